"""``c4s backup`` and ``c4s restore``: runs, suites, packs, warehouse parts and human studies, elsewhere and back."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from c4s.cli.output import print_json, say
from c4s.cli.runs_commands import size_text
from c4s.errors import unknown
from c4s.home import warehouse_root
from c4s.run.backup import PARTS, Copied, Part, back_up
from c4s.run.backup import restore as copy_back

Json = Annotated[bool, typer.Option("--json")]


def backup(
    to: Annotated[Path, typer.Argument(help="folder of the backup: a new one, or one that is brought up to date")],
    only: Annotated[
        list[str] | None, typer.Option(help=f"only this part ({', '.join(PARTS)}); repeatable (default: all)")
    ] = None,
    json_output: Json = False,
) -> None:
    """Copy the home's runs, suites, packs, warehouse parts and human studies with their digests.

    The same command again goes on where it was cut off, and copies what has changed. Runs that somebody works on are
    left out, and told.
    """
    parts: list[Part] = [part for part in PARTS if not only or part in only]
    for name in only or ():
        if name not in PARTS:
            raise unknown("part", name, PARTS, where="--only")
    _tell(back_up(to, parts), "backed up", json_output)


def restore(
    source: Annotated[Path, typer.Argument(metavar="FROM", help="folder of a backup")], json_output: Json = False
) -> None:
    """Copy a backup into the home: each file is held against its digest, and none that is there is overwritten.

    The same command again goes on where it was cut off.
    """
    from warehouse.database import rebuild

    done = copy_back(source)
    if warehouse_root().is_dir():
        rebuild(warehouse_root())
    _tell(done, "restored", json_output)
    if not json_output:
        say("`c4s report` makes the pages anew")


def _tell(done: Copied, what: str, json_output: bool) -> None:
    if json_output:
        print_json(
            {
                "files": done.files,
                "copied": done.copied,
                "bytes": done.size,
                "left_out": done.left_out,
                "links": done.links,
            }
        )
        return
    say(f"{done.files} files ({size_text(done.size)}) {what}, {done.copied} of them copied now")
    if done.left_out:
        say(f"left out, as somebody works on them: {', '.join(done.left_out)}")
    if done.links:
        say(f"{done.links} links were not copied: none of them is part of a result")
