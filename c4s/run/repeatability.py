"""What the repeats of a study come to: scores, agreement of ranks, deviations, fallbacks."""

from __future__ import annotations

import statistics
from collections.abc import Sequence

from c4s.errors import BadInput
from c4s.protocol.rules import FAMILY_WEIGHTS
from c4s.records.judgement import Judgements, JudgeUsage
from c4s.records.repeatability import (
    RankOrder,
    Repeatability,
    RepeatAgreement,
    RepeatedConfiguration,
    RepeatedScene,
    ServedRepeat,
)
from c4s.run.check import judged_digests
from c4s.run.inputs import evidence_in, inputs
from c4s.run.repeating import JudgedScene, Study, said_of
from c4s.stats.repeats import agreements, as_table, centred, rank_stability, sample_deviations
from c4s.verify.registry import make_verdict
from c4s.verify.semantic.verifier import DETAILED


def repeatability(study: Study) -> Repeatability:
    """The findings over all repeats of a study. ``BadInput`` where one is missing."""
    plan, scenes, said = study.plan, [], []
    for scene, judgements in said_of(study):
        scenes.append(_scene(study, scene, judgements))
        said.append(judgements)
    names = list(dict.fromkeys(scene.configuration for scene in scenes))
    means = as_table([[_mean(scenes, name, number) for name in names] for number in range(study.repeats)])
    ranks, deviations, off = rank_stability(means), sample_deviations(means), centred(means)
    by_repeat = [[rows[number] for rows in said if rows] for number in range(study.repeats)]
    return Repeatability(
        study=study.folder.root.name,
        run_id=plan.run_id,
        suite_id=plan.suite_id,
        suite_digest=plan.suite_digest,
        judge=plan.judge,
        judge_version=plan.judge_version,
        repeats=study.repeats,
        family_weights=dict(FAMILY_WEIGHTS),
        evaluations=len(scenes) * study.repeats,
        requests_per_repeat=sum(scene.requests for scene in scenes),
        asked_again=sum(sum(scene.asked_again) for scene in scenes),
        fallbacks=sum(sum(scene.fallbacks) for scene in scenes),
        configurations=[
            RepeatedConfiguration(
                configuration=names[column],
                rank=rank,
                means=means[:, column].tolist(),
                mean=float(means[:, column].mean()),
                sd=0.0 if deviations is None else deviations[column],
                deviations=off[:, column].tolist(),
            )
            for rank, column in enumerate(ranks.order, start=1)
        ],
        agreements=[RepeatAgreement(repeats=one.repeats, tau_b=one.tau_b) for one in agreements(means)],
        ranks=RankOrder(
            leading=ranks.leading,
            kept=list(ranks.kept),
            bands=[(band.first, band.last) for band in ranks.bands],
            reversals=ranks.reversals,
        ),
        scenes=scenes,
        served=[ServedRepeat.of([one.served for one in rows if one.served is not None]) for rows in by_repeat],
        usage=[_used(rows) for rows in by_repeat],
    )


def _scene(study: Study, scene: JudgedScene, said: Sequence[Judgements]) -> RepeatedScene:
    trial, judged = scene.trial, scene.judged
    requests = 0 if judged is None else len(judged.claim_schedule())
    return RepeatedScene(
        configuration=trial.configuration.name,
        case_id=trial.case.case_id,
        trial_repeat=trial.repeat,
        judgements_sha256=None if judged is None else judged.sha256(),
        requests=requests,
        scores=_scores(study, scene) if said else [0.0] * study.repeats,
        fallbacks=[sum(claim.fallback for claim in (*one.claims, *one.beneath)) for one in said] or [0] * study.repeats,
        asked_again=[len(one.schedule) - requests for one in said] or [0] * study.repeats,
    )


def _scores(study: Study, scene: JudgedScene) -> list[float]:
    """Detailed Alignment of a scene in every repeat, at the adopted weights."""
    trial, made = scene.trial, []
    given, noted = inputs(trial), judged_digests(trial.folder)
    for number in range(1, study.repeats + 1):
        judgements = study.folder.repeat(scene.place, number)
        verdict = make_verdict(DETAILED.name, evidence_in(trial.folder.evidence, given, judgements, noted))
        if verdict.score is None:
            raise BadInput(f"{trial.name} has no Detailed Alignment: {verdict.reason}", todo="leave it out with --case")
        made.append(verdict.score)
    return made


def _mean(scenes: Sequence[RepeatedScene], configuration: str, number: int) -> float:
    return statistics.fmean(scene.scores[number] for scene in scenes if scene.configuration == configuration)


def _used(said: Sequence[Judgements]) -> JudgeUsage:
    used = [one.usage for one in said if one.usage is not None]
    costs = [one.cost_usd for one in used]
    return JudgeUsage(
        requests=sum(one.requests for one in used),
        failures=sum(one.failures for one in used),
        input_tokens=sum(one.input_tokens for one in used),
        output_tokens=sum(one.output_tokens for one in used),
        unknown=sum(one.unknown for one in used),
        cost_usd=None if None in costs else sum(cost for cost in costs if cost is not None),
    )
