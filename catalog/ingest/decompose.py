"""Convex decomposition of a mesh: what is convex already stays whole, the rest is cut by coacd and remembered."""

from __future__ import annotations

import io
import json
import os
import signal
import subprocess
import sys
import time
from functools import cache
from importlib import metadata
from pathlib import Path
from typing import Any
from zipfile import BadZipFile

import numpy as np
from scipy.spatial import ConvexHull, QhullError

from c4s.errors import BadInput
from c4s.files import digest, digest_bytes, write_bytes
from c4s.home import cache_root
from catalog.ingest.coacd_run import CPU_LIMIT
from catalog.ingest.surfaces import Faces, Points, SurfacePiece, connected, weld

PARAMETERS: dict[str, Any] = {
    "threshold": 0.05,
    "max_convex_hull": 32,
    "preprocess_mode": "auto",
    "seed": 0,
    "preprocess_resolution": 30,
    "resolution": 1000,
    "mcts_iterations": 60,
    "mcts_nodes": 20,
    "mcts_max_depth": 3,
    "merge": True,
}
"""coacd's, with fewer search steps than its defaults: a quarter of the time, and about as many parts."""
FINEST, COARSEST = 0.03, 0.12
"""Thresholds of coacd that ``cut_piece`` keeps to."""
MOST_PLAIN = 20_000
"""A piece of more triangles is made anew by coacd before it is cut."""
QUICK = {"resolution": 500, "mcts_iterations": 20, "mcts_nodes": 10, "mcts_max_depth": 2}
"""Of ``cut_piece``: a third of the time again."""
MOST_SECONDS = 300.0
"""Of cutting a mesh, all its pieces together; what is left whole then keeps one hull a piece."""
MOST_PIECES = 64
"""A mesh of more pieces is cut as a whole: the many little ones of a decoration are no bodies of their own."""
PIECE_CPU_SECONDS = 20
"""Of cutting one piece: processor time, so that a busy machine cuts what an idle one does."""
BULGE = 0.025
"""A piece is convex when no point lies further outside the plane of a face than this share of its size: about what
coacd's threshold, which is told in half sizes, lets pass."""
FINE_CM = 1.0
"""Notches and chamfers up to this depth do not matter: contacts are scored from 5 cm on."""
LITTLE = 0.1
"""Pieces below this share of the whole keep a hull."""
HIDDEN_CM = 1.0
"""A piece that lies in another's hull, within this much, adds no body."""


def decompose(vertices: Points, faces: Faces, cache_folder: Path | None = None) -> tuple[list[Points], list[str]]:
    """Points (cm) of the convex parts of a surface, and notes on what could not be cut.

    Raises:
        BadInput: coacd is needed and not installed.
    """
    corners, welded = weld(vertices, faces)
    pieces = (
        [_piece(corners, welded[rows]) for rows in connected(welded, np.zeros(len(welded), np.int64))]
        if len(welded)
        else []
    )
    if not pieces:
        return [vertices], ["it has no triangles with an area: one hull"]
    if len(pieces) > MOST_PIECES:
        pieces = [(corners, welded)]
    pieces.sort(key=lambda piece: -float(np.linalg.norm(np.ptp(piece[0], axis=0))))
    found: list[Points] = []
    little = LITTLE * float(np.linalg.norm(np.ptp(corners, axis=0)))
    notes: list[str] = []
    deadline = time.monotonic() + MOST_SECONDS
    for points, triangles in pieces:
        if any(holds(other, points) for other in found):
            continue
        if float(np.linalg.norm(np.ptp(points, axis=0))) < little or is_convex(points, triangles):
            found.append(points)
            continue
        parts, note = _cut(points, triangles, cache_folder or cache_root() / "convex", deadline, PARAMETERS)
        found += parts or [points]
        notes += [f"{note}: one hull"] if note else []
    return found, notes


def is_convex(points: Points, faces: Faces) -> bool:
    """Whether no part of a surface (open or not) bulges inwards by more than ``BULGE`` of its size and ``FINE_CM``."""
    a, b, c = (points[faces[:, i]] for i in range(3))
    normals = np.cross(b - a, c - a)
    areas = np.linalg.norm(normals, axis=1)
    normals, a = normals[areas > 0] / areas[areas > 0, None], a[areas > 0]
    allowed = max(FINE_CM, BULGE * float(np.linalg.norm(np.ptp(points, axis=0))))
    for start in range(0, len(a), 512):
        heights = (points[None] - a[start : start + 512, None]) @ normals[start : start + 512, :, None]
        if (np.minimum(heights.max(axis=1), -heights.min(axis=1)) > allowed).any():
            return False
    return True


