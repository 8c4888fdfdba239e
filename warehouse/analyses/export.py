"""Tables of an analysis as CSV files."""

from __future__ import annotations

from pathlib import Path

import pandas as pd

from c4s.files import write_text
from c4s.records.analysis import Table
from warehouse.frames import no_formula


def write_tables(tables: list[Table], folder: Path) -> list[Path]:
    """Write ``<table>.csv`` of each table into a folder: its columns by name, numbers unrounded, no text a formula."""
    written = []
    for table in tables:
        names = [column.name for column in table.columns]
        rows = pd.DataFrame([[row.get(name) for name in names] for row in table.rows], columns=names, dtype=object)
        path = folder / f"{table.name}.csv"
        write_text(path, rows.map(no_formula).to_csv(index=False))
        written.append(path)
    return written
