"""The output format of the benchmark's own ``measure_reachability.py`` (``ue_editor_reachability`` 0.1), out and in.

Out: a measurement of ours as that probe writes one, so that the published scorer reads it. Its eligible actors are our
floor-level pool, so its share is our A, and ``walk_validation`` is our W. Under our own key ``c4s`` stands the whole
measurement. Points are ``[x, y, z]`` in cm.

In: an output of ours is its measurement again. An output of the probe itself is a measurement of one build without
walks: our rules for the pool and for storeys are applied to the points that it found, so the verifier can tell its A,
and withholds the score for what the probe does not tell.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, Final

from c4s.collision import scene_bodies
from c4s.errors import BadInput
from c4s.navigation.measuring import agree, has_arrived, target_records
from c4s.navigation.settings import NavigationSettings, settings_told
from c4s.navigation.targets import targets_of
from c4s.protocol.navigation import ABOVE_CM, BELOW_CM, COMPONENT_PITCH_CM, REACH_CM
from c4s.records.navigation import LETTER, LETTERS, SCENERY, BuildRecord, Fall, NavigationEvidence, TargetRecord

KIND: Final = "ue_editor_reachability"
VERSION: Final = "0.1.1"
_VERSIONS: Final = "0.1."
_INELIGIBLE: Final = {
    "no_collision": "collision_disabled",
    "kind": "no_collision_class",
    "effect": "no_collision_class",
}
"""The probe's words for two of our reasons; surfaces and scenery are reasons that it does not have."""
_LEFT: Final = {"collision_disabled": "no_collision", "no_collision_class": "kind"}
Row = dict[str, Any]


def published_output(evidence: NavigationEvidence, snapshot: Mapping[str, Any]) -> dict[str, Any]:
    """A measurement of a scene as the published probe writes one.

    Raises:
        BadInput: the measurement is of another scene, or is an older one that does not tell where footprints fell.
    """
    map_path = str(snapshot.get("map_path") or "")
    rows = _rows(evidence, snapshot)
    eligible = [row for row in rows if row["eligible"]]
    last = next((build for build in reversed(evidence.builds) if build.settled), BuildRecord(settled=False))
    settled = evidence.fault is None and len(evidence.builds) > 1 and agree(*evidence.builds[-2:])
    cells = sum(last.component_cells)
    made = "c4s.walkable_space" if evidence.made_by == "walkable_space" else "RecastNavMesh"
    output: dict[str, Any] = {
        "schema_version": VERSION,
        "measurement_type": KIND,
        "map_path": map_path,
        "runtime_provenance": {
            "project_file_path": "",
            "engine_version": evidence.engine_version,
            "map_path": map_path,
        },
        "navmesh": {
            "actor_path": None if last.cells == 0 else f"{map_path}:{made}",
            "class": made,
            "agent_radius_requested_cm": evidence.asked.get("radius_cm"),
            "agent_radius_properties_set": ["agent_radius"] if "radius_cm" in evidence.kept else [],
            "agent_radius_errors": [],
            "rebuild": [{"method": evidence.made_by, "status": "called"} for _ in evidence.builds],
            "parameters_after_rebuild": NavigationSettings(**evidence.kept).properties() if evidence.kept else {},
            "bounds_min_cm": None if evidence.bounds_cm is None else [*evidence.bounds_cm[0]],
            "bounds_max_cm": None if evidence.bounds_cm is None else [*evidence.bounds_cm[1]],
            "bounds_source": "unavailable" if evidence.bounds_cm is None else "navmesh_actor_bounds",
            "settle": _settle(evidence, settled),
        },
        "samples": {
            "seed": 0,
            "requested_count": cells,
            "accepted_count": cells,
            "projection_attempts": cells,
            "projection_extent_cm": COMPONENT_PITCH_CM,
            "points_cm": [],
        },
        "components": {
            "count": len(last.component_cells),
            "sizes": last.component_cells,
            "largest_size": max(last.component_cells, default=0),
            "largest_representative_cm": None if evidence.anchor_cm is None else [*evidence.anchor_cm],
            "path_endpoint_tolerance_cm": REACH_CM,
            "cost": {
                "query_batches": cells,
                "path_queries": cells,
                "query_budget": cells,
                "query_budget_unit": "sample_batches",
                "query_budget_truncated": False,
            },
            "spread": [
                {
                    "settled": build.settled,
                    "settle_path": "conservative",
                    "count": len(build.component_cells),
                    "largest_size": max(build.component_cells, default=0),
                }
                for build in evidence.builds
            ],
        },
        "actors": {row["actor_path"]: row for row in rows},
        "diagnostics": {
            "status": "success" if settled else "partial",
            "level_actor_count": len(rows),
            "eligible_actor_count": len(eligible),
            "projected_actor_count": sum(row["projected_point_cm"] is not None for row in eligible),
            "connected_actor_count": sum(row["connected"] is True for row in eligible),
            "unresolved": [{"what": name, "reason": why} for name, why in evidence.unknown.items()],
            "measurement_errors": [],
            "options": {"agent_radius_cm": evidence.asked.get("radius_cm"), "projection_extent_cm": REACH_CM},
        },
    }
    if evidence.walks:
        arrived = sum(has_arrived(evidence, one) for one in evidence.walks)
        output["walk_validation"] = {
            "completed_route_fraction": arrived / len(evidence.walks),
            "completed_route_count": arrived,
            "route_count": len(evidence.walks),
        }
    return {**output, "c4s": {"navigation": evidence.plain()}}


