"""The navigation mesh of the open level as its engine builds it, and a capsule that walks in it. Runs inside an engine.

``build_mesh`` writes the settings, builds, waits until the mesh has settled and reads the settings back; the other
functions ask the mesh that is there. Points are ``[x, y, z]`` in cm. Nothing is saved: the volume and the mesh that it
makes are for this process.
"""

from __future__ import annotations

import math
import time
from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import Any

import unreal

Point = Sequence[float]
POLL_S = 0.25
PROBES = 64
"""Points that are projected twice, to see whether a build has come to an end."""
NEAR_CM = 100.0
TICK_S = 0.05
RECORD_S = 0.5
FALL_CM = 400.0
AT_CM = 5.0
_SKIN_CM = 1.0


def build_mesh(settings: Mapping[str, float], low: Point, high: Point, settle_s: float) -> dict[str, Any]:
    """Build the mesh within a box: ``{"settled", "reason", "kept", "refused"}``.

    Settings go by the mesh's editor properties. ``kept`` are those that it tells after the build, ``refused`` those
    that it would not take.
    """
    world = _world()
    volume = _volume(low, high)
    system = unreal.NavigationSystemV1.get_navigation_system(world)
    system.on_navigation_bounds_updated(volume)
    data = _data()
    if data is None:
        _rebuild(world)
        data = _data()
    if data is None:
        return {"settled": False, "reason": "the level has no RecastNavMesh", "kept": {}, "refused": sorted(settings)}
    refused = sorted(name for name, value in settings.items() if not _written(data, name, value))
    _rebuild(world)
    settled = _settled(world, low, high, settle_s)
    reason = "" if settled else f"it did not settle in {settle_s:.0f} s"
    return {"settled": settled, "reason": reason, "kept": _kept(data, settings), "refused": refused}


def _world() -> Any:
    return unreal.get_editor_subsystem(unreal.UnrealEditorSubsystem).get_editor_world()


def _actors(kind: Any) -> list[Any]:
    subsystem = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)
    return [actor for actor in subsystem.get_all_level_actors() if isinstance(actor, kind)]


def _data() -> Any:
    found = _actors(unreal.RecastNavMesh)
    return found[0] if found else None


def _volume(low: Point, high: Point) -> Any:
    """The level's only bounds volume, scaled so that its box is the wanted one whatever a fresh one's size is."""
    subsystem = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)
    for volume in _actors(unreal.NavMeshBoundsVolume):
        subsystem.destroy_actor(volume)
    middle = [(a + b) / 2 for a, b in zip(low, high, strict=True)]
    volume = subsystem.spawn_actor_from_class(unreal.NavMeshBoundsVolume, unreal.Vector(*middle))
    _, extent = volume.get_actor_bounds(False)
    wanted = [max(b - a, 1.0) / 2 for a, b in zip(low, high, strict=True)]
    volume.set_actor_scale3d(
        unreal.Vector(*(w / max(e, 1e-6) for w, e in zip(wanted, (extent.x, extent.y, extent.z), strict=True)))
    )
    return volume


def _written(data: Any, name: str, value: float) -> bool:
    try:
        data.set_editor_property(name, float(value))
    except Exception:  # whatever an engine says of a property that it does not have or take
        return False
    return True


def _kept(data: Any, settings: Mapping[str, float]) -> dict[str, float]:
    kept = {}
    for name in settings:
        try:
            kept[name] = float(data.get_editor_property(name))
        except Exception:  # a property that this engine does not tell
            continue
    return kept


def _rebuild(world: Any) -> None:
    unreal.SystemLibrary.execute_console_command(world, "RebuildNavigation")


def _settled(world: Any, low: Point, high: Point, limit_s: float) -> bool:
    """Whether nothing is being built any more and two samplings agree, within the limit."""
    end = time.monotonic() + limit_s
    before = None
    while time.monotonic() < end:
        if not unreal.NavigationSystemV1.is_navigation_being_built_or_locked(world):
            now = _sample(world, low, high)
            if now == before:
                return True
            before = now
        time.sleep(POLL_S)
    return False


