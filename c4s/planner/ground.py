"""The ground pass: tiles of one flat asset over the whole plate, their tops level with the world's ground plane."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from typing import Any

from c4s.records.pack import Asset

WORDS = (
    "ground",
    "floor",
    "road",
    "tile",
    "plaza",
    "paving",
    "cobble",
    "grass",
    "field",
    "street",
    "pavement",
    "dock",
    "carpet",
    "plane",
    "parquet",
    "terrain",
)
MIN_SIDE_CM, MAX_HEIGHT_CM = 150.0, 60.0
MAX_TILES = 700
PREFERRED_M = 8.0


def _flat(asset: Asset) -> bool:
    width, depth, height = (100 * side for side in asset.size_m)
    return min(width, depth) >= MIN_SIDE_CM and height <= min(MAX_HEIGHT_CM, 0.1 * min(width, depth))


def choose_tile(scene_text: str, catalog: Sequence[Asset]) -> Asset | None:
    """The flat asset that fits the text best: a ground word in its name, then a handy size, then the
    words that it shares with the text."""
    text = set(re.findall(r"[a-z]+", scene_text.lower()))

    def fit(asset: Asset) -> tuple[bool, int, int, str]:
        words = set(re.findall(r"[a-z]+", f"{asset.name} {asset.category} {' '.join(asset.tags)}".lower()))
        width, depth, _ = asset.size_m
        named = any(ground in word for word in words for ground in WORDS)
        return named, -round(abs(math.log2(min(width, depth) / PREFERRED_M))), len(words & text), asset.id

    flat = [asset for asset in catalog if asset.kind == "static_mesh" and _flat(asset)]
    return max(flat, key=fit) if flat else None


def ground_tiles(scene_text: str, catalog: Sequence[Asset], half_extent_m: float = 100.0) -> list[dict[str, Any]]:
    """Entries that carpet the square of ``half_extent_m`` edge to edge; empty where the catalog has no flat asset.

    A tile that would be needed more than ``MAX_TILES`` times is enlarged in plan until that many cover the square.
    """
    tile = choose_tile(scene_text, catalog)
    if tile is None:
        return []
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
