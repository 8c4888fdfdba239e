"""How few cases stand for all: greedy selection against random, stratified, anchored and filtered ones, each without
the configuration whose means it has to tell (paper, app:public-private, tab:public-set-size; SA31, SA32, SA33).

Within each setting. Errors are of plain means of the chosen cases (anchors: weighted) against those of all cases. No
case is named.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Final

import numpy as np
import pandas as pd

from c4s.errors import BadInput, unknown
from c4s.protocol.settings import SETTINGS, Setting, is_construction
from c4s.records.analysis import Chart, Column, Findings, Table, Value
from c4s.stats.bootstrap import Floats
from c4s.stats.orders import REVERSED_GAP, reversed_counts
from c4s.stats.selection import Choose, anchors, filtered_keys, greedy_order, left_out, lowest, plain, stratified_keys
from warehouse.analyses.cases import CaseTable, case_table
from warehouse.analyses.main_results import MAIN_RESULTS
from warehouse.analyses.panels import SETS, TITLES, ranked_places
from warehouse.analyses.study import BOTH_PANELS, Frames, StudyDefinition, StudyOptions

SHARES: Final = (0.32, 0.4, 0.5, 0.67)
"""Of the cases of each setting."""
SUBSETS: Final = 1000
"""Draws of a method that draws."""
LEAST: Final = 3
METHODS: Final = ("greedy", "random", "stratified", "anchors", "middle scores")
TOTAL: Final = "score"


def compute(frames: Frames, options: StudyOptions) -> Findings:
    """A row a method and share of cases, over all settings and of each."""
    trials = frames["trials"]
    table = case_table(trials, options)
    for name in options.pool:
        if name not in table.agents:
            raise unknown("configuration", name, table.agents)
    places = [place for place in ranked_places(table) if not options.pool or table.agents[place] in options.pool]
    if len(places) < LEAST:
        raise BadInput(f"a selection needs {LEAST} complete configurations, there are {len(places)}")
    settings = [setting for setting in SETTINGS if setting in table.settings]
    stratum_of = strata_of(trials)
    made: dict[str, Predicted | None]
    rows: list[dict[str, Value]] = []
    for share in SHARES:
        for method in METHODS:
            made = {s: _predicted(table, s, places, method, share, stratum_of, options.seed) for s in settings}
            rows.append({"method": method, "share": share, **errors_of(made)})
    if set(trials["visibility"]) == set(SETS):
        public = set(trials.loc[trials["visibility"] == SETS[0], "case_id"])
        made = {setting: _of_public(table, setting, places, public) for setting in settings}
        if None not in made.values():
            rows.append({"method": "the public set", "share": len(public) / len(table.cases), **errors_of(made)})
    columns = [
        Column(name="method", title="method"),
        Column(name="share", title="share of the cases", unit="share", decimals=2),
        Column(name="cases", title="cases"),
        Column(name="total_error", title="error of totals", unit="score", decimals=3),
        Column(name="part_error", title="error of parts", unit="score", decimals=3),
        Column(name="reversed", title="reversed pairs", decimals=1),
        *(
            Column(name=f"{kind} {setting}", title=f"{TITLES[setting]}: error of {words}", unit="score", decimals=3)
            for setting in settings
            for kind, words in (("total", "totals"), ("part", "parts"))
        ),
    ]
    main = Table(
        name="methods",
        title=f"Errors of means over chosen cases, each configuration left out in turn ({len(places)} configurations)",
        columns=columns,
        rows=rows,
    )
    chart = Chart(
        name="methods",
        title="Error of totals by the share of cases that is kept",
        kind="lines",
        table="methods",
        x="share",
        y="total_error",
        group="method",
    )
    notes = [
        f"Mean absolute errors. Pairs count as reversed that differ by {REVERSED_GAP} or more over all cases. Methods "
        f"that draw are means over {SUBSETS:,} draws with seed {options.seed}; anchors carry weights.",
        "The public set was chosen with these configurations or without: its row leaves none out.",
    ]
    return Findings(tables=[main, *([table.apart] if table.apart.rows else [])], charts=[chart], notes=notes)


Predicted = tuple[int, Floats, Floats]
"""Number of cases; means by chosen cases, shape (draws, configurations, columns); means of all cases."""


def values_of(table: CaseTable, setting: Setting, places: Sequence[int]) -> Floats:
    """The setting's cases, shape (cases, configurations, columns); the first column is the total."""
    parts = ("semantic", "physical") if is_construction(setting) else ("repair_f1", "physical")
    own = np.array(table.settings) == setting
    return np.stack([table.values(column)[own][:, places] for column in (TOTAL, *parts)], axis=-1)