def _sample(world: Any, low: Point, high: Point) -> list[Any]:
    side = math.isqrt(PROBES)
    extent = [(high[0] - low[0]) / side / 2, (high[1] - low[1]) / side / 2, (high[2] - low[2]) / 2 + NEAR_CM]
    places = [
        [low[0] + (i + 0.5) * (high[0] - low[0]) / side, low[1] + (j + 0.5) * (high[1] - low[1]) / side, 0.0]
        for i in range(side)
        for j in range(side)
    ]
    return [_projected(world, [x, y, (low[2] + high[2]) / 2], extent) for x, y, _ in places]


def _projected(world: Any, place: Point, extent: Point) -> list[float] | None:
    """The point of the mesh in a box around a place. One outside the box is none: engines answer far ones too."""
    found = unreal.NavigationSystemV1.project_point_to_navigation(
        world, unreal.Vector(*place), None, None, unreal.Vector(*extent)
    )
    if isinstance(found, tuple):
        found = found[-1] if found[0] else None
    if found is None:
        return None
    point = [found.x, found.y, found.z]
    return point if all(abs(a - b) <= e + 1.0 for a, b, e in zip(point, place, extent, strict=True)) else None


def lattice(low: Point, high: Point, pitch_cm: float, stratum_cm: float, phase_cm: float) -> list[float]:
    """Points of the mesh over a lattice within a box: x, y, z in a row, one a place and stratum at most.

    Its places are the multiples of the pitch in the world, and the phase.
    """
    world, made = _world(), []
    extent = (_SKIN_CM, _SKIN_CM, stratum_cm / 2)
    strata = range(math.floor(low[2] / stratum_cm), math.floor(high[2] / stratum_cm) + 1)
    x, y = ([n * pitch_cm + phase_cm for n in _steps(low[axis], high[axis], pitch_cm, phase_cm)] for axis in (0, 1))
    for right in y:
        for ahead in x:
            last = None
            for k in strata:
                point = _projected(world, (ahead, right, (k + 0.5) * stratum_cm), extent)
                if point is not None and point[2] != last:
                    made += point
                    last = point[2]
    return made


def _steps(low: float, high: float, pitch_cm: float, phase_cm: float) -> range:
    return range(math.ceil((low - phase_cm) / pitch_cm), math.floor((high - phase_cm) / pitch_cm) + 1)


def components(points: Sequence[Point]) -> list[int]:
    """Of each point the number of the first one that a complete path joins it with; -1 off the mesh."""
    world = _world()
    found: list[int] = []
    heads: list[int] = []
    for number, point in enumerate(points):
        if _projected(world, point, (NEAR_CM, NEAR_CM, NEAR_CM)) is None:
            found.append(-1)
            continue
        joined = next((head for head in heads if _path(world, point, points[head]) is not None), number)
        if joined == number:
            heads.append(number)
        found.append(joined)
    return found


def distances(start: Point, points: Sequence[Point]) -> list[float]:
    """Length of the path to each point; -1 without a complete one."""
    world = _world()
    found = [_path(world, start, point) for point in points]
    return [-1.0 if path is None else float(path.get_path_length()) for path in found]


def route(start: Point, goal: Point) -> list[list[float]]:
    """Corners of the path from one point to another; none without a complete one."""
    path = _path(_world(), start, goal)
    return [] if path is None else [[point.x, point.y, point.z] for point in path.get_editor_property("path_points")]


def _path(world: Any, start: Point, goal: Point) -> Any:
    """A complete path that ends at its goal; partial ones are how a wall reads as a door."""
    path = unreal.NavigationSystemV1.find_path_to_location_synchronously(
        world, unreal.Vector(*start), unreal.Vector(*goal)
    )
    if path is None or not path.is_valid() or path.is_partial():
        return None
    points = path.get_editor_property("path_points")
    if len(points) < 2:
        return None
    last = points[len(points) - 1]
    return path if math.dist((last.x, last.y, last.z), goal) <= NEAR_CM else None


