"""What DuckDB refuses, in one line: a query that is wrong, or rows that cannot be read and how to have them again."""

from __future__ import annotations

import re
from collections.abc import Iterable
from pathlib import Path

import duckdb
import pyarrow as pa
import pyarrow.parquet as pq

from c4s.errors import BadInput, unknown
from c4s.files import no_place
from warehouse.parquet import arrow_schema

UNHELD = ("pictures", "calls", "scenes", "shapes")
"""Tables whose rows stay in their parts: a question reads them there."""
REMEDY = "delete it, then run `c4s report --from-runs`"
_OUTSIDE = re.compile(r'Cannot access (?:file|directory) "(.*)" - file system operations are disabled')
_NO_FILE = re.compile(r'No files found that match the pattern "(.*)"')
_NO_TABLE = re.compile(r"Table with name (.+?) does not exist")


def refused(root: Path, error: duckdb.Error, where: str, names: Iterable[str]) -> BadInput:
    """What a query that DuckDB refuses comes of: rows that cannot be read, else the query itself.

    Rows that the database holds were read when it took them; here it is about those that stay in their parts. For an
    error that may speak of types or columns only the files' schemas are looked at; else all is read.
    """
    if outside := _OUTSIDE.search(str(error)):
        return BadInput(
            f"a question reads the warehouse and no other file, not {outside[1]!r}",
            where=where,
            todo="c4s sql --allow FOLDER lets it read a folder of yours",
        )
    if (missing := _NO_FILE.search(str(error))) and not Path(missing[1]).is_relative_to(root.absolute()):
        return BadInput(f"there is no file {missing[1]!r}", where=where)
    if not isinstance(error, duckdb.ParserException | duckdb.CatalogException):
        whole = not isinstance(error, duckdb.BinderException | duckdb.ConversionException)
        damaged = broken_part(root, UNHELD, whole=whole)
        if damaged is not None or "No files found" in str(error):
            return damaged or broken_rows(root, error)
    text = " ".join(str(error).partition("\n\nLINE")[0].split())
    if table := _NO_TABLE.search(text):
        return unknown("table or question", table[1], names, where=where)
    return BadInput(_told(error), where=where)


def broken_rows(root: Path, error: duckdb.Error) -> BadInput:
    """What keeps the tables from being read."""
    return broken_part(root, UNHELD, whole=True) or BadInput(
        f"rows are missing: {_told(error)}", where=str(root), todo="`c4s report --from-runs` writes them anew"
    )


def broken_part(root: Path, tables: Iterable[str], *, whole: bool) -> BadInput | None:
    """The first part of the tables that cannot be read, or has other columns. ``whole``: its rows are read too."""
    for table in tables:
        for path in sorted((root / table).glob("suite=*/configuration=*/*.parquet")):
            try:
                _opened(table, path, whole=whole)
            except BadInput as error:
                return error
    return None


def read_part(table: str, path: Path) -> pa.Table:
    """The rows of a part, without the columns of its partition.

    ``BadInput`` for a part that cannot be read, or has other columns than its table.
    """
    return _opened(table, path, whole=True)


def _opened(table: str, path: Path, *, whole: bool) -> pa.Table | None:
    try:
        file = pq.ParquetFile(path)
        found = {field.name: field.type for field in file.schema_arrow}
        rows = file.read(use_threads=False) if whole else None
    except (pa.ArrowException, ValueError) as fault:
        raise BadInput(f"these rows cannot be read: {_told(fault)}", where=str(path), todo=REMEDY) from None
    except OSError as fault:
        raise BadInput(f"these rows cannot be read: {no_place(fault)}", where=str(path), todo=REMEDY) from None
    if found != {field.name: field.type for field in arrow_schema(table, partitions=False)}:
        raise BadInput(
            f"the rows of table {table!r} have other columns: another version of c4s wrote them",
            where=str(path),
            todo="delete the warehouse, then run `c4s report --from-runs`",
        )
    return rows


def _told(fault: Exception) -> str:
    """The words of DuckDB or Arrow without the kind of their error and a drawing of the place."""
    text = " ".join(str(fault).partition("\n\nLINE")[0].split())
    text = re.sub(r"^[A-Z][A-Za-z ]+ Error: ", "", text)
    return re.sub(r"\b\w+(?:Error|Exception): ", "", text)
