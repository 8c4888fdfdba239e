"""What a physics verdict says beside its score: known oddities of the protocol in this scene."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from typing import Any

from c4s.verify.actors.collision import bodied_meshes, is_switched_off
from c4s.verify.physics.penetration import Penetration
from c4s.verify.physics.records import SupportRecord
from c4s.verify.physics.scene import PhysicsScene, actor_name
from c4s.verify.physics.support import excluded_by_label, text_to_scene_support
from c4s.verify.physics.support_advisories import support_advisories


def support_oddities(scene: PhysicsScene, scored: Sequence[int]) -> list[dict[str, Any]]:
    """Known oddities of the support rule of constructions in this scene."""
    try:
        support = text_to_scene_support(scene.snapshot)
    except ValueError:
        return []
    return _unscored_labels(scene.actors, scored) + support_advisories(scene.snapshot, support)


def hidden_by_edits(support: SupportRecord) -> list[dict[str, Any]]:
    """Actors that float by the published probe, although collision bodies hold them."""
    near = {row["index"] for row in support["near_bodies"]["states"] if row["state"] == "supported"}
    named = [row["actor"] for row in support["rows"] if row["state"] == "floating" and row["index"] in near]
    text = (
        "these float although a body is within 5 cm below or at the side: edits of one group do not hold each other, a "
        "line stops at the first surface, and only thin standing panels are held sideways"
    )
    return [{"code": "floats_beside_a_body", "text": text, "actors": named}] if named else []


def _unscored_labels(actors: Sequence[Mapping[str, Any]], scored: Sequence[int]) -> list[dict[str, Any]]:
    named = [actor_name(actors[i]) for i in scored if excluded_by_label(actors[i])]
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


def switched_off(scene: PhysicsScene, chosen: Sequence[int]) -> list[dict[str, Any]]:
    """Actors that no contact can be found of because their collision is off, although their meshes have bodies."""
    bodied = bodied_meshes(scene.snapshot)
    named = [actor_name(scene.actors[i]) for i in chosen if is_switched_off(scene.actors[i], bodied)]
    text = (
        f"their collision is switched off although their meshes have bodies: {len(named)} of {len(chosen)} actors can "
        "penetrate nothing"
    )
    return [{"code": "collision_switched_off", "text": text, "actors": named}] if named else []


def _one_object(actors: Sequence[Mapping[str, Any]], scored: Sequence[int]) -> list[str]:
    """Scored actors that share a logical object with another actor."""
    objects = [str(actor.get("logical_object_id") or "") for actor in actors]
    members = Counter(objects)
    return [actor_name(actors[i]) for i in scored if objects[i] and members[objects[i]] > 1]


def scene_advisories(
    actors: Sequence[Mapping[str, Any]],
    chosen: Sequence[int],
    scored: Sequence[int],
    judged: Penetration,
    known: set[int],
    leaves: tuple[dict[str, Any], dict[str, Any]],
) -> list[dict[str, Any]]:
    """Known oddities of the protocol in this scene. ``known``: actors with bodies, or with bodies not at hand."""
    notes: list[dict[str, Any]] = []
    if not chosen and leaves[1]["status"] == "measured":
        notes.append({"code": "empty_population", "text": "no actor was edited: both leaves are neutral", "actors": []})
    elif any(leaf["status"] == "not_applicable" for leaf in leaves):
        notes.append(
            {
                "code": "all_excluded",
                "text": "every selected actor is excluded from a leaf, which is not applicable and counts 0",
                "actors": [actor_name(actors[i]) for i in chosen],
            }
        )
    if judged.unresolved and judged.violators:
        notes.append(
            {
                "code": "violation_lifts_unresolved",
                "text": "a proven violation makes the leaf measured although other actors are unresolved",
                "actors": [actor_name(actors[i]) for i in judged.unresolved],
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
    bare = [actor_name(actors[i]) for i in scored if i not in known]
    if bare:
        notes.append(
            {
                "code": "no_collision_body",
                "text": "solid actors whose meshes have no collision body count as clean",
                "actors": bare,
            }
        )
    return notes
