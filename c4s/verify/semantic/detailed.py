"""Detailed Alignment by the offline rule judge (paper, Semantic Verifier; ``docs/rule-judge.md``)."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from typing import Any

from c4s.errors import BadInput
from c4s.judge.rule.judge import RuleJudge
from c4s.judge.version import judge_version
from c4s.protocol.bundle import read_requirements
from c4s.protocol.families import attach_families
from c4s.protocol.requirements import protocol_detailed, semantic_case
from c4s.protocol.rules import SEMANTIC_CASE_POLICY
from c4s.records.verdict import Verdict
from c4s.semantics.kinds import Facts
from c4s.semantics.views import read_views


def verify_detailed(
    bundle: Mapping[str, Any],
    snapshot: Mapping[str, Any],
    catalog: Mapping[str, Facts],
    captures: Mapping[str, Any] | None = None,
) -> Verdict:
    """Decide every requirement of a bundle and aggregate the decisions by the published rule.

    Args:
        bundle: requirement bundle in the published format.
        snapshot: the candidate scene.
        catalog: asset path to ``{"name", "category", "tags", "description", "materials"}``.
        captures: ``captures.json``; the visible pixels of the actors are recorded beside each decision.

    Raises ``BadInput`` for a bundle that cannot be read. A bundle without a requirement that counts is not evaluated.
    """
    requirements = read_requirements(bundle)
    judge = RuleJudge(requirements, snapshot, catalog)
    views = read_views(captures)
    rows, decisions = [], []
    for node in requirements.scored:
        predicate, found = requirements.predicates[node], judge.decide(node)
        rows.append(
            {
                "node_id": node,
                "text": predicate.text,
                "source_span": list(predicate.span),
                "predicate_type": predicate.type,
                "entity_scopes": requirements.scopes[node],
                "evaluation_status": found.status,
                "score": found.score,
            }
        )
        decisions.append(
            {
                "node_id": node,
                "text": predicate.text,
                "status": found.status,
                "score": round(found.score, 6),
                "reason": found.reason,
                "actors": found.actors,
                "measures": found.measures,
                "seen_actors": None if views is None else sum(views.sees(actor) for actor in found.actors),
            }
        )
    measurements: dict[str, Any] = {"judge": "rule", "judge_version": judge_version(), "decisions": decisions}
    tally = Counter(decision["status"] for decision in decisions)
    population = {
        "requirements": len(rows),
        "matched": tally["MATCH"],
        "mismatched": tally["MISMATCH"],
        "unresolved": tally["UNKNOWN"],
    }
    try:
        case = semantic_case(requirements.prompt, attach_families(requirements.graph, rows))
        total = protocol_detailed(case)
    except BadInput as error:
        return Verdict(
            verifier="detailed",
            status="not_evaluated",
            policy=SEMANTIC_CASE_POLICY,
            measurements=measurements,
            population=population,
            reason=error.line(),
        )
    if total is None or total["score"] is None:
        return Verdict(
            verifier="detailed",
            status="not_evaluated",
            policy=SEMANTIC_CASE_POLICY,
            measurements=measurements,
            population=population,
            reason="the bundle has no requirement",
        )
    measurements |= {
        "semantic_requirement_aggregation": case["requirements"],
        "families": total["families"],
        "known_coverage": total["known_coverage"],
    }
    return Verdict(
        verifier="detailed",
        status="measured",
        score=total["score"],
        policy=SEMANTIC_CASE_POLICY,
        measurements=measurements,
        population=population | {"active": case["active_requirement_count"]},
    )
