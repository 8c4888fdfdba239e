"""``python -m manual --out FOLDER``."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from c4s.cli import boundary
from manual.build import build_manual


def main(
    out: Annotated[Path, typer.Option("--out", help="Folder of the site; an older one is replaced.")] = Path(
        ".c4s/manual"
    ),
) -> None:
    """Write the documentation as a site that opens from its folder."""
    typer.echo(build_manual(out.resolve()).as_uri())


if __name__ == "__main__":
    alone = typer.Typer(add_completion=False, pretty_exceptions_enable=False)
    alone.command()(main)
    boundary.run(lambda: typer.main.get_command(alone)(standalone_mode=False))
