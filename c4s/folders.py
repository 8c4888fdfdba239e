"""Putting a finished folder in its place in one step, so that a reader sees the old one or the new one, whole."""

from __future__ import annotations

import ctypes
import os
import shutil
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

_EXCHANGE = 2
_AT_FDCWD = -100


@contextmanager
def beside(place: Path) -> Iterator[Path]:
    """A folder to build in, in the same file system as ``place``; removed at the end with what is left in it.

    A finished folder lies one level deeper than its place, so that no listing takes what a kill leaves for the thing.
    """
    place.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=place.parent, prefix=f".{place.name}.") as scratch:
        yield Path(scratch)


def put_folder(made: Path, place: Path) -> None:
    """Move ``made`` to ``place``. What was there is exchanged with it in one step and then deleted."""
    if not place.exists():
        made.rename(place)
        return
    if not _exchange(made, place):
        old = made.with_name(f"{made.name}.old")
        place.rename(old)
        made.rename(place)
        made = old
    shutil.rmtree(made)


def _exchange(one: Path, other: Path) -> bool:
    """Exchange two folders (Linux ``renameat2``); False where the system or the file system cannot."""
    rename = getattr(ctypes.CDLL(None, use_errno=True), "renameat2", None)
    return rename is not None and not rename(_AT_FDCWD, os.fsencode(one), _AT_FDCWD, os.fsencode(other), _EXCHANGE)
