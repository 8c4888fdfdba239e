"""Which configurations have outcomes of which cases: the cohorts of all other studies (paper, app:trajectory-cohort and
app:benchmark-details; SA43).

A pair is a configuration and a case. Only complete configurations are in a cohort; ``apart`` lists the others.
"""

from __future__ import annotations

from fractions import Fraction

import numpy as np

from c4s.protocol.settings import INDOOR_REPAIR, OUTDOOR_REPAIR, SETTING_TITLES, SETTINGS
from c4s.records.analysis import Chart, Column, Findings, Table, Value
from warehouse.analyses.cases import CaseTable, NoneComplete, case_table
from warehouse.analyses.panels import SETS, apart_of, panels
from warehouse.analyses.study import BOTH_PANELS, Frames, StudyDefinition, StudyOptions

FULL = "full"
_SHORT = dict(zip(SETTINGS, ("t2s", "indoor", "outdoor"), strict=True))


def compute(frames: Frames, options: StudyOptions) -> Findings:
    """A row a set of cases, and one of all cases where there are two sets."""
    trials = frames["trials"]
    found = panels(trials, options)
    rows = [_cohort(panel.name, panel.cases) for panel in found]
    notes = []
    if set(trials["visibility"]) == set(SETS):
        try:
            rows.append(_cohort(FULL, case_table(trials, options)))
        except NoneComplete:
            notes.append("No configuration is complete on both sets.")
    main = Table(
        name="cohorts",
        title="Cohorts: complete configurations on a set of cases",
        columns=[
            Column(name="set", title="set"),
            *(Column(name=_SHORT[setting], title=SETTING_TITLES[setting], unit="cases") for setting in SETTINGS),
            Column(name="cases", title="cases"),
            Column(name="indoor_weight", title="weight of indoor among repairs", unit="share"),
            Column(name="outdoor_weight", title="weight of outdoor among repairs", unit="share"),
            *(
                Column(name=f"{_SHORT[setting]}_scenes", title=f"{SETTING_TITLES[setting]}: source scenes")
                for setting in SETTINGS
            ),
            Column(name="configurations", title="complete configurations"),
            Column(name="ranked", title="of them ranked"),
            Column(name="pairs", title="pairs"),
        ],
        rows=rows,
    )
    if len(rows) == 1:
        notes.append(f"There is one set of cases, with {rows[0]['pairs']} pairs: no chart compares it.")
    members: list[dict[str, Value]] = [
        {"set": panel.name, "configuration": agent, "ranked": ranked}
        for panel in found
        for agent, ranked in zip(panel.cases.agents, panel.cases.ranked, strict=True)
    ]
    chart = Chart(
        name="cohorts", title="Pairs of configuration and case", kind="bars", table="cohorts", x="pairs", y="set"
    )
    columns = [Column(name=name, title=name) for name in ("set", "configuration", "ranked")]
    return Findings(
        tables=[
            main,
            Table(name="members", title="Complete configurations", columns=columns, rows=members),
            *apart_of(found),
        ],
        charts=[chart] if len(rows) > 1 else [],
        notes=notes,
    )


def _cohort(name: str, cases: CaseTable) -> dict[str, Value]:
    of = np.array(cases.settings)
    counts = {setting: int((of == setting).sum()) for setting in SETTINGS}
    scenes = {str(domain): count for domain, count in cases.design.clusters_in().items()}
    repairs = counts[INDOOR_REPAIR] + counts[OUTDOOR_REPAIR]
    return {
        "set": name,
        **{_SHORT[setting]: count for setting, count in counts.items()},
        "cases": len(of),
        "indoor_weight": str(Fraction(counts[INDOOR_REPAIR], repairs)) if repairs else None,
        "outdoor_weight": str(Fraction(counts[OUTDOOR_REPAIR], repairs)) if repairs else None,
        **{f"{_SHORT[setting]}_scenes": scenes.get(setting, 0) for setting in SETTINGS},
        "configurations": len(cases.agents),
        "ranked": sum(cases.ranked),
        "pairs": len(cases.agents) * len(of),
    }


COHORTS = StudyDefinition(
    name="cohorts",
    title="Cohorts of configurations and cases",
    section="app:trajectory-cohort, app:public-private",
    sources={"trials": "SELECT * FROM chosen ORDER BY configuration, case_id, repeat"},
    compute=compute,
    takes=frozenset({"agents"}),
    across=BOTH_PANELS,
)
