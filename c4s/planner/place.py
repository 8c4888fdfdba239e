"""From checked nodes to entries: where each copy goes before overlaps are removed. Deterministic."""

from __future__ import annotations

import hashlib
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from c4s.geometry.transform import affine, transformed_box
from c4s.planner.graph import Node


@dataclass
class PlacedEntry:
    """One copy of a node in the world (cm, degrees). ``bottom`` and ``top`` bound it; the pivot is at ``location``."""

    name: str
    node: Node
    x: float
    y: float
    bottom: float
    yaw_deg: float
    half_x: float
    half_y: float
    height: float
    offset: tuple[float, float, float]
    """From the middle of the bottom of the world box to the pivot."""
    on: str | None = None
    fixed: bool = False

    @property
    def top(self) -> float:
        """Height of the world box's top in cm."""
        return self.bottom + self.height

    @property
    def location_cm(self) -> tuple[float, float, float]:
        """Where the pivot goes."""
        return self.x + self.offset[0], self.y + self.offset[1], self.bottom + self.offset[2]


def make_entry(node: Node, name: str, x: float, y: float, bottom: float, yaw_deg: float) -> PlacedEntry:
    """An entry whose world box stands with the middle of its bottom at (x, y, bottom)."""
    origin, half = transformed_box(
        affine((0, 0, 0), (0, yaw_deg, 0), node.scale), node.asset.bounds_min_cm, node.asset.bounds_max_cm
    )
    return PlacedEntry(
        name=name,
        node=node,
        x=x,
        y=y,
        bottom=bottom,
        yaw_deg=yaw_deg,
        half_x=float(half[0]),
        half_y=float(half[1]),
        height=2 * float(half[2]),
        offset=(-float(origin[0]), -float(origin[1]), float(half[2] - origin[2])),
    )


def place(nodes: Sequence[Node], half_extent_cm: float) -> list[PlacedEntry]:
    """Entries of all nodes in order. Nodes may stand on, or relate to, earlier ones."""
    first: dict[str, PlacedEntry] = {}
    entries: list[PlacedEntry] = []
    for node in nodes:
        base = make_entry(node, node.id, 0.0, 0.0, 0.0, node.yaw_deg)
        x, y, bottom = _anchor(node, base, first)
        for index, (dx, dy, yaw) in enumerate(_offsets(node, base, half_extent_cm)):
            entry = make_entry(
                node, node.id if node.count == 1 else f"{node.id}_{index + 1}", x + dx, y + dy, bottom, yaw
            )
            entry.on = node.on
            entry.fixed = node.at_m is not None and node.count == 1
            entries.append(entry)
            first.setdefault(node.id, entry)
    return entries


def _anchor(node: Node, base: PlacedEntry, first: dict[str, PlacedEntry]) -> tuple[float, float, float]:
    """Middle of the bottom of the node's first copy, in cm."""
    bottom = 0.0
    x = y = 0.0
    if node.on is not None:
        support = first[node.on]
        x, y, bottom = support.x, support.y, support.top
    if node.relation is not None:
        kind, of, distance = node.relation
        other = first[of]
        gap_x, gap_y = other.half_x + base.half_x + 100 * distance, other.half_y + base.half_y + 100 * distance
        step = {
            "next_to": (0.0, gap_y),
            "right_of": (0.0, gap_y),
            "left_of": (0.0, -gap_y),
            "in_front_of": (gap_x, 0.0),
            "behind": (-gap_x, 0.0),
            "around": (0.0, 0.0),
        }[kind]
        x, y = other.x + step[0], other.y + step[1]
        bottom = other.bottom
    if node.at_m is not None:
        x, y = 100 * node.at_m[0], 100 * node.at_m[1]
        if node.at_m[2] is not None:
            bottom = 100 * node.at_m[2]
    return x, y, bottom


def _offsets(node: Node, base: PlacedEntry, half_extent_cm: float) -> Iterator[tuple[float, float, float]]:
    """Offset (cm) and yaw of each copy from the anchor."""
    layout, count = node.layout, node.count
    if count == 1:
        yield 0.0, 0.0, node.yaw_deg
        return
    turn = math.radians(layout.yaw_deg)
    along, across = (math.cos(turn), math.sin(turn)), (-math.sin(turn), math.cos(turn))
    step = 100 * layout.spacing_m or 2 * max(base.half_x, base.half_y) * 1.15
    if layout.kind == "row":
        for index in range(count):
            d = (index - (count - 1) / 2) * step
            yield d * along[0], d * along[1], node.yaw_deg
    elif layout.kind == "grid":
        columns = math.ceil(math.sqrt(count))
        lines = math.ceil(count / columns)
        for index in range(count):
            u = (index % columns - (columns - 1) / 2) * step
            v = (index // columns - (lines - 1) / 2) * step
            yield u * along[0] + v * across[0], u * along[1] + v * across[1], node.yaw_deg
    elif layout.kind == "ring":
        radius = 100 * layout.radius_m or max(step * count / (2 * math.pi), step)
        for index in range(count):
            angle = turn + 2 * math.pi * index / count
            yaw = math.degrees(angle) + 180 if layout.facing == "centre" else node.yaw_deg
            yield radius * math.cos(angle), radius * math.sin(angle), yaw
    else:
        radius = 100 * layout.radius_m or min(half_extent_cm * 0.8, step * math.sqrt(count))
        random = np.random.default_rng(int.from_bytes(hashlib.sha256(node.id.encode()).digest()[:8], "big"))
        for _ in range(count):
            distance, angle = radius * math.sqrt(random.random()), 2 * math.pi * random.random()
            yield (
                distance * math.cos(angle),
                distance * math.sin(angle),
                node.yaw_deg + float(random.integers(0, 4)) * 90.0,
            )
