"""Which actors of a candidate were edited: added, moved or changed against the input, paired by identity.

The published population (scorer facts 4) is wider and narrower than what repair calls a change: labels, tags, roles,
origins and logical objects are edits too, and so is another way to write a rotation; of the recorded properties only
the visible ones are. What the input does not record is no edit.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from c4s.errors import BadInput
from c4s.verify.actors.difference import property_differences, transform_differences
from c4s.verify.actors.entries import Record, identity

CANDIDATE = "candidate snapshot"
_OWN_FIELDS = ("label", "actor_origin", "logical_object_id", "actor_role")


def edited_actors(snapshot: Mapping[str, Any], input_snapshot: Mapping[str, Any]) -> list[int]:
    """Positions of the candidate's actors that the input does not hold in the same state.

    Raises ``BadInput`` (its ``where`` names the snapshot) for two actors under one identity and for an actor that has
    none: what was edited is then not known.
    """
    return sorted(edit_order(snapshot, input_snapshot))


def edit_order(snapshot: Mapping[str, Any], input_snapshot: Mapping[str, Any]) -> list[int]:
    """``edited_actors`` in the order in which the published probe measures them.

    Added ones as the candidate lists them, then those whose pose changed, then the others, both as the input lists
    them.
    """
    before = _by_identity(input_snapshot, "input snapshot")
    after = _by_identity(snapshot, CANDIDATE)
    place = {key: index for index, key in enumerate(after)}
    posed, others = [], []
    for key, old in before.items():
        new = after.get(key)
        if new is not None and transform_differences(old, new, as_quaternion=False):
            posed.append(place[key])
        elif new is not None and _restated(old, new):
            others.append(place[key])
    return [index for key, index in place.items() if key not in before] + posed + others


def _by_identity(snapshot: Mapping[str, Any], where: str) -> dict[str, Record]:
    found: dict[str, Record] = {}
    for actor in snapshot.get("actors") or []:
        try:
            key = identity(actor)
        except BadInput as error:
            raise BadInput(error.what, where=where, todo=error.todo) from None
        if key in found:
            raise BadInput(
                f"two actors have the identity {key}", where=where, todo="identities must be unique in a scene"
            )
        found[key] = actor
    return found


def _restated(old: Record, new: Record) -> bool:
    """Whether anything but the pose was edited."""
    if any(field in old and (old[field] or None) != (new.get(field) or None) for field in _OWN_FIELDS) or (
        "actor_tags" in old and _tags(old) != _tags(new)
    ):
        return True
    changed = property_differences(old, new, target=False)
    return bool(changed) and (
        changed != ["property.properties"]
        or bool(property_differences({"properties": old["properties"]}, new, target=True))
    )


def _tags(actor: Record) -> list[str]:
    return sorted(str(tag) for tag in actor.get("actor_tags") or [])
