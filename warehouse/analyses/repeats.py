"""What repeats tell: how scores spread between cases and between runs of a case, and how probable complete recovery is
in some or in all of k runs (ours; complete recovery as in the paper's "Final repair outcomes")."""

from __future__ import annotations

from typing import Final

import numpy as np

from c4s.errors import BadInput
from c4s.records.analysis import Chart, Column, Findings, Intervals, Table, Value
from c4s.stats.bootstrap import Floats, percentile_interval
from c4s.stats.passes import pass_all, pass_at
from c4s.stats.variance import spread
from warehouse.analyses.cases import REPAIRS, CaseTable, case_table, intervals_of, number
from warehouse.analyses.parts import by_run, over_known, score_means
from warehouse.analyses.study import RESAMPLING, Frames, StudyDefinition, StudyOptions

_RECOVERIES: Final = (
    ("complete_recovery", "Complete recovery", ("repair_recall",)),
    ("clean_recovery", "Complete recovery without false positives", ("repair_recall", "repair_precision")),
)
"""Name and title of what is a success, and which shares are then 1."""
_WHOLE: Final = 1 - 1e-9
_KINDS: Final = (("any", "pass@k"), ("all", "pass^k"))
PENDING_REPEATS: Final = "run them: `c4s run SUITE --repeats 3`"


def compute(frames: Frames, options: StudyOptions) -> Findings:
    """Spread of each configuration's scores by part of the suite, and its passes by k."""
    table = case_table(frames["trials"], options)
    runs = by_run(table, "score")
    if runs.shape[2] < 2:
        raise BadInput("each case was run once: nothing is repeated", todo=PENDING_REPEATS)
    intervals = intervals_of(table.design, options)
    passes = [_passes(table, recovery, intervals, options) for recovery in _RECOVERIES] if table.of(REPAIRS) else []
    return Findings(
        tables=[_spreads(table, runs), *passes, table.apart],
        charts=[
            Chart(
                name=made.name, title=made.title, kind="lines", table=made.name, x="k", y="all", group="configuration"
            )
            for made in passes
        ],
        intervals=[intervals] if passes else [],
        notes=[
            "pass@k: at least one of k runs succeeds; pass^k: each of them does. Both are without bias, over cases "
            "that have k runs or more. A variance between cases may be estimated below 0.",
            *([] if passes else ["Complete recovery is of repairs, and there is none here."]),
        ],
    )


def _spreads(table: CaseTable, runs: Floats) -> Table:
    rows: list[dict[str, Value]] = []
    for mean in score_means(table):
        if mean.domains > 1:
            continue
        own = mean.case_shares > 0
        for place, agent in enumerate(table.agents):
            found = spread(runs[own, place])
            between, within = found.between_cases, found.between_runs
            rows.append(
                {
                    "cases_of": mean.title,
                    "configuration": agent,
                    "cases": found.cases,
                    "runs": found.runs,
                    "mean": float(np.nanmean(runs[own, place], axis=1).mean()),
                    "between_cases": between,
                    "between_runs": within,
                    "run_sd": None if within is None else within**0.5,
                    "intraclass": found.intraclass,
                }
            )
    return Table(
        name="spread",
        title="Spread of scores between cases and between runs of a case",
        columns=[
            Column(name="cases_of", title="cases of"),
            Column(name="configuration", title="configuration"),
            Column(name="cases", title="cases"),
            Column(name="runs", title="runs"),
            Column(name="mean", title="mean score", unit="score", decimals=3),
            Column(name="between_cases", title="variance between cases", decimals=5),
            Column(name="between_runs", title="between runs", decimals=5),
            Column(name="run_sd", title="SD of a run", unit="score", decimals=3, marks="low"),
            Column(name="intraclass", title="share of cases", unit="share", decimals=3),
        ],
        rows=rows,
    )


def _passes(
    table: CaseTable, recovery: tuple[str, str, tuple[str, ...]], intervals: Intervals, options: StudyOptions
) -> Table:
    """A row a configuration and k; means over repair cases that have k runs."""
    name, title, columns = recovery
    known = ~np.isnan(by_run(table, "score"))
    runs = known.sum(axis=2)
    counts = table.design.draw(options.draws, options.seed) if intervals.honest else None
    repairs = np.array([setting in REPAIRS for setting in table.settings])
    whole = np.all([by_run(table, column) >= _WHOLE for column in columns], axis=0)
    successes = (whole & known).sum(axis=2)
    rows: list[dict[str, Value]] = []
    for k in range(1, int(runs[repairs].max()) + 1):
        chances = np.concatenate([chance(successes, runs, k) for chance in (pass_at, pass_all)], axis=1)
        chances[~repairs] = np.nan
        observed = over_known(table, table.design.observed(), chances)[0]
        ends = None if counts is None else percentile_interval(over_known(table, counts, chances), options.level)
        for place, agent in enumerate(table.agents):
            row: dict[str, Value] = {"configuration": agent, "k": k, "cases": int((~np.isnan(chances[:, place])).sum())}
            for kind, column in (("any", place), ("all", place + len(table.agents))):
                row[kind] = number(observed[column])
                if ends is not None:
                    row |= {f"{kind}_{end}": number(ends[side][column]) for side, end in enumerate(("low", "high"))}
            rows.append(row)
    rows.sort(key=lambda row: table.agents.index(str(row["configuration"])))
    return Table(
        name=name,
        title=f"{title} in k runs, all repairs",
        columns=[
            Column(name="configuration", title="configuration"),
            Column(name="k", title="k"),
            Column(name="cases", title="cases"),
            *(column for kind, told in _KINDS for column in _columns(kind, told, intervals.honest)),
        ],
        rows=rows,
    )


def _columns(name: str, title: str, with_ends: bool) -> list[Column]:
    told = [(name, title), *([(f"{name}_{end}", end) for end in ("low", "high")] if with_ends else [])]
    return [Column(name=key, title=words, unit="share", decimals=3) for key, words in told]


REPEATS = StudyDefinition(
    name="repeats",
    title="What repeated runs tell",
    section="",
    sources={"trials": "SELECT * FROM chosen ORDER BY configuration, case_id, repeat"},
    compute=compute,
    takes=RESAMPLING | {"agents"},
)
