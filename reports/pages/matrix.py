"""All cases of a leaderboard by configuration."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from typing import Any

from reports.frame import Board, SiteContext, SitePage, links
from reports.frame.board import Row


def pages(site: SiteContext) -> Iterator[SitePage]:
    """A page a leaderboard; the first one's is in the navigation."""
    for place, board in enumerate(site.boards):
        title = "" if place else "Cases"
        yield SitePage(
            links.cases(board), "matrix.html.j2", partial(_values, site, board), site.stamp(board), navigation=title
        )


def _values(site: SiteContext, board: Board) -> dict[str, Any]:
    hard = {str(row["case"]): row for row in site.answer(board, "case-difficulty").rows("cases")}
    return {
        "board": board,
        "boards": site.boards,
        "cases": [
            {
                **case,
                "means": [mean_of(case["scores"].get(name, [])) for name in board.order],
                "zeros": [_zeros(case["scores"].get(name, [])) for name in board.order],
                "difficulty": hard.get(case["case_id"], {}).get("difficulty"),
                "spread": hard.get(case["case_id"], {}).get("spread"),
            }
            for case in board.cases
        ],
        "settings": sorted({case["setting"] for case in board.cases}),
        "difficulty": site.answer(board, "case-difficulty"),
    }


def mean_of(trials: list[Row]) -> float | None:
    """The mean score over repeats; None where one is pending, or there is none."""
    scores = [trial["score"] for trial in trials]
    return None if not scores or None in scores else sum(scores) / len(scores)


def _zeros(trials: list[Row]) -> str:
    """Why trials are worth zero without a measurement; empty where none is."""
    return "; ".join(
        (trial["reason"] or trial["status"]) for trial in trials if str(trial["status"]).startswith("zero")
    )
