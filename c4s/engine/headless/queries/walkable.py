"""The navigation mesh of the open level: a walkable space of its collision bodies.

The kernels are loaded at the first build. One mesh is kept, that of the open level.
"""

from __future__ import annotations

import random
from typing import TYPE_CHECKING, Any

import numpy as np

from c4s.engine.headless import editor
from c4s.engine.headless.queries.index import current
from c4s.engine.headless.queries.solids import Array

if TYPE_CHECKING:
    from c4s.navigation import NavigationSettings, SpaceMesh

_MOST_TRIES = 64
_STEP_CM = 12.5


class LevelMesh:
    """The mesh of one level."""

    def __init__(self, level: Any, mesh: SpaceMesh) -> None:
        self.level = level
        self._mesh = mesh

    def project(self, point: Array, extent: Array) -> Array | None:
        """The nearest point of the mesh in a box around a point (half extents, cm)."""
        return self._mesh.nearest(point, extent)

    def route(self, start: Array, goal: Array, extent: Array) -> tuple[Array, bool] | None:
        """Corners of the way between the points of the mesh next to two places, and whether it is complete.

        None where one of them is not near the mesh; a way that is not complete ends where it begins.
        """
        places = [self._mesh.nearest(place, extent) for place in (start, goal)]
        if places[0] is None or places[1] is None:
            return None
        found = self._mesh.route(places[0], places[1])
        return (np.array([places[0], places[0]]), False) if found is None else (self._ended(found, places), True)

    @staticmethod
    def _ended(corners: Array, places: list[Any]) -> Array:
        """The corners with the places themselves at the ends."""
        made = corners.copy()
        made[0], made[-1] = places
        return made

    def straight(self, start: Array, goal: Array, extent: Array) -> Array:
        """How far a straight walk leads."""
        last = self._mesh.nearest(start, extent)
        if last is None:
            return start
        for share in np.linspace(0, 1, max(2, int(np.linalg.norm((goal - start)[:2]) / _STEP_CM) + 1))[1:]:
            wanted = np.array([*(start + share * (goal - start))[:2], last[2]])
            there = self._mesh.nearest(wanted, np.array([1.0, 1.0, 50.0]))
            if there is None:
                return last
            last = there
        return last

    def random_near(self, origin: Array, radius: float, *, reachable: bool) -> Array | None:
        """A point of the mesh within a radius, the same for the same question; ``reachable``: that a way leads to."""
        chosen = random.Random(repr((origin.tolist(), radius, reachable)))
        for _ in range(_MOST_TRIES):
            angle, away = chosen.uniform(0, 2 * np.pi), radius * chosen.random() ** 0.5
            place = origin + np.array([away * np.cos(angle), away * np.sin(angle), 0.0])
            there = self._mesh.nearest(place, np.array([50.0, 50.0, max(radius, 250.0)]))
            if there is None or np.linalg.norm(there - origin) > radius:
                continue
            if not reachable or self._mesh.route(origin, there) is not None:
                return there
        return None


_made: LevelMesh | None = None
_tried: tuple[Any, NavigationSettings] | None = None
"""Level and settings of the last build, whether it came to a mesh or not."""


def build(low: Array, high: Array, settings: NavigationSettings) -> str:
    """Build the mesh of the open level within a box (cm); the text says why there is none now, empty where there is."""
    global _made, _tried
    from c4s.navigation import SpaceMesh, SpaceTooLarge, build_space

    _tried = (editor.world().map, settings)
    index = current()
    solid = [target for target in index.meeting(low, high) if target.asset is not None]
    bodies = [body for target in solid for body in index.bodies(target)]
    try:
        _made = LevelMesh(editor.world().map, SpaceMesh(build_space(bodies, (low, high), settings)))
    except SpaceTooLarge as error:
        _made = None
        return str(error)
    return ""


def mesh() -> LevelMesh | None:
    """The mesh of the open level; None where none was built."""
    return _made if _made is not None and _made.level is editor.world().map else None


def is_of(settings: NavigationSettings) -> bool:
    """Whether the last build was one of the open level with these settings."""
    return _tried is not None and _tried[0] is editor.world().map and _tried[1] == settings
