"""Scenes and annotators of known taste."""

from __future__ import annotations

from collections.abc import Collection

import numpy as np

from c4s.protocol.rules import FAMILY_WEIGHTS, OVERVIEW_WEIGHTS, PHYSICS_LEAF_WEIGHTS
from c4s.stats.bootstrap import Floats
from c4s.stats.human import (
    POINTS,
    HumanOrder,
    SavedOverview,
    SavedScene,
    SceneTable,
    SubscoreWeights,
    blocks,
    policy_scores,
)

SURE = 1e9
"""So sharp a taste never errs."""


def scenes(prompts: int, seed: int) -> list[SavedScene]:
    """Seven scenes a prompt; one prompt in ten or so does not ask for a family, one scene in ten is capped."""
    random = np.random.default_rng(seed)
    made = []
    for _ in range(prompts):
        asked = [name for name in FAMILY_WEIGHTS if random.random() > 0.1] or list(FAMILY_WEIGHTS)
        for _ in range(POINTS):
            overview = SavedOverview(
                {name: round(float(random.random()), 2) for name in OVERVIEW_WEIGHTS},
                round(float(random.random()), 2),
                bool(random.random() < 0.1),
            )
            made.append(
                SavedScene(
                    {name: round(float(random.random()), 4) for name in asked},
                    overview,
                    {name: round(float(random.random()), 4) for name in PHYSICS_LEAF_WEIGHTS},
                )
            )
    return made


def planted_scores(table: SceneTable, taste: SubscoreWeights) -> Floats:
    """What each scene is worth to people of a taste, a row a prompt."""
    return np.asarray(policy_scores(table, taste.hundredths()[None])[0].reshape(-1, POINTS))


def rankings(worth: np.ndarray, seed: int, sharpness: float = SURE, clickers: Collection[int] = ()) -> list[HumanOrder]:
    """What annotators answer in the study's design: Plackett-Luce draws of the worths times the sharpness.

    Those of ``clickers`` answer by chance.
    """
    random = np.random.default_rng(seed)
    found = []
    for prompt, drawn in enumerate(blocks(len(worth), seed)):
        for block in drawn:
            shown = np.array(block.candidates)
            for annotator in block.annotators:
                taste = 0.0 if annotator in clickers else sharpness
                order = np.argsort(-(worth[prompt, shown] * taste + random.gumbel(size=len(shown))))
                found.append(HumanOrder(prompt, annotator, tuple(shown[order].tolist())))
    return found
