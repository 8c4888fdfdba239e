"""What agents did: tool calls, operations inside Python, and the errors that they met (paper, "Agent Behavior Analysis"
and "Execution errors", tab:actual-tool-usage, fig:joint-trajectory-2; SA21-SA27, SA45, SA46).

All of it is of recorded runs: the attempt with a valid submission, else the last; runs without a call included.
"""

from __future__ import annotations

import re
from functools import partial

import pandas as pd

from c4s.errors import BadInput
from c4s.protocol.settings import SETTING_TITLES, SETTINGS, Setting
from c4s.records.analysis import Chart, Column, Findings, Table, Value
from c4s.trajectory import FAMILIES
from warehouse.analyses.cases import VISIBILITIES
from warehouse.analyses.panels import CoverageGate, coverage_gate
from warehouse.analyses.study import BOTH_PANELS, Frames, StudyDefinition, StudyOptions

NAMED_ERRORS = ("AttributeError", "TypeError")
"""The families that the paper names."""
_ALL = "all"
_SUM = "sum of all"
_KEYS = [
    Column(name="configuration", title="configuration"),
    Column(name="setting", title="setting"),
    Column(name="set", title="set"),
]
_NO_SUBMISSION = "no Python submission of such configurations is there"
_TOTALS = {
    "submissions": "submissions",
    "parseable": "that parse",
    "cases": "cases with any",
    "answered": "seen to run",
    "failed": "of these failed",
}


def tool_usage(frames: Frames, options: StudyOptions) -> Findings:
    """Mean calls without status checks, by setting and set, with the split into Python and other tools."""
    gate, runs = _wanted(frames, "attempts", options, "no recorded run of such configurations is there")
    rows: list[dict[str, Value]] = []
    for agent, setting, visibility in _groups(runs):
        own = _of(runs, agent, setting, visibility)
        calls = own["tool_calls"] - own["polling_calls"]
        rows.append(
            {
                "configuration": agent,
                "setting": SETTING_TITLES[setting],
                "set": visibility,
                "runs": len(own),
                "calls": float(calls.mean()),
                "python": float(own["python_calls"].mean()),
                "other": float((calls - own["python_calls"]).mean()),
                "polling": float(own["polling_calls"].mean()),
                "failed": int(own["failed_calls"].sum()),
                "transforms": int(own["named_transform_calls"].sum()),
            }
        )
    table = Table(
        name="calls",
        title="Mean tool calls of a recorded run, status checks left out",
        columns=[
            *_KEYS,
            Column(name="runs", title="runs"),
            Column(name="calls", title="calls", decimals=1),
            Column(name="python", title="of Python", decimals=1),
            Column(name="other", title="of other tools", decimals=1),
            Column(name="polling", title="status checks", decimals=1),
            Column(name="failed", title="failed, in all"),
            Column(name="transforms", title="named transform calls, in all"),
        ],
        rows=rows,
    )
    charts = [
        Chart(
            name=f"calls_{place}",
            title=f"Mean tool calls of a recorded run: {', '.join(only.values())}",
            kind="stacks",
            table="calls",
            only=only,
            x="calls",
            y="configuration",
            series=["python", "other"],
        )
        for place, only in _panels(rows)
    ]
    note = "A call counts from its metered start, failed and unfinished ones too; a repeated request id counts once."
    return Findings(tables=[table, *gate.apart], charts=charts, notes=[note])


