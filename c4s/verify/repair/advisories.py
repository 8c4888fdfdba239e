"""Known oddities of the protocol that are present in a case. They never change a count; a reader should know them."""

from __future__ import annotations

from typing import Any

from c4s.verify.repair.acceptance import measure
from c4s.verify.repair.counts import RepairResult
from c4s.verify.repair.difference import same_but_for_identity, target_differences
from c4s.verify.repair.materials import slot_map
from c4s.verify.repair.policy import NOMINAL


def _advisory(code: str, text: str, actors: list[str]) -> dict[str, Any]:
    return {"code": code, "text": text, "actors": actors}


def advisories(result: RepairResult) -> list[dict[str, Any]]:
    """Advisories ``{"code", "text", "actors"}`` of a case."""
    targets = result.case.targets
    found = []
    removals = {t.descriptor for t in targets if t.operation == "remove"}
    shared = [t.label for t in targets if t.operation != "remove" and t.descriptor in removals]
    if shared:
        found.append(_advisory("removal-shares-a-descriptor",
                               "an actor to remove is of the same kind as these to add or restore; it can be matched "
                               "to one of them, and then counts as not removed although it is gone", shared))
    phantom = [t.label for t in targets if t.operation == "repair" and t.fields == ("transform.rotation",)
               and t.truth is not None and t.start is not None and "transform.rotation" in target_differences(
                   t.truth, t.start) and same_but_for_identity(t.truth, t.start)]
    if phantom:
        found.append(_advisory("euler-phantom-target",
                               "the same rotation is written with other Euler angles; doing nothing satisfies it",
                               phantom))
    satisfied = [t.label for t in targets if t.operation == "repair" and t.label not in phantom
                 and t.truth is not None and t.start is not None and measure(t.truth, t.start).accepted(NOMINAL)]
    if satisfied:
        found.append(_advisory("target-within-tolerance",
                               "the input is already within the acceptance limits; doing nothing satisfies it",
                               satisfied))
    slots = [t.label for t in targets if t.truth is not None and "component_material_slots" in t.truth
             and slot_map(t.truth["component_material_slots"]) is None]
    if slots:
        found.append(_advisory("unmeasurable-material-slot",
                               "a dynamic, empty or doubled material slot in the truth: no candidate can pass",
                               slots))
    hopeless = [t.label for t in targets if t.truth is not None and t.label not in slots
                and not measure(t.truth, t.truth).accepted(NOMINAL)]
    if hopeless:
        found.append(_advisory("unreachable-target",
                               "the truth itself does not pass its acceptance tests: no candidate can pass", hopeless))
    if result.rebound:
        found.append(_advisory("rebound-survivor",
                               "an actor that should have gone was moved into the place of one to be restored; it "
                               "counts as both done", []))
    return found
