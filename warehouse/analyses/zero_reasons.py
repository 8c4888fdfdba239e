"""Trials that are worth zero without being measured, by reason and configuration (paper, tab:invalid-breakdown; SA41).

A reason is a code, one column each; how many is the number beside it. Public and private cases stand apart.
"""

from __future__ import annotations

from collections.abc import Sequence

import pandas as pd

from c4s.records.analysis import Chart, Column, Findings, Table, Value
from warehouse.analyses.cases import known_agents
from warehouse.analyses.panels import SETS, TITLES
from warehouse.analyses.study import BOTH_PANELS, Frames, StudyDefinition, StudyOptions

UNTOLD = "untold"
"""The code of a zero whose verdict tells none."""


def compute(frames: Frames, options: StudyOptions) -> Findings:
    """A row a configuration and setting that has a zero, a column a reason, and the sums."""
    trials = frames["trials"]
    known_agents(trials, options)
    chosen = trials[trials["configuration"].isin(options.agents)] if options.agents else trials
    tables, charts = [], []
    for name in SETS:
        own = chosen[chosen["visibility"] == name]
        if own.empty:
            continue
        zeros = _of_zeros(own)
        codes = sorted(set(zeros["code"]))
        tables += [_zeros(name, own, zeros, codes), _sums(name, zeros, codes)]
        if codes:
            charts.append(
                Chart(
                    name=f"zeros_{name}",
                    title=f"Zeros without a measurement, by reason ({name} set)",
                    kind="stacks",
                    table=f"zeros_{name}",
                    x="total",
                    y="configuration",
                    group="setting",
                    series=codes,
                )
            )
    notes = [] if charts else ["Every trial with an outcome was measured: there is no zero without a measurement."]
    return Findings(tables=tables, charts=charts, notes=notes)


def _zeros(name: str, trials: pd.DataFrame, zeros: pd.DataFrame, codes: Sequence[str]) -> Table:
    rows: list[dict[str, Value]] = []
    for (configuration, setting), own in zeros.groupby(["configuration", "setting"]):
        rows.append({"configuration": str(configuration), "setting": TITLES[str(setting)], **_counted(own, codes)})
    rows.sort(key=lambda row: (-int(row["total"] or 0), str(row["configuration"]), str(row["setting"])))
    return Table(
        name=f"zeros_{name}",
        title=f"Zeros without a measurement ({name} set: {len(zeros)} of {int(trials['score'].notna().sum())} trials "
        "with an outcome)",
        columns=[
            Column(name="configuration", title="configuration"),
            Column(name="setting", title="setting"),
            *(Column(name=code, title=code.replace("_", " "), unit="trials") for code in codes),
            Column(name="total", title="total", unit="trials"),
        ],
        rows=rows,
    )


def _counted(zeros: pd.DataFrame, codes: Sequence[str]) -> dict[str, int]:
    counts = zeros["code"].value_counts()
    return {**{code: int(counts.get(code, 0)) for code in codes}, "total": len(zeros)}


def _sums(name: str, zeros: pd.DataFrame, codes: Sequence[str]) -> Table:
    rows: list[dict[str, Value]] = [
        {"reason": reason, "trials": count} for reason, count in _counted(zeros, codes).items()
    ]
    return Table(
        name=f"sums_{name}",
        title=f"Zeros of all configurations by reason ({name} set)",
        columns=[Column(name="reason", title="reason"), Column(name="trials", title="trials")],
        rows=rows,
    )


def _of_zeros(trials: pd.DataFrame) -> pd.DataFrame:
    zeros = trials[trials["status"].str.startswith("zero_")]
    return zeros.assign(code=zeros["reason_code"].replace("", UNTOLD))


ZERO_REASONS = StudyDefinition(
    name="zero-reasons",
    title="Zeros without a measurement, by reason",
    section="tab:invalid-breakdown",
    sources={"trials": "SELECT * FROM chosen ORDER BY configuration, case_id, repeat"},
    compute=compute,
    takes=frozenset({"agents"}),
    across=BOTH_PANELS,
)
