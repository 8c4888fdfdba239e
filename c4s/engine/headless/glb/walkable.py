"""How a body can use the open level, as layers of a GLB: the walkable area, targets, and routes.

It is what the Embodied Utility Score is measured of: the level's snapshot and its collision bodies. Targets are frames
around their feet; routes are ribbons, each a layer named for its target and for whether the walk arrived.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

import numpy as np
from numpy.typing import NDArray

from c4s.errors import BadInput
from c4s.records.pack import Material

if TYPE_CHECKING:
    from c4s.records.navigation import NavigationEvidence

_LIFT_M: Final = 0.02
"""Above the floor, so that the two do not flicker."""
_FRAME_M, _ROUTE_M = 0.06, 0.12
LARGEST, OTHERS = "Walkable: largest area", "Walkable: other areas"
REACHED, ASTRAY = "Targets: reached", "Targets: not reached"
_AREA, _AREA_APART, _YES, _NO = (0.05, 0.55, 0.2), (0.9, 0.45, 0.05), (0.02, 0.25, 0.1), (0.75, 0.05, 0.03)
Points = NDArray[np.float64]


@dataclass(frozen=True)
class Layer:
    """Flat quadrangles, as triangles in glTF's axes and metres, looking up."""

    name: str
    points: Points
    faces: NDArray[np.int64]
    colour: tuple[float, float, float]
    opacity: float

    @property
    def material(self) -> Material:
        """What it is seen in."""
        return Material(path=f"/Engine/{self.name}.{self.name}", base_color=self.colour, opacity=self.opacity)


def walkable_layers() -> list[Layer]:
    """The layers of the open level; none where nobody can stand.

    Raises:
        BadInput: the level is too large for a walkable space.
    """
    from c4s.collision import scene_bodies
    from c4s.editor.snapshot import export_snapshot
    from c4s.navigation import NavigationSettings, SpaceTooLarge, build_space, measure_snapshot
    from c4s.navigation.rectangles import rectangles_of
    from c4s.navigation.solids import navigation_bounds

    snapshot = export_snapshot()
    scene = scene_bodies(snapshot)
    bounds = navigation_bounds(scene)
    if bounds is None:
        return []
    try:
        space = build_space(scene.bodies, bounds, NavigationSettings())
    except SpaceTooLarge as error:
        where = str(snapshot["metadata"].get("level", "the level"))
        raise BadInput(f"no walkable area: {error}", where=where, todo="leave out --walk") from error
    if not len(space.sizes):
        return []
    regions = np.arange(len(space.sizes))
    largest = int(space.sizes.argmax())
    areas = [(LARGEST, regions[[largest]], _AREA), (OTHERS, np.delete(regions, largest), _AREA_APART)]
    made = [
        _layer(name, _plates(found), colour, 0.55)
        for name, of, colour in areas
        if len(found := rectangles_of(space, of))
    ]
    return made + list(_of_walks(measure_snapshot(snapshot)))


def _of_walks(evidence: NavigationEvidence) -> Iterator[Layer]:
    """Targets by whether they are reached, and each route."""
    from c4s.navigation import has_arrived
    from c4s.records.navigation import LETTERS, SCENERY

    pool = [target for target in evidence.targets if not target.left]
    falls = [LETTERS[letter] for letter in evidence.builds[-1].falls] if evidence.builds else []
    floor = [(target, fall) for target, fall in zip(pool, falls, strict=False) if fall not in SCENERY]
    for name, reached, colour in ((REACHED, True, _YES), (ASTRAY, False, _NO)):
        frames = [_frame(target.low_cm, target.high_cm) for target, fall in floor if (fall == "connected") == reached]
        if frames:
            yield _layer(name, np.concatenate(frames), colour, 1.0)
    labels = {target.name: target.label or target.name for target in evidence.targets}
    for number, walk in enumerate(evidence.walks, 1):
        arrived = has_arrived(evidence, walk)
        start = f" from {labels.get(walk.start, walk.start)}" if walk.start else ""
        name = (
            f"Route {number}{start} to {labels.get(walk.goal, walk.goal)}: {'arrived' if arrived else 'did not arrive'}"
        )
        yield _layer(name, _ribbon(np.array(walk.route_cm) / 100), _YES if arrived else _NO, 1.0)


def _layer(name: str, corners: Points, colour: tuple[float, float, float], opacity: float) -> Layer:
    """A layer of quadrangles (n, 4, 3) in metres and Unreal's axes, in the order that looks up in glTF."""
    first = 4 * np.arange(len(corners))[:, None]
    faces = np.concatenate([first + np.array([0, 1, 2]), first + np.array([0, 2, 3])])
    return Layer(name, corners.reshape(-1, 3)[:, [0, 2, 1]], faces, colour, opacity)


def _plates(rectangles: Points) -> Points:
    x0, y0, x1, y1, z = rectangles.T / 100
    return np.stack([np.column_stack([x, y, z + _LIFT_M]) for x, y in ((x0, y0), (x0, y1), (x1, y1), (x1, y0))], 1)


def _frame(low_cm: Sequence[float], high_cm: Sequence[float]) -> Points:
    """Four strips around the foot of a box."""
    (x0, y0, z), (x1, y1, _) = (np.array(part) for part in (low_cm, high_cm))
    wide = 100 * _FRAME_M
    rows = [
        (x0 - wide, y0 - wide, x1 + wide, y0),
        (x0 - wide, y1, x1 + wide, y1 + wide),
        (x0 - wide, y0, x0, y1),
        (x1, y0, x1 + wide, y1),
    ]
    return _plates(np.array([[*row, z + 100 * _LIFT_M] for row in rows]))


def _ribbon(points: Points) -> Points:
    """A strip along a polyline."""
    a, b = points[:-1], points[1:]
    along = (b - a)[:, :2]
    length = np.maximum(np.linalg.norm(along, axis=1), 1e-9)[:, None]
    across = np.zeros_like(a)
    across[:, :2] = np.column_stack([-along[:, 1], along[:, 0]]) / length * _ROUTE_M / 2
    lift = np.array([0.0, 0.0, 4 * _LIFT_M])
    return np.stack([a + lift + across, b + lift + across, b + lift - across, a + lift - across], 1)
