"""What the rule judge writes down: a judgement of every claim, and of the scene as a whole."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from c4s.judge.names import RULE
from c4s.judge.paired.judging import paired_by_measures
from c4s.judge.rule.overview import DimensionPart, dimensions, structural_integrity
from c4s.judge.rule.pixels import ActorColors
from c4s.judge.rule.version import rule_version
from c4s.protocol.bundle import Requirements, read_requirements
from c4s.protocol.numbers import mean
from c4s.protocol.rules import OVERVIEW_VIEWS
from c4s.protocol.settings import is_construction
from c4s.records.evidence import Evidence
from c4s.records.judgement import ClaimJudgement, Judgements, OverviewDimension, OverviewJudgement, OverviewPart
from c4s.semantics.binding import binding_of
from c4s.semantics.kinds import Facts
from c4s.semantics.state import ActorColor, StateDecider
from c4s.semantics.views import Views, read_views


def judge_evidence(evidence: Evidence) -> Judgements:
    """What the rule judge says of a submission: of a construction by its claims, of a repair by measures of
    pictures."""
    if not is_construction(evidence.setting):
        paired, reason = paired_by_measures(evidence)
        return Judgements(
            judge=RULE,
            judge_version=rule_version(),
            claims=[],
            overview_reason="a repair has no overview",
            paired=paired,
            paired_reason=reason,
        )
    return judge_by_rule(
        evidence.json("requirements") if evidence.has("requirements") else None,
        evidence.prompt,
        evidence.json("candidate_snapshot"),
        evidence.catalog(),
        evidence.json("captures"),
        evidence.json("binding") if evidence.has("binding") else None,
        ActorColors(evidence).shows,
    )


def judge_by_rule(
    bundle: Mapping[str, Any] | None,
    prompt: str,
    snapshot: Mapping[str, Any],
    catalog: Mapping[str, Facts],
    captures: Mapping[str, Any] | None = None,
    binding: Mapping[str, Any] | None = None,
    colors: ActorColor | None = None,
) -> Judgements:
    """Judge every requirement of a bundle, and the four overview dimensions, from state and actor masks.

    Args:
        bundle: requirement bundle in the published format; without one nothing that the prompt asks for is known.
        prompt: the task's text.
        snapshot: the candidate scene.
        catalog: asset path to ``{"name", "category", "tags", "description", "materials"}``.
        captures: ``captures.json``; an overview needs exactly four views with actor masks.
        binding: the case's frozen binding as plain data; without one it is made here.
        colors: what the pictures show of an actor's colour; without it colours are known by assets alone.

    A rule judge sees no severe visual defect, so the cap for one never applies. Raises ``BadInput`` for a bundle that
    cannot be read, and for a binding of another bundle or catalog.
    """
    requirements = Requirements(prompt, {}, {}, (), {}, {}) if bundle is None else read_requirements(bundle)
    judge = StateDecider(requirements, snapshot, catalog, binding_of(requirements, catalog, binding), colors)
    views = read_views(captures)
    enough = views is not None and views.count == OVERVIEW_VIEWS
    return Judgements(
        judge=RULE,
        judge_version=rule_version(),
        claims=[_claim(judge, node, views) for node in requirements.scored],
        overview=_overview(judge, views) if views is not None and enough else None,
        overview_reason=""
        if enough
        else f"needs {OVERVIEW_VIEWS} overview views with actor masks, has {views.count if views else 0}",
    )


def _claim(judge: StateDecider, node: str, views: Views | None) -> ClaimJudgement:
    found = judge.decide(node)
    return ClaimJudgement(
        claim=node,
        answer=found.status,
        score=found.score,
        reason=found.reason,
        actors=found.actors,
        measures=found.measures,
        seen_actors=None if views is None else sum(views.sees(actor) for actor in found.actors),
    )


def _overview(judge: StateDecider, views: Views) -> OverviewJudgement:
    structure = structural_integrity(judge.things)
    return OverviewJudgement(
        dimensions={
            name: OverviewDimension(score=mean(part.value for part in rows), parts=_parts(rows))
            for name, rows in dimensions(judge, views).items()
        },
        structural_integrity_score=structure.value,
        structural_parts=_parts([structure]),
        things=len(judge.things),
    )


def _parts(rows: Sequence[DimensionPart]) -> list[OverviewPart]:
    return [OverviewPart(name=part.name, value=part.value, known=part.known, detail=part.detail) for part in rows]
