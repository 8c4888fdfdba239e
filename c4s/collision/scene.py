"""The collision bodies of a snapshot: which actors have them, and which cannot be resolved."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np

from c4s.collision.mesh_body import Array, MeshBody, Triple, number, read_body, triple
from c4s.collision.shape_cache import SHAPES
from c4s.collision.shapes import Body, Shape
from c4s.geometry.transform import quat_from_rotator

MOST_CORNERS_AT_ONCE = 200_000
"""Hull corners that are placed in one step: bounds the memory of a scene with many instances."""


@dataclass(frozen=True)
class SceneBodies:
    """All bodies of a snapshot. ``owners[i]`` is the index of the actor that owns ``bodies[i]``."""

    bodies: list[Body] = field(default_factory=list)
    owners: list[int] = field(default_factory=list)
    components: list[int] = field(default_factory=list)
    """Which component of its owner a body belongs to."""
    unresolved: dict[int, str] = field(default_factory=dict)
    """Actor index to the reason why its bodies are not (all) known."""


class _Placed(NamedTuple):
    """A shape of an actor (an index) and the pose of its component."""

    owner: int
    component: int
    shape: Shape
    location: Triple
    quaternion: tuple[float, float, float, float]


def scene_bodies(snapshot: Mapping[str, Any]) -> SceneBodies:
    """World bodies of every actor of a snapshot that carries c4s's keys.

    Components with collision off have none; a body without area (scale zero) has no collision, as in Unreal.
    An actor without the keys, with an unknown mesh or with unusable numbers is unresolved, never guessed.
    """
    extra = snapshot.get("c4s")
    meshes = extra.get("meshes") if isinstance(extra, Mapping) else None
    library = _Meshes(meshes) if isinstance(meshes, Mapping) else None
    placed: list[_Placed] = []
    unresolved: dict[int, str] = {}
    for index, actor in enumerate(snapshot.get("actors") or []):
        own = actor.get("c4s")
        components = own.get("components") if isinstance(own, Mapping) else None
        if library is None or not isinstance(components, list):
            collision = actor.get("collision")
            if not (isinstance(collision, Mapping) and collision.get("collision_enabled") is False):
                unresolved[index] = "the snapshot holds no collision bodies of this actor"
            continue
        for part, component in enumerate(components):
            try:
                placed += [_Placed(index, part, *shape) for shape in library.place(component)]
            except ValueError as error:
                unresolved.setdefault(index, str(error))
    owners, of = [part.owner for part in placed], [part.component for part in placed]
    return SceneBodies(_place(placed), owners, of, unresolved)


class _Meshes:
    """The meshes of a snapshot; each is read once."""

    def __init__(self, meshes: Mapping[str, Any]) -> None:
        self._meshes = meshes
        self._bodies: dict[str, list[MeshBody]] = {}
        self._shapes: dict[tuple[str, Triple], list[Shape]] = {}

    def place(self, component: Any) -> Iterator[tuple[Shape, Triple, tuple[float, float, float, float]]]:
        """Shapes of a component with their poses. ``ValueError`` says why they are not known."""
        if not isinstance(component, Mapping):
            raise ValueError("a component is not an object")
        mesh = component.get("mesh")
        if not mesh or not component.get("collision_enabled"):
            return
        instances = component.get("instances")
        transforms = instances if isinstance(instances, list) else [component.get("transform")]
        try:
            for transform in transforms:
                if not isinstance(transform, Mapping):
                    raise ValueError("no transform")
                location, scale = triple(transform.get("location_cm")), triple(transform.get("scale"))
                rotation = quaternion_of(transform)
                for shape in self._scaled(str(mesh), scale):
                    yield shape, location, rotation
        except ValueError as error:
            raise ValueError(f"component {component.get('name')}: {error}") from error

    def _scaled(self, mesh: str, scale: Triple) -> list[Shape]:
        known = self._shapes.get((mesh, scale))
        if known is None:
            shapes = [SHAPES.shape(body, scale) for body in self._read(mesh)]
            known = self._shapes[mesh, scale] = [shape for shape in shapes if shape is not None]
        return known

    def _read(self, mesh: str) -> list[MeshBody]:
        if mesh not in self._bodies:
            facts = self._meshes.get(mesh)
            stored = facts.get("collision") if isinstance(facts, Mapping) else None
            if not isinstance(stored, list):
                raise ValueError(f"no collision data of mesh {mesh}")
            try:
                self._bodies[mesh] = [read_body(body) for body in stored]
            except ValueError as error:
                raise ValueError(f"mesh {mesh}: {error}") from error
        return self._bodies[mesh]


def quaternion_of(transform: Mapping[str, Any]) -> tuple[float, float, float, float]:
    """Rotation of a transform (x, y, z, w), not normalised; from ``rotation_deg`` when it stores no quaternion."""
    stored = transform.get("quaternion_xyzw")
    if stored is None:
        return quat_from_rotator(triple(transform.get("rotation_deg")))
    if not isinstance(stored, list | tuple) or len(stored) != 4:
        raise ValueError("not a rotation quaternion")
    x, y, z, w = (number(part) for part in stored)
    if (x * x + y * y + z * z + w * w) ** 0.5 < 1e-12:
        raise ValueError("not a rotation quaternion")
    return x, y, z, w


def rotation_matrices(quaternions: Array) -> Array:
    """Rotation matrices (n, 3, 3) of quaternions (n, 4) of any length but zero."""
    x, y, z, w = (quaternions / np.linalg.norm(quaternions, axis=1)[:, None]).T
    rows = [
        1 - 2 * (y * y + z * z),
        2 * (x * y - z * w),
        2 * (x * z + y * w),
        2 * (x * y + z * w),
        1 - 2 * (x * x + z * z),
        2 * (y * z - x * w),
        2 * (x * z - y * w),
        2 * (y * z + x * w),
        1 - 2 * (x * x + y * y),
    ]
    return np.stack(rows, axis=1).reshape(-1, 3, 3)


def _place(placed: list[_Placed]) -> list[Body]:
    """The bodies in the world, all poses at once."""
    if not placed:
        return []
    rotation = rotation_matrices(np.array([part.quaternion for part in placed]))
    pose = rotation @ np.array([part.shape.frame for part in placed])
    offset = np.array([part.shape.offset for part in placed])
    half = np.array([part.shape.half for part in placed])
    centre = np.array([part.location for part in placed]) + np.einsum("nij,nj->ni", rotation, offset)
    reach = np.einsum("nij,nj->ni", np.abs(pose), half) + np.array([[part.shape.radius] for part in placed])
    low, high = centre - reach, centre + reach
    for some, corners in _hull_groups(placed):
        world = corners @ pose[some].transpose(0, 2, 1)
        low[some], high[some] = centre[some] + world.min(axis=1), centre[some] + world.max(axis=1)
    return [Body(part.shape, *row) for part, *row in zip(placed, pose, centre, low, high, strict=True)]


def _hull_groups(placed: list[_Placed]) -> Iterator[tuple[list[int], Array]]:
    """Positions that share a hull, with its corners; at most ``MOST_CORNERS_AT_ONCE`` corners a group."""
    groups: dict[int, list[int]] = {}
    for index, part in enumerate(placed):
        if part.shape.corners is not None:
            groups.setdefault(id(part.shape), []).append(index)
    for members in groups.values():
        corners = placed[members[0]].shape.corners
        assert corners is not None
        step = max(1, MOST_CORNERS_AT_ONCE // len(corners))
        for start in range(0, len(members), step):
            yield members[start : start + step], corners
