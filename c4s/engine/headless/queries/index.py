"""All bodies of the open level that queries can meet, with their boxes; only what changed is looked at again."""

from __future__ import annotations

from typing import Any

import numpy as np

from c4s.collision.mesh_body import MeshBody, read_body
from c4s.collision.shape_cache import SHAPES
from c4s.collision.shapes import Body
from c4s.engine.headless import editor
from c4s.engine.headless.editor import Editor
from c4s.engine.headless.pose import Pose, compose
from c4s.engine.headless.queries import changes
from c4s.engine.headless.queries.solids import Array
from c4s.engine.headless.queries.triangles import Rows, Triangles, segment_meets
from c4s.geometry.transform import WORLD_CM
from c4s.records.pack import Asset, BoxBody, CapsuleBody, CollisionBody, HullBody

_ROOM = 256
_Corners = tuple[tuple[float, float, float], tuple[float, float, float]]


class QueryTarget:
    """One placed mesh (or volume) that queries can meet."""

    __slots__ = ("_bodies", "_matrix", "actor", "asset", "component", "geometry", "item", "pose")

    def __init__(self, actor: Any, component: Any, item: int, pose: Pose, asset: Asset | None, geometry: Any) -> None:
        self.actor, self.component, self.item, self.pose = actor, component, item, pose
        self.asset, self.geometry = asset, geometry
        self._bodies: list[Body] | None = None
        self._matrix: tuple[Array, Array | None] | None = None

    def matrices(self) -> tuple[Array, Array | None]:
        """4x4 local to world, and the inverse of its linear part (None where a scale is 0)."""
        if self._matrix is None:
            matrix = self.pose.matrix()
            flat = min(abs(side) for side in self.pose.scale) < 1e-8
            inverse: Array | None = None if flat else np.asarray(np.linalg.inv(matrix[:3, :3]), np.float64)
            self._matrix = matrix, inverse
        return self._matrix


