"""The whole measurement of a scene over the navigation meshes of an engine: builds, projection, routes, walks."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np

from c4s.collision import scene_bodies
from c4s.collision.mesh_body import Array
from c4s.collision.scene import SceneBodies
from c4s.navigation.mesh import NavigationMesh, SpaceMesh
from c4s.navigation.picture import floors_of, map_of
from c4s.navigation.projection import Projection, project
from c4s.navigation.selection import Route, Selection, half_extent_cm, select
from c4s.navigation.settings import NavigationSettings
from c4s.navigation.solids import navigation_bounds
from c4s.navigation.space import SpaceTooLarge, build_space
from c4s.navigation.targets import WalkTarget, pool, targets_of
from c4s.navigation.walker import BodyWorld, judge_walk, walk
from c4s.protocol.navigation import (
    AGREED_A,
    AGREED_CELLS,
    COMPONENT_PITCH_CM,
    MOST_BUILDS,
    PROJECTION_PITCH_CM,
    STRATUM_CM,
    Withheld,
    arrival_radius_cm,
)
from c4s.records.navigation import (
    LETTER,
    LETTERS,
    SCENERY,
    BuildRecord,
    Fall,
    NavigationEvidence,
    NavigationFloors,
    NavigationMap,
    PlaceRecord,
    TargetRecord,
    Triple,
    WalkRecord,
)

MOST_COMPONENTS = 100


class NotBuilt(Exception):
    """A navigation mesh could not be made or did not settle; ``reason`` is one of the protocol's."""

    def __init__(self, reason: Withheld, detail: str) -> None:
        self.reason: Withheld = reason
        super().__init__(detail)


class NavigationEngine(Protocol):
    """What makes navigation meshes of one scene, and lets a capsule walk in it."""

    def build(self, number: int) -> NavigationMesh:
        """Build ``number`` (from 1), from nothing. Raises ``NotBuilt``."""
        ...

    def kept(self) -> dict[str, float]:
        """The settings that the mesh says it has."""
        ...

    def walk(self, route: Array) -> tuple[Array, Array]:
        """Follow a route: feet of the capsule every half second, and what was left to go."""
        ...


class SpaceEngine:
    """Walkable spaces of the bodies of a snapshot. Every other build reads the bodies backwards: it must not matter."""

    def __init__(self, scene: SceneBodies, settings: NavigationSettings) -> None:
        self._scene, self._settings = scene, settings
        self._world: BodyWorld | None = None

    def build(self, number: int) -> SpaceMesh:
        """See ``NavigationEngine``."""
        bodies = self._scene.bodies if number % 2 else self._scene.bodies[::-1]
        try:
            return SpaceMesh(build_space(bodies, navigation_bounds(self._scene), self._settings))
        except SpaceTooLarge as error:
            raise NotBuilt("navigation_too_large", str(error)) from error

    def kept(self) -> dict[str, float]:
        """See ``NavigationEngine``."""
        return self._settings.plain()

    def walk(self, route: Array) -> tuple[Array, Array]:
        """See ``NavigationEngine``."""
        if self._world is None:
            self._world = BodyWorld(self._scene.bodies, self._settings)
        return walk(self._world, route, self._settings)


@dataclass(frozen=True)
class Falls:
    """Where the targets of one build fall."""

    record: BuildRecord
    mesh: NavigationMesh
    cells: Array
    """Lattice points for projection."""
    projections: list[Projection]
    falls: list[Fall]
    main: Array
    """Lattice points of the largest component."""


def measure_snapshot(snapshot: Mapping[str, Any], settings: NavigationSettings | None = None) -> NavigationEvidence:
    """The measurement of a snapshot over its own collision bodies."""
    settings = settings or NavigationSettings()
    scene = scene_bodies(snapshot)
    return measure(snapshot, scene, SpaceEngine(scene, settings), settings, made_by="walkable_space")


def measure(
    snapshot: Mapping[str, Any],
    scene: SceneBodies,
    engine: NavigationEngine,
    settings: NavigationSettings,
    made_by: Any,
) -> NavigationEvidence:
    """Build until two builds in a row agree, then choose routes and walk them. What it comes to is not decided here."""
    told = snapshot.get("c4s")
    own: Mapping[str, Any] = told if isinstance(told, Mapping) else {}
    targets = targets_of(snapshot, scene)
    wanted = pool(targets)
    names = [str(actor.get("name") or index) for index, actor in enumerate(snapshot.get("actors") or [])]
    made: dict[str, Any] = {
        "engine": str(own.get("engine") or ""),
        "engine_version": str(own.get("engine_version") or ""),
        "made_by": made_by,
        "asked": settings.plain(),
        "targets": target_records(targets),
        "unknown": {names[index]: reason for index, reason in scene.unresolved.items()},
    }
    builds: list[Falls] = []
    fault: NotBuilt | None = None
    for number in range(1, MOST_BUILDS + 1):
        try:
            builds.append(_fallen(engine.build(number), wanted))
        except NotBuilt as error:
            fault = error
            break
        if len(builds) > 1 and agree(builds[-2].record, builds[-1].record):
            break
    records = [build.record for build in builds]
    if fault is not None:
        records.append(BuildRecord(settled=False, reason=str(fault)))
        return NavigationEvidence(**made, kept=engine.kept(), builds=records, fault=fault.reason, detail=str(fault))
    last = builds[-1]
    bounds = last.mesh.bounds_cm()
    chosen = select(last.mesh, bounds, last.cells, last.main, _reached(wanted, last)) if bounds else Selection()
    walks = [_walked(engine, route) for route in chosen.routes]
    return NavigationEvidence(
        **made,
        kept=engine.kept(),
        builds=records,
        bounds_cm=None if bounds is None else (_triple(bounds[0]), _triple(bounds[1])),
        ground_cm=chosen.ground_cm,
        anchor_cm=None if chosen.anchor is None else _triple(chosen.anchor),
        small=chosen.small,
        places=[_place(last, projection) for projection in last.projections],
        walks=walks,
        map=_map(last),
        floors=_floors(last),
    )


