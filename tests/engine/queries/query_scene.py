"""A scene as scripts of these tests ask it: bodies that differ from their triangles, and short calls."""

from __future__ import annotations

from types import ModuleType
from typing import Any

from c4s.records.pack import BoxBody, CapsuleBody, HullBody, SphereBody

FOLDER = "/Game/Q"
BODIES: dict[str, list[Any]] = {
    "table": [
        BoxBody(center=(0, 0, 95), half_extent=(100, 50, 5)),
        *[BoxBody(center=(x, y, 45), half_extent=(5, 5, 45)) for x in (-90, 90) for y in (-40, 40)],
    ],
    "ball": [SphereBody(center=(0, 0, 50), radius=50)],
    "post": [CapsuleBody(center=(0, 0, 100), radius=20, length=160)],
    "wedge": [
        HullBody(vertices=[(-50, -50, 0), (50, -50, 0), (-50, 50, 0), (50, 50, 0), (-50, -50, 100), (-50, 50, 100)])
    ],
    "bare": [],
}


def path_of(name: str) -> str:
    return f"{FOLDER}/SM_{name}.SM_{name}"


class Scene:
    """Short calls of a script."""

    def __init__(self, unreal: ModuleType) -> None:
        self.unreal, self.library = unreal, unreal.SystemLibrary
        self.world = unreal.EditorLevelLibrary.get_editor_world()
        self.tail = (unreal.DrawDebugTrace.NONE,)
        self.statics = [unreal.ObjectTypeQuery.OBJECT_TYPE_QUERY1]

    def put(self, asset: str, location: Any = (0, 0, 0), rotation: Any = (0, 0, 0), scale: Any = (1, 1, 1)) -> Any:
        path = path_of(asset) if asset in BODIES else f"/Engine/BasicShapes/{asset}"
        pitch, yaw, roll = rotation
        actor = self.unreal.EditorLevelLibrary.spawn_actor_from_object(
            self.unreal.load_asset(path),
            self.unreal.Vector(*map(float, location)),
            self.unreal.Rotator(roll=roll, pitch=pitch, yaw=yaw),
        )
        actor.set_actor_scale3d(self.unreal.Vector(*map(float, scale)))
        return actor

    def vector(self, row: Any) -> Any:
        return self.unreal.Vector(*map(float, row))

    def line(
        self,
        start: Any,
        end: Any,
        *,
        triangles: bool = False,
        ignore: Any = (),
        many: bool = False,
        channel: int = 1,
        context: Any = None,
    ) -> Any:
        call = self.library.line_trace_multi if many else self.library.line_trace_single
        return call(
            context or self.world,
            self.vector(start),
            self.vector(end),
            getattr(self.unreal.TraceTypeQuery, f"TRACE_TYPE_QUERY{channel}"),
            triangles,
            list(ignore),
            *self.tail,
        )

    def ball(self, start: Any, end: Any, radius: float, *, triangles: bool = False) -> Any:
        return self.library.sphere_trace_single(
            self.world,
            self.vector(start),
            self.vector(end),
            float(radius),
            self.unreal.TraceTypeQuery.TRACE_TYPE_QUERY1,
            triangles,
            [],
            *self.tail,
        )

    def box(self, start: Any, end: Any, half: Any, yaw: float = 0.0, *, triangles: bool = False) -> Any:
        return self.library.box_trace_single(
            self.world,
            self.vector(start),
            self.vector(end),
            self.vector(half),
            self.unreal.Rotator(yaw=yaw),
            self.unreal.TraceTypeQuery.TRACE_TYPE_QUERY1,
            triangles,
            [],
            *self.tail,
        )

    def capsule(self, start: Any, end: Any, radius: float, half: float, *, triangles: bool = False) -> Any:
        return self.library.capsule_trace_single(
            self.world,
            self.vector(start),
            self.vector(end),
            float(radius),
            float(half),
            self.unreal.TraceTypeQuery.TRACE_TYPE_QUERY1,
            triangles,
            [],
            *self.tail,
        )


def row(vector: Any) -> tuple[float, float, float]:
    return (vector.x, vector.y, vector.z)
