"""The DuckDB file of views over the Parquet parts. It can be deleted and rebuilt at any time."""

from __future__ import annotations

import fcntl
import os
import re
from pathlib import Path
from typing import Any

import duckdb

from c4s.errors import BadInput
from c4s.files import no_place
from c4s.protocol.settings import INDOOR_REPAIR, OUTDOOR_REPAIR, SETTING_TITLES, SETTINGS, is_construction
from warehouse.damage import broken_rows, refused
from warehouse.parquet import arrow_schema
from warehouse.records import TABLES

SQL = Path(__file__).parent / "sql"
FOUNDATIONS = ("trials", "case_scores", "setting_means", "leaderboards")
"""Questions that others build on, in this order."""
MEMORY, THREADS = "4GB", 4
"""What a question may take."""
_LIMITS: dict[str, str | bool | int | float | list[str]] = {
    "memory_limit": MEMORY,
    "threads": THREADS,
    "temp_directory": "",
    "python_enable_replacements": False,
    "autoinstall_known_extensions": False,
    "autoload_known_extensions": False,
}
_ASKING = (duckdb.StatementType.SELECT, duckdb.StatementType.EXPLAIN)
_TYPES = {"string": "VARCHAR", "int64": "BIGINT", "double": "DOUBLE", "bool": "BOOLEAN", "binary": "BLOB"}


def questions() -> list[str]:
    """Names of the questions that have a ``.sql`` file."""
    return sorted(path.stem for path in SQL.glob("*.sql"))


def _table_view(root: Path, table: str) -> str:
    """A view over a table's parts; an empty relation of the right columns where none was written yet."""
    columns = ", ".join(
        f'CAST("{field.name}" AS {_TYPES[str(field.type)]}) AS "{field.name}"' for field in arrow_schema(table)
    )
    if any((root / table).glob("suite=*/configuration=*/*.parquet")):
        pattern = str(root / table / "*" / "*" / "*.parquet").replace("'", "''")
        source = f"read_parquet('{pattern}', hive_partitioning = true, hive_types_autocast = false)"
        return f"CREATE VIEW {table} AS SELECT {columns} FROM {source}"
    nulls = ", ".join(f'NULL AS "{field.name}"' for field in arrow_schema(table))
    return f"CREATE VIEW {table} AS SELECT {columns} FROM (SELECT {nulls}) WHERE false"


def _settings_view() -> str:
    """The settings of the benchmark as rows, so that a question need not spell their names."""
    rows = ", ".join(
        f"('{name}', '{SETTING_TITLES[name]}', {is_construction(name)}, {name == INDOOR_REPAIR}, "
        f"{name == OUTDOOR_REPAIR})"
        for name in SETTINGS
    )
    return (
        "CREATE VIEW settings AS SELECT * FROM "
        f"(VALUES {rows}) AS v(setting, title, construction, indoor_repair, outdoor_repair)"
    )


def rebuild(root: Path) -> Path:
    """Make ``c4s.duckdb`` anew: one view a table and one a question. Atomic; returns the file.

    ``BadInput`` where rows are there that another version of c4s wrote.
    """
    root.mkdir(parents=True, exist_ok=True)
    target, fresh = root / "c4s.duckdb", root / f".c4s.duckdb.{os.getpid()}"
    with (root / ".rebuild.lock").open("a") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        for left in root.glob(f".{target.name}.*"):
            left.unlink()
        try:
            with duckdb.connect(str(fresh)) as connection:
                _make_views(connection, root)
            fresh.replace(target)
        except OSError as error:
            raise BadInput(
                f"it cannot be replaced: {no_place(error)}", where=str(target), todo="delete it, then run `c4s report`"
            ) from None
        finally:
            fresh.unlink(missing_ok=True)
    return target


def _make_views(connection: duckdb.DuckDBPyConnection, root: Path) -> None:
    for table in TABLES:
        try:
            connection.execute(_table_view(root, table))
        except duckdb.Error as error:
            raise broken_rows(root, error) from None
    connection.execute(_settings_view())
    for name in (*FOUNDATIONS, *(question for question in questions() if question not in FOUNDATIONS)):
        connection.execute(f"CREATE VIEW {name} AS {(SQL / f'{name}.sql').read_text()}")


def is_sound(root: Path) -> bool:
    """Whether ``c4s.duckdb`` is there, of this place, and answers every question."""
    try:
        with connect(root) as connection:
            found = {name for (name,) in connection.execute("SELECT view_name FROM duckdb_views()").fetchall()}
    except (BadInput, duckdb.Error):
        return False
    return found >= {*TABLES, *questions()}


def connect(root: Path) -> duckdb.DuckDBPyConnection:
    """A read-only connection that reads no file but the warehouse's own, inside ``MEMORY`` and ``THREADS``.

    None of it can be changed from within. ``BadInput`` where there is no warehouse, or its file is damaged or in use.
    """
    path = root / "c4s.duckdb"
    if not path.exists():
        raise BadInput("no warehouse here yet", where=str(root), todo="run `c4s run` or `c4s report` first")
    try:
        connection = duckdb.connect(str(path), read_only=True, config=_LIMITS)
        views = connection.execute("SELECT sql FROM duckdb_views() WHERE contains(sql, 'read_parquet(')").fetchall()
    except duckdb.Error as error:
        holder = re.search(r"PID (\d+)", str(error))
        if holder:
            raise BadInput(
                f"process {holder[1]} has it open for writing", where=str(path), todo="close it there, then ask again"
            ) from None
        raise BadInput(
            "this is no file of DuckDB, or a damaged one", where=str(path), todo="delete it, then run `c4s report`"
        ) from None
    if not all(str(root).replace("'", "''") in sql for (sql,) in views):
        raise BadInput("the warehouse was moved since this file was made", where=str(path), todo="run `c4s report`")
    place = str(root.absolute()).replace("'", "''")
    connection.execute(f"SET allowed_directories = ['{place}']")
    connection.execute("SET enable_external_access = false")
    connection.execute("SET lock_configuration = true")
    return connection


def ask(root: Path, sql: str, *, where: str = "query") -> tuple[list[str], list[tuple[Any, ...]]]:
    """Column names and rows of one ``SELECT`` or ``EXPLAIN``.

    ``BadInput``, with ``where`` before it, for any other query, and for one that DuckDB refuses, in its words; for rows
    that cannot be read it names their file and the command that makes it anew.
    """
    with connect(root) as connection:
        try:
            if not sql.isascii():
                sql.encode()
            statements = connection.extract_statements(sql)
            if len(statements) != 1:
                told = f"these are {len(statements)} queries" if statements else "the query is empty"
                raise BadInput(told, where=where, todo="ask one")
            if statements[0].type not in _ASKING:
                raise BadInput("a question only reads", where=where, todo="SELECT ...")
            cursor = connection.execute(statements[0])
            columns = [column[0] for column in cursor.description or []]
            return columns, cursor.fetchall()
        except UnicodeEncodeError:
            raise BadInput("it is not UTF-8 text", where=where) from None
        except duckdb.Error as error:
            raise refused(root, error, where, [*TABLES, *questions()]) from None


def rows(root: Path, sql: str) -> list[dict[str, Any]]:
    """The rows of a query as dictionaries."""
    columns, found = ask(root, sql)
    return [dict(zip(columns, row, strict=True)) for row in found]
