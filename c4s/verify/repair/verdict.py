"""The repair verdict: F1 of a saved scene with its counts, explanation, tolerance profiles and advisories."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Literal

from c4s.errors import BadInput
from c4s.garbage import put_off
from c4s.protocol.repair import NOMINAL, PROFILES, REPAIR_POLICY
from c4s.records.verdict import Verdict
from c4s.verify.repair.actors import scene_actors
from c4s.verify.repair.advisories import advisories
from c4s.verify.repair.counts import RepairResult, count, prepare_case
from c4s.verify.repair.explanation import false_positive_rows, target_rows
from c4s.verify.repair.reading import read_snapshots


def counts_record(result: RepairResult) -> dict[str, Any]:
    """Counts and scores of a result, unrounded."""
    return {
        "tp": result.tp,
        "fp": result.fp,
        "fn": result.fn,
        "precision": result.precision,
        "recall": result.recall,
        "f1": result.f1,
    }


def repair_verdict(
    start: Any, truth: Any, candidate: Any, *, policy: str = REPAIR_POLICY, inputs: dict[str, str] | None = None
) -> Verdict:
    """Score plain snapshots under the nominal profile; strict and relaxed are recorded beside it.

    Raises ``BadInput`` when the scenes cannot be scored.
    """
    case = prepare_case(start, truth, candidate)
    results = {name: count(case, limits) for name, limits in PROFILES.items()}
    nominal = results[NOMINAL.name]
    measurements = counts_record(nominal) | {
        "present_targets": sum(t.truth is not None for t in case.targets),
        "removal_targets": sum(t.truth is None for t in case.targets),
        "targets": target_rows(nominal),
        "false_positives": false_positive_rows(nominal),
        "profiles": {name: counts_record(result) for name, result in results.items()},
    }
    population = {
        "targets": len(case.targets),
        "input_actors": len(case.start),
        "candidate_actors": len(case.candidate),
        "candidate_pool": len(case.pool),
    }
    return Verdict(
        verifier="repair",
        status="measured",
        score=nominal.f1,
        policy=policy,
        measurements=measurements,
        population=population,
        advisories=advisories(nominal),
        inputs=inputs or {},
    )


def _failure(candidate: Any) -> Literal["error", "not_evaluated"]:
    """Whose failure it is that a candidate snapshot cannot be scored."""
    try:
        scene_actors(candidate, "candidate")
    except BadInput:
        return "error"
    return "not_evaluated"


def verify_repair(input_path: Path, truth_path: Path, candidate_path: Path, policy: str = REPAIR_POLICY) -> Verdict:
    """Score snapshot files.

    A wrong input or truth raises ``BadInput``. A candidate that cannot be scored is a verdict with its reason:
    ``error`` when its export failed (the evaluator's fault), ``not_evaluated`` when the saved scene itself is
    ambiguous, such as two actors under one identity.
    """
    with put_off():
        values, inputs = read_snapshots({"input": input_path, "truth": truth_path, "candidate": candidate_path})
        try:
            return repair_verdict(values["input"], values["truth"], values["candidate"], policy=policy, inputs=inputs)
        except BadInput as error:
            if error.where != "candidate snapshot":
                raise
            return Verdict(
                verifier="repair",
                status=_failure(values["candidate"]),
                policy=policy,
                inputs=inputs,
                reason=error.line(),
            )
