"""Fewer convex bodies: neighbours become one where their common hull adds little that is not there.

What a merge adds is told as a gap (cm): the volume that the common hull has beyond the two, by its narrowest side (its
thickness times its length). It is the mean width of what is filled and should be free, also of a door between panels.
"""

from __future__ import annotations

import heapq
from collections.abc import Sequence

import numpy as np
import shapely
from scipy.spatial import ConvexHull, QhullError

from catalog.ingest.surfaces import Points

GAP_CM = 1.0
"""Merges up to this gap are always made."""
MOST_BODIES = 96
"""Beyond this number merges are made up to ``LARGEST_GAP_CM``."""
LARGEST_GAP_CM = 3.0
HARD_LIMIT = 1024
"""Beyond this number the cheapest merges are made at whatever gap."""
REACH_CM = 1.0
"""How near the boxes of neighbours are."""
AT_ONCE = 1500
"""Of more bodies those that lie together are merged first, without comparing all."""


def measured(points: Points) -> tuple[Points, float, float]:
    """Corners of the hull of points, its volume (cm3) and surface (cm2); the points themselves when they are flat."""
    try:
        found = ConvexHull(points)
    except QhullError:
        return points, 0.0, 0.0
    return points[found.vertices], float(found.volume), float(found.area)


def gap_cm(hull_volume: float, own_volume: float, hull_area: float) -> float:
    """Mean depth of what a hull fills beyond what is there."""
    return max(0.0, hull_volume - own_volume) / (hull_area / 2) if hull_area > 0 else 0.0


def _narrowest_side(corners: Points) -> float:
    """Smallest extent times largest (cm2), along the main axes of the corners."""
    centred = corners - corners.mean(axis=0)
    extents = np.ptp(centred @ np.linalg.eigh(centred.T @ centred)[1], axis=0)
    return max(float(extents.min() * extents.max()), 1e-9)


def merged(bodies: Sequence[Points], *, most: int = MOST_BODIES) -> list[Points]:
    """The bodies (corners in cm) with neighbours merged, cheapest first; the same bodies give the same result."""
    bodies = list(bodies)
    if len(bodies) > AT_ONCE:
        bodies = _grouped(bodies)
    known = {number: measured(points)[:2] for number, points in enumerate(bodies)}
    boxes = {number: (row[0].min(axis=0), row[0].max(axis=0)) for number, row in known.items()}
    heap: list[tuple[float, int, int, Points]] = []
    fresh = len(known)

    def offer(a: int, b: int) -> None:
        corners, volume, _ = measured(np.concatenate([known[a][0], known[b][0]]))
        gap = max(0.0, volume - known[a][1] - known[b][1]) / _narrowest_side(corners)
        if gap <= (np.inf if len(known) > HARD_LIMIT else LARGEST_GAP_CM):
            heapq.heappush(heap, (gap, min(a, b), max(a, b), corners))

    for a, b in _neighbours([boxes[number] for number in known]):
        offer(a, b)
    while heap:
        gap, a, b, corners = heapq.heappop(heap)
        if a not in known or b not in known:
            continue
        limit = np.inf if len(known) > HARD_LIMIT else LARGEST_GAP_CM if len(known) > most else GAP_CM
        if gap > limit:
            break
        known[fresh], boxes[fresh] = (
            (corners, known.pop(a)[1] + known.pop(b)[1]),
            (corners.min(axis=0), corners.max(axis=0)),
        )
        low, high = boxes[fresh][0] - REACH_CM, boxes[fresh][1] + REACH_CM
        for other in list(known):
            if other != fresh and (boxes[other][0] <= high).all() and (boxes[other][1] >= low).all():
                offer(other, fresh)
        fresh += 1
    return [known[number][0] for number in sorted(known)]


def _neighbours(boxes: list[tuple[Points, Points]]) -> list[tuple[int, int]]:
    low, high = np.array([box[0] for box in boxes]), np.array([box[1] for box in boxes])
    plan = shapely.box(*(low[:, :2] - REACH_CM).T, *high[:, :2].T)
    a, b = shapely.STRtree(plan).query(plan)
    keep = (a < b) & (low[a, 2] - REACH_CM <= high[b, 2]) & (low[b, 2] - REACH_CM <= high[a, 2])
    return sorted(zip(a[keep].tolist(), b[keep].tolist(), strict=True))


def _grouped(bodies: list[Points]) -> list[Points]:
    """At most ``AT_ONCE`` bodies: halved along the longest side of what is left until each group is near together."""
    middles = np.array([(points.min(axis=0) + points.max(axis=0)) / 2 for points in bodies])
    groups = [np.arange(len(bodies))]
    heap = [(-float(np.ptp(middles, axis=0).max()), 0)]
    while len(groups) < AT_ONCE and heap:
        spread, number = heapq.heappop(heap)
        rows = groups[number]
        if spread == 0 or len(rows) < 2:
            break
        axis = int(np.argmax(np.ptp(middles[rows], axis=0)))
        order = rows[np.argsort(middles[rows, axis], kind="stable")]
        groups[number], fresh = order[: len(order) // 2], order[len(order) // 2 :]
        groups.append(fresh)
        for one in (number, len(groups) - 1):
            heapq.heappush(heap, (-float(np.ptp(middles[groups[one]], axis=0).max()), one))
    return [measured(np.concatenate([bodies[row] for row in rows.tolist()]))[0] for rows in groups]
