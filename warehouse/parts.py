"""The parts as they lie on disk: which there are, and their rows."""

from __future__ import annotations

import os
import time
from collections.abc import Iterator, Mapping
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

import pyarrow as pa

from warehouse.columns import column, columns
from warehouse.damage import UNHELD, read_part
from warehouse.parquet import PARTITIONS, arrow_schema
from warehouse.records import TABLES

HELD = tuple(table for table in TABLES if table not in UNHELD)
"""Tables whose rows the database holds."""
LISTED = pa.schema(
    [
        ("folder", pa.string()),
        ("name", pa.string()),
        ("size", pa.int64()),
        ("mtime_ns", pa.int64()),
        ("inode", pa.uint64()),
    ]
)
"""What tells one part from another: every writer puts a new file in the place of an old one."""
YOUNG_NS, YOUNG_COARSE_NS = 100_000_000, 2_000_000_000
"""A folder that was changed so short a time ago may change again under the same time of change. The second one is for
file systems that tell whole seconds."""
_READERS = 4


@dataclass(frozen=True)
class Look:
    """The parts of a warehouse."""

    folders: dict[str, int]
    """Every folder of parts, by its path below the warehouse, with its time of change; 0 for a young one."""
    listed: list[str]
    """The folders that were listed."""
    parts: pa.Table
    """Their parts, as ``LISTED`` says."""


def look(root: Path, known: Mapping[str, int]) -> Look:
    """Find the parts; folders that have the time of change that is ``known`` of them are not listed again."""
    folders, listed, now_ns = {}, [], time.time_ns()
    told_of: dict[str, list[str | int]] = {name: [] for name in LISTED.names}
    for folder, path in _folders(root):
        changed = path.stat().st_mtime_ns
        young_ns = YOUNG_NS if changed % 1_000_000_000 else YOUNG_COARSE_NS
        folders[folder] = changed if now_ns - changed > young_ns else 0
        if known.get(folder, 0) == changed:
            continue
        listed.append(folder)
        for entry in _entries(path):
            if entry.name.endswith(".parquet"):
                try:
                    found = entry.stat()
                except FileNotFoundError:
                    continue
                told: tuple[str | int, ...] = (folder, entry.name, found.st_size, found.st_mtime_ns, found.st_ino)
                for name, value in zip(told_of, told, strict=True):
                    told_of[name].append(value)
    return Look(folders, listed, columns(told_of, LISTED))


def _folders(root: Path) -> Iterator[tuple[str, Path]]:
    """Every folder of parts of the tables that the database holds: its path below the warehouse, and whole."""
    suite_mark, configuration_mark = (f"{name}=" for name in PARTITIONS)
    for table in HELD:
        for suite in _entries(root / table):
            if suite.name.startswith(suite_mark) and suite.is_dir():
                for configuration in _entries(Path(suite.path)):
                    if configuration.name.startswith(configuration_mark) and configuration.is_dir():
                        yield f"{table}/{suite.name}/{configuration.name}", Path(configuration.path)


def _entries(folder: Path) -> list[os.DirEntry[str]]:
    try:
        with os.scandir(folder) as entries:
            return sorted(entries, key=lambda entry: entry.name)
    except (FileNotFoundError, NotADirectoryError):
        return []


def table_of(folder: str) -> str:
    """The table whose parts lie in a folder."""
    return folder.partition("/")[0]


def rows_of(root: Path, folder: str, parts: list[tuple[int, str]]) -> pa.Table:
    """The rows of parts of one folder, each with the number of its part first, in the columns of the table.

    ``BadInput`` for a part that cannot be read, or has other columns.
    """
    table = table_of(folder)
    schema = pa.schema([pa.field("part", pa.int64()), *arrow_schema(table)])
    place = dict(step.split("=", 1) for step in folder.split("/")[1:])

    def read(part: tuple[int, str]) -> pa.Table:
        number, name = part
        rows = read_part(table, root / folder / name)
        given = {"part": number, **place}
        cells = [
            column([given[field.name]] * len(rows), field.type) if field.name in given else rows[field.name]
            for field in schema
        ]
        return pa.Table.from_arrays(cells, schema=schema)

    with ThreadPoolExecutor(_READERS) as readers:
        return pa.concat_tables(list(readers.map(read, parts)))
