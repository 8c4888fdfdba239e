"""Exact penetration depths of convex bodies, by other means than the product's: a core of points and a radius.

A sphere is a point with a radius, a capsule a segment with a radius. The depth of two bodies is the sum of their radii
plus the depth of their cores, or minus the distance of their cores; both are read from the Minkowski difference.
"""

from __future__ import annotations

from itertools import combinations

import numpy as np
from scipy.spatial import ConvexHull, QhullError


def exact_depth(a: np.ndarray, b: np.ndarray, radius: float = 0.0) -> float:
    """Depth in cm of two cores (n, 3), of the given sum of radii; 0 when the bodies do not touch."""
    difference = np.unique((a[:, None] - b[None]).reshape(-1, 3), axis=0)
    return max(0.0, radius + _signed_depth(difference))


def _signed_depth(points: np.ndarray) -> float:
    """Depth of the origin in the hull of points, or minus its distance from it."""
    spread = np.linalg.svd(points - points.mean(axis=0), compute_uv=False)
    if len(points) > 3 and spread[2] > 1e-9 * spread[0]:
        try:
            hull = ConvexHull(points)
        except QhullError:
            return -_distance(points)
        depth = float(-hull.equations[:, 3].max())
        return depth if depth >= 0 else -_distance(points[hull.vertices])
    return -_distance(points)


def _distance(points: np.ndarray) -> float:
    """Distance of the origin from the hull of points that does not hold it inside: the least over all triangles."""
    if len(points) < 3:
        points = np.concatenate([points] * 3)
    corners = points[np.array(list(combinations(range(len(points)), 3)))]
    return float(_to_triangles(corners[:, 0], corners[:, 1], corners[:, 2]).min())


def _to_segments(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    along = b - a
    square = (along**2).sum(axis=1)
    share = np.clip(-(a * along).sum(axis=1) / np.where(square > 0, square, 1), 0, 1)
    return np.linalg.norm(a + share[:, None] * along, axis=1)


def _to_triangles(a: np.ndarray, b: np.ndarray, c: np.ndarray) -> np.ndarray:
    """Distances of the origin from triangles: to the plane where its foot lies inside, else to the nearest edge."""
    best = np.minimum(np.minimum(_to_segments(a, b), _to_segments(b, c)), _to_segments(c, a))
    normal = np.cross(b - a, c - a)
    square = (normal**2).sum(axis=1)
    real = square > 1e-18
    height = (a * normal).sum(axis=1)
    foot = height[:, None] * normal / np.where(real, square, 1)[:, None]
    inside = real.copy()
    for start, end in ((a, b), (b, c), (c, a)):
        inside &= (np.cross(end - start, foot - start) * normal).sum(axis=1) >= 0
    return np.where(inside, np.minimum(best, np.abs(height) / np.sqrt(np.where(real, square, 1))), best)
