"""Query results as pandas frames and files, for analysts who go on elsewhere."""

from __future__ import annotations

from pathlib import Path

import pandas as pd

from c4s.errors import BadInput
from warehouse.database import ask

WRITERS = {".csv": "to_csv", ".parquet": "to_parquet"}


def frame(root: Path, sql: str) -> pd.DataFrame:
    """The rows of a query as a data frame."""
    columns, rows = ask(root, sql)
    return pd.DataFrame(rows, columns=columns)


def export(root: Path, sql: str, out: Path) -> int:
    """Write the rows of a query to a ``.csv`` or ``.parquet`` file and count them. Another ending is ``BadInput``."""
    if out.suffix not in WRITERS:
        raise BadInput(
            f"cannot write {out.suffix or 'a file without ending'}", where=str(out), todo=f"one of {', '.join(WRITERS)}"
        )
    found = frame(root, sql)
    getattr(found, WRITERS[out.suffix])(out, index=False)
    return len(found)
