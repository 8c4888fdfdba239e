"""Weights that agree best with preferences: a bounded search (paper, ``sec:human-weight-fitting``).

What the paper leaves open is read so: proposals are drawn evenly over all blocks at once and rounded to hundredths; the
0.05 grid is walked block by block, the others at their best so far, until no block gains (the grid of all blocks
together has some 10^9 points), from the comparison policy and from the best proposals; each end of a walk is refined,
and the best of all is the fit.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from itertools import permutations
from typing import Final

import numpy as np
from numpy.typing import NDArray

from c4s.protocol.criteria import SPLIT_SEED
from c4s.stats.bootstrap import Floats, Integers
from c4s.stats.human.consensus import TIE
from c4s.stats.human.preferences import PairVotes
from c4s.stats.human.scoring import SceneTable, policy_scores
from c4s.stats.human.weights import (
    ALPHA_AT,
    BETA_AT,
    BLOCKS,
    GAMMA,
    LEAST_ALPHA,
    SPANS,
    WHOLE,
    as_shares,
    feasible,
    final_shares,
    simplex,
)

SEED: Final = SPLIT_SEED
"""Of the proposals."""
GRID_STEP: Final = 5
PROPOSALS: Final = 8_192
PASSES: Final = 5
"""Most refinement passes."""
TRANSFER: Final = 1
"""Hundredths that a refinement moves from one part of a block to another."""
LOSS_SCALE: Final = 10.0
"""Factor of the score difference in the logistic loss."""
STARTS: Final = 3
"""Proposals from which the grid is walked too."""
_ROUNDS: Final = 5
"""Most walks over the grids of all blocks."""
_DIGITS: Final = 12
"""Numbers that are equal so far are equal: sums of equal shares in another order."""
Told = Callable[[str, int, int], None]


@dataclass(frozen=True)
class PolicyStanding:
    """How good a policy is: what is compared, the first first."""

    agreement: float
    """Share of preferences that it agrees with: mean over prompts, pairs and reviewers."""
    loss: float
    """Mean of log(1 + exp(-10 y delta)), with the same shares."""
    distance: float
    """Squared distance of its weights to those of the comparison policy."""

    def key(self) -> tuple[float, float, float]:
        """Lower is to be preferred."""
        return -self.agreement, self.loss, self.distance


Found = tuple[Integers, PolicyStanding]
"""A policy in hundredths and how good it is."""


@dataclass(frozen=True)
class WeightFit:
    """The best policy that a search found."""

    hundredths: Integers
    """Shape (13,)."""
    standing: PolicyStanding
    comparison: PolicyStanding
    """Of the comparison policy on the same preferences."""
    looked_at: dict[str, int]
    """How many policies each stage looked at."""
    passes: int
    """Refinement passes that were made; the last one gained nothing, or was the last that is allowed."""


class Objective:
    """Scores policies on some preferences.

    Args:
        scenes: a row a candidate: candidate c of prompt p is row ``p * candidates + c``.
        votes: on pairs of these candidates.
        comparison: hundredths of the comparison policy, shape (13,).
    """

    def __init__(self, scenes: SceneTable, votes: PairVotes, candidates: int, comparison: Integers) -> None:
        self.scenes, self.comparison = scenes, comparison
        self.applicable: NDArray[np.bool_] = scenes.applicable()
        self._won, self._lost = votes.weights()
        self._first = votes.prompt * candidates + votes.first
        self._second = votes.prompt * candidates + votes.second

    def standings(self, policies: Integers) -> Floats:
        """Agreement, loss and distance of each policy, shape (policies, 3)."""
        scores = policy_scores(self.scenes, policies)
        gap = scores[:, self._first] - scores[:, self._second]
        agreement = (gap > TIE) @ self._won + (gap < -TIE) @ self._lost
        from scipy.special import log1p

        loss = log1p(np.exp(-LOSS_SCALE * gap)) @ self._won + log1p(np.exp(LOSS_SCALE * gap)) @ self._lost
        apart = as_shares(policies) - as_shares(self.comparison)
        return np.round(np.column_stack([agreement, loss, (apart**2).sum(axis=1)]), _DIGITS)

    def ranked(self, policies: Integers, most: int) -> list[Found]:
        """The best feasible policies, the best first; of equal ones the lower weights in the order of the columns."""
        allowed = policies[feasible(policies, self.applicable)]
        if not len(allowed):
            return []
        found = self.standings(allowed)
        keys = [*allowed.T[::-1], found[:, 2], found[:, 1], -found[:, 0]]
        return [(allowed[at], PolicyStanding(*found[at].tolist())) for at in np.lexsort(keys)[:most].tolist()]


def fit(objective: Objective, seed: int = SEED, told: Told | None = None) -> WeightFit:
    """Search the feasible policies; the seed decides the proposals, all else is fixed.

    ``ValueError`` where the comparison policy is not feasible: the search starts there.
    """
    comparison = objective.ranked(objective.comparison[None], 1)
    if not comparison:
        raise ValueError("a comparison policy that a fit may choose is expected")
    search = _Search(objective)
    drawn = proposals(seed)
    starts = [*comparison, *search.look("proposals", drawn, STARTS)]
    refined: list[tuple[Found, int]] = []
    for number, start in enumerate(starts):
        refined.append(search.refined(search.walked(start)))
        if told is not None:
            told("searching weights", number + 1, len(starts))
    (weights, standing), passes = min(refined, key=lambda row: row[0][1].key())
    return WeightFit(weights, standing, comparison[0][1], search.looked_at, passes)


class _Search:
    """What is looked at, stage by stage."""

    def __init__(self, objective: Objective) -> None:
        self._objective = objective
        self.looked_at = dict.fromkeys(("proposals", "grid", "refinement"), 0)

    def look(self, stage: str, policies: Integers, most: int = 1) -> list[Found]:
        """The best of some policies."""
        self.looked_at[stage] += len(policies)
        return self._objective.ranked(policies, most)

    def walked(self, best: Found) -> Found:
        """From a policy over the grid, block by block, until no block gains."""
        for _ in range(_ROUNDS):
            before = best
            for block in BLOCKS:
                best = self._better(best, "grid", _grid(best[0], block))
            if best is before:
                break
        return best

    def refined(self, best: Found) -> tuple[Found, int]:
        """From a policy by small transfers, and how many passes it took."""
        gained, passes = True, 0
        while gained and passes < PASSES:
            passes, before = passes + 1, best
            for move in _moves():
                if (moved := _moved(best[0], *move)) is not None:
                    best = self._better(best, "refinement", moved)
            gained = best is not before
        return best, passes

    def _better(self, best: Found, stage: str, policies: Integers) -> Found:
        for found in self.look(stage, policies):
            if found[1].key() < best[1].key():
                return found
        return best


def proposals(seed: int, count: int = PROPOSALS) -> Integers:
    """Policies drawn evenly over the feasible set, rounded to hundredths, shape (count, 13)."""
    random = np.random.default_rng(seed)
    parts = [
        _rounded_shares(random.dirichlet(np.ones(len(names)), count))
        for block, names in BLOCKS.items()
        if block != "final"
    ]
    alphas = random.integers(LEAST_ALPHA, WHOLE - GAMMA + 1, count)
    return np.column_stack([*parts, final_shares(alphas.tolist())])


def _rounded_shares(shares: Floats) -> Integers:
    """Shares as hundredths that sum to a whole: what is left goes to the largest remainders."""
    exact = shares * WHOLE
    rows = np.floor(exact).astype(np.int64)
    order = np.argsort(rows - exact, axis=1, kind="stable")
    left = WHOLE - rows.sum(axis=1)
    extra = np.arange(shares.shape[1]) < left[:, None]
    np.put_along_axis(rows, order, np.take_along_axis(rows, order, axis=1) + extra, axis=1)
    return rows


def _grid(policy: Integers, block: str) -> Integers:
    """A policy with a block at each point of its grid."""
    if block == "final":
        points = final_shares(range(LEAST_ALPHA, WHOLE - GAMMA + 1, GRID_STEP))
    else:
        points = simplex(len(BLOCKS[block]), GRID_STEP)
    table = np.repeat(policy[None], len(points), axis=0)
    table[:, SPANS[block]] = points
    return table


def _moves() -> list[tuple[int, int]]:
    """Columns between which a refinement moves weight: within a block, the physical safety share excepted."""
    moves = [
        (giver, taker)
        for block, span in SPANS.items()
        if block != "final"
        for giver, taker in permutations(range(span.start, span.stop), 2)
    ]
    return [*moves, (ALPHA_AT, BETA_AT), (BETA_AT, ALPHA_AT)]


def _moved(policy: Integers, giver: int, taker: int) -> Integers | None:
    """A policy with some weight moved; None where the giver has none left."""
    if policy[giver] < TRANSFER:
        return None
    moved = policy.copy()
    moved[giver] -= TRANSFER
    moved[taker] += TRANSFER
    return moved[None]
