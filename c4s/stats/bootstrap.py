"""Intervals by resampling source clusters within domains (paper, "Trajectory coverage", lines 1984-1995).

Cases of one source scene stand or fall together, so sources are drawn, not cases: in each domain as many clusters as
there are, with replacement. A mean of a domain is a ratio, the sum over its drawn cases by their number, and domains
are joined with their observed weights, which no draw changes.
All is matrix products: draws x clusters times clusters x columns.
"""

from __future__ import annotations

from collections.abc import Hashable, Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]
DRAWS: Final = 10_000
SEED: Final = 23_917
"""The paper's seed of its trajectory comparisons."""
LEVEL: Final = 0.95
LEAST_CLUSTERS: Final = 9
"""Fewest clusters of a domain by which an interval is told. On simulated suites a percentile interval that says 95 %
holds the truth 78 % of the time with 4 clusters, 87 % with 8 and 9, 89 % with 10, 92 % with 20 (``python -m bench
coverage``). There is no sharp line: nine is what the paper's smallest domain has."""
MODEST_CLUSTERS: Final = 20
"""Below so many in a domain, an interval comes with the words that it is too narrow."""


@dataclass(frozen=True)
class Design:
    """Which cluster each case belongs to, and which domain each cluster."""

    clusters: tuple[Hashable, ...]
    """Names of the clusters, in rising order of their domains."""
    domains: tuple[Hashable, ...]
    """Names of the domains."""
    cluster_of: Integers
    """Cluster number of each case, shape (cases,)."""
    domain_of: Integers
    """Domain number of each cluster, shape (clusters,)."""

    @classmethod
    def of(cls, clusters: Sequence[Hashable], domains: Sequence[Hashable]) -> Design:
        """From a cluster and a domain a case. A cluster's name that is met in two domains is two clusters.

        ``ValueError`` where there is no case, or not as many of the one as of the other.
        """
        if len(clusters) != len(domains) or not clusters:
            raise ValueError("a cluster and a domain for each of at least one case are expected")
        named = sorted(dict.fromkeys(domains), key=str)
        places = {name: place for place, name in enumerate(named)}
        pairs = list(zip((places[domain] for domain in domains), clusters, strict=True))
        known = sorted(dict.fromkeys(pairs), key=lambda pair: (pair[0], str(pair[1])))
        numbers = {pair: number for number, pair in enumerate(known)}
        return cls(
            clusters=tuple(cluster for _, cluster in known),
            domains=tuple(named),
            cluster_of=np.array([numbers[pair] for pair in pairs], dtype=np.int64),
            domain_of=np.array([domain for domain, _ in known], dtype=np.int64),
        )

    def sizes(self) -> Integers:
        """Number of cases of each domain."""
        return np.bincount(self.domain_of[self.cluster_of], minlength=len(self.domains))

    def clusters_in(self) -> dict[Hashable, int]:
        """Number of clusters of each domain, by its name."""
        return dict(zip(self.domains, np.bincount(self.domain_of, minlength=len(self.domains)).tolist(), strict=True))

    def is_honest(self) -> bool:
        """Whether every domain has clusters enough for an interval (``LEAST_CLUSTERS``)."""
        return min(self.clusters_in().values()) >= LEAST_CLUSTERS

    def observed(self) -> Floats:
        """Each cluster once: the counts that give what was observed, shape (1, clusters)."""
        return np.ones((1, len(self.clusters)))

    def draw(self, draws: int = DRAWS, seed: int = SEED) -> Floats:
        """How often each draw holds each cluster, shape (draws, clusters).

        Domains are drawn in their order by one generator (PCG64), so the seed alone decides.
        """
        random = np.random.default_rng(seed)
        counts = np.zeros((draws, len(self.clusters)))
        for domain in range(len(self.domains)):
            (own,) = np.nonzero(self.domain_of == domain)
            drawn = random.integers(0, len(own), (draws, len(own)))
            rows = np.arange(draws)[:, None] * len(own)
            found = np.bincount((drawn + rows).ravel(), minlength=draws * len(own))
            counts[:, own] = found.reshape(draws, len(own))
        return counts


