"""``c4s catalog``: asset packs."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Literal

import typer

from c4s.cli.bringing import Hulls, HullsOf, LicenceFile, say_excess
from c4s.cli.left_out import readable, refuse_left_out
from c4s.cli.output import grouped, print_json, print_table, say
from c4s.cli.progress import bars
from c4s.errors import BadInput, unknown
from c4s.folders import check_out
from c4s.home import packs_root
from c4s.names import checked_id, place_in
from c4s.records.pack import MANIFEST, Pack

NAMES_SHOWN = 5
app = typer.Typer(help="Asset packs: build, list, show, search.", no_args_is_help=True)


@app.command("list")
def list_packs(json_output: Annotated[bool, typer.Option("--json")] = False) -> None:
    """The packs built here. Exit 2 where one cannot be read; the others are listed."""
    found, left_out = readable(Pack, sorted(packs_root().glob("*/pack.json")))
    if json_output:
        print_json(
            [
                {
                    "pack": pack.pack_id,
                    "title": pack.title,
                    "assets": len(pack.assets),
                    "license": pack.license,
                    "ai_use": pack.ai_use,
                    "sha256": pack.sha256(),
                }
                for pack in found
            ]
        )
    else:
        print_table(
            ["pack", "title", "assets", "licence", "AI use"],
            [[pack.pack_id, pack.title, len(pack.assets), pack.license, pack.ai_use] for pack in found],
        )
    refuse_left_out(left_out)


@app.command()
def show(
    pack_id: Annotated[str, typer.Argument(help="id of a pack")],
    json_output: Annotated[bool, typer.Option("--json")] = False,
) -> None:
    """The assets of a pack."""
    pack = Pack.read(_manifest(pack_id))
    if json_output:
        print_json(pack.plain())
        return
    print_table(
        ["id", "name", "category", "W x D x H (m)", "path"],
        [
            [asset.id, asset.name, asset.category, " x ".join(f"{side:.2f}" for side in asset.size_m), asset.path]
            for asset in pack.assets
        ],
        title=pack.title,
    )


@app.command("collision")
def draw_collision(
    pack_id: Annotated[str, typer.Argument(help="id of a pack")],
    out: Annotated[Path, typer.Option(help="PNG to write")],
    name: Annotated[list[str] | None, typer.Option(help="part of an asset's id, repeatable; all when left out")] = None,
    replace: Annotated[bool, typer.Option("--replace", help="replace the file")] = False,
    json_output: Annotated[bool, typer.Option("--json")] = False,
) -> None:
    """Draw what is to be seen of assets beside their collision bodies, each body in its own colour."""
    from catalog.collision_sheet import collision_sheet

    folder = _manifest(pack_id).parent
    if out.suffix.lower() != ".png":
        raise BadInput("a sheet is a PNG file", where=f"--out {out}")
    check_out(out, replace=replace, magic=b"\x89PNG")
    count = collision_sheet(folder, out, name or ())
    if json_output:
        print_json({"pack": pack_id, "assets": count, "file": str(out)})
    else:
        say(f"{count} assets drawn in {out}")


@app.command()
def search(
    query: Annotated[str, typer.Argument(help="words: `red chair`")],
    pack: Annotated[list[str] | None, typer.Option(help="id of a pack, repeatable; all when left out")] = None,
    limit: Annotated[int, typer.Option(help="how many assets at most", min=1)] = 10,
    json_output: Annotated[bool, typer.Option("--json")] = False,
) -> None:
    """Find assets of the packs built here, as an agent's search tool finds them."""
    from c4s.toolbox.catalog import CaseCatalog, CatalogEntry

    if not query.strip():
        raise BadInput("the query is empty", todo="give words: `red chair`")
    folders = (
        [_manifest(name).parent for name in pack]
        if pack
        else sorted(path.parent for path in packs_root().glob("*/pack.json"))
    )
    if not folders:
        raise BadInput("no pack is built here", where=str(packs_root()), todo="build one with `c4s catalog build`")
    packs = [(folder, Pack.read(folder / "pack.json")) for folder in folders]
    catalog = CaseCatalog([CatalogEntry(asset, one, folder) for folder, one in packs for asset in one.assets])
    found = catalog.search(query, limit=limit)
    if json_output:
        print_json(found)
        return
    print_table(
        ["name", "category", "W x D x H (m)", "description", "path"],
        [
            [
                row["name"],
                row["category"],
                " x ".join(f"{side:.2f}" for side in row["size_m"]),
                row["description"],
                row["spawn_path"],
            ]
            for row in found
        ],
    )


