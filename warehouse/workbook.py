"""Rows as an Excel workbook: numbers are numbers, no text is a formula, the header stays in sight."""

from __future__ import annotations

import io
import math
import re
from collections.abc import Sequence
from datetime import date, datetime
from decimal import Decimal
from pathlib import Path
from typing import Any, Final

from openpyxl import Workbook
from openpyxl.cell import WriteOnlyCell
from openpyxl.styles import Font
from openpyxl.utils import get_column_letter

from c4s.errors import BadInput
from c4s.names import shown

MOST_ROWS: Final = 1_048_575
"""Of a sheet, beside its header."""
MOST_COLUMNS: Final = 16_384
MOST_LETTERS: Final = 32_767
"""Of a cell."""
EXACT: Final = 2**53
"""Whole numbers beyond it are texts: a sheet holds numbers as floats."""
WIDEST, SEEN = 60, 200
"""Letters that the widest column shows, and rows that widths are made for."""
INSTEAD: Final = "write a .csv or .parquet file"


def workbook(columns: Sequence[str], rows: Sequence[Sequence[Any]], *, where: Path, name: str = "rows") -> bytes:
    """The bytes of an ``.xlsx`` file with one sheet that can be filtered; what a sheet has no kind for is text.

    Fractions have 16 digits there, one less than a float needs to be the same again.

    ``BadInput`` where a sheet cannot hold the rows: too many, too many columns, or too long a text.
    """
    if len(rows) > MOST_ROWS:
        raise BadInput(f"a sheet holds {MOST_ROWS:,} rows, these are {len(rows):,}", where=str(where), todo=INSTEAD)
    if len(columns) > MOST_COLUMNS:
        raise BadInput(f"a sheet holds {MOST_COLUMNS:,} columns", where=str(where), todo=INSTEAD)
    for name, *values in zip(columns, *rows, strict=True):
        longest = max((len(value) for value in map(_plain, values) if isinstance(value, str)), default=0)
        if longest > MOST_LETTERS:
            raise BadInput(
                f"a cell holds {MOST_LETTERS:,} letters, one of column {name!r} has {longest:,}",
                where=str(where),
                todo=INSTEAD,
            )
    book, out = Workbook(write_only=True), io.BytesIO()
    sheet = book.create_sheet(re.sub(r"[^\w -]", "_", name)[:31] or "rows")
    sheet.freeze_panes = "A2"
    if columns:
        sheet.auto_filter.ref = f"A1:{get_column_letter(len(columns))}{len(rows) + 1}"
    for place, name in enumerate(columns, start=1):
        widest = max([len(str(row[place - 1])) for row in rows[:SEEN]], default=0)
        sheet.column_dimensions[get_column_letter(place)].width = min(max(widest, len(name)) + 2, WIDEST)
    header = [_cell(sheet, name) for name in columns]
    for cell in header:
        cell.font = Font(bold=True)
    sheet.append(header)
    for row in rows:
        sheet.append([_cell(sheet, value) for value in row])
    book.save(out)
    return out.getvalue()


def _cell(sheet: Any, value: Any) -> Any:
    plain = _plain(value)
    cell = WriteOnlyCell(sheet, value=None)
    if not isinstance(plain, str):
        cell.value = plain
        return cell
    cell.value = shown(plain, keep="\n\t")
    cell.data_type = "s"
    return cell


def _plain(value: Any) -> Any:
    """A value as a sheet has it."""
    if isinstance(value, Decimal):
        value = float(value)
    if isinstance(value, datetime) and value.tzinfo is not None:
        return value.isoformat()
    if value is None or isinstance(value, bool | date | datetime):
        return value
    if isinstance(value, int):
        return value if abs(value) <= EXACT else str(value)
    if isinstance(value, float):
        return value if math.isfinite(value) else str(value)
    return value.hex() if isinstance(value, bytes) else str(value)
