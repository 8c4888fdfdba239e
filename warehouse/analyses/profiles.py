"""Profiles of what configurations are good at: repair scores by operation category, construction by requirement family
(paper, "Task Requirement Analysis", fig:i2s-operation-heatmap; SA06, SA07)."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Mapping, Sequence
from typing import get_args

import pandas as pd

from c4s.protocol.rules import Family
from c4s.records.analysis import Chart, Column, Findings, Table
from warehouse.analyses.cases import REPAIRS, case_table, number
from warehouse.analyses.study import Frames, StudyDefinition, StudyOptions


def compute(frames: Frames, options: StudyOptions) -> Findings:
    """Mean score of each configuration by category and by family; the weakest family of each."""
    table = case_table(frames["trials"], options)
    trials = table.rows
    repairs = trials[trials["setting"].isin(REPAIRS) & trials["operation_group"].notna()]
    families = frames["families"][frames["families"]["configuration"].isin(table.agents)]
    texts = trials[~trials["setting"].isin(REPAIRS)]
    ranked = dict(zip(table.agents, table.ranked, strict=True))
    tables = [
        _heat(
            "categories",
            "Repair scores by operation category",
            _by_category(repairs),
            sorted(set(repairs["operation_group"])),
            ranked,
        ),
        _heat(
            "families",
            "Detailed Alignment by requirement family",
            _by_family(families, texts),
            get_args(Family),
            ranked,
        ),
    ]
    charts = [
        Chart(
            name=one.name,
            title=one.title,
            kind="heat",
            table=one.name,
            y="configuration",
            series=[column.name for column in one.columns[1:]],
        )
        for one in tables
        if one.rows
    ]
    notes = _weakest(tables[1], set(families.loc[families["value"].notna(), "family"]))
    notes.append(
        "A family's mean is over the cases whose prompt has it; a case without a measured answer counts 0 in it. "
        "A repair "
        "category has few cases and fewer source scenes, so its numbers have no intervals here."
    )
    return Findings(tables=[one for one in tables if one.rows] + [table.apart], charts=charts, notes=notes)


def _by_category(repairs: pd.DataFrame) -> pd.DataFrame:
    cases = repairs.groupby(["configuration", "operation_group", "case_id"])["score"].mean().reset_index()
    found = cases.groupby(["configuration", "operation_group"])["score"].agg(["mean", "size"]).reset_index()
    return found.rename(columns={"operation_group": "of", "mean": "score", "size": "cases"})


def _by_family(families: pd.DataFrame, texts: pd.DataFrame) -> pd.DataFrame:
    """Means over the cases that any configuration's verdict shows to have the family."""
    has = families[["case_id", "family"]].drop_duplicates()
    asked = texts[["configuration", "case_id", "trial_id"]].merge(has, on="case_id")
    told = asked.merge(families[["trial_id", "family", "value"]], on=["trial_id", "family"], how="left")
    cases = told.assign(value=told["value"].fillna(0.0)).groupby(["configuration", "family", "case_id"])["value"].mean()
    found = cases.reset_index().groupby(["configuration", "family"])["value"].agg(["mean", "size"]).reset_index()
    return found.rename(columns={"family": "of", "mean": "score", "size": "cases"})


def _heat(name: str, title: str, found: pd.DataFrame, order: Sequence[str], ranked: Mapping[str, bool]) -> Table:
    """A row a configuration, a column a category with its number of cases."""
    scores = found.pivot_table(index="configuration", columns="of", values="score")
    cases = {str(of): int(count) for of, count in found.groupby("of")["cases"].max().items()}
    there = [one for one in order if one in cases]
    return Table(
        name=name,
        title=title,
        columns=[
            Column(name="configuration", title="configuration"),
            *(
                Column(name=one, title=f"{words(one)} ({cases[one]})", unit="score", decimals=3, marks="high")
                for one in there
            ),
        ],
        rows=[
            {
                "configuration": str(agent),
                "ranked": ranked[str(agent)],
                **{one: number(float(scores.loc[agent, one])) for one in there},
            }
            for agent in scores.index
        ],
    )


def words(name: str) -> str:
    """A code's name as people read it."""
    return name.replace("_", " ")


def _weakest(families: Table, judged: Collection[str]) -> list[str]:
    """Which family is the weakest of those that a judge gave any answer in, and of how many configurations."""
    weakest: Counter[str] = Counter()
    for row in families.rows:
        scores = {name: value for name, value in row.items() if type(value) is float and name in judged}
        if not scores:
            continue
        weakest[min(scores, key=scores.__getitem__)] += 1
    told = ", ".join(f"{words(name)} ({count})" for name, count in weakest.most_common())
    return [f"Weakest family, and of how many configurations: {told}."] if told else []


PROFILES = StudyDefinition(
    name="profiles",
    title="Profiles by operation category and requirement family",
    section="sec:analysis, fig:i2s-operation-heatmap",
    sources={
        "trials": "SELECT * FROM chosen ORDER BY configuration, case_id, repeat",
        "families": """
            SELECT c.configuration, c.case_id, c.trial_id, substr(p.name, 10) AS family, p.value
            FROM chosen AS c JOIN components AS p USING (trial_id)
            WHERE starts_with(p.name, 'families.') AND NOT contains(substr(p.name, 10), '.')
            ORDER BY c.configuration, c.case_id, c.repeat, family""",
    },
    compute=compute,
    takes=frozenset({"agents"}),
)
