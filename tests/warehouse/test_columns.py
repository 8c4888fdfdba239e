"""Columns that are laid out here are those that Arrow makes of the same values."""

from __future__ import annotations

from typing import Any

import pyarrow as pa
import pytest
from hypothesis import given
from hypothesis import strategies as st

from warehouse.columns import column, columns, no_rows

KINDS = {
    pa.string(): st.text(st.characters(codec="utf-8")),
    pa.binary(): st.binary(),
    pa.int64(): st.integers(-(2**63), 2**63 - 1),
    pa.uint64(): st.integers(0, 2**64 - 1),
    pa.float64(): st.floats(allow_nan=False),
    pa.bool_(): st.booleans(),
}


@pytest.mark.parametrize("kind", KINDS, ids=str)
@given(data=st.data())
def test_a_column_is_the_one_that_arrow_makes(kind: pa.DataType, data: st.DataObject) -> None:
    values: list[Any] = data.draw(st.lists(st.none() | KINDS[kind], max_size=40))
    made = column(values, kind)
    made.validate(full=True)
    assert made.equals(pa.array(values, kind)) and made.null_count == values.count(None)


def test_what_does_not_fit_its_type_is_refused() -> None:
    for value, kind in (
        ("a", pa.int64()),
        (2**63, pa.int64()),
        (-1, pa.uint64()),
        (1, pa.string()),
        ("a", pa.binary()),
    ):
        with pytest.raises((TypeError, OverflowError)):
            column([value], kind)


def test_a_table_has_the_columns_of_its_schema() -> None:
    schema = pa.schema([pa.field("b", pa.int64()), pa.field("a", pa.string())])
    assert columns({"a": ["x"], "b": [1]}, schema).equals(pa.table({"b": [1], "a": ["x"]}, schema=schema))
    assert no_rows(schema).equals(schema.empty_table())