def _predicted(
    table: CaseTable,
    setting: Setting,
    places: Sequence[int],
    method: str,
    share: float,
    stratum_of: Mapping[str, str],
    seed: int,
) -> Predicted:
    values = values_of(table, setting, places)
    size = max(1, round(share * len(values)))
    strata = [stratum_of[case] for case, own in zip(table.cases, table.settings, strict=True) if own == setting]
    return size, left_out(values, method_named(method, size, strata, seed)), values.mean(axis=0)


def method_named(method: str, size: int, strata: Sequence[str], seed: int) -> Choose:
    """How a pool's values choose cases."""

    def chosen(values: Floats) -> Floats:
        cases, random = len(values), np.random.default_rng(seed)
        if method == "greedy":
            return plain(cases, greedy_order(values.reshape(cases, -1))[:size])
        if method == "anchors":
            return anchors(values[:, :, 0], size)
        if method == "stratified":
            return lowest(stratified_keys(strata, random, SUBSETS), size)
        if method == "random":
            return lowest(random.random((SUBSETS, cases)), size)
        return lowest(filtered_keys(values[:, :, 0].mean(axis=1), random, SUBSETS), size)

    return chosen


def strata_of(trials: pd.DataFrame) -> dict[str, str]:
    """The stratum of each case: its group of operations, or its scene."""
    strata = trials.assign(stratum=trials["operation_group"].fillna(trials["scene_id"])).drop_duplicates("case_id")
    return dict(zip(strata["case_id"].astype(str), strata["stratum"].astype(str), strict=True))


def _of_public(table: CaseTable, setting: Setting, places: Sequence[int], public: set[str]) -> Predicted | None:
    values = values_of(table, setting, places)
    own = [case in public for case, of in zip(table.cases, table.settings, strict=True) if of == setting]
    chosen = np.flatnonzero(own)
    if not len(chosen):
        return None
    return len(chosen), np.tensordot(plain(len(values), chosen), values, axes=1), values.mean(axis=0)


def errors_of(made: Mapping[str, Predicted | None]) -> dict[str, Value]:
    """Errors over the settings, each the same weight."""
    known = {setting: found for setting, found in made.items() if found is not None}
    errors = {setting: np.abs(told - truth).mean(axis=(0, 1)) for setting, (_, told, truth) in known.items()}
    turned = [
        reversed_counts(told[:, :, column], truth[:, column]).mean()
        for _, told, truth in known.values()
        for column in range(truth.shape[1])
    ]
    row: dict[str, Value] = {
        "cases": sum(size for size, _, _ in known.values()),
        "total_error": float(np.mean([error[0] for error in errors.values()])),
        "part_error": float(np.mean([error[1:].mean() for error in errors.values()])),
        "reversed": float(sum(turned)),
    }
    for setting, error in errors.items():
        row |= {f"total {setting}": float(error[0]), f"part {setting}": float(error[1:].mean())}
    return row


SET_SELECTION = StudyDefinition(
    name="set-selection",
    title="How few cases stand for all",
    section="app:public-private, tab:public-set-size",
    sources=MAIN_RESULTS.sources,
    compute=compute,
    takes=frozenset({"agents", "pool", "seed"}),
    across=BOTH_PANELS,
)
