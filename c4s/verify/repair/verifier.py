"""The row of the repair verifier."""

from __future__ import annotations

from typing import Any

from c4s.protocol.settings import INDOOR_REPAIR, OUTDOOR_REPAIR, Setting
from c4s.records.evidence import Evidence
from c4s.records.policy import ScorePolicy
from c4s.records.verdict import Verdict
from c4s.verify.repair.components import repair_components
from c4s.verify.repair.findings import repair_findings
from c4s.verify.repair.verdict import verify_repair
from c4s.verify.verifier import Verifier


def _verify(evidence: Evidence) -> Verdict:
    return verify_repair(
        evidence.path("input_snapshot"), evidence.path("truth_snapshot"), evidence.path("candidate_snapshot")
    )


def _score_under(verdict: Verdict, policy: ScorePolicy, setting: Setting) -> tuple[float | None, dict[str, Any]]:
    counts = verdict.measurements["profiles"][policy.repair_tolerances]
    return counts["f1"], counts


REPAIR = Verifier(
    name="repair",
    title="Repair",
    settings=(INDOOR_REPAIR, OUTDOOR_REPAIR),
    needs=frozenset({"candidate_snapshot", "input_snapshot", "truth_snapshot"}),
    verify=_verify,
    weighed_as="repair_f1",
    parts=repair_components,
    headlines={"repair_precision": "precision", "repair_recall": "recall", "repair_f1": "score"},
    score_under=_score_under,
    findings=repair_findings,
)
