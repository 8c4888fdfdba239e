"""``c4s suite new | preview | freeze | diff | stats | export``: a suite file, from the first case to a frozen suite."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal, cast

import typer

from c4s.cli.output import print_json, print_table, say
from c4s.cli.progress import bars, step_line
from c4s.cli.suites import built_suite
from c4s.errors import BadInput, unknown
from c4s.home import packs_root, reviews_root, suites_root
from c4s.names import checked_id, checked_name, name_fault
from c4s.records.asking import ReviewFolder
from c4s.records.pack import MANIFEST, Pack
from c4s.records.suite import IMPORTED_SCENE, Suite, SuiteFolder

if TYPE_CHECKING:
    from c4s.records.level import Level
    from cases.workshop.statistics import Range, SettingStatistics

Json = Annotated[bool, typer.Option("--json")]
Built = Annotated[str, typer.Argument(help="id of a built suite")]
SCENE_SUFFIXES = {".sdf", ".world", ".gltf", ".glb", ".dae", ".csv"}
SHOWN = 12
"""Things that `new` proposes, refusals that `build` tells, gaps that `freeze` tells."""


def new(
    source: Annotated[
        str, typer.Argument(help="folder of meshes, scene file, or id of a pack or of a scene that is here")
    ],
    out: Annotated[Path, typer.Option(help="folder for suite.yaml")],
    suite_id: Annotated[
        str | None, typer.Option("--id", help="id of the suite; the folder's name unless given")
    ] = None,
    author: Annotated[str | None, typer.Option(help="your pseudonym: nobody reviews their own cases")] = None,
    environment: Annotated[Literal["indoor", "outdoor"] | None, typer.Option(help="what the scene is")] = None,
    actor: Annotated[str | None, typer.Option(help="what the first case changes")] = None,
    change: Annotated[str | None, typer.Option(help="how: removal, move, rotate, rescale or mirror")] = None,
    yes: Annotated[bool, typer.Option("--yes", "-y", help="ask nothing: take what is proposed")] = False,
    json_output: Json = False,
) -> None:
    """Begin a suite: from meshes or a scene to a suite.yaml with a first case. Asks what is not given."""
    from cases.generate import sound_things
    from cases.workshop.beginning import FIRST_CHANGES, FirstChange, first_suite, write_suite
    from cases.workshop.document import SUITE_FILE, SceneEntry
    from cases.workshop.scene_sheet import write_scene_sheet

    asking = not (yes or json_output)
    name = checked_id(suite_id or out.resolve().name, "suite")
    if (out / SUITE_FILE).exists():
        raise BadInput("a suite file lies here already", where=str(out / SUITE_FILE), todo="choose another --out")
    if change is not None and change not in FIRST_CHANGES:
        raise unknown("change", change, FIRST_CHANGES)
    level, reference, packs = _scene(source, name, out)
    where = environment or (
        _ask("Is the scene indoor or outdoor?", "indoor", ("indoor", "outdoor")) if asking else "indoor"
    )
    who = checked_name(
        author or (typer.prompt("Your pseudonym", default="author", err=True) if asking else "author"), "an author"
    )
    with bars() as progress:
        progress.add_task("looking at the scene", total=None)
        folders = [packs_root() / pack for pack in packs]
        things = sound_things(level, folders)
        sheet = write_scene_sheet(level, folders, out / "scene.png")
    names = [thing.name for thing in sorted(things, key=lambda thing: (-max(thing.extent), thing.name))]
    if asking:
        say(f"{sheet}: the scene with the names of its things; {len(names)} of {len(level.actors)} stand and fit")
        say(f"  {', '.join(names[:SHOWN])}{' ...' if len(names) > SHOWN else ''}")
        middle = names[len(names) // 2] if names else None
        actor = actor or (_ask("Which one does the first case change?", middle or "", names) if names else None)
        change = change or _ask("How?", "move", FIRST_CHANGES)
    scene = SceneEntry(
        scene_id=reference.removesuffix(".level.json") if reference.endswith(".level.json") else reference,
        level=reference,
        environment=cast(Literal["indoor", "outdoor"], where),
        packs=[] if reference in packs else list(packs),
    )
    file = first_suite(name, scene, things, author=who, actor=actor, kind=cast("FirstChange", change or "move"))
    path = write_suite(file, out)
    told = {"suite_file": str(path), "sheet": str(sheet), "suite": name, "things": names}
    if json_output:
        print_json(told)
        return
    say(f"{path}: one case; add more by hand (an editor that knows YAML schemas completes them)")
    say(f"next: c4s suite build {path}")


def _scene(source: str, name: str, out: Path) -> tuple[Level, str, Sequence[str]]:
    """The scene that a source means: its level, how a suite file names it, and its packs."""
    from cases.importers.importing import import_scene
    from cases.importers.scene import imported_scene
    from cases.workshop.showroom import showroom
    from catalog.ingest.folder import ingest

    place, is_id = Path(source), not name_fault(source)
    if is_id and (suites_root() / source / IMPORTED_SCENE).is_file():
        return imported_scene(suites_root(), packs_root(), source), source, (source,)
    if place.is_file():
        if place.suffix.lower() not in SCENE_SUFFIXES:
            raise BadInput("this is no scene", where=source, todo=f"give {', '.join(sorted(SCENE_SUFFIXES))}")
        scene_id = f"{name}-scene"
        import_scene(place, scene_id, suites=suites_root(), packs=packs_root())
        return imported_scene(suites_root(), packs_root(), scene_id), scene_id, (scene_id,)
    if is_id and (packs_root() / source / MANIFEST).is_file():
        pack_id = source
    elif source.strip() and place.is_dir():
        pack_id = f"{name}-pack"
        ingest(place, pack_id, packs_root())
    else:
        todo = "see `c4s catalog list`, or give a path"
        raise BadInput("there is no such folder, file, scene or pack", where=repr(source), todo=todo)
    level = showroom(Pack.read(packs_root() / pack_id / MANIFEST))
    level.write(out / "showroom.level.json")
    return level, "showroom.level.json", (pack_id,)


def _ask(question: str, default: str, known: Sequence[str]) -> str:
    while True:
        answer = str(typer.prompt(question, default=default, err=True))
        if answer in known:
            return answer
        say(f"{answer!r} is none of them")


def build_file(path: Path, *, replace: bool, json_output: bool) -> Suite:
    """Build the suite of a suite file, with its contact sheet; the refusals of all its cases where some are refused."""
    from cases.admissible import Refused
    from cases.suite import build_suite
    from cases.workshop import read_definition
    from cases.workshop.reading import suite_file

    definition = read_definition(suite_file(path), suites_root(), packs_root())
    place = suites_root() / checked_id(definition.suite_id, "suite")
    with bars() as progress:
        task = progress.add_task(definition.suite_id, total=None)

        def step(message: str) -> None:
            progress.update(task, description=f"building {message:42.42}")
            step_line(message)

        try:
            suite = build_suite(definition, place, packs_root(), step, replace=replace)
        except Refused as refused:
            if json_output:
                print_json({"suite": definition.suite_id, "refusals": [asdict(one) for one in refused.refusals]})
            else:
                print_table(["case", "why it cannot be used"], [[one.case_id, one.reason] for one in refused.refusals])
            raise
        progress.update(task, description=f"{'suite written':51}")
    if not json_output:
        for file in _sheets(SuiteFolder(place), suite_file(path).parent):
            say(f"contact sheet: {file}")
        say(f"next: c4s suite stats {suite.suite_id}; c4s suite review {suite.suite_id}; c4s run {suite.suite_id}")
    return suite


def check_file(path: Path, *, json_output: bool) -> None:
    """Whether a suite file can be built as far as can be told without an engine."""
    from cases.checks import check_definition, check_scene
    from cases.workshop import read_definition
    from cases.workshop.reading import suite_file

    file = suite_file(path)
    definition = read_definition(file, suites_root(), packs_root())
    check_definition(definition)
    for scene in definition.scenes:
        known = {a.path for pack in scene.packs for a in Pack.read(packs_root() / pack / MANIFEST).assets}
        check_scene(scene, known)
    told = {"suite": definition.suite_id, "scenes": len(definition.scenes), "cases": len(definition.cases)}
    if json_output:
        print_json(told)
        return
    say(f"{file}: {told['scenes']} scenes and {told['cases']} cases that fit together")
    say(f"next: c4s suite build {file}")


def _sheets(suite: SuiteFolder, folder: Path) -> list[Path]:
    from cases.workshop.sheet import suite_rows, write_sheets

    return write_sheets(suite_rows(suite), folder / f"{suite.root.name}.png")


def preview(
    name: Built, out: Annotated[Path, typer.Option(help="folder for the sheet")] = Path(), json_output: Json = False
) -> None:
    """Draw a contact sheet of all cases: reference views beside the start scene, overviews of texts."""
    files = _sheets(SuiteFolder(built_suite(name)), out)
    if json_output:
        print_json({"suite": name, "sheets": [str(file) for file in files]})
        return
    for file in files:
        say(str(file))
    say(f"next: c4s suite review {name}")


def freeze(name: Built, json_output: Json = False) -> None:
    """Freeze a reviewed suite. Exit 1 with all that it lacks: reviews, licences, permission for AI use."""
    from cases.workshop.freezing import NotFrozen
    from cases.workshop.freezing import freeze as frozen_of

    suite = SuiteFolder(built_suite(name))
    try:
        frozen = frozen_of(suite, ReviewFolder(reviews_root() / name), packs_root())
    except NotFrozen as error:
        if json_output:
            print_json({"suite": name, "frozen": False, "gaps": [asdict(gap) for gap in error.gaps]})
        else:
            print_table(["of", "lacks"], [[gap.of, gap.lacks] for gap in error.gaps], most=4 * SHOWN)
            say(error.line())
        raise typer.Exit(1) from None
    if json_output:
        print_json({"suite": name, "frozen": True, **frozen.plain()})
        return
    say(f"{name} is frozen ({frozen.suite_digest[:12]}): {suite.frozen}")
    say(f"next: c4s suite export {name} --public --out FOLDER")


def diff(
    before: Annotated[str, typer.Argument(help="id of a built suite, or its folder")],
    after: Annotated[str, typer.Argument(help="id of another, or its folder")],
    json_output: Json = False,
) -> None:
    """What differs between two suites, case by case. Exit 1 where something does."""
    from cases.workshop.difference import difference

    found = difference(_opened(before), _opened(after))
    if json_output:
        print_json({"same": found.same, "packs": found.packs, "cases": [asdict(case) for case in found.cases]})
    else:
        rows = [[case.case_id, case.change, ", ".join(case.parts)] for case in found.cases if case.change != "same"]
        if rows:
            print_table(["case", "change", "parts"], rows)
        for pack in found.packs:
            say(f"pack {pack} differs")
        same = sum(case.change == "same" for case in found.cases)
        say(f"{same} of {len(found.cases)} cases are the same")
    if not found.same:
        raise typer.Exit(1)


def _opened(name: str) -> SuiteFolder:
    folder = SuiteFolder(Path(name))
    return folder if folder.record.is_file() else SuiteFolder(built_suite(name))


def stats(name: Built, json_output: Json = False) -> None:
    """A suite in numbers: cases, scenes, actors, palettes, requirements, operations, difficulty, visible pixels."""
    from cases.workshop.statistics import held_slots, statistics

    suite = SuiteFolder(built_suite(name))
    rows, slots = statistics(suite), held_slots(suite)
    if json_output:
        print_json({"suite": name, "settings": [asdict(row) for row in rows], "slots": slots})
        return
    print_table(["", *(row.setting for row in rows)], _told(rows), title=f"{name} in numbers")
    for scene, held in slots.items():
        say(f"slot {scene}: {held}")


def _told(rows: Sequence[SettingStatistics]) -> list[list[Any]]:
    """A line a number, a column a setting."""
    lines: list[tuple[str, list[Any]]] = [
        ("cases (public)", [f"{row.cases} ({row.public})" for row in rows]),
        ("source scenes", [row.scenes for row in rows]),
        ("actors", [_range(row.actors) for row in rows]),
        ("palette", [_range(row.palette) for row in rows]),
        ("plates (m)", [_counts(row.plates_m) for row in rows]),
        ("words of a prompt", [_range(row.prompt_words) for row in rows]),
        ("requirements", [_range(row.requirements) for row in rows]),
        ("groups", [_counts(row.groups) for row in rows]),
        ("difficulty", [_counts(row.tiers) for row in rows]),
        ("changes a case", [_counts(row.chains) for row in rows]),
        ("kinds of change", [_counts(row.kinds) for row in rows]),
        ("reference views", [_counts(row.views) for row in rows]),
        ("target pixels of 1280x720", [_range(row.target_pixels) for row in rows]),
    ]
    return [[name, *values] for name, values in lines]


def _range(spread: Range | None) -> str | None:
    return None if spread is None else f"{spread.least:g} to {spread.most:g}, mean {spread.mean:.1f}"


def _counts(counts: dict[str, int]) -> str | None:
    return ", ".join(f"{name} {count}" for name, count in counts.items()) or None


def export(
    name: Built,
    out: Annotated[Path, typer.Option(help="folder to write")],
    public: Annotated[bool, typer.Option("--public", help="nothing of private cases")] = False,
    json_output: Json = False,
) -> None:
    """Copy a suite for others; with `--public` its public cases alone, and no file that names a private one."""
    from cases.workshop.exporting import export_suite

    made = export_suite(SuiteFolder(built_suite(name)), out, public_only=public)
    if json_output:
        print_json({"suite": name, "folder": str(out), "cases": len(made.cases), "sha256": made.sha256()})
        return
    say(f"{out}: {len(made.cases)} cases ({made.sha256()[:12]})")
