"""The status page of a run: one file with its style in it, that loads itself again while the run goes."""

from __future__ import annotations

import os
from datetime import datetime
from pathlib import Path

from markupsafe import Markup

from c4s.files import write_text
from c4s.names import shown
from c4s.records.progress import Snapshot
from reports.frame import STATIC, environment
from reports.text import clock, span

REFRESH_S = 5
"""How often the page is written and loads itself again."""
MOST_RUNNING = 64
"""Rows of stages in work that are shown; the rest is counted."""


def write_status(now: Snapshot, page: Path, leaderboard: Path) -> None:
    """Write a run's status page: whole or not at all.

    Args:
        now: how far the run is.
        page: the file.
        leaderboard: the site's first page, which is linked where it is there.
    """
    made = environment().get_template("status.html.j2")
    link = os.path.relpath(leaderboard, page.parent) if leaderboard.is_file() else None
    write_text(
        page,
        made.render(
            root="",
            now=now,
            link=link,
            going=now.going,
            refresh_s=REFRESH_S,
            style=_styles("style.css", "tables.css"),
            print_style=_styles("print.css"),
            written=datetime.fromtimestamp(now.time).astimezone().strftime("%Y-%m-%d %H:%M:%S %Z"),
            ends=clock(now.time + now.left_s) if now.left_s is not None else None,
            deadline=clock(now.deadline) if now.deadline is not None else None,
            span=span,
            shown=shown,
            most_running=MOST_RUNNING,
        ),
    )


def _styles(*names: str) -> Markup:
    return Markup("".join((STATIC / name).read_text(encoding="utf-8") for name in names))