class SpatialIndex:
    """Boxes of all targets of one world, kept up to date."""

    def __init__(self, world: Editor) -> None:
        self._world = world
        self._map: Any = None
        self._rows: dict[Any, list[int]] = {}
        self._free: list[int] = []
        self._low, self._high = np.full((3, _ROOM), np.inf), np.full((3, _ROOM), -np.inf)
        self._targets: list[QueryTarget | None] = []
        self._plain: dict[str, list[MeshBody]] = {}
        self._reach: dict[str, _Corners] = {}
        self._triangles: dict[str, Triangles | None] = {}

    @property
    def world(self) -> Editor:
        """The world that it is of."""
        return self._world

    # keeping up

    def refresh(self) -> None:
        """Look again at the actors that changed."""
        changed = changes.taken()
        actors = self._world.actors
        if self._map is not self._world.map:
            self._map = self._world.map
            self._rows, self._free, self._targets = {}, [], []
            self._low, self._high = np.full((3, _ROOM), np.inf), np.full((3, _ROOM), -np.inf)
            changed = list(actors.values())
        for actor in changed:
            for row in self._rows.pop(actor, ()):
                self._targets[row] = None
                self._low[:, row], self._high[:, row] = np.inf, -np.inf
                self._free.append(row)
            if actors.get(actor._name) is actor:
                boxes = [(target, self._box(target)) for target in self._of(actor)]
                found = [self._add(target, *box) for target, box in boxes if box is not None]
                if found:
                    self._rows[actor] = found

    def _of(self, actor: Any) -> list[QueryTarget]:
        return [
            target
            for component in actor._components
            if hasattr(type(component), "_queries") and component._queries()
            for target in self._of_component(component, component._world_pose())
        ]

    @staticmethod
    def _of_component(component: Any, pose: Pose) -> list[QueryTarget]:
        mesh, instances = getattr(component, "_mesh", None), getattr(component, "_instances", None)
        if mesh is not None:
            poses = [pose] if instances is None else [compose(each, pose) for each in instances]
            return [
                QueryTarget(component._outer, component, -1 if instances is None else i, each, mesh._asset, mesh)
                for i, each in enumerate(poses)
            ]
        if type(component).__name__ == "BrushComponent":
            return [QueryTarget(component._outer, component, -1, pose, None, None)]
        return []

    def _add(self, target: QueryTarget, low: Array, high: Array) -> int:
        if self._free:
            row = self._free.pop()
            self._targets[row] = target
        else:
            row = len(self._targets)
            self._targets.append(target)
            if row == self._low.shape[1]:
                self._low = np.concatenate([self._low, np.full_like(self._low, np.inf)], axis=1)
                self._high = np.concatenate([self._high, np.full_like(self._high, -np.inf)], axis=1)
        self._low[:, row], self._high[:, row] = low, high
        return row

    def _box(self, target: QueryTarget) -> tuple[Array, Array] | None:
        """World box of the mesh and of its bodies; None when it reaches out of the world."""
        low, high = target.component._local_bounds() if target.asset is None else self._corners(target.asset)
        origin, extent = target.pose.box(low, high)
        corners = np.array(origin) - extent, np.array(origin) + extent
        if not max(np.abs(corners[0]).max(), np.abs(corners[1]).max()) < WORLD_CM:
            return None
        sides = [abs(side) for side in target.pose.scale]
        if (
            min(sides) == max(sides)
            or target.asset is None
            or not any(isinstance(body, CapsuleBody) for body in target.asset.collision)
        ):
            return corners
        bodies = self.bodies(target)  # a capsule stays round and can leave its scaled box
        return (
            np.min([corners[0], *(body.low for body in bodies)], axis=0),
            np.max([corners[1], *(body.high for body in bodies)], axis=0),
        )

    def _corners(self, asset: Asset) -> _Corners:
        """Local box that holds the mesh and its bodies."""
        if asset.path not in self._reach:
            rows = [asset.bounds_min_cm, asset.bounds_max_cm]
            for body in asset.collision:
                rows += list(local_reach(body))
            table = np.array(rows)
            low, high = table.min(axis=0).tolist(), table.max(axis=0).tolist()
            self._reach[asset.path] = (low[0], low[1], low[2]), (high[0], high[1], high[2])
        return self._reach[asset.path]

    # reading

    def crossing(self, start: Array, step: Array, half: Array) -> list[tuple[float, QueryTarget]]:
        """Targets whose box, widened by ``half`` (cm), meets a segment, with the fraction of the way; nearest first."""
        end = start + step
        rows = self._near(np.minimum(start, end) - half, np.maximum(start, end) + half)
        meets, first = segment_meets(self._low[:, rows].T - half, self._high[:, rows].T + half, start, step)
        order = np.flatnonzero(meets)
        order = order[np.argsort(first[order], kind="stable")]
        return [(float(first[i]), target) for i in order.tolist() if (target := self._targets[rows[i]]) is not None]

    def meeting(self, low: Array, high: Array) -> list[QueryTarget]:
        """Targets whose box meets a box."""
        return [target for row in self._near(low, high).tolist() if (target := self._targets[row]) is not None]

    def _near(self, low: Array, high: Array) -> Rows:
        """Rows whose box meets a box."""
        used = len(self._targets)
        near = self._low[0, :used] <= high[0]
        for axis in range(3):
            if axis:
                near &= self._low[axis, :used] <= high[axis]
            near &= self._high[axis, :used] >= low[axis]
        return np.flatnonzero(near)

    def bodies(self, target: QueryTarget) -> list[Body]:
        """Collision bodies of a target in the world."""
        if target._bodies is None:
            target._bodies = self.placed(target, target.pose)
        return target._bodies

    def of_component(self, component: Any, pose: Pose) -> list[Body]:
        """Collision bodies of a component as they would lie under another pose (instances move with it)."""
        return [body for target in self._of_component(component, pose) for body in self.placed(target, target.pose)]

    def placed(self, target: QueryTarget, pose: Pose) -> list[Body]:
        """Collision bodies of a target as they would lie under another pose."""
        name = target.asset.path if target.asset is not None else f"{type(target.component).__name__}:box"
        if name not in self._plain:
            self._plain[name] = [read_body(body.model_dump()) for body in _records(target)]
        rotation, location = np.array(pose.axes()), np.array(pose.location)
        shapes = [SHAPES.shape(body, pose.scale) for body in self._plain[name]]
        return [shape.place(rotation, location) for shape in shapes if shape is not None]

    def triangles(self, target: QueryTarget) -> Triangles | None:
        """Triangles of a target's mesh in its local frame; None when there are none."""
        if target.asset is None:
            return None
        path = target.asset.path
        if path not in self._triangles:
            mesh = target.geometry._geometry()
            self._triangles[path] = Triangles(mesh) if mesh is not None else None
        return self._triangles[path]


def local_reach(body: CollisionBody) -> _Corners:
    """Local box that holds a body (a capsule: as long as its scale is even)."""
    if isinstance(body, HullBody):
        points = np.array(body.vertices)
        low, high = points.min(axis=0).tolist(), points.max(axis=0).tolist()
        return (low[0], low[1], low[2]), (high[0], high[1], high[2])
    if isinstance(body, BoxBody):
        half = float(np.linalg.norm(body.half_extent)) if any(body.rotation_deg) else 0.0
        straight = [half] * 3 if half else body.half_extent
        low, high = (np.array(body.center) - straight).tolist(), (np.array(body.center) + straight).tolist()
        return (low[0], low[1], low[2]), (high[0], high[1], high[2])
    half = body.radius + body.length / 2 if isinstance(body, CapsuleBody) else body.radius
    x, y, z = body.center
    return (x - half, y - half, z - half), (x + half, y + half, z + half)


def _records(target: QueryTarget) -> list[CollisionBody]:
    if target.asset is not None:
        return list(target.asset.collision)
    low, high = (np.array(corner) for corner in target.component._local_bounds())
    x, y, z = ((low + high) / 2).tolist()
    a, b, c = ((high - low) / 2).tolist()
    return [BoxBody(center=(x, y, z), half_extent=(a, b, c))]


_current: SpatialIndex | None = None


def current() -> SpatialIndex:
    """The index of the open level, up to date."""
    global _current
    world = editor.world()
    if _current is None or _current.world is not world:
        _current = SpatialIndex(world)
    _current.refresh()
    return _current
