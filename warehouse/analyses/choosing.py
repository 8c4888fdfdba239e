"""Choosing the cases of a public set by what agents scored on them (paper, app:public-private, "Selection"; CC38-CC44).

Within each setting, by scores alone: no label, pack or category is looked at. Each larger set holds the smaller ones.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from typing import Final

import numpy as np
import pandas as pd

from c4s.errors import BadInput, unknown
from c4s.protocol.settings import SETTINGS, Setting
from c4s.stats.bootstrap import Floats, Integers
from c4s.stats.selection import apportioned, greedy_order, left_out, normalised_error, replaced
from warehouse.analyses.cases import case_table
from warehouse.analyses.main_results import MAIN_RESULTS
from warehouse.analyses.panels import ranked_places
from warehouse.analyses.scope import StudyScope, WantedScope, choose
from warehouse.analyses.set_selection import (
    LEAST,
    METHODS,
    SHARES,
    Predicted,
    errors_of,
    method_named,
    strata_of,
    values_of,
)
from warehouse.analyses.study import BOTH_PANELS, StudyOptions
from warehouse.database import arrow

SIZES: Final = (61, 75, 95, 128)
"""Of the paper's candidate sets, for a suite that has as many."""
Counts = tuple[int, ...]
"""Cases of each setting, in the order of the settings."""


@dataclass(frozen=True)
class SettingPool:
    """What is chosen from: the cases of a setting and the configurations that have an outcome of each."""

    setting: Setting
    agents: list[str]
    cases: list[str]
    values: Floats
    """Shape (cases, configurations, columns); the first column is the total."""
    strata: list[str]

    @property
    def columns(self) -> Floats:
        """All scores of each case, shape (cases, columns)."""
        return self.values.reshape(len(self.cases), -1)


@dataclass(frozen=True)
class ChosenSet:
    """A set of one size."""

    counts: Counts
    cases: list[str]
    worst: float
    """The largest error of a column's mean, in standard deviations of means of random sets of the same size."""


@dataclass(frozen=True)
class MethodError:
    """How far off a method's sets are of configurations that they were chosen without."""

    method: str
    cases: int
    total_error: float
    part_error: float
    reversed_pairs: float


@dataclass(frozen=True)
class NestedSets:
    """Nested sets, the smallest first, and what they and their rivals err by."""

    suite: str
    suite_digest: str
    pools: list[SettingPool]
    sets: list[ChosenSet]
    errors: list[MethodError]
    withdrawn: dict[str, str | None]
    """Cases that were withdrawn, and what took their place in the set that was kept; None where nothing had to."""


def trials_of(warehouse: Path, wanted: WantedScope) -> tuple[StudyScope, pd.DataFrame]:
    """The scope that is wanted, and its trials, of public and private cases."""
    scope = choose(warehouse, wanted, BOTH_PANELS)
    (sql,) = MAIN_RESULTS.sources.values()
    return scope, arrow(warehouse, f"WITH chosen AS ({scope.sql()}) SELECT * FROM ({sql})", where="trials").to_pandas()


def pools_of(trials: pd.DataFrame, wanted: Sequence[str] = ()) -> list[SettingPool]:
    """A pool a setting; a configuration that is complete on one setting only counts there (CC41).

    Raises:
        BadInput: an unknown configuration is wanted, or a setting has too few.
    """
    known = sorted(set(trials["configuration"]))
    for name in wanted:
        if name not in known:
            raise unknown("configuration", name, known)
    stratum_of = strata_of(trials)
    pools = []
    for setting in SETTINGS:
        own = trials[trials["setting"] == setting]
        if not len(own):
            continue
        table = case_table(own, StudyOptions())
        places = [place for place in ranked_places(table) if not wanted or table.agents[place] in wanted]
        if len(places) < LEAST:
            raise BadInput(f"a selection needs {LEAST} complete configurations, there are {len(places)}", where=setting)
        pools.append(
            SettingPool(
                setting,
                [table.agents[place] for place in places],
                table.cases,
                values_of(table, setting, places),
                [stratum_of[case] for case in table.cases],
            )
        )
    return pools


def counts_of(sizes: Sequence[str], pools: Sequence[SettingPool]) -> list[Counts]:
    """Cases of each setting of each set, smallest first; the paper's sizes or shares without ``sizes``.

    Args:
        sizes: ``95`` (shared out by the numbers of cases) or ``20/25/50`` (of each setting).

    Raises:
        BadInput: a size is no number, larger than the suite, or leaves a setting out; or sets that are not nested.
    """
    most = [len(pool.cases) for pool in pools]
    if not sizes:
        paper = sum(most) > SIZES[-1]
        sizes = [str(size) for size in (SIZES if paper else [round(share * sum(most)) for share in SHARES])]
        sizes = [str(max(int(size), len(pools))) for size in sizes]
    found = sorted({_counts(size, most) for size in sizes}, key=lambda counts: (sum(counts), counts))
    for small, large in pairwise(found):
        if any(few > many for few, many in zip(small, large, strict=True)):
            raise BadInput(f"{_told(large)} does not hold {_told(small)}: sets are nested")
    return found


