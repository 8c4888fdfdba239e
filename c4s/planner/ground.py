"""The ground pass: tiles of one flat asset over the whole plate, their tops level with the world's ground plane."""

from __future__ import annotations

import math
from typing import Any

from c4s.records.pack import Asset

MAX_TILES = 700


def ground_tiles(tile: Asset, half_extent_m: float) -> list[dict[str, Any]]:
    """Entries that carpet the square of ``half_extent_m`` edge to edge with one asset.

    A tile that would be needed more than ``MAX_TILES`` times is enlarged in plan until that many cover the square.
    """
    low, high = tile.bounds_min_cm, tile.bounds_max_cm
    width, depth = high[0] - low[0], high[1] - low[1]
    side_cm, factor = 200 * half_extent_m, 1.0
    while math.ceil(side_cm / (width * factor)) * math.ceil(side_cm / (depth * factor)) > MAX_TILES:
        factor *= 1.05
    width, depth, factor = width * factor, depth * factor, round(factor, 6)
    columns, lines = (max(1, math.ceil(side_cm / side - 1e-9)) for side in (width, depth))
    centre = (factor * (low[0] + high[0]) / 2, factor * (low[1] + high[1]) / 2)
    return [
        {
            "name": f"GroundTile_{i}_{j}",
            "asset": tile.path,
            "kind": tile.kind,
            "rotation": [0.0, 0.0, 0.0],
            "scale": [factor, factor, 1.0],
            "tier": 0,
            "location": [
                round((i - (columns - 1) / 2) * width - centre[0], 3),
                round((j - (lines - 1) / 2) * depth - centre[1], 3),
                round(-high[2], 3),
            ],
        }
        for i in range(columns)
        for j in range(lines)
    ]
