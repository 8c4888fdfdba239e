"""Tables as people read them: rounded, the best and the second marked, and as CSV files."""

from __future__ import annotations

from c4s.numbers import half_up
from c4s.records.analysis import Column, Intervals, Table, Value


def method_of(made: Intervals) -> str:
    """How intervals were made, or why there are none, in a sentence or two."""
    if not made.honest:
        return made.proviso
    clusters = ", ".join(f"{name} {count}" for name, count in made.clusters.items())
    return (
        f"Intervals: {made.level:.0%}, {made.method}, {made.draws:,} draws of {made.unit} (clusters: {clusters}), "
        f"seed {made.seed}. {made.proviso}"
    )


def printed(value: Value, column: Column) -> Value:
    """A value as it is shown: rounded half up to the column's decimals; None stays None."""
    if not isinstance(value, float) or column.decimals is None:
        return value
    return half_up(value, column.decimals)


def marks(table: Table, column: Column) -> list[str]:
    """``best``, ``second`` or nothing for each row: by printed values, ties share.

    All rows at the best printed value are best, all at the next distinct one second. Rows of what is not ranked
    (``ranked`` is False) have no mark, and where all are equal none has.
    """
    numbers = [
        None if column.marks is None or row.get("ranked") is False or shown is None else float(shown)
        for row, shown in zip(table.rows, (printed(one, column) for one in table.column(column.name)), strict=True)
    ]
    distinct = sorted({number for number in numbers if number is not None}, reverse=column.marks == "high")
    if len(distinct) < 2:
        return [""] * len(numbers)
    return ["best" if one == distinct[0] else "second" if one == distinct[1] else "" for one in numbers]
