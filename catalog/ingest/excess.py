"""How much collision bodies hold that is not there: their free depth, and their volume beyond the mesh's own."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from scipy.spatial import ConvexHull, QhullError

from c4s.geometry.transform import rotation_matrix
from c4s.records.pack import BoxBody, CollisionBody, HullBody, SphereBody
from catalog.ingest.automatic import is_solid, without_cavities
from catalog.ingest.hulls import joined
from catalog.ingest.surface import SourcePart
from catalog.ingest.surfaces import FLAT_CM, Faces, Points, pieces

GRID = 14
"""Points along each side of a body that are looked at."""
NEAR_CM = 2.0
"""What lies this near to a body is no free place."""
MOST_LISTED = 10
_SIGNS = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], dtype=float)
_TURNS = np.arange(16) * 2 * np.pi / 16


def corners_of(body: CollisionBody) -> Points:
    """Corners (n, 3) in cm of a body; of a round one, points of its surface."""
    if isinstance(body, HullBody):
        return np.array(body.vertices, dtype=float)
    if isinstance(body, BoxBody):
        local = _SIGNS * np.array(body.half_extent)
    else:
        half = 0.0 if isinstance(body, SphereBody) else body.length / 2
        rows = [
            [body.radius * np.cos(rise) * np.cos(turn), body.radius * np.cos(rise) * np.sin(turn), end * height]
            for end in (-1, 1)
            for rise in np.linspace(0, np.pi / 2, 5)
            for turn in _TURNS
            for height in [half + body.radius * np.sin(rise)]
        ]
        local = np.array(rows)
    turn = np.eye(3) if isinstance(body, SphereBody) else np.asarray(rotation_matrix(body.rotation_deg))
    moved: Points = local @ turn.T + np.array(body.center)
    return moved


def free_depth_cm(bodies: Sequence[CollisionBody], made: Sequence[Points]) -> float:
    """How deep in one of the bodies a place lies that is near to none of the parts that a mesh was made into."""
    planes = [found for points in made if (found := _planes(points)) is not None]
    flat = [points for points in made if _planes(points) is None]
    deepest = 0.0
    for body in bodies:
        own = _planes(corners := corners_of(body))
        if own is None:
            continue
        low, high = corners.min(axis=0), corners.max(axis=0)
        steps = (np.arange(GRID) + 0.5) / GRID
        grid = np.stack(np.meshgrid(steps, steps, steps, indexing="ij"), axis=-1).reshape(-1, 3) * (high - low) + low
        depth = -(grid @ own[:, :3].T + own[:, 3]).max(axis=1)
        grid, depth = grid[depth > deepest], depth[depth > deepest]
        for other in planes:
            free = (grid @ other[:, :3].T + other[:, 3]).max(axis=1) > NEAR_CM
            grid, depth = grid[free], depth[free]
        for points in flat:
            free = ((grid < points.min(axis=0) - NEAR_CM) | (grid > points.max(axis=0) + NEAR_CM)).any(axis=1)
            grid, depth = grid[free], depth[free]
        deepest = max(deepest, float(depth.max(initial=0.0)))
    return deepest


def _planes(points: Points) -> Points | None:
    try:
        return np.asarray(np.unique(np.round(ConvexHull(points).equations, 9), axis=0))
    except QhullError:
        return None


def bodies_volume(bodies: Sequence[CollisionBody]) -> float:
    """Sum of the volumes (cm3) of bodies; what two of them share counts twice."""
    total = 0.0
    for body in bodies:
        try:
            total += float(ConvexHull(corners_of(body)).volume)
        except QhullError:
            continue
    return total


def excess_row(name: str, parts: Sequence[SourcePart], bodies: Sequence[CollisionBody]) -> dict[str, Any]:
    """What an asset's bodies hold and what its mesh does, in litres, and their ratio; None for an empty mesh."""
    held = bodies_volume(bodies) / 1000
    own = own_volume(*joined([(part.node, part.vertices, part.faces) for part in parts])) / 1000
    return {
        "asset": name,
        "bodies": len(bodies),
        "bodies_l": round(held, 3),
        "mesh_l": round(own, 3),
        "factor": round(held / own, 2) if own > 0 else None,
    }


def worst(rows: Sequence[dict[str, Any]]) -> list[dict[str, Any]]:
    """The ``MOST_LISTED`` rows whose bodies hold most beyond their mesh."""
    beyond = [row for row in rows if row["bodies_l"] > row["mesh_l"]]
    return sorted(beyond, key=lambda row: (row["mesh_l"] - row["bodies_l"], row["asset"]))[:MOST_LISTED]


def own_volume(vertices: Points, faces: Faces) -> float:
    """Volume (cm3) of a mesh's solid pieces, and of its shells as thin as panels."""
    found = pieces(vertices, faces)
    if not found:
        return 0.0
    ground = min(float(piece.points[:, 2].min()) for piece in found)
    total = 0.0
    for piece in without_cavities(found):
        if is_solid(piece, ground):
            total += abs(piece.volume)
        else:
            sides = piece.triangles
            across = np.cross(sides[:, 1] - sides[:, 0], sides[:, 2] - sides[:, 0])
            total += float(np.linalg.norm(across, axis=1).sum()) / 2 * FLAT_CM
    return total
