"""``Builder`` collects parts, each with a material and, unless told otherwise, a collision body."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Literal

import numpy as np

from c4s.geometry.transform import affine, quat_from_rotator, quat_multiply, rotator_from_quat
from c4s.packs.meshes import Mesh
from c4s.records.pack import BoxBody, CapsuleBody, CollisionBody, HullBody, SphereBody
from catalog.shapes import patches
from catalog.shapes.patches import Array, Patch, Point2, Point3

Body = Literal["box", "hull", "sphere"]


@dataclass(frozen=True)
class BuiltShape:
    """A finished mesh: its slots are material names in order of first use. Texture coordinates are in metres, but
    0..1 on parts that were added with ``fit``; ``fitted`` tells them apart a vertex."""

    mesh: Mesh
    materials: list[str]
    collision: list[CollisionBody]
    fitted: np.ndarray[tuple[int], np.dtype[np.bool_]]


def _rounded(point: Sequence[float] | Array) -> Point3:
    return (round(float(point[0]), 3), round(float(point[1]), 3), round(float(point[2]), 3))


class Builder:
    """Parts in cm and degrees in Unreal's axes: X is an asset's width, Y its depth, Z up; furniture faces +Y.

    ``at`` is the middle of the bottom of the part, ``rot`` = (pitch, yaw, roll) turns it about ``at``; ``body`` is the
    collision body made for it, ``None`` for none.
    """

    def __init__(self) -> None:
        self._parts: list[tuple[str, Patch, bool]] = []
        self._bodies: list[CollisionBody] = []
        self._frame: list[tuple[Point3, Point3]] = []

    @contextmanager
    def moved(self, at: Point3 = (0, 0, 0), rot: Point3 = (0, 0, 0)) -> Iterator[None]:
        """Parts added inside are placed in a frame at ``at`` turned by ``rot``."""
        self._frame.append((at, rot))
        try:
            yield
        finally:
            self._frame.pop()

    def _pose(self, at: Point3, rot: Point3) -> tuple[Array, Point3]:
        matrix, turn = affine(at, rot, (1, 1, 1)), quat_from_rotator(rot)
        for place, angles in reversed(self._frame):
            matrix = affine(place, angles, (1, 1, 1)) @ matrix
            turn = quat_multiply(quat_from_rotator(angles), turn)
        return matrix, rotator_from_quat(turn)

    def add(
        self,
        material: str,
        patch: Patch,
        at: Point3 = (0, 0, 0),
        rot: Point3 = (0, 0, 0),
        *,
        body: Body | None = "hull",
        fit: bool = False,
    ) -> None:
        """Add any patch; ``fit`` says that its texture coordinates run from 0 to 1."""
        matrix, angles = self._pose(at, rot)
        points = patch.vertices @ matrix[:3, :3].T + matrix[:3, 3]
        self._parts.append((material, Patch(points, patch.faces, patch.normals @ matrix[:3, :3].T, patch.uvs), fit))
        low, high = patch.vertices.min(axis=0), patch.vertices.max(axis=0)
        centre, half = matrix[:3, :3] @ ((low + high) / 2) + matrix[:3, 3], (high - low) / 2
        if body == "box":
            self._bodies.append(
                BoxBody(
                    center=_rounded(centre), rotation_deg=_rounded(angles), half_extent=_rounded(np.maximum(half, 0.05))
                )
            )
        elif body == "sphere":
            self._bodies.append(SphereBody(center=_rounded(centre), radius=round(float(half.max()), 3)))
        elif body == "hull":
            self._add_hull(points)

    def _add_hull(self, points: Array) -> None:
        """Hull body; rounding is coarse enough that coplanar corners do not become slivers."""
        from scipy.spatial import ConvexHull

        corners = np.unique(np.round(points, 3), axis=0)
        self._bodies.append(HullBody(vertices=[_rounded(corners[i]) for i in sorted(ConvexHull(corners).vertices)]))

    def box(
        self,
        material: str,
        size: Point3,
        at: Point3 = (0, 0, 0),
        rot: Point3 = (0, 0, 0),
        *,
        bevel: float = 0.0,
        body: Body | None = "box",
    ) -> None:
        """A box, with bevelled edges where ``bevel`` (cm) is given."""
        self.add(material, patches.box(size, bevel), at, rot, body=body)

    def cylinder(
        self,
        material: str,
        radius: float,
        height: float,
        at: Point3 = (0, 0, 0),
        rot: Point3 = (0, 0, 0),
        *,
        top: float | None = None,
        segments: int = 20,
        squash: float = 1.0,
        body: Body | None = "hull",
    ) -> None:
        """A cylinder, or a frustum with upper radius ``top`` (0 for a cone)."""
        self.add(material, patches.cylinder(radius, height, segments, top=top, squash=squash), at, rot, body=body)

    def ellipsoid(
        self,
        material: str,
        size: Point3,
        at: Point3 = (0, 0, 0),
        rot: Point3 = (0, 0, 0),
        *,
        segments: int = 16,
        body: Body | None = "hull",
    ) -> None:
        """An ellipsoid of the given diameters, standing on ``at``."""
        self.add(material, patches.ellipsoid(size, segments), at, rot, body=body)

    def lathe(
        self,
        material: str,
        profile: Sequence[Point2],
        at: Point3 = (0, 0, 0),
        rot: Point3 = (0, 0, 0),
        *,
        segments: int = 20,
        smooth: bool = True,
        squash: float = 1.0,
        body: Body | None = "hull",
    ) -> None:
        """A turned shape through (radius, z) points."""
        self.add(material, patches.revolve(profile, segments, smooth=smooth, squash=squash), at, rot, body=body)

    def extrude(
        self,
        material: str,
        outline: Sequence[Point2],
        height: float,
        at: Point3 = (0, 0, 0),
        rot: Point3 = (0, 0, 0),
        *,
        body: Body | None = "hull",
    ) -> None:
        """A prism on an outline in the XY plane."""
        self.add(material, patches.extrude(outline, height), at, rot, body=body)

    def tube(
        self, material: str, path: Sequence[Point3], radius: float, *, segments: int = 8, body: Body | None = None
    ) -> None:
        """A round tube along points."""
        self.add(material, patches.tube(path, radius, segments), body=body)

    def wedge(
        self,
        material: str,
        size: Point3,
        at: Point3 = (0, 0, 0),
        rot: Point3 = (0, 0, 0),
        *,
        body: Body | None = "hull",
    ) -> None:
        """A ramp that rises along +X."""
        x = size[0] / 2
        self.add(material, patches.prism([(-x, 0), (x, 0), (x, size[2])], size[1]), at, rot, body=body)

    def arch(
        self,
        material: str,
        size: Point3,
        opening: Point2,
        at: Point3 = (0, 0, 0),
        rot: Point3 = (0, 0, 0),
        *,
        body: bool = True,
    ) -> None:
        """A wall of ``size`` with a round-topped opening (width, height); the bodies are two posts and a lintel."""
        outline = patches.arch_outline(size[0], size[2], *opening)
        self.add(material, patches.prism(outline, size[1]), at, rot, body=None)
        if body:
            post = (size[0] - opening[0]) / 2
            with self.moved(at, rot):
                for side in (-1, 1):
                    self.body_box((post, size[1], size[2]), (side * (size[0] - post) / 2, 0, 0))
                self.body_box((opening[0], size[1], size[2] - opening[1]), (0, 0, opening[1]))

    def gable(
        self,
        material: str,
        size: Point3,
        at: Point3 = (0, 0, 0),
        rot: Point3 = (0, 0, 0),
        *,
        body: Body | None = "hull",
    ) -> None:
        """A gable roof: ridge along Y, ``size`` = width, length, height."""
        x = size[0] / 2
        self.add(material, patches.prism([(-x, 0), (x, 0), (0, size[2])], size[1]), at, rot, body=body)

    def quad(self, material: str, corners: Sequence[Point3], *, fit: bool = True) -> None:
        """A sheet without thickness or body; ``fit``: the texture covers it once."""
        self.add(material, patches.quad(corners, fit=fit), body=None, fit=fit)

    def panel(self, material: str, width: float, height: float, at: Point3, rot: Point3 = (0, 0, 0)) -> None:
        """An upright sheet that faces +Y, its texture fitted once; ``at`` is the middle of its lower edge."""
        x = width / 2
        with self.moved(at, rot):
            self.quad(material, [(x, 0, 0), (-x, 0, 0), (-x, 0, height), (x, 0, height)])

    def body_box(self, size: Point3, at: Point3 = (0, 0, 0), rot: Point3 = (0, 0, 0)) -> None:
        """A collision box without a visible part; ``at`` is the middle of its bottom."""
        matrix, angles = self._pose(at, rot)
        centre = matrix[:3, :3] @ np.array([0, 0, size[2] / 2]) + matrix[:3, 3]
        self._bodies.append(
            BoxBody(center=_rounded(centre), rotation_deg=_rounded(angles), half_extent=_rounded(np.array(size) / 2))
        )

    def body_capsule(self, radius: float, height: float, at: Point3 = (0, 0, 0), rot: Point3 = (0, 0, 0)) -> None:
        """A collision capsule of total ``height``; ``at`` is its lowest point."""
        matrix, angles = self._pose(at, rot)
        centre = matrix[:3, :3] @ np.array([0, 0, height / 2]) + matrix[:3, 3]
        self._bodies.append(
            CapsuleBody(
                center=_rounded(centre),
                rotation_deg=_rounded(angles),
                radius=radius,
                length=round(max(0.0, height - 2 * radius), 3),
            )
        )

    def shape(self) -> BuiltShape:
        """Join all parts. Coordinates are rounded to 0.001 cm so that every machine builds the same bytes."""
        names = list(dict.fromkeys(material for material, _, _ in self._parts))
        whole = patches.join([patch for _, patch, _ in self._parts])
        mesh = Mesh(
            np.round(whole.vertices, 3).astype(np.float32) + np.float32(0),
            whole.faces.astype(np.int32),
            np.round(whole.normals, 4).astype(np.float32) + np.float32(0),
            np.round(whole.uvs, 5).astype(np.float32) + np.float32(0),
            np.concatenate([np.full(len(p.faces), names.index(m), np.int32) for m, p, _ in self._parts]),
        )
        fitted = np.concatenate([np.full(len(p.vertices), fit) for _, p, fit in self._parts])
        return BuiltShape(mesh, names, list(self._bodies), fitted)
