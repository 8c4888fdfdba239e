"""Paired differences of two configurations in scores and non-polling tool calls (paper, "Interaction volume and scene
quality", tab:trajectory-paired; SA20, EU35): a bootstrap interval and a sign-flip p by source scenes."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from c4s.errors import BadInput
from c4s.records.analysis import Chart, Column, Findings, Table, Value
from c4s.stats.bootstrap import Floats, percentile_interval
from c4s.stats.multiple import holm
from c4s.stats.permutation import cluster_sums, sign_flip
from warehouse.analyses.cases import CaseTable, case_table, intervals_of, number
from warehouse.analyses.parts import ScoreMean, by_run, score_means
from warehouse.analyses.study import RESAMPLING, Frames, StudyDefinition, StudyOptions

_POINTS = 100.0
_MEASURES = (("score", "score", "points", _POINTS, 2), ("calls", "calls", "", 1.0, 2))
"""Name, title, unit, factor and shown decimals of what is compared."""


def compute(frames: Frames, options: StudyOptions) -> Findings:
    """The first named configuration less the second."""
    if len(set(options.agents)) != 2:
        raise BadInput("two configurations are compared", todo="name them: -a FIRST -a SECOND")
    table = case_table(frames["trials"], options)
    if len(table.agents) < 2:
        left = table.apart.rows[0]
        raise BadInput(
            f"{left['configuration']} has an outcome of {left['resolved']} of {left['planned']} trials: a difference "
            "is told of complete configurations",
            todo="run it to the end: `c4s run` with the same arguments",
        )
    means = score_means(table)
    intervals = intervals_of(table.design, options)
    counts = table.design.draw(options.draws, options.seed) if intervals.honest else None
    rows: list[dict[str, Value]] = [
        {"cases_of": mean.title, "cases": mean.cases, "sources": mean.sources} for mean in means
    ]
    for name, _, _, factor, _ in _MEASURES:
        differences = factor * _differences(table, name)
        for row, mean in zip(rows, means, strict=True):
            row |= _compared(name, mean, differences, counts, options)
    if options.holm:
        _adjust(rows)
    first, second = table.agents
    made = Table(
        name="paired", title=f"{first} less {second}", columns=_columns(counts is not None, options), rows=rows
    )
    return Findings(
        tables=[made, table.apart],
        charts=[_chart(name, f"{title}: {first} less {second}", counts is not None) for name, title, *_ in _MEASURES],
        intervals=[intervals],
        notes=_notes(rows, options),
    )


def _differences(table: CaseTable, column: str) -> Floats:
    """Of each case, each side over its own measured repeats; NaN where one was never measured."""
    runs = by_run(table, column)
    known = ~np.isnan(runs)
    with np.errstate(invalid="ignore"):
        means = np.where(known, runs, 0.0).sum(axis=2) / known.sum(axis=2)
    return np.asarray(means[:, 0] - means[:, 1])


def _compared(
    name: str, mean: ScoreMean, differences: Floats, counts: Floats | None, options: StudyOptions
) -> dict[str, Value]:
    """The mean difference with its interval and p; ``least_p`` is what so few sources can give at best."""
    table = differences[:, None]
    shares = mean.known_shares(differences)
    row: dict[str, Value] = {name: number(mean.known_means(mean.table.design.observed(), table)[0, 0])}
    if counts is not None:
        ends = percentile_interval(mean.known_means(counts, table), options.level)
        row |= {f"{name}_{end}": number(value[0]) for end, value in zip(("low", "high"), ends, strict=True)}
    if row[name] is None:
        return row | {f"{name}_p": None, f"{name}_least_p": None}
    sums = cluster_sums(mean.table.design, np.nan_to_num(differences), shares)
    test = sign_flip(sums, options.draws, options.seed)
    return row | {f"{name}_p": test.p, f"{name}_least_p": test.least}


def _adjust(rows: Sequence[dict[str, Value]]) -> None:
    """Holm over all tests of the answer."""
    tests = [(row, name) for row in rows for name, *_ in _MEASURES]
    given = [row[f"{name}_p"] for row, name in tests]
    for (row, name), p in zip(tests, holm([np.nan if p is None else p for p in given]), strict=True):
        row[f"{name}_p_holm"] = number(p)


def _columns(with_ends: bool, options: StudyOptions) -> list[Column]:
    columns = [
        Column(name="cases_of", title="cases of"),
        Column(name="cases", title="cases"),
        Column(name="sources", title="sources"),
    ]
    for name, title, unit, _, decimals in _MEASURES:
        parts: list[tuple[str, str, str, int]] = [(name, f"Δ {title}", unit, decimals)]
        if with_ends:
            parts += [(f"{name}_{end}", end, unit, decimals) for end in ("low", "high")]
        parts += [(f"{name}_p", "p", "", 4)]
        if options.holm:
            parts += [(f"{name}_p_holm", "p (Holm)", "", 4)]
        columns += [Column(name=key, title=told, unit=of, decimals=shown) for key, told, of, shown in parts]
    return columns


def _chart(name: str, title: str, with_ends: bool) -> Chart:
    ends: dict[str, Any] = {"low": f"{name}_low", "high": f"{name}_high"} if with_ends else {}
    return Chart(
        name=f"paired_{name}",
        title=f"Difference in {title}",
        kind="dots",
        table="paired",
        x=name,
        y="cases_of",
        reference=0.0,
        **ends,
    )


def _notes(rows: Sequence[dict[str, Value]], options: StudyOptions) -> list[str]:
    notes = [
        "Scores are in points (0 to 100); calls leave status checks out and are of recorded runs, those without a call "
        "included. p: share of the ways to flip the signs of whole sources that give as large a difference, two-sided."
    ]
    blunt = [
        row for row in rows if isinstance(row["score_least_p"], float) and row["score_least_p"] > 1 - options.level
    ]
    if blunt:
        told = ", ".join(f"{row['cases_of']} {row['score_least_p']:.3g}" for row in blunt)
        notes.append(
            f"Too few sources to find a difference in scores at {1 - options.level:.2g}: the smallest p that there "
            f"can be of scores is {told}."
        )
    return notes


PAIRED = StudyDefinition(
    name="paired",
    title="Paired differences of two configurations",
    section="app:trajectory-effort, tab:trajectory-paired",
    sources={
        "trials": """
            SELECT c.*, a.calls FROM chosen AS c
            LEFT JOIN (SELECT trial_id, tool_calls - polling_calls AS calls FROM attempts WHERE recorded) AS a
            USING (trial_id) ORDER BY c.configuration, c.case_id, c.repeat"""
    },
    compute=compute,
    takes=RESAMPLING | {"agents", "holm"},
)
