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

ENDINGS = (".csv", ".parquet", ".xlsx")
FORMULA = ("=", "+", "-", "@", "\t", "\r")
"""A text that begins so is computed by spreadsheets: in a CSV file an apostrophe stands before it."""


def frame(root: Path, sql: str, *, where: str = "query") -> pd.DataFrame:
    """The rows of a query as a data frame."""
    columns, rows = ask(root, sql, where=where)
    return pd.DataFrame(rows, columns=columns)


def export(root: Path, sql: str, out: Path, *, replace: bool = False, where: str = "query", name: str = "rows") -> int:
    """Write the rows of a query to a ``.csv``, ``.parquet`` or ``.xlsx`` file and count them.

    No text is a formula (``FORMULA``, ``warehouse.workbook``). ``BadInput`` for another ending, where a file lies at
    ``out`` that is not to be replaced, or anything else, and for more rows than a sheet holds.
    """
    if out.suffix not in ENDINGS:
        raise BadInput(
            f"cannot write {out.suffix or 'a file without ending'}", where=str(out), todo=f"one of {', '.join(ENDINGS)}"
        )
    check_out(out, replace=replace)
    columns, rows = ask(root, sql, where=where)
    twice = sorted({name for name in columns if columns.count(name) > 1})
    if twice:
        raise BadInput(f"two columns are called {twice[0]!r}", where=str(out), todo="name them apart with AS")
    if out.suffix == ".xlsx":
        from warehouse.workbook import workbook

        write_bytes(out, workbook(columns, rows, where=out, name=name))
        return len(rows)
    found, made = pd.DataFrame(rows, columns=columns), io.BytesIO()
    try:
        if out.suffix == ".csv":
            found.map(no_formula).rename(columns=no_formula).to_csv(made, index=False)
        else:
            found.to_parquet(made, index=False)
    except (pa.ArrowException, ValueError, TypeError) as error:
        raise BadInput(f"these rows cannot be written: {error}", where=str(out), todo="cast their columns") from None
    write_bytes(out, made.getvalue())
    return len(found)


def no_formula(value: Any) -> Any:
    """A value as a CSV file may hold it: a text that a spreadsheet would compute has an apostrophe before it."""
    return f"'{value}" if isinstance(value, str) and value.startswith(FORMULA) else value
