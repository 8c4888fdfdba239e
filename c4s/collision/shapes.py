"""Collision bodies in world space.

A body of a mesh (local cm) becomes a world body by its component's transform. Scale and mirroring are baked into the
shape; what is left is a rigid pose. Scaling follows Unreal's aggregate geometry: a sphere takes the smallest axis, a
capsule the larger of its two radial axes and its own length axis, boxes and hulls every axis.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, TypeAlias

import coal
import fcl
import numpy as np
from numpy.typing import NDArray
from scipy.spatial import ConvexHull, QhullError

from c4s.scene.transform import rotation_matrix

Array: TypeAlias = NDArray[np.float64]
FLAT = 1e-9
"""Relative size under which a dimension of a shape counts as zero."""


@dataclass(frozen=True, eq=False)
class Shape:
    """A convex shape in the frame of its component, scale and mirroring baked in."""

    coal: Any
    fcl: Any
    frame: Array
    """Rotation of the shape in the component."""
    offset: Array
    """Centre of the shape's own frame in the component (cm)."""
    corners: Array | None = None
    """Vertices of a hull; None: the box that ``half`` and ``radius`` span holds the shape."""
    half: Array = field(default_factory=lambda: np.zeros(3))
    radius: float = 0.0

    def place(self, rotation: Array, translation: Array) -> Body:
        """The shape in the world."""
        pose = rotation @ self.frame
        centre = translation + rotation @ self.offset
        if self.corners is not None:
            world = self.corners @ pose.T + centre
            return Body(self, pose, centre, world.min(axis=0), world.max(axis=0))
        reach = np.abs(pose) @ self.half + self.radius
        return Body(self, pose, centre, centre - reach, centre + reach)


@dataclass(frozen=True, eq=False)
class Body:
    """A convex body in the world (cm)."""

    form: Shape
    rotation: Array
    translation: Array
    low: Array
    """World AABB."""
    high: Array

    @property
    def shape(self) -> Any:
        """The coal geometry, in the body's own frame."""
        return self.form.coal

    @cached_property
    def coal_pose(self) -> Any:
        """The pose as coal's transform."""
        return coal.Transform3s(self.rotation, self.translation)

    @cached_property
    def fcl_object(self) -> Any:
        """The body as python-fcl's collision object."""
        return fcl.CollisionObject(self.form.fcl, fcl.Transform(self.rotation, self.translation))

    def moved(self, step: Array) -> Body:
        """The body moved by ``step`` (cm)."""
        return Body(self.form, self.rotation, self.translation + step, self.low + step, self.high + step)


def quaternion_matrix(quaternion_xyzw: Sequence[float]) -> Array:
    """3x3 rotation of a quaternion (x, y, z, w); it is normalised first. ``ValueError`` when it has no length."""
    quat = np.asarray(quaternion_xyzw, dtype=float)
    length = float(np.linalg.norm(quat))
    if quat.shape != (4,) or not math.isfinite(length) or length < 1e-12:
        raise ValueError("not a rotation quaternion")
    x, y, z, w = quat / length
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                     [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                     [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])


def vector(values: Any) -> Array:
    """Three finite numbers as an array; ``ValueError`` otherwise."""
    array = np.asarray(values, dtype=float)
    if array.shape != (3,) or not np.isfinite(array).all():
        raise ValueError("not three finite numbers")
    return array


def make_hull(vertices: Array) -> Shape | None:
    """The convex hull of points (n, 3) in cm, solid or flat; None when the points span no area."""
    points = np.asarray(vertices, dtype=float)
    if points.ndim != 2 or points.shape[1] != 3 or len(points) < 3 or not np.isfinite(points).all():
        return None
    centred = points - points.mean(axis=0)
    size = float(np.abs(centred).max())
    if size == 0:
        return None
    axes = np.linalg.svd(centred, full_matrices=False)
    rank = int((axes[1] > FLAT * size * math.sqrt(len(points))).sum())
    if rank < 2:
        return None
    corners, faces = _solid(points) if rank == 3 else _flat(points, centred @ axes[2][:2].T)
    return Shape(*_geometries(corners, faces), np.eye(3), np.zeros(3), corners)


def _solid(points: Array) -> tuple[Array, NDArray[np.int64]]:
    """Vertices and outward triangles of a solid hull; a hull too thin for Qhull is built as a flat one."""
    try:
        hull = ConvexHull(points)
    except QhullError:
        centred = points - points.mean(axis=0)
        return _flat(points, centred @ np.linalg.svd(centred, full_matrices=False)[2][:2].T)
    used, faces = np.unique(hull.simplices, return_inverse=True)
    corners, faces = points[used], np.asarray(faces, dtype=np.int64).reshape(-1, 3)
    sides = np.cross(corners[faces[:, 1]] - corners[faces[:, 0]], corners[faces[:, 2]] - corners[faces[:, 0]])
    inward = (sides * hull.equations[:, :3]).sum(axis=1) < 0
    faces[inward] = faces[inward][:, ::-1]
    return corners, faces


def _flat(points: Array, plane: Array) -> tuple[Array, NDArray[np.int64]]:
    """The polygon of flat points as a two-sided fan of triangles."""
    corners = points[ConvexHull(plane).vertices]
    fan = np.array([[0, i, i + 1] for i in range(1, len(corners) - 1)], dtype=np.int64)
    return corners, np.concatenate([fan, fan[:, ::-1]])


