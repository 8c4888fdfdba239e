"""Repair targets: what must be added, removed or restored, made from input and truth alone (scorer fact 2.2)."""

from __future__ import annotations

from collections import defaultdict
from dataclasses import dataclass
from typing import Literal, TypeAlias

from c4s.errors import BadInput
from c4s.verify.actors.difference import same_but_for_identity, target_differences
from c4s.verify.actors.entries import ActorEntry, Record
from c4s.verify.actors.kinds import Descriptor, descriptor, is_semantic, short_class

Operation: TypeAlias = Literal["add", "remove", "repair"]


@dataclass(frozen=True, slots=True)
class RepairTarget:
    """One target. ``truth`` is the state to reproduce, cut down to evidence that the input records too."""

    key: str
    operation: Operation
    fields: tuple[str, ...]
    truth: Record | None
    start: Record | None

    @property
    def label(self) -> str:
        """A readable name of the actor concerned."""
        record = self.truth or self.start or {}
        return str(record.get("label") or (self.start or {}).get("label") or record.get("name") or self.key)

    @property
    def descriptor(self) -> Descriptor:
        """Structural descriptor of the state to reproduce, or of the actor to remove."""
        return descriptor(self.truth or self.start or {})


def _shared_evidence(truth: Record, start: Record) -> Record:
    cut = {field: value for field, value in truth.items() if field in start}
    mine, theirs = truth.get("transform"), start.get("transform")
    if isinstance(mine, dict) and isinstance(theirs, dict):
        cut["transform"] = {member: value for member, value in mine.items() if member in theirs}
    return cut


def _without_identity_pairs(added: dict[str, Record], removed: dict[str, Record]) -> None:
    """Drop pairs of a truth-only and an input-only actor with identical content; first come, first served."""
    pool: dict[str, dict[str, Record]] = defaultdict(dict)
    for key, record in removed.items():
        pool[short_class(record.get("class"))][key] = record
    for key, truth in list(added.items()):
        same_class = pool[short_class(truth.get("class"))] if "class" in truth else removed
        partner = next(
            (k for k, start in same_class.items() if k in removed and same_but_for_identity(truth, start)), None
        )
        if partner is not None:
            del added[key], removed[partner]
            same_class.pop(partner, None)


def find_targets(
    before: dict[str, ActorEntry], after: dict[str, ActorEntry], finite: set[str]
) -> tuple[list[RepairTarget], list[str]]:
    """All targets, in their fixed order, and the labels of actors that differ in properties which make no target.

    Args:
        before: actors of the input by identity.
        after: actors of the truth by identity.
        finite: identities of input actors whose pose is known to be three vectors of finite numbers; for them equal
            records need no closer look.

    Raises:
        BadInput: there is no target.
    """
    added, removed = (
        {key: entry.record for key, entry in side.items() if key not in other and is_semantic(entry.record)}
        for side, other in ((after, before), (before, after))
    )
    if added and removed:
        _without_identity_pairs(added, removed)
    found = [RepairTarget(key, "add", ("existence",), record, None) for key, record in added.items()]
    found += [RepairTarget(key, "remove", ("existence",), None, record) for key, record in removed.items()]
    beside = []
    for key, entry in after.items():
        old = before.get(key)
        if old is None or (entry.alike(old) and key in finite):
            continue
        cut = _shared_evidence(entry.record, old.record)
        fields = target_differences(cut, old.record)
        if not (is_semantic(entry.record) or is_semantic(old.record)):
            continue
        if fields:
            found.append(RepairTarget(key, "repair", tuple(fields), cut, old.record))
        elif "properties" in cut and cut["properties"] != old.record["properties"]:
            beside.append(str(old.record.get("label") or key))
    if not found:
        raise BadInput(
            "input and truth define no repair target",
            where="truth snapshot",
            todo="a case needs at least one difference",
        )
    return sorted(found, key=lambda t: (t.key.casefold(), t.key, t.operation)), beside
