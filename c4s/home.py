"""Where c4s writes: one root, ``C4S_HOME`` (default ``.c4s`` in the working directory)."""

from __future__ import annotations

import os
from pathlib import Path

from c4s.errors import BadInput


def home() -> Path:
    """The root of everything that c4s writes, as an absolute path. ``BadInput`` for one that can be no folder."""
    told = os.environ.get("C4S_HOME", ".c4s")
    place = Path(told).absolute()
    if not told.strip():
        raise BadInput("it is empty", where="C4S_HOME", todo="name a folder, or unset it for .c4s here")
    if not place.is_dir():
        _check_new(place)
    return place


def _check_new(place: Path) -> None:
    """``BadInput`` for a home that cannot be made: something else is there or on the way."""
    try:
        str(place).encode()
        at = next(folder for folder in (place, *place.parents) if os.path.lexists(folder))
    except (UnicodeEncodeError, OSError):
        raise BadInput(f"{str(place)!a} is no path", where="C4S_HOME", todo="name a folder") from None
    if not at.is_dir():
        raise BadInput(f"{at} is no folder", where="C4S_HOME", todo="name a folder")
    if not os.access(at, os.W_OK) or at.is_relative_to("/proc"):
        raise BadInput(f"nothing can be made in {at}", where="C4S_HOME", todo="name a folder that you may write to")


def _folder(name: str) -> Path:
    """A folder of the home, there or not; ``BadInput`` where something else has its name."""
    place = home() / name
    if os.path.lexists(place) and not place.is_dir():
        raise BadInput("this is no folder", where=str(place), todo="move it away")
    return place


def packs_root() -> Path:
    """Built asset packs, one folder a pack."""
    return _folder("packs")


def suites_root() -> Path:
    """Built suites, one folder a suite."""
    return _folder("suites")


def runs_root() -> Path:
    """Run folders, one a run."""
    return _folder("runs")


def warehouse_root() -> Path:
    """Parquet parts and the rebuildable DuckDB file of views."""
    return _folder("warehouse")


def analyses_root() -> Path:
    """Answers of studies with their rows, one folder an answer."""
    return _folder("analyses")


def human_root() -> Path:
    """Human studies, one folder a study."""
    return _folder("human")


def reviews_root() -> Path:
    """What reviewers said of suites, one folder a suite."""
    return human_root() / "reviews"


def site_root() -> Path:
    """The static pages."""
    return _folder("site")


def cache_root() -> Path:
    """Derived data that may be deleted at any time (hulls, mesh arrays, compiled kernels)."""
    return _folder("cache")
