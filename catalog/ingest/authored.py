"""Collision that the author of a file made: nodes named as Unreal imports them, which are never shown.

``UCX_`` is a mesh of convex parts: each connected piece is one, or several where it is concave. ``UBX_`` is a box,
``USP_`` a sphere and ``UCP_`` a capsule. What a box, sphere or capsule node holds is measured; one that is none becomes
a hull, with a note.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

import numpy as np
from scipy.spatial import ConvexHull, QhullError
from scipy.spatial.transform import Rotation

from c4s.geometry.transform import rotator_from_quat
from c4s.records.level import Vector
from c4s.records.pack import BoxBody, CapsuleBody, CollisionBody, SphereBody
from catalog.ingest.automatic import automatic
from catalog.ingest.hulls import hull, joined
from catalog.ingest.surface import SourcePart
from catalog.ingest.surfaces import Points

PREFIX = re.compile(r"(UCX|UBX|USP|UCP)_", re.IGNORECASE)
ROUND_SHARE = 0.1
"""A low-poly sphere or capsule: how far its points may lie off the true surface, by its radius."""
FACETS = 0.7
"""How near to the centre the faces of a sphere may come, by its radius (an icosahedron's: 0.79; a cube's: 0.58)."""
SQUARE = 1e-3
"""How far the sides of a box may be from square: a dot product of unit normals, and corners by its size."""


def split_authored(parts: Sequence[SourcePart]) -> tuple[list[SourcePart], list[CollisionBody], list[str]]:
    """The parts to be shown, the bodies of the others, and notes on nodes that are not the shape their name says."""
    shown = [part for part in parts if not PREFIX.match(part.node)]
    nodes: dict[str, list[SourcePart]] = {}
    for part in parts:
        if PREFIX.match(part.node):
            nodes.setdefault(part.node, []).append(part)
    bodies: list[CollisionBody] = []
    notes = []
    for name, own in nodes.items():
        kind = name[:3].upper()
        points = np.concatenate([part.vertices for part in own])
        made = {"UBX": box, "USP": sphere, "UCP": capsule}[kind](points) if kind != "UCX" else None
        if made is not None:
            bodies.append(made)
            continue
        if kind != "UCX":
            notes.append(f"collision node {name!r} is no {_WORDS[kind]}: its hull is used")
        bodies += [hull(part) for part in automatic(*joined([(name, one.vertices, one.faces) for one in own])).bodies]
    return shown, bodies, notes


_WORDS = {"UBX": "box", "USP": "sphere", "UCP": "capsule"}


def _vector(values: Points) -> Vector:
    x, y, z = (round(float(value), 4) + 0.0 for value in values)
    return x, y, z


def rotator(axes: Points) -> Vector:
    """[pitch, yaw, roll] of a rotation matrix."""
    x, y, z, w = Rotation.from_matrix(axes).as_quat().tolist()
    pitch, yaw, roll = rotator_from_quat((x, y, z, w))
    return round(pitch, 5) + 0.0, round(yaw, 5) + 0.0, round(roll, 5) + 0.0


def box(points: Points) -> BoxBody | None:
    """The box whose corners the points are; None when they are no box."""
    try:
        planes = ConvexHull(points).equations[:, :3]
    except QhullError:
        return None
    axes: list[Points] = []
    for normal in planes:
        along = [abs(float(normal @ axis)) for axis in axes]
        if all(value < SQUARE for value in along):
            axes.append(normal)
        elif not any(value > 1 - SQUARE for value in along):
            return None
    if len(axes) != 3:
        return None
    return framed_box(points, _upright(np.stack(axes, axis=1)))


def framed_box(points: Points, frame: Points) -> BoxBody | None:
    """The box of points that are its corners, along the columns of ``frame``; None when some lie inside it."""
    local = points @ frame
    low, high = local.min(axis=0), local.max(axis=0)
    inner = np.minimum(np.abs(local - low), np.abs(local - high)).max()
    if inner > SQUARE * max(1.0, float(np.max(high - low))):
        return None
    return BoxBody(
        center=_vector(frame @ ((low + high) / 2)), rotation_deg=rotator(frame), half_extent=_vector((high - low) / 2)
    )


def _upright(axes: Points) -> Points:
    """The same three axes in the order and with the signs that turn least from the world's."""
    rest, ordered = [0, 1, 2], []
    for world in np.eye(3):
        best = max(rest, key=lambda i: abs(float(axes[:, i] @ world)))
        rest.remove(best)
        ordered.append(axes[:, best] * (1 if axes[:, best] @ world >= 0 else -1))
    frame = np.stack(ordered, axis=1)
    if np.linalg.det(frame) < 0:
        frame[:, 2] = -frame[:, 2]
    return frame


def sphere(points: Points) -> SphereBody | None:
    """The sphere that the points lie on; None when they do not."""
    centre = (points.min(axis=0) + points.max(axis=0)) / 2
    distances = np.linalg.norm(points - centre, axis=1)
    radius = float(distances.max())
    if radius <= 0 or float(distances.min()) < (1 - ROUND_SHARE) * radius:
        return None
    try:
        planes = ConvexHull(points).equations
    except QhullError:
        return None
    if float(-(planes[:, :3] @ centre + planes[:, 3]).max()) < FACETS * radius:
        return None
    return SphereBody(center=_vector(centre), radius=round(radius, 4))


def capsule(points: Points) -> CapsuleBody | None:
    """The capsule that the points lie on; None when they do not."""
    corners = np.unique(np.round(points, 3), axis=0)
    centred = corners - corners.mean(axis=0)
    axis = np.linalg.svd(centred, full_matrices=False)[2][0]
    axis = axis if axis[np.argmax(np.abs(axis))] > 0 else -axis
    along = centred @ axis
    middle = corners.mean(axis=0) + axis * (along.min() + along.max()) / 2
    offset = corners - middle
    heights = offset @ axis
    across = np.linalg.norm(offset - heights[:, None] * axis, axis=1)
    radius, reach = float(across.max()), float(heights.max())
    if radius <= 0 or reach < radius * (1 - ROUND_SHARE):
        return None
    half = max(0.0, reach - radius)
    off = np.hypot(across, np.abs(heights) - np.clip(np.abs(heights), 0, half)) - radius
    if np.abs(off).max() > ROUND_SHARE * radius:
        return None
    side = np.cross(np.eye(3)[int(np.argmin(np.abs(axis)))], axis)
    side /= np.linalg.norm(side)
    frame = np.stack([side, np.cross(axis, side), axis], axis=1)
    upright = abs(float(axis[2])) > 1 - 1e-6
    return CapsuleBody(
        center=_vector(middle),
        rotation_deg=(0.0, 0.0, 0.0) if upright else rotator(frame),
        radius=round(radius, 4),
        length=round(2 * half, 4),
    )
