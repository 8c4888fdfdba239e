"""Validate and solve a scene graph: a world transform for every copy, and what was dropped, moved or overlaps."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from typing import Any

from c4s.planner.graph import read_graph
from c4s.planner.place import PlacedEntry, place
from c4s.planner.separate import separate
from c4s.planner.tiers import NAMES, is_ground, tier_of
from c4s.records.pack import Asset

MODES = ("separate", "exact")
HALF_EXTENT_M = 100.0


def validate(graph: Any, catalog: Sequence[Asset], half_extent_m: float = HALF_EXTENT_M) -> dict[str, Any]:
    """Report on a graph: whether it can be solved whole, and each problem with the node or copy that it drops.

    ``dropped`` names all that solving would drop: nodes that cannot be used, and copies whose middle lies outside the
    square of ``half_extent_m``.
    """
    nodes, problems = read_graph(graph, catalog)
    entries = place(nodes, 100 * half_extent_m)
    told = [{"node": problem.node, "problem": problem.text, "dropped": problem.drops} for problem in problems]
    told += [
        {"node": entry.name, "problem": f"outside the build area ({half_extent_m:g} m to each side)", "dropped": True}
        for entry in entries
        if _outside(entry, 100 * half_extent_m)
    ]
    drops = dict.fromkeys(row["node"] for row in told if row["dropped"])
    return {
        "valid": bool(nodes) and not drops,
        "nodes": len(nodes),
        "copies": len(entries),
        "dropped": list(drops),
        "problems": told,
    }


def _outside(entry: PlacedEntry, half_cm: float) -> bool:
    return abs(entry.x) > half_cm or abs(entry.y) > half_cm


def solve(
    graph: Any, catalog: Sequence[Asset], mode: str = "separate", half_extent_m: float = HALF_EXTENT_M
) -> dict[str, Any]:
    """World transforms (cm, [pitch, yaw, roll] degrees) of every copy; equal input gives equal output.

    ``mode`` is ``separate`` (push overlapping footprints apart) or ``exact`` (keep the positions). Copies whose middle
    lies outside the square of ``half_extent_m`` are dropped first. Raises ``ValueError`` for an unknown mode.
    """
    if mode not in MODES:
        raise ValueError(f"mode must be one of {', '.join(MODES)}")
    nodes, problems = read_graph(graph, catalog)
    half_cm = 100.0 * half_extent_m
    placed = place(nodes, half_cm)
    kept = [entry for entry in placed if not _outside(entry, half_cm)]
    outside = [
        {"node": entry.name, "problem": f"outside the build area ({half_extent_m:g} m to each side)"}
        for entry in placed
        if _outside(entry, half_cm)
    ]
    moved, overlaps = separate(kept, half_cm) if mode == "separate" else ([], 0)
    plain = [_plain(entry) for entry in kept]
    return {
        "entries": plain,
        "tier_counts": dict(Counter(entry["tier_name"] for entry in plain)),
        "moved": moved,
        "overlapping_pairs": overlaps,
        "dropped": [{"node": problem.node, "problem": problem.text} for problem in problems if problem.drops] + outside,
        "half_extent_m": half_extent_m,
    }


def _plain(entry: PlacedEntry) -> dict[str, Any]:
    x, y, z = entry.location_cm
    if is_ground(entry):
        z -= entry.height
    tier = tier_of(entry)
    return {
        "name": entry.name,
        "node": entry.node.id,
        "asset": entry.node.asset.spawn_path,
        "kind": entry.node.asset.kind,
        "location": [round(x, 3), round(y, 3), round(z, 3)],
        "rotation": [0.0, round(entry.yaw_deg, 4), 0.0],
        "scale": list(entry.node.scale),
        "tier": tier,
        "tier_name": NAMES[tier],
        "footprint_cm": [
            round(entry.x - entry.half_x, 2),
            round(entry.y - entry.half_y, 2),
            round(entry.x + entry.half_x, 2),
            round(entry.y + entry.half_y, 2),
        ],
        "height_cm": round(entry.height, 2),
    }


def tiers(solved: dict[str, Any]) -> dict[str, Any]:
    """Which tier each entry of a solved plan belongs to, and how many entries each tier has."""
    entries = solved.get("entries", [])
    return {
        "tiers": {NAMES[tier]: [entry["name"] for entry in entries if entry["tier"] == tier] for tier in sorted(NAMES)},
        "order": [NAMES[tier] for tier in sorted(NAMES)],
    }
