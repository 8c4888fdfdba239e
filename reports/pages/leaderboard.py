"""The leaderboard: the site's first page."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from statistics import fmean
from typing import Any, Final

import numpy as np

from c4s.protocol.settings import is_construction
from c4s.records.analysis import Column, Table
from c4s.stats import orders
from reports.drawing import Dot, Scatter, scatter
from reports.frame import Board, Grid, SiteContext, SitePage, grid, links
from reports.frame.board import Row
from reports.frame.studies import Answer
from reports.statements import CAVEATS
from warehouse.release import PrivateStanding

SCORES: Final = {
    name: name.replace("_", " ").capitalize()
    for name, field in PrivateStanding.model_fields.items()
    if field.annotation == float | None
} | {"model_score": "Overall", "repair_f1": "Repair F1", "text_physics": "Physics T2S", "image_physics": "Physics I2S"}
"""Columns of the leaderboard with their titles, in the order of the paper's main table."""
STUDIED: Final = {
    "model_score": "s_model",
    "text_to_scene": "s_t2s",
    "image_to_scene": "s_i2s",
    "text_physics": "physical_t2s",
    "repair_f1": "repair_f1",
    "image_physics": "physical_i2s",
}
"""What the study of main results calls them: these have intervals."""
COST: Final = "usd_per_case"


def pages(site: SiteContext) -> Iterator[SitePage]:
    """The one page."""
    yield SitePage(
        links.LEADERBOARD,
        "leaderboard.html.j2",
        lambda: {"told": [_told(site, board) for board in site.boards], "caveats": CAVEATS},
        site.stamp(),
        navigation="Leaderboard",
    )


def _told(site: SiteContext, board: Board) -> dict[str, Any]:
    main, costs = site.answer(board, "main-results"), site.answer(board, "costs")
    profiles = site.answer(board, "profiles")
    priced = frontier(board, main, costs)
    return {
        "board": board,
        "main": main,
        "ends": _ends(main),
        "grid": standings_grid(board.standings, main, costs),
        "costs": costs,
        "overall": len({is_construction(case["setting"]) for case in board.cases}) > 1,
        "intervals": any(one.honest for one in main.findings.intervals),
        "frontier": priced,
        "timed": None if priced else timed(board, main),
        "zero_trials": partial(_zero_trials, board),
        "most_zeros": MOST_ZEROS,
        "profiles": profiles,
        "heat": [
            grid(table, heat=True, order=board.order)
            for table in profiles.findings.tables
            if table.name in HEAT and table.rows
        ],
        "private": grid(_table("private", "Private cases", [row.plain() for row in board.private])),
    }


MOST_ZEROS: Final = 6
"""Cases that are named beside a reason."""
HEAT: Final = ("categories", "families")
"""Tables of profiles: operation categories, requirement families."""


def standings_grid(standings: list[Row], main: Answer, costs: Answer) -> Grid:
    """A row a configuration: scores with their intervals where they are honest, and the cost of a case."""
    ends = _ends(main)
    usd = {str(row["configuration"]): row[COST] for row in costs.rows("costs_public")}
    rows = []
    for standing in standings:
        row = {name: standing[name] for name in ("configuration", "ranked", *SCORES)}
        own = ends.get(standing["configuration"], {})
        for name, studied in STUDIED.items():
            row |= {f"{name}_{end}": own.get(f"{studied}_{end}") for end in ("low", "high")}
        rows.append({**row, COST: usd.get(standing["configuration"])})
    return grid(_table("standings", "Leaderboard", rows, cost=bool(usd)))


def _table(name: str, title: str, rows: list[Row], *, cost: bool = False) -> Table:
    columns = [Column(name=key, title=told, unit="score", decimals=3, marks="high") for key, told in SCORES.items()]
    if cost:
        columns.append(Column(name=COST, title="USD a case", unit="USD", decimals=2, marks="low"))
    return Table(name=name, title=title, columns=columns, rows=rows)


def frontier(board: Board, main: Answer, costs: Answer) -> Scatter | None:
    """Cost and score of each configuration; None where nothing is priced."""
    ends = _ends(main)
    axis = "s_model" if any(row.get("s_model") is not None for row in costs.rows("costs_public")) else "score"
    dots = [
        Dot(
            name=str(row["configuration"]),
            x=float(row[COST]),
            y=float(row[axis]),
            low=ends.get(str(row["configuration"]), {}).get(f"{axis}_low"),
            high=ends.get(str(row["configuration"]), {}).get(f"{axis}_high"),
            strong=row["frontier"] == "frontier",
            link=links.configuration(board, str(row["configuration"])),
        )
        for row in costs.rows("costs_public")
        if row[COST] is not None and row.get(axis) is not None
    ]
    return scatter(dots, "estimated USD a case (logarithmic)", "overall score" if axis == "s_model" else "mean score")


def timed(board: Board, main: Answer) -> Scatter | None:
    """Mean time and score of each configuration: what stands for cost where nothing is priced. None without a time."""
    ends, found = _ends(main), []
    whole = all(row["model_score"] is not None for row in board.standings if row["ranked"])
    for standing in board.standings:
        name = str(standing["configuration"])
        trials = [trial for case in board.cases for trial in case["scores"].get(name, [])]
        scores = [trial["score"] for trial in trials]
        seconds = [trial["attempt_wall_s"] for trial in trials if trial["attempt_wall_s"] is not None]
        score = standing["model_score"] if whole else None if None in scores or not scores else fmean(scores)
        if score is not None and seconds and fmean(seconds) > 0:
            own = ends.get(name, {}) if whole else {}
            found.append((standing, float(score), fmean(seconds), own.get("s_model_low"), own.get("s_model_high")))
    ranked = np.array([bool(standing["ranked"]) for standing, *_ in found])
    times = np.where(ranked, np.array([seconds for _, _, seconds, *_ in found]), np.nan)
    best = orders.frontier(np.array([score for _, score, *_ in found]), times) if found else ()
    dots = [
        Dot(
            name=str(standing["configuration"]),
            x=seconds,
            y=score,
            low=low,
            high=high,
            strong=place in best,
            link=links.configuration(board, str(standing["configuration"])),
        )
        for place, (standing, score, seconds, low, high) in enumerate(found)
    ]
    return scatter(dots, "mean seconds a case (logarithmic)", "overall score" if whole else "mean score")


def _ends(main: Answer) -> dict[str, Row]:
    """Each configuration's scores with their intervals."""
    return {str(row["configuration"]): row for row in main.rows("main")}


def _zero_trials(board: Board, zero: Row) -> list[Row]:
    """The first trials that a reason was told of."""
    same = ("configuration", "setting", "status", "reason_code")
    trials = [
        trial
        for case in board.cases
        for trial in case["scores"].get(zero["configuration"], [])
        if all(trial[name] == zero[name] for name in same)
    ]
    return trials[:MOST_ZEROS]
