"""A weight fit of the published study's size, against scoring the same policies one by one by the protocol.

``python -m bench.human_fit`` prints which weights are found where annotators of a known taste answered.
"""

from __future__ import annotations

import time
from itertools import product

import numpy as np

from bench.made_people import SURE, planted_scores, rankings, scenes
from bench.row import Row
from c4s.stats.human import (
    ADOPTED,
    POINTS,
    Objective,
    Preferences,
    SceneTable,
    SubscoreWeights,
    WeightFit,
    fit,
    proposals,
    score_under,
)

DEVELOPMENT, NOISY = 12, 30.0
SIZES = (DEVELOPMENT, 40, 100)
_GOAL = 20
_SAMPLE = 40
"""Policies that are scored one by one."""


def fitted(prompts: int, taste: SubscoreWeights, sharpness: float, seed: int = 4) -> tuple[Objective, WeightFit]:
    """What is found on some prompts from answers of annotators of a taste."""
    table = SceneTable.of(scenes(prompts, seed))
    votes = Preferences.of(rankings(planted_scores(table, taste), seed, sharpness), prompts, POINTS).units()
    objective = Objective(table, votes, POINTS, ADOPTED.hundredths())
    return objective, fit(objective)


def rows() -> list[Row]:
    """One fit of twelve prompts."""
    taste = SubscoreWeights.of(proposals(17, 1)[0])
    began = time.perf_counter()
    objective, found = fitted(DEVELOPMENT, taste, NOISY)
    ours = time.perf_counter() - began
    some = [SubscoreWeights.of(policy) for policy in proposals(1, _SAMPLE)]
    began = time.perf_counter()
    for weights, scene in product(some, objective.scenes.scenes):
        score_under(scene, weights)
    looked_at = sum(found.looked_at.values())
    theirs = (time.perf_counter() - began) / _SAMPLE * looked_at
    return [
        Row(
            f"weight fit, {DEVELOPMENT} prompts, {looked_at:,} policies",
            ours,
            f"{_GOAL} times faster",
            theirs / ours >= _GOAL,
            rival="scoring them one by one by the protocol",
            theirs=theirs,
            ratio=theirs / ours,
        )
    ]


def main() -> None:
    """Planted and found weights in hundredths: families, dimensions, leaves, final shares."""
    for planted in proposals(17, 3):
        taste = SubscoreWeights.of(planted)
        print(f"planted{'':39}{planted}")
        for prompts, (hands, sharpness) in product(SIZES, (("sure", SURE), ("noisy", NOISY))):
            objective, found = fitted(prompts, taste, sharpness)
            reached = objective.standings(planted[None])[0, 0]
            told = f"{prompts:>4} prompts, {hands:<5} {found.standing.agreement:.3f} (planted {reached:.3f})"
            print(f"  {told:<44}{found.hundredths}  off by {np.abs(found.hundredths - planted).max()}")


if __name__ == "__main__":
    main()
