"""The DuckDB file of views over the Parquet parts. It can be deleted and rebuilt at any time."""

from __future__ import annotations

import fcntl
import os
from pathlib import Path
from typing import Any

import duckdb

from c4s.errors import BadInput
from c4s.protocol.settings import INDOOR_REPAIR, OUTDOOR_REPAIR, SETTING_TITLES, SETTINGS, is_construction
from warehouse.parquet import arrow_schema
from warehouse.records import TABLES

SQL = Path(__file__).parent / "sql"
FOUNDATIONS = ("case_scores", "setting_means")
"""Questions that others build on, in this order."""
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
    with (root / ".rebuild.lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        fresh.unlink(missing_ok=True)
        with duckdb.connect(str(fresh)) as connection:
            for table in TABLES:
                try:
                    connection.execute(_table_view(root, table))
                except duckdb.BinderException:
                    raise BadInput(
                        f"the rows of table {table!r} have other columns: another version of c4s wrote them",
                        where=str(root),
                        todo="delete this folder and run `c4s report --from-runs`",
                    ) from None
            connection.execute(_settings_view())
            for name in (*FOUNDATIONS, *(question for question in questions() if question not in FOUNDATIONS)):
                connection.execute(f"CREATE VIEW {name} AS {(SQL / f'{name}.sql').read_text()}")
        fresh.replace(target)
    return target


def connect(root: Path) -> duckdb.DuckDBPyConnection:
    """A read-only connection. ``BadInput`` where there is no warehouse."""
    path = root / "c4s.duckdb"
    if not path.is_file():
        raise BadInput("no warehouse here yet", where=str(root), todo="run `c4s run` or `c4s report` first")
    return duckdb.connect(str(path), read_only=True)


def ask(root: Path, sql: str) -> tuple[list[str], list[tuple[Any, ...]]]:
    """Column names and rows of a query; a query that DuckDB refuses is ``BadInput`` with DuckDB's own words."""
    with connect(root) as connection:
        try:
            cursor = connection.execute(sql)
        except duckdb.Error as error:
            raise BadInput(str(error).splitlines()[0], where="query") from None
        columns = [column[0] for column in cursor.description or []]
        return columns, cursor.fetchall()


def rows(root: Path, sql: str) -> list[dict[str, Any]]:
    """The rows of a query as dictionaries."""
    columns, found = ask(root, sql)
    return [dict(zip(columns, row, strict=True)) for row in found]
