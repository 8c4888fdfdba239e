"""Scores by authored difficulty: easy, medium and hard cases of both sides (paper, app:difficulty-results,
tab:difficulty-results; SA19).

Cases weigh the same within a tier, public and private ones together; the tiers are descriptive.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

import numpy as np

from c4s.errors import BadInput
from c4s.protocol.settings import SETTING_TITLES
from c4s.records.analysis import Chart, Column, Findings, Table, Value
from c4s.stats.bootstrap import Floats
from warehouse.analyses.cases import CONSTRUCTIONS, REPAIRS, CaseTable, case_table
from warehouse.analyses.panels import set_scores
from warehouse.analyses.study import BOTH_PANELS, Frames, StudyDefinition, StudyOptions

TIERS: Final = ("easy", "medium", "hard")
_SIDES = (("t2s", "T2S", CONSTRUCTIONS), ("i2s", "I2S", REPAIRS))
MODEL = "s_model"


def compute(frames: Frames, options: StudyOptions) -> Findings:
    """A row a configuration, a column a side and tier."""
    trials = frames["trials"]
    labelled = trials[trials["difficulty"].isin(TIERS)]
    if labelled.empty:
        raise BadInput("no case of this suite has a difficulty", todo="c4s analyze main-results")
    table = case_table(trials, options)
    scores = table.values("score")
    tier_of = labelled.drop_duplicates("case_id").set_index("case_id")["difficulty"].reindex(table.cases).to_numpy()
    columns = dict(_tiers(table, tier_of, scores))
    model = set_scores(table.settings, scores).get("model")
    rows: list[dict[str, Value]] = [
        {
            "configuration": agent,
            **{name: float(values[place]) for name, (_, values) in columns.items()},
            MODEL: None if model is None else float(model[place]),
        }
        for place, agent in enumerate(table.agents)
    ]
    rows.sort(key=lambda row: (-float(row[MODEL] or 0), str(row["configuration"])))
    main = Table(
        name="tiers",
        title=f"Scores by difficulty ({len(table.cases)} cases)",
        columns=[
            Column(name="configuration", title="configuration"),
            *(
                Column(name=name, title=title, unit="score", decimals=3, marks="high")
                for name, (title, _) in columns.items()
            ),
            Column(name=MODEL, title="S_model", unit="score", decimals=3, marks="high"),
        ],
        rows=rows,
    )
    ranked = np.array(table.ranked)
    chart = Chart(
        name="difficulty",
        title="Score by difficulty",
        kind="heat",
        table="tiers",
        y="configuration",
        series=list(columns),
    )
    unlabelled = int((~np.isin(tier_of.astype(str), TIERS)).sum())
    notes = ["Tiers are descriptive: single configurations can turn their order round."]
    if unlabelled:
        notes.append(f"{unlabelled} cases without a difficulty are in S_model only.")
    tables = [main, _means(columns, ranked), _counts(table, tier_of), *([table.apart] if table.apart.rows else [])]
    return Findings(tables=tables, charts=[chart], notes=notes)


def _tiers(table: CaseTable, tier_of: np.ndarray, scores: Floats) -> Iterator[tuple[str, tuple[str, Floats]]]:
    """Name, title and each configuration's mean of every side and tier that has cases."""
    of = np.array(table.settings)
    for short, side, settings in _SIDES:
        for tier in TIERS:
            own = np.isin(of, settings) & (tier_of == tier)
            if own.any():
                yield f"{short}_{tier}", (f"{side} {tier}", scores[own].mean(axis=0))


def _means(columns: dict[str, tuple[str, Floats]], ranked: np.ndarray) -> Table:
    """Means of the tiers over the ranked configurations."""
    rows: list[dict[str, Value]] = [
        {"tier": title, "mean": float(values[ranked].mean()), "configurations": int(ranked.sum())}
        for title, values in columns.values()
        if ranked.any()
    ]
    return Table(
        name="means",
        title="Means of the ranked configurations",
        columns=[
            Column(name="tier", title="tier"),
            Column(name="mean", title="mean", unit="score", decimals=3),
            Column(name="configurations", title="configurations"),
        ],
        rows=rows,
    )


def _counts(table: CaseTable, tier_of: np.ndarray) -> Table:
    of = np.array(table.settings)
    rows: list[dict[str, Value]] = [
        {
            "setting": SETTING_TITLES[setting],
            **{tier: int(((of == setting) & (tier_of == tier)).sum()) for tier in TIERS},
            "cases": int((of == setting).sum()),
        }
        for setting in (*CONSTRUCTIONS, *REPAIRS)
        if (of == setting).any()
    ]
    return Table(
        name="counts",
        title="Cases by difficulty",
        columns=[
            Column(name="setting", title="setting"),
            *(Column(name=tier, title=tier) for tier in TIERS),
            Column(name="cases", title="cases"),
        ],
        rows=rows,
    )


DIFFICULTY = StudyDefinition(
    name="difficulty",
    title="Scores by difficulty",
    section="app:difficulty-results, tab:difficulty-results",
    sources={"trials": "SELECT * FROM chosen ORDER BY configuration, case_id, repeat"},
    compute=compute,
    takes=frozenset({"agents"}),
    across=BOTH_PANELS,
)
