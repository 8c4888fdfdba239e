"""Files that are equal are stored once: hard links, where the file system has them."""

from __future__ import annotations

import os
import shutil
from pathlib import Path

from c4s.files import digest_file
from c4s.trees import files_under


def share_equal(folder: Path) -> int:
    """Make equal files under a folder one on the disk; returns how many bytes that spares."""
    first: dict[tuple[int, str], Path] = {}
    spared = 0
    for name, _ in files_under(folder):
        path = folder / name
        size = path.stat().st_size
        known = first.setdefault((size, digest_file(path)), path)
        if known is not path and not known.samefile(path) and _linked(known, path):
            spared += size
    return spared


def link_tree(source: Path, target: Path) -> None:
    """Put the files of a folder into another one without a second copy of their bytes, where that can be."""
    for name, _ in files_under(source):
        place = target / name
        place.parent.mkdir(parents=True, exist_ok=True)
        try:
            os.link(source / name, place)
        except OSError:
            shutil.copyfile(source / name, place)


def _linked(known: Path, path: Path) -> bool:
    """Put a link to a file in the place of its equal, in one step."""
    beside = path.with_name(f".{path.name}.link")
    try:
        os.link(known, beside)
    except OSError:
        return False
    beside.replace(path)
    return True
