"""What a process that is gone left in a folder of its own is kept up to a bound; else the folder is emptied."""

from __future__ import annotations

import os
from pathlib import Path

from c4s.engine.confine.confinement import Limits
from c4s.engine.confine.watch import overfull
from c4s.files import write_json

KEPT = Limits(files=10_000, disk=256 << 20)
"""How much of a folder without a part in the result is kept."""


def trim(folder: Path, note: Path) -> None:
    """Empty a folder that holds more than ``KEPT``, and write why into ``note``.

    The process that wrote it must be gone. Links are removed, not followed; no depth of folders is too deep.
    """
    why = overfull([folder], KEPT)
    if why is not None:
        _empty(folder)
        write_json(note, {"why": why, "removed": "everything"})


def _empty(folder: Path) -> None:
    """Remove all that is in a folder. Nested folders are first moved up to it, so every path stays short."""
    moved = 0
    while places := list(os.scandir(folder)):
        for place in places:
            if not place.is_dir(follow_symlinks=False):
                Path(place).unlink()
                continue
            Path(place).chmod(0o700)
            for entry in list(os.scandir(place)):
                if entry.is_dir(follow_symlinks=False):
                    moved += 1
                    Path(entry).rename(folder / f".{folder.name}-moved-{os.getpid()}-{moved}")
                else:
                    Path(entry).unlink()
            Path(place).rmdir()
