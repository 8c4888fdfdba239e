"""Charts of what studies find on a warehouse of known truth: one of each kind, the same bytes twice, names as text."""

from __future__ import annotations

from pathlib import Path
from typing import get_args
from xml.etree import ElementTree

import pytest

from c4s.records.analysis import Chart, ChartKind, Column, Findings, Table
from reports.charts import chart_svg, write_charts

ROWS = [
    {"name": "<b>one & $x$", "set": "public", "x": 0.25, "low": 0.2, "high": 0.4, "y": 3.0},
    {"name": "two", "set": "public", "x": 0.5, "low": None, "high": None, "y": 1.0},
    {"name": "two", "set": "private", "x": 0.75, "low": 0.7, "high": 0.9, "y": 2.0},
    {"name": "three", "set": "private", "x": None, "low": None, "high": None, "y": None},
]


def findings(kind: ChartKind, rows: list[dict[str, str | float | None]]) -> Findings:
    columns = [Column(name=name, title=name.upper()) for name in ("name", "set", "x", "low", "high", "y")]
    wide = kind in ("heat", "stacks")
    chart = Chart(
        name=kind,
        title="Costs < scores",
        kind=kind,
        table="rows",
        x="" if kind == "heat" else "x",
        y="name" if wide or kind in ("dots", "bars") else "y",
        low="low" if kind in ("dots", "bars") else None,
        high="high" if kind in ("dots", "bars") else None,
        group="set",
        series=["x", "y"] if wide else [],
        label="name" if kind == "scatter" else None,
        reference=0.5,
    )
    return Findings(tables=[Table(name="rows", title="Rows", columns=columns, rows=rows)], charts=[chart])


def drawn_words(drawn: str) -> set[str]:
    return {"".join(one.itertext()) for one in ElementTree.fromstring(drawn).iter("{http://www.w3.org/2000/svg}text")}


@pytest.mark.parametrize("kind", get_args(ChartKind))
def test_every_kind_is_drawn_the_same_twice_with_names_as_text(kind: ChartKind, tmp_path: Path) -> None:
    found = findings(kind, ROWS)
    (path,) = write_charts(found, tmp_path)
    drawn = path.read_text()
    assert drawn == chart_svg(found, found.charts[0])
    words = drawn_words(drawn)
    assert "Costs < scores" in words
    if kind != "lines":
        assert any("<b>one & $x$" in one for one in words)


@pytest.mark.parametrize(("kind", "grows"), [("dots", True), ("heat", True), ("lines", False), ("scatter", False)])
def test_rows_have_room_and_plots_of_numbers_keep_their_height(kind: ChartKind, grows: bool) -> None:
    few, many = (findings(kind, ROWS * times) for times in (5, 10))
    heights = [
        float(ElementTree.fromstring(chart_svg(one, one.charts[0])).attrib["height"][:-2]) for one in (few, many)
    ]
    assert (heights[1] > 1.5 * heights[0]) == grows and (heights[1] == heights[0]) != grows


@pytest.mark.parametrize("kind", get_args(ChartKind))
def test_what_has_no_row_says_so(kind: ChartKind) -> None:
    found = findings(kind, [])
    assert "no value to show" in drawn_words(chart_svg(found, found.charts[0]))


def test_dots_without_a_value_say_so_and_a_chart_tells_what_it_is_of() -> None:
    found = findings("dots", [{"name": "one", "set": "public", "x": None}])
    words = drawn_words(chart_svg(found, found.charts[0], "suite made, judge rule"))
    assert {"no value to show", "suite made, judge rule"} <= words


def test_a_chart_may_draw_some_rows_and_costs_are_plain_numbers() -> None:
    found = findings("scatter", ROWS)
    chart = found.charts[0].model_copy(update={"only": {"set": "private"}, "log_x": True, "reference": None})
    words = drawn_words(chart_svg(found, chart))
    assert "two" in words and not any("one" in word for word in words)
    assert not any("mathdefault" in word for word in words)
