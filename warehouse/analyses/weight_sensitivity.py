"""Repair-weight sensitivity: the order of configurations by eight weights of Repair F1 against the adopted one (paper,
app:i2s-weight-sensitivity, tab:i2s-weight-sensitivity; SA37).

The parts are means over the repair cases of a set, each case equal; scenes, limits and cases stay as they are.
"""

from __future__ import annotations

from typing import Final

from c4s.errors import BadInput
from c4s.protocol.rules import I2S_WEIGHTS
from c4s.records.analysis import Chart, Column, Findings, Table, Value
from c4s.stats.orders import WeightEffect, average_ranks, weight_effects
from warehouse.analyses.cases import REPAIRS, CaseTable
from warehouse.analyses.panels import apart_of, panels, ranked_places
from warehouse.analyses.study import BOTH_PANELS, Frames, StudyDefinition, StudyOptions

WEIGHTS: Final = (0.0, 0.25, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0)
"""Of Repair F1; physical safety has the rest."""


def compute(frames: Frames, options: StudyOptions) -> Findings:
    """A row a weight and set."""
    repairs = frames["trials"][frames["trials"]["setting"].isin(REPAIRS)]
    if repairs.empty:
        raise BadInput("this suite has no repair case", todo="c4s analyze main-results")
    found = panels(repairs, options)
    tables, charts = [], []
    for panel in found:
        effects = _effects(panel.cases)
        name = f"scores_{panel.name}"
        tables += [
            _effects_table(panel.name, panel.cases, effects),
            _scores_table(name, panel.name, panel.cases, effects),
        ]
        charts.append(
            Chart(
                name=f"weights_{panel.name}",
                title=f"Image-to-scene score by the weight of Repair F1 ({panel.name} set)",
                kind="lines",
                table=name,
                x="weight",
                y="score",
                group="configuration",
                reference=I2S_WEIGHTS["repair_f1"],
            )
        )
    notes = ["It tells how much the order hangs on the weight over fixed cases, not which weight is right."]
    return Findings(tables=[*tables, *apart_of(found)], charts=charts, notes=notes)


def _effects(cases: CaseTable) -> list[WeightEffect]:
    ranked = ranked_places(cases)
    f1, physical = (cases.values(column).mean(axis=0)[ranked] for column in ("repair_f1", "physical"))
    return weight_effects(f1, physical, WEIGHTS, I2S_WEIGHTS["repair_f1"])


def _effects_table(name: str, cases: CaseTable, effects: list[WeightEffect]) -> Table:
    agents = _agents(cases)
    rows: list[dict[str, Value]] = [
        {
            "weight": effect.weight,
            "spearman": effect.spearman,
            "tau_b": effect.tau_b,
            "largest_shift": effect.largest_shift,
            "leader": ", ".join(agents[place] for place in effect.leaders),
        }
        for effect in effects
    ]
    return Table(
        name=f"sensitivity_{name}",
        title=f"Order by other weights of Repair F1 ({name} set, {len(agents)} configurations, "
        f"{len(cases.cases)} repairs)",
        columns=[
            Column(name="weight", title="weight of Repair F1", decimals=2),
            Column(name="spearman", title="Spearman's rho", decimals=3),
            Column(name="tau_b", title="Kendall's tau-b", decimals=3),
            Column(name="largest_shift", title="largest rank shift", unit="ranks", decimals=1),
            Column(name="leader", title="leader"),
        ],
        rows=rows,
    )


def _scores_table(name: str, shown: str, cases: CaseTable, effects: list[WeightEffect]) -> Table:
    rows: list[dict[str, Value]] = []
    for effect in effects:
        ranks = average_ranks(effect.scores)
        rows += [
            {"weight": effect.weight, "configuration": agent, "score": float(score), "rank": float(rank)}
            for agent, score, rank in zip(_agents(cases), effect.scores, ranks, strict=True)
        ]
    return Table(
        name=name,
        title=f"Image-to-scene scores by weight ({shown} set)",
        columns=[
            Column(name="weight", title="weight of Repair F1", decimals=2),
            Column(name="configuration", title="configuration"),
            Column(name="score", title="score", unit="score", decimals=3),
            Column(name="rank", title="rank", decimals=1),
        ],
        rows=rows,
    )


def _agents(cases: CaseTable) -> list[str]:
    return [cases.agents[place] for place in ranked_places(cases)]


WEIGHT_SENSITIVITY = StudyDefinition(
    name="weight-sensitivity",
    title="Sensitivity of the repair order to the weight of Repair F1",
    section="app:i2s-weight-sensitivity, tab:i2s-weight-sensitivity",
    sources={
        "trials": "SELECT * EXCLUDE (physics), physics AS physical FROM chosen ORDER BY configuration, case_id, repeat"
    },
    compute=compute,
    takes=frozenset({"agents"}),
    across=BOTH_PANELS,
)