def _settle(evidence: NavigationEvidence, settled: bool) -> dict[str, Any]:
    told = {
        "settled": settled,
        "method": "consecutive_builds_agree",
        "path": "conservative",
        "probe_count": max((build.cells for build in evidence.builds), default=0),
        "wait_s": 0.0,
        "passes": [
            {"attempt": number, "sample_count": build.cells, "remaining_build_tasks": None}
            for number, build in enumerate(evidence.builds)
        ],
        "remaining_build_tasks_reported": None,
        "fallback_reason": None,
    }
    return told if settled else {**told, "reason": evidence.detail or "no two builds in a row agree"}


def _rows(evidence: NavigationEvidence, snapshot: Mapping[str, Any]) -> list[Row]:
    """A row an actor, in scene order."""
    actors = snapshot.get("actors") or []
    if [target.name for target in evidence.targets] != [_name(actor, at) for at, actor in enumerate(actors)]:
        raise BadInput("the measurement is of another scene: its actors are not the snapshot's")
    falls = next((build.falls for build in reversed(evidence.builds) if build.settled), "")
    if falls and not evidence.places:
        raise BadInput("this measurement does not tell where footprints fell", todo="measure the scene anew")
    fallen = iter(zip(falls, evidence.places, strict=True) if falls else ())
    return [
        _row(actor, target, None if target.left else next(fallen, None))
        for actor, target in zip(actors, evidence.targets, strict=True)
    ]


def _row(actor: Mapping[str, Any], target: TargetRecord, fallen: Any) -> Row:
    fall: Fall | None = None if fallen is None else LETTERS[fallen[0]]
    reason = _INELIGIBLE.get(target.left, target.left) or (fall if fall in SCENERY else None)
    place = None if fallen is None or reason else fallen[1]
    return {
        "actor_path": str(actor.get("actor_path") or target.name),
        "label": target.label,
        "class": str(actor.get("class") or "").rpartition(".")[2],
        "eligible": reason is None,
        "ineligible_reason": reason,
        "projected_point_cm": None if place is None else [*place.point_cm],
        "projection_offset_index": None if place is None else place.sample,
        "connected": None if place is None else fall == "connected",
    }


def _name(actor: Any, at: int) -> str:
    return str(actor.get("name") or at) if isinstance(actor, Mapping) else str(at)


