"""A run's progress as a scheduler shows it on its own pages: rows of a table and links, as plain data."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from c4s.records.folder import RunFolder
from c4s.records.progress import Snapshot


def rows(now: Snapshot) -> list[dict[str, Any]]:
    """A row a configuration: done, pending, mean score so far (no result), cost."""
    return [
        {
            "agent": row.configuration,
            "done": f"{row.done}/{row.planned}",
            "pending": row.pending,
            "score so far": None if row.mean_score is None else round(row.mean_score, 4),
            "cost in USD": row.cost_usd,
        }
        for row in now.standings
    ]


def summary(now: Snapshot) -> str:
    """The run in a line: state, counts, why it stops."""
    told = f"{now.state}: {now.done} of {now.planned} trials done, {now.pending} pending, {now.waiting} waiting"
    return f"{told}; {now.why}" if now.why else told


def links(run: RunFolder, leaderboard: Path) -> dict[str, str]:
    """Addresses of the run's status page and of the leaderboard, by what they are called."""
    return {"status page": run.status_page.absolute().as_uri(), "leaderboard": leaderboard.absolute().as_uri()}
