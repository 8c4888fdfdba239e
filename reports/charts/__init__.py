"""Charts of studies as SVG: one style, their data beside them."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from textwrap import wrap
from typing import TYPE_CHECKING, Final

from c4s.files import write_text
from c4s.records.analysis import Chart, ChartKind, Findings, Table
from reports.charts.marks import draw_bars, draw_dots, draw_heat, draw_lines, draw_scatter, draw_stacks
from reports.charts.style import CAPTION_COLUMNS, INK, PLOT_ROWS, drawing, svg

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["chart_svg", "write_charts"]

_KINDS: Final[dict[ChartKind, Callable[[Axes, Chart, Table], None]]] = {
    "bars": draw_bars,
    "dots": draw_dots,
    "heat": draw_heat,
    "lines": draw_lines,
    "scatter": draw_scatter,
    "stacks": draw_stacks,
}
_FREE: Final[frozenset[ChartKind]] = frozenset({"lines", "scatter"})
"""Charts whose height has nothing to do with how many rows they show."""


SHORT_LABEL: Final = 36
"""Letters of a name in a legend of three columns."""


def chart_svg(findings: Findings, chart: Chart, caption: str = "") -> str:
    """A chart of an analysis as SVG text; the caption says what it is of."""
    table = _drawn(next(one for one in findings.tables if one.name == chart.table), chart)
    with drawing(PLOT_ROWS if chart.kind in _FREE else len(table.rows)) as (figure, axes):
        if table.rows:
            _KINDS[chart.kind](axes, chart, table)
        axes.set_title(chart.title)
        if not axes.has_data():
            axes.text(0.5, 0.5, "no value to show", transform=axes.transAxes, ha="center", color=INK)
            axes.set_xticks([])
            axes.set_yticks([])
        if chart.log_x:
            axes.set_xscale("log")
            axes.xaxis.set_major_formatter("{x:g}")
            axes.xaxis.set_minor_formatter("{x:g}")
        if chart.reference is not None:
            axes.axvline(chart.reference, color=INK, linewidth=0.9, linestyle="--")
        if axes.get_legend_handles_labels()[1]:
            longest = max(map(len, axes.get_legend_handles_labels()[1]))
            figure.legend(loc="outside lower center", ncols=1 if longest > SHORT_LABEL else 3)
        if caption:
            figure.suptitle(
                "\n".join(wrap(caption, CAPTION_COLUMNS)), fontsize=6.5, x=0.01, ha="left", fontweight="normal"
            )
        return svg(figure)


def _drawn(table: Table, chart: Chart) -> Table:
    rows = [row for row in table.rows if all(row.get(name) == value for name, value in chart.only.items())]
    return table.model_copy(update={"rows": rows})


def write_charts(findings: Findings, folder: Path, caption: str = "") -> list[Path]:
    """Write ``<chart>.svg`` of each chart into a folder."""
    written = []
    for chart in findings.charts:
        path = folder / f"{chart.name}.svg"
        write_text(path, chart_svg(findings, chart, caption))
        written.append(path)
    return written
