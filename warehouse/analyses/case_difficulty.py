"""Which cases are hard, and which of them carry the ranking (ours; authored tiers as in tab:difficulty-results).

No item-response model is fitted: some fourteen configurations cannot tell its parameters from noise.
"""

from __future__ import annotations

import numpy as np

from c4s.errors import BadInput
from c4s.records.analysis import Chart, Column, Findings, Table, Value
from c4s.stats.difficulty import case_rest_correlations, turned_pairs
from warehouse.analyses.cases import case_table, number
from warehouse.analyses.parts import compared, score_means
from warehouse.analyses.study import Frames, StudyDefinition, StudyOptions


def compute(frames: Frames, options: StudyOptions) -> Findings:
    """Each case over the ranked configurations (all where fewer than two are), and the authored tiers."""
    table = case_table(frames["trials"], options)
    places = compared(table)
    if len(places) < 2:
        raise BadInput("one configuration tells no case from another", todo="run another agent on the same suite")
    values = table.values("score")[:, places]
    facts = table.rows.drop_duplicates("case_id").set_index("case_id").loc[table.cases]
    means = score_means(table)
    widest = means[-1]
    turned = turned_pairs(values, widest.case_shares)
    rows: list[dict[str, Value]] = []
    for mean in means:
        own = mean.case_shares > 0
        if mean.domains > 1:
            continue
        together = case_rest_correlations(values[own], mean.case_shares[own])
        for place, correlation in zip(np.nonzero(own)[0], together, strict=True):
            fact = facts.iloc[place]
            rows.append(
                {
                    "case": table.cases[place],
                    "set": str(fact["visibility"]),
                    "cases_of": mean.title,
                    "source": str(fact["scene_id"]),
                    "tier": str(fact["difficulty"]) if isinstance(fact["difficulty"], str) else None,
                    "difficulty": float(1 - values[place].mean()),
                    "spread": float(values[place].std(ddof=1)),
                    "case_rest": number(correlation),
                    "turned": int(turned[place]),
                    "solved": int((values[place] >= 1).sum()),
                    "failed": int((values[place] <= 0).sum()),
                }
            )
    rows.sort(key=lambda row: (-float(row["difficulty"] or 0), str(row["case"])))
    pairs = len(places) * (len(places) - 1) // 2
    return Findings(
        tables=[_cases(rows), _tiers(rows), table.apart],
        charts=[
            Chart(
                name="difficulty",
                title="Difficulty of cases, and how they go with the rest",
                kind="scatter",
                table="cases",
                x="difficulty",
                y="case_rest",
                group="cases_of",
            )
        ],
        notes=[
            f"Over {len(places)} configurations. Difficulty: 1 less the mean score. Case-rest: Pearson's correlation "
            "of a case's scores with the means of all other cases of its setting; below 0, better configurations do "
            f"worse. Turned: of {pairs} pairs by {widest.title.lower()}, those that change order without the case.",
            *([] if len(places) > 2 else ["A correlation takes three configurations."]),
        ],
    )


def _cases(rows: list[dict[str, Value]]) -> Table:
    return Table(
        name="cases",
        title="Cases, the hardest first",
        columns=[
            Column(name="case", title="case"),
            Column(name="set", title="set"),
            Column(name="cases_of", title="setting"),
            Column(name="source", title="source scene"),
            Column(name="tier", title="authored"),
            Column(name="difficulty", title="difficulty", decimals=3),
            Column(name="spread", title="SD over configurations", unit="score", decimals=3),
            Column(name="case_rest", title="case-rest correlation", decimals=3),
            Column(name="turned", title="pairs turned without it"),
            Column(name="solved", title="at 1"),
            Column(name="failed", title="at 0"),
        ],
        rows=rows,
    )


def _tiers(rows: list[dict[str, Value]]) -> Table:
    """Mean difficulty of each authored tier by setting, in the order in which cases are met."""
    made: list[dict[str, Value]] = []
    for setting, tier in sorted({(str(row["cases_of"]), str(row["tier"])) for row in rows if row["tier"]}):
        own = [row for row in rows if (row["cases_of"], row["tier"]) == (setting, tier)]
        known = [float(row["case_rest"]) for row in own if isinstance(row["case_rest"], float)]
        made.append(
            {
                "cases_of": setting,
                "tier": tier,
                "cases": len(own),
                "difficulty": float(np.mean([float(row["difficulty"] or 0) for row in own])),
                "case_rest": float(np.mean(known)) if known else None,
            }
        )
    made.sort(key=lambda row: (str(row["cases_of"]), float(row["difficulty"] or 0)))
    return Table(
        name="tiers",
        title="Authored tiers, the easiest first",
        columns=[
            Column(name="cases_of", title="setting"),
            Column(name="tier", title="authored"),
            Column(name="cases", title="cases"),
            Column(name="difficulty", title="mean difficulty", decimals=3),
            Column(name="case_rest", title="mean case-rest correlation", decimals=3),
        ],
        rows=made,
    )


CASE_DIFFICULTY = StudyDefinition(
    name="case-difficulty",
    title="Which cases are hard, and which carry the ranking",
    section="",
    sources={"trials": "SELECT * FROM chosen ORDER BY configuration, case_id, repeat"},
    compute=compute,
    takes=frozenset({"agents"}),
)
