"""Why each target is a TP or FN, and what each FP is: plain rows for reports, with measured errors.

Rows name actors by label; labels come from the submission, so they are data to show, never text to judge by.
"""

from __future__ import annotations

from collections.abc import Collection
from typing import Any

from c4s.verify.actors.difference import MATERIAL_FIELDS
from c4s.verify.actors.materials import renumbered_materials
from c4s.verify.repair.acceptance import Errors, measure
from c4s.verify.repair.actors import Actor
from c4s.verify.repair.counts import RepairResult

_DIGITS = 6


def _rounded(value: float | None) -> float | None:
    return None if value is None else round(value, _DIGITS)


def _label(actor: Actor) -> str:
    return str(actor.record.get("label") or actor.record.get("name") or actor.key)


def _pose_numbers(errors: Errors) -> dict[str, Any]:
    return {
        "position_cm": _rounded(errors.position_cm),
        "rotation_deg": _rounded(errors.rotation_deg),
        "scale_pct": _rounded(errors.scale_pct),
    }


def _numbers(errors: Errors) -> dict[str, Any]:
    return {
        **_pose_numbers(errors),
        "bounds_center_cm": _rounded(errors.bounds_center_cm),
        "bounds_extent_pct": _rounded(errors.bounds_extent_pct),
    }


def best_attempt(result: RepairResult, target: int) -> tuple[int, Errors] | None:
    """The candidate actor that comes nearest to a missed target: its own actor, else the fewest failed tests."""
    case = result.case
    wanted = case.targets[target]
    if wanted.truth is None:
        return None
    start = case.start_index.get(wanted.key) if wanted.operation == "repair" else None
    own = None if start is None else case.output_of.get(start)
    if own is not None:
        return own, case.errors(target, own)
    alike = [c for c in case.pool if case.candidate[c].descriptor == wanted.descriptor]
    ranked = []
    for c in alike:
        errors = case.errors(target, c)
        far = float("inf") if errors.position_cm is None else errors.position_cm
        ranked.append((len(errors.failed(result.tolerances)), far, c, errors))
    if not ranked:
        return None
    _, _, nearest, errors = min(ranked, key=lambda row: row[:3])
    return nearest, errors


def _missed(result: RepairResult, target: int) -> dict[str, Any]:
    attempt = best_attempt(result, target)
    if attempt is None:
        return {"reason": "no actor of this kind was added or changed"}
    candidate, errors = attempt
    pair = result.case.start_of.get(candidate)
    failed = errors.failed(result.tolerances)
    reason = (
        "left as it was"
        if pair is not None and not pair.fields
        else "taken by another target"
        if not failed
        else "fails: " + ", ".join(failed)
    )
    return {
        "reason": reason,
        "candidate": _label(result.case.candidate[candidate]),
        "failed": list(failed),
        "errors": _numbers(errors),
    }


def target_rows(result: RepairResult) -> list[dict[str, Any]]:
    """One row a target: operation, the fields that were wrong, outcome TP or FN, reason and errors."""
    rows, case = [], result.case
    for i, target in enumerate(case.targets):
        row: dict[str, Any] = {
            "actor": target.label,
            "identity": target.key,
            "operation": target.operation,
            "fields": list(target.fields),
        }
        if i in result.accepted:
            found = result.accepted[i]
            row |= {
                "outcome": "TP",
                "reason": "restored" if target.operation == "repair" else "added",
                "candidate": _label(case.candidate[found]),
                "errors": _numbers(case.errors(i, found)),
            }
        elif target.operation == "remove":
            gone = i in result.removed_targets
            row |= {"outcome": "TP" if gone else "FN", "reason": "removed" if gone else "still there"}
        else:
            row |= {"outcome": "FN"} | _missed(result, i)
        rows.append(row)
    return rows


def _is_renamed_material(fields: Collection[str], start: Actor, candidate: Actor) -> bool:
    if not fields or not set(fields) <= set(MATERIAL_FIELDS):
        return False
    return renumbered_materials(start.record) == renumbered_materials(candidate.record)


def false_positive_rows(result: RepairResult) -> list[dict[str, Any]]:
    """One row a false positive: wrong candidate outputs first, then losses of background actors.

    ``moved`` tells how far an actor is from its input actor, ``errors`` how far from the target it stands for;
    ``renamed_material`` that saving gave its runtime material another number and nothing else changed.
    """
    case, used = result.case, set(result.accepted.values())
    rows: list[dict[str, Any]] = []
    for c in case.pool:
        if c in used:
            continue
        actor, pair = case.candidate[c], case.start_of.get(c)
        row: dict[str, Any] = {"actor": _label(actor), "identity": actor.key}
        if pair is None:
            row |= {"kind": "added", "reason": "an actor that no target asks for"}
        else:
            origin = case.start[pair.start]
            target = case.target_of_start.get(pair.start)
            kind = (
                "background_changed"
                if target is None
                else "removal_target_changed"
                if target.operation == "remove"
                else "repair_target_wrong"
            )
            reason = "left as it was" if not pair.fields else "changed: " + ", ".join(pair.fields)
            row |= {
                "kind": kind,
                "reason": reason,
                "fields": list(pair.fields),
                "renamed_material": _is_renamed_material(pair.fields, origin, actor),
                "input_actor": _label(origin),
                "method": pair.method,
                "moved": _pose_numbers(measure(origin.record, actor.record)),
            }
            if target is not None and target.truth is not None:
                row["errors"] = _numbers(case.errors(case.targets.index(target), c))
        rows.append(row)
    for s in result.losses:
        repurposed = s in result.repurposed
        rows.append(
            {
                "actor": _label(case.start[s]),
                "identity": case.start[s].key,
                "kind": "background_repurposed" if repurposed else "background_lost",
                "reason": "a background actor became a target's actor" if repurposed else "a background actor is gone",
            }
        )
    return rows
