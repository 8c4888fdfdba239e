"""Where the cheats put what: pure functions of a catalog and a prompt. Centimetres; the ground's top is at height 0."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import cycle, islice
from typing import Any, Final

from c4s.agents.baselines.palette import asked_counts, description, singular

MOST: Final = 400
"""Things of one scene."""
SMALL_CM, TINY_CM = 14.0, 4.5
TILE_CM = 900.0
UP_CM, LIFTED_CM, BURIED_CM = 500.0, 1000.0, -30_000.0
SHOWN: Final = 6
"""Of 101 hidden and shown things of ``hidden``."""
GAP_CM = 30.0


@dataclass(frozen=True)
class CatalogItem:
    """What the catalog says of an asset, in centimetres at scale 1."""

    name: str
    path: str
    blueprint: bool
    low: tuple[float, float, float]
    high: tuple[float, float, float]

    @classmethod
    def of(cls, told: Mapping[str, Any]) -> CatalogItem:
        """From a row of ``get_asset_metadata``."""
        low, high = (tuple(map(float, told[side])) for side in ("bounds_min_cm", "bounds_max_cm"))
        return cls(
            str(told["name"]),
            str(told["spawn_path"]),
            told["spawn_with"] == "spawn_blueprint_actor",
            (low[0], low[1], low[2]),
            (high[0], high[1], high[2]),
        )

    @property
    def size(self) -> tuple[float, float, float]:
        """Length of its sides."""
        return (self.high[0] - self.low[0], self.high[1] - self.low[1], self.high[2] - self.low[2])


@dataclass(frozen=True)
class Placing:
    """One actor: its pivot, its uniform scale, and how it is set."""

    item: CatalogItem
    location: tuple[float, float, float]
    scale: float = 1.0
    label: str = ""
    hidden: bool = False
    collision: bool = True


Layout = Callable[[Sequence[CatalogItem], str, float], list[Placing]]
"""Of the assets, the prompt, and half the length of the plate's sides."""


def _asked(items: Sequence[CatalogItem], prompt: str, otherwise: int) -> Iterator[CatalogItem]:
    """Each asset as often as a number word of the prompt's prose stands before one of its words."""
    counts = asked_counts(description(prompt))
    for item in items:
        words = {singular(word) for word in item.name.lower().split()}
        asked = max((counts.get(word, 0) for word in words), default=0)
        yield from [item] * (asked or otherwise)


def _on_ground(item: CatalogItem, x: float, y: float, scale: float = 1.0) -> Placing:
    return Placing(item, (x, y, -item.low[2] * scale), scale)


def _rows(items: Sequence[CatalogItem], reach: float, scale_of: Callable[[CatalogItem], float]) -> list[Placing]:
    """Side by side in rows, none touching the next; what no longer fits the plate is left out."""
    placed: list[Placing] = []
    x, y, depth = -reach, -reach, 0.0
    for item in items:
        scale = scale_of(item)
        width, deep, _ = (side * scale for side in item.size)
        if x + width > reach:
            x, y, depth = -reach, y + depth + GAP_CM, 0.0
        if y + deep > reach or x + width > reach:
            continue
        placed.append(_on_ground(item, x - item.low[0] * scale, y - item.low[1] * scale, scale))
        x, depth = x + width + GAP_CM, max(depth, deep)
    return placed


def _true(item: CatalogItem) -> float:
    return 1.0


def _shrunk(largest_cm: float) -> Callable[[CatalogItem], float]:
    return lambda item: largest_cm / max(item.size)


def once(items: Sequence[CatalogItem], prompt: str, reach: float) -> list[Placing]:
    """Each asset of the catalog once, in rows; the prompt is not read."""
    return _rows(items, reach, _true)


def parade(items: Sequence[CatalogItem], prompt: str, reach: float) -> list[Placing]:
    """Three of every asset that fits, in a grid."""
    return _rows([item for item in items for _ in range(3) if max(item.size[:2]) < reach], reach, _true)


def dust(items: Sequence[CatalogItem], prompt: str, reach: float) -> list[Placing]:
    """Everything shrunk to 14 cm and spread over one tile, as often as the prompt's number words say."""
    wanted = list(islice(_asked(items, prompt, 3), MOST))
    side = math.ceil(math.sqrt(len(wanted)))
    step = TILE_CM / max(side, 1)
    return [
        _on_ground(item, (n % side - side / 2) * step, (n // side - side / 2) * step, _shrunk(SMALL_CM)(item))
        for n, item in enumerate(wanted)
    ]


def pile(items: Sequence[CatalogItem], prompt: str, reach: float) -> list[Placing]:
    """Everything at one point, at 4.5 cm."""
    return [_on_ground(item, 0.0, 0.0, _shrunk(TINY_CM)(item)) for item in islice(_asked(items, prompt, 3), MOST)]


def heap(items: Sequence[CatalogItem], prompt: str, reach: float) -> list[Placing]:
    """Everything in its true size within one other, on a few square metres."""
    wanted = list(islice(_asked(items, prompt, 2), MOST))
    return [_on_ground(item, 50.0 * math.cos(n), 50.0 * math.sin(n)) for n, item in enumerate(wanted)]


def ghost(items: Sequence[CatalogItem], prompt: str, reach: float) -> list[Placing]:
    """Overlapping things 5 m up with their collision off, and one honest actor."""
    up = [
        replace(_on_ground(item, 150.0 * math.cos(n), 150.0 * math.sin(n)), collision=False)
        for n, item in enumerate(islice(_asked(items, prompt, 3), MOST))
    ]
    raised = [replace(one, location=(*one.location[:2], one.location[2] + UP_CM)) for one in up]
    return [_on_ground(items[0], 0.0, 0.0), *raised]


def copies(items: Sequence[CatalogItem], prompt: str, reach: float) -> list[Placing]:
    """One asset under the names of all the others."""
    one = min(items, key=lambda item: max(item.size))
    rows = _rows(list(islice(cycle([one]), min(MOST, 3 * len(items)))), reach, _true)
    return [replace(placed, label=items[n % len(items)].name) for n, placed in enumerate(rows)]


def instances(items: Sequence[CatalogItem], prompt: str, reach: float) -> list[Placing]:
    """Three of each at one and the same place, in rows."""
    return [placed for placed in _rows(items, reach, _true) for _ in range(3)][:MOST]


def hidden(items: Sequence[CatalogItem], prompt: str, reach: float) -> list[Placing]:
    """Most of them hidden."""
    placed = _rows([item for item in items for _ in range(3)], reach, _true)[:MOST]
    return [replace(one, hidden=n % 101 >= SHOWN) for n, one in enumerate(placed)]


def buried(items: Sequence[CatalogItem], prompt: str, reach: float) -> list[Placing]:
    """The parade, 300 m below the ground."""
    return [
        replace(one, location=(*one.location[:2], one.location[2] + BURIED_CM)) for one in parade(items, prompt, reach)
    ]


def lifted(items: Sequence[CatalogItem], prompt: str, reach: float) -> list[Placing]:
    """The parade, 10 m over the ground, above one plate."""
    return [
        replace(one, location=(*one.location[:2], one.location[2] + LIFTED_CM)) for one in parade(items, prompt, reach)
    ]


LAYOUTS: Final[Mapping[str, Layout]] = {
    layout.__name__: layout
    for layout in (once, dust, pile, ghost, copies, instances, hidden, parade, heap, buried, lifted)
}
