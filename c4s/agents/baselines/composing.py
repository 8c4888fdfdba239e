"""A plausible scene from a prompt and its palette, without a model: what is named, as often as asked, by kind.

Large things stand in a loose grid with streets between them, walls and fences enclose, trees and props line the
streets, small things stand on tables, desks, counters and crates. Deterministic: the random numbers are seeded by the
prompt.
"""

from __future__ import annotations

import hashlib
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from c4s.agents.baselines.palette import PaletteItem, asked_counts, description, palette, singular

ENCLOSING = {"wall", "fence", "railing", "hedge", "parapet", "partition", "enclosure", "gate"}
GREEN = {"tree", "bush", "shrub", "palm", "hedge", "plant", "pine", "oak", "birch", "vegetation"}
SURFACES = {
    "table",
    "desk",
    "counter",
    "crate",
    "shelf",
    "cabinet",
    "dresser",
    "nightstand",
    "sideboard",
    "stall",
    "bench",
    "drawer",
    "stand",
}
UNSTANDABLE = {
    "sky",
    "decal",
    "water",
    "cloud",
    "fog",
    "particle",
    "light",
    "ceiling",
    "roof",
    "window",
    "door",
    "balcony",
    "awning",
    "cornice",
    "curtain",
    "picture",
    "painting",
    "mirror",
    "sign",
    "clock",
    "stain",
    "puddle",
    "wire",
    "cable",
    "gutter",
    "carpet",
    "rug",
    "beam",
    "pendant",
}
SEATS = {"chair", "stool", "armchair"}
MAX_ITEMS_M = 45.0
STREET_M = 3.0
MAX_COPIES = 260


@dataclass
class Wish:
    """How many of which item, and how strongly the text asks for it."""

    item: PaletteItem
    count: int
    named: int


@dataclass
class _Plan:
    nodes: list[dict[str, Any]] = field(default_factory=list)
    tables: list[tuple[str, PaletteItem, float, float]] = field(default_factory=list)

    def add(self, item: PaletteItem, x: float, y: float, yaw: float = 0.0, on: str | None = None) -> str:
        name = f"{item.id}_{len(self.nodes) + 1}"
        node: dict[str, Any] = {"id": name, "asset": item.path, "at": [round(x, 3), round(y, 3)], "yaw_deg": yaw}
        if on is not None:
            node["on"] = on
        self.nodes.append(node)
        return name


def wishes(prompt: str) -> list[Wish]:
    """The palette items that can stand on their own, with counts; the named ones first."""
    text = description(prompt)
    counts = asked_counts(text)
    found = []
    for item in palette(prompt):
        largest, smallest = max(item.width, item.depth, item.height), min(item.width, item.depth)
        if largest > MAX_ITEMS_M or smallest < 0.02 or item.height < 0.03:
            continue
        if item.height <= 0.06 * min(item.width, item.depth):
            continue
        words = item.words
        if words & UNSTANDABLE and not words & (GREEN | SURFACES | {"lamp", "lighthouse"}):
            continue
        named = sum(word in counts for word in words)
        asked = max((counts[word] for word in words if word in counts), default=0)
        found.append(Wish(item, asked or (3 if named else 1), named))
    _share(found, counts)
    return sorted(found, key=lambda wish: (-wish.named, wish.item.id))


