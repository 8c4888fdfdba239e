"""The map of a walk: where one can walk, which targets are reached and which not, the routes, and how each walk went.

Plan views look down: X to the right, Y downwards, as the engine's left-handed axes have it. Lengths in cm.
"""

from __future__ import annotations

import base64
import io
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from PIL import Image

from c4s.records.navigation import ELSEWHERE, MAIN, NEAR, NavigationMap
from c4s.verify.navigation.verifier import NAVIGATION
from reports.frame.board import Row

FALLS: Final = {
    "connected": "reached",
    "unconnected": "no way from the largest area",
    "unreached": "no room to stand within a metre",
    "raised": "scenery, above the floor",
    "buried": "scenery, under the floor",
}
_COLOURS: Final = {MAIN: (148, 205, 166), ELSEWHERE: (240, 196, 120), NEAR: (214, 220, 226)}
_HASTE: Final = 4.0
"""The animation runs so many times as fast as the walk."""
_MARGIN, _MARGIN_CM = 0.15, 200.0
_LEAST: Final = 0.006
"""Targets are drawn at least this large, as a share of the map's longer side."""


Box = tuple[float, float, float, float]
"""x, y, width, height."""


@dataclass(frozen=True)
class Walked:
    """One walk."""

    route: str
    """Points of a polyline."""
    trace: str
    steps: str
    """Places of the animation, at equal times."""
    seconds: float
    """Of the animation."""
    end: tuple[float, float]
    told: Mapping[str, Any]


@dataclass(frozen=True)
class Spot:
    """A target on the map."""

    label: str
    fall: str
    box: Box


@dataclass(frozen=True)
class WalkMap:
    """What the section shows."""

    status: str
    reason: str
    view: Box
    """x, y, width, height of the picture; zeros where there is none."""
    ground: str
    """The walkable area as a data URL of a PNG."""
    place: Box
    """Where it lies."""
    spots: Sequence[Spot]
    walks: Sequence[Walked]
    anchor: tuple[float, float] | None
    counts: Mapping[str, int]
    numbers: Mapping[str, float | None]
    advisories: Sequence[Mapping[str, Any]]

    @property
    def stroke(self) -> float:
        """Width of lines."""
        return max(self.view[2:]) / 220


def walk_of(document: Mapping[str, Any] | None) -> WalkMap | None:
    """The section of a trial's navigation verdict; None where there is none."""
    if document is None:
        return None
    measured = document["measurements"]
    picture = measured.get("picture") or {}
    chart = None if not picture.get("map") else NavigationMap.parse(picture["map"])
    place = view = (0.0, 0.0, 0.0, 0.0)
    anchor = picture.get("anchor")
    targets = picture.get("targets", [])
    if chart is not None:
        place = (*chart.low_cm, chart.columns * chart.pixel_cm, chart.rows * chart.pixel_cm)
        view = _view(
            place, [target[2:6] for target in targets], [*picture.get("traces", []), [anchor] if anchor else []]
        )
    pairs = zip(picture.get("routes", []), picture.get("traces", []), measured.get("walks", []), strict=False)
    return WalkMap(
        status=str(document["status"]),
        reason=str(document.get("reason") or ""),
        view=view,
        ground="" if chart is None else _png(chart),
        place=place,
        spots=[_spot(target, _LEAST * max(view[2:])) for target in targets] if chart is not None else [],
        walks=[_walked(route, trace, told) for route, trace, told in pairs],
        anchor=None if not anchor else (anchor[0], anchor[1]),
        counts=Counter(target[1] for target in targets),
        numbers={"EUS": document.get("score"), "A": measured.get("approachability"), "W": measured.get("completion")},
        advisories=document.get("advisories") or [],
    )


def _view(place: Box, boxes: Sequence[Sequence[float]], lines: Sequence[Sequence[Sequence[float]]]) -> Box:
    """What of a map is shown: targets and walks with a margin; of a plain around them no more than that."""
    points = [
        *(box[:2] for box in boxes),
        *(box[2:] for box in boxes),
        *(point[:2] for line in lines for point in line),
    ]
    if not points:
        return place
    low, high = np.min(points, axis=0), np.max(points, axis=0)
    margin = max(_MARGIN * float(np.max(high - low)), _MARGIN_CM)
    low = np.maximum(low - margin, place[:2])
    high = np.minimum(high + margin, np.add(place[:2], place[2:]))
    if not np.all(high > low):
        return place
    return float(low[0]), float(low[1]), float(high[0] - low[0]), float(high[1] - low[1])


def astray(findings: Sequence[Row]) -> list[Row]:
    """Findings about targets that count as not reached; scenery and walks are told elsewhere."""
    return [
        row for row in findings if row["verifier"] == NAVIGATION.name and row["outcome"] in ("unconnected", "unreached")
    ]


def _png(chart: NavigationMap) -> str:
    pixels = np.frombuffer(chart.pixels(), np.uint8).reshape(chart.rows, chart.columns)
    shown = np.zeros((*pixels.shape, 4), np.uint8)
    for value, colour in _COLOURS.items():
        shown[pixels == value] = (*colour, 255)
    made = io.BytesIO()
    Image.fromarray(shown).quantize(8).save(made, "PNG", optimize=True)
    return "data:image/png;base64," + base64.b64encode(made.getvalue()).decode()


def _spot(target: Sequence[Any], least: float) -> Spot:
    label, fall, *box = target
    x0, y0, x1, y1 = (float(part) for part in box[:4])
    width, depth = max(x1 - x0, least), max(y1 - y0, least)
    return Spot(str(label), str(fall), ((x0 + x1 - width) / 2, (y0 + y1 - depth) / 2, width, depth))


def _walked(route: Sequence[Any], trace: Sequence[Any], told: Mapping[str, Any]) -> Walked:
    def line(points: Sequence[Any], between: str) -> str:
        return between.join(f"{point[0]},{point[1]}" for point in points)

    seconds = round(max(float(told["seconds"]) / _HASTE, 0.5), 2)
    return Walked(line(route, " "), line(trace, " "), line(trace, ";"), seconds, (trace[-1][0], trace[-1][1]), told)
