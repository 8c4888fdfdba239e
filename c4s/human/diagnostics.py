"""Diagnostic rankings beside the part of the score that each is compared with (paper, ``sec:human-alignment``)."""

from __future__ import annotations

import numpy as np

from c4s.human.components import scene_of
from c4s.human.study import OpenStudy
from c4s.human.tables import BOTH, MEASURED, measured_row
from c4s.protocol.criteria import CRITERIA, PRIMARY
from c4s.protocol.rules import FAMILY_WEIGHTS, T2S_WEIGHTS
from c4s.records.analysis import Column, Table
from c4s.stats.human import (
    ADOPTED,
    SavedScene,
    SubscoreWeights,
    between_annotators,
    log_worths,
    macro_mean,
    score_under,
    tau_by_prompt,
    with_scores,
)


def diagnostics(opened: OpenStudy) -> list[Table]:
    """How far each part of the score agrees with the ranking that asks for it, over all prompts.

    None where only the primary criterion was asked. A prompt that does not ask for a family has no value there.
    """
    study, rows = opened.study, []
    saved = {one.candidate: scene_of(one) for part in BOTH for one in opened.saved(part).candidates}
    for criterion, asked in CRITERIA.items():
        orders = opened.orders(*BOTH, criterion=criterion)
        if criterion == PRIMARY or not orders:
            continue
        scores = np.array(
            [[part_score(saved[one.candidate], asked.part) for one in prompt.candidates] for prompt in study.prompts]
        )
        preferences = opened.preferences(*BOTH, criterion=criterion)
        worths = log_worths(orders, len(study.prompts), opened.candidates())
        for measure, by_prompt in (
            ("individual preferences", with_scores(scores, preferences)),
            ("tau-b with the consensus", tau_by_prompt(scores, worths)),
            ("two annotators on one pair", between_annotators(preferences)),
        ):
            value = macro_mean(by_prompt, study.seed)
            rows.append(measured_row({"criterion": asked.title, "part": asked.part, "measure": measure}, value))
    names = [Column(name=name, title=name) for name in ("criterion", "part", "measure")]
    title = "Diagnostic criteria and the parts of the score they ask for"
    return [Table(name="diagnostics", title=title, columns=[*names, *MEASURED], rows=rows)] if rows else []


def part_score(scene: SavedScene, part: str) -> float:
    """The score of a family or of a component; NaN for a family that the prompt does not ask for."""
    if part in T2S_WEIGHTS:
        final = {name: float(name == part) for name in T2S_WEIGHTS}
        return score_under(scene, SubscoreWeights(ADOPTED.families, ADOPTED.dimensions, ADOPTED.leaves, final))
    return {str(name): scene.families.get(name, float("nan")) for name in FAMILY_WEIGHTS}[part]
