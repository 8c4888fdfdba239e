"""The walkable area of the open level as layers of a GLB: the largest area, and all others.

It is the walkable space of the Embodied Utility Score, built of the level's collision bodies in the same bounds.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from c4s.collision.scene import SceneBodies
from c4s.engine.headless.queries.index import current
from c4s.errors import BadInput
from c4s.records.pack import Material

_LIFT_M = 0.02
"""Above the floor, so that the two do not flicker."""
LARGEST, OTHERS = "Walkable: largest area", "Walkable: other areas"
_COLOURS = {LARGEST: (0.05, 0.55, 0.2), OTHERS: (0.9, 0.45, 0.05)}


@dataclass(frozen=True)
class Layer:
    """Triangles in glTF's axes and metres, looking up."""

    name: str
    points: NDArray[np.float64]
    faces: NDArray[np.int64]

    @property
    def material(self) -> Material:
        """What it is seen in."""
        return Material(path=f"/Engine/{self.name}.{self.name}", base_color=_COLOURS[self.name], opacity=0.55)


def walkable_layers() -> list[Layer]:
    """The layers of the open level; none where nobody can stand.

    Raises:
        BadInput: the level is too large for a walkable space.
    """
    from c4s.navigation import NavigationSettings, SpaceTooLarge, build_space
    from c4s.navigation.rectangles import rectangles_of
    from c4s.navigation.solids import navigation_bounds

    index, scene = current(), SceneBodies()
    everywhere = np.full(3, np.inf)
    for number, target in enumerate(t for t in index.meeting(-everywhere, everywhere) if t.asset is not None):
        bodies = index.bodies(target)
        scene.bodies.extend(bodies)
        scene.owners.extend([number] * len(bodies))
        scene.components.extend([0] * len(bodies))
    bounds = navigation_bounds(scene)
    if bounds is None:
        return []
    try:
        space = build_space(scene.bodies, bounds, NavigationSettings())
    except SpaceTooLarge as error:
        raise BadInput(f"no walkable area: {error}", where=index.world.package, todo="leave out --walk") from error
    if not len(space.sizes):
        return []
    regions = np.arange(len(space.sizes))
    largest = int(space.sizes.argmax())
    made = {LARGEST: regions[[largest]], OTHERS: np.delete(regions, largest)}
    return [_layer(name, found) for name, of in made.items() if len(found := rectangles_of(space, of))]


def _layer(name: str, rectangles: NDArray[np.float64]) -> Layer:
    x0, y0, x1, y1, z = rectangles.T / 100
    corners = np.stack([np.column_stack([x, z + _LIFT_M, y]) for x, y in ((x0, y0), (x0, y1), (x1, y1), (x1, y0))], 1)
    first = 4 * np.arange(len(rectangles))[:, None]
    faces = np.concatenate([first + np.array([0, 1, 2]), first + np.array([0, 2, 3])])
    return Layer(name, corners.reshape(-1, 3), faces)
