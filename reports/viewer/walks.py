"""Where a body can walk in a scene, for the 3D view: floors, targets and routes of a navigation verdict, in cm."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np

from c4s.records.navigation import NavigationFloors
from c4s.verify.navigation.verifier import NAVIGATION

Row = Mapping[str, Any]


def walk_of_verdicts(verdicts: Iterable[Row]) -> dict[str, Any] | None:
    """What the viewer draws; None where a trial has no navigation verdict, or one of which there is nothing to draw.

    ``floors`` is None where the verdict tells none: rows of low x, low y, high x, high y, height, and 1 in the largest
    area. ``targets``: label, how it falls, low x, low y, high x, high y, height of its foot. ``routes``: points, goal,
    and whether the walk arrived.
    """
    for verdict in verdicts:
        measured = verdict["document"]["measurements"]
        if verdict["verifier"] == NAVIGATION.name and "picture" in measured:
            return _drawn(measured["picture"], measured.get("walks", []))
    return None


def _drawn(picture: Row, walks: Iterable[Row]) -> dict[str, Any]:
    floors = picture.get("floors")
    return {
        "floors": None if floors is None else _rows(NavigationFloors.parse(floors)),
        "targets": [target for target in picture["targets"] if len(target) == _WITH_HEIGHT],
        "routes": [
            {"points": points, "goal": walk["goal"], "arrived": walk["arrived"]}
            for points, walk in zip(picture["routes"], walks, strict=False)
        ],
    }


_WITH_HEIGHT = 7
"""Fields of a target; verdicts of old tell no height."""


def _rows(floors: NavigationFloors) -> list[list[float]]:
    rows = np.frombuffer(floors.rows(), "<i4").reshape(-1, 6)
    return [[*(part / 10 for part in row[:5]), row[5]] for row in rows.tolist()]
