"""Cameras of a place: one over the whole of it, and such at the height of eyes as nothing stands in the way of."""

from __future__ import annotations

import math
from dataclasses import replace

from c4s.records.level import Vector
from cases.model import CaseView
from cases.open190.layout import StagedPlace
from cases.open190.space import Solid

AHEAD_CM = (60.0, 200.0, 340.0, 600.0)
"""Nothing may stand that far in front of the eye."""
RINGS_CM, TURNS = (0.0, 90.0, 180.0, 270.0, 360.0, 500.0, 700.0, 950.0, 1250.0, 1600.0), 10
LEAFY = ("tree", "conifer", "palm", "bush", "arbour")
"""Families whose crowns have no collision body."""


def overview(place: StagedPlace) -> CaseView:
    """A camera that sees the whole place from above one side."""
    solid = [item for item in place.items.values() if not item.thing.flat] or list(place.items.values())
    xs, ys = sorted(item.x for item in solid), sorted(item.y for item in solid)
    cut = len(xs) // 50
    x0, x1, y0, y1 = xs[cut], xs[-1 - cut], ys[cut], ys[-1 - cut]
    reach = max(x1 - x0, y1 - y0, 400.0)
    centre = ((x0 + x1) / 2, (y0 + y1) / 2, 0.0)
    return CaseView("above", (centre[0] - 0.28 * reach, centre[1] + 0.78 * reach, 0.62 * reach + 200), centre, 62.0)


def views(place: StagedPlace) -> list[CaseView]:
    """The cameras of a place, each moved to the nearest spot that is free; two across it where it names none."""
    named = place.views or [
        CaseView("south", (0.0, -3000.0, 175.0), (0.0, 1500.0, 160.0), 72.0),
        CaseView("east", (2700.0, 500.0, 230.0), (-1500.0, -300.0, 120.0), 72.0),
    ]
    return [overview(place), *(replace(view, location_cm=_free_spot(place, view)) for view in named)]


def _free_spot(place: StagedPlace, view: CaseView) -> Vector:
    x, y, z = view.location_cm
    for reach in RINGS_CM:
        for turn in range(TURNS if reach else 1):
            angle = 2 * math.pi * turn / TURNS
            spot = (round(x + reach * math.cos(angle), 1), round(y + reach * math.sin(angle), 1), z)
            if _is_free(place, spot, view.target_cm):
                return spot
    return view.location_cm


def _is_free(place: StagedPlace, eye: Vector, target: Vector) -> bool:
    length = math.hypot(target[0] - eye[0], target[1] - eye[1]) or 1.0
    dx, dy = (target[0] - eye[0]) / length, (target[1] - eye[1]) / length
    spots = [(eye[0] + dx * ahead, eye[1] + dy * ahead) for ahead in AHEAD_CM]
    around = [block(px, py, eye[2], 45.0 + 20.0 * i) for i, (px, py) in enumerate([(eye[0], eye[1]), *spots])]
    if not place.space.free(around):
        return False
    for item in place.items.values():
        if item.thing.family in LEAFY:
            reach = max(item.thing.width, item.thing.depth) * item.scale[0] / 2
            if any(math.hypot(item.x - px, item.y - py) < reach * 0.8 + 30 for px, py in spots):
                return False
    return True


def block(x: float, y: float, z: float, half: float) -> Solid:
    """The air around a place, in cm: so far to each side, a little below and above."""
    return Solid(
        ((x - half, y - half), (x + half, y - half), (x + half, y + half), (x - half, y + half)), z - 60, z + 40
    )