def _share(found: Sequence[Wish], counts: dict[str, int]) -> None:
    """Divide a count among the items that answer to the same word, so that a dozen houses are a dozen in all."""
    for word, asked in counts.items():
        same = [wish for wish in found if singular(word) in wish.item.words and wish.count == asked and asked > 1]
        for index, wish in enumerate(same):
            wish.count = max(1, asked // len(same) + (index < asked % len(same)))


def compose(prompt: str, plate_m: float) -> dict[str, Any]:
    """A scene graph for the planner, in metres, within the plate."""
    random = np.random.default_rng(int.from_bytes(hashlib.sha256(prompt.encode()).digest()[:8], "big"))
    chosen = [wish for wish in wishes(prompt) if wish.named] or wishes(prompt)
    chosen = chosen[:70]
    plan = _Plan()
    fences = [
        wish
        for wish in chosen
        if wish.item.words & ENCLOSING
        and wish.item.height >= 0.5
        and max(wish.item.width, wish.item.depth) >= 0.8
        and min(wish.item.width, wish.item.depth) < 0.5 * max(wish.item.width, wish.item.depth)
    ]
    green = [wish for wish in chosen if wish.item.words & GREEN and wish not in fences]
    seats = [wish for wish in chosen if wish.item.words & SEATS]
    small = [
        wish
        for wish in chosen
        if max(wish.item.width, wish.item.depth, wish.item.height) < 0.62 and wish not in green + seats + fences
    ]
    rest = [wish for wish in chosen if wish not in fences + green + seats + small]
    largest = max((wish.item.area for wish in rest), default=1.0)
    anchors = [wish for wish in rest if wish.item.area >= 0.18 * largest or wish.item.words & SURFACES]
    props = [wish for wish in rest if wish not in anchors]
    reach = _anchors(plan, anchors, seats, plate_m, random)
    _line_streets(plan, props + [wish for wish in green if wish.item.area < 9], reach, random)
    _scatter(plan, [wish for wish in green if wish.item.area >= 9], reach, plate_m, random)
    _tops(plan, small)
    _enclose(plan, fences, reach, plate_m)
    return {"nodes": plan.nodes[: MAX_COPIES + 120]}


def _copies(found: Sequence[Wish]) -> Iterator[PaletteItem]:
    """Items one at a time, taking turns, so that neighbours differ."""
    left = [[wish.item, wish.count] for wish in found]
    total = 0
    while left and total < MAX_COPIES:
        for pair in list(left):
            yield pair[0]  # type: ignore[misc]
            total += 1
            pair[1] -= 1  # type: ignore[operator]
            if not pair[1]:
                left.remove(pair)


def _anchors(
    plan: _Plan, anchors: Sequence[Wish], seats: Sequence[Wish], plate_m: float, random: np.random.Generator
) -> float:
    """Large things in rows with streets between; seats in front of tables and desks. Returns the half extent used."""
    items = sorted(_copies(anchors), key=lambda item: -item.area)
    if not items:
        return min(12.0, plate_m / 3)
    street = STREET_M if items[0].area > 8 else 1.4
    side = math.sqrt(sum((max(item.width, item.depth) + street) ** 2 for item in items)) * 1.05
    half = min(side / 2, 0.42 * plate_m)
    chairs = [wish.item for wish in seats]
    x = y = -half
    line = 0.0
    for index, item in enumerate(items):
        size = max(item.width, item.depth)
        if x + size > half:
            x, y, line = -half, y + line + street, 0.0
        if y + size > max(half, 0.44 * plate_m):
            break
        yaw = float(random.integers(0, 4)) * 90.0 if item.area > 8 else 0.0
        centre = (x + size / 2, y + size / 2)
        name = plan.add(item, *centre, yaw)
        if item.words & SURFACES:
            plan.tables.append((name, item, *centre))
            if chairs and item.height < 1.2:
                chair = chairs[index % len(chairs)]
                plan.add(chair, centre[0], centre[1] + item.depth / 2 + chair.depth / 2 + 0.1, 270.0)
        x, line = x + size + street, max(line, size)
    return half


def _line_streets(plan: _Plan, found: Sequence[Wish], reach: float, random: np.random.Generator) -> None:
    """Props and low plants along concentric lines around and between the large things."""
    items = list(_copies(found))
    pitch = max(1.6, 8 * reach / max(len(items), 1))
    radius, travelled = reach + 1.2, 0.0
    for item in items:
        if travelled > 8 * radius:
            radius, travelled = radius + 3.0, 0.0
        edge, along = divmod(travelled, 2 * radius)
        u = along - radius
        x, y = ((u, -radius), (radius, u), (-u, radius), (-radius, -u))[int(edge) % 4]
        plan.add(item, x, y, float(random.integers(0, 4)) * 90.0)
        travelled += max(pitch, max(item.width, item.depth) + 0.4)


def _scatter(plan: _Plan, found: Sequence[Wish], reach: float, plate_m: float, random: np.random.Generator) -> None:
    """Large trees in a loose ring outside the large things."""
    for item in _copies(found):
        angle = 2 * math.pi * random.random()
        radius = min(reach * (1.25 + 0.5 * random.random()) + item.width, 0.46 * plate_m)
        plan.add(item, radius * math.cos(angle), radius * math.sin(angle), float(random.integers(0, 360)))


def _tops(plan: _Plan, found: Sequence[Wish]) -> None:
    """Small things in rows on the tops of tables, desks and crates."""
    if not plan.tables:
        return
    room = {name: -0.45 * item.width for name, item, _, _ in plan.tables}
    turn = 0
    for item in _copies(found):
        for _ in range(len(plan.tables)):
            name, table, x, y = plan.tables[turn % len(plan.tables)]
            turn += 1
            if item.depth < table.depth and room[name] + item.width < 0.5 * table.width:
                plan.add(item, x + room[name] + item.width / 2, y, 0.0, on=name)
                room[name] += item.width + 0.06
                break


def _enclose(plan: _Plan, found: Sequence[Wish], reach: float, plate_m: float) -> None:
    """One kind of wall or fence around everything, sides parallel to the plate's."""
    if not found:
        return
    item = max(found, key=lambda wish: (wish.named, max(wish.item.width, wish.item.depth))).item
    length, along_x = max(item.width, item.depth), item.width >= item.depth
    half = min(reach + 8.0, 0.47 * plate_m)
    each = max(1, min(30, int(2 * half // length)))
    half = each * length / 2 + min(item.width, item.depth)
    for index in range(each):
        u = (index - (each - 1) / 2) * length
        for x, y, turned in ((u, -half, False), (u, half, False), (-half, u, True), (half, u, True)):
            plan.add(item, x, y, 90.0 if turned == along_x else 0.0)
