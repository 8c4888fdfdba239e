"""Answers to be taken away: the questions that keep public cases apart, each as a file of the site."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

from c4s.files import digest_bytes
from reports.frame import SiteContext
from reports.frame.board import PUBLIC
from warehouse.frames import frame, no_formula
from warehouse.manual import told_question

OFFERED: Final = ("leaderboard", "case_scores", "zero_reasons", "coverage")
"""Questions that have a column ``visibility``."""


@dataclass(frozen=True)
class DownloadFile:
    """A file of the site with the answer to a question, of public cases alone."""

    file: str
    question: str
    about: str
    rows: int
    bytes: int
    sha256: str


def put_downloads(site: SiteContext) -> list[DownloadFile]:
    """Write them, and tell what they are."""
    found = []
    for name in OFFERED:
        table = frame(site.warehouse, f"SELECT * FROM {name} WHERE {PUBLIC}")
        data = table.map(no_formula).to_csv(index=False).encode()
        digest = digest_bytes(data)
        file = site.put(f"data/{name}-{digest[:12]}.csv", data)
        found.append(DownloadFile(file, name, told_question(name), len(table), len(data), digest))
    return found
