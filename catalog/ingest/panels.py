"""Open surfaces as thin convex panels: each flat region of a surface, cut into convex outlines, a few mm thick.

A panel lies behind its surface, away from the side that its triangles face, so that what stands on a floor stands on
the very triangles; one that was given with both windings lies on both sides.
"""

from __future__ import annotations

import numpy as np
import shapely
from numpy.typing import NDArray
from scipy.spatial import ConvexHull, QhullError

from catalog.ingest.surfaces import Points, SurfacePiece

THICK_CM = 0.5
SAME_PLANE_CM = 0.3
"""A region is flat when its corners lie this near to one plane."""
SAME_WAY = 0.98
"""Cosine between the normal of a triangle and that of its region."""
NOTCH_CM = 0.5
"""An outline is convex when its hull adds a strip of no more than this width on average."""
MOST_FACES = 30_000
"""Corners of a surface of more triangles are moved to a grid of ``GRID_SHARE`` of its size first."""
GRID_SHARE = 0.01


def panels(piece: SurfacePiece) -> list[Points]:
    """Corners (cm) of the panels of a piece."""
    if len(piece.faces) > MOST_FACES:
        piece = _coarse(piece)
    found, triangles = list[Points](), piece.triangles
    for rows, normal in _regions(piece):
        found += _outlines(triangles[rows], normal, piece.two_sided)
    return found


def _coarse(piece: SurfacePiece) -> SurfacePiece:
    step = GRID_SHARE * piece.size
    corners, same = np.unique(np.round(piece.points / step), axis=0, return_inverse=True)
    faces = same.reshape(-1)[piece.faces]
    across = np.cross(corners[faces[:, 1]] - corners[faces[:, 0]], corners[faces[:, 2]] - corners[faces[:, 0]])
    faces = faces[np.linalg.norm(across, axis=1) > 0]
    _, first = np.unique(np.sort(faces, axis=1), axis=0, return_index=True)
    return SurfacePiece(corners * step, faces[np.sort(first)], piece.two_sided) if len(first) else piece


def _regions(piece: SurfacePiece) -> list[tuple[NDArray[np.int64], Points]]:
    """Faces of each flat region, with its normal: grown across edges from the largest triangle left."""
    triangles = piece.triangles
    across = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    areas = np.linalg.norm(across, axis=1)
    normals = across / areas[:, None]
    edges = np.sort(piece.faces[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
    _, which = np.unique(edges, axis=0, return_inverse=True)
    which = which.reshape(-1, 3)
    by_edge: list[list[int]] = [[] for _ in range(int(which.max()) + 1)]
    for face, own in enumerate(which.tolist()):
        for edge in own:
            by_edge[edge].append(face)
    free = np.ones(len(triangles), dtype=bool)
    found = []
    for seed in np.argsort(-areas, kind="stable").tolist():
        if not free[seed]:
            continue
        near = normals @ normals[seed] > SAME_WAY
        near &= (np.abs((triangles - triangles[seed, 0]) @ normals[seed]) <= SAME_PLANE_CM).all(axis=1) & free
        free[seed], rows, at = False, [seed], 0
        while at < len(rows):
            for edge in which[rows[at]].tolist():
                for face in by_edge[edge]:
                    if near[face] and free[face]:
                        free[face] = False
                        rows.append(face)
            at += 1
        found.append((np.array(rows), normals[seed]))
    return found


def _outlines(triangles: Points, normal: Points, two_sided: bool) -> list[Points]:
    """Corners of the convex panels of a flat region."""
    origin = triangles[0, 0]
    axes = np.linalg.svd(normal[None])[2][1:]
    flat = (triangles - origin) @ axes.T
    behind = normal * THICK_CM
    depths = (behind / 2, -behind / 2) if two_sided else (np.zeros(3), -behind)

    def panel(outline: Points) -> Points:
        face = outline @ axes + origin
        return np.concatenate([face + depth for depth in depths])

    corners = flat.reshape(-1, 2)
    try:
        whole = ConvexHull(corners)
    except QhullError:
        return [np.concatenate([triangles.reshape(-1, 3) + depth for depth in depths])]
    sides = flat[:, 1:] - flat[:, :1]
    area = float(np.abs(sides[:, 0, 0] * sides[:, 1, 1] - sides[:, 0, 1] * sides[:, 1, 0]).sum() / 2)
    if float(whole.volume) - area <= NOTCH_CM * float(whole.area) / 2:
        return [panel(corners[whole.vertices])]
    shape = shapely.union_all(shapely.polygons(flat), grid_size=1e-3)
    cut: list[Points] = []
    for polygon in getattr(shape, "geoms", [shape]):
        if isinstance(polygon, shapely.Polygon) and polygon.area > 1e-3:
            cut += _convex_parts(polygon)
    return [panel(outline) for outline in cut] or [panel(corners[whole.vertices])]


def _convex_parts(polygon: shapely.Polygon) -> list[Points]:
    """Convex outlines (n, 2) that cover a polygon: its triangles, joined while what they make stays convex."""
    eased = polygon.simplify(NOTCH_CM / 2)
    eased = eased if isinstance(eased, shapely.Polygon) and eased.is_valid and not eased.is_empty else polygon
    parts = [one for one in shapely.constrained_delaunay_triangles(eased).geoms if one.area > 1e-6]
    parts.sort(key=lambda one: (-one.area, one.bounds))
    done: list[shapely.Polygon] = []
    while parts:
        grown, rest, joined = parts[0], parts[1:], True
        while joined:
            joined = False
            for number, other in enumerate(rest):
                if grown.distance(other) > 1e-6:
                    continue
                hull = shapely.union(grown, other).convex_hull
                if hull.area - grown.area - other.area <= NOTCH_CM / 4 * min(hull.length, other.length) / 2:
                    grown, joined = hull, True
                    del rest[number]
                    break
        done.append(grown)
        parts = rest
    return [np.array(one.exterior.coords)[:-1] for one in done]
