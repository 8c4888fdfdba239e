"""What a mean is taken over: a setting, all repairs, or both tracks by the model score's weights, and tables by run."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from c4s.protocol.settings import SETTING_TITLES, SETTINGS, Setting
from c4s.stats.bootstrap import Floats, domain_means, weighted_means
from warehouse.analyses.cases import CONSTRUCTIONS, REPAIRS, CaseTable


@dataclass(frozen=True)
class ScoreMean:
    """A mean with fixed weights of settings; within a setting cases weigh alike."""

    title: str
    shares: Floats
    """Of each domain of the design; they sum to 1."""
    table: CaseTable

    @property
    def case_shares(self) -> Floats:
        """Weight of each case; they sum to 1."""
        domain_of = self.table.design.domain_of[self.table.design.cluster_of]
        return np.asarray((self.shares / self.table.design.sizes())[domain_of])

    @property
    def cases(self) -> int:
        """How many cases it is of."""
        return int(self.table.design.sizes()[self.shares > 0].sum())

    @property
    def sources(self) -> int:
        """How many source scenes they come from."""
        return int((self.shares[self.table.design.domain_of] > 0).sum())

    @property
    def domains(self) -> int:
        """How many settings it is of."""
        return int((self.shares > 0).sum())

    def means(self, counts: Floats, values: Floats) -> Floats:
        """Of each draw, shape (draws, columns); values are finite, shape (cases, columns)."""
        return weighted_means(self.table.design, counts, values, self.shares)

    def known_means(self, counts: Floats, values: Floats) -> Floats:
        """The same over those cases whose value is known (not NaN); NaN where a setting has none."""
        known = ~np.isnan(values)
        found = domain_means(self.table.design, counts, values, known)
        (own,) = np.nonzero(self.shares)
        return np.asarray(np.einsum("d,bdc->bc", self.shares[own], found[:, own]))

    def known_shares(self, values: Floats) -> Floats:
        """Weight of each case in the observed mean of known values, shape (cases,): 0 where unknown; sum 1 or 0."""
        known = ~np.isnan(values)
        domain_of = self.table.design.domain_of[self.table.design.cluster_of]
        sizes = np.bincount(domain_of[known], minlength=len(self.shares))
        with np.errstate(divide="ignore", invalid="ignore"):
            return np.where(known, (self.shares / sizes)[domain_of], 0.0)


def score_means(table: CaseTable) -> list[ScoreMean]:
    """Of each setting that has cases, of both repair settings by their cases, and of the model score."""
    sizes = {setting: table.settings.count(setting) for setting in SETTINGS if setting in table.settings}
    found = [_mean(SETTING_TITLES[setting], table, {setting: 1.0}) for setting in sizes]
    repairs, constructions = (
        {name: float(size) for name, size in sizes.items() if name in part} for part in (REPAIRS, CONSTRUCTIONS)
    )
    if len(repairs) > 1:
        found.append(_mean("Image to scene", table, repairs))
    if len(repairs) == len(REPAIRS) and constructions:
        halves = {name: size / sum(part.values()) for part in (repairs, constructions) for name, size in part.items()}
        found.append(_mean("Model score", table, halves))
    return found


def over_known(table: CaseTable, counts: Floats, values: Floats) -> Floats:
    """Means over those cases whose value is known (not NaN), of all settings, which keep their observed weights.

    Args:
        counts: how often each draw holds each source, shape (draws, sources).
        values: shape (cases, columns).

    Returns:
        Shape (draws, columns); NaN where nothing is known, or a draw holds nothing known of a setting that has some.
    """
    known = ~np.isnan(values)
    found = domain_means(table.design, counts, values, known)
    domain_of = table.design.domain_of[table.design.cluster_of]
    sizes = np.stack([known[domain_of == domain].sum(axis=0) for domain in range(len(table.design.domains))])
    with np.errstate(invalid="ignore"):
        shares = sizes / sizes.sum(axis=0)
    return np.asarray(np.where(sizes == 0, 0.0, shares * found).sum(axis=1) + 0 * shares.sum(axis=0))


def compared(table: CaseTable) -> list[int]:
    """Places of the ranked configurations; of all where fewer than two are ranked, as in a check of the evaluator."""
    ranked = [place for place, is_ranked in enumerate(table.ranked) if is_ranked]
    return ranked if len(ranked) > 1 else list(range(len(table.agents)))


def by_run(table: CaseTable, column: str) -> Floats:
    """A column of every run, shape (cases, configurations, repeats); NaN where it was not measured.

    Repeats are in rising order; a case with fewer of them has NaN.
    """
    rows = table.rows.assign(value=table.rows[column].astype(float))
    wide = rows.pivot_table(
        index="case_id", columns=["configuration", "repeat"], values="value", aggfunc="mean", dropna=False
    )
    repeats = sorted(set(table.rows["repeat"]))
    names = [(agent, repeat) for agent in table.agents for repeat in repeats]
    found = wide.reindex(index=table.cases, columns=names).to_numpy(dtype=np.float64)
    return found.reshape(len(table.cases), len(table.agents), len(repeats))


def _mean(title: str, table: CaseTable, weights: Mapping[Setting, float]) -> ScoreMean:
    known = {str(name): weight for name, weight in weights.items()}
    shares = np.array([known.get(str(name), 0.0) for name in table.design.domains])
    return ScoreMean(title, shares / shares.sum(), table)
