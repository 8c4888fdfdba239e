"""The physics verifier: support and solid penetration (paper, Physical Safety; scorer facts 3 and 4)."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Mapping, Sequence
from typing import Any

from c4s.collision import Contact, SceneBodies
from c4s.protocol.physics import physics_from_report
from c4s.protocol.rules import (
    ADAPTIVE_TOLERANCE,
    EDITED_ACTORS_PROFILE,
    FIXED_TOLERANCE,
    FIXED_TOLERANCE_CM,
    GAP_CM,
    I2S_FLOATING_METRIC,
    PENETRATION_METRIC,
    PHYSICS_DIGITS,
    PHYSICS_POLICY,
    ROLE_POLICY,
    T2S_FLOATING_METRIC,
    WHOLE_SCENE_PROFILE,
)
from c4s.protocol.settings import Setting
from c4s.records.verdict import Verdict
from c4s.verify.physics.advisories import hidden_by_edits, scene_advisories, support_oddities, switched_off
from c4s.verify.physics.dilution import diluted
from c4s.verify.physics.evidence import (
    contacts_of,
    given_contacts,
    measure_contacts,
    measure_support,
    read_contacts,
    support_of,
)
from c4s.verify.physics.penetration import Penetration, penetration, tolerances_cm
from c4s.verify.physics.records import ContactsRecord, NearBodies, SupportRecord, checked
from c4s.verify.physics.scene import Actors, PhysicsScene, actor_name
from c4s.verify.physics.surfaces import MeshSource

__all__ = ["measure_contacts", "measure_support", "report", "verify_physics"]

Leaf = dict[str, Any]
DIRECTIONS = {"floating": "lower_is_better", "solid_penetration": "higher_is_better"}
MOST_LISTED = 20
"""Contacts of one actor that a verdict lists."""
_STATES = ("supported", "floating", "unresolved")
_SHOWN = ("actor", "state", "mode", "method", "gap_cm", "held_by")


def verify_physics(
    setting: Setting,
    snapshot: Mapping[str, Any],
    input_snapshot: Mapping[str, Any] | None = None,
    *,
    contacts: Sequence[Contact] | Mapping[str, Any] | None = None,
    support: Mapping[str, Any] | None = None,
    meshes: MeshSource | None = None,
    alone: bool = False,
) -> Verdict:
    """Judge the two physics leaves, ``floating`` and ``solid_penetration``.

    Args:
        setting: ``text-to-scene`` (all actors), or an image-to-scene setting (actors that differ from the input).
        snapshot: the candidate scene.
        input_snapshot: the start scene; needed by image-to-scene.
        contacts: a record of ``measure_contacts``, or contacts that another engine measured, for a snapshot without
            collision bodies (the depth of one that is not trusted may be NaN). Measured here when not given.
        support: a record of ``measure_support``. Measured here when not given.
        meshes, alone: of that measurement, as ``measure_support`` has them.

    Without bodies and without ``contacts`` an actor is unresolved, and a leaf that rests on it is not evaluated.
    Raises ``BadInput`` for a scene without an actor list, for image-to-scene without an input scene, and for a record
    of another scene.
    """
    scene = PhysicsScene(setting, snapshot, input_snapshot)
    if scene.fault:
        return _withheld(scene.actors, scene.fault)
    if contacts is None:
        found = contacts_of(scene)
    elif isinstance(contacts, Mapping):
        found = checked(scene, contacts, ContactsRecord)
    else:
        found = given_contacts(scene, contacts)
    held = support_of(scene, meshes, alone=alone) if support is None else checked(scene, support, SupportRecord)
    return _judged(scene, found, held)


def _judged(scene: PhysicsScene, contacts: ContactsRecord, support: SupportRecord) -> Verdict:
    actors, role, chosen, whole = scene.actors, scene.role, scene.chosen, scene.whole
    unknown = {row["index"]: row["reason"] for row in contacts["unknown"]}
    floating = _scene_floating(scene, support) if whole else _edited_floating(support)
    tolerances = tolerances_cm(actors, role, chosen, adaptive=whole)
    judged = penetration(
        actors,
        role,
        read_contacts(contacts),
        SceneBodies(unresolved=unknown),
        scored=chosen,
        tolerances=tolerances,
        noise_cm=contacts["noise_cm"],
    )
    crowded = contacts.get("crowded", "")
    solid = (
        _unmeasured_leaf(len(tolerances), f"too crowded to be measured: {crowded}")
        if crowded
        else _penetration_leaf(actors, chosen, judged, whole)
    )
    leaves = {"leaf_results": [floating, solid], "leaf_score_directions": DIRECTIONS}
    total = physics_from_report({"report_id": "physical_safety", "status": "measured", "metrics": leaves})
    scored = [i for i in chosen if role[i] == "scored_solid"]
    return Verdict(
        verifier="physics",
        status="measured",
        score=total["score"],
        policy=PHYSICS_POLICY,
        measurements={
            **leaves,
            "leaves": total["leaves"],
            "diagnostic_leaves": [] if whole else [_near_bodies(actors, support["near_bodies"])],
            "role_policy": ROLE_POLICY,
            "profile": WHOLE_SCENE_PROFILE if whole else EDITED_ACTORS_PROFILE,
            "roles": {actor_name(actors[i]): role[i] for i in chosen},
        },
        population={
            "actors": len(actors),
            "selected": len(chosen),
            **_leaf_population("floating", floating),
            **_leaf_population("solid_penetration", solid),
            **{f"role_{name}": n for name, n in sorted(Counter(role[i] for i in chosen).items())},
        },
        advisories=scene_advisories(
            actors, chosen, scored, judged, {*contacts["with_bodies"], *unknown}, (floating, solid)
        )
        + switched_off(scene, chosen)
        + (
            support_oddities(scene, scored)
            + diluted(actors, scored, judged.violators, floating.get("floating_actors") or [])
            if whole
            else hidden_by_edits(support)
        ),
    )


def _withheld(actors: Sequence[Mapping[str, Any]], reason: str) -> Verdict:
    """Neither leaf is evaluated: it is not known which actors were edited."""
    leaves = {
        "leaf_results": [
            _floating("not_evaluated", None, 0, 0, [], metric=I2S_FLOATING_METRIC, reason=reason),
            _unmeasured_leaf(0, reason),
        ],
        "leaf_score_directions": DIRECTIONS,
    }
    total = physics_from_report({"report_id": "physical_safety", "status": "not_evaluated", "metrics": leaves})
    return Verdict(
        verifier="physics",
        status="not_evaluated",
        policy=PHYSICS_POLICY,
        reason=reason,
        measurements={
            **leaves,
            "leaves": total["leaves"],
            "diagnostic_leaves": [],
            "role_policy": ROLE_POLICY,
            "profile": EDITED_ACTORS_PROFILE,
            "roles": {},
        },
        population={"actors": len(actors)},
    )


def _unmeasured_leaf(unresolved: int, reason: str) -> Leaf:
    """A leaf without a number, which is worth zero."""
    return _leaf(
        "solid_penetration",
        "not_evaluated",
        None,
        "higher_is_better",
        metric=PENETRATION_METRIC,
        evaluated=0,
        unresolved=unresolved,
        failed=0,
        violations=[],
        unresolved_actors=[],
        actors=[],
        reason=reason,
    )


def report(verdict: Verdict) -> dict[str, Any]:
    """The verdict in the published report's shape, as the score package reads it."""
    return {
        "report_id": "physical_safety",
        "status": verdict.status,
        "score": verdict.score,
        "metrics": {key: verdict.measurements[key] for key in ("leaf_results", "leaf_score_directions")},
    }


