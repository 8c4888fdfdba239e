"""Detailed Alignment: the judgements of all requirements, aggregated as published (paper, Semantic Verifier)."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from typing import Any

from c4s.errors import BadInput
from c4s.protocol.bundle import read_requirements
from c4s.protocol.families import attach_families
from c4s.protocol.requirements import protocol_detailed, semantic_case
from c4s.protocol.rules import SEMANTIC_CASE_POLICY
from c4s.records.judgement import Judgements
from c4s.records.verdict import Verdict
from c4s.verify.faults import accepted_faults
from c4s.verify.semantic.existence import ExistenceChecks


def verify_detailed(bundle: Mapping[str, Any], judgements: Judgements) -> Verdict:
    """Aggregate what a judge said of every requirement of a bundle.

    Raises ``BadInput`` for a bundle that cannot be read, and for judgements that do not answer it claim by claim. A
    bundle without a requirement that counts is not evaluated.
    """
    requirements = read_requirements(bundle)
    said = {claim.claim: claim for claim in judgements.claims}
    if set(said) != set(requirements.scored):
        odd = sorted(set(said) ^ set(requirements.scored))
        raise BadInput(
            f"the judgements do not answer this requirement bundle: {', '.join(odd[:3])}", todo="judge the trial again"
        )
    rows, decisions, existence = [], [], ExistenceChecks(requirements, said)
    for node in requirements.scored:
        predicate, found = requirements.predicates[node], said[node]
        rows.append(
            {
                "node_id": node,
                "text": predicate.text,
                "source_span": list(predicate.span),
                "predicate_type": predicate.type,
                "entity_scopes": requirements.scopes[node],
                "evaluation_status": found.answer,
                "score": found.score,
            }
        )
        decisions.append(
            {
                "node_id": node,
                "text": predicate.text,
                "predicate_type": predicate.type,
                "status": found.answer,
                "score": round(found.score, 6),
                "reason": found.reason,
                "stage": found.stage,
                "confidence": found.confidence,
                "fallback": found.fallback,
                "views": found.cited,
                "actors": found.actors,
                "measures": found.measures,
                "seen_actors": found.seen_actors,
                "existence": existence.of(node),
            }
        )
    measurements: dict[str, Any] = {"judge": judgements.judge, "judge_version": judgements.judge_version}
    measurements["decisions"] = decisions
    tally = Counter(decision["status"] for decision in decisions)
    population = {
        "requirements": len(rows),
        "matched": tally["MATCH"],
        "mismatched": tally["MISMATCH"],
        "unresolved": tally["UNKNOWN"],
    } | _beyond(judgements, tally)
    try:
        case = semantic_case(requirements.prompt, attach_families(requirements.graph, rows))
        total = protocol_detailed(case)
        reason = "the bundle has no requirement"
    except BadInput as error:
        total, reason = None, error.line()
    if total is None or total["score"] is None:
        return Verdict(
            verifier="detailed",
            status="not_evaluated",
            policy=SEMANTIC_CASE_POLICY,
            measurements=measurements,
            population=population,
            advisories=accepted_faults(judgements),
            reason=reason,
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
        advisories=accepted_faults(judgements),
    )


def _beyond(judgements: Judgements, tally: Mapping[Any, int]) -> dict[str, int]:
    """What only a judge that looks can come to; told where it did."""
    found = {
        "not_evaluated": tally["NOT_EVALUATED"],
        "errors": tally["ERROR"],
        "fallbacks": sum(claim.fallback for claim in judgements.claims),
        "by_sight": sum(claim.stage != "state" for claim in judgements.claims),
    }
    return {name: count for name, count in found.items() if count}
