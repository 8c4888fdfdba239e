"""Reference cameras: the published ``cameras.json`` record, and a good view of chosen actors."""

from __future__ import annotations

import math
from typing import Any

from c4s.geometry.transform import look_at
from c4s.records.level import Vector
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
