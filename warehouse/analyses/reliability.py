"""Consistency of each configuration over repeats, by the published reliability metrics of HAL with their corrected
formula (Rabanser et al., arXiv 2602.16666; ``c4s.stats.reliability``)."""

from __future__ import annotations

from typing import Final

import numpy as np
import pandas as pd

from c4s.errors import BadInput
from c4s.records.analysis import Chart, Column, Findings, Intervals, Table, Value
from c4s.stats.bootstrap import Floats, percentile_interval
from c4s.stats.reliability import (
    outcome_consistency,
    overall_consistency,
    resource_consistency,
    trajectory_consistency,
    unbiased_outcome_consistency,
)
from warehouse.analyses.cases import REPAIRS, CaseTable, case_table, intervals_of, number
from warehouse.analyses.parts import by_run, over_known
from warehouse.analyses.repeats import PENDING_REPEATS
from warehouse.analyses.study import RESAMPLING, Frames, StudyDefinition, StudyOptions

_RESOURCES: Final = ("run_wall_s", "run_cost_usd", "run_calls", "run_tokens")
_ASPECTS: Final = (
    ("outcome", "outcome"),
    ("outcome_unbiased", "outcome, unbiased"),
    ("trajectory", "trajectory"),
    ("resource", "resource"),
)
_OF_THREE: Final = ("outcome", "trajectory", "resource")


def compute(frames: Frames, options: StudyOptions) -> Findings:
    """Consistency of complete recovery, of the shares of tools and of resources; means over cases that have each."""
    table = case_table(frames["trials"], options)
    runs = by_run(table, "score")
    if runs.shape[2] < 2:
        raise BadInput("each case was run once: nothing is repeated", todo=PENDING_REPEATS)
    measured = _measured(table, frames["tools"], ~np.isnan(runs))
    intervals = intervals_of(table.design, options)
    rows = _rows(table, measured, intervals, options)
    made = Table(
        name="reliability",
        title="Consistency over repeats",
        columns=[
            Column(name="configuration", title="configuration"),
            Column(name="recovered", title="recovered", unit="share", decimals=3),
            *(column for name, title in _ASPECTS for column in _columns(name, title, intervals.honest)),
            Column(name="overall", title="R_Con", decimals=3),
        ],
        rows=rows,
    )
    ends = {"low": "resource_low", "high": "resource_high"} if intervals.honest else {}
    return Findings(
        tables=[made, table.apart],
        charts=[
            Chart(
                name="resource_consistency",
                title="Consistency of time, cost, calls and tokens over repeats",
                kind="dots",
                table="reliability",
                x="resource",
                y="configuration",
                **ends,
            )
        ],
        intervals=[intervals],
        notes=[
            "Outcome: (2p - 1)^2 of complete recovery, of repairs; unbiased: with the sample variance. Trajectory: "
            "shares of tools (HAL's distribution metric) in pairs of runs that recovered completely. Resource: "
            "exp(-CV) of time, cost, calls and tokens. R_Con: mean of the three, without what was not measured.",
            "Who always fails is consistent too: read it beside the share that recovered.",
            "Not measured here: HAL's order of actions (the warehouse counts calls by tool), predictability (agents "
            "tell no confidence), robustness (no perturbed runs) and safety.",
        ],
    )


def _measured(table: CaseTable, tools: pd.DataFrame, known: np.ndarray) -> dict[str, Floats]:
    """Each aspect of each case and configuration, shape (cases, configurations); NaN where it was not measured."""
    repairs = np.array([setting in REPAIRS for setting in table.settings])
    whole = (by_run(table, "repair_recall") >= 1 - 1e-9) & known & repairs[:, None, None]
    runs = np.where(repairs[:, None], known.sum(axis=2), 0)
    amounts = [by_run(table, name) for name in _RESOURCES]
    calls = _calls(table, tools, known.shape[2])
    places = list(np.ndindex(known.shape[:2]))
    shape = known.shape[:2]
    with np.errstate(invalid="ignore"):
        recovered = whole.sum(axis=2) / runs
    return {
        "recovered": recovered,
        "outcome": outcome_consistency(whole.sum(axis=2), runs),
        "outcome_unbiased": unbiased_outcome_consistency(whole.sum(axis=2), runs),
        "trajectory": np.array([trajectory_consistency(calls[place][whole[place]]) for place in places]).reshape(shape),
        "resource": np.array(
            [resource_consistency([np.nan_to_num(kind[place]) for kind in amounts]) for place in places]
        ).reshape(shape),
    }


def _calls(table: CaseTable, tools: pd.DataFrame, repeats: int) -> Floats:
    """Calls by tool, shape (cases, configurations, repeats, tools)."""
    names = sorted(set(tools["tool"]))
    found = np.zeros((len(table.cases), len(table.agents), repeats, len(names)))
    numbers = {repeat: place for place, repeat in enumerate(sorted(set(table.rows["repeat"])))}
    keys = zip(tools["case_id"], tools["configuration"], tools["repeat"], tools["tool"], tools["calls"], strict=True)
    cases, agents, kinds = ({name: place for place, name in enumerate(of)} for of in (table.cases, table.agents, names))
    for case, agent, repeat, tool, calls in keys:
        if agent in agents:
            found[cases[case], agents[agent], numbers[repeat], kinds[tool]] = calls
    return found


def _rows(
    table: CaseTable, measured: dict[str, Floats], intervals: Intervals, options: StudyOptions
) -> list[dict[str, Value]]:
    rows: list[dict[str, Value]] = [{"configuration": agent} for agent in table.agents]
    counts = table.design.draw(options.draws, options.seed) if intervals.honest else None
    for name, values in measured.items():
        means = over_known(table, table.design.observed(), values)[0]
        ends = None if counts is None else percentile_interval(over_known(table, counts, values), options.level)
        for place, row in enumerate(rows):
            row[name] = number(means[place])
            if ends is not None and name != "recovered":
                row |= {f"{name}_{end}": number(ends[side][place]) for side, end in enumerate(("low", "high"))}
    for row in rows:
        known = [float(value) for name in _OF_THREE if isinstance(value := row[name], float)]
        row["overall"] = number(overall_consistency(known))
    return rows


def _columns(name: str, title: str, with_ends: bool) -> list[Column]:
    told = [(name, title), *([(f"{name}_{end}", end) for end in ("low", "high")] if with_ends else [])]
    return [Column(name=key, title=words, decimals=3) for key, words in told]


RELIABILITY = StudyDefinition(
    name="reliability",
    title="Consistency over repeats, by HAL's metrics",
    section="",
    sources={
        "trials": """
            SELECT c.*, a.wall_s AS run_wall_s, a.cost_usd AS run_cost_usd, a.tool_calls AS run_calls,
                a.input_tokens + a.output_tokens AS run_tokens
            FROM chosen AS c LEFT JOIN (SELECT * FROM attempts WHERE recorded) AS a USING (trial_id)
            ORDER BY c.configuration, c.case_id, c.repeat""",
        "tools": """
            SELECT c.configuration, c.case_id, c.repeat, u.tool, u.calls FROM chosen AS c
            JOIN tool_use AS u USING (trial_id) WHERE u.recorded
            ORDER BY c.configuration, c.case_id, c.repeat, u.tool""",
    },
    compute=compute,
    takes=RESAMPLING | {"agents"},
)
