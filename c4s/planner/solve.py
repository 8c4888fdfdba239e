"""Validate and solve a scene graph: a world transform for every copy, and what was dropped, moved or overlaps."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from c4s.packs.manifest import Asset
from c4s.planner.graph import read_graph
from c4s.planner.place import Entry, place
from c4s.planner.separate import separate
from c4s.planner.tiers import NAMES, is_ground, tier_of

MODES = ("separate", "exact")
HALF_EXTENT_M = 100.0


def validate(graph: Any, catalog: Sequence[Asset]) -> dict[str, Any]:
    """Report on a graph: whether it can be solved whole, and each problem with the node that it drops."""
    nodes, problems = read_graph(graph, catalog)
    return {"valid": bool(nodes) and not any(problem.drops for problem in problems), "nodes": len(nodes),
            "copies": sum(node.count for node in nodes),
            "problems": [{"node": problem.node, "problem": problem.text, "dropped": problem.drops}
                         for problem in problems]}


def solve(graph: Any, catalog: Sequence[Asset], mode: str = "separate",
          half_extent_m: float = HALF_EXTENT_M) -> dict[str, Any]:
    """World transforms (cm, [pitch, yaw, roll] degrees) of every copy; equal input gives equal output.

    ``mode`` is ``separate`` (push overlapping footprints apart) or ``exact`` (keep the positions). Copies that
    leave the square of ``half_extent_m`` are dropped. Raises ``ValueError`` for an unknown mode.
    """
    if mode not in MODES:
        raise ValueError(f"mode must be one of {', '.join(MODES)}")
    nodes, problems = read_graph(graph, catalog)
    half_cm = 100.0 * half_extent_m
    entries = place(nodes, half_cm)
    moved, overlaps = separate(entries, half_cm) if mode == "separate" else ([], 0)
    kept = [entry for entry in entries if abs(entry.x) <= half_cm and abs(entry.y) <= half_cm]
    outside = [{"node": entry.name, "problem": "outside the build area"} for entry in entries if entry not in kept]
    return {"entries": [_plain(entry) for entry in kept], "moved": moved, "overlapping_pairs": overlaps,
            "dropped": [{"node": problem.node, "problem": problem.text} for problem in problems if problem.drops]
            + outside, "half_extent_m": half_extent_m}


def _plain(entry: Entry) -> dict[str, Any]:
    x, y, z = entry.location_cm
    if is_ground(entry):
        z -= entry.height
    tier = tier_of(entry)
    return {"name": entry.name, "node": entry.node.id, "asset": entry.node.asset.path, "kind": entry.node.asset.kind,
            "location": [round(x, 3), round(y, 3), round(z, 3)], "rotation": [0.0, round(entry.yaw_deg, 4), 0.0],
            "scale": list(entry.node.scale), "tier": tier, "tier_name": NAMES[tier],
            "footprint_cm": [round(entry.x - entry.half_x, 2), round(entry.y - entry.half_y, 2),
                             round(entry.x + entry.half_x, 2), round(entry.y + entry.half_y, 2)],
            "height_cm": round(entry.height, 2)}


def tiers(solved: dict[str, Any]) -> dict[str, Any]:
    """Which tier each entry of a solved plan belongs to, and how many entries each tier has."""
    entries = solved.get("entries", [])
    return {"tiers": {NAMES[tier]: [entry["name"] for entry in entries if entry["tier"] == tier]
                      for tier in sorted(NAMES)}, "order": [NAMES[tier] for tier in sorted(NAMES)]}
