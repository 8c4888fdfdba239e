"""Overview Alignment: what a judge said of the scene in its four overview views (paper, Overview Alignment)."""

from __future__ import annotations

from typing import Any

from c4s.protocol.overview import overview_score
from c4s.protocol.rules import OVERVIEW_MODEL_POLICY, OVERVIEW_RULE_POLICY, OVERVIEW_VIEWS
from c4s.records.judgement import Judgements, OverviewPart
from c4s.records.verdict import Verdict
from c4s.verify.faults import accepted_faults


def verify_overview(judgements: Judgements) -> Verdict:
    """Score the four prompt dimensions and structural integrity. Without an overview judgement it is not evaluated."""
    made = {"judge": judgements.judge, "judge_version": judgements.judge_version}
    said = judgements.overview
    policy = OVERVIEW_RULE_POLICY if judgements.kind == "rule" else OVERVIEW_MODEL_POLICY
    if said is None:
        return Verdict(
            verifier="overview",
            status="not_evaluated",
            policy=policy,
            measurements=made,
            advisories=accepted_faults(judgements),
            reason=judgements.overview_reason,
        )
    scores = {name: dimension.score for name, dimension in said.dimensions.items()}
    total = overview_score(scores, said.structural_integrity_score, said.severe_structural_cap_eligible)
    unknown = [
        f"{name}.{part.name}"
        for name, dimension in said.dimensions.items()
        for part in dimension.parts
        if not part.known
    ]
    population = {"views": len(said.views) or OVERVIEW_VIEWS, "unresolved": len(unknown)}
    return Verdict(
        verifier="overview",
        status="measured",
        score=total["score"],
        policy=policy,
        advisories=accepted_faults(judgements),
        measurements={
            **made,
            **{key: value for key, value in total.items() if key not in ("status", "score")},
            "dimensions": {
                name: {"score": dimension.score, "parts": _plain(dimension.parts), "reason": dimension.reason}
                for name, dimension in said.dimensions.items()
            },
            "structural_integrity_score": said.structural_integrity_score,
            "structural_parts": _plain(said.structural_parts),
            "structural_reason": said.structural_reason,
            "severe_structural_cap_eligible": said.severe_structural_cap_eligible,
            "severe": None if said.severe is None else said.severe.plain(),
            "summary": said.summary,
            "unknown": unknown,
        },
        population=population if said.things is None else {"things": said.things} | population,
    )


def _plain(parts: list[OverviewPart]) -> list[dict[str, Any]]:
    return [part.plain() for part in parts]
