"""Cameras of cases: the published ``cameras.json``, those held out, what they are to see, and a good view of actors."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from c4s.geometry.transform import look_at
from c4s.records.level import Level, Vector
from c4s.records.suite import TARGET_CAMERAS
from c4s.semantics.sight import Target
from cases.boxes import Array, Boxes, world_box
from cases.model import CaseView, RepairCase


def cameras_record(case: RepairCase) -> dict[str, Any]:
    """The ``code4scene.cameras.v1`` record of a case."""
    first = case.views[0]
    return {
        "schema_version": "code4scene.cameras.v1",
        "case_id": case.case_id,
        "capture_map": "ground_truth",
        "capture": {
            "method": "scene_capture_2d",
            "width": first.width,
            "height": first.height,
            "capture_count": 1,
            "rotation": "look_at(location_cm, target_cm)",
            "fov": "fov_deg is the horizontal field of view of the capture component",
        },
        "views": [
            {
                "name": view.name,
                "location_cm": list(view.location_cm),
                "target_cm": list(view.target_cm),
                "fov_deg": view.fov_deg,
                "publish": {
                    "file": f"references/{view.name}.png",
                    "format": "png",
                    "width": view.width,
                    "height": view.height,
                },
            }
            for view in case.views
        ],
    }


def targets_record(case_id: str, cameras: Sequence[Mapping[str, Any]]) -> dict[str, Any]:
    """The record of a case's held-out cameras."""
    return {"schema_version": TARGET_CAMERAS, "case_id": case_id, "views": [dict(camera) for camera in cameras]}


def changed(truth: Level, corrupted: Level, boxes: Boxes) -> list[Target]:
    """What a corrupted level changes, where it is and where it was: boxes of actors that differ or are in one alone."""
    sides = [{actor.name: actor for actor in level.actors} for level in (truth, corrupted)]
    told = [{name: actor.model_dump(exclude={"guid"}) for name, actor in side.items()} for side in sides]
    found = []
    for side, own, other in ((sides[0], told[0], told[1]), (sides[1], told[1], told[0])):
        for name in sorted(side):
            if own[name] != other.get(name):
                low, high = world_box(side[name], side[name].transform, boxes)
                if np.isfinite(low).all():
                    found.append(Target(_point(low), _point(high)))
    return list(dict.fromkeys(found))


def _point(corner: Array) -> tuple[float, float, float]:
    x, y, z = (round(float(value), 3) for value in corner)
    return x, y, z


def camera(view: CaseView) -> dict[str, Any]:
    """A view as the camera that the engine captures with."""
    return {
        "name": view.name,
        "location_cm": list(view.location_cm),
        "rotation_deg": list(look_at(view.location_cm, view.target_cm)),
        "fov_deg": view.fov_deg,
        "width": view.width,
        "height": view.height,
    }


def orbit(
    name: str,
    target_cm: Vector,
    *,
    distance_cm: float,
    yaw_deg: float,
    pitch_deg: float = 20.0,
    fov_deg: float = 60.0,
    width: int = 1280,
    height: int = 720,
) -> CaseView:
    """A view of ``target_cm`` from ``distance_cm`` away: ``yaw_deg`` is the direction from the target to the camera,
    ``pitch_deg`` its height above the horizon."""
    yaw, pitch = math.radians(yaw_deg), math.radians(pitch_deg)
    x, y, z = target_cm
    place = (
        x + distance_cm * math.cos(pitch) * math.cos(yaw),
        y + distance_cm * math.cos(pitch) * math.sin(yaw),
        z + distance_cm * math.sin(pitch),
    )
    return CaseView(name, place, target_cm, fov_deg, width, height)
