"""Spatial errors where everything is there: mismatches of spatial requirements whose entities all pass a separate
existence check (paper, app:conditional-spatial-analysis, fig:analysis-diagnostics a; SA03-SA05, SA48)."""

from __future__ import annotations

import numpy as np

from c4s.errors import BadInput
from c4s.records.analysis import Chart, Column, Findings, Table, Value
from warehouse.analyses.cases import CONSTRUCTIONS
from warehouse.analyses.panels import coverage_gate
from warehouse.analyses.rates import DIAGNOSTICS_SEED, TrialRates
from warehouse.analyses.study import RESAMPLING, Frames, StudyDefinition, StudyOptions

_OF = ("mismatched", "kept", "mismatch rate")


def compute(frames: Frames, options: StudyOptions) -> Findings:
    """Rates by kind of requirement and by configuration, over the ranked configurations or those that are named."""
    gate = coverage_gate(frames["trials"], options, CONSTRUCTIONS)
    rows = gate.passed(frames["decisions"])
    rows = rows[rows["configuration"].isin(options.agents) if options.agents else rows["ranked"]].reset_index(drop=True)
    if rows.empty:
        raise BadInput("no spatial requirement of such configurations was decided")
    rates = TrialRates.of(rows, options)
    kept, wrong = rows["kept"].to_numpy(dtype=bool), (rows["answer"] == "MISMATCH").to_numpy()
    answers = rows["answer"].to_numpy()
    kinds = [_row(rates, "all", kept, wrong, answers, len(rows))]
    for kind in sorted(set(rows["predicate_type"])):
        inside = (rows["predicate_type"] == kind).to_numpy()
        kinds.append(_row(rates, kind.lower().replace("_", " "), kept & inside, wrong, answers, int(inside.sum())))
    agents = []
    for agent in sorted(set(rows["configuration"])):
        own = (rows["configuration"] == agent).to_numpy()
        agents.append(_row(rates, agent, kept & own, wrong, answers, int(own.sum())))
    honest = rates.intervals.honest
    return Findings(
        tables=[
            _table("kinds", "By kind of requirement", kinds, rates),
            _table("configurations", "By configuration", agents, rates),
            *gate.apart,
        ],
        charts=[
            Chart(
                name="kinds",
                title="Spatial requirements that do not hold although everything is there"
                + (f", with {options.level:.0%} intervals" if honest else ""),
                kind="dots",
                table="kinds",
                x="share",
                y="of_what",
                low="share_low" if honest else None,
                high="share_high" if honest else None,
            )
        ],
        intervals=[rates.intervals],
        notes=[
            f"{len(rows)} spatial requirements in {rows['trial_id'].nunique()} scenes with a finished Detailed "
            "record; the "
            f"existence checks keep {int(kept.sum())}.",
            "That a collection is present proves neither its number nor which members it has. Answers are "
            "direct, before "
            "caps by parents. What the judge left open is kept and is no mismatch.",
        ],
    )


def _row(rates: TrialRates, name: str, kept: object, wrong: object, answers: object, asked: int) -> dict[str, Value]:
    inside, told = np.asarray(kept, dtype=bool), np.asarray(answers)
    return {
        "of_what": name,
        "asked": asked,
        **rates.rate(wrong, inside),
        "open": int((inside & ~np.isin(told, ["MATCH", "MISMATCH"])).sum()),
    }


def _table(name: str, title: str, rows: list[dict[str, Value]], rates: TrialRates) -> Table:
    return Table(
        name=name,
        title=title,
        columns=[
            Column(name="of_what", title="requirements"),
            Column(name="asked", title="asked"),
            *rates.columns(*_OF),
            Column(name="open", title="left open"),
        ],
        rows=rows,
    )


CONDITIONAL_SPATIAL = StudyDefinition(
    name="conditional-spatial",
    title="Spatial errors where everything is there",
    section="app:conditional-spatial-analysis, fig:analysis-diagnostics",
    sources={
        "trials": "SELECT * FROM chosen ORDER BY configuration, case_id, repeat",
        "decisions": "SELECT d.* FROM spatial_decisions AS d JOIN chosen USING (trial_id) "
        "ORDER BY d.configuration, d.case_id, d.repeat, d.node_id",
    },
    compute=compute,
    takes=RESAMPLING | {"agents"},
    defaults={"seed": DIAGNOSTICS_SEED},
)