def _leaf(leaf_id: str, status: str, score: float | None, direction: str, **more: Any) -> Leaf:
    """A leaf as published: its score has four decimals before it is weighted."""
    return {
        "leaf_id": leaf_id,
        "report_id": f"physical_safety.{leaf_id}",
        "status": status,
        "score": None if score is None else round(score, PHYSICS_DIGITS),
        "metadata": {"score_direction": direction},
        **more,
    }


def _leaf_population(name: str, leaf: Leaf) -> dict[str, int]:
    return {f"{name}_{key}": leaf[key] for key in ("evaluated", "unresolved", "failed")}


def _scene_floating(scene: PhysicsScene, support: SupportRecord) -> Leaf:
    """Text-to-scene: the box rule over all generated actors."""
    if support["error"]:
        return _floating("error", None, 0, 0, [], reason=support["error"])
    states = [row["state"] for row in support["rows"]]
    failed = [row["actor"] for row in support["rows"] if row["state"] == "floating"]
    rate = round(len(failed) / len(states), PHYSICS_DIGITS) if states else None
    status, score = ("measured", rate) if states else _empty(len(scene.actors), None)
    return _floating(status, score, len(states), 0, failed, metric=T2S_FLOATING_METRIC, excluded=support["excluded"])


def _edited_floating(support: SupportRecord) -> Leaf:
    """Image-to-scene: support of the edited actors, without non-solid ones and broad thin ground surfaces.

    When none is left the leaf is neutral; the penetration leaf is then not applicable. One actor without evidence
    withholds the leaf, whatever the others show: here a failure proves nothing about the rest (all as published).
    """
    named = {state: [row["actor"] for row in support["rows"] if row["state"] == state] for state in _STATES}
    failed, unresolved = named["floating"], named["unresolved"]
    status, score = _rate(len(failed), len(unresolved), len(support["rows"]))
    return _floating(
        status,
        score,
        len(support["rows"]) - len(unresolved),
        len(unresolved),
        failed,
        metric=I2S_FLOATING_METRIC,
        gap_cm=GAP_CM,
        unresolved_actors=unresolved,
        actors=[
            {key: value for key, value in row.items() if key in _SHOWN or (key == "reason" and value)}
            for row in support["rows"]
        ],
    )


