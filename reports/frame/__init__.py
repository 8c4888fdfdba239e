"""What all pages share: what they are made of, how one is told, how they link to each other, the templates."""

from __future__ import annotations

from reports.frame import links
from reports.frame.board import Board, boards
from reports.frame.context import SiteContext, SitePicture
from reports.frame.page import SitePage
from reports.frame.sources import code_digest
from reports.frame.studies import Answer, Grid, grid
from reports.frame.templates import STATIC, environment

__all__ = [
    "STATIC",
    "Answer",
    "Board",
    "Grid",
    "SiteContext",
    "SitePage",
    "SitePicture",
    "boards",
    "code_digest",
    "environment",
    "grid",
    "links",
]
