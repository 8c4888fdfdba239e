"""How well the public cases stand for the whole suite: differences, order, reversed pairs (paper, app:public-private,
tab:public-private-validation; SA34, SA35, SA36, SA47).

Over the configurations that are complete on both sets. No case is named.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pandas as pd

from c4s.errors import BadInput, unknown
from c4s.records.analysis import Chart, Column, Findings, Table, Value
from c4s.stats.bootstrap import Floats
from c4s.stats.orders import REVERSED_GAP, differences, pearson, reversed_pairs
from c4s.stats.repeats import tau_b
from warehouse.analyses.cases import REPAIRS, CaseTable, case_table
from warehouse.analyses.panels import SETS, TITLES, ranked_places, set_scores
from warehouse.analyses.study import BOTH_PANELS, Frames, StudyDefinition, StudyOptions

_SIDES = {"t2s": "S_T2S", "i2s": "S_I2S", "model": "S_model"}
EQUAL = "i2s_equal_domains"
"""The mean of the public means of the domains, whatever their numbers of cases."""


def compute(frames: Frames, options: StudyOptions) -> Findings:
    """Public means against means over all cases."""
    trials = frames["trials"]
    if set(trials["visibility"]) != set(SETS):
        raise BadInput("this suite has no two sets of cases", todo="c4s analyze main-results")
    table = case_table(trials, options)
    places = ranked_places(table)
    agents = [table.agents[place] for place in places]
    for name in options.pool:
        if name not in table.agents:
            raise unknown("configuration", name, table.agents)
    public = np.isin(table.cases, trials.loc[trials["visibility"] == "public", "case_id"].unique())
    part, whole = _scores(table, table.values("score")[:, places], public)
    names = [name for name in (*table.of(REPAIRS), *_SIDES, EQUAL) if name in part and name in whole]
    order = [name for name in ("t2s", *table.of(REPAIRS), "i2s", EQUAL, "model") if name in names]
    rows = [_validation(name, agents, part[name], whole[name], options.pool) for name in order]
    pooled = Column(name="inside_pool", title="mean |Δ| inside the pool", unit="score", decimals=3)
    outside = Column(name="outside_pool", title="mean |Δ| outside", unit="score", decimals=3)
    validation = Table(
        name="validation",
        title=f"Public cases against all cases ({len(agents)} configurations, {int(public.sum())} of "
        f"{len(public)} cases)",
        columns=[
            Column(name="score", title="score"),
            Column(name="mean_absolute", title="mean |Δ|", unit="score", decimals=3),
            Column(name="largest", title="largest |Δ|", unit="score", decimals=3),
            Column(name="mean", title="mean Δ", unit="score", decimals=3),
            Column(name="tau_b", title="Kendall's tau-b", decimals=3),
            Column(name="pearson", title="Pearson's r", decimals=3),
            Column(name="reversed_pairs", title="reversed pairs"),
            Column(name="which", title="which"),
            Column(name="swapped_pairs", title="in another order at all"),
            *([pooled, outside] if options.pool else []),
        ],
        rows=rows,
    )
    tables = [validation, _each(agents, order, part, whole), _parts(frames["components"], table, places, public)]
    chart = Chart(
        name="public_against_all",
        title="Model score of each configuration: public cases against all",
        kind="scatter",
        table="configurations",
        x="model_all",
        y="model_public",
        label="configuration",
        diagonal=True,
    )
    notes = [
        "Δ is the public mean less the mean over all cases. A pair is reversed that differs by at least "
        f"{REVERSED_GAP} over all cases and stands the other way round on the public ones.",
        "These errors describe these configurations; the public set is not proportional in packages, categories or "
        "difficulty.",
    ]
    return Findings(
        tables=[*tables, *([table.apart] if table.apart.rows else [])],
        charts=[chart] if "model" in order else [],
        notes=notes,
    )


def _scores(table: CaseTable, scores: Floats, public: np.ndarray) -> tuple[dict[str, Floats], dict[str, Floats]]:
    settings = np.array(table.settings)
    part, whole = set_scores(settings[public].tolist(), scores[public]), set_scores(settings.tolist(), scores)
    if "i2s" in part:
        for of in (part, whole):
            of[EQUAL] = np.mean([of[domain] for domain in REPAIRS], axis=0)
    return part, whole


def _validation(name: str, agents: list[str], part: Floats, whole: Floats, pool: list[str]) -> dict[str, Value]:
    off, turned = differences(part, whole), reversed_pairs(part, whole)
    row: dict[str, Value] = {
        "score": _title(name),
        "mean_absolute": off.mean_absolute,
        "largest": off.largest,
        "mean": off.mean,
        "tau_b": tau_b(part, whole),
        "pearson": pearson(part, whole),
        "reversed_pairs": len(turned),
        "which": "; ".join(f"{agents[one]} / {agents[two]}" for one, two in turned),
        "swapped_pairs": "; ".join(
            f"{agents[one]} / {agents[two]} ({abs(whole[one] - whole[two]):.4f})"
            for one, two in reversed_pairs(part, whole, gap=0.0)
        ),
    }
    if pool:
        inside = np.isin(agents, pool)
        for key, chosen in (("inside_pool", inside), ("outside_pool", ~inside)):
            row[key] = differences(part[chosen], whole[chosen]).mean_absolute if chosen.any() else None
    return row


def _title(name: str) -> str:
    if name == EQUAL:
        return "S_I2S, domains equal"
    return _SIDES.get(name) or TITLES[name]


def _each(agents: list[str], order: list[str], part: dict[str, Floats], whole: dict[str, Floats]) -> Table:
    kinds = {"public": part, "all": whole}
    columns = [
        Column(name=f"{name}_{kind}", title=f"{_title(name)}, {kind}", unit="score", decimals=3)
        for name in order
        for kind in kinds
    ]
    rows: list[dict[str, Value]] = [
        {"configuration": agent}
        | {f"{name}_{kind}": float(scores[name][place]) for name in order for kind, scores in kinds.items()}
        for place, agent in enumerate(agents)
    ]
    return Table(
        name="configurations",
        title="Means on the public cases and on all",
        columns=[Column(name="configuration", title="configuration"), *columns],
        rows=rows,
    )


def _parts(components: pd.DataFrame, table: CaseTable, places: list[int], public: np.ndarray) -> Table:
    rows = sorted(
        _deviations(components, table, places, public), key=lambda row: (str(row["setting"]), str(row["part"]))
    )
    return Table(
        name="parts",
        title="Parts of scores on the public cases against all",
        columns=[
            Column(name="setting", title="setting"),
            Column(name="part", title="part"),
            Column(name="mean_absolute", title="mean |Δ|", unit="score", decimals=3),
            Column(name="largest", title="largest |Δ|", unit="score", decimals=3),
        ],
        rows=rows,
    )


def _deviations(
    components: pd.DataFrame, table: CaseTable, places: list[int], public: np.ndarray
) -> Iterator[dict[str, Value]]:
    """Each number in [0, 1] that scores are made of; a case that lacks it does not count."""
    of, agents = np.array(table.settings), [table.agents[place] for place in places]
    for (setting, verifier, name), rows in components.groupby(["setting", "verifier", "name"]):
        wide = rows.pivot_table(index="case_id", columns="configuration", values="value", aggfunc="mean").reindex(
            index=table.cases, columns=agents
        )
        values = wide.to_numpy(dtype=np.float64)
        if values[np.isfinite(values)].max(initial=0.0) > 1 or not np.isfinite(values[public]).any(axis=0).all():
            continue
        off = differences(
            np.nanmean(values[public & (of == setting)], axis=0), np.nanmean(values[of == setting], axis=0)
        )
        yield {
            "setting": TITLES[str(setting)],
            "part": f"{verifier} {name}",
            "mean_absolute": off.mean_absolute,
            "largest": off.largest,
        }


PUBLIC_PRIVATE = StudyDefinition(
    name="public-private",
    title="Public cases against the whole suite",
    section="app:public-private, tab:public-private-validation",
    sources={
        "trials": "SELECT * FROM chosen ORDER BY configuration, case_id, repeat",
        "components": "SELECT c.configuration, c.setting, c.case_id, c.repeat, p.verifier, p.name, p.value "
        "FROM chosen AS c JOIN components AS p USING (trial_id) "
        "ORDER BY c.configuration, c.case_id, c.repeat, p.verifier, p.name",
    },
    compute=compute,
    takes=frozenset({"agents", "pool"}),
    across=BOTH_PANELS,
)
