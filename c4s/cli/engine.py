"""``c4s engine``: what the headless engine does with a level, without an agent."""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path
from typing import Annotated, Any

import typer

from c4s.cli.output import print_json
from c4s.errors import BadInput
from c4s.home import packs_root
from c4s.records.level import Level
from c4s.records.pack import Pack

app = typer.Typer(help="The headless engine: levels as GLB files.", no_args_is_help=True)


@app.callback()
def engine() -> None:
    """The headless engine: levels as GLB files."""


@app.command()
def export(
    level: Annotated[Path, typer.Argument(help="level document, of a case or of a saved submission")],
    glb: Annotated[Path, typer.Option(help="GLB file to write")],
    pack: Annotated[
        list[str] | None,
        typer.Option(help="id or folder of a pack, once for each; default: the built packs that the level uses"),
    ] = None,
    json_output: Annotated[bool, typer.Option("--json")] = False,
) -> None:
    """Write a level as one GLB in metres, Y up, that any viewer opens. Hidden actors are left out."""
    if not level.is_file():
        raise BadInput("no such level document", where=str(level))
    document = Level.read(level)
    packs = [_pack(name) for name in pack] if pack else _packs_of(document)
    if glb.suffix.lower() != ".glb":
        raise BadInput("the output must be a .glb file", where=str(glb), todo="give --glb OUT.glb")
    report = {**_write(document.package, level, packs, glb), "file": str(glb), "packs": [p.name for p in packs]}
    if json_output:
        print_json(report)
        return
    print(
        f"{glb}: {report['actors']} actors, {report['meshes']} meshes, {report['triangles']} triangles, "
        f"{report['lights']} lights, {report['cameras']} cameras"
    )
    for label in report["left_out"]:
        print(f"c4s: left out, glTF has no such light or camera: {label}", file=sys.stderr)
    for path in report["unresolved"]:
        print(f"c4s: unresolved and left out: {path}", file=sys.stderr)


def _write(package: str, level: Path, packs: list[Path], glb: Path) -> dict[str, Any]:
    from c4s.engine.headless.glb.level import write_glb
    from c4s.engine.headless.process.boot import boot
    from c4s.engine.headless.world.documents import read, references
    from c4s.engine.headless.world.state import world

    with tempfile.TemporaryDirectory(prefix="c4s-glb-") as folder:
        content = _content_root(level, package)
        boot(
            packs,
            content or Path(folder),
            levels=[] if content else [level],
            start_map=package,
            scratch=Path(folder) / "Saved",
        )
        unresolved = [path for path in references(read(level)) if world().find(path) is None]
        return {**write_glb(world(), glb), "unresolved": unresolved}


def _content_root(level: Path, package: str) -> Path | None:
    """The writable root that a saved level lies under, with the assets saved beside it; None for a lone document."""
    place, inside = level.resolve(), Path(f"{package[1:]}.level.json")
    return place.parents[len(inside.parts) - 1] if place.parts[-len(inside.parts) :] == inside.parts else None


def _pack(name: str) -> Path:
    for folder in (packs_root() / name, Path(name)):
        if (folder / "pack.json").is_file():
            return folder
    raise BadInput(f"no pack {name!r}", where=str(packs_root()), todo="see `c4s catalog list`")


def _packs_of(document: Level) -> list[Path]:
    """The built packs that hold an asset which the level names."""
    from c4s.engine.headless.world.documents import references
    from c4s.packs.store import object_path

    wanted = {object_path(path.removesuffix("_C")) for path in references(document)}
    found = []
    for path in sorted(packs_root().glob("*/pack.json")):
        manifest = Pack.read(path)
        held = {asset.path for asset in manifest.assets} | {material.path for material in manifest.materials}
        if any(object_path(path) in held for path in wanted):
            found.append(path.parent)
    return found
