"""Where pages may lie."""

from __future__ import annotations

from pathlib import Path
from typing import Final

from c4s.folders import check_own

MARKER: Final = ".c4s-site"
"""In every folder of pages, so that no other folder is taken for one and replaced."""


def check_place(site: Path) -> None:
    """``BadInput`` where something else lies than pages of c4s."""
    check_own(site, MARKER)
