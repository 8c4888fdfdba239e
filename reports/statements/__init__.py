"""What the statement pages say that is a table or a list: one place for each."""

from __future__ import annotations

from reports.statements.caveats import CAVEATS
from reports.statements.cheats import cheat_tables
from reports.statements.downloads import DownloadFile, put_downloads
from reports.statements.manual import ManualTable, manual_tables
from reports.statements.related import COVERAGE, RELATED
from reports.statements.weights import weight_tables

__all__ = [
    "CAVEATS",
    "COVERAGE",
    "RELATED",
    "DownloadFile",
    "ManualTable",
    "cheat_tables",
    "manual_tables",
    "put_downloads",
    "weight_tables",
]
