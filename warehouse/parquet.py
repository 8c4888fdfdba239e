"""Writing rows: one immutable Parquet file a table and trial, partitioned by suite and configuration."""

from __future__ import annotations

import functools
import io
import os
import struct
import types
import typing
from collections.abc import Sequence
from pathlib import Path
from typing import Any, Literal, get_args, get_origin

import pyarrow as pa
import pyarrow.parquet as pq

from c4s.files import write_bytes
from c4s.home import warehouse_root
from c4s.records.base import Record
from c4s.run.store import open_store
from warehouse.columns import columns
from warehouse.records import TABLES

_ARROW = {str: pa.string(), int: pa.int64(), float: pa.float64(), bool: pa.bool_(), bytes: pa.binary()}
_MAGIC = b"PAR1"
_TAIL = struct.Struct("<I4s")
"""The end of a Parquet file: the length of its footer in bytes, and the magic word."""
PARTITIONS = ("suite", "configuration")


def _arrow_type(annotation: Any) -> tuple[pa.DataType, bool]:
    """Arrow type of a field annotation and whether it may be null."""
    if get_origin(annotation) in (types.UnionType, typing.Union):
        inner = [arg for arg in get_args(annotation) if arg is not type(None)]
        return _arrow_type(inner[0])[0], True
    if get_origin(annotation) is Literal:
        return pa.string(), False
    return _ARROW[annotation], False


@functools.cache
def arrow_schema(table: str, *, partitions: bool = True) -> pa.Schema:
    """The Arrow schema of a table, from its record model; partition columns are left out of the files."""
    fields = []
    for name, field in TABLES[table].model_fields.items():
        if name in PARTITIONS and not partitions:
            continue
        kind, nullable = _arrow_type(field.annotation)
        fields.append(pa.field(name, kind, nullable=nullable))
    return pa.schema(fields)


def part_path(root: Path, table: str, suite: str, configuration: str, key: str) -> Path:
    """Where a trial's rows of a table lie."""
    return root / table / f"suite={suite}" / f"configuration={configuration}" / f"{key}.parquet"


def is_whole(path: Path) -> bool:
    """Whether a part is there from its first byte to its last: a file that was cut off is not."""
    try:
        with path.open("rb") as part:
            first = part.read(len(_MAGIC))
            part.seek(-_TAIL.size, os.SEEK_END)
            footer, last = _TAIL.unpack(part.read())
            return (first, last) == (_MAGIC, _MAGIC) and footer + _TAIL.size + len(_MAGIC) <= part.tell()
    except (OSError, struct.error):
        return False


def write_part(root: Path, table: str, rows: Sequence[Record], *, suite: str, configuration: str, key: str) -> Path:
    """Write one trial's rows of one table. The same rows give the same bytes, so a repeated write changes nothing."""
    schema = arrow_schema(table, partitions=False)
    values = {name: [getattr(row, name) for row in rows] for name in schema.names}
    buffer = io.BytesIO()
    pq.write_table(columns(values, schema), buffer, compression="zstd")
    path = part_path(root, table, suite, configuration, key)
    write_bytes(path, buffer.getvalue())
    if path.is_relative_to(warehouse_root()):
        open_store().push_files(path)
    return path
