"""Columns of plain values, laid out here: Arrow's own conversion of them loads pandas, longer than all else."""

from __future__ import annotations

from array import array
from collections.abc import Callable, Mapping, Sequence
from itertools import accumulate
from typing import Any, Final

import pyarrow as pa

_CODES: Final[Mapping[pa.DataType, str]] = {pa.int64(): "q", pa.uint64(): "Q", pa.float64(): "d"}
_TEXTS: Final[Mapping[pa.DataType, Callable[[Any], bytes]]] = {pa.string(): str.encode, pa.binary(): bytes}


def column(values: Sequence[Any], kind: pa.DataType) -> pa.Array:
    """Values, or ``None``, as an Arrow array of text, bytes, whole numbers, numbers or truth values."""
    there = [value is not None for value in values]
    missing = len(values) - sum(there)
    valid = _bits(there) if missing else None
    return pa.Array.from_buffers(kind, len(values), [valid, *_laid_out(values, kind)], missing)


def columns(values: Mapping[str, Sequence[Any]], schema: pa.Schema) -> pa.Table:
    """A table of the columns that a schema names."""
    return pa.Table.from_arrays([column(values[field.name], field.type) for field in schema], schema=schema)


def no_rows(schema: pa.Schema) -> pa.Table:
    """A table without rows."""
    return pa.Table.from_batches([], schema=schema)


def _laid_out(values: Sequence[Any], kind: pa.DataType) -> list[pa.Buffer]:
    """The buffers behind that of the missing ones, which hold zero."""
    if kind == pa.bool_():
        return [_bits([bool(value) for value in values])]
    if kind in _CODES:
        return [pa.py_buffer(array(_CODES[kind], [0 if value is None else value for value in values]).tobytes())]
    whole = [b"" if value is None else _TEXTS[kind](value) for value in values]
    ends = array("i", accumulate(map(len, whole), initial=0))
    return [pa.py_buffer(ends.tobytes()), pa.py_buffer(b"".join(whole))]


def _bits(flags: Sequence[bool]) -> pa.Buffer:
    """Eight flags a byte, the first in the lowest bit."""
    number = int("".join("1" if flag else "0" for flag in reversed(flags)) or "0", 2)
    return pa.py_buffer(number.to_bytes((len(flags) + 7) // 8, "little"))
