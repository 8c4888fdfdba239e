"""Which actors of a candidate were edited: added, moved or changed against the input, paired by identity.

Besides what repair calls a change, a new label or tag is an edit here (scorer facts 4).
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from c4s.verify.repair.difference import changed_fields
from c4s.verify.repair.entries import Record, identity


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
    return old.get("label") != new.get("label") or _tags(old) != _tags(new) or bool(changed_fields(old, new))


def _tags(actor: Record) -> list[str]:
    return sorted(str(tag) for tag in actor.get("actor_tags") or [])
