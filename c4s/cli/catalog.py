"""``c4s catalog``: asset packs."""

from __future__ import annotations

from typing import Annotated

import typer

from c4s.cli.output import print_json, print_table
from c4s.errors import BadInput
from c4s.home import packs_root
from c4s.packs.manifest import Pack

app = typer.Typer(help="Asset packs: list and show.", no_args_is_help=True)


@app.command("list")
def list_packs(json_output: Annotated[bool, typer.Option("--json")] = False) -> None:
    """The packs built here."""
    found = [Pack.read(path) for path in sorted(packs_root().glob("*/pack.json"))]
    if json_output:
        print_json([{"pack": pack.pack_id, "title": pack.title, "assets": len(pack.assets), "license": pack.license,
                     "sha256": pack.sha256()} for pack in found])
    else:
        print_table(["pack", "title", "assets", "licence"],
                    [[pack.pack_id, pack.title, len(pack.assets), pack.license] for pack in found])


@app.command()
def show(pack_id: Annotated[str, typer.Argument(help="id of a pack")],
         json_output: Annotated[bool, typer.Option("--json")] = False) -> None:
    """The assets of a pack."""
    path = packs_root() / pack_id / "pack.json"
    if not path.is_file():
        raise BadInput(f"no pack {pack_id!r}", where=str(packs_root()), todo="see `c4s catalog list`")
    pack = Pack.read(path)
    if json_output:
        print_json(pack.plain())
        return
    print_table(["id", "name", "category", "W x D x H (m)", "path"],
                [[asset.id, asset.name, asset.category, " x ".join(f"{side:.2f}" for side in asset.size_m), asset.path]
                 for asset in pack.assets], title=pack.title)
