"""The repair verdict: F1 of a saved scene with its counts, explanation, tolerance profiles and advisories."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from c4s.errors import BadInput
from c4s.files import digest_bytes
from c4s.verify.repair.advisories import advisories
from c4s.verify.repair.counts import RepairResult, count, prepare_case
from c4s.verify.repair.explanation import false_positive_rows, target_rows
from c4s.verify.repair.policy import NOMINAL, PROFILES, REPAIR_POLICY
from c4s.verify.repair.reading import read_snapshot
from c4s.verify.verdict import Verdict


def counts_record(result: RepairResult) -> dict[str, Any]:
    """Counts and scores of a result, unrounded."""
    return {"tp": result.tp, "fp": result.fp, "fn": result.fn, "precision": result.precision,
            "recall": result.recall, "f1": result.f1}


def repair_verdict(start: Any, truth: Any, candidate: Any, *, policy: str = REPAIR_POLICY,
                   inputs: dict[str, str] | None = None) -> Verdict:
    """Score plain snapshots under the nominal profile; strict and relaxed are recorded beside it.

    Raises ``BadInput`` when the scenes cannot be scored.
    """
    case = prepare_case(start, truth, candidate)
    results = {name: count(case, limits) for name, limits in PROFILES.items()}
    nominal = results[NOMINAL.name]
    measurements = counts_record(nominal) | {
        "present_targets": sum(t.truth is not None for t in case.targets),
        "removal_targets": sum(t.truth is None for t in case.targets),
        "targets": target_rows(nominal), "false_positives": false_positive_rows(nominal),
        "profiles": {name: counts_record(result) for name, result in results.items()}}
    population = {"targets": len(case.targets), "input_actors": len(case.start),
                  "candidate_actors": len(case.candidate), "candidate_pool": len(case.pool)}
    return Verdict(verifier="repair", status="measured", score=nominal.f1, policy=policy, measurements=measurements,
                   population=population, advisories=advisories(nominal), inputs=inputs or {})


def verify_repair(input_path: Path, truth_path: Path, candidate_path: Path, policy: str = REPAIR_POLICY) -> Verdict:
    """Score snapshot files.

    A candidate that cannot be scored (an export that failed, ambiguous identities) is a verdict ``error`` with its
    reason: evidence is made by the evaluator's own engine, so it is never the agent's score. A wrong input or truth
    raises ``BadInput``.
    """
    values, inputs = {}, {}
    for name, path in (("input", input_path), ("truth", truth_path), ("candidate", candidate_path)):
        values[name], data = read_snapshot(path)
        inputs[f"{name}_snapshot"] = digest_bytes(data)
    try:
        return repair_verdict(values["input"], values["truth"], values["candidate"], policy=policy, inputs=inputs)
    except BadInput as error:
        if error.where != "candidate snapshot":
            raise
        return Verdict(verifier="repair", status="error", policy=policy, inputs=inputs, reason=error.line())
