"""Where each configuration stands in each public case, ties told (paper, app:running-cases; SA42).

Competition ranks by the case score: equal scores share the smallest. Private cases are not named, so they have no row.
"""

from __future__ import annotations

import numpy as np

from c4s.errors import BadInput
from c4s.records.analysis import Chart, Column, Findings, Table, Value
from c4s.stats.bootstrap import Integers
from c4s.stats.ranks import competition_ranks
from warehouse.analyses.cases import CaseTable, case_table
from warehouse.analyses.panels import SETS, ranked_places
from warehouse.analyses.study import BOTH_PANELS, Frames, StudyDefinition, StudyOptions


def compute(frames: Frames, options: StudyOptions) -> Findings:
    """A row a public case and configuration."""
    trials = frames["trials"]
    public = trials[trials["visibility"] == SETS[0]]
    if public.empty:
        raise BadInput("this suite has no public case", todo="c4s analyze main-results")
    table = case_table(public, options)
    places = ranked_places(table)
    scores = table.values("score")[:, places]
    ranks = competition_ranks(scores)
    titles = public.drop_duplicates("case_id").set_index("case_id")["title"].to_dict()
    rows: list[dict[str, Value]] = [
        {
            "case": case,
            "title": titles[case],
            "setting": table.settings[number],
            "configuration": table.agents[place],
            "score": float(scores[number, column]),
            "rank": int(ranks[number, column]),
            "tied": bool((ranks[number] == ranks[number, column]).sum() > 1),
            "of": len(places),
        }
        for number, case in enumerate(table.cases)
        for column, place in enumerate(places)
    ]
    main = Table(
        name="ranks",
        title=f"Ranks by case ({len(places)} configurations)",
        columns=[
            Column(name="case", title="case"),
            Column(name="title", title="title"),
            Column(name="setting", title="setting"),
            Column(name="configuration", title="configuration"),
            Column(name="score", title="score", unit="score", decimals=3),
            Column(name="rank", title="rank"),
            Column(name="tied", title="shares its rank"),
            Column(name="of", title="of"),
        ],
        rows=rows,
    )
    chart = Chart(
        name="ranks",
        title="Rank of each configuration in each public case",
        kind="heat",
        table="by_case",
        y="case",
        series=[table.agents[place] for place in places],
    )
    wide = _by_case(table, places, ranks)
    tables = [_each(table, places, ranks), wide, main, *([table.apart] if table.apart.rows else [])]
    return Findings(tables=tables, charts=[chart])


def _by_case(table: CaseTable, places: list[int], ranks: Integers) -> Table:
    agents = [table.agents[place] for place in places]
    return Table(
        name="by_case",
        title="Rank of each configuration in each public case",
        columns=[Column(name="case", title="case"), *(Column(name=agent, title=agent) for agent in agents)],
        rows=[
            {"case": case, **{agent: int(rank) for agent, rank in zip(agents, ranks[number], strict=True)}}
            for number, case in enumerate(table.cases)
        ],
    )


def _each(table: CaseTable, places: list[int], ranks: Integers) -> Table:
    """How often each configuration leads, shares the lead, and comes last."""
    last = ranks.max(axis=1, keepdims=True)
    alone = (ranks == 1).sum(axis=1, keepdims=True) == 1
    rows: list[dict[str, Value]] = [
        {
            "configuration": table.agents[place],
            "leads_alone": int(((ranks == 1) & alone)[:, column].sum()),
            "shares_lead": int(((ranks == 1) & ~alone)[:, column].sum()),
            "last": int((ranks == last)[:, column].sum()),
            "median_rank": float(np.median(ranks[:, column])),
            "cases": len(table.cases),
        }
        for column, place in enumerate(places)
    ]
    return Table(
        name="leads",
        title="How often a configuration leads a case",
        columns=[
            Column(name="configuration", title="configuration"),
            Column(name="leads_alone", title="first alone", unit="cases"),
            Column(name="shares_lead", title="first with others", unit="cases"),
            Column(name="last", title="last, alone or with others", unit="cases"),
            Column(name="median_rank", title="median rank", decimals=1),
            Column(name="cases", title="cases"),
        ],
        rows=rows,
    )


CASE_RANKS = StudyDefinition(
    name="case-ranks",
    title="Ranks by case",
    section="app:running-cases",
    sources={"trials": "SELECT * FROM chosen ORDER BY configuration, case_id, repeat"},
    compute=compute,
    takes=frozenset({"agents"}),
    across=BOTH_PANELS,
)
