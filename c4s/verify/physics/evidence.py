"""Contacts and support of a scene as plain records, apart from any verdict: what ``evidence/contacts.json`` and
``evidence/support.json`` hold. ``verify_physics`` judges by such records alone, whether just made or read back.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from c4s.collision import NOISE_CM, Contact, scene_contacts
from c4s.errors import BadInput
from c4s.protocol.rules import FIXED_TOLERANCE_CM, GAP_CM, I2S_FLOATING_METRIC, NEAR_BODIES_METRIC, T2S_FLOATING_METRIC
from c4s.protocol.settings import Setting
from c4s.verify.actors.roles import bounds_of, needs_no_support
from c4s.verify.physics.edited_support import Footing, edited_footing, groups_of
from c4s.verify.physics.penetration import contact_rule, tolerances_cm
from c4s.verify.physics.records import (
    CONTACTS_VERSION,
    SUPPORT_VERSION,
    ContactsRecord,
    NearState,
    SupportRecord,
    SupportRow,
    scene_record,
)
from c4s.verify.physics.scene import PhysicsScene, actor_name
from c4s.verify.physics.support import held_by_bodies, text_to_scene_support
from c4s.verify.physics.surfaces import MeshSource, Surfaces


def measure_contacts(
    setting: Setting, snapshot: Mapping[str, Any], start: Mapping[str, Any] | None = None
) -> ContactsRecord:
    """Contacts of the scene's population deeper than 5 cm, from its collision bodies."""
    return contacts_of(PhysicsScene(setting, snapshot, start))


def contacts_of(scene: PhysicsScene) -> ContactsRecord:
    """``measure_contacts`` of a scene that is already read; a scene beyond the bounds of contacts is ``crowded``."""
    tolerances = tolerances_cm(scene.actors, scene.role, scene.chosen, adaptive=scene.whole)
    try:
        found = scene_contacts(
            scene.snapshot,
            scene.bodies,
            minimum_depth_cm=FIXED_TOLERANCE_CM,
            actors=None if scene.whole else scene.chosen,
            rule=contact_rule(scene.actors, scene.role, tolerances),
        )
    except BadInput as crowded:
        return {**_contacts(scene, [], NOISE_CM, scene.bodies.unresolved), "crowded": crowded.what}
    return _contacts(scene, found, NOISE_CM, scene.bodies.unresolved)


def given_contacts(scene: PhysicsScene, contacts: Sequence[Contact]) -> ContactsRecord:
    """A record of contacts that another engine measured. The depth of one that is not trusted may be NaN."""
    return _contacts(scene, contacts, 0.0, {})


def _contacts(
    scene: PhysicsScene, contacts: Sequence[Contact], noise_cm: float, unknown: Mapping[int, str]
) -> ContactsRecord:
    return {
        "schema_version": CONTACTS_VERSION,
        "scene": scene_record(scene),
        "measured_beyond_cm": FIXED_TOLERANCE_CM,
        "noise_cm": noise_cm,
        "with_bodies": sorted(set(scene.bodies.owners)),
        "unknown": [{"index": index, "reason": reason} for index, reason in unknown.items()],
        "contacts": [
            {
                "a": one.a_index,
                "b": one.b_index,
                "a_name": actor_name(scene.actors[one.a_index]),
                "b_name": actor_name(scene.actors[one.b_index]),
                "depth_cm": None if math.isnan(one.depth_cm) else one.depth_cm,
                "trusted": one.trusted,
            }
            for one in contacts
        ],
    }


def read_contacts(record: ContactsRecord) -> list[Contact]:
    """The contacts of a record."""
    return [
        Contact(
            row["a_name"],
            row["b_name"],
            math.nan if row["depth_cm"] is None else row["depth_cm"],
            row["trusted"],
            row["a"],
            row["b"],
        )
        for row in record["contacts"]
    ]


