"""Folders of compiled code: each belongs to exactly the sources that its name has the digest of."""

from __future__ import annotations

import tempfile
import time
from pathlib import Path
from typing import Final

from c4s.folders import remove_tree

_STALE_S: Final = 86400.0


def writable(folder: Path) -> bool:
    """Whether files can be made in a folder, which is made where it is not there."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with tempfile.NamedTemporaryFile(dir=folder):
            return True
    except OSError:
        return False


def prune(chosen: Path, kind: str) -> None:
    """Delete what earlier sources left beside a folder, ``<kind>-<digest>``, a day ago or longer."""
    for folder in chosen.parent.glob(f"{kind}-*"):
        if folder != chosen and folder.stat().st_mtime < time.time() - _STALE_S:
            remove_tree(folder, inside=chosen.parent, at_best=True)
