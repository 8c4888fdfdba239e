"""The picture of a study of repeats, as SVG: each repeat's mean of a configuration less the configuration's own mean,
with the absolute mean and the sample standard deviation at the right (paper, the figure of judge repeatability)."""

from __future__ import annotations

from xml.sax.saxutils import escape

from c4s.names import shown
from c4s.records.repeatability import Repeatability, RepeatedConfiguration
from reports.charts.style import COLOURS

NAME, PLOT, RIGHT, ROW, HEAD, FOOT = 220, 460, 150, 26, 34, 44
"""Pixels: widths of the names, the plot and the numbers; heights of a row, what is above and what is below."""
LEAST_REACH, MARGIN = 0.001, 1.1
"""Half the width of the axis where nothing deviates by more, and how much wider it is than what it shows."""
MOST_WORDS = 6
"""Repeats that are told in words; more are told by number."""
MOST_NAME = 30
"""Characters of a configuration's name that fit."""


def deviations_svg(found: Repeatability) -> str:
    """The picture; a row a configuration, the best first, a mark a repeat."""
    reach = max([LEAST_REACH, *(abs(off) for row in found.configurations for off in row.deviations)]) * MARGIN
    width, height = NAME + PLOT + RIGHT, HEAD + ROW * len(found.configurations) + FOOT
    bottom = height - FOOT
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" viewBox="0 0 {width} {height}" '
        'font-family="sans-serif" font-size="12">',
        f'<rect width="{width}" height="{height}" fill="white"/>',
        _text(NAME + PLOT + 60, 20, "mean", "end"),
        _text(width - 14, 20, "SD", "end"),
    ]
    for share in (-1.0, -0.5, 0.0, 0.5, 1.0):
        x = _x(share * reach / MARGIN, reach)
        shade = "#888" if share == 0 else "#ddd"
        parts.append(f'<line x1="{x:.1f}" y1="{HEAD - 6}" x2="{x:.1f}" y2="{bottom}" stroke="{shade}"/>')
        parts.append(_text(x, bottom + 16, f"{share * reach / MARGIN:+.4f}" if share else "0", "middle"))
    for number, row in enumerate(found.configurations):
        parts += _row(row, HEAD + ROW * number + ROW / 2, reach, width)
    few = found.repeats <= MOST_WORDS
    for number in range(found.repeats):
        x = NAME + (PLOT + RIGHT) / max(found.repeats, MOST_WORDS) * number
        parts.append(_mark(number, x, height - 12))
        parts.append(_text(x + 10, height - 8, f"repeat {number + 1}" if few else str(number + 1)))
    return "\n".join([*parts, "</svg>", ""])


def _row(row: RepeatedConfiguration, y: float, reach: float, width: int) -> list[str]:
    name = row.configuration if len(row.configuration) <= MOST_NAME else f"{row.configuration[: MOST_NAME - 1]}…"
    return [
        _text(NAME - 12, y + 4, f"{row.rank}. {name}", "end"),
        *(_mark(number, _x(off, reach), y) for number, off in enumerate(row.deviations)),
        _text(NAME + PLOT + 60, y + 4, f"{row.mean:.4f}", "end"),
        _text(width - 14, y + 4, f"{row.sd:.4f}", "end"),
    ]


def _x(deviation: float, reach: float) -> float:
    return NAME + PLOT / 2 * (1 + deviation / reach)


def _mark(number: int, x: float, y: float) -> str:
    colour = f'fill="{COLOURS[number % len(COLOURS)]}" fill-opacity="0.85"'
    shape = number % 3
    if shape == 0:
        return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="4.5" {colour}/>'
    if shape == 1:
        return f'<rect x="{x - 4:.1f}" y="{y - 4:.1f}" width="8" height="8" {colour}/>'
    return f'<path d="M{x:.1f} {y - 5:.1f} l5 9 h-10 z" {colour}/>'


def _text(x: float, y: float, text: str, anchor: str = "start") -> str:
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}">{escape(shown(text))}</text>'
