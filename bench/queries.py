"""One trace, sweep or overlap of a script among 6,700 actors, one of which moved just before (CPU time, median)."""

from __future__ import annotations

import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import trimesh

from bench.row import Row
from c4s.engine.headless.process.boot import boot
from c4s.engine.headless.world import state

ACTORS, CALLS, GOAL_MS = 6_700, 200, 1.0
SHAPES = ("Cube", "Sphere", "Cone", "Cylinder")


def _level(unreal: ModuleType) -> list[Any]:
    """Basic shapes of 1 m, one on each 4 m of a square, turned and at several heights."""
    random = np.random.default_rng(1)
    actors = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)
    side = round(ACTORS**0.5) + 1
    return [
        actors.spawn_actor_from_object(
            unreal.load_asset(f"/Engine/BasicShapes/{SHAPES[i % len(SHAPES)]}"),
            unreal.Vector(400.0 * (i % side), 400.0 * (i // side), float(random.uniform(50, 500))),
            unreal.Rotator(yaw=float(random.uniform(0, 360))),
        )
        for i in range(ACTORS)
    ]


def _median_ms(actors: list[Any], unreal: ModuleType, call: Callable[[Any], Any], moves: bool = True) -> float:
    spent = []
    for actor in actors[:: len(actors) // CALLS][:CALLS]:
        before = time.process_time()
        if moves:
            actor.set_actor_location(actor.get_actor_location() + unreal.Vector(1, 0, 0), False, False)
        assert call(actor) is not None
        spent.append(time.process_time() - before)
    return 1000 * sorted(spent)[len(spent) // 2]


def rows() -> list[Row]:
    """Ours, and trimesh's Embree rays over all triangles at once (a scene that never changes)."""
    with tempfile.TemporaryDirectory() as folder:
        unreal = boot([], Path(folder))
        actors, library = _level(unreal), unreal.SystemLibrary
        world = unreal.get_editor_subsystem(unreal.UnrealEditorSubsystem).get_editor_world()
        channel, kinds = unreal.TraceTypeQuery.TRACE_TYPE_QUERY1, [unreal.ObjectTypeQuery.OBJECT_TYPE_QUERY1]
        up, none = unreal.Vector(0, 0, 1000), unreal.DrawDebugTrace.NONE

        def trace(kind: str, *size: Any, triangles: bool = False) -> Callable[[Any], Any]:
            call = getattr(library, f"{kind}_trace_single")
            return lambda actor: call(
                world,
                actor.get_actor_location() + up,
                actor.get_actor_location() - up,
                *size,
                channel,
                triangles,
                [],
                none,
            )

        calls: dict[str, Callable[[Any], Any]] = {
            "line trace": trace("line"),
            "line trace, complex": trace("line", triangles=True),
            "sphere sweep": trace("sphere", 30.0),
            "box sweep": trace("box", unreal.Vector(30, 20, 10), unreal.Rotator(yaw=20)),
            "capsule sweep": trace("capsule", 30.0, 90.0),
            "sphere overlap": lambda actor: library.sphere_overlap_actors(
                world, actor.get_actor_location(), 100.0, kinds, None, []
            ),
        }
        trace("line")(actors[0])
        ours = {name: _median_ms(actors, unreal, call) for name, call in calls.items()}
        rival = _rival_ms(actors)
    return [
        Row(
            f"{name}, {ACTORS:,} actors",
            value,
            f"under {GOAL_MS:g} ms",
            value < GOAL_MS,
            "ms",
            *(("trimesh rays (Embree)", rival, rival / value) if name == "line trace, complex" else ()),
        )
        for name, value in ours.items()
    ]


def _rival_ms(actors: list[Any]) -> float:
    parts = []
    for drawable in state.world().drawables():
        mesh = state.world().store.mesh(drawable.mesh)
        parts.append(trimesh.Trimesh(mesh.vertices, mesh.faces, process=False).apply_transform(drawable.matrix))
    scene = trimesh.util.concatenate(parts)
    assert isinstance(scene, trimesh.Trimesh)
    down = np.array([[0.0, 0.0, -1.0]])
    spent = []
    for actor in actors[:: len(actors) // CALLS][:CALLS]:
        place = actor.get_actor_location()
        before = time.process_time()
        assert len(scene.ray.intersects_location([[place.x + 1, place.y + 1, 1000.0]], down, multiple_hits=False)[0])
        spent.append(time.process_time() - before)
    return 1000 * sorted(spent)[len(spent) // 2]
