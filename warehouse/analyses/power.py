"""How small a difference of two configurations this suite can find, and how many sources or repeats find the observed
one (ours; sources as units, see ``c4s.stats.power``)."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from c4s.errors import BadInput
from c4s.records.analysis import Chart, Column, Findings, Table, Value
from c4s.stats.bootstrap import LEAST_CLUSTERS, Floats
from c4s.stats.power import POWER, clustered_variances, detectable, repeats_needed, sources_needed
from c4s.stats.variance import ROUNDING, run_variances
from warehouse.analyses.cases import CaseTable, case_table
from warehouse.analyses.parts import ScoreMean, by_run, score_means
from warehouse.analyses.study import Frames, StudyDefinition, StudyOptions

_TIMES = (1, 2, 4, 8)
"""Suites so many times as large."""


def compute(frames: Frames, options: StudyOptions) -> Findings:
    """Of the named pair, else of neighbours by the widest mean: what can be found, and what finding them would take."""
    if len(options.agents) not in (0, 2):
        raise BadInput("two configurations are told apart, or all neighbours", todo="name two, or none")
    table = case_table(frames["trials"], options)
    if len(table.agents) < 2:
        raise BadInput("two complete configurations are expected", todo="run another agent on the same suite")
    pairs_of = _Pairs(table, options)
    means = score_means(table)
    order = np.argsort(-means[-1].means(table.design.observed(), table.values("score"))[0], kind="stable")
    pairs = [(0, 1)] if options.agents else list(pairwise(order.tolist()))
    rows = [pairs_of.row(mean, first, second) for mean in means for first, second in pairs]
    few = dict.fromkeys(str(row["cases_of"]) for row in rows if row["error"] is None)
    rows = [row for row in rows if row["error"] is not None]
    if not rows:
        raise BadInput(
            f"no setting has {LEAST_CLUSTERS} source scenes in each domain: an error told from fewer is none",
            todo="run the configurations on a suite of more scenes",
        )
    return Findings(
        tables=[_table(rows), _larger(rows, options), table.apart],
        charts=[
            Chart(
                name="power",
                title=f"Least difference found {POWER:.0%} of the time, by sources",
                kind="lines",
                table="larger",
                x="sources",
                y="detectable",
                group="cases_of",
            )
        ],
        notes=[
            f"A true difference as large as the least one is found {POWER:.0%} of the time at {1 - options.level:.2g}, "
            "two-sided. Sources and repeats needed hold if the true difference is the one observed, which is a guess. "
            "Errors are clustered by source scene, with Student's t.",
            *(
                [f"Of {', '.join(few)} nothing is told: a domain has fewer than {LEAST_CLUSTERS} source scenes."]
                if few
                else []
            ),
            *([] if pairs_of.repeated else ["Without repeats nothing is known of what more repeats would bring."]),
        ],
    )


class _Pairs:
    """Differences of configurations with their errors."""

    def __init__(self, table: CaseTable, options: StudyOptions) -> None:
        runs = by_run(table, "score")
        counts = (~np.isnan(runs)).sum(axis=2)
        self.table, self.options = table, options
        self.values = table.values("score")
        self.repeated = bool((counts > 1).all())
        self.repeats = int(counts.min())
        self.run_errors = np.stack([run_variances(runs[:, place]) for place in range(runs.shape[1])], axis=1) / counts

    def row(self, mean: ScoreMean, first: int, second: int) -> dict[str, Value]:
        """A pair on one mean."""
        difference = self.values[:, first] - self.values[:, second]
        own = mean.shares > 0
        variances = clustered_variances(mean.table.design, difference)[own, 0]
        variance = float(mean.shares[own] ** 2 @ variances)
        variance = 0.0 if variance < ROUNDING else variance
        freedom = mean.sources - mean.domains
        observed = float(mean.case_shares @ difference)
        row: dict[str, Value] = {
            "cases_of": mean.title,
            "pair": f"{self.table.agents[first]} – {self.table.agents[second]}",
            "cases": mean.cases,
            "sources": mean.sources,
            "domains": mean.domains,
            "difference": observed,
            "error": None,
            "detectable": None,
            "sources_needed": None,
            "cases_needed": None,
            "repeats_needed": None,
        }
        if np.bincount(mean.table.design.domain_of)[own].min() < LEAST_CLUSTERS:
            return row
        level = self.options.level
        row["error"] = variance**0.5
        row["detectable"] = detectable(variance, freedom, level)
        if observed and variance:
            needed = sources_needed(observed, variance, mean.sources, mean.domains, level)
            row["sources_needed"] = needed
            row["cases_needed"] = None if needed is None else round(needed * mean.cases / mean.sources)
            if self.repeated:
                of_runs = self._of_runs(mean, first, second)
                row["repeats_needed"] = repeats_needed(observed, variance, of_runs, self.repeats, freedom, level=level)
        return row

    def _of_runs(self, mean: ScoreMean, first: int, second: int) -> float:
        """The part of a mean difference's variance that comes of runs."""
        errors: Floats = self.run_errors[:, first] + self.run_errors[:, second]
        own = mean.case_shares > 0
        return float(mean.case_shares[own] ** 2 @ errors[own])


def _table(rows: list[dict[str, Value]]) -> Table:
    return Table(
        name="power",
        title="What tells two configurations apart",
        columns=[
            Column(name="cases_of", title="cases of"),
            Column(name="pair", title="configurations"),
            Column(name="cases", title="cases"),
            Column(name="sources", title="sources"),
            Column(name="difference", title="difference", unit="score", decimals=4),
            Column(name="error", title="standard error", unit="score", decimals=4),
            Column(name="detectable", title="least difference found", unit="score", decimals=4),
            Column(name="sources_needed", title="sources needed"),
            Column(name="cases_needed", title="cases"),
            Column(name="repeats_needed", title="repeats needed"),
        ],
        rows=rows,
    )


def _larger(rows: list[dict[str, Value]], options: StudyOptions) -> Table:
    """The least difference by the size of the suite, of the pair with the middle error."""
    made: list[dict[str, Value]] = []
    for title in dict.fromkeys(row["cases_of"] for row in rows):
        own = sorted((row for row in rows if row["cases_of"] == title), key=lambda row: _float(row["error"]))
        row = own[len(own) // 2]
        sources, domains = int(_float(row["sources"])), int(_float(row["domains"]))
        for times in _TIMES:
            variance = (_float(row["error"]) ** 2) / times
            made.append(
                {
                    "cases_of": title,
                    "times": times,
                    "sources": times * sources,
                    "cases": times * int(_float(row["cases"])),
                    "detectable": detectable(variance, times * sources - domains, options.level),
                }
            )
    return Table(
        name="larger",
        title="Least difference found by suites so many times as large (the pair with the middle error)",
        columns=[
            Column(name="cases_of", title="cases of"),
            Column(name="times", title="times"),
            Column(name="sources", title="sources"),
            Column(name="cases", title="cases"),
            Column(name="detectable", title="least difference found", unit="score", decimals=4),
        ],
        rows=made,
    )


def _float(value: Value) -> float:
    return float(value or 0)


POWER_STUDY = StudyDefinition(
    name="power",
    title="What tells two configurations apart",
    section="",
    sources={"trials": "SELECT * FROM chosen ORDER BY configuration, case_id, repeat"},
    compute=compute,
    takes=frozenset({"agents", "level"}),
)
