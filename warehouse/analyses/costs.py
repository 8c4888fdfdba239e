"""Estimated cost of a case at list rates, by class of tokens with its coverage, and which configurations no other beats
in score and cost (paper, app:cost-estimate and fig:teaser; SA38, SA39, SA40).

The recorded run of each trial is priced, discarded attempts are not: an estimate of use, no bill. A setting's mean
covers the cases whose requests are all priced; settings are joined with their shares of the planned cases. Unknown use
is left out and told, never taken for 0.
"""

from __future__ import annotations

from typing import Final

import numpy as np
import pandas as pd

from c4s.errors import BadInput
from c4s.meter.prices import COST_CLASSES
from c4s.protocol.settings import SETTING_TITLES, SETTINGS
from c4s.records.analysis import Chart, Column, Findings, Table, Value
from c4s.stats.orders import frontier
from warehouse.analyses.panels import SetPanel, apart_of, panels, set_scores
from warehouse.analyses.study import BOTH_PANELS, Frames, StudyDefinition, StudyOptions

_TITLES: Final = {
    "fresh_input": "fresh input",
    "cache_read": "cache reads",
    "cache_write": "cache writes",
    "output": "output",
}
_USD: Final = [f"{name}_usd" for name in COST_CLASSES]


def compute(frames: Frames, options: StudyOptions) -> Findings:
    """A row a configuration and set."""
    found = panels(frames["trials"], options)
    tables, charts, priced = [], [], False
    for panel in found:
        rows = _rows(panel)
        if any(row["usd_per_case"] is not None for row in rows):
            priced = True
            charts.append(_chart(panel.name, "model" if rows[0]["s_model"] is not None else "score"))
        tables.append(_table(panel, rows))
    if not priced:
        raise BadInput(
            "no recorded run of a complete configuration is priced",
            todo="its model needs a row in C4S_HOME/prices.yaml; then `c4s report --from-runs`",
        )
    notes = [
        "List rates of the day of each request, standard tier, without discounts and charges that are not for tokens. "
        "The cache was used as it was. Where a case's use is not known, the mean is over the others.",
        "Tokens alone do not tell costs apart: clients count differently, and the scenes differ in quality.",
    ]
    return Findings(tables=[*tables, *apart_of(found)], charts=charts, notes=notes)


def _rows(panel: SetPanel) -> list[dict[str, Value]]:
    cases = panel.cases
    scores = set_scores(cases.settings, cases.values("score"))
    sizes = pd.Series(cases.settings).value_counts()
    rows: list[dict[str, Value]] = []
    for place, agent in enumerate(cases.agents):
        own = cases.rows[cases.rows["configuration"] == agent]
        rows.append(
            {
                "configuration": agent,
                "s_model": float(scores["model"][place]) if "model" in scores else None,
                "score": float(cases.values("score")[:, place].mean()),
                **_cost(own, sizes),
            }
        )
    axis = "s_model" if "model" in scores else "score"
    ranked = np.array(cases.ranked)
    usd = np.array([np.nan if row["usd_per_case"] is None else float(row["usd_per_case"]) for row in rows])
    best = frontier(np.array([float(row[axis] or 0) for row in rows]), np.where(ranked, usd, np.nan))
    for place, row in enumerate(rows):
        row["frontier"] = "frontier" if place in best else "beaten" if np.isfinite(usd[place]) else "unpriced"
    return rows


def _cost(trials: pd.DataFrame, sizes: pd.Series) -> dict[str, Value]:
    """A configuration's cost of a case: means of the settings by their shares of the cases. None where one has none."""
    costs = trials[_USD].astype(float)
    known = costs.notna().all(axis=1)
    by_case = costs[known].groupby([trials.loc[known, "setting"], trials.loc[known, "case_id"]]).mean()
    means = by_case.groupby("setting").mean().reindex(sizes.index)
    parts = means.mul(sizes / sizes.sum(), axis=0).sum(skipna=False)
    covered = by_case.groupby("setting").size().reindex(sizes.index, fill_value=0)
    usd = means.sum(axis=1, skipna=False)
    row: dict[str, Value] = {
        "usd_per_case": _none(float(parts.sum(skipna=False))),
        **{f"{name}_usd": _none(float(parts[f"{name}_usd"])) for name in COST_CLASSES},
        "covered": int(covered.sum()),
        "of_cases": int(sizes.sum()),
    }
    for setting in SETTINGS:
        if setting in sizes.index:
            row |= {f"usd {setting}": _none(float(usd[setting])), f"covered {setting}": int(covered[setting])}
    return row


def _none(value: float) -> float | None:
    return None if np.isnan(value) else value


def _table(panel: SetPanel, rows: list[dict[str, Value]]) -> Table:
    settings = [setting for setting in SETTINGS if setting in panel.cases.settings]
    return Table(
        name=f"costs_{panel.name}",
        title=f"Estimated cost of a case ({panel.name} set)",
        columns=[
            Column(name="configuration", title="configuration"),
            Column(name="s_model", title="S_model", unit="score", decimals=3, marks="high"),
            Column(name="score", title="mean case score", unit="score", decimals=3),
            Column(name="usd_per_case", title="cost of a case", unit="USD", decimals=3, marks="low"),
            *(Column(name=f"{name}_usd", title=_TITLES[name], unit="USD", decimals=3) for name in COST_CLASSES),
            Column(name="covered", title="cases priced", unit="cases"),
            Column(name="of_cases", title="of", unit="cases"),
            *(
                column
                for setting in settings
                for column in (
                    Column(name=f"usd {setting}", title=SETTING_TITLES[setting], unit="USD", decimals=3),
                    Column(name=f"covered {setting}", title="priced", unit="cases"),
                )
            ),
            Column(name="frontier", title="on the frontier"),
        ],
        rows=rows,
    )


def _chart(name: str, axis: str) -> Chart:
    return Chart(
        name=f"frontier_{name}",
        title=f"Score against estimated cost of a case ({name} set)",
        kind="scatter",
        table=f"costs_{name}",
        x="usd_per_case",
        y="s_model" if axis == "model" else "score",
        group="frontier",
        label="configuration",
        log_x=True,
    )


COSTS = StudyDefinition(
    name="costs",
    title="Estimated cost of a case, and the frontier of score and cost",
    section="app:cost-estimate, fig:teaser",
    sources={
        "trials": f"""
            SELECT c.*, {", ".join(f"a.{name}" for name in _USD)}, a.requests, a.unpriced_requests
            FROM chosen AS c LEFT JOIN (SELECT * FROM attempts WHERE recorded) AS a USING (trial_id)
            ORDER BY c.configuration, c.case_id, c.repeat"""
    },
    compute=compute,
    takes=frozenset({"agents"}),
    across=BOTH_PANELS,
)
