"""Where c4s writes: one root, ``C4S_HOME`` (default ``.c4s`` in the working directory)."""

from __future__ import annotations

import os
import re
from pathlib import Path

from c4s.errors import BadInput

_ID = re.compile(r"[a-z0-9][a-z0-9._-]{0,62}")


def home() -> Path:
    """The root of everything that c4s writes, as an absolute path."""
    return Path(os.environ.get("C4S_HOME", ".c4s")).absolute()


def packs_root() -> Path:
    """Built asset packs, one folder a pack."""
    return home() / "packs"


def suites_root() -> Path:
    """Built suites, one folder a suite."""
    return home() / "suites"


def runs_root() -> Path:
    """Run folders, one a run."""
    return home() / "runs"


def warehouse_root() -> Path:
    """Parquet parts and the rebuildable DuckDB file of views."""
    return home() / "warehouse"


def site_root() -> Path:
    """The static pages."""
    return home() / "site"


def cache_root() -> Path:
    """Derived data that may be deleted at any time (hulls, mesh arrays, compiled kernels)."""
    return home() / "cache"


def checked_id(text: str, what: str) -> str:
    """The id of a new pack or suite, which is also the name of its folder; ``BadInput`` for any other text."""
    if not _ID.fullmatch(text):
        raise BadInput(f"a {what} id is lower-case letters, digits and . _ -, a letter or digit first", where=text)
    return text