def _manifest(pack_id: str) -> Path:
    built = [path.parent.name for path in packs_root().glob(f"*/{MANIFEST}")]
    if pack_id not in built:
        raise unknown("pack", pack_id, built, where=str(packs_root()), todo="see `c4s catalog list`")
    return place_in(packs_root(), pack_id, "pack") / MANIFEST


@app.command()
def build(
    folder: Annotated[Path, typer.Argument(help="folder of glTF, GLB, OBJ and DAE files")],
    pack_id: Annotated[str, typer.Option("--id", help="id of the pack to write")],
    scale: Annotated[float, typer.Option(help="metres per unit of the files")] = 1.0,
    scale_of: Annotated[
        list[str] | None, typer.Option(help="another scale for some files, once for each: 'chair*=0.01'")
    ] = None,
    title: Annotated[str | None, typer.Option(help="title of the pack; the folder's name when left out")] = None,
    up: Annotated[Literal["y", "z"], typer.Option(help="axis that points up in OBJ files")] = "y",
    hulls: Hulls = "auto",
    hulls_of: HullsOf = None,
    recentre: Annotated[
        bool, typer.Option("--recentre", help="move pivots that lie outside their mesh to the middle of its bottom")
    ] = False,
    license_file: LicenceFile = None,
    replace: Annotated[
        bool, typer.Option("--replace", help="replace a pack of this id that is another, or was changed")
    ] = False,
    json_output: Annotated[bool, typer.Option("--json")] = False,
) -> None:
    """Turn a folder of mesh files into a pack. Files that cannot be used are named and skipped."""
    from catalog.ingest.folder import ingest

    checked_id(pack_id, "pack")
    with bars() as progress:
        task = progress.add_task("reading", total=None)

        def step(done: int, total: int, name: str) -> None:
            progress.update(task, completed=done, total=total, description=f"reading {name:43.43}")

        report = ingest(
            folder,
            pack_id,
            packs_root(),
            scale=scale,
            scale_of=scale_of or (),
            title=title,
            up=up,
            hulls=hulls,
            hulls_of=hulls_of or (),
            recentre=recentre,
            license_file=license_file,
            replace=replace,
            progress=step,
        )
        progress.update(task, completed=report["files"], total=report["files"], description=f"{'pack written':51}")
    if json_output:
        print_json(report)
        return
    say(
        f"{report['pack']}: {report['assets']} assets of {report['files']} files, {report['materials']} materials, "
        f"licence {report['license']} (AI use {report['ai_use']}), in {report['folder']}"
        f"{' (unchanged)' if report['cached'] else ''}"
    )
    for word, rows, key in (("skipped", report["skipped"], "reason"), ("note", report["notes"], "note")):
        for text, names in grouped(rows, key, "file").items():
            more = f" and {len(names) - NAMES_SHOWN} more (see --json)" if len(names) > NAMES_SHOWN else ""
            say(f"{word}: {text}" + (f": {', '.join(names[:NAMES_SHOWN])}{more}" if names[0] else ""))
    say_excess(report["collision_excess"])
    units = report["units"]
    if units["proposed_scale"]:
        say(f"sizes look wrong: {units['reason']}. An estimate: --scale {units['proposed_scale']}")
