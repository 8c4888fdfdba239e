"""Whether two configurations differ: signs of whole clusters are flipped (paper, "Uncertainty", keeps clusters whole).

If the two were alike, a source's difference could as well have come out the other way round. So the mean difference is
compared with those under all ways of flipping the signs of sources: each of them where they are few, else draws.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from c4s.stats.bootstrap import DRAWS, SEED, Design, Floats

EXACT_CLUSTERS: Final = 20
"""Up to so many clusters all flips are looked at: 2^19 sums, a flip and its opposite being one."""
_ROUNDING: Final = 1e-9
"""Sums that differ by less, relative to the largest there can be, are equal."""
_AT_ONCE: Final = 4_000


@dataclass(frozen=True)
class SignFlip:
    """A two-sided test that a weighted sum of clusters' differences is 0."""

    p: float
    exact: bool
    """Whether every flip was looked at; else ``flips`` of them were drawn."""
    flips: int
    least: float
    """The smallest p that so many clusters and draws can give: above the wanted level, the test can find nothing."""


def cluster_sums(design: Design, differences: object, shares: object) -> Floats:
    """What each cluster adds to a weighted mean of differences.

    Args:
        differences: of each case, shape (cases,), finite.
        shares: weight of each case in the mean, shape (cases,); they sum to 1.

    Returns:
        Shape (clusters,): its sum is the mean.
    """
    sums = np.zeros(len(design.clusters))
    np.add.at(sums, design.cluster_of, np.asarray(differences, dtype=np.float64) * np.asarray(shares))
    return sums


def sign_flip(sums: object, draws: int = DRAWS, seed: int = SEED) -> SignFlip:
    """Share of the flips whose sum is as far from 0 as the observed one.

    Clusters that add nothing are left out: flipping them changes nothing. Drawn flips count the observed one beside
    them (the +1 rule), so p is never 0.

    Args:
        sums: what each cluster adds, shape (clusters,). ``ValueError`` where one is not finite.
        draws: how many flips are drawn where there are too many to look at each.
    """
    given = np.asarray(sums, dtype=np.float64)
    if given.ndim != 1 or not np.isfinite(given).all():
        raise ValueError("a finite number a cluster is expected")
    own = given[given != 0]
    if not len(own):
        return SignFlip(p=1.0, exact=True, flips=1, least=1.0)
    far = abs(own.sum()) - _ROUNDING * np.abs(own).sum()
    if len(own) <= EXACT_CLUSTERS:
        flipped = own[:1]
        for value in own[1:]:
            flipped = np.concatenate([flipped + value, flipped - value])
        count = len(flipped)
        return SignFlip(float((np.abs(flipped) >= far).sum() / count), exact=True, flips=2 * count, least=1 / count)
    random = np.random.default_rng(seed)
    found = 0
    for first in range(0, draws, _AT_ONCE):
        signs = random.integers(0, 2, (min(_AT_ONCE, draws - first), len(own))) * 2.0 - 1.0
        found += int((np.abs(signs @ own) >= far).sum())
    return SignFlip((1 + found) / (1 + draws), exact=False, flips=draws, least=1 / (1 + draws))
