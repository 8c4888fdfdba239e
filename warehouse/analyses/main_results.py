"""Main results: component scores, both settings and the model score, with intervals and ranks (paper, "Main results",
tab:main-results; SA01, SA02, SA28-SA30)."""

from __future__ import annotations

import numpy as np

from c4s.protocol.case import SEMANTIC
from c4s.records.analysis import Chart, Column, Findings, Table, Value
from c4s.stats.bootstrap import Floats, domain_means, percentile_interval
from c4s.stats.orders import spearman
from c4s.stats.ranks import competition_ranks, rank_interval
from warehouse.analyses.cases import CONSTRUCTIONS, REPAIRS, CaseTable, case_table, intervals_of, number
from warehouse.analyses.study import RESAMPLING, Frames, StudyDefinition, StudyOptions

_COLUMNS = (
    ("semantic", "Semantic", "semantic", CONSTRUCTIONS),
    ("physical_t2s", "Physical (T2S)", "physical", CONSTRUCTIONS),
    ("s_t2s", "S_T2S", "score", CONSTRUCTIONS),
    ("repair_f1", "Repair F1", "repair_f1", REPAIRS),
    ("physical_i2s", "Physical (I2S)", "physical", REPAIRS),
    ("s_i2s", "S_I2S", "score", REPAIRS),
)
"""Name, title, column of the rows, and settings of each score column."""
MODEL = "s_model"


def compute(frames: Frames, options: StudyOptions) -> Findings:
    """The main table of the complete configurations."""
    table = case_table(frames["trials"], options)
    intervals = intervals_of(table.design, options)
    observed = _scores(table, table.design.observed())
    drawn = _scores(table, table.design.draw(options.draws, options.seed)) if intervals.honest else {}
    rows: list[dict[str, Value]] = [
        {"configuration": agent, "ranked": ranked} for agent, ranked in zip(table.agents, table.ranked, strict=True)
    ]
    for name, scores in observed.items():
        ends = percentile_interval(drawn[name], options.level) if drawn else None
        for place, row in enumerate(rows):
            row[name] = number(scores[0, place])
            if ends is not None:
                row[f"{name}_low"], row[f"{name}_high"] = float(ends[0][place]), float(ends[1][place])
    _rank(table, rows, observed, drawn, options)
    notes = (
        []
        if MODEL in observed
        else ["A model score needs cases of both tracks, and a repair score cases of both domains."]
    )
    notes += _association(observed)
    rows.sort(
        key=lambda row: (
            -_number(row, MODEL),
            -_number(row, "s_t2s"),
            -_number(row, "s_i2s"),
            str(row["configuration"]),
        )
    )
    shown = [name for name in (*(column[0] for column in _COLUMNS), MODEL) if name in observed]
    titles = {name: title for name, title, *_ in _COLUMNS} | {MODEL: "S_model"}
    main = Table(
        name="main",
        title="Main results",
        columns=[
            Column(name="rank", title="rank"),
            *(
                [Column(name="rank_low", title="best rank"), Column(name="rank_high", title="worst rank")]
                if drawn
                else []
            ),
            Column(name="configuration", title="configuration"),
            *(column for name in shown for column in _score_columns(name, titles[name], bool(drawn))),
        ],
        rows=rows,
    )
    charts = [
        Chart(
            name="scores",
            title=f"{titles[axis]} of each configuration" + (f", with {options.level:.0%} intervals" if drawn else ""),
            kind="dots",
            table="main",
            x=axis,
            y="configuration",
            low=f"{axis}_low" if drawn else None,
            high=f"{axis}_high" if drawn else None,
        )
        for axis in shown[-1:]
    ]
    return Findings(tables=[main, table.apart], charts=charts, intervals=[intervals], notes=notes)


def _scores(table: CaseTable, counts: Floats) -> dict[str, Floats]:
    """Each score column in each draw, shape (draws, configurations)."""
    columns = list(dict.fromkeys(column for _, _, column, _ in _COLUMNS))
    values = np.concatenate([table.values(column) for column in columns], axis=1)
    means = domain_means(table.design, counts, values).reshape(len(counts), len(table.design.domains), len(columns), -1)
    scores: dict[str, Floats] = {}
    for name, _, column, settings in _COLUMNS:
        found = table.scores_of(means[:, :, columns.index(column)], settings)
        if found is not None:
            scores[name] = found
    if "s_t2s" in scores and "s_i2s" in scores:
        scores[MODEL] = 0.5 * scores["s_t2s"] + 0.5 * scores["s_i2s"]
    return scores


def _rank(
    table: CaseTable,
    rows: list[dict[str, Value]],
    observed: dict[str, Floats],
    drawn: dict[str, Floats],
    options: StudyOptions,
) -> None:
    """Ranks by the model score among configurations that are ranked."""
    places = [place for place, ranked in enumerate(table.ranked) if ranked]
    for row in rows:
        row["rank"] = None
    if MODEL not in observed or not places:
        return
    for place, rank in zip(places, competition_ranks(observed[MODEL][0, places]).tolist(), strict=True):
        rows[place]["rank"] = rank
    if drawn:
        low, high = rank_interval(drawn[MODEL][:, places], options.level)
        for place, least, most in zip(places, low.tolist(), high.tolist(), strict=True):
            rows[place] |= {"rank_low": least, "rank_high": most}


def _association(observed: dict[str, Floats]) -> list[str]:
    """Spearman's rank correlation of the two setting scores (SA02)."""
    if MODEL not in observed or observed[MODEL].shape[1] < 3:
        return []
    rho = spearman(observed["s_t2s"][0], observed["s_i2s"][0])
    if rho is None:
        return []
    return [f"Spearman's rho of S_T2S and S_I2S over {observed[MODEL].shape[1]} configurations: {rho:.2f}."]


def _score_columns(name: str, title: str, with_ends: bool) -> list[Column]:
    columns = [Column(name=name, title=title, unit="score", decimals=3, marks="high")]
    if with_ends:
        columns += [
            Column(name=f"{name}_{end}", title=f"{title} {end}", unit="score", decimals=3) for end in ("low", "high")
        ]
    return columns


def _number(row: dict[str, Value], name: str) -> float:
    value = row.get(name)
    return float(value) if isinstance(value, int | float) else -1.0


MAIN_RESULTS = StudyDefinition(
    name="main-results",
    title="Main results",
    section="sec:main-results, tab:main-results",
    sources={
        "trials": f"""
            SELECT c.* EXCLUDE (physics), c.physics AS physical, s.value AS semantic FROM chosen AS c
            LEFT JOIN (SELECT trial_id, value FROM components WHERE verifier = '{SEMANTIC}' AND name = 'score') AS s
            USING (trial_id) ORDER BY c.configuration, c.case_id, c.repeat"""
    },
    compute=compute,
    takes=RESAMPLING | {"agents"},
)
