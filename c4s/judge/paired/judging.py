"""The paired judgement of a repair from measures of its pictures alone, and what a model's scores add to it."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping, Sequence

from c4s.errors import BadInput
from c4s.judge.paired.measures import mask_measures, mask_of, picture_of, pixel_measures
from c4s.judge.paired.pairs import ViewPair, view_pairs
from c4s.protocol.numbers import mean
from c4s.protocol.paired import PAIRED_WEIGHTS, blended, paired_score
from c4s.records.evidence import Evidence
from c4s.records.judgement import PairedJudgement, PairedView

NOT_MEASURED = "nothing of the pictures can be compared"


def paired_by_measures(evidence: Evidence) -> tuple[PairedJudgement | None, str]:
    """The dimensions that measures tell of, over all pairs; None with the reason where no pair is there."""
    found, reason = view_pairs(evidence.json("captures"))
    made = [view_of(pair, measured(evidence, pair), {}) for pair in found]
    return paired_of(made) if found else (None, reason)


def measured(evidence: Evidence, pair: ViewPair) -> dict[str, float]:
    """The measures of a pair that its files allow."""
    target, truth = (
        picture_of(evidence.beside_captures(str(view["file"])), str(view["file"])) for view in (pair.target, pair.truth)
    )
    values = pixel_measures(target, truth)
    masks = [view.get("actors") for view in (pair.target, pair.truth)]
    if all(isinstance(mask, str) for mask in masks):
        values |= mask_measures(*(mask_of(evidence.beside_captures(str(mask)), str(mask)) for mask in masks))
    return values


def view_of(pair: ViewPair, measures: Mapping[str, float], said: Mapping[str, float], reason: str = "") -> PairedView:
    """A pair with what was measured and what a model said of it."""
    return PairedView(
        pair=pair.pair,
        target=str(pair.target["name"]),
        truth=str(pair.truth["name"]),
        measures=dict(measures),
        said=dict(said),
        dimensions=blended(said, measures),
        reason=reason,
    )


def paired_of(views: Sequence[PairedView]) -> tuple[PairedJudgement | None, str]:
    """All pairs as one judgement: the mean of each dimension over the views that tell it."""
    told: dict[str, list[float]] = defaultdict(list)
    for view in views:
        for dimension, value in view.dimensions.items():
            told[dimension].append(value)
    dimensions = {name: mean(told[name]) for name in PAIRED_WEIGHTS if told[name]}
    score = paired_score(dimensions)
    if score is None:
        return None, NOT_MEASURED
    return PairedJudgement(views=list(views), dimensions=dimensions, score=min(score, 1.0)), ""


def readable(evidence: Evidence, file: str) -> bytes | None:
    """The bytes of a picture; None where it is no picture."""
    png = evidence.beside_captures(file)
    try:
        picture_of(png, file)
    except BadInput:
        return None
    return png
