"""Where each page lies: paths below the site. A template writes ``{{ root }}{{ links.case(board, case_id) }}``."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

if TYPE_CHECKING:
    from reports.frame.board import Board, Row

LEADERBOARD: Final = "index.html"
ABOUT: Final = "about.html"
LIMITS: Final = "limits.html"
RELATED: Final = "related.html"
CHEATS: Final = "cheats.html"
METHODS: Final = "methods.html"
DATA: Final = "data.html"
RELEASE: Final = "release.html"


def configuration(board: Board, name: str) -> str:
    """A configuration's page."""
    return f"agents/{board.page(name)}"


def case(board: Board, case_id: str) -> str:
    """A case's page; ``#<slug of a configuration>`` leads to its row."""
    return f"cases/{board.page(case_id)}"


def trial(board: Board, row: Row) -> str:
    """The page of a trial, by its row."""
    return "trials/" + board.page(f"{row['case_id']}--{row['configuration']}--r{row['repeat']}")


def cases(board: Board) -> str:
    """All cases of a leaderboard by configuration."""
    return f"boards/{board.page('cases')}"


def diagnostics(board: Board) -> str:
    """What stands behind the scores of a leaderboard."""
    return f"boards/{board.page('diagnostics')}"


def compare(board: Board) -> str:
    """Two configurations compared; ``#a=<one>&b=<other>`` names them."""
    return f"boards/{board.page('compare')}"