def _geometries(corners: Array, faces: NDArray[np.int64]) -> tuple[Any, Any]:
    points, triangles = coal.StdVec_Vec3s(), coal.StdVec_Triangle()
    for corner in corners:
        points.append(corner)
    for face in faces.tolist():
        triangles.append(coal.Triangle(*face))
    fcl_faces = np.concatenate([np.full((len(faces), 1), 3, dtype=np.int64), faces], axis=1).ravel()
    return coal.Convex(points, triangles), fcl.Convex(corners, len(faces), fcl_faces)


def body_matrix(body: Mapping[str, Any]) -> Array:
    """Rotation of a body in its mesh."""
    return rotation_matrix([float(v) for v in body.get("rotation_deg") or (0.0, 0.0, 0.0)])


class BodyFactory:
    """Places the bodies of meshes in the world. Shapes are built once a mesh and scale."""

    def __init__(self, meshes: Mapping[str, Any]) -> None:
        self._meshes = meshes
        self._shapes: dict[tuple[str, tuple[float, ...]], list[Shape]] = {}

    def knows(self, mesh: str) -> bool:
        """Whether the snapshot holds the mesh's collision bodies (null: the engine could not read them)."""
        facts = self._meshes.get(mesh)
        return isinstance(facts, Mapping) and isinstance(facts.get("collision"), list)

    def place(self, mesh: str, transform: Mapping[str, Any]) -> list[Body]:
        """World bodies of a mesh under a component's world transform; ``ValueError`` when its numbers are unusable."""
        location, scale = vector(transform.get("location_cm")), vector(transform.get("scale"))
        quaternion = transform.get("quaternion_xyzw")
        rotation = (quaternion_matrix(quaternion) if quaternion is not None
                    else rotation_matrix(vector(transform.get("rotation_deg")).tolist()))
        key = mesh, tuple(scale.tolist())
        if key not in self._shapes:
            shapes = [scaled_shape(body, scale) for body in self._meshes[mesh]["collision"]]
            self._shapes[key] = [shape for shape in shapes if shape is not None]
        return [shape.place(rotation, location) for shape in self._shapes[key]]


def scaled_shape(body: Mapping[str, Any], scale: Array) -> Shape | None:
    """A mesh's collision body under a component's scale; None when nothing with an area is left of it."""
    kind = body.get("kind")
    if kind == "hull":
        return make_hull(np.asarray(body["vertices"], dtype=float) * scale)
    centre = scale * vector(body["center"])
    if kind == "sphere":
        return _round_shape(np.eye(3), centre, abs(float(body["radius"])) * float(np.abs(scale).min()), 0.0)
    axes = scale[:, None] * body_matrix(body)
    if kind == "capsule":
        return _capsule(centre, axes, abs(float(body["radius"])), abs(float(body["length"])))
    if kind == "box":
        edges = axes * np.abs(vector(body["half_extent"]))
        if np.abs(np.triu(edges.T @ edges, 1)).max() <= 1e-12 * float((edges**2).sum()) and np.all(edges.any(axis=0)):
            return _box(centre, edges)
        signs = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], dtype=float)
        return make_hull(centre + signs @ edges.T)
    raise ValueError(f"unknown collision body kind {kind!r}")


def _box(centre: Array, edges: Array) -> Shape:
    """A box from its three half edges (columns); a box has no handedness."""
    half = np.linalg.norm(edges, axis=0)
    frame = edges / half
    if np.linalg.det(frame) < 0:
        frame[:, 2] = -frame[:, 2]
    sides = (2 * half).tolist()
    return Shape(coal.Box(*sides), fcl.Box(*sides), frame, centre, half=half)


def box_body(low: Array, high: Array) -> Body:
    """An axis-aligned box between two corners (cm)."""
    return _box((low + high) / 2, np.diag(np.maximum((high - low) / 2, FLAT))).place(np.eye(3), np.zeros(3))


def _capsule(centre: Array, axes: Array, radius: float, length: float) -> Shape | None:
    """A scaled capsule: its ends stay round, the radius takes the larger radial factor, at most the half length."""
    along = np.linalg.norm(axes, axis=0)
    if float(along[2]) == 0:
        return None
    half = (length / 2 + radius) * float(along[2])
    scaled = min(radius * float(max(along[0], along[1])), half)
    direction = axes[:, 2] / along[2]
    x = np.cross(np.eye(3)[int(np.argmin(np.abs(direction)))], direction)
    x /= np.linalg.norm(x)
    return _round_shape(np.column_stack([x, np.cross(direction, x), direction]), centre, scaled, 2 * (half - scaled))


def _round_shape(frame: Array, centre: Array, radius: float, length: float) -> Shape | None:
    """A sphere, or a capsule along the frame's Z when ``length`` is above zero; None without a radius."""
    if radius <= 0:
        return None
    if length <= 0:
        return Shape(coal.Sphere(radius), fcl.Sphere(radius), np.eye(3), centre, radius=radius)
    return Shape(coal.Capsule(radius, length), fcl.Capsule(radius, length), frame, centre,
                 half=np.array([0.0, 0.0, length / 2]), radius=radius)
