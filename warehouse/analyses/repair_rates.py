"""Actor precision, recall and F1 by domain and set, with intervals (paper, tab:repair-metrics; SA17).

Means over cases: F1 of the table is not the harmonic mean of its precision and recall. What was not measured counts 0.
"""

from __future__ import annotations

from typing import Final

from c4s.errors import BadInput
from c4s.records.analysis import Chart, Column, Findings, Table, Value
from c4s.stats.bootstrap import domain_means, percentile_interval
from warehouse.analyses.cases import REPAIRS, intervals_of
from warehouse.analyses.panels import TITLES, SetPanel, apart_of, panels
from warehouse.analyses.study import BOTH_PANELS, RESAMPLING, Frames, StudyDefinition, StudyOptions

RATES: Final = {"repair_precision": "precision", "repair_recall": "recall", "repair_f1": "F1"}


def compute(frames: Frames, options: StudyOptions) -> Findings:
    """A row a configuration, domain and set."""
    repairs = frames["trials"]
    repairs = repairs[repairs["setting"].isin(REPAIRS)]
    if repairs.empty:
        raise BadInput("this suite has no repair case", todo="c4s analyze main-results")
    found = panels(repairs, options)
    tables = [_rates(panel, options) for panel in found]
    charts = [
        Chart(
            name=f"f1_{panel.name}",
            title=f"Repair F1 by domain ({panel.name} set)",
            kind="dots",
            table=f"rates_{panel.name}",
            x="repair_f1",
            y="configuration",
            group="domain",
        )
        for panel in found
    ]
    intervals = [intervals_of(panel.cases.design, options) for panel in found]
    return Findings(tables=[*tables, *apart_of(found)], charts=charts, intervals=intervals)


def _rates(panel: SetPanel, options: StudyOptions) -> Table:
    cases = panel.cases
    honest = cases.design.is_honest()
    counts = cases.design.draw(options.draws, options.seed) if honest else None
    rows: list[dict[str, Value]] = [
        {"configuration": agent, "domain": TITLES[domain]} for agent in cases.agents for domain in cases.of(REPAIRS)
    ]
    for rate in RATES:
        values = cases.values(rate)
        observed = domain_means(cases.design, cases.design.observed(), values)[0]
        ends = (
            None if counts is None else percentile_interval(domain_means(cases.design, counts, values), options.level)
        )
        places = [
            (cases.design.domains.index(domain), agent)
            for agent in range(len(cases.agents))
            for domain in cases.of(REPAIRS)
        ]
        for row, place in zip(rows, places, strict=True):
            row[rate] = float(observed[place])
            if ends is not None:
                row[f"{rate}_low"], row[f"{rate}_high"] = float(ends[0][place]), float(ends[1][place])
    return Table(
        name=f"rates_{panel.name}",
        title=f"Precision, recall and F1 of repairs ({panel.name} set, {len(cases.cases)} cases)",
        columns=[
            Column(name="configuration", title="configuration"),
            Column(name="domain", title="domain"),
            *(
                column
                for rate, title in RATES.items()
                for column in (
                    Column(name=rate, title=title, unit="share", decimals=3),
                    *(
                        Column(name=f"{rate}_{end}", title=f"{title} {end}", unit="share", decimals=3)
                        for end in (("low", "high") if honest else ())
                    ),
                )
            ),
        ],
        rows=rows,
    )


REPAIR_RATES = StudyDefinition(
    name="repair-rates",
    title="Precision, recall and F1 of repairs by domain",
    section="tab:repair-metrics",
    sources={"trials": "SELECT * FROM chosen ORDER BY configuration, case_id, repeat"},
    compute=compute,
    takes=RESAMPLING | {"agents"},
    across=BOTH_PANELS,
)
