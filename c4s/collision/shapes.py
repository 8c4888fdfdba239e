"""Collision shapes under a component's scale, and their bodies in the world.

Scale and mirroring are baked into the shape; what is left is a rigid pose. Scaling follows Unreal's aggregate geometry:
a sphere takes the smallest axis, a capsule the larger of its two radial axes and its own length axis, boxes and hulls
every axis.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np

from c4s.collision.hulls import FLAT, Hull, Triangles, convex_hull
from c4s.collision.libraries import coal, fcl
from c4s.collision.mesh_body import Array as Array
from c4s.collision.mesh_body import MeshBody
from c4s.geometry.transform import rotation_matrix

SIGNS = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], dtype=float)


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
    """Vertices of a hull around ``offset``; None: the box ``half``, widened by ``radius`` all around, is the shape."""
    half: Array = field(default_factory=lambda: np.zeros(3))
    radius: float = 0.0
    triangles: Triangles | None = None
    """Faces of a hull by corner, looking outward."""

    @property
    def is_box(self) -> bool:
        """A box with sharp edges."""
        return self.corners is None and self.radius == 0

    def place(self, rotation: Array, translation: Array) -> Body:
        """The shape in the world."""
        pose, centre = rotation @ self.frame, translation + rotation @ self.offset
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

    @property
    def points(self) -> Array:
        """The corners in the world; of a round body those of the box inside."""
        local = SIGNS * self.form.half if self.form.corners is None else self.form.corners
        return np.asarray(local @ self.rotation.T + self.translation)

    @cached_property
    def coal_pose(self) -> Any:
        """The pose as coal's transform."""
        return coal.Transform3s(self.rotation, self.translation)

    @cached_property
    def fcl_object(self) -> Any:
        """The body as python-fcl's collision object."""
        return fcl.CollisionObject(self.form.fcl, fcl.Transform(self.rotation, self.translation))

    def reach(self, direction: Array) -> float:
        """How far (cm) the body reaches from its own centre along a unit direction."""
        local = direction @ self.rotation
        if self.form.corners is not None:
            return float((self.form.corners @ local).max())
        return float(np.abs(local) @ self.form.half) + self.form.radius

    def moved(self, step: Array) -> Body:
        """The body moved by ``step`` (cm)."""
        return Body(self.form, self.rotation, self.translation + step, self.low + step, self.high + step)


def scaled_shape(body: MeshBody, scale: Array, hull: Hull | None = None) -> Shape | None:
    """A mesh's body under a component's scale; None when nothing with an area is left of it.

    ``hull``: the body's own hull, where it is a hull.
    """
    if body.kind == "hull":
        return _hull_shape(None if hull is None else hull.scaled(scale))
    centre = scale * np.array(body.centre)
    if body.kind == "sphere":
        return _round_shape(np.eye(3), centre, body.size[0] * float(np.abs(scale).min()), 0.0)
    axes = scale[:, None] * rotation_matrix(body.rotation_deg)
    if body.kind == "capsule":
        return _capsule(centre, axes, body.size[0], body.size[1])
    edges = axes * np.array(body.size)
    square = np.abs(np.triu(edges.T @ edges, 1)).max() <= 1e-12 * float((edges**2).sum())
    if square and np.linalg.norm(edges, axis=0).min() > 0:
        return _box(centre, edges)
    return _hull_shape(convex_hull(centre + SIGNS @ edges.T))


def _hull_shape(hull: Hull | None) -> Shape | None:
    if hull is None:
        return None
    return Shape(*hull.geometries(), np.eye(3), hull.centre, hull.corners, triangles=hull.faces.triangles)


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
    return Shape(
        coal.Capsule(radius, length),
        fcl.Capsule(radius, length),
        frame,
        centre,
        half=np.array([0.0, 0.0, length / 2]),
        radius=radius,
    )
