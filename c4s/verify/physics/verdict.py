"""The physics verifier: support and solid penetration (paper, Physical Safety; scorer facts 3 and 4)."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from c4s.collision import NOISE_CM, Contact, SceneBodies, scene_bodies, scene_contacts
from c4s.errors import BadInput
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
from c4s.protocol.settings import Setting, is_construction
from c4s.records.verdict import Verdict
from c4s.verify.actors.roles import Role, bounds_of, needs_no_support, roles
from c4s.verify.physics.edited import CANDIDATE, edited_actors
from c4s.verify.physics.penetration import Penetration, contact_rule, penetration, tolerances_cm
from c4s.verify.physics.support import Support, edited_support, excluded_by_label, text_to_scene_support
from c4s.verify.physics.support_advisories import support_advisories

Leaf = dict[str, Any]
DIRECTIONS = {"floating": "lower_is_better", "solid_penetration": "higher_is_better"}
MOST_LISTED = 20
"""Contacts of one actor that a verdict lists."""


def verify_physics(
    setting: Setting,
    snapshot: Mapping[str, Any],
    input_snapshot: Mapping[str, Any] | None = None,
    *,
    contacts: Sequence[Contact] | None = None,
) -> Verdict:
    """Measure the two physics leaves, ``floating`` and ``solid_penetration``.

    Args:
        setting: ``text-to-scene`` (all actors), or an image-to-scene setting (actors that differ from the input).
        snapshot: the candidate scene. Contacts come from its collision bodies.
        input_snapshot: the start scene; needed by image-to-scene.
        contacts: contacts that another engine measured, for a snapshot without collision bodies. The depth
            of one that is not trusted may be NaN.

    Without bodies and without ``contacts`` an actor is unresolved, and a leaf that rests on it is not evaluated.
    Raises ``BadInput`` for a scene without an actor list, and for image-to-scene without an input scene.
    """
    actors = _actors_of(snapshot, "snapshot")
    role = roles(actors)
    scene = scene_bodies(snapshot)
    whole = is_construction(setting)
    if whole:
        chosen = list(range(len(actors)))
        floating = _scene_floating(snapshot)
    else:
        if input_snapshot is None:
            raise BadInput("image-to-scene physics needs the input snapshot", where=setting)
        _actors_of(input_snapshot, "input snapshot")
        try:
            chosen = edited_actors(snapshot, input_snapshot)
        except BadInput as error:
            if error.where != CANDIDATE:
                raise
            return _withheld(actors, error.line())
        floating = _edited_floating(actors, role, scene, chosen)
    if contacts is not None:
        scene = SceneBodies(scene.bodies, scene.owners, {})
    tolerances = tolerances_cm(actors, role, chosen, adaptive=whole)
    found = (
        list(contacts)
        if contacts is not None
        else scene_contacts(
            snapshot,
            scene,
            minimum_depth_cm=FIXED_TOLERANCE_CM,
            actors=None if whole else chosen,
            rule=contact_rule(actors, role, tolerances),
        )
    )
    judged = penetration(
        actors, role, found, scene, scored=chosen, tolerances=tolerances, noise_cm=NOISE_CM if contacts is None else 0.0
    )
    solid = _penetration_leaf(actors, chosen, judged, whole)
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
            "role_policy": ROLE_POLICY,
            "profile": WHOLE_SCENE_PROFILE if whole else EDITED_ACTORS_PROFILE,
            "roles": {_name(actors[i]): role[i] for i in chosen},
        },
        population={
            "actors": len(actors),
            "selected": len(chosen),
            **_leaf_population("floating", floating),
            **_leaf_population("solid_penetration", solid),
            **{f"role_{name}": n for name, n in sorted(Counter(role[i] for i in chosen).items())},
        },
        advisories=_advisories(actors, chosen, scored, judged, scene, (floating, solid))
        + (_support_oddities(snapshot, actors, scored) if whole else []),
    )


def _withheld(actors: Sequence[Mapping[str, Any]], reason: str) -> Verdict:
    """Neither leaf is evaluated: it is not known which actors were edited."""
    leaves = {
        "leaf_results": [
            _floating("not_evaluated", None, 0, 0, [], metric=I2S_FLOATING_METRIC, reason=reason),
            _leaf(
                "solid_penetration",
                "not_evaluated",
                None,
                "higher_is_better",
                metric=PENETRATION_METRIC,
                evaluated=0,
                unresolved=0,
                failed=0,
                violations=[],
                unresolved_actors=[],
                actors=[],
                reason=reason,
            ),
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
            "role_policy": ROLE_POLICY,
            "profile": EDITED_ACTORS_PROFILE,
            "roles": {},
        },
        population={"actors": len(actors)},
    )


def _actors_of(snapshot: Mapping[str, Any], what: str) -> list[Mapping[str, Any]]:
    actors = snapshot.get("actors")
    if not isinstance(actors, list) or not all(isinstance(actor, Mapping) for actor in actors):
        raise BadInput(f"the {what} has no list of actors", todo="export the scene again")
    return actors


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


def _name(actor: Mapping[str, Any]) -> str:
    return str(actor.get("name") or actor.get("label"))


def _scene_floating(snapshot: Mapping[str, Any]) -> Leaf:
    """Text-to-scene: the box rule over all generated actors."""
    try:
        support: Support = text_to_scene_support(snapshot)
    except ValueError as error:
        return _floating("error", None, 0, 0, [], reason=str(error))
    failed = [
        _name(actor) for actor, state in zip(snapshot["actors"], support.per_actor, strict=True) if state == "floating"
    ]
    status, score = ("measured", support.rate) if support.evaluated else _empty(len(support.per_actor), None)
    return _floating(
        status,
        score,
        support.evaluated,
        0,
        failed,
        metric=T2S_FLOATING_METRIC,
        excluded=support.per_actor.count("excluded"),
    )


def _edited_floating(
    actors: Sequence[Mapping[str, Any]], role: Sequence[Role], scene: SceneBodies, chosen: Sequence[int]
) -> Leaf:
    """Image-to-scene: support of the edited actors, without non-solid ones and broad thin ground surfaces.

    When none is left the leaf is neutral; the penetration leaf is then not applicable. One actor without evidence
    withholds the leaf, whatever the others show: here a failure proves nothing about the rest (all as published).
    """
    tested = [i for i in chosen if not needs_no_support(actors[i])]
    solid = {i for i in range(len(actors)) if role[i] != "non_solid"}
    unknown = [
        (box[0] - box[1], box[0] + box[1])
        if (box := bounds_of(actors[i])) is not None
        else (np.full(3, -math.inf), np.full(3, math.inf))
        for i in scene.unresolved
        if i in solid
    ]
    boxes = {i: (box[0] - box[1], box[0] + box[1]) for i in tested if (box := bounds_of(actors[i])) is not None}
    states = edited_support(scene, tested, solid, unknown, boxes)
    failed = [_name(actors[i]) for i, state in states.items() if state == "floating"]
    unresolved = [_name(actors[i]) for i, state in states.items() if state == "unresolved"]
    evaluated = len(states) - len(unresolved)
    if not tested:
        status, score = "measured", 0.0
    elif unresolved:
        status, score = "not_evaluated", None
    else:
        status, score = "measured", len(failed) / evaluated
    return _floating(
        status,
        score,
        evaluated,
        len(unresolved),
        failed,
        metric=I2S_FLOATING_METRIC,
        gap_cm=GAP_CM,
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
                "actor": _name(actors[i]),
                "tolerance_cm": judged.tolerances_cm[i],
                **_contact_rows(actors, judged.violating(i)),
            }
            for i in judged.violators
        ],
        unresolved_actors=[_name(actors[i]) for i in judged.unresolved],
        measured_beyond_cm=FIXED_TOLERANCE_CM,
        actors=[
            {
                "actor": _name(actors[i]),
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
        {"actor": _name(actors[other]), "depth_cm": None if math.isnan(depth) else round(depth, 4), "trusted": trusted}
        for other, depth, trusted in rows[:MOST_LISTED]
    ]
    return {"contacts": listed} if len(rows) <= MOST_LISTED else {"contacts": listed, "contacts_found": len(rows)}


def _support_oddities(
    snapshot: Mapping[str, Any], actors: Sequence[Mapping[str, Any]], scored: Sequence[int]
) -> list[dict[str, Any]]:
    try:
        support = text_to_scene_support(snapshot)
    except ValueError:
        return []
    return _unscored_labels(actors, scored) + support_advisories(snapshot, support)


def _unscored_labels(actors: Sequence[Mapping[str, Any]], scored: Sequence[int]) -> list[dict[str, Any]]:
    named = [_name(actors[i]) for i in scored if excluded_by_label(actors[i])]
    return (
        [
            {
                "code": "label_never_supported",
                "text": "labels that start with a word for infrastructure (light, sky, "
                "floor, ...) are never tested for support and support nothing",
                "actors": named,
            }
        ]
        if named
        else []
    )


def _one_object(actors: Sequence[Mapping[str, Any]], scored: Sequence[int]) -> list[str]:
    """Scored actors that share a logical object with another actor."""
    objects = [str(actor.get("logical_object_id") or "") for actor in actors]
    members = Counter(objects)
    return [_name(actors[i]) for i in scored if objects[i] and members[objects[i]] > 1]


def _advisories(
    actors: Sequence[Mapping[str, Any]],
    chosen: Sequence[int],
    scored: Sequence[int],
    judged: Penetration,
    scene: SceneBodies,
    leaves: tuple[Leaf, Leaf],
) -> list[dict[str, Any]]:
    """Known oddities of the protocol in this scene."""
    notes: list[dict[str, Any]] = []
    if not chosen and leaves[1]["status"] == "measured":
        notes.append({"code": "empty_population", "text": "no actor was edited: both leaves are neutral", "actors": []})
    elif any(leaf["status"] == "not_applicable" for leaf in leaves):
        notes.append(
            {
                "code": "all_excluded",
                "text": "every selected actor is excluded from a leaf, which is not applicable and counts 0",
                "actors": [_name(actors[i]) for i in chosen],
            }
        )
    if judged.unresolved and judged.violators:
        notes.append(
            {
                "code": "violation_lifts_unresolved",
                "text": "a proven violation makes the leaf measured although other actors are unresolved",
                "actors": [_name(actors[i]) for i in judged.unresolved],
            }
        )
    whole = _one_object(actors, scored)
    if whole:
        notes.append(
            {
                "code": "one_logical_object",
                "text": "contacts inside one logical object, which tags name, are not counted",
                "actors": whole,
            }
        )
    owners = set(scene.owners)
    bare = [_name(actors[i]) for i in scored if i not in owners and i not in scene.unresolved]
    if bare:
        notes.append(
            {
                "code": "no_collision_body",
                "text": "solid actors whose meshes have no collision body count as clean",
                "actors": bare,
            }
        )
    return notes
