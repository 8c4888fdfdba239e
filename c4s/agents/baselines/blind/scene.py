"""A scene as agent code can read it: every actor with all that an editor tells of it, and no picture."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Vector = tuple[float, float, float]
_NUMBERED = re.compile(r"(.*?)_?(\d+)")


@dataclass(frozen=True)
class SeenActor:
    """One actor that shows a single static mesh. Places in cm, [pitch, yaw, roll] degrees; the box is the world's."""

    name: str
    label: str
    guid: str
    stable_id: str
    class_path: str
    mesh: str
    component: tuple[str, ...]
    """Name and flags of the component, and the flags of the actor, as text."""
    materials: tuple[tuple[int, str], ...]
    tags: frozenset[str]
    """All but those that carry an id."""
    folder: str
    location: Vector
    rotation: Vector
    scale: Vector
    low: Vector
    high: Vector
    order: int
    """Place in the level's list."""

    @property
    def stem(self) -> str:
        """The name without its number."""
        numbered = _NUMBERED.fullmatch(self.name)
        return numbered[1] if numbered and numbered[1] else self.name

    @property
    def number(self) -> int | None:
        """The number at the end of the name."""
        numbered = _NUMBERED.fullmatch(self.name)
        return int(numbered[2]) if numbered and numbered[1] else None

    @property
    def category(self) -> str:
        """The folder that the mesh lies in."""
        return self.mesh.rpartition("/")[0]

    @property
    def side_cm(self) -> float:
        """Longest side of the box."""
        return max(high - low for low, high in zip(self.low, self.high, strict=True))


@dataclass(frozen=True)
class SeenLevel:
    """The things of a level in its order, and what its package is called."""

    package: str
    things: tuple[SeenActor, ...]

    @cached_property
    def of_mesh(self) -> dict[str, list[SeenActor]]:
        """Things by mesh."""
        return grouped((thing.mesh, thing) for thing in self.things)

    @cached_property
    def of_stem(self) -> dict[str, list[SeenActor]]:
        """Things by what they are called after."""
        return grouped((thing.stem, thing) for thing in self.things)

    @cached_property
    def low(self) -> Array:
        """Lowest corners, a row a thing."""
        return np.array([thing.low for thing in self.things]).reshape(-1, 3)

    @cached_property
    def high(self) -> Array:
        """Highest corners, a row a thing."""
        return np.array([thing.high for thing in self.things]).reshape(-1, 3)

    def nearest(self, row: int, count: int) -> list[SeenActor]:
        """The things whose middles are nearest to that of the thing in a row, the nearest first."""
        middles = (self.low + self.high) / 2
        far = np.linalg.norm(middles - middles[row], axis=1)
        far[row] = np.inf
        return [self.things[i] for i in np.argsort(far, kind="stable")[: min(count, len(far) - 1)]]

    def shared(self, row: int) -> Array:
        """Volume of the box in a row that each box shares, as a part of the smaller of both; 0 for itself."""
        sides = np.clip(np.minimum(self.high, self.high[row]) - np.maximum(self.low, self.low[row]), 0, None)
        volumes = np.prod(self.high - self.low, axis=1)
        least = np.minimum(volumes, volumes[row])
        parts = np.where(least > 0, np.prod(sides, axis=1) / np.where(least > 0, least, 1), 0.0)
        parts[row] = 0.0
        return np.asarray(parts)


def grouped(pairs: Iterable[tuple[str, SeenActor]]) -> dict[str, list[SeenActor]]:
    """Things by a key, in their order."""
    found: dict[str, list[SeenActor]] = defaultdict(list)
    for key, thing in pairs:
        found[key].append(thing)
    return dict(found)
