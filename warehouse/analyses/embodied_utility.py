"""The Embodied Utility Score of configurations: panels, changes against the input, alignment with the benchmark score
(paper, "Downstream Usability", tab:eus-leaderboard, fig:eus-summary; EU28 to EU37). Never part of a benchmark score.

A record is a trial with a scene. One that is withheld has no number: the conservative mean lets it count 0, the
measured mean leaves it out, and both are told with the coverage. What the evaluator could not read is no record.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pandas as pd

from c4s.protocol.baselines import NOOP
from c4s.protocol.settings import INDOOR_REPAIR, OUTDOOR_REPAIR, SETTINGS, TEXT_TO_SCENE, Setting
from c4s.records.analysis import Chart, Column, Findings, Table, Value
from c4s.stats.bootstrap import LEAST_CLUSTERS, Floats
from c4s.stats.navigation import alignment, paired_change, room_means, utility_mean
from warehouse.analyses.cases import CaseTable, case_table, number
from warehouse.analyses.study import Frames, StudyDefinition, StudyOptions

FEW = 6
"""Fewer configurations have no correlation."""
_TITLES: dict[Setting, str] = {
    TEXT_TO_SCENE: "Construction",
    OUTDOOR_REPAIR: "Repairs outdoors",
    INDOOR_REPAIR: "Repairs indoors",
}
_COLUMNS = [
    Column(name="eus", title="EUS", unit="score", decimals=3, marks="high"),
    Column(name="se", title="SE", unit="score", decimals=3),
    Column(name="measured", title="measured", unit="score", decimals=3, marks="high"),
    Column(name="coverage", title="coverage", unit="share", decimals=2),
    Column(name="A", title="A", unit="share", decimals=3, marks="high"),
    Column(name="W", title="W", unit="share", decimals=3, marks="high"),
    Column(name="scored", title="scored"),
    Column(name="zero", title="zero"),
    Column(name="withheld", title="withheld"),
    Column(name="records", title="records"),
    Column(name="absent", title="no scene, or not read"),
]
_AGENT = Column(name="configuration", title="configuration")


def compute(frames: Frames, options: StudyOptions) -> Findings:
    """A panel a setting, rooms as units indoors, changes against the input, two configurations, alignment."""
    cases = case_table(frames["trials"], options)
    rows = cases.rows
    settings = [setting for setting in SETTINGS if setting in set(rows["setting"])]
    tables = [_panel(cases, setting) for setting in settings]
    if INDOOR_REPAIR in settings:
        tables.append(_rooms(cases))
    tables += [_changes(cases, setting) for setting in settings if setting != TEXT_TO_SCENE]
    if TEXT_TO_SCENE in settings:
        tables += [_difference(cases, options.agents), _alignment(cases)]
    tables = [table for table in tables if table.rows]
    return Findings(
        tables=[*tables, _reasons(cases), cases.apart],
        charts=[
            Chart(name=f"{one.name}_eus", title=one.title, kind="bars", table=one.name, x="eus", y="configuration")
            for one in tables
            if one.name.startswith("panel_")
        ]
        + [
            Chart(
                name=one.name,
                title=one.title,
                kind="dots",
                table=one.name,
                x="change",
                y="configuration",
                reference=0.0,
            )
            for one in tables
            if one.name.startswith("change_")
        ],
        notes=[
            "The Embodied Utility Score has no weight in any benchmark score. EUS lets a withheld scene count 0, "
            "measured leaves it out; scored counts results above 0. A is over scored and zero records, W over records "
            "with walks.",
            "The matched input of a repair is the scene that the configuration that does nothing saved of its case.",
            f"With fewer than {LEAST_CLUSTERS} source scenes no standard error is given, with fewer than {FEW} "
            "configurations no correlation.",
        ],
    )


def _of(cases: CaseTable, agent: str, setting: Setting) -> pd.DataFrame:
    """The records of a configuration in a setting: trials with a scene that was read."""
    rows = cases.rows
    own = rows[(rows["configuration"] == agent) & (rows["setting"] == setting)]
    return own[own["walked"].notna() & ~own["excluded"].fillna(False).astype(bool)]


def _utilities(records: pd.DataFrame) -> Floats:
    return records["utility"].to_numpy(dtype=np.float64, na_value=np.nan)


def _mean(values: pd.Series) -> float | None:
    known = values.dropna().astype(float)
    return float(known.mean()) if len(known) else None


def _panel(cases: CaseTable, setting: Setting) -> Table:
    rows: list[dict[str, Value]] = []
    for agent in cases.agents:
        records = _of(cases, agent, setting)
        planned = cases.rows[(cases.rows["configuration"] == agent) & (cases.rows["setting"] == setting)]
        row: dict[str, Value] = {"configuration": agent, "records": len(records), "absent": len(planned) - len(records)}
        if len(records):
            mean = utility_mean(_utilities(records))
            row |= {
                "eus": mean.conservative,
                "se": mean.standard_error if records["scene_id"].nunique() >= LEAST_CLUSTERS else None,
                "measured": mean.measured,
                "coverage": mean.coverage,
                "A": _mean(records["approachability"]),
                "W": _mean(records["completion"]),
                "scored": mean.records - mean.zeros - mean.withheld,
                "zero": mean.zeros,
                "withheld": mean.withheld,
            }
        rows.append(row)
    rows.sort(key=lambda row: (-float(row.get("eus") or 0.0), str(row["configuration"])))
    name = setting.replace("/", "_").replace("-", "_")
    return Table(name=f"panel_{name}", title=_TITLES[setting], columns=[_AGENT, *_COLUMNS], rows=rows)


def _rooms(cases: CaseTable) -> Table:
    """Edits of one room share its geometry, so rooms are the units; by name, since their coverage differs."""
    rows: list[dict[str, Value]] = []
    for agent in cases.agents:
        records = _of(cases, agent, INDOOR_REPAIR)
        if len(records):
            made = room_means(_utilities(records), records["scene_id"].tolist())
            rows.append(
                {
                    "configuration": agent,
                    "rooms_measured": made.measured,
                    "rooms": made.rooms,
                    "mean": made.mean,
                    "median": made.median,
                }
            )
    columns = [
        _AGENT,
        Column(name="rooms_measured", title="rooms measured"),
        Column(name="rooms", title="rooms"),
        Column(name="mean", title="mean EUS", unit="score", decimals=3),
        Column(name="median", title="median EUS", unit="score", decimals=3),
    ]
    return Table(name="rooms", title="Repairs indoors, rooms as units (not ranked)", columns=columns, rows=rows)


def _changes(cases: CaseTable, setting: Setting) -> Table:
    """Each configuration less the matched input, over the cases that both have a record of."""
    inputs = sorted(set(cases.rows.loc[cases.rows["client"] == NOOP, "configuration"]))
    rows: list[dict[str, Value]] = []
    for agent in cases.agents if inputs else []:
        if agent != inputs[0]:
            rows += _paired(cases, agent, inputs[0], setting)
    columns = [
        _AGENT,
        Column(name="change", title="change", unit="score", decimals=3),
        Column(name="se", title="SE", unit="score", decimals=3),
        Column(name="pairs", title="pairs"),
        Column(name="without", title="without a pair"),
    ]
    name = setting.replace("/", "_").replace("-", "_")
    title = f"{_TITLES[setting]}: change against the matched input"
    return Table(name=f"change_{name}", title=title, columns=columns, rows=rows)


def _paired(cases: CaseTable, agent: str, other: str, setting: Setting) -> list[dict[str, Value]]:
    one, two = (_of(cases, name, setting) for name in (agent, other))
    both = one.merge(two, on="case_id", suffixes=("", "_before")).drop_duplicates(["case_id", "repeat"])
    if not len(both):
        return []
    before = both["utility_before"].to_numpy(dtype=np.float64, na_value=np.nan)
    made = paired_change(_utilities(both), before)
    shown = made.standard_error if both["scene_id"].nunique() >= LEAST_CLUSTERS else None
    without = len(one) - len(both)
    return [{"configuration": agent, "change": made.mean, "se": shown, "pairs": made.pairs, "without": without}]


def _difference(cases: CaseTable, agents: Sequence[str]) -> Table:
    """Of two configurations that were asked for, the first less the second on shared prompts."""
    rows = _paired(cases, agents[0], agents[1], TEXT_TO_SCENE) if len(agents) == 2 else []
    columns = [
        _AGENT,
        Column(name="change", title="difference", unit="score", decimals=3),
        Column(name="se", title="SE", unit="score", decimals=3),
        Column(name="pairs", title="shared prompts"),
    ]
    title = f"Construction: {agents[0]} less {agents[1]}" if rows else "Construction: difference"
    return Table(name="difference", title=title, columns=columns, rows=rows)


def _alignment(cases: CaseTable) -> Table:
    """How configurations' means go with their benchmark scores of construction, over those that have both."""
    found: list[tuple[float, float, float]] = []
    for agent, ranked in zip(cases.agents, cases.ranked, strict=True):
        records = _of(cases, agent, TEXT_TO_SCENE)
        own = cases.rows[(cases.rows["configuration"] == agent) & (cases.rows["setting"] == TEXT_TO_SCENE)]
        if ranked and len(records):
            mean = utility_mean(_utilities(records))
            if mean.measured is not None:
                found.append((mean.conservative, mean.measured, float(own["score"].mean())))
    rows: list[dict[str, Value]] = []
    if len(found) >= FEW:
        conservative, measured, scores = np.array(found).T
        for name, values in (("conservative", conservative), ("measured", measured)):
            made = alignment(values, scores)
            rows.append({"variant": name, "n": made.configurations, "pearson": made.pearson, "spearman": made.spearman})
    columns = [
        Column(name="variant", title="EUS"),
        Column(name="n", title="configurations"),
        Column(name="pearson", title="Pearson r", decimals=3),
        Column(name="spearman", title="Spearman rho", decimals=3),
    ]
    return Table(
        name="alignment", title="Alignment with the benchmark score of construction", columns=columns, rows=rows
    )


