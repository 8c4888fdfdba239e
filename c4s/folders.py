"""Putting a finished folder in its place, and removing one: only what c4s made is replaced or removed."""

from __future__ import annotations

import ctypes
import os
import shutil
import stat
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from c4s.errors import BadInput, MachineryFault
from c4s.home import (
    analyses_root,
    cache_root,
    human_root,
    packs_root,
    runs_root,
    site_root,
    suites_root,
    warehouse_root,
)

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


def put_folder(made: Path, place: Path, *, marker: str) -> None:
    """Move ``made`` to ``place``. What was there is exchanged with it in one step and then deleted.

    ``marker``: the file that every folder of this kind holds. ``BadInput``, and nothing is touched, where something
    lies at ``place`` that is no folder with it.
    """
    check_own(place, marker)
    if not place.exists():
        made.rename(place)
        return
    if not _exchange(made, place):
        old = made.with_name(f"{made.name}.old")
        place.rename(old)
        made.rename(place)
        made = old
    remove_tree(made, inside=place.parent)


def numbered_folder(root: Path, stem: str) -> Path:
    """The first free ``<stem>-<n>``, made."""
    root.mkdir(parents=True, exist_ok=True)
    number = 1
    while True:
        try:
            (root / f"{stem}-{number}").mkdir()
        except FileExistsError:
            number += 1
            continue
        return root / f"{stem}-{number}"


def check_own(place: Path, marker: str) -> None:
    """``BadInput`` where something lies at ``place`` that is neither empty nor a folder with a ``marker``."""
    if not os.path.lexists(place):
        return
    plain = place.is_dir() and not place.is_symlink()
    if not plain or (not (place / marker).is_file() and any(place.iterdir())):
        raise BadInput(
            f"something lies here that c4s did not make: a folder of this kind holds {marker}",
            where=str(place),
            todo="move it away, or choose another name",
        )


def remove_tree(folder: Path, *, inside: Path, at_best: bool = False) -> None:
    """Remove a folder with all that is in it, where there is one: the only place where c4s does.

    Args:
        folder: the folder; links in it are removed, what they lead to is not.
        inside: a folder above it, that belongs to c4s or to this process.
        at_best: what cannot be removed is left.

    Raises:
        MachineryFault: the folder is a link, or does not lie below ``inside``.
    """
    real, root = Path(os.path.realpath(folder)), Path(os.path.realpath(inside))
    if folder.is_symlink() or root not in real.parents:
        raise MachineryFault(f"this folder is not c4s's to remove: it does not lie below {inside}", where=str(folder))
    if folder.exists():
        shutil.rmtree(folder, ignore_errors=at_best)


def check_new(place: Path) -> None:
    """``BadInput`` where a user's new folder cannot be made at ``place``: something but an empty folder is there."""
    _check_outside(place)
    if os.path.lexists(place) and (place.is_symlink() or not place.is_dir() or any(place.iterdir())):
        raise BadInput("this is no new or empty folder", where=str(place), todo="choose another name")


def check_own_output(place: Path, marker: str) -> None:
    """``check_own`` for a folder that a user named: ``BadInput`` for one inside of what c4s keeps too."""
    _check_outside(place)
    check_own(place, marker)


def _check_outside(path: Path) -> None:
    """``BadInput`` for an output inside of what c4s keeps: a frozen folder with one more file is another one."""
    real = Path(os.path.realpath(path))
    for root in (
        packs_root(),
        suites_root(),
        runs_root(),
        warehouse_root(),
        analyses_root(),
        human_root(),
        site_root(),
        cache_root(),
    ):
        if real == (kept := Path(os.path.realpath(root))) or kept in real.parents:
            raise BadInput("c4s keeps this folder itself", where=str(root), todo="write the output elsewhere")


def check_out(path: Path, *, replace: bool, magic: bytes = b"") -> None:
    """``BadInput`` where a file may not be written to ``path``, which a user named; before anything is done.

    Args:
        path: the output. Its folder is there, or can be made.
        replace: whether a plain file that lies there may be overwritten.
        magic: how a file of this kind begins: one that begins otherwise is never overwritten.
    """
    _check_outside(path)
    try:
        found = os.lstat(path)
    except FileNotFoundError:
        return
    except OSError as error:
        raise BadInput(f"this cannot be written: {error.strerror}", where=str(path)) from None
    if not stat.S_ISREG(found.st_mode):
        raise BadInput("this is no plain file: it is left as it is", where=str(path), todo="choose another name")
    if not replace:
        raise BadInput("this file exists", where=str(path), todo="give --replace, or choose another name")
    with path.open("rb") as file:
        if file.read(len(magic)) != magic:
            raise BadInput("this file is of another kind: it is left as it is", where=str(path))


def _exchange(one: Path, other: Path) -> bool:
    """Exchange two folders (Linux ``renameat2``); False where the system or the file system cannot."""
    rename = getattr(ctypes.CDLL(None, use_errno=True), "renameat2", None)
    return rename is not None and not rename(_AT_FDCWD, os.fsencode(one), _AT_FDCWD, os.fsencode(other), _EXCHANGE)
