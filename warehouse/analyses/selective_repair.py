"""Selective repair: complete recoveries, and what else was changed in them (paper, "Final repair outcomes",
app:trajectory-repair-outcomes, tab:repair-robustness, fig:selective-repair-by-model; SA08-SA18, SA49, SA50).

What saving alone explains, a runtime material with another number, is left out here and nowhere else.
"""

from __future__ import annotations

import itertools

import numpy as np
import pandas as pd

from c4s.errors import BadInput
from c4s.protocol.settings import SETTING_TITLES
from c4s.records.analysis import Chart, Column, Findings, Table, Value
from warehouse.analyses.cases import REPAIRS, VISIBILITIES
from warehouse.analyses.panels import coverage_gate
from warehouse.analyses.rates import DIAGNOSTICS_SEED, TrialRates
from warehouse.analyses.study import BOTH_PANELS, RESAMPLING, Frames, StudyDefinition, StudyOptions

_KINDS = {
    "added": "Added actors without a target match",
    "modified": "Modified non-target actors",
    "deleted": "Deleted non-target actors",
    "repurposed": "Non-target actors repurposed for a repair",
    "target": "Unrecovered target state",
}
_PROFILES = (
    ("strict", "Strict (half the tolerances)", "complete_strict", "fp_strict"),
    ("default", "Default", "complete", "fp_kept"),
    ("relaxed", "Relaxed (twice the tolerances)", "complete_relaxed", "fp_relaxed"),
    ("confined", "Default; without changes confined to assets and materials", "complete", "fp_not_confined"),
)
_SHARE = ("with false positives", "complete recoveries", "share")


def compute(frames: Frames, options: StudyOptions) -> Findings:
    """Every table of the paper's repair diagnostics over the ranked configurations, or those that are named."""
    gate = coverage_gate(frames["trials"], options, REPAIRS)
    outcomes = gate.passed(frames["outcomes"])
    outcomes = outcomes[outcomes["configuration"].isin(options.agents) if options.agents else outcomes["ranked"]]
    if outcomes.empty:
        raise BadInput("no resolved repair of such configurations is there")
    outcomes = outcomes.reset_index(drop=True)
    changes = frames["changes"][~frames["changes"]["renamed_material"].astype(bool)]
    rates = TrialRates.of(outcomes, options)
    by_agent = _by_configuration(outcomes)
    sensitivity = _sensitivity(outcomes, rates)
    return Findings(
        tables=[
            by_agent,
            _domains(outcomes, rates),
            _kinds(outcomes, changes),
            sensitivity,
            _amounts(outcomes),
            *gate.apart,
        ],
        charts=[
            Chart(
                name="outcomes",
                title="Outcomes of repairs, by what else they change",
                kind="stacks",
                table="configurations",
                x="cases",
                y="configuration",
                group="domain",
                series=["clean", "spoilt", "incomplete"],
            ),
            Chart(
                name="tolerances",
                title="Complete recoveries with false positives, by tolerance",
                kind="dots",
                table="tolerances",
                x="share",
                y="setting",
                low="share_low" if rates.intervals.honest else None,
                high="share_high" if rates.intervals.honest else None,
            ),
        ],
        intervals=[rates.intervals],
        notes=[
            "All scheduled cases of complete configurations count; one without a valid submission recovers nothing.",
            f"{int((outcomes['fp'] - outcomes['fp_kept']).sum())} false positives that saving alone explains are left "
            "out here; official scores keep them.",
            _guard(outcomes, changes),
        ],
    )


def _by_configuration(outcomes: pd.DataFrame) -> Table:
    """Complete with and without false positives, and the rest: what the figure stacks (SA18, SA50)."""
    rows: list[dict[str, Value]] = []
    for agent in outcomes["configuration"].unique():
        for setting in REPAIRS:
            own = outcomes[(outcomes["configuration"] == agent) & (outcomes["setting"] == setting)]
            clean = own["complete"] & (own["fp_kept"] == 0) & (own["tp"] > 0)
            rows.append(
                {
                    "configuration": str(agent),
                    "domain": SETTING_TITLES[setting],
                    "clean": int(clean.sum()),
                    "spoilt": int((own["complete"] & ~clean).sum()),
                    "incomplete": int((~own["complete"]).sum()),
                    "cases": len(own),
                }
            )
    return Table(
        name="configurations",
        title="Outcomes by configuration",
        columns=[
            Column(name="configuration", title="configuration"),
            Column(name="domain", title="domain"),
            Column(name="clean", title="complete, nothing else changed"),
            Column(name="spoilt", title="complete, with false positives"),
            Column(name="incomplete", title="not complete"),
            Column(name="cases", title="cases"),
        ],
        rows=rows,
    )


