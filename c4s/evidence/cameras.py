"""Where the evaluator looks from: four overview views of a whole scene, chosen from its snapshot alone.

The plan is deterministic. It frames the content (not the ground or sky) and lifts each camera until no actor's
bounds hold it and the line of sight to the target is free at the start (Overview Alignment, paper section
"Semantic Verifier for Text-to-Scene": a scene-graph and clearance-aware camera plan, exactly four views).
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from c4s.geometry.transform import WORLD_CM
from c4s.protocol.rules import OVERVIEW_VIEWS

Array: TypeAlias = NDArray[np.float64]


HORIZONTAL_FOV_DEG = 60.0
CLEARANCE_CM = 100.0
SIZE_PX = {"width": 960, "height": 540}
"""Size of evidence pictures."""


def _content_boxes(snapshot: Mapping[str, Any]) -> Array:
    """Origins and half extents (n, 2, 3) of the actors with a real box that is not a plate or a sky dome.

    What lies beyond the largest world counts as at its edge.
    """
    boxes = [
        (actor["bounds"]["origin_cm"], actor["bounds"]["extent_cm"])
        for actor in snapshot["actors"]
        if actor.get("bounds") and actor.get("component_asset_paths")
    ]
    found = np.asarray(boxes, dtype=float).reshape(-1, 2, 3)
    found = np.clip(found[np.isfinite(found).all(axis=(1, 2))], -WORLD_CM, WORLD_CM)
    solid = found[(found[:, 1].max(axis=1) > 1.0) & (found[:, 1, :2].max(axis=1) < 6000.0)]
    standing = solid[solid[:, 1, 2] > 0.03 * solid[:, 1, :2].max(axis=1)]
    return np.asarray(standing if len(standing) else solid)


def overview_cameras(snapshot: Mapping[str, Any]) -> list[dict[str, Any]]:
    """Four cameras ``{"name", "location_cm", "target_cm", "fov_deg"}`` around the scene's content.

    A scene without content is framed as a 20 m plate, so that its emptiness is seen.
    """
    boxes = _content_boxes(snapshot)
    if len(boxes):
        low = np.quantile(boxes[:, 0] - boxes[:, 1], 0.02, axis=0)
        high = np.quantile(boxes[:, 0] + boxes[:, 1], 0.98, axis=0)
    else:
        low, high = np.array([-1000.0, -1000.0, 0.0]), np.array([1000.0, 1000.0, 300.0])
    centre, half = (low + high) / 2, np.maximum((high - low) / 2, 100.0)
    radius = float(np.hypot(half[0], half[1]))
    distance = radius / math.tan(math.radians(HORIZONTAL_FOV_DEG) / 2) * 0.86
    target = [float(centre[0]), float(centre[1]), float(low[2] + 0.35 * (high[2] - low[2]))]
    cameras = []
    for index in range(OVERVIEW_VIEWS):
        azimuth = math.radians(45 + 360 / OVERVIEW_VIEWS * index)
        elevation = math.radians(24 if index % 2 == 0 else 42)
        eye = centre + distance * np.array(
            [math.cos(azimuth) * math.cos(elevation), math.sin(azimuth) * math.cos(elevation), 0.0]
        )
        eye[2] = low[2] + distance * math.sin(elevation)
        cameras.append(
            {
                "name": f"overview-{index + 1}",
                "location_cm": [float(eye[0]), float(eye[1]), _clear_height(eye, boxes)],
                "target_cm": target,
                "fov_deg": HORIZONTAL_FOV_DEG,
                **SIZE_PX,
            }
        )
    return cameras


def _clear_height(eye: Array, boxes: Array) -> float:
    """The eye's height, lifted in steps of the clearance until no box holds the eye, clearance included."""
    over = np.all(np.abs(boxes[:, 0, :2] - eye[:2]) < boxes[:, 1, :2] + CLEARANCE_CM, axis=1)
    centre, half = boxes[over, 0, 2], boxes[over, 1, 2] + CLEARANCE_CM
    order = np.argsort(centre - half)
    bottoms, tops = (centre - half)[order], np.maximum.accumulate((centre + half)[order])
    height = float(eye[2])
    while (below := int(np.searchsorted(bottoms, height))) and tops[below - 1] > height:
        height = _lifted(height, float(tops[below - 1]))
    return height


def _lifted(height: float, top: float) -> float:
    """The first of the sums height + 100 cm + 100 cm ... that is at least ``top``.

    Each sum is rounded as if it were made step by step; a sum that stays below the next power of two is exact.
    """
    while height < top:
        end = min(top, 2.0 ** math.frexp(height)[1]) if height >= 0 else min(top, 0.0)
        height += math.floor((end - height) / CLEARANCE_CM) * CLEARANCE_CM
        if height < top:
            height += CLEARANCE_CM
    return height
