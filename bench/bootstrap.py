"""Intervals of 98 columns (14 configurations, 7 scores each) on 95 cases by 10,000 draws of 39 sources in three
domains, against ``scipy.stats.bootstrap`` on the same statistic with the same generator: it draws the same sources, so
the intervals are the same but for rounding.

scipy is asked in three ways: with a plain function of the drawn sources' cases, which is the statistic as it is told;
with a vectorised one over sums that were made before, a call a column; and with all columns in one call of it. The last
two leave scipy only what ours has to do as well, gathering where ours multiplies.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import Any, Final

import numpy as np
from scipy.stats import bootstrap

from bench.made_warehouse import PUBLIC_SET
from bench.row import Row
from c4s.stats.bootstrap import DRAWS, SEED, Design, Floats, percentile_interval, weighted_means

COLUMNS: Final = 14 * 7
PLAIN: Final = 4
"""Columns that the plain function is timed on; its time is scaled to all."""
GOAL: Final = 100.0
ROUNDING: Final = 1e-12


def _cases() -> tuple[Design, Floats]:
    names = [(f"{setting} {case % scenes}", setting) for setting, count, scenes in PUBLIC_SET for case in range(count)]
    design = Design.of([scene for scene, _ in names], [setting for _, setting in names])
    return design, np.random.default_rng(1).random((len(names), COLUMNS))


def _ours(design: Design, values: Floats) -> Floats:
    """Interval ends, shape (2, columns)."""
    shares = design.sizes() / design.sizes().sum()
    return np.stack(percentile_interval(weighted_means(design, design.draw(), values, shares)))


class _Scipy:
    """The same statistic for scipy: its samples are the numbers of each domain's sources."""

    def __init__(self, design: Design, values: Floats) -> None:
        self.values = values
        self.samples = [np.nonzero(design.domain_of == place)[0] for place in range(len(design.domains))]
        self.shares = design.sizes() / design.sizes().sum()
        self.cases = [np.nonzero(design.cluster_of == place)[0] for place in range(len(design.clusters))]
        self.sums = np.array([values[own].sum(axis=0) for own in self.cases]).T
        self.counts = np.array([len(own) for own in self.cases], dtype=np.float64)

    def column(self, place: int) -> Floats:
        return self._ends(lambda *drawn, axis: self._mean(self.sums[place], drawn, axis), self.samples)

    def all_columns(self) -> Floats:
        samples = [sample[None] for sample in self.samples]
        return self._ends(
            lambda *drawn, axis: self._mean(self.sums, [part[0] for part in drawn], axis), samples, vectorized=True
        )

    def plain(self, place: int) -> Floats:
        column = self.values[:, place]

        def mean(*drawn: Any) -> float:
            means = [column[np.concatenate([self.cases[source] for source in part])].mean() for part in drawn]
            return float(self.shares @ means)

        return self._ends(mean, self.samples, vectorized=False)

    def _mean(self, sums: Floats, drawn: Any, axis: int) -> Any:
        return sum(
            share * sums[..., part].sum(axis=axis) / self.counts[part].sum(axis=axis)
            for share, part in zip(self.shares, drawn, strict=True)
        )

    def _ends(self, statistic: Callable[..., Any], samples: Any, vectorized: bool = True) -> Floats:
        found = bootstrap(
            samples,
            statistic,
            n_resamples=DRAWS,
            method="percentile",
            vectorized=vectorized,
            axis=-1,
            rng=np.random.default_rng(SEED),
        )
        return np.array([found.confidence_interval.low, found.confidence_interval.high])


def _timed(work: Callable[[], Floats], times: int = 1) -> tuple[float, Floats]:
    """The best wall-clock time of some, and what was made."""
    best, made = float("inf"), np.empty(0)
    for _ in range(times):
        before = time.perf_counter()
        made = work()
        best = min(best, time.perf_counter() - before)
    return best, made


def rows() -> list[Row]:
    """Our time for all columns against three ways to ask scipy, with the largest difference of an interval's end."""
    design, values = _cases()
    rival = _Scipy(design, values)
    ours, ends = _timed(lambda: _ours(design, values), times=7)
    plain, of_plain = _timed(lambda: np.stack([rival.plain(place) for place in range(PLAIN)], axis=1))
    each, of_each = _timed(lambda: np.stack([rival.column(place) for place in range(COLUMNS)], axis=1))
    once, of_once = _timed(rival.all_columns, times=3)
    plain *= COLUMNS / PLAIN
    made = []
    for told, theirs, found, goal in (
        (f"a plain function ({PLAIN} columns, scaled)", plain, of_plain, GOAL),
        ("sums made before, a call a column", each, of_each, 1.0),
        ("sums made before, one call", once, of_once, 1.0),
    ):
        off = float(np.abs(ends[:, : found.shape[1]] - found).max())
        made.append(
            Row(
                f"intervals of {COLUMNS} columns; off by at most {off:.0e}",
                ours,
                f"{goal:g}x, the same to {ROUNDING:g}",
                theirs / ours >= goal and off <= ROUNDING,
                "s",
                f"scipy.stats.bootstrap, {told}",
                theirs,
                theirs / ours,
            )
        )
    return made