def walk(corners: Sequence[Point], settings: Mapping[str, float], speed_cm_s: float, most_s: float) -> dict[str, Any]:
    """Follow a route with a swept capsule: ``{"trace", "left"}``, every half second and at the end.

    Each tick goes straight for the next corner, slides along what is in the way, and stands on what is below.
    """
    world = _world()
    lengths = [math.dist(a, b) for a, b in pairwise(corners)]
    after = [sum(lengths[number:]) for number in range(len(lengths) + 1)]
    at = _grounded(world, corners[0], settings["step_cm"]) or list(corners[0])
    corner, trace, left = 1, [list(at)], [after[0]]
    every = round(RECORD_S / TICK_S)
    for number in range(1, int(most_s / TICK_S) + 1):
        while math.dist(at[:2], corners[corner][:2]) <= AT_CM and corner < len(corners) - 1:
            corner += 1
        away = math.dist(at[:2], corners[corner][:2])
        if away > AT_CM:
            share = min(speed_cm_s * TICK_S, away) / away
            move = [(corners[corner][axis] - at[axis]) * share for axis in (0, 1)]
            at = _moved(world, at, move, settings)
        gone = away <= AT_CM and corner == len(corners) - 1
        if gone or number % every == 0:
            trace.append(list(at))
            left.append(math.dist(at[:2], corners[corner][:2]) + after[corner])
        if gone:
            break
    return {"trace": trace, "left": left}


def _moved(world: Any, at: Sequence[float], move: Sequence[float], settings: Mapping[str, float]) -> list[float]:
    """Where a tick leads: as far as the capsule is not stopped, then along what stops it."""
    place = list(at)
    for _ in range(2):
        share, normal = _swept(world, place, move, settings)
        place = [place[0] + move[0] * share, place[1] + move[1] * share, place[2]]
        if normal is None:
            break
        level = math.hypot(*normal)
        if level < 0.2:
            break
        into = (move[0] * normal[0] + move[1] * normal[1]) / (level * level)
        move = [(move[axis] - into * normal[axis]) * (1 - share) for axis in (0, 1)]
    return _grounded(world, place, settings["step_cm"]) or list(at)


def _swept(
    world: Any, place: Sequence[float], move: Sequence[float], settings: Mapping[str, float]
) -> tuple[float, Sequence[float] | None]:
    """The share of a move that is free, and the level part of the normal of what ends it."""
    radius, step, height = settings["radius_cm"] - _SKIN_CM, settings["step_cm"], settings["height_cm"]
    half = max((height - step) / 2, radius)
    z = place[2] + height - half
    hit = unreal.SystemLibrary.capsule_trace_single(
        world,
        unreal.Vector(place[0], place[1], z),
        unreal.Vector(place[0] + move[0], place[1] + move[1], z),
        radius,
        half,
        unreal.TraceTypeQuery.TRACE_TYPE_QUERY1,
        False,
        [],
        unreal.DrawDebugTrace.NONE,
    )
    told = _hit(hit)
    if told is None:
        return 1.0, None
    return (0.0 if told[1] else float(told[2])), (told[6].x, told[6].y)


def _grounded(world: Any, place: Sequence[float], step_cm: float) -> list[float] | None:
    """The place on the highest surface within a step; None where there is none near below."""
    told = _hit(
        unreal.SystemLibrary.line_trace_single(
            world,
            unreal.Vector(place[0], place[1], place[2] + step_cm),
            unreal.Vector(place[0], place[1], place[2] - FALL_CM),
            unreal.TraceTypeQuery.TRACE_TYPE_QUERY1,
            False,
            [],
            unreal.DrawDebugTrace.NONE,
        )
    )
    return None if told is None or told[1] else [place[0], place[1], float(told[5].z)]


def _hit(found: Any) -> Any:
    """What a trace met as a tuple; None for nothing, whichever way an engine answers."""
    if isinstance(found, tuple):
        found = found[-1] if found[0] else None
    told = None if found is None else found.to_tuple()
    return told if told is not None and told[0] else None
