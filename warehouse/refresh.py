"""Bringing the database up to its parts: what is new or changed is read, what is gone is taken out.

The file that questions read is never written: a copy takes what changed and is put in its place in one step. So a
reader sees the rows of one moment, stands in nobody's way, and a process that is killed leaves the file of before. One
process at a time makes a copy.
"""

from __future__ import annotations

import fcntl
import os
import shutil
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager, nullcontext, suppress
from dataclasses import dataclass
from itertools import groupby
from pathlib import Path

import duckdb
import pyarrow as pa

from c4s.errors import BadInput
from c4s.files import digest, no_place
from warehouse.columns import column, columns, no_rows
from warehouse.damage import broken_rows
from warehouse.parts import HELD, LISTED, Look, look, rows_of, table_of
from warehouse.tables import KEPT, ROWS, question_text, table_statements, view_statements

NAME = "c4s.duckdb"
LOCK = ".rebuild.lock"
MEMORY, THREADS = "4GB", 4
"""What a question, or taking in rows, may take."""
LIMITS: dict[str, str | bool | int | float | list[str]] = {
    "memory_limit": MEMORY,
    "threads": THREADS,
    "temp_directory": "",
    "python_enable_replacements": False,
    "autoinstall_known_extensions": False,
    "autoload_known_extensions": False,
}
AT_ONCE = 500
"""Parts whose rows are in memory at once."""
_NONE = no_rows(pa.schema([pa.field("part", pa.int64()), *LISTED]))
_FOLDERS = pa.schema([("folder", pa.string()), ("mtime_ns", pa.int64())])
_SAME = " AND ".join(f"p.{name} = f.{name}" for name in LISTED.names)


@dataclass(frozen=True)
class Books:
    """What a database says of itself."""

    views: str
    """Digest of what made its views."""
    place: str
    """The warehouse that it is of."""
    folders: dict[str, int]
    """Every folder of parts that it knows, with its time of change, or 0."""


@dataclass(frozen=True)
class _Due:
    """What a database does not hold yet, or still holds."""

    fresh: pa.Table
    """New and changed parts, as ``LISTED``, in order of their folders."""
    gone: pa.Table
    """Parts that are gone or changed, by their ``part``."""
    number: int
    """Of the next part."""

    @property
    def is_nothing(self) -> bool:
        """Whether the database holds all parts as they are."""
        return not (len(self.fresh) or len(self.gone))


def rebuild(root: Path) -> Path:
    """Bring ``c4s.duckdb`` up to the parts as they lie there, or make it anew where it is of no use; returns the file.

    Every part is looked at, those that changed are read. ``BadInput``, and the file stays as it was, where one cannot
    be read or was written by another version of c4s.
    """
    root.mkdir(parents=True, exist_ok=True)
    with (root / LOCK).open("a") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        try:
            try:
                _bring_up(root, trusting=False)
            except duckdb.Error:
                _bring_up(root, trusting=False, anew=True)
        except OSError as error:
            raise BadInput(
                f"it cannot be replaced: {no_place(error)}",
                where=str(root / NAME),
                todo="delete it, then run `c4s report`",
            ) from None
    return root / NAME


def catch_up(root: Path) -> None:
    """The same for a reader, who never waits: only folders that changed are looked at, and the file stays as it is
    where another process is at work on it, where it cannot be replaced, and where it is not there or of no use.

    ``BadInput`` for a part that cannot be read, or is gone.
    """
    with suppress(duckdb.Error), _reading(root) as opened:
        if opened is None or _due(*opened, look(root, opened[1].folders)).is_nothing:
            return
    with suppress(OSError, duckdb.Error), (root / LOCK).open("a") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        _bring_up(root, trusting=True)


def is_current(root: Path) -> bool:
    """Whether ``c4s.duckdb`` is there, of this place, answers every question, and holds all parts as they lie there."""
    with suppress(duckdb.Error), _reading(root) as opened:
        if opened is not None:
            connection, books = opened
            return books.views == _views_digest(root) and _due(connection, books, look(root, {})).is_nothing
    return False


def open_books(path: Path) -> tuple[duckdb.DuckDBPyConnection, Books | None]:
    """A database open for reading, and what it says of itself; None for one of another version.

    ``duckdb.Error`` for one that is damaged, or that another process writes.
    """
    connection = duckdb.connect(str(path), read_only=True, config=LIMITS)
    try:
        return connection, _books(connection)
    except BaseException:
        connection.close()
        raise


def _books(connection: duckdb.DuckDBPyConnection) -> Books | None:
    try:
        ((tables, views, place),) = connection.execute(f"FROM {ROWS}.made").fetchall()
    except (duckdb.CatalogException, ValueError):
        return None
    if tables != _tables_digest():
        return None
    return Books(views, place, dict(connection.execute(f"FROM {ROWS}.folders").fetchall()))


@contextmanager
def _reading(root: Path) -> Iterator[tuple[duckdb.DuckDBPyConnection, Books] | None]:
    """The database open for reading, and what it says of itself; None where it is of no use."""
    with ExitStack() as stack:
        found: tuple[duckdb.DuckDBPyConnection, Books] | None = None
        with suppress(duckdb.Error):
            connection, books = open_books(root / NAME)
            stack.enter_context(connection)
            if books is not None and books.place == str(root.absolute()):
                found = connection, books
        yield found