def _reasons(cases: CaseTable) -> Table:
    """Why records have no number, and how often."""
    told = cases.rows[cases.rows["because"].notna()]
    counted = told.groupby(["configuration", "setting", "because"]).size().reset_index(name="trials")
    rows: list[dict[str, Value]] = [
        {str(key): number(value) if isinstance(value, float) else value for key, value in row.items()}
        for row in counted.to_dict("records")
    ]
    columns = [
        _AGENT,
        Column(name="setting", title="setting"),
        Column(name="because", title="withheld because"),
        Column(name="trials", title="trials", unit="trials"),
    ]
    return Table(name="reasons", title="Why there is no number", columns=columns, rows=rows)


EMBODIED_UTILITY = StudyDefinition(
    name="embodied-utility",
    title="Embodied Utility Score",
    section="app:eus-results, tab:eus-leaderboard, fig:eus-summary",
    sources={
        "trials": """
            SELECT c.*, v.status AS walked, v.score AS utility, a.value AS approachability, w.value AS completion,
                v.document ->> '$.measurements.reason_code' AS because,
                CAST(v.document ->> '$.measurements.excluded' AS BOOLEAN) AS excluded
            FROM chosen AS c
            LEFT JOIN (SELECT * FROM verdicts WHERE verifier = 'navigation') AS v USING (trial_id)
            LEFT JOIN (SELECT trial_id, value FROM components
                WHERE verifier = 'navigation' AND name = 'approachability') AS a USING (trial_id)
            LEFT JOIN (SELECT trial_id, value FROM components
                WHERE verifier = 'navigation' AND name = 'completion') AS w USING (trial_id)
            ORDER BY c.configuration, c.case_id, c.repeat"""
    },
    compute=compute,
    takes=frozenset({"agents"}),
)
