"""Prompts with palettes, and the things that the planner composes of them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from c4s.agents.baselines.composing import compose
from c4s.agents.baselines.palette import PaletteItem, palette
from c4s.planner import solve
from c4s.records.pack import Asset
from c4s.semantics.inventory import Thing
from c4s.semantics.kinds import ThingKind

PLATE_M = 120.0
SIZES = {
    "Oak Table": (1.6, 0.9, 0.75),
    "Dining Chair": (0.45, 0.45, 0.9),
    "Teal Stool": (0.4, 0.4, 0.5),
    "Fruit Bowl": (0.3, 0.3, 0.15),
    "Blue Rug": (2.4, 1.7, 0.01),
    "Barn": (12.0, 16.0, 9.0),
    "Stone Well": (2.2, 2.0, 3.0),
    "Tractor Red": (3.0, 2.3, 2.2),
    "Tractor Green": (3.0, 2.3, 2.2),
    "Cow": (2.7, 0.8, 1.6),
    "Apple Tree": (3.2, 2.8, 4.0),
    "Street Lamp": (0.8, 0.5, 4.2),
    "Bench": (1.8, 0.5, 0.9),
    "Wood Fence": (3.0, 0.15, 1.2),
    "Road Tile": (8.0, 8.0, 0.04),
    "Pond Tile": (10.0, 10.0, 0.12),
    "Crate": (0.8, 0.8, 0.8),
}


def id_of(name: str) -> str:
    """The palette id of an asset's name."""
    return name.lower().replace(" ", "_")


def prompt_of(text: str, sizes: Mapping[str, tuple[float, float, float]] = SIZES) -> str:
    """A prompt of this prose with all these assets."""
    rows = [
        f"- {id_of(name)} | {name} | things | {w}x{d}x{h} m | /Game/T/{name.replace(' ', '')}.X"
        for name, (w, d, h) in sizes.items()
    ]
    return "\n".join([text, "", "=== ASSET PALETTE ===", *rows, "", "=== THE TASK ===", "Build it."])


def composed(prompt: str, plate_m: float = PLATE_M) -> dict[str, list[Thing]]:
    """Things of the solved plan by palette id, each in its world box. Nothing was dropped or pushed."""
    items = palette(prompt)
    graph = compose(prompt, plate_m)
    solved = solve(graph, [_asset(item) for item in items], half_extent_m=plate_m / 2)
    assert solved["dropped"] == [] and solved["overlapping_pairs"] == 0
    by_path = {item.path: item.id for item in items}
    found: dict[str, list[Thing]] = {}
    for entry in solved["entries"]:
        found.setdefault(by_path[entry["asset"]], []).append(_thing(entry))
    return found


def intruders(things: dict[str, list[Thing]], deeper_than_cm: float = 2.0) -> list[tuple[str, str]]:
    """Pairs of things that are in each other."""
    rows = [(name, thing) for name, own in things.items() for thing in own]
    low, high = (np.array([getattr(thing, side) for _, thing in rows]).reshape(-1, 3) for side in ("low", "high"))
    shared = np.minimum(high[:, None], high[None]) - np.maximum(low[:, None], low[None])
    pairs = np.argwhere(np.triu((shared > deeper_than_cm).all(axis=2), 1))
    return [(rows[a][0], rows[b][0]) for a, b in pairs.tolist()]


def _asset(item: PaletteItem) -> Asset:
    x, y, z = 50 * item.width, 50 * item.depth, 100 * item.height
    return Asset(
        id=item.id,
        name=item.name,
        path=item.path,
        category=item.category,
        bounds_min_cm=(-x, -y, 0.0),
        bounds_max_cm=(x, y, z),
    )


def _thing(entry: dict[str, Any]) -> Thing:
    x0, y0, x1, y1 = entry["footprint_cm"]
    bottom = entry["location"][2]
    return Thing(
        entry["name"],
        ThingKind(entry["asset"], None, True),
        np.array([x0, y0, bottom]),
        np.array([x1, y1, bottom + entry["height_cm"]]),
        np.array(entry["scale"]),
        (),
    )
