"""Drawings of pages: places of marks in a plane of numbers, drawn by templates so that colours follow the reader's."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Final

WIDTH, HEIGHT = 720.0, 380.0
LEFT, RIGHT, TOP, BOTTOM = 54.0, 150.0, 16.0, 44.0
"""Space around the plane: for numbers, for names, for the title of the axis."""
LINE: Final = 13.0
"""Height of a name."""
MOST_TICKS: Final = 6
STEPS: Final = (1.0, 2.0, 5.0)


@dataclass(frozen=True)
class Dot:
    """A thing in the plane."""

    name: str
    x: float
    y: float
    low: float | None = None
    high: float | None = None
    """Ends of its interval along y."""
    strong: bool = False
    """Whether it is on the line."""
    link: str = ""


@dataclass(frozen=True)
class PlacedDot:
    """A dot with its places on the drawing, in its units."""

    dot: Dot
    x: float
    y: float
    low: float | None
    high: float | None
    name_y: float


@dataclass(frozen=True)
class Scatter:
    """A plane with dots, its strong ones joined by steps."""

    dots: list[PlacedDot]
    x_ticks: list[tuple[float, str]]
    y_ticks: list[tuple[float, str]]
    path: str
    x_title: str
    y_title: str
    width: float = WIDTH
    height: float = HEIGHT
    left: float = LEFT
    right: float = WIDTH - RIGHT
    top: float = TOP
    bottom: float = HEIGHT - BOTTOM


def scatter(dots: Sequence[Dot], x_title: str, y_title: str) -> Scatter | None:
    """The drawing; the horizontal axis is logarithmic. None where no dot has a place on it."""
    shown = sorted((dot for dot in dots if dot.x > 0), key=lambda dot: (dot.x, dot.name))
    if not shown:
        return None
    xs = [math.log10(dot.x) for dot in shown]
    least_x, most_x = _wide(min(xs), max(xs), 0.06)
    ends = [end for dot in shown for end in (dot.y, dot.low, dot.high) if end is not None]
    least_y, most_y = _wide(min(ends), max(ends), max(0.02, 0.05 * (max(ends) - min(ends))))

    def across(value: float) -> float:
        return LEFT + (math.log10(value) - least_x) / (most_x - least_x) * (WIDTH - LEFT - RIGHT)

    def up(value: float) -> float:
        return HEIGHT - BOTTOM - (value - least_y) / (most_y - least_y) * (HEIGHT - TOP - BOTTOM)

    names = _apart([up(dot.y) for dot in shown], [across(dot.x) for dot in shown])
    placed = [
        PlacedDot(dot, across(dot.x), up(dot.y), _maybe(up, dot.low), _maybe(up, dot.high), name)
        for dot, name in zip(shown, names, strict=True)
    ]
    path = ""
    for one in placed:
        if one.dot.strong:
            path += f"M{one.x:.1f} {one.y:.1f}" if not path else f"H{one.x:.1f}V{one.y:.1f}"
    return Scatter(
        placed,
        [(across(value), f"{value:g}") for value in _log_ticks(least_x, most_x)],
        [(up(value), f"{value:g}") for value in ticks(least_y, most_y)],
        path,
        x_title,
        y_title,
    )


def ticks(least: float, most: float) -> list[float]:
    """Round numbers between two."""
    rough = (most - least) / MOST_TICKS
    scale = 10 ** math.floor(math.log10(rough))
    step = next(scale * one for one in (*STEPS, 10.0) if scale * one >= rough)
    return [round(place * step, 10) for place in range(math.ceil(least / step), math.floor(most / step) + 1)]


def _log_ticks(least: float, most: float) -> list[float]:
    decades = range(math.floor(least), math.ceil(most) + 1)
    found = [step * 10.0**decade for decade in decades for step in STEPS if least <= math.log10(step) + decade <= most]
    return found if len(found) > 1 else ticks(10**least, 10**most)


def _wide(least: float, most: float, margin: float) -> tuple[float, float]:
    return least - margin, most + margin


def _maybe(place: Callable[[float], float], value: float | None) -> float | None:
    return None if value is None else place(value)


def _apart(ys: Sequence[float], xs: Sequence[float]) -> list[float]:
    """Heights of names right of their dots, moved where another one stands there already."""
    taken: list[tuple[float, float]] = []
    found = [0.0] * len(ys)
    for place in sorted(range(len(ys)), key=lambda one: ys[one]):
        y = ys[place]
        while any(abs(x - xs[place]) < RIGHT * 0.7 and abs(y - other) < LINE for x, other in taken):
            y += LINE / 4
        taken.append((xs[place], y))
        found[place] = y
    return found