def read_published(output: Any, snapshot: Mapping[str, Any], *, where: str = "") -> NavigationEvidence:
    """The measurement that an output of the published probe, or of ours in its format, is of a scene.

    Raises:
        BadInput: it is no such output, is of another scene, or its rows are not what its own ``c4s`` part comes to.
    """
    if not isinstance(output, Mapping) or output.get("measurement_type") != KIND:
        raise BadInput(f"no output of the reachability probe: measurement_type is not {KIND}", where=where)
    version = output.get("schema_version")
    if not isinstance(version, str) or not version.startswith(_VERSIONS):
        raise BadInput(f"the reachability output is of version {version!r}, not {_VERSIONS}x", where=where)
    actors, diagnostics = output.get("actors"), _part(output, "diagnostics")
    if not isinstance(actors, Mapping):
        raise BadInput("the reachability output has no actors", where=where)
    if diagnostics.get("status") == "error":
        raise BadInput(f"the probe failed: {str(diagnostics.get('error'))[:200]}", where=where)
    own = _part(output, "c4s").get("navigation")
    if own is None:
        return _foreign(output, actors, snapshot, where)
    evidence = NavigationEvidence.parse(own, where=where)
    if {row["actor_path"]: row for row in _rows(evidence, snapshot)} != actors:
        raise BadInput("the rows of actors are not what the c4s part of this output says", where=where)
    return evidence


def _part(output: Mapping[str, Any], name: str) -> Mapping[str, Any]:
    found = output.get(name)
    return found if isinstance(found, Mapping) else {}


def _foreign(
    output: Mapping[str, Any], actors: Mapping[str, Any], snapshot: Mapping[str, Any], where: str
) -> NavigationEvidence:
    """What the probe itself found, with our pool and storeys."""
    scene = scene_bodies(snapshot)
    rows = {str(path).rpartition(".")[2]: row for path, row in actors.items() if isinstance(row, Mapping)}
    targets: list[TargetRecord] = []
    falls: list[Fall] = []
    unanswered = 0
    for target in target_records(targets_of(snapshot, scene)):
        row = rows.get(target.name)
        if row is None:
            raise BadInput(f"the output does not tell of actor {target.name}: it is of another scene", where=where)
        left = target.left if row.get("eligible") is True else _LEFT.get(str(row.get("ineligible_reason")), "no_target")
        targets.append(target.model_copy(update={"left": target.left or left}))
        if not targets[-1].left:
            fall = _fall(row, target, where)
            unanswered += fall is None
            falls.append(fall or "unconnected")
    navmesh, components = _part(output, "navmesh"), _part(output, "components")
    settle = _part(navmesh, "settle")
    reason = str(settle.get("reason") or "") if settle.get("settled") is not True else ""
    if unanswered:
        reason = f"no path was asked for {unanswered} actors"
    settled = settle.get("settled") is True and not unanswered
    build = BuildRecord.parse(
        {
            "settled": settled,
            "reason": reason,
            "cells": _part(output, "samples").get("accepted_count") or 0,
            "component_cells": components.get("sizes") or [],
            "falls": "".join(LETTER[fall] for fall in falls),
        },
        where=where,
    )
    told: dict[str, Any] = {} if settled else {"fault": "not_settled", "detail": reason}
    return NavigationEvidence(
        engine="unreal",
        engine_version=str(_part(output, "runtime_provenance").get("engine_version") or ""),
        made_by="published_probe",
        asked=NavigationSettings().plain(),
        kept=settings_told(_part(navmesh, "parameters_after_rebuild")),
        targets=targets,
        builds=[build],
        unknown={_name(snapshot["actors"][index], index): why for index, why in scene.unresolved.items()},
        **told,
    )


def _fall(row: Mapping[str, Any], target: TargetRecord, where: str) -> Fall | None:
    """Where an eligible actor falls; None where the probe found a point and asked for no path."""
    point = row.get("projected_point_cm")
    if point is None:
        return "unreached"
    if not isinstance(point, Sequence) or len(point) != 3 or any(type(part) not in (int, float) for part in point):
        raise BadInput(f"the point of actor {target.name} is no three numbers", where=where)
    above = target.low_cm[2] - point[2]
    if above > ABOVE_CM:
        return "raised"
    if above < -BELOW_CM:
        return "buried"
    connected = row.get("connected")
    return None if not isinstance(connected, bool) else "connected" if connected else "unconnected"
