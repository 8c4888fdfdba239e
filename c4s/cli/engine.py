"""``c4s engine``: what an engine does with a level, without an agent."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path
from typing import Annotated

import typer

from c4s.cli.output import check_new_file, print_json, print_table, say
from c4s.engine import DEFAULT_ENGINE, backend
from c4s.errors import BadInput
from c4s.files import write_json
from c4s.folders import check_out
from c4s.stderr import tell

app = typer.Typer(help="Engines: levels as GLB files, and what every engine must do.", no_args_is_help=True)
Kind = Annotated[str, typer.Option("--engine", help="kind of the engine")]


@app.callback()
def engine() -> None:
    """Engines: levels as GLB files, and what every engine must do."""


@app.command()
def export(
    level: Annotated[Path, typer.Argument(help="level document, of a case or of a saved submission")],
    glb: Annotated[Path, typer.Option(help="GLB file to write")],
    pack: Annotated[
        list[str] | None,
        typer.Option(help="id or folder of a pack, once for each; default: the built packs that the level uses"),
    ] = None,
    walk: Annotated[bool, typer.Option("--walk", help="add where a body can walk, as nodes of their own")] = False,
    engine: Kind = DEFAULT_ENGINE,
    replace: Annotated[bool, typer.Option("--replace", help="overwrite a GLB file of this name")] = False,
    json_output: Annotated[bool, typer.Option("--json")] = False,
) -> None:
    """Write a level as one GLB in metres, Y up, that any viewer opens. Hidden actors are left out."""
    if not level.is_file():
        raise BadInput("no such level document", where=str(level))
    if glb.suffix.lower() != ".glb":
        raise BadInput("the output must be a .glb file", where=str(glb), todo="give --glb OUT.glb")
    from c4s.cli.levels import named_pack, packs_of

    chosen = backend(engine)
    used = chosen.asset_paths(level)
    check_new_file(glb)
    check_out(glb, replace=replace, magic=b"glTF")
    packs = [named_pack(name) for name in pack] if pack else packs_of(used)
    report = {**chosen.export_glb(level, packs, glb, walk=walk), "file": str(glb), "packs": [p.name for p in packs]}
    if json_output:
        print_json(report)
        return
    say(
        f"{glb}: {report['actors']} actors, {report['meshes']} meshes, {report['triangles']} triangles, "
        f"{report['lights']} lights, {report['cameras']} cameras"
    )
    if walk:
        say(", ".join(report["layers"]) or "nowhere in this level can a body of 50 by 180 cm stand")
    for label in report["left_out"]:
        tell(f"c4s: left out, glTF has no such light or camera: {label}")
    for path in report["unresolved"]:
        tell(f"c4s: unresolved and left out: {path}")


@app.command()
def conform(
    engine: Kind = DEFAULT_ENGINE,
    only: Annotated[list[str] | None, typer.Option(help="name of a check, once for each; default: all")] = None,
    out: Annotated[
        Path | None, typer.Option(help="JSON file to write: the table with the engine's version, this host, its GPUs")
    ] = None,
    replace: Annotated[bool, typer.Option("--replace", help="overwrite a file of this name")] = False,
    json_output: Annotated[bool, typer.Option("--json")] = False,
) -> None:
    """Check that an engine does what c4s asks of every engine, and record how it answers open questions.

    Exit 1 when a check fails. It is the first thing to run on a host with a real editor (docs/unreal.md).
    """
    from c4s.engine.conformance import run
    from c4s.run.host import this_host

    if out is not None:
        check_new_file(out)
        check_out(out, replace=replace, magic=b"{")
    report = run(engine, only or ())
    host = this_host().model_copy(update={"engine_version": report.version})
    told = {**asdict(report), "failed": report.failed, "host": host.plain()}
    if out is not None:
        write_json(out, told)
    if json_output:
        print_json(told)
    else:
        print_table(
            ("group", "check", "status", "detail"),
            [(result.group, result.name, result.status, result.detail) for result in report.checks],
        )
        say(f"{report.engine} {report.version}: {len(report.checks)} checks, {report.failed} failed")
        if out is not None:
            say(str(out))
    if report.failed:
        raise typer.Exit(1)


@app.command()
def warm(
    pack: Annotated[list[str], typer.Argument(help="ids or folders of the packs that engines will show")],
    engine: Kind = DEFAULT_ENGINE,
    json_output: Annotated[bool, typer.Option("--json")] = False,
) -> None:
    """Make what engines only read before the first one needs it: compiled kernels, or an editor's shaders."""
    from c4s.cli.levels import named_pack
    from c4s.records.pack import MANIFEST, Pack

    chosen, packs = backend(engine), [named_pack(name) for name in pack]
    for place in packs:
        Pack.read(place / MANIFEST)
    folder = chosen.warm(packs)
    if json_output:
        print_json({"engine": engine, "folder": str(folder)})
    else:
        say(str(folder))


@app.command()
def python(
    file: Annotated[Path, typer.Argument(help="Python source; `-` reads standard input")],
    case: Annotated[str | None, typer.Option("--case", "-c", help="run on the start level of this case")] = None,
    suite: Annotated[str, typer.Option(help="id of the built suite that has the case")] = "starter",
    level: Annotated[
        Path | None, typer.Option(help="run on this level document; without it and a case on an empty level")
    ] = None,
    save: Annotated[
        Path | None, typer.Option(help="level document to write at the end, NAME.level.json, whatever was saved")
    ] = None,
    picture: Annotated[
        Path | None, typer.Option(help="PNG file to write: what the viewport shows, or the whole level")
    ] = None,
    engine: Kind = DEFAULT_ENGINE,
    replace: Annotated[bool, typer.Option("--replace", help="overwrite files of these names")] = False,
    json_output: Annotated[bool, typer.Option("--json")] = False,
) -> None:
    """Run a script as an agent's is run, and tell what it printed and what it changed. Exit 1 when it failed."""
    from c4s.cli.changed import lines
    from c4s.cli.levels import ground_of
    from c4s.cli.scripting import read_script, run_script, save_package

    if case is not None and level is not None:
        raise BadInput("--case and --level are two levels", where=str(level), todo="give one of them")
    backend(engine)
    script = read_script(file)
    ground = ground_of(case, suite, level)
    if save is not None:
        save_package(save)
    if picture is not None and picture.suffix.lower() != ".png":
        raise BadInput("the picture must be a .png file", where=str(picture), todo="give --picture OUT.png")
    for out, magic in ((save, b"{"), (picture, b"\x89PNG")):
        if out is not None:
            check_new_file(out)
            check_out(out, replace=replace, magic=magic)
    ran = run_script(script, ground, engine=engine, save=save, picture=picture)
    if json_output:
        print_json(asdict(ran))
    else:
        for line in ran.output:
            say(line)
        if ran.found:
            say(f"-- {ran.level}", style="dim")
            for line in lines(ran.found):
                say(line)
        for written in (ran.saved, ran.picture):
            if written is not None:
                say(str(written))
        for line in ran.error.splitlines():
            tell(line)
    for path in ran.left_out:
        tell(f"c4s: not kept, the script made it: {path}")
    if ran.status != "ok":
        raise typer.Exit(1)