def _piece(corners: Points, faces: Faces) -> tuple[Points, Faces]:
    used, renamed = np.unique(faces, return_inverse=True)
    return corners[used], renamed.reshape(faces.shape).astype(np.int64)


def holds(hull: Points, points: Points) -> bool:
    """Whether the hull of some points holds all of others, within ``HIDDEN_CM``."""
    if (points.min(axis=0) < hull.min(axis=0) - HIDDEN_CM).any() or (
        points.max(axis=0) > hull.max(axis=0) + HIDDEN_CM
    ).any():
        return False
    try:
        planes = ConvexHull(hull).equations
    except QhullError:
        return False
    return bool((points @ planes[:, :3].T + planes[:, 3] <= HIDDEN_CM).all())


def cut_piece(
    piece: SurfacePiece, gap_cm: float, deadline: float, folder: Path | None = None
) -> tuple[list[Points], str]:
    """Parts (corners in cm) of a solid piece, concave by about ``gap_cm`` at most; none and why where it cannot be.

    ``deadline``: of ``time.monotonic``. A piece that is no plain closed surface is made anew by coacd first.
    """
    half = float(np.ptp(piece.points, axis=0).max()) / 2
    threshold = float(np.clip(gap_cm / half, FINEST, COARSEST).round(3))
    plain = len(piece.faces) <= MOST_PLAIN
    parameters = {**PARAMETERS, **QUICK, "threshold": threshold, "preprocess_mode": "off" if plain else "on"}
    return _cut(piece.points, piece.faces, folder or cache_root() / "convex", deadline, parameters)


def _cut(
    points: Points, faces: Faces, folder: Path, deadline: float, parameters: dict[str, Any]
) -> tuple[list[Points], str]:
    """The parts that coacd makes of a piece, from the cache when it was tried before; none and why when it fails."""
    centre = points.mean(axis=0).round(2)
    centred = (points - centre).round(3) + 0.0
    key = digest([digest_bytes(centred.tobytes()), digest_bytes(faces.astype("<i8").tobytes()), parameters, _version()])
    file = folder / f"{key}.npz"
    data = file.read_bytes() if file.is_file() else None
    parts = _read(data) if data is not None else None
    if parts is None:
        failed = file.with_suffix(".failed")
        known = failed.is_file()
        data, problem, own = (None, failed.read_text(), True) if known else _run(centred, faces, deadline, parameters)
        parts = _read(data) if data is not None else None
        if data is None or parts is None:
            if own and not known:
                write_bytes(failed, problem.encode())
            return [], f"a piece of {len(faces)} triangles could not be cut ({problem})"
        write_bytes(file, data)
    return [part + centre for part in parts], ""


def _run(points: Points, faces: Faces, deadline: float, parameters: dict[str, Any]) -> tuple[bytes | None, str, bool]:
    """What coacd wrote, or why it wrote nothing, and whether that is the piece's own doing and would be so again."""
    late = f"coacd took more than {MOST_SECONDS:g} s for the mesh"
    if time.monotonic() >= deadline:
        return None, late, False
    sent = io.BytesIO()
    np.savez(sent, vertices=points, faces=faces.astype(np.int32), parameters=np.array(json.dumps(parameters)))
    try:
        done = subprocess.run(
            [sys.executable, "-m", "catalog.ingest.coacd_run"],
            env={**os.environ, "OMP_NUM_THREADS": "1", CPU_LIMIT: f"{PIECE_CPU_SECONDS}"},
            input=sent.getvalue(),
            capture_output=True,
            timeout=max(0.0, deadline - time.monotonic()),
            check=False,
        )
    except subprocess.TimeoutExpired:
        return None, late, False
    if done.returncode == -signal.SIGXCPU:
        return None, f"coacd took more than {PIECE_CPU_SECONDS} s of processor time", True
    if done.returncode:
        lines = done.stderr.decode(errors="replace").strip().splitlines()
        return None, f"coacd ended with {done.returncode}{': ' + lines[-1] if lines else ''}", done.returncode < 0
    return done.stdout, "coacd gave no parts", True


def _read(data: bytes) -> list[Points] | None:
    """The parts of an npz file; None when it holds none or is damaged."""
    try:
        with np.load(io.BytesIO(data), allow_pickle=False) as kept:
            parts = [np.asarray(kept[name], np.float64) for name in kept.files]
    except (ValueError, OSError, EOFError, KeyError, BadZipFile):
        return None
    return [part for part in parts if part.ndim == 2 and part.shape[1] == 3 and len(part) >= 3] or None


@cache
def _version() -> str:
    try:
        return metadata.version("coacd")
    except metadata.PackageNotFoundError:
        raise BadInput(
            "cutting a mesh into convex parts needs coacd",
            where="--hulls decompose",
            todo="pip install coacd, or choose another --hulls",
        ) from None
