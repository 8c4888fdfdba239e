"""Which actors of a candidate were edited: added, moved or changed against the input, paired by identity.

The published population (scorer facts 4) is wider and narrower than what repair calls a change: labels, tags, roles,
origins and logical objects are edits too, and so is another way to write a rotation; of the recorded properties only
the visible ones are. What the input does not record is no edit.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from c4s.verify.repair.difference import property_differences, transform_differences
from c4s.verify.repair.entries import Record, identity

_OWN_FIELDS = ("label", "actor_origin", "logical_object_id", "actor_role")


def edited_actors(snapshot: Mapping[str, Any], input_snapshot: Mapping[str, Any]) -> list[int]:
    """Positions of the candidate's actors that the input does not hold in the same state.

    Copies that share an identity are paired one to one: unedited as many times as the input holds the actor.
    Raises ``BadInput`` for an actor without id, GUID, label and path.
    """
    before: dict[str, list[Record]] = {}
    for actor in input_snapshot.get("actors") or []:
        before.setdefault(identity(actor), []).append(actor)
    edited = []
    for index, actor in enumerate(snapshot.get("actors") or []):
        same = before.get(identity(actor), [])
        twin = next((i for i, old in enumerate(same) if not _edited(old, actor)), None)
        if twin is None:
            edited.append(index)
        else:
            same.pop(twin)
    return edited


def _edited(old: Record, new: Record) -> bool:
    if any(field in old and (old[field] or None) != (new.get(field) or None) for field in _OWN_FIELDS) \
            or ("actor_tags" in old and _tags(old) != _tags(new)) \
            or transform_differences(old, new, as_quaternion=False):
        return True
    changed = property_differences(old, new, target=False)
    return bool(changed) and (changed != ["property.properties"] or bool(
        property_differences({"properties": old["properties"]}, new, target=True)))


def _tags(actor: Record) -> list[str]:
    return sorted(str(tag) for tag in actor.get("actor_tags") or [])
