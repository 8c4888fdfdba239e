"""Asking the DuckDB file of the warehouse. It can be deleted and rebuilt at any time."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, nullcontext
from contextvars import ContextVar
from pathlib import Path
from typing import Any

import duckdb
import pyarrow as pa

from c4s.errors import BadInput
from warehouse.damage import broken_part, refused
from warehouse.records import TABLES
from warehouse.refresh import NAME, catch_up, is_current, open_books, rebuild
from warehouse.tables import questions

__all__ = [
    "arrow",
    "ask",
    "catch_up",
    "columns_of",
    "connect",
    "held_open",
    "is_current",
    "questions",
    "rebuild",
    "rows",
]

_HELD: ContextVar[tuple[Path, duckdb.DuckDBPyConnection] | None] = ContextVar("held", default=None)
_EXPLAIN = re.compile(r"\s*EXPLAIN\b\s*(?:ANALYZE\b\s*)?(?:\(\s*(?:ANALYZE|FORMAT)\b[^()]*\))?", re.IGNORECASE)


def connect(root: Path, allow: Sequence[Path] = ()) -> duckdb.DuckDBPyConnection:
    """A read-only connection that reads no file but the warehouse's own and those below the folders ``allow``.

    It is inside ``MEMORY`` and ``THREADS``, and none of this can be changed from within. ``BadInput`` where there is no
    warehouse, its file is damaged or in use, or ``allow`` names no folder.
    """
    for folder in allow:
        if not folder.is_dir():
            raise BadInput("there is no such folder", where=str(folder), todo="--allow takes a folder")
    path = root / NAME
    if not path.exists():
        raise _unusable(root, "no warehouse here yet", root, "run `c4s run` or `c4s report` first")
    try:
        connection, books = open_books(path)
    except duckdb.Error as error:
        holder = re.search(r"PID (\d+)", str(error))
        if holder:
            raise BadInput(
                f"process {holder[1]} has it open for writing", where=str(path), todo="close it there, then ask again"
            ) from None
        raise _damaged(root) from None
    if books is None:
        raise _unusable(root, "another version of c4s made this file", path, "run `c4s report`")
    if books.place != str(root.absolute()):
        raise _unusable(root, "the warehouse was moved since this file was made", path, "run `c4s report`")
    places = ", ".join("'" + str(one.absolute()).replace("'", "''") + "'" for one in (root, *allow))
    connection.execute(f"SET allowed_directories = [{places}]")
    connection.execute("SET enable_external_access = false")
    connection.execute("SET lock_configuration = true")
    return connection


@contextmanager
def held_open(root: Path, allow: Sequence[Path] = ()) -> Iterator[None]:
    """Within it every question of this thread is asked over one connection, of the warehouse as it was at its begin.

    For many questions in a row: to open the file takes longer than most of them. ``allow``: as of ``connect``.
    """
    with connect(root, allow) as connection:
        token = _HELD.set((root.absolute(), connection))
        try:
            yield
        finally:
            _HELD.reset(token)


def _damaged(root: Path) -> BadInput:
    return _unusable(
        root, "this is no file of DuckDB, or a damaged one", root / NAME, "delete it, then run `c4s report`"
    )


def _unusable(root: Path, what: str, where: Path, todo: str) -> BadInput:
    """Why there is nothing to ask; where the rows are what `c4s report` would refuse, it is they."""
    return broken_part(root, TABLES, whole=False) or BadInput(what, where=str(where), todo=todo)


def ask(root: Path, sql: str, *, where: str = "query") -> tuple[list[str], list[tuple[Any, ...]]]:
    """Column names and rows of one ``SELECT`` or ``EXPLAIN``.

    ``BadInput``, with ``where`` before it, for any other query, and for one that DuckDB refuses, in its words; for rows
    that cannot be read it names their file and the command that makes it anew.
    """
    with _asked(root, sql, where) as (connection, statement):
        cursor = connection.execute(statement)
        return [column[0] for column in cursor.description or []], cursor.fetchall()


def arrow(root: Path, sql: str, *, where: str = "query") -> pa.Table:
    """The same as an Arrow table."""
    with _asked(root, sql, where) as (connection, statement):
        return connection.sql(statement.query).to_arrow_table()


@contextmanager
def _asked(root: Path, sql: str, where: str) -> Iterator[tuple[duckdb.DuckDBPyConnection, duckdb.Statement]]:
    held = _HELD.get()
    over = nullcontext(held[1]) if held is not None and held[0] == root.absolute() else connect(root)
    with over as connection:
        try:
            if not sql.isascii():
                sql.encode()
            statements = connection.extract_statements(sql)
            if len(statements) != 1:
                told = f"these are {len(statements)} queries" if statements else "the query is empty"
                raise BadInput(told, where=where, todo="ask one")
            if not _only_reads(connection, statements[0]):
                raise BadInput("a question only reads", where=where, todo="SELECT ...")
            yield connection, statements[0]
        except UnicodeEncodeError:
            raise BadInput("it is not UTF-8 text", where=where) from None
        except duckdb.IOException as error:
            if NAME in str(error) or "database file" in str(error):
                raise _damaged(root / NAME) from None
            raise refused(root, error, where, [*TABLES, *questions()]) from None
        except duckdb.Error as error:
            raise refused(root, error, where, [*TABLES, *questions()]) from None


def _only_reads(connection: duckdb.DuckDBPyConnection, statement: duckdb.Statement) -> bool:
    """Whether it is a ``SELECT``, or an ``EXPLAIN`` of one: ``EXPLAIN ANALYZE COPY`` would write its file."""
    if statement.type == duckdb.StatementType.EXPLAIN:
        explain = _EXPLAIN.match(statement.query)
        explained = connection.extract_statements(statement.query[explain.end() :]) if explain else []
        return [one.type for one in explained] == [duckdb.StatementType.SELECT]
    return statement.type == duckdb.StatementType.SELECT


def columns_of(root: Path) -> dict[str, dict[str, str]]:
    """The columns of every table and question with their DuckDB types, tables first."""
    found: dict[str, dict[str, str]] = {name: {} for name in (*TABLES, *questions())}
    sql = "SELECT table_name, column_name, data_type FROM duckdb_columns() WHERE NOT internal AND schema_name = 'main'"
    for table, column, kind in ask(root, sql)[1]:
        found.setdefault(table, {})[column] = kind
    return found


def rows(root: Path, sql: str) -> list[dict[str, Any]]:
    """The rows of a query as dictionaries."""
    columns, found = ask(root, sql)
    return [dict(zip(columns, row, strict=True)) for row in found]