def _counts(size: str, most: Sequence[int]) -> Counts:
    parts = size.split("/")
    if not all(part.isdecimal() and part.isascii() and len(part) < 8 for part in parts):
        raise BadInput(f"{size!r} is no size", todo="95, or 20/25/50 for each setting")
    given = [int(part) for part in parts]
    if len(given) == 1 and len(most) > 1:
        if given[0] > sum(most):
            raise BadInput(f"a set of {given[0]} of {sum(most)} cases")
        given = apportioned(given[0], most)
    if len(given) != len(most):
        raise BadInput(f"{size!r} names {len(given)} settings, the suite has {len(most)}")
    for count, many in zip(given, most, strict=True):
        if not 1 <= count <= many:
            raise BadInput(f"{_told(given)}: a setting with {many} cases cannot give {count}")
    return tuple(given)


def _told(counts: Sequence[int]) -> str:
    return "/".join(map(str, counts))


def select(
    scope: StudyScope,
    pools: Sequence[SettingPool],
    sizes: Sequence[Counts],
    kept: Counts,
    *,
    withdrawn: Sequence[str] = (),
    seed: int,
) -> NestedSets:
    """Choose nested sets greedily and hold them against rivals, each configuration left out in turn.

    Args:
        scope: of the trials.
        pools: from ``pools_of``.
        sizes: from ``counts_of``.
        kept: the size of the set in which other cases take the place of withdrawn ones.
        withdrawn: cases that are in no set.
        seed: of the rivals that draw.

    Raises:
        BadInput: a withdrawn case is not there.
    """
    known = [case for pool in pools for case in pool.cases]
    for case in withdrawn:
        if case not in known:
            raise unknown("case", case, known)
    orders = [greedy_order(pool.columns) for pool in pools]
    taken: dict[str, str | None] = {}
    for case in dict.fromkeys(withdrawn):
        place = next(place for place, pool in enumerate(pools) if case in pool.cases)
        orders[place], taken[case] = _replaced(pools[place], orders[place], case, kept[place], taken)
    sets = [_chosen(pools, orders, counts) for counts in sizes]
    left = [_without(pool, taken) for pool in pools]
    errors = [_error(left, counts, method, seed) for counts in sizes for method in METHODS]
    return NestedSets(scope.suite, scope.suite_digest, list(pools), sets, errors, taken)


def _replaced(
    pool: SettingPool, order: Integers, case: str, size: int, gone: dict[str, str | None]
) -> tuple[Integers, str | None]:
    """The order without a case, and what took its place among the first ``size``."""
    left = np.array([place for place, name in enumerate(pool.cases) if name not in gone], dtype=np.int64)
    own = np.searchsorted(left, order)
    found = left[replaced(pool.columns[left], own, int(np.searchsorted(left, pool.cases.index(case))), size)]
    new = set(found[:size].tolist()) - set(order[:size].tolist())
    return found, next((pool.cases[place] for place in new), None)


def _chosen(pools: Sequence[SettingPool], orders: Sequence[Integers], counts: Counts) -> ChosenSet:
    cases: list[str] = []
    worst = 0.0
    for pool, order, count in zip(pools, orders, counts, strict=True):
        left = np.sort(order)
        cases += sorted(pool.cases[place] for place in order[:count])
        worst = max(worst, normalised_error(pool.columns[left], np.searchsorted(left, order[:count])))
    return ChosenSet(counts, cases, worst)


def _without(pool: SettingPool, gone: Collection[str]) -> SettingPool:
    left = [place for place, case in enumerate(pool.cases) if case not in gone]
    cases, strata = [pool.cases[place] for place in left], [pool.strata[place] for place in left]
    return SettingPool(pool.setting, pool.agents, cases, pool.values[left], strata)


def _error(pools: Sequence[SettingPool], counts: Counts, method: str, seed: int) -> MethodError:
    made: dict[str, Predicted | None] = {
        pool.setting: (
            min(count, len(pool.cases)),
            left_out(pool.values, method_named(method, min(count, len(pool.cases)), pool.strata, seed)),
            pool.values.mean(axis=0),
        )
        for pool, count in zip(pools, counts, strict=True)
    }
    row = errors_of(made)
    numbers = [float(row[name] or 0) for name in ("total_error", "part_error", "reversed")]
    return MethodError(method, int(row["cases"] or 0), *numbers)
