"""Known oddities of the protocol that are present in a case. They never change a count; a reader should know them."""

from __future__ import annotations

import json
from typing import Any

from c4s.protocol.repair import NOMINAL
from c4s.verify.actors.difference import same_but_for_identity, target_differences
from c4s.verify.actors.materials import slot_map
from c4s.verify.repair.acceptance import measure
from c4s.verify.repair.counts import RepairResult
from c4s.verify.repair.explanation import best_attempt

_LEVEL_MARK = ":PersistentLevel."
_BOX_TESTS = {"bounds_center", "bounds_extent"}


def _advisory(code: str, text: str, actors: list[str]) -> dict[str, Any]:
    return {"code": code, "text": text, "actors": actors}


def advisories(result: RepairResult) -> list[dict[str, Any]]:
    """Advisories ``{"code", "text", "actors"}`` of a case."""
    targets = result.case.targets
    found = []
    removals = {t.descriptor for t in targets if t.operation == "remove"}
    shared = [t.label for t in targets if t.operation != "remove" and t.descriptor in removals]
    if shared:
        found.append(
            _advisory(
                "removal-shares-a-descriptor",
                "an actor to remove is of the same kind as these to add or restore; it can be matched "
                "to one of them, and then counts as not removed although it is gone",
                shared,
            )
        )
    phantom = [
        t.label
        for t in targets
        if t.operation == "repair"
        and t.fields == ("transform.rotation",)
        and t.truth is not None
        and t.start is not None
        and "transform.rotation" in target_differences(t.truth, t.start)
        and same_but_for_identity(t.truth, t.start)
    ]
    if phantom:
        found.append(
            _advisory(
                "euler-phantom-target",
                "the same rotation is written with other Euler angles; doing nothing satisfies it",
                phantom,
            )
        )
    satisfied = [
        t.label
        for t in targets
        if t.operation == "repair"
        and t.label not in phantom
        and t.truth is not None
        and t.start is not None
        and measure(t.truth, t.start).accepted(NOMINAL)
    ]
    if satisfied:
        found.append(
            _advisory(
                "target-within-tolerance",
                "the input is already within the acceptance limits; doing nothing satisfies it",
                satisfied,
            )
        )
    slots = [
        t.label
        for t in targets
        if t.truth is not None
        and "component_material_slots" in t.truth
        and slot_map(t.truth["component_material_slots"]) is None
    ]
    if slots:
        found.append(
            _advisory(
                "unmeasurable-material-slot",
                "a dynamic, empty or doubled material slot in the truth: no candidate can pass",
                slots,
            )
        )
    hopeless = [
        t.label
        for t in targets
        if t.truth is not None and t.label not in slots and not measure(t.truth, t.truth).accepted(NOMINAL)
    ]
    if hopeless:
        found.append(
            _advisory(
                "unreachable-target",
                "the truth itself does not pass its acceptance tests: no candidate can pass",
                hopeless,
            )
        )
    if result.rebounds:
        found.append(
            _advisory(
                "rebound-survivor",
                "an actor that should have gone was moved into the place of one to be restored; it counts as both done",
                [targets[i].label for pair in result.rebounds for i in pair],
            )
        )
    return found + _of_the_outcome(result)


def _of_the_outcome(result: RepairResult) -> list[dict[str, Any]]:
    """Advisories that depend on what the candidate did, and those on what no target asks for."""
    case, found = result.case, []
    local = [
        t.label
        for t in case.targets
        if t.truth is not None
        and _LEVEL_MARK in json.dumps([t.truth.get("material_paths"), t.truth.get("component_material_slots")])
    ]
    if local:
        found.append(
            _advisory(
                "level-local-material",
                "a material of these belongs to the level: under another package its path differs, and "
                "the target cannot be matched",
                local,
            )
        )
    if case.beside:
        found.append(
            _advisory(
                "restored-property-charged",
                "these differ from the truth in properties that make no target; to restore them counts "
                "as a change of the background",
                case.beside,
            )
        )
    missed = [
        (i, best_attempt(result, i))
        for i, t in enumerate(case.targets)
        if t.truth is not None and i not in result.accepted
    ]
    boxes = [
        case.targets[i].label
        for i, attempt in missed
        if attempt is not None and (failed := attempt[1].failed(result.tolerances)) and set(failed) <= _BOX_TESTS
    ]
    if boxes:
        found.append(
            _advisory(
                "box-alone-fails",
                "pose, kind and materials of these are right within the limits; only their box is not",
                boxes,
            )
        )
    cleared = [
        case.targets[i].label
        for i in sorted(result.removed_targets)
        if case.start_index.get(case.targets[i].key) in case.replaced
    ]
    wrecked = [case.targets[i].label for i in sorted(result.removed_targets)]
    if wrecked and len(result.losses) > len(case.targets):
        found.append(
            _advisory(
                "removed-with-the-rest",
                f"these count as removed, and {len(result.losses)} actors that should have stayed are gone too",
                wrecked,
            )
        )
    if cleared:
        found.append(
            _advisory(
                "cleared-removal",
                "the mesh of these was cleared or swapped in place: they count as removed, and what "
                "stands there as a false positive",
                cleared,
            )
        )
    return found
