"""Recast itself, as the reference of the walkable space: built here from the library of the system."""

from __future__ import annotations

import ctypes
import shutil
import subprocess
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from c4s.collision.shapes import Body
from c4s.navigation import NavigationSettings, WalkableSpace
from c4s.navigation.solids import solids_of

_HEADERS = "/usr/include/recastnavigation"
_SIMPLIFIED = 0.7
"""Largest error of Recast's contours, in cells."""


class NoRecast(Exception):
    """Recast cannot be built here; the message says what is missing."""


@dataclass(frozen=True)
class RecastCells:
    """What Recast can walk on: cells (column, row), their floor in steps, and the component of each."""

    column: NDArray[np.int32]
    row: NDArray[np.int32]
    floor: NDArray[np.int32]
    component: NDArray[np.int32]
    polygons_m2: float
    """Area of its polygons, simplified."""
    voxels_s: float
    """Up to its regions."""
    whole_s: float
    """With contours and polygons."""


@cache
def library() -> Any:
    """The compiled interface. ``NoRecast`` where the compiler or the library is missing."""
    compiler = shutil.which("g++")
    if compiler is None or not Path(_HEADERS, "Recast.h").is_file():
        raise NoRecast("Recast is not here: it takes g++ and the Debian package librecast-dev")
    source = Path(__file__).with_name("shim.cpp")
    with tempfile.TemporaryDirectory(prefix="c4s-recast-") as folder:
        made = Path(folder) / "recast.so"
        done = subprocess.run(
            [compiler, "-O2", "-shared", "-fPIC", f"-I{_HEADERS}", str(source), "-o", str(made), "-lRecast"],
            capture_output=True,
            text=True,
            check=False,
        )
        if done.returncode:
            raise NoRecast(f"Recast does not build here: {done.stderr.strip()[-300:]}")
        loaded = ctypes.CDLL(str(made))
    loaded.recast_build.restype = ctypes.c_void_p
    loaded.recast_count.argtypes = [ctypes.c_void_p]
    loaded.recast_free.argtypes = [ctypes.c_void_p]
    return loaded


def recast_cells(bodies: Sequence[Body], space: WalkableSpace, settings: NavigationSettings) -> RecastCells:
    """What Recast makes of the same bodies in the same field; bodies go in by their height, the lowest first.

    Recast lets the order decide where spans merge: with this one, the highest decides.
    """
    made = library()
    order = np.argsort([body.high[2] for body in bodies], kind="stable")
    solids = solids_of([bodies[index] for index in order])
    triangles = np.ascontiguousarray(solids.triangles[:, [0, 2, 1]][:, :, [0, 2, 1]], np.float32)
    first = np.ascontiguousarray(solids.first, np.int32)
    low = np.ascontiguousarray(space.origin_cm[[0, 2, 1]], np.float32)
    top = float(solids.high[:, 2].max(initial=0.0)) + settings.height_cm + 2 * settings.cell_height_cm
    numbers = (
        top,
        settings.cell_cm,
        settings.cell_height_cm,
        settings.radius_cm,
        settings.height_cm,
        settings.step_cm,
        settings.slope_deg,
        settings.min_region_area,
        _SIMPLIFIED,
    )
    found = made.recast_build(
        ctypes.c_void_p(triangles.ctypes.data),
        ctypes.c_void_p(first.ctypes.data),
        ctypes.c_int(len(bodies)),
        ctypes.c_void_p(low.ctypes.data),
        ctypes.c_int(space.columns),
        ctypes.c_int(space.rows),
        *map(ctypes.c_float, numbers),
    )
    count = made.recast_count(found)
    parts = [np.empty(count, np.int32) for _ in range(4)]
    told = np.empty(3)
    made.recast_read(
        ctypes.c_void_p(found),
        *(ctypes.c_void_p(part.ctypes.data) for part in parts),
        ctypes.c_void_p(told.ctypes.data),
    )
    made.recast_free(found)
    column, row, floor, component = parts
    return RecastCells(column, row, floor, component, told[0] / 1e4, voxels_s=told[1], whole_s=told[2])
