"""Overview Alignment by the offline rule judge (paper, Overview Alignment; ``docs/rule-judge.md``)."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from c4s.judge.rule.judge import RuleJudge
from c4s.judge.rule.overview import Part, dimensions, structural_integrity
from c4s.judge.version import judge_version
from c4s.protocol.bundle import Requirements, read_requirements
from c4s.protocol.numbers import mean
from c4s.protocol.overview import overview_score
from c4s.protocol.rules import OVERVIEW_RULE_POLICY, OVERVIEW_VIEWS
from c4s.records.verdict import Verdict
from c4s.semantics.kinds import Facts
from c4s.semantics.views import read_views


def verify_overview(
    bundle_or_prompt: Mapping[str, Any] | str,
    snapshot: Mapping[str, Any],
    catalog: Mapping[str, Facts],
    captures: Mapping[str, Any] | None = None,
) -> Verdict:
    """Score the four prompt dimensions and structural integrity from state and actor masks.

    Args:
        bundle_or_prompt: a requirement bundle; with a bare prompt nothing it asks for is known, and counts 0.
        snapshot: the candidate scene.
        catalog: asset path to its facts.
        captures: ``captures.json`` of exactly four views with actor masks; anything else is not evaluated.

    A rule judge sees no severe visual defect, so the cap for one never applies.
    """
    requirements = (
        Requirements(bundle_or_prompt, {}, {}, (), {}, {})
        if isinstance(bundle_or_prompt, str)
        else read_requirements(bundle_or_prompt)
    )
    views = read_views(captures)
    if views is None or views.count != OVERVIEW_VIEWS:
        return Verdict(
            verifier="overview",
            status="not_evaluated",
            policy=OVERVIEW_RULE_POLICY,
            measurements={"judge": "rule", "judge_version": judge_version()},
            reason=f"needs {OVERVIEW_VIEWS} overview views with actor masks, has {views.count if views else 0}",
        )
    judge = RuleJudge(requirements, snapshot, catalog)
    parts = dimensions(judge, views)
    scores = {name: mean(part.value for part in rows) for name, rows in parts.items()}
    structure = structural_integrity(judge.things)
    total = overview_score(scores, structure.value, False)
    unknown = [f"{name}.{part.name}" for name, rows in parts.items() for part in rows if not part.known]
    return Verdict(
        verifier="overview",
        status="measured",
        score=total["score"],
        policy=OVERVIEW_RULE_POLICY,
        measurements={
            "judge": "rule",
            "judge_version": judge_version(),
            **{key: value for key, value in total.items() if key not in ("status", "score")},
            "dimensions": {
                name: {"score": scores[name], "parts": [_part(part) for part in rows]} for name, rows in parts.items()
            },
            "structural_integrity_score": structure.value,
            "structural_parts": [_part(structure)],
            "severe_structural_cap_eligible": False,
            "unknown": unknown,
        },
        population={"things": len(judge.things), "views": views.count, "unresolved": len(unknown)},
    )


def _part(part: Part) -> dict[str, Any]:
    return {"name": part.name, "value": part.value, "known": part.known, "detail": part.detail}
