"""The command line called in this process, in a home of its own."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

import pytest

from c4s.cli.boundary import run as boundary
from c4s.cli.main import app


class Done(NamedTuple):
    """How a command ended and what it printed."""

    code: int
    out: str
    err: str


def call(capsys: pytest.CaptureFixture[str], *arguments: str | Path) -> Done:
    """Run a command."""
    capsys.readouterr()
    with pytest.raises(SystemExit) as stop:
        boundary(lambda: app([str(one) for one in arguments], standalone_mode=False))
    told = capsys.readouterr()
    return Done(int(stop.value.code or 0), told.out, told.err)


def refused(done: Done, *words: str) -> None:
    """It ended with exit 2 and one line that holds these words."""
    assert done.code == 2 and done.err.count("\n") == 1 and done.err.startswith("c4s: "), done
    assert all(word in done.err for word in words), done.err


def contents(folder: Path) -> dict[str, bytes | None]:
    """Everything below a folder: the bytes of plain files, None for all else."""
    return {
        str(path.relative_to(folder)): path.read_bytes() if path.is_file() and not path.is_symlink() else None
        for path in sorted(folder.rglob("*"))
    }
