"""``c4s suite``: build, list, show and import suites."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from types import MappingProxyType
from typing import Annotated, Any

import typer

from c4s.cli import asking, auditing, drafting, exporting, requirements, selecting, workshop
from c4s.cli.bringing import Hulls, HullsOf, LicenceFile, say_excess
from c4s.cli.left_out import readable, refuse_left_out
from c4s.cli.output import grouped, print_json, print_table, say
from c4s.cli.progress import bars, step_line
from c4s.cli.shipped import SHIPPED
from c4s.cli.suites import built_suite
from c4s.errors import BadInput, unknown
from c4s.home import packs_root, suites_root
from c4s.names import checked_id, checked_name, place_in
from c4s.packs.suite_check import suite_changes
from c4s.records.suite import SUITE_FILE, Suite, SuiteFolder
from c4s.trees import refuse

app = typer.Typer(help="Suites: build, list, show, check, import.", no_args_is_help=True)
importing = typer.Typer(help="Bring other layouts in as a suite.", no_args_is_help=True)
app.add_typer(importing, name="import")
app.add_typer(requirements.app, name="requirements")
app.command("new")(workshop.new)
app.command("preview")(workshop.preview)
app.command("review")(asking.review)
app.command("freeze")(workshop.freeze)
app.command("diff")(workshop.diff)
app.command("stats")(workshop.stats)
app.command("audit")(auditing.audit_suite)
app.command("select")(selecting.select_cases)
app.command("export")(workshop.export)
app.command("draft-prompt")(drafting.draft_prompt)
app.command("export-harbor")(exporting.export_harbor)
Replace = Annotated[
    bool, typer.Option("--replace", help="replace what lies under this name and is another, or was changed")
]


@app.command()
def build(
    name: Annotated[
        str, typer.Argument(metavar="FILE", help="`starter`, `open-190`, a suite.yaml, or the folder of one")
    ],
    replace: Replace = False,
    json_output: Annotated[bool, typer.Option("--json")] = False,
) -> None:
    """Build a suite: one that ships with its packs, or that of a suite file.

    A build of open-190 that was stopped goes on where it was."""
    if _is_file(name):
        suite = workshop.build_file(Path(name), replace=replace, json_output=json_output)
        _tell(suite, suites_root() / suite.suite_id, json_output)
        return
    if name not in SHIPPED:
        raise unknown("shipped suite", name, list(SHIPPED), todo="or give a suite.yaml")
    _tell(SHIPPED[name](replace=replace), suites_root() / name, json_output)


@app.command("list")
def list_suites(json_output: Annotated[bool, typer.Option("--json")] = False) -> None:
    """The suites built here. Exit 2 where one cannot be read; the others are listed."""
    found, left_out = readable(Suite, sorted(suites_root().glob("*/suite.json")))
    if json_output:
        print_json(
            [
                {"suite": suite.suite_id, "title": suite.title, "cases": len(suite.cases), "sha256": suite.sha256()}
                for suite in found
            ]
        )
    else:
        print_table(
            ["suite", "title", "cases", "digest"],
            [[suite.suite_id, suite.title, len(suite.cases), suite.sha256()[:12]] for suite in found],
        )
    refuse_left_out(left_out)


@app.command()
def show(
    name: Annotated[str, typer.Argument(help="id of a built suite")],
    json_output: Annotated[bool, typer.Option("--json")] = False,
) -> None:
    """The cases of a suite."""
    folder = built_suite(name)
    _tell(SuiteFolder(folder).suite(), folder, json_output)


@app.command()
def check(
    name: Annotated[str, typer.Argument(metavar="SUITE", help="id of a built suite, or a suite.yaml")],
    json_output: Annotated[bool, typer.Option("--json")] = False,
) -> None:
    """Read every byte of a suite and of its packs, and compare it with what was frozen. Exit 2 where one differs.

    Of a suite file: whether what it names is there and fits together.
    """
    if _is_file(name):
        workshop.check_file(Path(name), json_output=json_output)
        return
    folder = SuiteFolder(built_suite(name))
    read = 0
    with bars() as progress:
        task = progress.add_task(f"checking {name:42.42}", total=None)

        def told(file: str) -> None:
            nonlocal read
            read += 1
            progress.update(task, completed=read)

        found = suite_changes(folder, told)
        progress.update(task, total=read, completed=read, description=f"{f'{read} files read':51}")
    rows = [{"file": str(change.file), "problem": change.told()} for change in found]
    from cases.stamp import losses_of_build

    losses = losses_of_build(folder.root)
    if json_output:
        print_json(
            {
                "suite": name,
                "sha256": folder.suite().sha256(),
                "files": read,
                "problems": rows,
                "physics_of_truth": losses,
            }
        )
    elif rows:
        print_table(["file", "problem"], [[row["file"], row["problem"]] for row in rows])
    else:
        say(f"{name}: {read} files are as they were frozen ({folder.suite().sha256()[:12]})")
    if not json_output:
        _say_losses(losses)
    refuse(found, todo="restore the files, or build again with --replace")


@importing.command()
def code4scene(
    folder: Annotated[Path, typer.Argument(help="folder with the published task layout")],
    suite_id: Annotated[str | None, typer.Option("--id", help="id of the suite to write")] = None,
    content: Annotated[
        Path | None,
        typer.Option(help="CSV of content given for image tasks: published, pack, asset (docs/published-tasks.md)"),
    ] = None,
    replace: Replace = False,
    json_output: Annotated[bool, typer.Option("--json")] = False,
) -> None:
    """Import published tasks. Text-to-scene becomes runnable with proxy assets of the palette's sizes.

    Of image-to-scene it tells which packs, levels and assets would be needed; the levels are not published.
    """
    from cases.code4scene.importer import import_code4scene

    name = checked_id("code4scene" if suite_id is None else suite_id, "suite")
    with bars() as progress:
        task = progress.add_task("importing", total=None)

        def step(message: str) -> None:
            progress.update(task, description=f"importing {message:41.41}")

        report = import_code4scene(
            folder, place_in(suites_root(), name, "suite"), packs_root(), step, content=content, replace=replace
        )
    if json_output:
        print_json(report)
        return
    print_table(
        ["case", "setting", "assets", "runnable", "note"],
        [[row["case_id"], row["setting"], row["assets"], row["runnable"], row["note"]] for row in report["cases"]],
    )
    _tell_needs(report["needs"], report["content_pack"])
    say(f"{report['runnable']} of {len(report['cases'])} cases are runnable here: c4s run {name} --agent planner")


def _tell_needs(needs: dict[str, Any], content_pack: str | None) -> None:
    """What image tasks would need, for people."""
    if not needs["packs"]:
        return
    print_table(
        ["pack", "tasks", "title", "where"],
        [[row["folder"], row["tasks"], row.get("title"), row.get("url")] for row in needs["packs"]],
        title="Content that the image tasks need",
    )
    print_table(
        ["asset", "tasks", "given"],
        [[path, count, needs["given"].get(path)] for path, count in needs["assets"].items()],
        title="Assets that they name",
    )
    say(f"{len(needs['given'])} of {len(needs['assets'])} assets are given; {len(needs['levels'])} levels are needed:")
    say(needs["levels_note"])
    for path in needs["not_needed"]:
        say(f"given and not needed: {path}")
    if content_pack is not None:
        say(f"given meshes under their published paths: pack {content_pack}")


@app.command("import-scene")
def import_scene_file(
    files: Annotated[
        list[Path],
        typer.Argument(
            help="SDF world (several join), glTF/GLB/DAE node tree, Blender file, or placement table (CSV)",
            metavar="FILE...",
        ),
    ],
    scene_id: Annotated[str, typer.Option("--id", help="id of the scene: its pack and its folder under the suites")],
    scale: Annotated[float, typer.Option(help="metres per unit (SDF is metres)")] = 1.0,
    without: Annotated[list[str] | None, typer.Option(help="pattern of actors to leave out; repeatable")] = None,
    mesh: Annotated[
        list[str] | None,
        typer.Option(help="NAME=FILE#PART: read a mesh that an SDF world names from another file; repeatable"),
    ] = None,
    resources: Annotated[
        list[Path] | None, typer.Option(help="further folder with models of an SDF world; repeatable")
    ] = None,
    ground: Annotated[bool, typer.Option("--ground", help="lay a flat ground under a scene that has none")] = False,
    hulls: Hulls = "auto",
    hulls_of: HullsOf = None,
    license_file: LicenceFile = None,
    replace: Replace = False,
    json_output: Annotated[bool, typer.Option("--json")] = False,
) -> None:
    """Bring a human-made scene in as a source scene: a pack of its meshes and a level with an actor a placed thing."""
    from cases.importers.importing import import_scene

    checked_id(scene_id, "scene")
    with bars() as progress:
        task = progress.add_task("importing", total=None)

        def step(message: str) -> None:
            progress.update(task, description=f"reading {message:43.43}")

        report = import_scene(
            files,
            scene_id,
            suites=suites_root(),
            packs=packs_root(),
            scale=scale,
            without=without or [],
            meshes=mesh or [],
            resources=resources or [],
            ground=ground,
            hulls=hulls,
            hulls_of=hulls_of or (),
            license_file=license_file,
            replace=replace,
            progress=step,
        )
        progress.update(task, description=f"{'scene written':51}")
    if json_output:
        print_json(report)
        return
    say(
        f"{report['actors']} actors, {report['lights']} lights, {report['assets']} assets (pack {report['pack']}, "
        f"licence {report['license']}): {report['level']}"
    )
    if report["skipped"]:
        kinds = ", ".join(f"{kind} ({count})" for kind, count in report["skipped_kinds"].items())
        say(f"skipped {len(report['skipped'])}: {kinds}; each by name in {suites_root() / scene_id / 'import.json'}")
    if any("mesh" in row["reason"] and row["reason"].endswith("is missing") for row in report["skipped"]):
        say(
            "a missing mesh can be read from a part of another file: see --mesh; "
            f"every name is in {suites_root() / scene_id / 'import.json'}"
        )
    for text, names in grouped(report["notes"], "note", "name").items():
        say(f"note: {text}" + (f": {', '.join(names[:3])}{' ...' if len(names) > 3 else ''}" if names[0] else ""))
    say_excess(report["collision_excess"])
    if report["proposed_scale"]:
        say(f"sizes look wrong. An estimate: --scale {report['proposed_scale']}")


@app.command("make-cases")
def make_cases(
    scene: Annotated[str, typer.Argument(help="id of an imported scene")],
    suite_id: Annotated[
        str | None, typer.Option("--id", help="id of the suite to write; else the scene's with `-cases`")
    ] = None,
    count: Annotated[int, typer.Option(min=1, max=200, help="number of cases")] = 3,
    changes: Annotated[int, typer.Option(min=1, max=5, help="most changes of a case")] = 3,
    seed: Annotated[int, typer.Option(help="another seed, other cases")] = 0,
    outdoor: Annotated[bool, typer.Option(help="cases of the outdoor setting")] = False,
    replace: Replace = False,
    json_output: Annotated[bool, typer.Option("--json")] = False,
) -> None:
    """Make repair cases of an imported scene: changes by chance, of things that stand and fit in the original.

    A case whose own truth loses points, or that can be repaired without a look at a picture, is refused with the number
    and another takes its place.
    """
    import dataclasses

    from cases.admissible import summed
    from cases.generate import generated, sound_things
    from cases.importers.scene import imported_scene
    from cases.stamp import refused_cases
    from cases.suite import build_suite

    if suite_id is not None and checked_id(suite_id, "suite") == checked_name(scene, "scene"):
        raise BadInput("the suite cannot have the scene's own id", where=f"--id {scene}")
    level = imported_scene(suites_root(), packs_root(), scene)
    with bars() as progress:
        task = progress.add_task("looking at the scene", total=None)

        def step(message: str) -> None:
            progress.update(task, description=f"building {message:42.42}")
            step_line(message)

        things = sound_things(level, [packs_root() / scene])
        definition = generated(
            scene,
            level,
            things,
            packs_root(),
            [scene],
            count=count,
            changes=changes,
            seed=seed,
            environment="outdoor" if outdoor else "indoor",
        )
        definition = dataclasses.replace(definition, suite_id=suite_id or definition.suite_id)
        suite = build_suite(
            definition, place_in(suites_root(), definition.suite_id, "suite"), packs_root(), step, replace=replace
        )
    refused = refused_cases(suites_root() / suite.suite_id)
    _tell(suite, suites_root() / suite.suite_id, json_output, {"refused": [one.plain() for one in refused]})
    if json_output:
        return
    if refused:
        say(f"refused {len(refused)} others: {summed(refused)}; for one, {refused[0].case_id}: {refused[0].reason}")
    if len(suite.cases) < count:
        say(
            f"{len(suite.cases)} of the {count} cases that were asked for, of {len(definition.cases)} that were tried: "
            "give another --seed or fewer --changes"
        )


def _is_file(name: str) -> bool:
    """Whether a name means a suite file: it ends like one, or is a folder with one."""
    return name.endswith((".yaml", ".yml")) or (Path(name) / SUITE_FILE).is_file()


def _tell(suite: Suite, root: Path, json_output: bool, more: Mapping[str, object] = MappingProxyType({})) -> None:
    from cases.stamp import losses_of_build

    losses = losses_of_build(root)
    if json_output:
        print_json({**suite.plain(), "sha256": suite.sha256(), "folder": str(root), "physics_of_truth": losses, **more})
        return
    folder = SuiteFolder(root)
    print_table(
        ["case", "agents see", "setting", "scene", "operations", "title"],
        [
            [case.case_id, case.alias, case.setting, withheld.scene_id, " ".join(withheld.operations), withheld.title]
            for case in suite.cases
            for withheld in [folder.withheld_case(case.case_id)]
        ],
        title=f"{suite.title} ({suite.suite_id}, {suite.sha256()[:12]})",
    )
    _say_losses(losses)


def _say_losses(losses: dict[str, Any] | None) -> None:
    from cases.losses import told

    for line in told(losses) if losses else []:
        say(line)
