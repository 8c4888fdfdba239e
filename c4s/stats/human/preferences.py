"""Rankings of triplets as pairwise preferences (paper, ``sec:human-alignment``), and who won by each of them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from c4s.stats.bootstrap import Floats, Integers


@dataclass(frozen=True)
class HumanOrder:
    """One annotator's strict ranking of some candidates of one prompt."""

    prompt: int
    annotator: int
    order: tuple[int, ...]
    """Numbers of candidates, the best first."""


@dataclass(frozen=True)
class Preferences:
    """Pairwise preferences: a row one, all arrays of shape (preferences,)."""

    prompt: Integers
    annotator: Integers
    first: Integers
    """The candidate of the lower number."""
    second: Integers
    sign: Integers
    """1 where the first is preferred, -1 where the second is."""
    prompts: int
    candidates: int
    """Of each prompt."""

    @classmethod
    def of(cls, rankings: Sequence[HumanOrder], prompts: int, candidates: int) -> Preferences:
        """Each ranking of k candidates as k (k - 1) / 2 preferences.

        ``ValueError`` where a number is out of range, or a candidate stands twice in a ranking.
        """
        rows = []
        for one in rankings:
            if len(set(one.order)) != len(one.order):
                raise ValueError("a ranking holds a candidate twice")
            for better, worse in combinations(one.order, 2):
                rows.append(
                    (one.prompt, one.annotator, min(better, worse), max(better, worse), 1 if better < worse else -1)
                )
        table = np.array(rows, dtype=np.int64).reshape(-1, 5)
        inside = (table[:, 0] < prompts) & (table[:, 3] < candidates) & (table[:, :4] >= 0).all(axis=1)
        if not inside.all():
            raise ValueError("a ranking names a prompt or a candidate that is not there")
        return cls(table[:, 0], table[:, 1], table[:, 2], table[:, 3], table[:, 4], prompts, candidates)

    def __len__(self) -> int:
        return len(self.sign)

    def only(self, mask: NDArray[np.bool_]) -> Preferences:
        """Some of them, of as many prompts and candidates as before."""
        prompt, annotator = self.prompt[mask], self.annotator[mask]
        first, second, sign = self.first[mask], self.second[mask], self.sign[mask]
        return Preferences(prompt, annotator, first, second, sign, self.prompts, self.candidates)

    def pair(self) -> Integers:
        """A number for each pair of candidates of each prompt, rising with both."""
        return (self.prompt * self.candidates + self.first) * self.candidates + self.second

    def units(self) -> PairVotes:
        """Votes by pair: the pairs that anybody ranked, in rising order."""
        pairs, where = np.unique(self.pair(), return_inverse=True)
        won = np.bincount(where, weights=(self.sign > 0).astype(np.float64), minlength=len(pairs))
        lost = np.bincount(where, weights=(self.sign < 0).astype(np.float64), minlength=len(pairs))
        ends, prompt = pairs % self.candidates**2, pairs // self.candidates**2
        first, second = ends // self.candidates, ends % self.candidates
        return PairVotes(prompt, first, second, won.astype(np.float64), lost.astype(np.float64), self.prompts)


@dataclass(frozen=True)
class PairVotes:
    """How many preferred either candidate of a pair; arrays of shape (pairs,)."""

    prompt: Integers
    first: Integers
    second: Integers
    won: Floats
    """By the first."""
    lost: Floats
    prompts: int

    def weights(self) -> tuple[Floats, Floats]:
        """What a vote for the first and for the second counts in the mean over prompts, pairs and reviewers.

        They sum to 1: prompts that anybody ranked count the same, so do the pairs of a prompt and the reviewers of a
        pair (paper, ``eq:human-weight-objective``).
        """
        pairs = np.bincount(self.prompt, minlength=self.prompts)
        share = 1.0 / (np.count_nonzero(pairs) * pairs[self.prompt] * (self.won + self.lost))
        return self.won * share, self.lost * share
