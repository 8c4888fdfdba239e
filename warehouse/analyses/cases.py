"""Scores of a scope as arrays: a row a case, a column a configuration, repeats averaged, the incomplete set apart."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import get_args

import numpy as np
import pandas as pd

from c4s.errors import BadInput, unknown
from c4s.protocol.settings import SETTINGS, is_construction
from c4s.records.analysis import Column, Intervals, Table, Value
from c4s.records.suite import Visibility
from c4s.stats.bootstrap import MODEST_CLUSTERS, Design, Floats, pooled
from warehouse.analyses.study import StudyOptions

CONSTRUCTIONS = tuple(setting for setting in SETTINGS if is_construction(setting))
VISIBILITIES = get_args(Visibility)
REPAIRS = tuple(setting for setting in SETTINGS if not is_construction(setting))


class NoneComplete(BadInput):
    """No configuration has an outcome of every planned case."""


@dataclass(frozen=True)
class CaseTable:
    """Configurations that are complete, on the same cases."""

    agents: list[str]
    ranked: list[bool]
    """Of each configuration; the others only validate the evaluator."""
    cases: list[str]
    settings: list[str]
    """Of each case."""
    design: Design
    """Clusters are source scenes, domains are settings."""
    rows: pd.DataFrame
    """Trials of these configurations, by case and configuration."""
    apart: Table
    """Configurations that are left out, with their coverage."""

    def values(self, column: str) -> Floats:
        """A column's mean over repeats, shape (cases, configurations); what was not measured counts 0."""
        wide = self.rows.assign(value=self.rows[column].astype(float).fillna(0.0)).pivot_table(
            index="case_id", columns="configuration", values="value", aggfunc="mean"
        )
        return wide.loc[self.cases, self.agents].to_numpy(dtype=np.float64)

    def of(self, settings: Sequence[str]) -> list[str]:
        """Those of some settings that have cases."""
        return [setting for setting in settings if setting in self.settings]

    def scores_of(self, drawn: Floats, settings: Sequence[str]) -> Floats | None:
        """Means over settings with their observed shares, shape (draws, configurations); None where one has no case."""
        return None if len(self.of(settings)) < len(settings) else pooled(self.design, drawn, settings)


def case_table(chosen: pd.DataFrame, options: StudyOptions) -> CaseTable:
    """The complete configurations among the wanted ones. One is complete that has an outcome of every planned case.

    Args:
        chosen: rows of the view ``case_scores`` of one scope.

    Raises:
        BadInput: an unknown configuration is wanted.
        NoneComplete: none is complete.
    """
    known = known_agents(chosen, options)
    cases = chosen.drop_duplicates("case_id").sort_values("case_id")
    wanted = options.agents or known
    own = {name: rows for name, rows in chosen.groupby("configuration") if name in wanted}
    complete = [
        name for name in wanted if own[name]["score"].notna().all() and own[name]["case_id"].nunique() == len(cases)
    ]
    apart = _coverage([own[name] for name in wanted if name not in complete], len(cases))
    if not complete:
        raise NoneComplete(
            f"no configuration is complete: {len(apart.rows)} have outcomes of some cases only",
            todo="run them to the end: `c4s run` with the same arguments",
        )
    rows = chosen[chosen["configuration"].isin(complete)]
    return CaseTable(
        agents=complete,
        ranked=[bool(own[name]["ranked"].iloc[0]) for name in complete],
        cases=cases["case_id"].tolist(),
        settings=cases["setting"].tolist(),
        design=Design.of(cases["scene_id"].tolist(), cases["setting"].tolist()),
        rows=rows,
        apart=apart,
    )


def known_agents(chosen: pd.DataFrame, options: StudyOptions) -> list[str]:
    """The configurations that are planned, in order; ``BadInput`` where another one is wanted."""
    known = sorted(set(chosen["configuration"]))
    for name in options.agents:
        if name not in known:
            raise unknown("configuration", name, known)
    return known


def _coverage(left_out: list[pd.DataFrame], cases: int) -> Table:
    rows: list[dict[str, Value]] = []
    for trials in left_out:
        resolved = int(trials["score"].notna().sum())
        rows.append(
            {
                "configuration": str(trials["configuration"].iloc[0]),
                "planned": len(trials),
                "resolved": resolved,
                "cases": int(trials["case_id"].nunique()),
                "of_cases": cases,
                "coverage": resolved / len(trials),
            }
        )
    return Table(
        name="apart",
        title="Configurations with pending or unplanned cases: never ranked",
        columns=[
            Column(name="configuration", title="configuration"),
            Column(name="planned", title="planned trials"),
            Column(name="resolved", title="with an outcome"),
            Column(name="cases", title="cases"),
            Column(name="of_cases", title="of cases"),
            Column(name="coverage", title="coverage", unit="share", decimals=3),
        ],
        rows=rows,
    )


def intervals_of(
    design: Design, options: StudyOptions, method: str = "source-cluster bootstrap, percentile"
) -> Intervals:
    """How the intervals of a study over such cases are made, and whether any is honest."""
    clusters = {str(name): count for name, count in design.clusters_in().items()}
    fewest = min(clusters.values())
    proviso = (
        "Intervals describe sampling of source scenes, not the noise of repeated generation. They hold one at a "
        "time; no correction for their number is made."
    )
    if fewest < MODEST_CLUSTERS:
        proviso += (
            f" With {fewest} source scenes in a setting a percentile interval is too narrow: one that says 95 % holds "
            "the truth rather 87 % of the time with nine (docs/statistics.md)."
        )
    if not design.is_honest():
        proviso = (
            f"No interval is given: a domain has {_scenes(fewest)}, and an interval from so few does not hold "
            "the truth as often as it says."
        )
    return Intervals(
        method=method,
        level=options.level,
        draws=options.draws,
        seed=options.seed,
        unit="source scene within its setting",
        clusters=clusters,
        honest=design.is_honest(),
        proviso=proviso,
    )


def _scenes(count: int) -> str:
    return f"{count} source scene" + ("" if count == 1 else "s")


def number(value: float) -> float | None:
    """A number as a table holds it: None where there is none."""
    return None if np.isnan(value) else float(value)
