"""How far a study's annotators agree with each other. No score enters, so it may be asked at any time."""

from __future__ import annotations

import numpy as np

from c4s.errors import BadInput
from c4s.human.study import OpenStudy
from c4s.human.tables import BOTH, MEASURED, intervals, measured_row
from c4s.protocol.criteria import CRITERIA, CriterionName
from c4s.records.analysis import Column, Findings, Table, Value
from c4s.stats.human import (
    Preferences,
    Progress,
    between_annotators,
    between_groups,
    krippendorff_alpha,
    left_out,
    macro_mean,
)

CHANCE = 0.5


def agreement(opened: OpenStudy, criterion: CriterionName, told: Progress | None = None) -> Findings:
    """Agreement on a criterion within prompts, of all prompts and of both parts of the split.

    ``BadInput`` where nothing came back for the criterion.
    """
    study = opened.study
    orders, preferences = opened.orders(*BOTH, criterion=criterion), opened.preferences(*BOTH, criterion=criterion)
    if not orders:
        raise BadInput(f"there is no ranking by {criterion!r}", where=study.study, todo="c4s human intake")
    prompts, candidates = len(study.prompts), opened.candidates()
    between = between_annotators(preferences)
    shares, taus = between_groups(orders, prompts, candidates, study.seed, told)
    rows = []
    for name, cases in _parts(opened).items():
        own = np.array([prompt.case_id in cases for prompt in study.prompts])
        some = preferences.only(own[preferences.prompt])
        for title, value in (
            ("two annotators on one pair", macro_mean(between[own], study.seed)),
            ("Krippendorff's alpha, nominal", krippendorff_alpha(some, study.seed)),
            ("two groups of annotators, pairs of their consensus", macro_mean(shares[own], study.seed)),
            ("two groups of annotators, tau-b of their consensus", macro_mean(taus[own], study.seed)),
        ):
            rows.append(measured_row({"measure": title, "prompts of": name}, value))
    columns = [Column(name="measure", title="measure"), Column(name="prompts of", title="prompts of"), *MEASURED]
    question = CRITERIA[criterion].title
    return Findings(
        tables=[
            Table(name="people", title=f"Agreement of people: {question}", columns=columns, rows=rows),
            _annotators(opened, preferences, left_out(orders, prompts, candidates, told)),
        ],
        intervals=[intervals(name, len(cases), study.seed) for name, cases in _parts(opened).items()],
        notes=[
            f"{len(orders)} rankings, {len(preferences)} pairwise preferences. All is computed within prompts, then "
            "averaged over them; alpha is of all pairs together.",
            "An annotator whose interval reaches down to 0.5 is not told from one who clicks at random.",
        ],
    )


def _parts(opened: OpenStudy) -> dict[str, list[str]]:
    study = opened.study
    return {"all": [*study.development, *study.holdout], "development": study.development, "holdout": study.holdout}


def _annotators(opened: OpenStudy, preferences: Preferences, found: dict[int, np.ndarray]) -> Table:
    rows: list[dict[str, Value]] = []
    for number, by_prompt in found.items():
        value = macro_mean(by_prompt, opened.study.seed)
        row = measured_row({"annotator": opened.study.annotators[number]}, value)
        row["preferences"] = int((preferences.annotator == number).sum())
        row["like chance"] = not value.low > CHANCE
        rows.append(row)
    return Table(
        name="annotators",
        title="Each annotator's preferences against the consensus of the others",
        columns=[
            Column(name="annotator", title="annotator"),
            Column(name="preferences", title="preferences"),
            *MEASURED,
            Column(name="like chance", title="like chance"),
        ],
        rows=rows,
    )