def domain_means(design: Design, counts: Floats, values: object, weights: object = None) -> Floats:
    """Means of each domain over the cases of each draw.

    Args:
        design: of the cases.
        counts: how often each draw holds each cluster, shape (draws, clusters).
        values: shape (cases,) or (cases, columns); where the weight is 0 they may be anything.
        weights: of each value, same shape; 1 without. With 0 and 1 the mean is one of a part of the cases: a rate.

    Returns:
        Shape (draws, domains, columns). NaN where a draw's weights in a domain sum to 0.
    """
    given = np.asarray(values, dtype=np.float64)
    table = given.reshape(len(given), -1)
    share = np.ones((len(table), 1)) if weights is None else np.asarray(weights, dtype=np.float64).reshape(table.shape)
    above, below = (_by_cluster(design, part) for part in (np.where(share == 0, 0.0, table) * share, share))
    means = np.empty((len(design.domains), len(counts), table.shape[1]))
    for domain in range(len(design.domains)):
        (own,) = np.nonzero(design.domain_of == domain)
        drawn = counts[:, own]
        np.matmul(drawn, above[own], out=means[domain])
        with np.errstate(invalid="ignore", divide="ignore"):
            means[domain] /= drawn @ below[own]
    return np.moveaxis(means, 0, 1)


def pooled(design: Design, means: Floats, domains: Sequence[Hashable] | None = None) -> Floats:
    """Means over some domains (all without) with their observed shares of cases as weights.

    Args:
        means: shape (draws, domains, columns).

    Returns:
        Shape (draws, columns).
    """
    sizes = design.sizes().astype(np.float64)
    if domains is not None:
        sizes *= [name in domains for name in design.domains]
    (own,) = np.nonzero(sizes)
    total = np.zeros((len(means), means.shape[2]))
    for domain in own:
        total += sizes[domain] / sizes[own].sum() * means[:, domain]
    return total


def weighted_means(design: Design, counts: Floats, values: object, shares: object) -> Floats:
    """Means over domains with fixed weights, in one product: ``domain_means`` joined, where every case counts.

    Args:
        counts: how often each draw holds each cluster, shape (draws, clusters).
        values: shape (cases,) or (cases, columns), finite.
        shares: weight of each domain, shape (domains,); a domain of weight 0 is left out.

    Returns:
        Shape (draws, columns). NaN where a draw holds nothing of a domain.
    """
    given = np.asarray(values, dtype=np.float64)
    sums = _by_cluster(design, given.reshape(len(given), -1))
    sizes = np.bincount(design.cluster_of, minlength=len(design.clusters))
    scaled = np.zeros(counts.shape)
    for domain, share in enumerate(np.asarray(shares, dtype=np.float64)):
        if share:
            (own,) = np.nonzero(design.domain_of == domain)
            with np.errstate(invalid="ignore", divide="ignore"):
                scaled[:, own] = counts[:, own] * (share / (counts[:, own] @ sizes[own]))[:, None]
    return np.asarray(scaled @ sums)


def pooled_rate(design: Design, counts: Floats, hits: object, of: object) -> Floats:
    """Rates over all domains: the pooled mean of ``hits`` by the pooled mean of ``of``, domains at observed shares.

    Args:
        hits: 0 and 1, shape (cases,) or (cases, columns).
        of: which of the cases count at all, same shape; a hit counts where it is 1.

    Returns:
        Shape (draws, columns); NaN where nothing counts.
    """
    base = np.asarray(of, dtype=np.float64)
    above = pooled(design, domain_means(design, counts, np.asarray(hits, dtype=np.float64) * base))
    below = pooled(design, domain_means(design, counts, base))
    with np.errstate(invalid="ignore", divide="ignore"):
        return np.asarray(above / below)


def percentile_interval(drawn: Floats, level: float = LEVEL) -> tuple[Floats, Floats]:
    """Ends of the percentile interval of each column; draws that have no value are left out, NaN where none has one.

    Args:
        drawn: shape (draws, ...).

    Returns:
        Low and high ends, each of the shape of one draw.
    """
    tails = [50 * (1 - level), 50 * (1 + level)]
    if not np.isnan(drawn).any():
        rows = np.ascontiguousarray(np.moveaxis(drawn, 0, -1))
        low, high = np.percentile(rows, tails, axis=-1, overwrite_input=True)
        return low, high
    flat = drawn.reshape(len(drawn), -1)
    ends = np.full((2, flat.shape[1]), np.nan)
    for column in range(flat.shape[1]):
        known = flat[~np.isnan(flat[:, column]), column]
        if len(known):
            ends[:, column] = np.percentile(known, tails)
    return ends[0].reshape(drawn.shape[1:]), ends[1].reshape(drawn.shape[1:])


def _by_cluster(design: Design, table: Floats) -> Floats:
    sums = np.zeros((len(design.clusters), table.shape[1]))
    np.add.at(sums, design.cluster_of, table)
    return sums
