"""Scores of saved components under many weights (paper, ``sec:human-weight-fitting``).

Nothing is judged or measured again: family scores, dimensions, the structural modifier, the cap and the safety of the
two leaves are as they were saved. The protocol's own functions make the score (``score_under``). A search asks for
millions of scores, so ``policy_scores`` does the protocol's additions and products for all at once, in the protocol's
order; the one that it cannot do so, the exact sum of the four dimensions, is left to the protocol where it decides a
digit. What it returns is what ``score_under`` returns.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from c4s.protocol.case import t2s_case
from c4s.protocol.detailed import detailed_score
from c4s.protocol.overview import overview_score
from c4s.protocol.physics import physics_from_report
from c4s.protocol.rules import (
    DETAILED_DIGITS,
    FAMILY_WEIGHTS,
    OVERVIEW_WEIGHTS,
    PHYSICS_LEAF_WEIGHTS,
    SEVERE_CAP,
    STRUCTURE_FLOOR,
    STRUCTURE_SHARE,
    Family,
)
from c4s.stats.bootstrap import Floats, Integers
from c4s.stats.human.weights import ALPHA_AT, BETA_AT, GAMMA_AT, SPANS, SubscoreWeights, as_shares

_SCALE: Final = 10**DETAILED_DIGITS
"""All three components and the case score keep four decimals."""
_EDGE: Final = 1e-5
"""So near to the middle between two last digits, in units of the last digit, Python rounds by the exact value."""
_ROWS: Final = 4096
"""Policies whose scores are made at once, so that memory stays small."""


@dataclass(frozen=True)
class SavedOverview:
    """What a judge said of the overview of a scene."""

    dimensions: Mapping[str, float]
    structure: float
    capped: bool
    """Whether a severe defect caps the score."""


@dataclass(frozen=True)
class SavedScene:
    """The saved components of one valid scene. What could not be evaluated is worth 0 at its full weight."""

    families: Mapping[Family, float]
    """Scores of the families that the prompt asks for, four decimals; none where they were not evaluated."""
    overview: SavedOverview | None
    leaves: Mapping[str, float]
    """Safety of the leaves that were measured."""


def score_under(scene: SavedScene, weights: SubscoreWeights) -> float:
    """The case score of a scene, by the protocol's functions."""
    made = t2s_case(
        valid=True,
        detailed=_detailed(scene, weights.families),
        overview=_overview(scene, weights.dimensions),
        physics=_physics(scene, weights.leaves),
        weights=weights.final,
    )
    return float(made["score"])


def _detailed(scene: SavedScene, weights: Mapping[str, float]) -> float:
    rows = [
        {"semantic_family": family, "clause_index": 0, "effective_score": score}
        for family, score in scene.families.items()
    ]
    return float(detailed_score(rows, {family: weights[family] for family in FAMILY_WEIGHTS})["score"] or 0.0)


def _overview(scene: SavedScene, weights: Mapping[str, float]) -> float:
    said = scene.overview
    if said is None:
        return 0.0
    return float(overview_score(said.dimensions, said.structure, said.capped, weights)["score"])


def _physics(scene: SavedScene, weights: Mapping[str, float]) -> float:
    leaves = [
        {"leaf_id": name, "status": "measured", "score": safety, "metadata": {"score_direction": "higher_is_better"}}
        for name, safety in scene.leaves.items()
    ]
    report = {"status": "measured", "metrics": {"leaf_results": leaves}}
    return float(physics_from_report(report, weights=weights, whole_scene=True)["score"])


