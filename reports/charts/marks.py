"""What each kind of chart draws of its table."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from c4s.numbers import half_up
from c4s.records.analysis import Chart, Table, Value
from reports.charts.style import COLOURS, DASHES, HATCHES, HEAT, INK, MARKERS, short

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Row = dict[str, Value]
WORDY = 7
"""Lines from which each is named at its end too."""


def draw_dots(axes: Axes, chart: Chart, table: Table) -> None:
    """A mark a row, with whiskers where the ends are known; the first row on top."""
    rows = [row for row in table.rows if number(row, chart.x) is not None]
    if not rows:
        return
    names = list(dict.fromkeys(short(row[chart.y]) for row in rows))
    for place, (group, own) in enumerate(_groups(chart, rows)):
        y = [names.index(short(row[chart.y])) + _aside(place, len(_groups(chart, rows))) for row in own]
        x = [float(number(row, chart.x) or 0.0) for row in own]
        axes.errorbar(
            x,
            y,
            xerr=_whiskers(chart, own, x),
            fmt=MARKERS[place % len(MARKERS)],
            color=COLOURS[place % len(COLOURS)],
            markersize=5,
            capsize=2.5,
            linewidth=1.1,
            label=group,
        )
    _names(axes, names)
    axes.set_xlabel(_title(table, chart.x))


def draw_bars(axes: Axes, chart: Chart, table: Table) -> None:
    """A bar a row, side by side where a column tells groups apart."""
    rows = [row for row in table.rows if number(row, chart.x) is not None]
    names = list(dict.fromkeys(short(row[chart.y]) for row in rows))
    groups = _groups(chart, rows)
    for place, (group, own) in enumerate(groups):
        y = [names.index(short(row[chart.y])) + _aside(place, len(groups)) for row in own]
        x = [float(number(row, chart.x) or 0.0) for row in own]
        axes.barh(
            y,
            x,
            height=0.8 / len(groups),
            color=COLOURS[place % len(COLOURS)],
            hatch=HATCHES[place % len(HATCHES)],
            edgecolor="white",
            label=group,
        )
        if (ends := _whiskers(chart, own, x)) is not None:
            axes.errorbar(x, y, xerr=ends, fmt="none", ecolor=INK, capsize=2.5, linewidth=1.0)
    _names(axes, names)
    axes.set_xlabel(_title(table, chart.x))


def draw_stacks(axes: Axes, chart: Chart, table: Table) -> None:
    """A bar a row, made of its series."""
    rows = table.rows
    names = [short(row[chart.y]) + (f" · {short(row[chart.group])}" if chart.group else "") for row in rows]
    left = np.zeros(len(rows))
    for place, series in enumerate(chart.series):
        width = np.array([float(number(row, series) or 0.0) for row in rows])
        axes.barh(
            range(len(rows)),
            width,
            left=left,
            color=COLOURS[place % len(COLOURS)],
            hatch=HATCHES[place % len(HATCHES)],
            edgecolor="white",
            label=_title(table, series),
        )
        left += width
    _names(axes, names)
    axes.set_xlabel(_title(table, chart.x) if chart.x else "")


def draw_heat(axes: Axes, chart: Chart, table: Table) -> None:
    """A cell a row and series, with its number in it."""
    names = [short(row[chart.y]) + (f" · {short(row[chart.group])}" if chart.group else "") for row in table.rows]
    cells = np.array([[_or_nan(number(row, series)) for series in chart.series] for row in table.rows])
    top = 1.0 if np.nanmax(cells, initial=0.0) <= 1.0 else float(np.nanmax(cells))
    shown = axes.imshow(np.ma.masked_invalid(cells), aspect="auto", cmap=HEAT, vmin=0.0, vmax=top)
    axes.figure.colorbar(shown, ax=axes, shrink=0.8, pad=0.02)
    for y, x in np.ndindex(*cells.shape):
        if not np.isnan(cells[y, x]):
            ink = "white" if cells[y, x] < 0.55 * top else INK
            text = half_up(float(cells[y, x]), 3) if top == 1.0 else f"{cells[y, x]:,.0f}"
            axes.text(x, y, text, ha="center", va="center", color=ink, fontsize=7.5)
    axes.set_xticks(
        range(len(chart.series)), [_title(table, series) for series in chart.series], rotation=30, ha="right"
    )
    axes.set_yticks(range(len(names)), names)
    axes.grid(visible=False)


def draw_lines(axes: Axes, chart: Chart, table: Table) -> None:
    """A line a series, or a line a group of rows."""
    lines = (
        [(_title(table, series), table.rows, series) for series in chart.series]
        if chart.series
        else [(group, own, chart.y) for group, own in _groups(chart, table.rows)]
    )
    ends: list[tuple[tuple[float, float], str, str]] = []
    for place, (name, rows, column) in enumerate(lines):
        points = [(_or_nan(number(row, chart.x)), _or_nan(number(row, column))) for row in rows]
        colour, marker = COLOURS[place % len(COLOURS)], MARKERS[place % len(MARKERS)]
        dash = DASHES[place // len(COLOURS) % len(DASHES)]
        axes.plot(
            *zip(*points, strict=True),
            color=colour,
            marker=marker,
            markersize=4,
            linewidth=1.3,
            linestyle=dash,
            label=name,
        )
        if len(lines) >= WORDY and name and points:
            ends.append((points[-1], name, colour))
        if chart.low and chart.high and not chart.series:
            low, high = ([_or_nan(number(row, end)) for row in rows] for end in (chart.low, chart.high))
            axes.fill_between([x for x, _ in points], low, high, color=colour, alpha=0.15, linewidth=0)
    _at_ends(axes, ends)
    if all(isinstance(row.get(chart.x), int) for row in table.rows):
        axes.locator_params(axis="x", integer=True)
    axes.set_xlabel(_title(table, chart.x))
    axes.set_ylabel("" if chart.series else _title(table, chart.y))


def draw_scatter(axes: Axes, chart: Chart, table: Table) -> None:
    """A point a row, with words at it."""
    rows = [row for row in table.rows if number(row, chart.x) is not None and number(row, chart.y) is not None]
    for place, (group, own) in enumerate(_groups(chart, rows)):
        x, y = ([float(number(row, name) or 0.0) for row in own] for name in (chart.x, chart.y))
        axes.scatter(x, y, color=COLOURS[place % len(COLOURS)], marker=MARKERS[place % len(MARKERS)], label=group)
        for row, at in zip(own, zip(x, y, strict=True), strict=True) if chart.label else ():
            axes.annotate(short(row[chart.label or ""]), at, xytext=(4, 4), textcoords="offset points", fontsize=7.5)
    if chart.diagonal and rows:
        both = [value for row in rows for name in (chart.x, chart.y) if (value := number(row, name)) is not None]
        low, high = min(both), max(both)
        room = 0.05 * ((high - low) or 1.0)
        axes.plot([low - room, high + room], [low - room, high + room], color=INK, linewidth=0.8, linestyle="--")
        axes.set_xlim(low - room, high + room)
        axes.set_ylim(low - room, high + room)
        axes.set_aspect("equal")
    axes.set_xlabel(_title(table, chart.x))
    axes.set_ylabel(_title(table, chart.y))


def _at_ends(axes: Axes, ends: list[tuple[tuple[float, float], str, str]]) -> None:
    """Names of lines at their last points, moved apart where they would lie on each other."""
    known = sorted((end for end in ends if not np.isnan(end[0][1])), key=lambda end: end[0][1])
    low, high = axes.get_ylim()
    least, at = 0.035 * (high - low), -np.inf
    for (x, y), name, colour in known:
        at = max(y, at + least)
        axes.annotate(name, (x, at), xytext=(6, 0), textcoords="offset points", va="center", fontsize=7, color=colour)


def number(row: Row, name: str) -> float | None:
    """A number of a row; None where there is none."""
    value = row.get(name)
    return float(value) if isinstance(value, int | float) else None


def _or_nan(value: float | None) -> float:
    return float("nan") if value is None else value


def _title(table: Table, name: str) -> str:
    """With its unit, where it is one of measure."""
    found = next((column for column in table.columns if column.name == name), None)
    if found is None:
        return name
    return found.headed()


def _groups(chart: Chart, rows: list[Row]) -> list[tuple[str | None, list[Row]]]:
    if chart.group is None:
        return [(None, rows)]
    named = list(dict.fromkeys(str(row[chart.group]) for row in rows))
    return [(short(name), [row for row in rows if str(row[chart.group or ""]) == name]) for name in named]


def _aside(place: int, of: int) -> float:
    """How far from its row's middle a group's mark stands."""
    return 0.8 * ((place + 0.5) / of - 0.5)


def _whiskers(chart: Chart, rows: list[Row], middle: list[float]) -> list[list[float]] | None:
    if chart.low is None or chart.high is None:
        return None
    low = [x - (x if (end := number(row, chart.low)) is None else end) for row, x in zip(rows, middle, strict=True)]
    high = [(x if (end := number(row, chart.high)) is None else end) - x for row, x in zip(rows, middle, strict=True)]
    return [[max(0.0, one) for one in low], [max(0.0, one) for one in high]]


def _names(axes: Axes, names: list[str]) -> None:
    axes.set_yticks(range(len(names)), names)
    axes.set_ylim(len(names) - 0.4, -0.6)
    axes.grid(axis="y", visible=False)
