"""Whether a configuration's scores drift over nights (ours).

A night is a repeat: a run that grows by one repeat a night, ``c4s run SUITE --repeats N``, measures the same cases with
the same configuration, judge and engine each time.
"""

from __future__ import annotations

import numpy as np

from c4s.errors import BadInput
from c4s.records.analysis import Chart, Column, Findings, Intervals, Table, Value
from c4s.stats.bootstrap import Floats, percentile_interval
from c4s.stats.drift import drift
from c4s.stats.multiple import holm
from warehouse.analyses.cases import CaseTable, case_table, intervals_of, number
from warehouse.analyses.parts import ScoreMean, by_run, score_means
from warehouse.analyses.repeats import PENDING_REPEATS
from warehouse.analyses.study import RESAMPLING, Frames, StudyDefinition, StudyOptions


def compute(frames: Frames, options: StudyOptions) -> Findings:
    """Each configuration's mean by night, its change since the first, and whether nights differ more than runs do."""
    table = case_table(frames["trials"], options)
    runs = by_run(table, "score")
    if runs.shape[2] < 2:
        raise BadInput("each case was run once: there is one night", todo=PENDING_REPEATS)
    complete = [place for place in range(len(table.agents)) if not np.isnan(runs[:, place]).any()]
    if not complete:
        raise BadInput("no configuration has every case in every night", todo="run the same nights of all cases")
    mean = score_means(table)[-1]
    intervals = intervals_of(table.design, options)
    tests = [_tested(table, mean, runs[:, place], place, options) for place in complete]
    if options.holm:
        for name in ("slope_p", "spread_p"):
            for row, p in zip(tests, holm([row[name] for row in tests]), strict=True):
                row[f"{name}_holm"] = float(p)
    nights = [row for place in complete for row in _nights(table, mean, runs[:, place], place, intervals)]
    ends = {"low": "change_low", "high": "change_high"} if intervals.honest else {}
    return Findings(
        tables=[_drift_table(tests, options), _night_table(nights, intervals), table.apart],
        charts=[
            Chart(
                name="drift",
                title=f"Change since the first night ({mean.title})",
                kind="lines",
                table="nights",
                x="night",
                y="change",
                group="configuration",
                **ends,
            )
        ],
        intervals=[intervals],
        notes=[
            f"Of: {mean.title}. p: chance of as steep a slope, or as large a spread of nights, where nothing drifts: "
            "the nights of each case are shuffled. An interval of a change is over source scenes.",
            *(
                ["With two nights a slope and a spread are the same thing: both have one p."]
                if runs.shape[2] == 2
                else []
            ),
        ],
    )


def _tested(table: CaseTable, mean: ScoreMean, scores: Floats, place: int, options: StudyOptions) -> dict[str, Value]:
    own = mean.case_shares > 0
    found = drift(scores[own], mean.case_shares[own], options.draws, options.seed)
    return {
        "configuration": table.agents[place],
        "nights": scores.shape[1],
        "cases": int(own.sum()),
        "slope": found.slope,
        "slope_p": found.slope_p,
        "spread": found.spread,
        "spread_p": found.spread_p,
    }


def _nights(
    table: CaseTable, mean: ScoreMean, scores: Floats, place: int, intervals: Intervals
) -> list[dict[str, Value]]:
    """A row a night; nights count from 1 in the order of the repeats."""
    changes = scores - scores[:, :1]
    observed = mean.means(table.design.observed(), np.concatenate([scores, changes], axis=1))[0]
    ends = None
    if intervals.honest:
        counts = table.design.draw(intervals.draws, intervals.seed)
        ends = percentile_interval(mean.means(counts, changes), intervals.level)
    rows: list[dict[str, Value]] = []
    for night in range(scores.shape[1]):
        row: dict[str, Value] = {
            "configuration": table.agents[place],
            "night": night + 1,
            "mean": float(observed[night]),
            "change": float(observed[scores.shape[1] + night]),
        }
        if ends is not None:
            row |= {f"change_{end}": number(ends[side][night]) for side, end in enumerate(("low", "high"))}
        rows.append(row)
    return rows


def _drift_table(rows: list[dict[str, Value]], options: StudyOptions) -> Table:
    adjusted = options.holm
    return Table(
        name="drift",
        title="Drift over nights",
        columns=[
            Column(name="configuration", title="configuration"),
            Column(name="nights", title="nights"),
            Column(name="cases", title="cases"),
            Column(name="slope", title="change a night", unit="score", decimals=4),
            Column(name="slope_p", title="p", decimals=4),
            *([Column(name="slope_p_holm", title="p (Holm)", decimals=4)] if adjusted else []),
            Column(name="spread", title="SD of nights", unit="score", decimals=4),
            Column(name="spread_p", title="p", decimals=4),
            *([Column(name="spread_p_holm", title="p (Holm)", decimals=4)] if adjusted else []),
        ],
        rows=rows,
    )


def _night_table(rows: list[dict[str, Value]], intervals: Intervals) -> Table:
    ends = [Column(name=f"change_{end}", title=end, unit="score", decimals=4) for end in ("low", "high")]
    return Table(
        name="nights",
        title="Means by night",
        columns=[
            Column(name="configuration", title="configuration"),
            Column(name="night", title="night"),
            Column(name="mean", title="mean", unit="score", decimals=4),
            Column(name="change", title="since the first", unit="score", decimals=4),
            *(ends if intervals.honest else []),
        ],
        rows=rows,
    )


DRIFT = StudyDefinition(
    name="drift",
    title="Drift of a configuration over nights",
    section="",
    sources={"trials": "SELECT * FROM chosen ORDER BY configuration, case_id, repeat"},
    compute=compute,
    takes=RESAMPLING | {"agents", "holm"},
)
