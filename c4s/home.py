"""Where c4s writes: one root, ``C4S_HOME`` (default ``.c4s`` in the working directory)."""

from __future__ import annotations

import os
from pathlib import Path


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
