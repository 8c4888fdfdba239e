"""Checks of pictures: their sizes, what they show where, and the bridge's screenshots."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image

from c4s.engine.bridge import FAILED
from c4s.engine.conformance.check import Group, need
from c4s.engine.conformance.ground import Ground

check = Group("pictures")
CHECKS = check.checks
_WIDTH, _HEIGHT = 160, 90
_CAMERA = {
    "name": "front",
    "location_cm": [-400.0, 0.0, 50.0],
    "rotation_deg": [0.0, 0.0, 0.0],
    "fov_deg": 60.0,
    "width": _WIDTH,
    "height": _HEIGHT,
}
_STAGE = """
box = place("Cube", 0, 0, 50)
box.set_actor_label("In the middle")
side = place("Sphere", 0, 150, 50)
side.set_actor_label("On the right")
sun = actors.spawn_actor_from_class(unreal.DirectionalLight, unreal.Vector(0, 0, 500), unreal.Rotator(0, -30, 20))
fact("names", [box.get_name(), side.get_name()])
"""


def _taken(ground: Ground, **camera: Any) -> tuple[dict[str, Any], Path, list[str]]:
    """The record of a capture of the stage, its folder, and the object names of box and ball."""
    names: list[str] = ground.facts(_STAGE)["names"]
    folder = ground.scratch / "pictures"
    records = ground.engine.call("capture.capture_views", cameras=[{**_CAMERA, **camera}], folder=str(folder))
    return records[0], folder, names


@check("A capture is a picture of the size that was asked for, with its camera on record")
def captures_have_their_size(ground: Ground) -> None:
    record, folder, _ = _taken(ground)
    with Image.open(folder / record["file"]) as picture:
        need(picture.size == (_WIDTH, _HEIGHT), f"it is {picture.size}")
    need(record["camera"]["location_cm"] == _CAMERA["location_cm"], f"its camera is {record['camera']}")


@check("A capture shows an actor where it stands: ahead in the middle, +Y on the right")
def captures_show_actors_where_they_stand(ground: Ground) -> None:
    record, folder, names = _taken(ground)
    if "actors" in record:
        mask = np.load(folder / record["actors"])
        middle, right = (int(mask["actor"][_HEIGHT // 2, column]) for column in (_WIDTH // 2, 132))
        seen = [str(mask["names"][index]) if index >= 0 else None for index in (middle, right)]
        need(seen == names, f"the middle and the right show {seen}, not {names}")
    with Image.open(folder / record["file"]) as picture:
        pixels = np.asarray(picture.convert("RGB"), dtype=int)
    empty, middle_pixel = pixels[_HEIGHT // 2, 8], pixels[_HEIGHT // 2, _WIDTH // 2]
    need(bool(np.abs(empty - middle_pixel).max() > 8), "the middle looks like the empty left")


@check("Where an engine masks actors, a mask has the distance to what it shows")
def masks_tell_the_distance(ground: Ground) -> None:
    record, folder, _ = _taken(ground)
    if "actors" in record:
        depth = float(np.load(folder / record["actors"])["depth_cm"][_HEIGHT // 2, _WIDTH // 2])
        need(abs(depth - 350) < 1, f"the box is 350 cm away, the mask says {depth:g}")


@check("A hidden actor is in no picture")
def hidden_actors_are_not_shown(ground: Ground) -> None:
    ground.facts(_STAGE + "box.set_actor_hidden_in_game(True)\nside.set_actor_hidden_in_game(True)\n")
    folder = ground.scratch / "pictures"
    for mode in ("lit", "base_color"):
        record = ground.engine.call("capture.capture_views", cameras=[_CAMERA], folder=str(folder), mode=mode)[0]
        need(not record.get("visible"), f"the {mode} picture shows {record.get('visible')}")


@check("The same scene from the same camera is the same picture")
def pictures_repeat(ground: Ground) -> None:
    _, folder, _ = _taken(ground)
    first = (folder / "front.png").read_bytes()
    ground.engine.call("capture.capture_views", cameras=[_CAMERA], folder=str(folder))
    with Image.open(folder / "front.png") as again, Image.open(_copy(folder, first)) as before:
        apart = np.abs(np.asarray(again.convert("RGB"), int) - np.asarray(before.convert("RGB"), int)).mean()
    need(float(apart) < 1.0, f"they differ by {apart:.2f} of 255 in the mean")


@check("The bridge takes a screenshot in the size that was asked for")
def the_bridge_takes_screenshots(ground: Ground) -> None:
    ground.facts(_STAGE)
    shot = {"camera_location": [-400, 0, 50], "camera_rotation": [0, 0, 0], "width": 64, "height": 48}
    reply = ground.engine.request("take_screenshot", shot)
    need(reply["status"] not in FAILED, f"it was answered with {str(reply)[:200]}")
    with Image.open(reply["filepath"]) as picture:
        need(picture.size == (64, 48), f"it is {picture.size}")


@check("A screenshot of no size is refused")
def screenshots_of_no_size_are_refused(ground: Ground) -> None:
    reply = ground.engine.request("take_screenshot", {"width": 0})
    need(reply["status"] in FAILED, f"it was answered with {str(reply)[:200]}")


def _copy(folder: Path, data: bytes) -> Path:
    path = folder / "before.png"
    path.write_bytes(data)
    return path