def approachable(falls: Sequence[Fall]) -> float | None:
    """A: the share of the floor-level pool that a way leads to; None without a pool (eq. eus-a)."""
    floor = [fall for fall in falls if fall not in SCENERY]
    return sum(fall == "connected" for fall in floor) / len(floor) if floor else None


def has_arrived(evidence: NavigationEvidence, one: WalkRecord) -> bool:
    """Whether a walk ended near its goal, by the radius of its scene."""
    if evidence.bounds_cm is None:
        return False
    radius = arrival_radius_cm(half_extent_cm((np.array(evidence.bounds_cm[0]), np.array(evidence.bounds_cm[1]))))
    return judge_walk(np.array(one.trace_cm), np.array(one.left_cm), np.array(one.goal_cm), radius).arrived


def agree(before: BuildRecord, after: BuildRecord) -> bool:
    """Whether two builds in a row certify each other (EU18); the count is relative to the larger one (E07)."""
    one, two = ([LETTERS[letter] for letter in build.falls] for build in (before, after))
    cells = max(before.cells, after.cells)
    return (
        before.settled
        and after.settled
        and abs((approachable(one) or 0.0) - (approachable(two) or 0.0)) <= AGREED_A + 1e-9
        and abs(before.cells - after.cells) <= AGREED_CELLS * cells
    )


def _fallen(mesh: NavigationMesh, wanted: Sequence[WalkTarget]) -> Falls:
    cells = mesh.lattice(PROJECTION_PITCH_CM, STRATUM_CM)
    coarse = mesh.lattice(COMPONENT_PITCH_CM, STRATUM_CM)
    if not len(coarse):
        coarse = cells
    of = mesh.components(coarse)
    sizes = np.bincount(of[of >= 0]) if (of >= 0).any() else np.zeros(0, np.int64)
    main = coarse[of == sizes.argmax()] if len(sizes) else np.zeros((0, 3))
    projections = project(wanted, cells)
    rows = [one.cell for one in projections if one.level == "storey"]
    linked: dict[int, bool] = {}
    if rows:
        group = mesh.components(np.concatenate([main[:1], cells[rows]]))
        linked = {cell: bool(there) for cell, there in zip(rows, group[1:] == group[0], strict=True)}
    falls: list[Fall] = [_fall(one, linked) for one in projections]
    record = BuildRecord(
        settled=True,
        cells=len(cells),
        component_cells=[int(size) for size in np.sort(sizes)[::-1][:MOST_COMPONENTS] if size],
        falls="".join(LETTER[fall] for fall in falls),
        area_m2=round(mesh.space.area_m2, 3) if isinstance(mesh, SpaceMesh) else None,
    )
    return Falls(record, mesh, cells, projections, falls, main)


def _fall(projection: Projection, linked: Mapping[int, bool]) -> Fall:
    if projection.level == "storey":
        return "connected" if linked[projection.cell] else "unconnected"
    return "unreached" if projection.level == "none" else projection.level


def _place(last: Falls, projection: Projection) -> PlaceRecord | None:
    if projection.level != "storey":
        return None
    return PlaceRecord(point_cm=_triple(last.cells[projection.cell]), sample=projection.sample)


def _reached(wanted: Sequence[WalkTarget], last: Falls) -> list[tuple[str, Array]]:
    """Approachable targets by name, with the cell of each."""
    return [
        (target.name, last.cells[projection.cell])
        for target, projection, fall in zip(wanted, last.projections, last.falls, strict=True)
        if fall == "connected"
    ]


def _walked(engine: NavigationEngine, route: Route) -> WalkRecord:
    trace, left = engine.walk(route.points)
    return WalkRecord(
        start=route.start,
        goal=route.goal,
        goal_cm=_triple(route.points[-1]),
        length_cm=round(route.length_cm, 2),
        route_cm=[_triple(point) for point in route.points],
        trace_cm=[_triple(point) for point in trace],
        left_cm=[round(float(value), 2) for value in left],
    )


def _map(last: Falls) -> NavigationMap | None:
    return map_of(last.mesh.space, last.main) if isinstance(last.mesh, SpaceMesh) else None


def _floors(last: Falls) -> NavigationFloors | None:
    return floors_of(last.mesh.space, last.main) if isinstance(last.mesh, SpaceMesh) else None


def target_records(targets: Sequence[WalkTarget]) -> list[TargetRecord]:
    """Targets as evidence tells them."""
    return [_target_record(target) for target in targets]


def _target_record(target: WalkTarget) -> TargetRecord:
    return TargetRecord(
        index=target.index,
        name=target.name,
        label=target.label,
        left=target.left,
        low_cm=_triple(target.low),
        high_cm=_triple(target.high),
        hidden=target.hidden,
        named_out=target.named_out,
    )


def _triple(point: Array) -> Triple:
    x, y, z = (round(float(part), 2) for part in point)
    return x, y, z