def python_operations(frames: Frames, options: StudyOptions) -> Findings:
    """Scripts that hold each operation family, their share of those that parse, and the cases where any does."""
    gate, submissions = _wanted(frames, "submissions", options, _NO_SUBMISSION)
    totals: list[dict[str, Value]] = []
    scripts: list[dict[str, Value]] = []
    shares: list[dict[str, Value]] = []
    cases: list[dict[str, Value]] = []
    for agent, setting, visibility in _groups(submissions):
        own = _of(submissions, agent, setting, visibility)
        parseable = own[own["parseable"]]
        words = parseable["families"].str.split()
        held = {family: parseable[words.map(partial(_holds, family))] for family in FAMILIES}
        named: dict[str, Value] = {"configuration": agent, "setting": SETTING_TITLES[setting], "set": visibility}
        totals.append(
            named
            | {
                "submissions": len(own),
                "parseable": len(parseable),
                "cases": int(own["case_id"].nunique()),
                "answered": int(own["feedback"].sum()),
                "failed": int(own["failed"].sum()),
            }
        )
        if len(parseable):
            scripts.append(named | {family: len(found) for family, found in held.items()})
            shares.append(named | {family: len(found) / len(parseable) for family, found in held.items()})
            cases.append(named | {family: int(found["case_id"].nunique()) for family, found in held.items()})
    families = [Column(name=family, title=family.replace("_", " ")) for family in FAMILIES]
    told = [Column(name=name, title=title) for name, title in _TOTALS.items()]
    in_shares = [one.model_copy(update={"unit": "share", "decimals": 3}) for one in families]
    return Findings(
        tables=[
            Table(name="submissions", title="Python submissions of recorded runs", columns=_KEYS + told, rows=totals),
            Table(name="scripts", title="Scripts that hold an operation", columns=_KEYS + families, rows=scripts),
            Table(name="shares", title="Share of scripts that parse", columns=_KEYS + in_shares, rows=shares),
            Table(name="cases", title="Cases with any such script", columns=_KEYS + families, rows=cases),
            *gate.apart,
        ],
        charts=[
            Chart(
                name=f"shares_{place}",
                title=f"Operations in Python scripts that parse: {', '.join(only.values())}",
                kind="heat",
                table="shares",
                only=only,
                y="configuration",
                series=list(FAMILIES),
            )
            for place, only in _panels(shares)
        ],
        notes=[
            "An operation is attempted where a script names its function; a script that does not parse, or is not on "
            "record, rules nothing out. Families may occur together."
        ],
    )


def execution_errors(frames: Frames, options: StudyOptions) -> Findings:
    """Exception classes among Python submissions that showed an error."""
    gate, submissions = _wanted(frames, "submissions", options, _NO_SUBMISSION)
    bearing = submissions[submissions["errors"] != ""]
    rows: list[dict[str, Value]] = []
    for agent in (*sorted(set(bearing["configuration"])), _SUM):
        own = bearing if agent == _SUM else bearing[bearing["configuration"] == agent]
        rows += _error_rows(agent, _ALL, own) if len(own) else []
        for setting in SETTINGS:
            inside = own[own["setting"] == setting]
            rows += _error_rows(agent, SETTING_TITLES[setting], inside) if len(inside) else []
    table = Table(
        name="errors",
        title="Errors in Python submissions that showed one",
        columns=[
            Column(name="configuration", title="configuration"),
            Column(name="setting", title="setting"),
            Column(name="error", title="error"),
            Column(name="submissions", title="submissions"),
            Column(name="of", title="with an error"),
            Column(name="share", title="share", unit="share", decimals=3),
        ],
        rows=rows,
    )
    return Findings(
        tables=[table, *gate.apart],
        charts=[
            Chart(
                name="errors",
                title="Exception classes in submissions that showed an error",
                kind="bars",
                table="errors",
                only={"setting": _ALL, "configuration": _SUM},
                x="share",
                y="error",
            )
        ]
        if rows
        else [],
        notes=[
            f"{len(bearing)} of {len(submissions)} submissions showed an error. Shares are of these, no error "
            "rates: where "
            "no answer or log was seen, none is ruled out. A submission counts once for each class; that a job "
            "was taken on "
            "is no sign that it ran."
        ],
    )


