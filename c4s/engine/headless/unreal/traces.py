"""Line traces against the triangles of meshes with collision, and their hit results."""

from __future__ import annotations

# ruff: noqa: RUF012  (each class declares its table of properties; no table is ever changed)
import math
from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from c4s.engine.headless.pose import Pose, compose
from c4s.engine.headless.state import world
from c4s.engine.headless.unreal.actors import Actor
from c4s.engine.headless.unreal.components import InstancedStaticMeshComponent, StaticMeshComponent
from c4s.engine.headless.unreal.containers import Name
from c4s.engine.headless.unreal.core import Prop, public
from c4s.engine.headless.unreal.structs import ClosedStruct, Vector

_EDGE = 1e-9


def _shut(kind: str, default: Any) -> Prop:
    return Prop(kind, default, attribute=False, scripts=False)


@public
class HitResult(ClosedStruct):
    """What a trace hit; ``to_tuple()`` gives the fields in Unreal's order (there are no attributes)."""

    _fields = {
        "blocking_hit": _shut("bool", False), "initial_overlap": _shut("bool", False), "time": _shut("float", 1.0),
        "distance": _shut("float", 0.0), "location": _shut("Vector", Vector), "impact_point": _shut("Vector", Vector),
        "normal": _shut("Vector", Vector), "impact_normal": _shut("Vector", Vector), "phys_mat": _shut("None", None),
        "hit_actor": _shut("Actor | None", None), "hit_component": _shut("PrimitiveComponent | None", None),
        "hit_bone_name": _shut("Name", Name), "bone_name": _shut("Name", Name), "hit_item": _shut("int", -1),
        "element_index": _shut("int", -1), "face_index": _shut("int", -1), "trace_start": _shut("Vector", Vector),
        "trace_end": _shut("Vector", Vector)}

    def to_dict(self) -> dict[str, Any]:
        """All fields by name."""
        return {n: self.__dict__[n] for n in self._fields}

    def copy(self) -> Any:
        """A copy."""
        made = HitResult.__new__(HitResult)
        made.__dict__.update(self.__dict__)
        return made

    def __repr__(self) -> str:
        return f"<Struct 'HitResult' {{{', '.join(f'{n}: {v!r}' for n, v in self.to_dict().items())}}}>"


def _targets(ignored: Sequence[Actor]) -> Iterator[tuple[Actor, StaticMeshComponent, Pose]]:
    for actor in world().actor_list():
        if actor in ignored:
            continue
        for component in actor._components:
            if isinstance(component, StaticMeshComponent) and component._mesh is not None and component._collides():
                pose = component._world_pose()
                instanced = isinstance(component, InstancedStaticMeshComponent)
                for each in [compose(i, pose) for i in component._instances] if instanced else [pose]:
                    yield actor, component, each


def _meets_box(start: Vector, step: Vector, origin: Sequence[float], extent: Sequence[float]) -> bool:
    near, far = 0.0, 1.0
    for s, d, o, e in zip(start._triple(), step._triple(), origin, extent, strict=True):
        if abs(d) < _EDGE:
            if abs(s - o) > e + _EDGE:
                return False
            continue
        a, b = sorted(((o - e - s) / d, (o + e - s) / d))
        near, far = max(near, a), min(far, b)
    return near <= far + _EDGE


def _first_triangle(component: StaticMeshComponent, pose: Pose, start: Vector,
                    step: Vector) -> tuple[float, int, tuple[float, float, float]] | None:
    """Fraction of the way, triangle and unit normal (towards the start) of the first hit (Moeller-Trumbore)."""
    shown: Any = component._mesh
    mesh = shown._geometry()
    if mesh is None:
        return None
    matrix = pose.matrix()
    points = mesh.vertices.astype(np.float64) @ matrix[:3, :3].T + matrix[:3, 3]
    a, b, c = (points[mesh.faces[:, i]] for i in range(3))
    origin, direction = np.array(start._triple()), np.array(step._triple())
    across = np.cross(direction, c - a)
    det = np.einsum("ij,ij->i", b - a, across)
    safe = np.where(np.abs(det) < 1e-14, np.inf, det)
    offset = origin - a
    u = np.einsum("ij,ij->i", offset, across) / safe
    turned = np.cross(offset, b - a)
    v = turned @ direction / safe
    t = np.einsum("ij,ij->i", turned, c - a) / safe
    hit = np.isfinite(safe) & (u >= -_EDGE) & (v >= -_EDGE) & (u + v <= 1 + _EDGE) & (t >= 0) & (t <= 1)
    if not hit.any():
        return None
    face = int(np.argmin(np.where(hit, t, np.inf)))
    normal = np.cross(b[face] - a[face], c[face] - a[face])
    normal /= np.linalg.norm(normal)
    if normal @ direction > 0:
        normal = -normal
    return float(t[face]), face, (float(normal[0]), float(normal[1]), float(normal[2]))


def line_hits(start: Vector, end: Vector, ignored: Sequence[Actor]) -> list[HitResult]:
    """First hit of each mesh along the line, nearest first."""
    step = end - start
    found: list[HitResult] = []
    for actor, component, pose in _targets(ignored):
        bounds = StaticMeshComponent._local_bounds(component)
        if bounds is None or not _meets_box(start, step, *pose.box(*bounds)):
            continue
        first = _first_triangle(component, pose, start, step)
        if first is None:
            continue
        fraction, face, normal = first
        place = start + step * fraction
        found.append(HitResult(
            blocking_hit=True, time=fraction, distance=fraction * math.hypot(*step._triple()), location=place,
            impact_point=place, normal=Vector(*normal), impact_normal=Vector(*normal), hit_actor=actor,
            hit_component=component, face_index=face, trace_start=start, trace_end=end))
    return sorted(found, key=lambda hit: float(hit.to_tuple()[2]))
