"""``c4s engine``: what an engine does with a level, without an agent."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from c4s.cli.output import check_new_file, print_json, print_table, say, tell
from c4s.engine import DEFAULT_ENGINE, backend
from c4s.errors import BadInput, unknown
from c4s.folders import check_out
from c4s.home import packs_root
from c4s.records.pack import Pack

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
    engine: Kind = DEFAULT_ENGINE,
    replace: Annotated[bool, typer.Option("--replace", help="overwrite a GLB file of this name")] = False,
    json_output: Annotated[bool, typer.Option("--json")] = False,
) -> None:
    """Write a level as one GLB in metres, Y up, that any viewer opens. Hidden actors are left out."""
    if not level.is_file():
        raise BadInput("no such level document", where=str(level))
    if glb.suffix.lower() != ".glb":
        raise BadInput("the output must be a .glb file", where=str(glb), todo="give --glb OUT.glb")
    chosen = backend(engine)
    used = chosen.asset_paths(level)
    check_new_file(glb)
    check_out(glb, replace=replace, magic=b"glTF")
    packs = [_pack(name) for name in pack] if pack else _packs_of(used)
    report = {**chosen.export_glb(level, packs, glb), "file": str(glb), "packs": [p.name for p in packs]}
    if json_output:
        print_json(report)
        return
    say(
        f"{glb}: {report['actors']} actors, {report['meshes']} meshes, {report['triangles']} triangles, "
        f"{report['lights']} lights, {report['cameras']} cameras"
    )
    for label in report["left_out"]:
        tell(f"c4s: left out, glTF has no such light or camera: {label}")
    for path in report["unresolved"]:
        tell(f"c4s: unresolved and left out: {path}")


@app.command()
def conformance(
    engine: Kind = DEFAULT_ENGINE,
    only: Annotated[list[str] | None, typer.Option(help="name of a check, once for each; default: all")] = None,
    json_output: Annotated[bool, typer.Option("--json")] = False,
) -> None:
    """Check that an engine does what c4s asks of every engine. Exit 1 when a check fails."""
    from dataclasses import asdict

    from c4s.engine.conformance import run

    results = run(engine, only or ())
    failed = [result for result in results if result.status == "failed"]
    if json_output:
        print_json({"engine": engine, "failed": len(failed), "checks": [asdict(result) for result in results]})
    else:
        print_table(
            ("group", "check", "status", "detail"),
            [(result.group, result.name, result.status, result.detail) for result in results],
        )
        say(f"{len(results)} checks, {len(failed)} failed")
    if failed:
        raise typer.Exit(1)


def _pack(name: str) -> Path:
    built = [path.parent.name for path in packs_root().glob("*/pack.json")]
    if name in built:
        return packs_root() / name
    if name and (Path(name) / "pack.json").is_file():
        return Path(name)
    raise unknown("pack", name, built, where=str(packs_root()), todo="or give the folder of a pack")


def _packs_of(paths: list[str]) -> list[Path]:
    """The built packs that hold one of these assets."""
    from c4s.packs.store import object_path

    wanted = {object_path(path.removesuffix("_C")) for path in paths}
    found = []
    for path in sorted(packs_root().glob("*/pack.json")):
        manifest = Pack.read(path)
        held = {asset.path for asset in manifest.assets} | {material.path for material in manifest.materials}
        if any(object_path(path) in held for path in wanted):
            found.append(path.parent)
    return found
