"""What the database is made of: a table a kind of row, what is known of the parts, and a view a question."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from c4s.protocol.settings import INDOOR_REPAIR, OUTDOOR_REPAIR, SETTING_TITLES, SETTINGS, is_construction
from warehouse.damage import UNHELD
from warehouse.parquet import arrow_schema
from warehouse.parts import HELD

SQL = Path(__file__).parent / "sql"
FOUNDATIONS = ("trials", "case_scores", "setting_means", "leaderboards", "spatial_decisions")
"""Questions that others build on, in this order."""
KEPT = ("setting_means",)
"""Questions whose answer is kept as a table, made anew when rows change: a leaderboard is made of few rows then."""
ROWS = "stored"
"""Schema of the tables: rows as they were read, each with the number of its part, and what is known of the parts."""
BOOKS = (
    f"CREATE TABLE {ROWS}.made (tables VARCHAR, views VARCHAR, place VARCHAR)",
    f"CREATE TABLE {ROWS}.folders (folder VARCHAR, mtime_ns BIGINT)",
    f"CREATE TABLE {ROWS}.parts "
    "(part BIGINT, folder VARCHAR, name VARCHAR, size BIGINT, mtime_ns BIGINT, inode UBIGINT)",
)
_TYPES = {"string": "VARCHAR", "int64": "BIGINT", "double": "DOUBLE", "bool": "BOOLEAN", "binary": "BLOB"}


def questions() -> list[str]:
    """Names of the questions that have a ``.sql`` file."""
    return sorted(path.stem for path in SQL.glob("*.sql"))


def table_statements() -> list[str]:
    """What makes the empty tables."""
    made = [f"CREATE SCHEMA {ROWS}", *BOOKS]
    for table in HELD:
        columns = ", ".join(f'"{field.name}" {_TYPES[str(field.type)]}' for field in arrow_schema(table))
        made.append(f"CREATE TABLE {ROWS}.{table} (part BIGINT, {columns})")
    return made


def view_statements(root: Path) -> Iterator[tuple[str, str]]:
    """Each view by name, in an order in which it can be made, and what makes it."""
    for table in HELD:
        yield table, f"SELECT * EXCLUDE (part) FROM {ROWS}.{table}{_ONCE.get(table, '')}"
    for table in UNHELD:
        yield table, _parts_view(root, table)
    yield "settings", _settings_view()
    for name in (*FOUNDATIONS, *(question for question in questions() if question not in FOUNDATIONS)):
        yield name, question_text(name)


def question_text(name: str) -> str:
    """The SQL of a question."""
    return (SQL / f"{name}.sql").read_text()


_ONCE = {"schedule": " QUALIFY row_number() OVER (PARTITION BY trial_id ORDER BY planned_at, run_id, part) = 1"}
"""A trial that several runs planned is one row: of the plan that was frozen first."""


def _parts_view(root: Path, table: str) -> str:
    """A view over a table's parts; an empty relation of the right columns where none was written yet."""
    columns = ", ".join(
        f'CAST("{field.name}" AS {_TYPES[str(field.type)]}) AS "{field.name}"' for field in arrow_schema(table)
    )
    if any((root / table).glob("suite=*/configuration=*/*.parquet")):
        pattern = str(root / table / "*" / "*" / "*.parquet").replace("'", "''")
        source = f"read_parquet('{pattern}', hive_partitioning = true, hive_types_autocast = false)"
        return f"SELECT {columns} FROM {source}"
    nulls = ", ".join(f'NULL AS "{field.name}"' for field in arrow_schema(table))
    return f"SELECT {columns} FROM (SELECT {nulls}) WHERE false"


def _settings_view() -> str:
    """The settings of the benchmark as rows, so that a question need not spell their names."""
    rows = ", ".join(
        f"('{name}', '{SETTING_TITLES[name]}', {is_construction(name)}, {name == INDOOR_REPAIR}, "
        f"{name == OUTDOOR_REPAIR})"
        for name in SETTINGS
    )
    return f"SELECT * FROM (VALUES {rows}) AS v(setting, title, construction, indoor_repair, outdoor_repair)"
