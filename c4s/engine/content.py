"""What an engine that ran agent code may leave behind: plain files under plain names that the host can read."""

from __future__ import annotations

import os
import stat
from itertools import islice
from pathlib import Path

from c4s.bounds import BOUNDS
from c4s.errors import shortage


def content_fault(folder: Path) -> str | None:
    """Why the host must not read this content folder, or None when it is sound. Links are never followed.

    A link or special file could lead to what a submission must not hold; a name that is no text, a folder that is
    nested without end, or what cannot be read would break the programs that read it later. ``OSError`` where it is the
    machine that cannot read.
    """
    files = size = 0
    waiting = [(str(folder), 0)]
    while waiting:
        place, depth = waiting.pop()
        deep = BOUNDS["content_depth"].fault(depth)
        if deep is not None:
            return deep
        try:
            with os.scandir(place) as found:
                entries = list(islice(found, BOUNDS["content_files"].most + 1))
        except OSError as error:
            if shortage(error) is not None:
                raise
            return f"a folder cannot be read: {error.strerror}"
        for entry in entries:
            name = ascii(os.path.relpath(entry.path, folder))
            found_stat = entry.stat(follow_symlinks=False)
            files, size = files + 1, size + found_stat.st_size
            if not entry.name.isprintable():
                return f"the name {name} is no text"
            fault = BOUNDS["content_files"].fault(files) or BOUNDS["content_bytes"].fault(size)
            if fault is not None:
                return fault
            if stat.S_ISDIR(found_stat.st_mode):
                waiting.append((entry.path, depth + 1))
            elif not stat.S_ISREG(found_stat.st_mode):
                return f"{name} is no plain file"
            elif not os.access(entry.path, os.R_OK):
                return f"{name} cannot be read"
    return None