@dataclass(frozen=True)
class SceneTable:
    """Saved components of scenes as arrays, a row a scene."""

    scenes: tuple[SavedScene, ...]
    families: Floats
    """Shape (scenes, 4); 0 where a prompt does not ask for one."""
    asked: Floats
    """Shape (scenes, 4), 1 or 0."""
    dimensions: Floats
    """Shape (scenes, 4), times the structural modifier."""
    ceiling: Floats
    """Shape (scenes,): the cap, or 1."""
    leaves: Floats
    """Shape (scenes, 2)."""

    @classmethod
    def of(cls, scenes: Sequence[SavedScene]) -> SceneTable:
        """Of some scenes."""
        said = [scene.overview for scene in scenes]
        modifier = [0.0 if one is None else STRUCTURE_FLOOR + STRUCTURE_SHARE * one.structure for one in said]
        dimensions = [[0.0 if one is None else one.dimensions[name] for name in OVERVIEW_WEIGHTS] for one in said]
        return cls(
            scenes=tuple(scenes),
            families=np.array([[scene.families.get(name, 0.0) for name in FAMILY_WEIGHTS] for scene in scenes]),
            asked=np.array([[float(name in scene.families) for name in FAMILY_WEIGHTS] for scene in scenes]),
            dimensions=np.array(dimensions) * np.array(modifier)[:, None],
            ceiling=np.array([SEVERE_CAP if one is not None and one.capped else 1.0 for one in said]),
            leaves=np.array([[scene.leaves.get(name, 0.0) for name in PHYSICS_LEAF_WEIGHTS] for scene in scenes]),
        )

    def applicable(self) -> np.ndarray:
        """The sets of families that scenes are asked for, shape (sets, 4)."""
        sets = np.unique(self.asked > 0, axis=0)
        return np.asarray(sets[sets.any(axis=1)])


def policy_scores(table: SceneTable, policies: Integers) -> Floats:
    """Case scores under each policy, equal to ``score_under`` to the last bit.

    Args:
        policies: hundredths, shape (policies, 13); each set of families that is asked for has some weight.

    Returns:
        Shape (policies, scenes).
    """
    return np.concatenate([_some(table, policies[at : at + _ROWS]) for at in range(0, len(policies), _ROWS)])


def _some(table: SceneTable, policies: Integers) -> Floats:
    shares = as_shares(policies)
    detailed = _each(shares[:, SPANS["families"]], lambda weights: _detailed_scores(table, weights))
    overview = _each(shares[:, SPANS["dimensions"]], lambda weights: _overview_scores(table, weights))
    physics = _each(shares[:, SPANS["leaves"]], lambda weights: _physics_scores(table, weights))
    alpha, beta, gamma = (shares[:, [at]] for at in (ALPHA_AT, BETA_AT, GAMMA_AT))
    return _rounded(alpha * detailed + gamma * physics + beta * overview)


def _each(weights: Floats, scores: Callable[[Floats], Floats]) -> Floats:
    """Scores under the weights of each policy, made once for equal ones."""
    distinct, row = np.unique(weights, axis=0, return_inverse=True)
    return np.asarray(scores(distinct)[row.ravel()])


def _detailed_scores(table: SceneTable, weights: Floats) -> Floats:
    """As ``detailed_score`` adds: in the order of the families, each with its share of what is asked."""
    total, score = np.zeros((2, len(weights), len(table.scenes)))
    columns = range(weights.shape[1])
    for family in columns:
        total += weights[:, [family]] * table.asked[:, family]
    total[total == 0] = 1.0
    for family in columns:
        score += (weights[:, [family]] / total) * table.families[:, family]
    return _rounded(score)


def _overview_scores(table: SceneTable, weights: Floats) -> Floats:
    named = [dict(zip(OVERVIEW_WEIGHTS, row, strict=True)) for row in weights.tolist()]
    rough = np.minimum(weights @ table.dimensions.T, table.ceiling)
    return _rounded(rough, lambda policy, scene: _overview(table.scenes[scene], named[policy]))


def _physics_scores(table: SceneTable, weights: Floats) -> Floats:
    first, second = table.leaves.T
    return _rounded(weights[:, [0]] * first + weights[:, [1]] * second)


def _rounded(values: Floats, exact: Callable[[int, int], float] | None = None) -> Floats:
    """Four decimals of each number, as Python rounds it; near an edge what ``exact`` says of its row and column."""
    scaled = values * _SCALE
    found = np.rint(scaled) / _SCALE
    for row, column in np.argwhere(np.abs(scaled - np.floor(scaled) - 0.5) < _EDGE).tolist():
        value = round(float(values[row, column]), DETAILED_DIGITS) if exact is None else exact(row, column)
        found[row, column] = value
    return np.asarray(found)