def measure_support(
    setting: Setting,
    snapshot: Mapping[str, Any],
    start: Mapping[str, Any] | None = None,
    *,
    meshes: MeshSource | None = None,
    alone: bool = False,
) -> SupportRecord:
    """What holds each actor of the scene's population, and how far it is from that.

    Args:
        setting: the setting whose rule counts.
        snapshot: the scene.
        start: the start scene; needed by image-to-scene.
        meshes: gives the triangles of meshes, on which image-to-scene rests. Without it, and for meshes that it does
            not give, surfaces are collision bodies and edited actors are probed by their boxes.
        alone: let edited actors support each other, as if each were the only edit.
    """
    return support_of(PhysicsScene(setting, snapshot, start), meshes, alone=alone)


def support_of(scene: PhysicsScene, meshes: MeshSource | None = None, *, alone: bool = False) -> SupportRecord:
    """``measure_support`` of a scene that is already read; in one beyond the bounds of support nothing is resolved."""
    return _whole(scene) if scene.whole else _edited(scene, meshes, alone)


def _whole(scene: PhysicsScene) -> SupportRecord:
    try:
        support = text_to_scene_support(scene.snapshot)
    except ValueError as error:
        return {
            "schema_version": SUPPORT_VERSION,
            "scene": scene_record(scene),
            "metric": None,
            "rows": [],
            "excluded": 0,
            "error": str(error),
        }
    rows: list[SupportRow] = [
        {"index": i, "actor": actor_name(scene.actors[i]), "state": state, "gap_cm": support.gaps_cm[i]}
        for i, state in enumerate(support.per_actor)
        if state != "excluded"
    ]
    return {
        "schema_version": SUPPORT_VERSION,
        "scene": scene_record(scene),
        "metric": T2S_FLOATING_METRIC,
        "rows": rows,
        "excluded": support.per_actor.count("excluded"),
        "error": "",
    }


def _edited(scene: PhysicsScene, meshes: MeshSource | None, alone: bool) -> SupportRecord:
    actors = scene.actors
    tested = [i for i in scene.chosen if not needs_no_support(actors[i])]
    groups = {i: frozenset([i]) for i in scene.order} if alone else groups_of(scene.order)
    try:
        footing = edited_footing(actors, tested, groups, Surfaces(scene.snapshot, scene.bodies, meshes))
    except BadInput as crowded:
        reason = f"too crowded to be measured: {crowded.what}"
        footing = {index: Footing("unresolved", reason=reason) for index in tested}
    return {
        "schema_version": SUPPORT_VERSION,
        "scene": scene_record(scene),
        "metric": I2S_FLOATING_METRIC,
        "gap_cm": GAP_CM,
        "rows": [_row(i, found, scene) for i, found in footing.items()],
        "near_bodies": {"metric": NEAR_BODIES_METRIC, "states": _near_bodies(scene, tested)},
    }


def _row(index: int, found: Footing, scene: PhysicsScene) -> SupportRow:
    return {
        "index": index,
        "actor": actor_name(scene.actors[index]),
        "state": found.state,
        "mode": found.mode,
        "method": found.method,
        "gap_cm": found.gap_cm,
        "lateral_share": found.lateral.share if found.lateral else None,
        "lateral_cm": found.lateral.distance_cm if found.lateral else None,
        "held_by": [actor_name(scene.actors[k]) for k in found.holders],
        "reason": found.reason,
    }


def _near_bodies(scene: PhysicsScene, tested: Sequence[int]) -> list[NearState]:
    solid = {i for i, role in enumerate(scene.role) if role != "non_solid"}
    boxes = {
        i: (box[0] - box[1], box[0] + box[1])
        for i in {*tested, *scene.bodies.unresolved}
        if (box := bounds_of(scene.actors[i])) is not None
    }
    anywhere = np.full(3, -math.inf), np.full(3, math.inf)
    unknown = [boxes.get(i, anywhere) for i in scene.bodies.unresolved if i in solid]
    try:
        states = held_by_bodies(scene.bodies, tested, solid, unknown, {i: boxes[i] for i in tested if i in boxes})
    except BadInput:
        states = dict.fromkeys(tested, "unresolved")
    return [{"index": index, "state": state} for index, state in states.items()]