def _rate(failed: int, unresolved: int, tested: int) -> tuple[str, float | None]:
    if not tested:
        return "measured", 0.0
    return ("not_evaluated", None) if unresolved else ("measured", failed / tested)


def _near_bodies(actors: Actors, record: NearBodies) -> Leaf:
    """The same question asked of the collision bodies, for comparison: no weight, and in no score."""
    named = {
        state: [actor_name(actors[row["index"]]) for row in record["states"] if row["state"] == state]
        for state in _STATES
    }
    failed, unresolved = named["floating"], named["unresolved"]
    status, score = _rate(len(failed), len(unresolved), len(record["states"]))
    return _leaf(
        "near_bodies",
        status,
        score,
        "lower_is_better",
        weight=None,
        metric=record["metric"],
        evaluated=len(record["states"]) - len(unresolved),
        unresolved=len(unresolved),
        failed=len(failed),
        floating_actors=failed,
        unresolved_actors=unresolved,
    )


def _floating(
    status: str, score: float | None, evaluated: int, unresolved: int, failed: list[str], **more: Any
) -> Leaf:
    return _leaf(
        "floating",
        status,
        score,
        "lower_is_better",
        evaluated=evaluated,
        unresolved=unresolved,
        failed=len(failed),
        floating_actors=failed,
        **more,
    )


def _empty(selected: int, neutral: float | None) -> tuple[str, float | None]:
    """Nothing to evaluate: not applicable when all that was selected is excluded. When nothing was, neutral for the
    edits of a repair, and not evaluated (no ``neutral``) for a whole scene, which would look perfect."""
    if selected:
        return "not_applicable", None
    return ("not_evaluated", None) if neutral is None else ("measured", neutral)


def _penetration_leaf(
    actors: Sequence[Mapping[str, Any]], chosen: Sequence[int], judged: Penetration, whole: bool
) -> Leaf:
    evaluated = len(judged.violators) + len(judged.clean)
    score: float | None
    if not evaluated and not judged.unresolved:
        status, score = _empty(len(chosen), None if whole else 1.0)
    else:
        status, score = ("measured", judged.score) if judged.score is not None else ("not_evaluated", None)
    state = (
        dict.fromkeys(judged.violators, "violating")
        | dict.fromkeys(judged.clean, "clean")
        | dict.fromkeys(judged.unresolved, "unresolved")
    )
    return _leaf(
        "solid_penetration",
        status,
        score,
        "higher_is_better",
        metric=PENETRATION_METRIC,
        evaluated=evaluated,
        tolerance_policy=ADAPTIVE_TOLERANCE if whole else FIXED_TOLERANCE,
        unresolved=len(judged.unresolved),
        failed=len(judged.violators),
        violations=[
            {
                "actor": actor_name(actors[i]),
                "tolerance_cm": judged.tolerances_cm[i],
                **_contact_rows(actors, judged.violating(i)),
            }
            for i in judged.violators
        ],
        unresolved_actors=[actor_name(actors[i]) for i in judged.unresolved],
        measured_beyond_cm=FIXED_TOLERANCE_CM,
        actors=[
            {
                "actor": actor_name(actors[i]),
                "state": state[i],
                "tolerance_cm": judged.tolerances_cm.get(i),
                **_contact_rows(actors, judged.contacts.get(i, [])),
                **({"reason": judged.unresolved[i]} if i in judged.unresolved else {}),
            }
            for i in sorted(state)
        ],
    )


def _contact_rows(actors: Sequence[Mapping[str, Any]], rows: Sequence[tuple[int, float, bool]]) -> dict[str, Any]:
    """The deepest contacts of an actor, and their number where more were found."""
    listed = [
        {
            "actor": actor_name(actors[other]),
            "depth_cm": None if math.isnan(depth) else round(depth, 4),
            "trusted": trusted,
        }
        for other, depth, trusted in rows[:MOST_LISTED]
    ]
    return {"contacts": listed} if len(rows) <= MOST_LISTED else {"contacts": listed, "contacts_found": len(rows)}