def _bring_up(root: Path, *, trusting: bool, anew: bool = False) -> None:
    """For the holder of the lock. ``duckdb.Error`` where the database that is there turns out to be damaged.

    Args:
        root: the warehouse.
        trusting: folders that have not changed hold what they held.
        anew: nothing is taken from the database that is there.
    """
    for left in root.glob(f".{NAME}.*"):
        left.unlink()
    fresh = root / f".{NAME}.{os.getpid()}"
    with nullcontext() if anew else _reading(root) as opened:
        found = look(root, opened[1].folders if opened and trusting else {})
        due = _Due(found.parts, _NONE, 1)
        if opened is None and trusting:
            return
        if opened is not None:
            connection, books = opened
            due = _due(connection, books, found)
            if due.is_nothing and (books.folders, books.views) == (found.folders, _views_digest(root)):
                return
            if trusting:
                _refuse_lost(root, due)
            shutil.copyfile(root / NAME, fresh)
    try:
        with duckdb.connect(str(fresh), config=LIMITS) as connection:
            if opened is None:
                for statement in table_statements():
                    connection.execute(statement)
            _take_out(connection, due.gone)
            _take_in(connection, root, due)
            if opened is None or opened[1].views != _views_digest(root):
                _make_views(connection, root)
            else:
                for name in KEPT:
                    _keep_answer(connection, name)
            _note(connection, root, found)
        fresh.replace(root / NAME)
    finally:
        for left in root.glob(f".{NAME}.*"):
            left.unlink()


def _due(connection: duckdb.DuckDBPyConnection, books: Books, found: Look) -> _Due:
    """What differs between the parts that were found and those that the database holds."""
    connection.register("found", found.parts)
    fresh = connection.sql(
        f"SELECT f.* FROM found AS f ANTI JOIN {ROWS}.parts AS p ON {_SAME} ORDER BY f.folder, f.name"
    ).to_arrow_table()
    looked = [*found.listed, *(books.folders.keys() - found.folders.keys())]
    gone = connection.sql(
        f"SELECT p.* FROM {ROWS}.parts AS p ANTI JOIN found AS f ON {_SAME} WHERE list_contains($looked, p.folder)",
        params={"looked": looked},
    ).to_arrow_table()
    ((after,),) = connection.execute(f"SELECT coalesce(max(part), 0) + 1 FROM {ROWS}.parts").fetchall()
    return _Due(fresh, gone, after)


def _refuse_lost(root: Path, due: _Due) -> None:
    """``BadInput`` for a part that is gone and has no other in its place."""
    there = set(zip(due.fresh["folder"].to_pylist(), due.fresh["name"].to_pylist(), strict=True))
    for folder, name in zip(due.gone["folder"].to_pylist(), due.gone["name"].to_pylist(), strict=True):
        if (folder, name) not in there:
            raise BadInput(
                "rows are missing: this part of them is gone",
                where=str(root / folder / name),
                todo="`c4s report --from-runs` writes them anew",
            )


def _take_out(connection: duckdb.DuckDBPyConnection, gone: pa.Table) -> None:
    if gone:
        connection.register("gone", gone)
        for table in ("parts", *HELD):
            connection.execute(f"DELETE FROM {ROWS}.{table} WHERE part IN (SELECT part FROM gone)")


def _take_in(connection: duckdb.DuckDBPyConnection, root: Path, due: _Due) -> None:
    start = 0
    for folder, inside in groupby(due.fresh["folder"].to_pylist()):
        end = start + len(list(inside))
        for first in range(start, end, AT_ONCE):
            parts = due.fresh.slice(first, min(AT_ONCE, end - first))
            numbers = range(due.number + first, due.number + first + len(parts))
            names = parts["name"].to_pylist()
            connection.register("fresh", rows_of(root, folder, list(zip(numbers, names, strict=True))))
            connection.execute(f"INSERT INTO {ROWS}.{table_of(folder)} FROM fresh")
            connection.register("fresh", parts.add_column(0, "part", column(numbers, pa.int64())))
            connection.execute(f"INSERT INTO {ROWS}.parts FROM fresh")
        start = end


def _make_views(connection: duckdb.DuckDBPyConnection, root: Path) -> None:
    for (name,) in connection.execute("SELECT view_name FROM duckdb_views() WHERE NOT internal").fetchall():
        connection.execute(f'DROP VIEW "{name}"')
    for name, statement in view_statements(root):
        try:
            if name in KEPT:
                statement = _keep_answer(connection, name)
            connection.execute(f"CREATE VIEW {name} AS {statement}")
        except duckdb.Error as error:
            raise broken_rows(root, error) from None


def _keep_answer(connection: duckdb.DuckDBPyConnection, name: str) -> str:
    """Keep what a question answers now as a table; what its view reads."""
    connection.execute(f"CREATE OR REPLACE TABLE {ROWS}.{name} AS {question_text(name)}")
    return f"SELECT * FROM {ROWS}.{name}"


def _note(connection: duckdb.DuckDBPyConnection, root: Path, found: Look) -> None:
    """What the database says of itself from now on."""
    connection.execute(f"DELETE FROM {ROWS}.made")
    made = [_tables_digest(), _views_digest(root), str(root.absolute())]
    connection.execute(f"INSERT INTO {ROWS}.made VALUES (?, ?, ?)", made)
    connection.execute(f"DELETE FROM {ROWS}.folders")
    connection.register(
        "folders", columns({"folder": [*found.folders], "mtime_ns": [*found.folders.values()]}, _FOLDERS)
    )
    connection.execute(f"INSERT INTO {ROWS}.folders FROM folders")


def _tables_digest() -> str:
    return digest(table_statements())


def _views_digest(root: Path) -> str:
    return digest(list(view_statements(root)))
