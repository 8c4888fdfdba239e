"""The rows of Detailed and Overview Alignment. Both read judgements, whoever made them."""

from __future__ import annotations

from typing import Any

from c4s.protocol.detailed import detailed_score
from c4s.protocol.overview import overview_score
from c4s.protocol.rules import SEMANTIC_CASE_POLICY
from c4s.protocol.settings import TEXT_TO_SCENE, Setting
from c4s.records.evidence import Evidence
from c4s.records.judgement import Judgements
from c4s.records.policy import ScorePolicy
from c4s.records.verdict import Verdict
from c4s.verify.semantic.components import detailed_components, overview_components
from c4s.verify.semantic.detailed import verify_detailed
from c4s.verify.semantic.findings import detailed_findings
from c4s.verify.semantic.overview import verify_overview
from c4s.verify.verifier import Verifier


def _judgements(evidence: Evidence) -> Judgements:
    return Judgements.opened(evidence.json("judgements"), where=str(evidence.path("judgements")))


def _verify_detailed(evidence: Evidence) -> Verdict:
    if not evidence.has("requirements"):
        return Verdict(
            verifier="detailed",
            status="not_evaluated",
            policy=SEMANTIC_CASE_POLICY,
            reason="the case has no requirement bundle",
        )
    return verify_detailed(evidence.json("requirements"), _judgements(evidence))


def _verify_overview(evidence: Evidence) -> Verdict:
    return verify_overview(_judgements(evidence))


def _detailed_under(verdict: Verdict, policy: ScorePolicy, setting: Setting) -> tuple[float | None, dict[str, Any]]:
    made = detailed_score(verdict.measurements["semantic_requirement_aggregation"], policy.families)
    return made["score"], {"known_coverage": made.get("known_coverage")}


def _overview_under(verdict: Verdict, policy: ScorePolicy, setting: Setting) -> tuple[float | None, dict[str, Any]]:
    stored = verdict.measurements
    dimensions = {name: row["score"] for name, row in stored["dimensions"].items()}
    structure, severe = stored["structural_integrity_score"], stored["severe_structural_cap_eligible"]
    return overview_score(dimensions, structure, severe, policy.overview)["score"], {}


DETAILED = Verifier(
    name="detailed",
    title="Detailed",
    settings=(TEXT_TO_SCENE,),
    needs=frozenset({"requirements", "judgements"}),
    verify=_verify_detailed,
    weighed_as="detailed",
    parts=detailed_components,
    headlines={"detailed": "score", "known_coverage": "known_coverage"},
    score_under=_detailed_under,
    findings=detailed_findings,
)
OVERVIEW = Verifier(
    name="overview",
    title="Overview",
    settings=(TEXT_TO_SCENE,),
    needs=frozenset({"judgements"}),
    verify=_verify_overview,
    weighed_as="overview",
    parts=overview_components,
    headlines={"overview": "score"},
    score_under=_overview_under,
)
