"""The page of a case: its prompt and pictures, and what every configuration made of it, side by side."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from typing import Any

from c4s.protocol.settings import is_construction
from reports.case import case_rows, case_runs, higher_and_lower, matrix_of, pair_of, renders_of
from reports.frame import Board, SiteContext, SitePage, links
from reports.frame.board import Row
from reports.viewer import scene_part


def pages(site: SiteContext) -> Iterator[SitePage]:
    """A page a public case of each leaderboard."""
    for board in site.boards:
        for case in board.cases:
            made_of = site.stamp(board, case["case_id"])
            yield SitePage(
                links.case(board, case["case_id"]), "case.html.j2", partial(_values, site, board, case), made_of
            )


def _values(site: SiteContext, board: Board, case: Row) -> dict[str, Any]:
    pictures = site.pictures(board, case["case_id"])
    asked = case_rows(site, board, case["case_id"])
    runs = case_runs(board, case, asked.documents)
    pictured = frozenset(trial_id for (trial_id, role), found in pictures.items() if role == "submission" and found)
    pair = higher_and_lower(runs, pictured)
    return {
        "board": board,
        "case": case,
        "plan": asked.plan,
        "scene": scene_part(site, board, case),
        "start": pictures.get(("", "start"), []),
        "truth": pictures.get(("", "truth"), []),
        "runs": runs,
        "attempts": asked.attempts,
        "renders": renders_of(pictures, runs, construction=is_construction(case["setting"])),
        "matrix": matrix_of(asked, runs),
        "pair": pair_of(*pair, asked, pictures) if pair else None,
        "documents": asked.documents,
    }