def _error_rows(agent: str, setting: str, own: pd.DataFrame) -> list[dict[str, Value]]:
    classes = own["errors"].str.split()
    both = " or ".join(NAMED_ERRORS)
    counts = {both: int(classes.map(lambda found: bool(set(NAMED_ERRORS) & set(found))).sum())}
    counts |= {str(name): int(count) for name, count in classes.explode().value_counts().items()}
    return [
        {
            "configuration": agent,
            "setting": setting,
            "error": name,
            "submissions": count,
            "of": len(own),
            "share": count / len(own),
        }
        for name, count in counts.items()
    ]


def _wanted(frames: Frames, source: str, options: StudyOptions, otherwise: str) -> tuple[CoverageGate, pd.DataFrame]:
    """The rows of complete configurations; ``BadInput`` where there is none."""
    gate = coverage_gate(frames["trials"], options, SETTINGS)
    found = gate.passed(frames[source])
    if found.empty:
        raise BadInput(otherwise)
    return gate, found


def _panels(rows: list[dict[str, Value]]) -> list[tuple[str, dict[str, str]]]:
    """The settings and sets that rows are of, with a name for files: a chart each."""
    pairs = dict.fromkeys((str(row["setting"]), str(row["set"])) for row in rows)
    return [
        (re.sub(r"\W+", "_", f"{setting} {name}".lower()), {"setting": setting, "set": name}) for setting, name in pairs
    ]


def _holds(family: str, families: list[str]) -> bool:
    return family in families


def _of(rows: pd.DataFrame, agent: str, setting: Setting, visibility: str) -> pd.DataFrame:
    same = (rows["configuration"] == agent) & (rows["setting"] == setting) & (rows["visibility"] == visibility)
    return rows[same]


def _groups(rows: pd.DataFrame) -> list[tuple[str, Setting, str]]:
    """Configuration, setting and set of each group that has rows, in order."""
    there = set(zip(rows["configuration"], rows["setting"], rows["visibility"], strict=True))
    return [
        (agent, setting, visibility)
        for agent in sorted({agent for agent, _, _ in there})
        for setting in SETTINGS
        for visibility in VISIBILITIES
        if (agent, setting, visibility) in there
    ]


_SUBMISSIONS = """
    SELECT c.configuration, c.setting, c.visibility, c.case_id, c.scene_id, p.trial_id, p.call, p.parseable, p.families,
           p.feedback, p.failed, p.errors
    FROM chosen AS c JOIN python_submissions AS p USING (trial_id) WHERE p.recorded
    ORDER BY c.configuration, c.case_id, c.repeat, p.call"""
_TRIALS = "SELECT * FROM chosen ORDER BY configuration, case_id, repeat"
_TAKES = frozenset({"agents"})
TOOL_USAGE = StudyDefinition(
    name="tool-usage",
    title="Tool calls",
    section="tab:actual-tool-usage, fig:joint-trajectory-2",
    sources={
        "trials": _TRIALS,
        "attempts": """
            SELECT c.configuration, c.setting, c.visibility, c.case_id, a.trial_id, a.tool_calls, a.polling_calls,
                   a.python_calls, a.failed_calls, a.named_transform_calls
            FROM chosen AS c JOIN attempts AS a USING (trial_id) WHERE a.recorded
            ORDER BY c.configuration, c.case_id, c.repeat""",
    },
    compute=tool_usage,
    takes=_TAKES,
    across=BOTH_PANELS,
)
PYTHON_OPERATIONS = StudyDefinition(
    name="python-operations",
    title="Operations inside Python",
    section="app:trajectory-repair-profiles, fig:joint-trajectory-2",
    sources={"trials": _TRIALS, "submissions": _SUBMISSIONS},
    compute=python_operations,
    takes=_TAKES,
    across=BOTH_PANELS,
)
EXECUTION_ERRORS = StudyDefinition(
    name="execution-errors",
    title="Errors in Python submissions",
    section="app:trajectory-python-feedback",
    sources={"trials": _TRIALS, "submissions": _SUBMISSIONS},
    compute=execution_errors,
    takes=_TAKES,
    across=BOTH_PANELS,
)
