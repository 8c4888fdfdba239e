"""The kinds of pages, one module a kind: each tells its pages of a site."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Final

from reports.frame import SiteContext, SitePage
from reports.pages import case, compare, configuration, diagnostics, leaderboard, matrix, statements, trial

__all__ = ["KINDS"]

KINDS: Final[tuple[Callable[[SiteContext], Iterator[SitePage]], ...]] = (
    leaderboard.pages,
    matrix.pages,
    compare.pages,
    diagnostics.pages,
    statements.pages,
    configuration.pages,
    case.pages,
    trial.pages,
)
"""In the order of the navigation."""
