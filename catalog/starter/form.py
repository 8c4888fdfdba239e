"""A small builder of outdoor meshes: boxes, prisms, frustums and ellipsoids, with collision bodies beside them.

Unreal's local axes in cm; every ``at`` is the centre of a part's base, so a thing that stands on the ground starts at
``z = 0``. Texture coordinates are the plan position on the face in metres divided by ``TILE_M``, so textures keep
their size on every part.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from c4s.packs.manifest import BoxBody, CollisionBody, HullBody
from c4s.packs.meshes import Mesh
from c4s.scene.level import Vector
from c4s.scene.transform import rotation_matrix

TILE_M = 2.0
"""Side of one texture repeat in metres."""
Point = tuple[float, float]
Points = NDArray[np.float64]


class Form:
    """A mesh in the making. Slots are material names; a part's ``body`` makes it solid."""

    def __init__(self) -> None:
        self.slots: list[str] = []
        self.bodies: list[CollisionBody] = []
        self._vertices: list[Points] = []
        self._normals: list[Points] = []
        self._faces: list[NDArray[np.int64]] = []
        self._face_slots: list[NDArray[np.int64]] = []
        self._count = 0

    def box(self, slot: str, size: Vector, at: Vector = (0.0, 0.0, 0.0), *, turn: Vector = (0.0, 0.0, 0.0),
            body: bool = False) -> Form:
        """A box of ``size``, turned by [pitch, yaw, roll] about the centre of its base."""
        x, y = size[0] / 2, size[1] / 2
        self.prism(slot, [(-x, -y), (x, -y), (x, y), (-x, y)], size[2], at, turn=turn)
        if body:
            centre = np.asarray(at) + rotation_matrix(turn) @ np.array([0.0, 0.0, size[2] / 2])
            self.bodies.append(BoxBody(center=_vector(centre), rotation_deg=turn,
                                       half_extent=(x, y, size[2] / 2)))
        return self

    def solid(self, size: Vector, at: Vector = (0.0, 0.0, 0.0)) -> Form:
        """A collision box without a visible part."""
        self.bodies.append(BoxBody(center=(at[0], at[1], at[2] + size[2] / 2),
                                   half_extent=(size[0] / 2, size[1] / 2, size[2] / 2)))
        return self

    def prism(self, slot: str, outline: Sequence[Point], height: float, at: Vector = (0.0, 0.0, 0.0), *,
              turn: Vector = (0.0, 0.0, 0.0), axis: str = "z", body: bool = False) -> Form:
        """A convex outline drawn out by ``height``.

        Axis ``z``: the outline is (x, y), drawn upwards from ``at``. Axis ``x``: (y, z), drawn to both sides of
        ``at``. Axis ``y``: (x, z), likewise.
        """
        flat = np.asarray(outline, dtype=float)
        low, high = (0.0, height) if axis == "z" else (-height / 2, height / 2)
        place = {"z": (0, 1, 2), "x": (1, 2, 0), "y": (0, 2, 1)}[axis]
        rings = []
        for level in (low, high):
            ring = np.zeros((len(flat), 3))
            ring[:, place[0]], ring[:, place[1]], ring[:, place[2]] = flat[:, 0], flat[:, 1], level
            rings.append(ring @ rotation_matrix(turn).T + np.asarray(at))
        bottom, top = rings
        self._polygon(slot, bottom[::-1])
        self._polygon(slot, top)
        for i in range(len(flat)):
            j = (i + 1) % len(flat)
            self._polygon(slot, np.array([bottom[i], bottom[j], top[j], top[i]]))
        if body:
            self.bodies.append(HullBody(vertices=[_vector(p) for p in np.concatenate(rings)]))
        return self

    def frustum(self, slot: str, radii: Point, height: float, at: Vector = (0.0, 0.0, 0.0), *,
                turn: Vector = (0.0, 0.0, 0.0), segments: int = 14, body: bool = False) -> Form:
        """A cylinder, cone or frustum with the radii at its base and its top; ``turn`` tilts its axis."""
        angles = np.arange(segments) * (2 * math.pi / segments)
        circle = np.stack([np.cos(angles), np.sin(angles)], axis=1)
        matrix, place = rotation_matrix(turn), np.asarray(at)
        rings = [np.column_stack([circle * r, np.full(segments, z)]) @ matrix.T + place
                 for r, z in zip(radii, (0.0, height), strict=True)]
        slope = (radii[0] - radii[1]) / height
        normals = np.column_stack([circle, np.full(segments, slope)])
        normals = normals / np.linalg.norm(normals, axis=1, keepdims=True) @ matrix.T
        index = np.arange(segments)
        after = (index + 1) % segments
        faces = np.concatenate([np.stack([index, after, after + segments], axis=1),
                                np.stack([index, after + segments, index + segments], axis=1)])
        self._add(slot, np.concatenate(rings), np.concatenate([normals, normals]), faces)
        if radii[0] > 0:
            self._polygon(slot, rings[0][::-1])
        if radii[1] > 0:
            self._polygon(slot, rings[1])
        if body:
            kept = [ring for ring, radius in zip(rings, radii, strict=True) if radius > 0]
            tips = [ring[:1] for ring, radius in zip(rings, radii, strict=True) if radius <= 0]
            self.bodies.append(HullBody(vertices=[_vector(p) for p in np.concatenate([*kept, *tips])]))
        return self

    def ball(self, slot: str, radii: Vector, at: Vector, *, rings: int = 7, segments: int = 12,
             body: bool = False) -> Form:
        """An ellipsoid; here ``at`` is the centre."""
        theta = np.linspace(0, math.pi, rings + 1)
        phi = np.arange(segments) * (2 * math.pi / segments)
        unit = np.array([[math.sin(t) * math.cos(p), math.sin(t) * math.sin(p), math.cos(t)] for t in theta for p in phi])
        scale = np.asarray(radii)
        normals = unit / scale
        normals /= np.linalg.norm(normals, axis=1, keepdims=True)
        faces = []
        for r in range(rings):
            for s in range(segments):
                a, b = r * segments + s, r * segments + (s + 1) % segments
                faces += [[a, b, b + segments], [a, b + segments, a + segments]]
        self._add(slot, unit * scale + np.asarray(at), normals, np.array(faces))
        if body:
            points = unit[segments:-segments] * scale + np.asarray(at)
            ends = np.array([[0, 0, 1.0], [0, 0, -1.0]]) * scale + np.asarray(at)
            self.bodies.append(HullBody(vertices=[_vector(p) for p in np.concatenate([points, ends])]))
        return self

    def bar(self, slot: str, start: Vector, end: Vector, radius: float, *, segments: int = 8) -> Form:
        """A round bar between two points."""
        a, b = np.asarray(start, dtype=float), np.asarray(end, dtype=float)
        dx, dy, dz = b - a
        length = float(np.linalg.norm(b - a))
        pitch = math.degrees(math.atan2(dz, math.hypot(dx, dy)))
        return self.frustum(slot, (radius, radius), length, start, segments=segments,
                            turn=(pitch - 90.0, math.degrees(math.atan2(dy, dx)), 0.0))

    def mesh(self) -> Mesh:
        """The finished mesh."""
        vertices = np.concatenate(self._vertices)
        normals = np.concatenate(self._normals)
        return Mesh(vertices=vertices.astype(np.float32), faces=np.concatenate(self._faces).astype(np.int32),
                    normals=normals.astype(np.float32), uvs=_uvs(vertices, normals),
                    face_slots=np.concatenate(self._face_slots).astype(np.int32))

    def _polygon(self, slot: str, points: Points) -> None:
        normal = np.cross(points[1] - points[0], points[2] - points[0])
        normal = normal / max(float(np.linalg.norm(normal)), 1e-9)
        fan = [[0, i, i + 1] for i in range(1, len(points) - 1)]
        self._add(slot, points, np.tile(normal, (len(points), 1)), np.array(fan))

    def _add(self, slot: str, vertices: Points, normals: Points, faces: NDArray[np.int64]) -> None:
        if slot not in self.slots:
            self.slots.append(slot)
        self._vertices.append(vertices)
        self._normals.append(normals)
        self._faces.append(faces + self._count)
        self._face_slots.append(np.full(len(faces), self.slots.index(slot)))
        self._count += len(vertices)


def _uvs(vertices: Points, normals: Points) -> NDArray[np.float32]:
    """Box projection: seen from the axis that the normal is nearest to; v runs down walls."""
    axis = np.abs(normals).argmax(axis=1)
    u = np.where(axis == 0, vertices[:, 1], vertices[:, 0])
    v = np.where(axis == 2, vertices[:, 1], -vertices[:, 2])
    uvs: NDArray[np.float32] = (np.stack([u, v], axis=1) / (100.0 * TILE_M)).astype(np.float32)
    return uvs


def _vector(point: NDArray[np.float64]) -> Vector:
    return float(point[0]), float(point[1]), float(point[2])
