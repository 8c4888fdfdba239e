"""One style for all charts: readable in print, by the colour-blind, and the same bytes for the same data."""

from __future__ import annotations

import io
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any, Final

from c4s.names import shown

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

COLOURS: Final = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000")
"""Of Okabe and Ito: told apart without red and green too."""
MARKERS: Final = ("o", "s", "^", "D", "v", "P", "X")
"""Series differ by shape as well as by colour."""
DASHES: Final = ("-", "--", ":")
"""Of lines, where there are more than colours."""
CAPTION_COLUMNS: Final = 120
HATCHES: Final = ("", "///", "...", "xxx", "\\\\\\", "+++", "ooo")
HEAT: Final = "cividis"
"""Colours of heat maps: even in lightness, alike to all eyes."""
INK, FAINT = "#222222", "#d9d9d9"
WIDTH_IN, ROW_IN, LEAST_IN = 7.2, 0.28, 1.8
"""Inches: width of a chart, height of a row of it, and the least height of its rows."""
PLOT_ROWS: Final = 12
"""Height of a plot with two axes of numbers, in rows."""
LONGEST_NAME: Final = 34
_RC: Final[Any] = {
    "svg.fonttype": "none",
    "svg.hashsalt": "c4s",
    "font.family": "sans-serif",
    "font.sans-serif": ["DejaVu Sans"],
    "font.size": 9,
    "axes.titlesize": 10,
    "axes.titleweight": "bold",
    "axes.titlelocation": "left",
    "axes.edgecolor": INK,
    "axes.labelcolor": INK,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "axes.axisbelow": True,
    "grid.color": FAINT,
    "grid.linewidth": 0.6,
    "legend.frameon": False,
    "text.color": INK,
    "text.parse_math": False,
    "xtick.color": INK,
    "ytick.color": INK,
}


@contextmanager
def drawing(rows: int) -> Iterator[tuple[Figure, Axes]]:
    """A figure with room for so many rows."""
    import matplotlib

    matplotlib.use("svg")
    from matplotlib import pyplot, rc_context

    with rc_context(_RC):
        height = max(LEAST_IN, ROW_IN * rows) + 1.1
        figure, axes = pyplot.subplots(figsize=(WIDTH_IN, height), layout="constrained")
        try:
            yield figure, axes
        finally:
            pyplot.close(figure)


def svg(figure: Figure) -> str:
    """The figure as SVG whose letters stay letters; nothing in it tells when it was made."""
    made = io.StringIO()
    figure.savefig(made, format="svg", metadata={"Date": None, "Creator": "c4s"})
    return made.getvalue()


def short(name: object) -> str:
    """A name that fits."""
    text = shown(str(name))
    return text if len(text) <= LONGEST_NAME else f"{text[: LONGEST_NAME - 1]}…"
