"""Writing rows: one immutable Parquet file a table and trial, partitioned by suite and configuration."""

from __future__ import annotations

import io
import types
import typing
from collections.abc import Sequence
from pathlib import Path
from typing import Any, Literal, get_args, get_origin

import pyarrow as pa
import pyarrow.parquet as pq

from c4s.files import write_bytes
from c4s.records.base import Record
from warehouse.records import TABLES

_ARROW = {str: pa.string(), int: pa.int64(), float: pa.float64(), bool: pa.bool_(), bytes: pa.binary()}
PARTITIONS = ("suite", "configuration")


def _arrow_type(annotation: Any) -> tuple[pa.DataType, bool]:
    """Arrow type of a field annotation and whether it may be null."""
    if get_origin(annotation) in (types.UnionType, typing.Union):
        inner = [arg for arg in get_args(annotation) if arg is not type(None)]
        return _arrow_type(inner[0])[0], True
    if get_origin(annotation) is Literal:
        return pa.string(), False
    return _ARROW[annotation], False


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


def write_part(root: Path, table: str, rows: Sequence[Record], *, suite: str, configuration: str, key: str) -> Path:
    """Write one trial's rows of one table. The same rows give the same bytes, so a repeated write changes nothing."""
    schema = arrow_schema(table, partitions=False)
    columns = {name: [getattr(row, name) for row in rows] for name in schema.names}
    buffer = io.BytesIO()
    pq.write_table(pa.table(columns, schema=schema), buffer, compression="zstd")
    path = part_path(root, table, suite, configuration, key)
    write_bytes(path, buffer.getvalue())
    return path
