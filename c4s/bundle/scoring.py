"""Scoring an evidence bundle from what it records, by the functions that score a run.

Repair F1 and the support rule of constructions are computed from the snapshots. Support of repairs, penetration, the
requirement decisions and the overview judgement are taken as recorded.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from c4s.bundle.reading import EvidenceBundle
from c4s.errors import BadInput
from c4s.protocol.detailed import detailed_from_report
from c4s.protocol.numbers import unit_number
from c4s.protocol.overview import overview_score
from c4s.protocol.physics import physics_from_report
from c4s.protocol.rules import GATE, INTEGRITY_POLICY, OVERVIEW_RULE_POLICY, PHYSICS_POLICY, SEMANTIC_CASE_POLICY
from c4s.protocol.settings import is_construction
from c4s.records.score import TrialScore
from c4s.records.snapshot_faults import scene_fault
from c4s.records.verdict import Verdict
from c4s.score.case import case_score
from c4s.verify.physics.support import text_to_scene_support
from c4s.verify.physics.verifier import PHYSICS
from c4s.verify.registry import weighed_of
from c4s.verify.repair import repair_verdict
from c4s.verify.repair.verifier import REPAIR
from c4s.verify.semantic.verifier import DETAILED, OVERVIEW

MINIMUM_ACTORS = 1


@dataclass(frozen=True, slots=True)
class BundleScore:
    """The case score of a bundle and the verdicts behind it."""

    score: TrialScore
    verdicts: dict[str, Verdict]


def score_bundle(bundle: EvidenceBundle, *, minimum_actors: int = MINIMUM_ACTORS) -> BundleScore:
    """Score a bundle under the published policy of its setting.

    Args:
        bundle: from ``read_bundle``.
        minimum_actors: of the case; fewer actors in the candidate snapshot make it invalid.

    Raises ``BadInput`` for evidence that cannot be scored.
    """
    manifest = bundle.manifest
    setting = manifest.task.setting
    scenes = manifest.scenes
    candidate = bundle.json(scenes.candidate) if scenes and scenes.candidate else None
    verdicts: dict[str, Verdict] = {}
    submitted = manifest.submitted
    if submitted:
        verdicts[GATE] = _integrity(bundle, candidate, minimum_actors)
    if submitted and verdicts[GATE].status == "valid":
        verdicts |= {row.name: _RECORDED[row.name](bundle, candidate) for row in weighed_of(setting)}
    model = manifest.run.model if manifest.run else None
    score = case_score(
        case_id=manifest.task.id,
        setting=setting,
        configuration=model or "unnamed",
        repeat=1,
        judge="recorded",
        engine=_engine(candidate),
        submitted=submitted,
        verdicts=verdicts,
    )
    return BundleScore(score, verdicts)


def _engine(candidate: Any) -> str:
    own = candidate.get("c4s") if isinstance(candidate, Mapping) else None
    return str(own.get("engine", "unreal")) if isinstance(own, Mapping) else "unreal"


def _integrity(bundle: EvidenceBundle, candidate: Any, minimum_actors: int) -> Verdict:
    """The recorded verdict; of a candidate snapshot the schema and the minimum are checked again."""
    recorded = bundle.manifest.candidate_integrity
    if recorded is None:
        raise BadInput("the bundle has no candidate_integrity", where=str(bundle.root))
    failed = recorded.failed_leaf()
    reason = ""
    if recorded.status == "invalid":
        reason = str(recorded.failure_reason or "invalid")
    elif candidate is not None and (fault := scene_fault(candidate)):
        reason = f"snapshot_schema: {fault}"
    elif candidate is not None and len(candidate["actors"]) < minimum_actors:
        reason = f"minimum_actors: {len(candidate['actors'])} of at least {minimum_actors} actors"
    elif candidate is not None and failed:
        reason = f"{failed} is recorded as {(recorded.leaves or {})[failed]!r}"
    return Verdict(
        verifier=GATE,
        status="invalid" if reason else "valid",
        policy=INTEGRITY_POLICY,
        measurements={"leaves": recorded.leaves or {}},
        reason=reason,
    )


def _physics(bundle: EvidenceBundle, scene: Any) -> Verdict:
    """From the recorded report; the snapshot of a construction with a tested actor gives the support leaf anew."""
    recorded = bundle.manifest.physics
    report = bundle.json(recorded.report) if recorded and recorded.report else None
    if report is not None and not isinstance(report, Mapping):
        raise BadInput("the physics report is not an object", where=str(bundle.root))
    rate, whole = None, is_construction(bundle.manifest.task.setting)
    if whole and scene is not None:
        try:
            rate = text_to_scene_support(scene).rate
        except ValueError as error:
            raise BadInput(f"support cannot be measured: {error}", where=str(bundle.root)) from None
    total = physics_from_report(report, rate, whole_scene=whole)
    return Verdict(
        verifier=PHYSICS.name,
        status="measured",
        score=total["score"],
        policy=PHYSICS_POLICY,
        measurements={"leaves": total["leaves"], "floating_source": total["floating_source"]},
    )


def _repair(bundle: EvidenceBundle, candidate: Any) -> Verdict:
    scenes = bundle.manifest.scenes
    if scenes is None or scenes.input is None or scenes.ground_truth is None:
        raise BadInput("the bundle lacks scenes", where=str(bundle.root))
    return repair_verdict(
        bundle.json(scenes.input),
        bundle.json(scenes.ground_truth),
        candidate,
        inputs={
            path: bundle.manifest.files[path] for path in (scenes.input, scenes.ground_truth, scenes.candidate) if path
        },
    )


def _semantic(verifier: str, policy: str, made: Mapping[str, Any]) -> Verdict:
    if made["score"] is None:
        return Verdict(
            verifier=verifier, status="not_evaluated", policy=policy, reason=f"recorded status {made['status']}"
        )
    if unit_number(made["score"]) is None:
        raise BadInput(f"what is recorded for {verifier} makes {made['score']}, which is no score in [0, 1]")
    return Verdict(
        verifier=verifier,
        status="measured",
        score=made["score"],
        policy=policy,
        measurements={key: value for key, value in made.items() if key not in ("status", "score")},
    )


def _detailed(bundle: EvidenceBundle, candidate: Any) -> Verdict:
    semantic = bundle.manifest.semantic
    found = bundle.json(semantic.decisions) if semantic and semantic.decisions else {"decisions": []}
    document = {"report_status": "measured", "decisions": found} if isinstance(found, list) else found
    if not isinstance(document, Mapping) or not isinstance(document.get("decisions") or [], list):
        raise BadInput('the decisions are not {"report_status", "decisions": [...]}', where=str(bundle.root))
    return _semantic(
        DETAILED.name,
        SEMANTIC_CASE_POLICY,
        detailed_from_report(
            {
                "status": document.get("report_status"),
                "metrics": {"semantic_requirement_aggregation": document.get("decisions")},
            }
        ),
    )


def _overview(bundle: EvidenceBundle, candidate: Any) -> Verdict:
    overview = bundle.manifest.overview
    found = bundle.json(overview.judgement) if overview and overview.judgement else None
    if not found:
        return _semantic(OVERVIEW.name, OVERVIEW_RULE_POLICY, {"status": "missing", "score": None})
    if not isinstance(found, Mapping) or not isinstance(found.get("dimension_scores"), Mapping):
        raise BadInput("the overview judgement has no dimension_scores", where=str(bundle.root))
    return _semantic(
        OVERVIEW.name,
        OVERVIEW_RULE_POLICY,
        overview_score(
            found["dimension_scores"],
            found.get("structural_integrity_score"),
            bool(found.get("severe_structural_cap_eligible")),
        ),
    )


_RECORDED: dict[str, Callable[[EvidenceBundle, Any], Verdict]] = {
    PHYSICS.name: _physics,
    REPAIR.name: _repair,
    DETAILED.name: _detailed,
    OVERVIEW.name: _overview,
}
"""How each verifier's verdict is made from what a bundle records."""
