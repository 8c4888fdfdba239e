"""The collision that a mesh's own surface tells: what is solid, what is a shell, and how many convex bodies it takes.

A connected piece that is watertight, but for openings of little area or a bottom that is missing where the thing
stands, is solid: one hull where that fills little that is free, else convex parts. Any other piece is a shell and
becomes thin panels; so does a large one whose triangles face inwards, which is a room seen from within. A cavity, an
inward piece within a solid one, is taken out of it.
"""

from __future__ import annotations

import time
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from catalog.ingest.decompose import LITTLE, cut_piece, holds
from catalog.ingest.merging import gap_cm, measured, merged
from catalog.ingest.panels import panels
from catalog.ingest.surfaces import Faces, Points, SurfacePiece, pieces

SEALED = 0.1
"""Openings up to this share of the hull's surface do not make a shell, ..."""
SLIT_CM2 = 400.0
"""... unless one of them alone is larger than this: a bin is open at its top, however tall it is."""
DOWN = -0.7
"""An opening faces down when its outward direction is lower than this."""
ROOM_CM3 = 1_000_000.0
"""From this volume on a closed surface that faces inwards is a room; a smaller one is inside out."""
FREE_CM, FREE_SHARE = 1.5, 0.005
"""A hull may fill this mean depth of what is free: absolute, and by the size of the piece."""
SMALL_CM = 25.0
"""Smaller pieces keep a hull: what is in one is no deeper than the tolerance of contacts, or not much."""
MOST_SECONDS = 600.0
"""Of cutting a mesh, all its pieces together."""
MOST_CUT = 6
"""The largest pieces that are cut; of the rest each becomes panels."""
MOST_PANELLED = 64
"""The largest pieces that become panels; of the rest each keeps a hull."""


@dataclass
class AutomaticBodies:
    """Corners (cm) of each body, notes, and whether a piece was cut or became panels."""

    bodies: list[Points]
    notes: list[str] = field(default_factory=list)
    parts: bool = False


def automatic(vertices: Points, faces: Faces, cache_folder: Path | None = None) -> AutomaticBodies:
    """The convex bodies of a surface (cm); the same surface gives the same bodies."""
    found = pieces(vertices, faces)
    if not found:
        return AutomaticBodies([vertices], ["it has no triangles with an area: one hull"])
    ground = min(float(piece.points[:, 2].min()) for piece in found)
    whole = without_cavities(found)
    solid = {id(piece) for piece in whole if is_solid(piece, ground)}
    corners, volume, area = measured(np.concatenate([piece.points for piece in whole]))
    size = float(np.linalg.norm(np.ptp(corners, axis=0)))
    if all(id(piece) in solid for piece in whole) and gap_cm(volume, _filled(whole), area) <= allowed_cm(size):
        return AutomaticBodies([corners])
    made, deadline = AutomaticBodies([]), time.monotonic() + MOST_SECONDS
    cut, panelled = 0, 0
    hulls: list[Points] = []
    for piece in whole:
        if any(holds(other, piece.points) for other in hulls[:64]):
            continue
        tight = piece.hull is not None and id(piece) in solid and is_tight(piece)
        if (
            tight
            or (piece.hull is not None and _little(piece, size))
            or (piece.hull is not None and panelled >= MOST_PANELLED)
        ):
            hulls.append(piece.points)
        elif id(piece) not in solid or cut >= MOST_CUT:
            made.bodies += panels(piece)
            panelled, made.parts = panelled + (piece.hull is not None), True
        else:
            cut, made.parts = cut + 1, True
            closed = piece.lidded() if piece.hole_share > SEALED else piece
            parts, note = cut_piece(closed, 2 * allowed_cm(piece.size), deadline, cache_folder)
            made.bodies += parts or panels(piece)
            made.notes += [f"{note}: panels"] if note else []
    made.bodies = merged([*hulls, *made.bodies])
    return made


def is_solid(piece: SurfacePiece, ground: float) -> bool:
    """Whether a piece bounds a solid; ``ground`` is where the whole mesh stands (cm)."""
    if piece.hull is None or (piece.two_sided and piece.holes):
        return False
    if piece.volume < 0:
        return not piece.holes and float(piece.hull.volume) < ROOM_CM3
    if abs(piece.volume) < 1e-3 * float(piece.hull.volume):
        return False
    open_area = float(piece.hull.area) * SEALED
    sides = [hole.area for hole in piece.holes if not (hole.direction[2] < DOWN and hole.middle[2] < ground + FREE_CM)]
    return sum(sides) <= open_area and max(sides, default=0.0) <= SLIT_CM2


def is_tight(piece: SurfacePiece) -> bool:
    """Whether one hull fills little that is free."""
    assert piece.hull is not None
    own = abs(piece.volume)
    return gap_cm(float(piece.hull.volume), own, float(piece.hull.area)) <= allowed_cm(piece.size)


def allowed_cm(size: float) -> float:
    """Mean depth (cm) that a hull of a piece of this size may fill."""
    return FREE_CM + FREE_SHARE * size


def without_cavities(found: list[SurfacePiece]) -> list[SurfacePiece]:
    """The pieces with each cavity made a part of the piece around it."""
    whole = list(found)
    for inner in [piece for piece in found if piece.volume < 0 and not piece.holes and piece.hull is not None]:
        around = [
            piece
            for piece in whole
            if piece is not inner
            and piece.volume > -inner.volume
            and not piece.holes
            and (piece.points.min(axis=0) <= inner.points.min(axis=0)).all()
            and (piece.points.max(axis=0) >= inner.points.max(axis=0)).all()
            and winding(piece, inner.points[:1])[0] > 0.5
        ]
        if around:
            outer = min(around, key=lambda piece: piece.volume)
            whole[whole.index(outer)] = SurfacePiece(
                np.concatenate([outer.points, inner.points]),
                np.concatenate([outer.faces, inner.faces + len(outer.points)]),
            )
            whole.remove(inner)
    return whole


def winding(piece: SurfacePiece, points: Points) -> Points:
    """The generalised winding number of a surface about points (Jacobson et al. 2013): 1 inside a closed one."""
    sums = []
    for point in points:
        a, b, c = (piece.points[piece.faces[:, i]] - point for i in range(3))
        la, lb, lc = (np.linalg.norm(side, axis=1) for side in (a, b, c))
        top = np.einsum("ij,ij->i", a, np.cross(b, c))
        dot = np.einsum("ij,ij->i", a, b) * lc + np.einsum("ij,ij->i", b, c) * la + np.einsum("ij,ij->i", c, a) * lb
        sums.append(float(np.arctan2(top, la * lb * lc + dot).sum()) / (2 * np.pi))
    return np.array(sums)


def _filled(whole: list[SurfacePiece]) -> float:
    """Volume (cm3) of pieces that do not lie in the hull of a larger one."""
    total, seen = 0.0, list[Points]()
    for piece in whole:
        if piece.hull is not None and not any(holds(other, piece.points) for other in seen[:16]):
            total += abs(piece.volume)
            seen.append(piece.points)
    return total


def _little(piece: SurfacePiece, size: float) -> bool:
    return piece.size < max(SMALL_CM, LITTLE * size) and piece.size < 4 * SMALL_CM