def _domains(outcomes: pd.DataFrame, rates: TrialRates) -> Table:
    """Complete recoveries with false positives by domain and set, and over all (SA09, SA14)."""
    spoilt = (outcomes["fp_kept"] > 0).to_numpy()
    complete = outcomes["complete"].to_numpy(dtype=bool)
    rows: list[dict[str, Value]] = [{"domain": "all", "set": "all", **rates.rate(spoilt, complete)}]
    for setting, visibility in itertools.product(REPAIRS, VISIBILITIES):
        inside = complete & ((outcomes["setting"] == setting) & (outcomes["visibility"] == visibility)).to_numpy()
        if inside.any():
            rows.append(
                {
                    "domain": SETTING_TITLES[setting],
                    "set": visibility,
                    "count": int((spoilt & inside).sum()),
                    "of": int(inside.sum()),
                    "share": float((spoilt & inside).sum() / inside.sum()),
                }
            )
    return Table(
        name="domains",
        title="Complete recoveries with false positives",
        columns=[Column(name="domain", title="domain"), Column(name="set", title="set"), *rates.columns(*_SHARE)],
        rows=rows,
    )


def _kinds(outcomes: pd.DataFrame, changes: pd.DataFrame) -> Table:
    """Complete recoveries that hold each kind of unintended change; kinds overlap (SA10)."""
    complete = outcomes[outcomes["complete"]]
    rows: list[dict[str, Value]] = []
    for kind, title in _KINDS.items():
        found = changes[(changes["kind"] == kind) & changes["trial_id"].isin(complete["trial_id"])]
        held = complete[complete["trial_id"].isin(found["trial_id"])]
        rows.append(
            {
                "kind": title,
                "submissions": len(held),
                "of": len(complete),
                "actors": len(found),
                "tasks": int(held["case_id"].nunique()),
                "scenes": int(held["scene_id"].nunique()),
            }
        )
    return Table(
        name="kinds",
        title="Kinds of unintended changes in complete recoveries; they overlap",
        columns=[
            Column(name="kind", title="kind"),
            Column(name="submissions", title="submissions"),
            Column(name="of", title="of"),
            Column(name="actors", title="actors"),
            Column(name="tasks", title="tasks"),
            Column(name="scenes", title="source scenes"),
        ],
        rows=rows,
    )


def _sensitivity(outcomes: pd.DataFrame, rates: TrialRates) -> Table:
    """The share under halved and doubled tolerances, and without changes of assets and materials (SA12, SA13)."""
    return Table(
        name="tolerances",
        title="By tolerance of the targets",
        columns=[Column(name="setting", title="setting"), *rates.columns(*_SHARE)],
        rows=[
            {"setting": title, **rates.rate((outcomes[fp] > 0).to_numpy(), outcomes[complete].to_numpy(dtype=bool))}
            for _, title, complete, fp in _PROFILES
        ],
    )


def _amounts(outcomes: pd.DataFrame) -> Table:
    """How many false positives the affected submissions hold, and over how many tasks they spread (SA11, SA49)."""
    affected = outcomes[outcomes["complete"] & (outcomes["fp_kept"] > 0)]
    row: dict[str, Value] = {
        "submissions": len(affected),
        "tasks": int(affected["case_id"].nunique()),
        "scenes": int(affected["scene_id"].nunique()),
    }
    if len(affected):
        counts = affected["fp_kept"].to_numpy(dtype=np.float64)
        low, middle, high = np.percentile(counts, [25, 50, 75])
        row |= {"median": float(middle), "low": float(low), "high": float(high), "most": int(counts.max())}
    return Table(
        name="amounts",
        title="False positives of complete recoveries that have any",
        columns=[
            Column(name="submissions", title="submissions"),
            Column(name="tasks", title="tasks"),
            Column(name="scenes", title="source scenes"),
            Column(name="median", title="median", decimals=1),
            Column(name="low", title="first quartile", decimals=1),
            Column(name="high", title="third quartile", decimals=1),
            Column(name="most", title="most"),
        ],
        rows=[row],
    )


def _guard(outcomes: pd.DataFrame, changes: pd.DataFrame) -> str:
    """Whether a change of a non-target is no change at all: within the comparison's own tolerances (SA16)."""
    complete = set(outcomes.loc[outcomes["complete"], "trial_id"])
    within = changes[(changes["kind"] == "modified") & changes["trial_id"].isin(complete)]
    idle = sum(not len(fields) for fields in within["fields"])
    return f"{idle} of {len(within)} modified non-targets in complete recoveries differ only within the tolerances."


SELECTIVE_REPAIR = StudyDefinition(
    name="selective-repair",
    title="Selective repair: recovery and preservation",
    section="app:trajectory-repair-outcomes, tab:repair-robustness, fig:selective-repair-by-model",
    sources={
        "trials": "SELECT * FROM chosen ORDER BY configuration, case_id, repeat",
        "outcomes": "SELECT r.* FROM repair_outcomes AS r JOIN chosen USING (trial_id) "
        "ORDER BY r.configuration, r.case_id, r.repeat",
        "changes": "SELECT r.* FROM repair_changes AS r JOIN chosen USING (trial_id) "
        "ORDER BY r.configuration, r.case_id, r.repeat, r.actor, r.kind",
    },
    compute=compute,
    takes=RESAMPLING | {"agents"},
    across=BOTH_PANELS,
    defaults={"seed": DIAGNOSTICS_SEED},
)
