"""How often a 95 % interval by source clusters holds the truth: simulated scores of a known mean, many times over.

Scores are like a suite's: in [0, 1], many of them low, cases of one source alike (intraclass correlation 0.5). Sources
have as many cases as rooms of a repair suite have, 1 to 5. The interval is the one that studies give, all of it.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np
from scipy.stats import t as student

from bench.row import Row
from c4s.stats.bootstrap import DRAWS, LEAST_CLUSTERS, LEVEL, Design, Floats, domain_means, percentile_interval
from c4s.stats.power import clustered_variances

SIMULATED: Final = 8_000
"""Suites a row: a coverage is known to 0.4 points (standard error)."""
AT_ONCE: Final = 500
MOST_CASES: Final = 5
ALIKE: Final = 0.5
"""Intraclass correlation of the cases of a source."""
MEAN: Final = 0.3
"""Of all scores; their spread is that of a Beta(0.6, 1.4)."""
_WEIGHT: Final = 2.0
GOAL: Final = 0.85
"""An interval that is told misses the truth at most three times as often as it says."""
COUNTS: Final = (4, 6, 8, 9, 10, 20, 40)


@dataclass(frozen=True)
class Coverage:
    """Shares of simulated suites whose interval holds the truth."""

    percentile: float
    student: float
    """Of the mean with its clustered standard error, by Student's t with one degree of freedom a cluster less one a
    domain."""


def coverage(
    clusters: tuple[int, ...], weights: tuple[float, ...], simulated: int = SIMULATED, seed: int = 1
) -> Coverage:
    """Of a weighted mean over domains with so many clusters each."""
    random = np.random.default_rng(seed)
    design = _design(clusters)
    shares = np.array(weights) / sum(weights)
    quantile = float(student.ppf((1 + LEVEL) / 2, sum(clusters) - len(clusters)))
    held, held_by_student = 0, 0
    for first in range(0, simulated, AT_ONCE):
        counts = design.draw(DRAWS, seed + first)
        values = _scores(design, min(AT_ONCE, simulated - first), random)
        low, high = percentile_interval(np.einsum("d,bdc->bc", shares, domain_means(design, counts, values)))
        held += int(((low <= MEAN) & (high >= MEAN)).sum())
        means = shares @ domain_means(design, design.observed(), values)[0]
        errors = np.sqrt(shares**2 @ clustered_variances(design, values))
        held_by_student += int((np.abs(means - MEAN) <= quantile * errors).sum())
    return Coverage(held / simulated, held_by_student / simulated)


def _design(clusters: tuple[int, ...]) -> Design:
    """Sources of 1 to ``MOST_CASES`` cases in turn."""
    pairs = [
        (f"{domain}-{cluster}", domain)
        for domain, count in enumerate(clusters)
        for cluster in range(count)
        for _ in range(1 + cluster % MOST_CASES)
    ]
    return Design.of([cluster for cluster, _ in pairs], [domain for _, domain in pairs])


def _scores(design: Design, columns: int, random: np.random.Generator) -> Floats:
    """Beta scores with the wanted mean: the part of a source's cases that equal its own score makes them alike."""
    shape = (_WEIGHT * MEAN, _WEIGHT * (1 - MEAN))
    own = random.beta(*shape, size=(len(design.clusters), columns))[design.cluster_of]
    other = random.beta(*shape, size=own.shape)
    return np.where(random.random(own.shape) < ALIKE**0.5, own, other)


def rows() -> list[Row]:
    """Coverage by number of clusters, then of the paper's design; Student's interval beside it."""
    designs: list[tuple[str, tuple[int, ...], tuple[float, ...]]] = [
        *((f"{count} sources", (count,), (1.0,)) for count in COUNTS),
        ("model score of 20 + 9 + 10 sources", (20, 9, 10), (2.0, 1.0, 1.0)),
    ]
    made = []
    for name, clusters, weights in designs:
        found = coverage(clusters, weights)
        told = min(clusters) >= LEAST_CLUSTERS
        made.append(
            Row(
                f"coverage of 95 %, {name}",
                100 * found.percentile,
                f"{100 * GOAL:g} %" if told else "none is told",
                not told or found.percentile >= GOAL,
                "%",
                "clustered error, Student's t",
                100 * found.student,
            )
        )
    return made
