"""The leaderboard: the site's first page."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, Final

from c4s.records.analysis import Column, Table
from reports.drawing import Dot, Scatter, scatter
from reports.frame import Board, Grid, SiteContext, SitePage, grid, links
from reports.frame.board import Row
from reports.frame.studies import Answer
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
        lambda: {"told": [_told(site, board) for board in site.boards]},
        site.stamp(),
        navigation="Leaderboard",
    )


def _told(site: SiteContext, board: Board) -> dict[str, Any]:
    main, costs = site.answer(board, "main-results"), site.answer(board, "costs")
    profiles = site.answer(board, "profiles")
    return {
        "board": board,
        "main": main,
        "ends": {str(row["configuration"]): row for row in main.rows("main")},
        "grid": standings_grid(board.standings, main, costs),
        "costs": costs,
        "frontier": frontier(board, main, costs),
        "profiles": profiles,
        "heat": [
            grid(table, heat=True, order=board.order)
            for table in profiles.findings.tables
            if table.name in HEAT and table.rows
        ],
        "private": grid(_table("private", "Private cases", [row.plain() for row in board.private])),
    }


HEAT: Final = ("categories", "families")
"""Tables of profiles: operation categories, requirement families."""


def standings_grid(standings: list[Row], main: Answer, costs: Answer) -> Grid:
    """A row a configuration: scores with their intervals where they are honest, and the cost of a case."""
    ends = {str(row["configuration"]): row for row in main.rows("main")}
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
    ends = {str(row["configuration"]): row for row in main.rows("main")}
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
