"""Query results as pandas frames and files, for analysts who go on elsewhere."""

from __future__ import annotations

import io
from pathlib import Path
from typing import Any

import pandas as pd
import pyarrow as pa

from c4s.errors import BadInput
from c4s.files import write_bytes
from c4s.folders import check_out
from warehouse.database import ask

ENDINGS = (".csv", ".parquet")
FORMULA = ("=", "+", "-", "@", "\t", "\r")
"""A text that begins so is computed by spreadsheets: in a CSV file an apostrophe stands before it."""


def frame(root: Path, sql: str, *, where: str = "query") -> pd.DataFrame:
    """The rows of a query as a data frame."""
    columns, rows = ask(root, sql, where=where)
    return pd.DataFrame(rows, columns=columns)


def export(root: Path, sql: str, out: Path, *, replace: bool = False, where: str = "query") -> int:
    """Write the rows of a query to a ``.csv`` or ``.parquet`` file and count them.

    In a CSV file no text is a formula (``FORMULA``). ``BadInput`` for another ending, and where a file lies at ``out``
    that is not to be replaced, or anything else.
    """
    if out.suffix not in ENDINGS:
        raise BadInput(
            f"cannot write {out.suffix or 'a file without ending'}", where=str(out), todo=f"one of {', '.join(ENDINGS)}"
        )
    check_out(out, replace=replace)
    found, made = frame(root, sql, where=where), io.BytesIO()
    twice = sorted({name for name in found.columns if list(found.columns).count(name) > 1})
    if twice:
        raise BadInput(f"two columns are called {twice[0]!r}", where=str(out), todo="name them apart with AS")
    try:
        if out.suffix == ".csv":
            found.map(_no_formula).rename(columns=_no_formula).to_csv(made, index=False)
        else:
            found.to_parquet(made, index=False)
    except (pa.ArrowException, ValueError, TypeError) as error:
        raise BadInput(f"these rows cannot be written: {error}", where=str(out), todo="cast their columns") from None
    write_bytes(out, made.getvalue())
    return len(found)


def _no_formula(value: Any) -> Any:
    return f"'{value}" if isinstance(value, str) and value.startswith(FORMULA) else value
