"""Pictures of the open level: viewport screenshots, and views with, for every pixel, the actor that it shows.

A host that renders by itself offers ``pictures`` (``c4s.editor.host``). Without them, pictures come from a
SceneCapture2D of the editor, which has no actor mask.

A camera is ``{"name", "location_cm", "rotation_deg" ([pitch, yaw, roll]) or "target_cm", "fov_deg" (horizontal),
"width", "height"}``. A shot is the bridge's: ``camera_location``, ``camera_rotation`` ([roll, pitch, yaw]),
``field_of_view``, ``width``, ``height``, ``exposure_bias_ev``, ``filepath``; without a location it is the viewport's
camera. What else the published bridge takes (``exposure_mode``) is left to the level's post-process.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import unreal

from c4s.editor.host import Camera, Record, host

WIDTH, HEIGHT, FIELD_OF_VIEW = 1280, 720, 90.0
SHOT_WIDTH, SHOT_HEIGHT, SHOT_FIELD_OF_VIEW = 1920, 1080, 55.0
"""What the published bridge takes where a shot names its camera and leaves these out."""
MODES = ("lit", "base_color")
_CAPTURES_OF_ONE = 4
_LARGEST_CONTENT_CM = 10000.0
_EMPTY_CM = 500.0
_FRAME_PITCH_DEG, _FRAME_YAW_DEG = -35.0, 45.0
_PNG_END = b"IEND\xaeB`\x82"


def take_screenshots(shots: Sequence[Mapping[str, Any]], folder: str) -> Record:
    """Take shots, one file each (default ``folder/shot-<n>.png``); the bridge's ``take_screenshot_batch`` reply."""
    results, missing = [], []
    for number, shot in enumerate(shots, 1):
        path = Path(folder, str(shot.get("filepath") or f"shot-{number}.png"))
        extras = _pictures([_shot_camera(shot)], [path], shot.get("mode", "lit"), bool(shot.get("actors")))
        if path.is_file():
            results.append({"filepath": str(path), "filename": path.name, **extras[0]})
        else:
            missing.append(str(path))
    return {"status": "partial" if missing else "success", "results": results, "missing": missing}


def capture_views(cameras: Sequence[Camera], folder: str, mode: str = "lit", actors: bool = True) -> list[Record]:
    """Write ``folder/<name>.png`` a camera, and with ``actors`` ``<name>.actors.npz``; a record a view.

    The npz holds ``actor`` (H, W) int32, an index into ``names`` and ``labels`` or -1, and ``depth_cm`` (H, W) float32.
    A record's ``visible`` counts the pixels of each actor by object name.
    """
    named = _named(cameras)
    files = [Path(folder, f"{camera['name']}.png") for camera in named]
    pictures = _pictures(named, files, mode, actors)
    return [
        {**_record(camera, mode), **extra, **_mask(camera, actors)}
        for camera, extra in zip(named, pictures, strict=True)
    ]


def probe_views(cameras: Sequence[Camera]) -> list[Record] | None:
    """What each camera would see, cheaply and without a picture; null where this editor has no actor masks.

    A record holds ``visible`` (pixels of each actor by object name), ``edge`` (object names of the actors that touch
    the border), ``near_share`` (share of the pixels that show something within 40 cm) and ``empty_share``.
    """
    pictures = host().pictures
    return None if pictures is None else pictures.probe(_named(cameras))


def plan_views(cameras: Sequence[Camera], mode: str = "lit") -> list[Record]:
    """What ``capture_views`` would return, without ``visible``; nothing is rendered.

    A record has a ``key`` where the host knows what the picture depends on: those of equal keys are the same bytes.
    """
    named = _named(cameras)
    pictures = host().pictures
    known = [{"key": key} for key in pictures.keys(named, mode)] if pictures is not None else [{} for _ in named]
    return [{**_record(camera, mode), **_mask(camera, True), **key} for camera, key in zip(named, known, strict=True)]


def _named(cameras: Sequence[Camera]) -> list[Record]:
    return [
        {**camera, **_pose(camera), "name": str(camera.get("name") or f"view-{number}")}
        for number, camera in enumerate(cameras, 1)
    ]


def _record(camera: Camera, mode: str) -> Record:
    kept = {key: camera[key] for key in ("location_cm", "rotation_deg", "fov_deg", "width", "height")}
    return {"name": camera["name"], "file": f"{camera['name']}.png", "mode": mode, "camera": kept}


def _mask(camera: Camera, actors: bool) -> Record:
    return {"actors": f"{camera['name']}.actors.npz"} if actors and host().pictures is not None else {}


def viewport_camera() -> Record:
    """The place and rotation of the level viewport's camera."""
    info = unreal.get_editor_subsystem(unreal.UnrealEditorSubsystem).get_level_viewport_camera_info()
    if not info:
        raise RuntimeError("the editor has no level viewport")
    location, rotation = info[-2], info[-1]
    return {
        "location_cm": [location.x, location.y, location.z],
        "rotation_deg": [rotation.pitch, rotation.yaw, rotation.roll],
    }


def frame_level() -> Record:
    """Put the viewport's camera where it sees the level's content (actors of up to 100 m), obliquely from above."""
    low, high = [math.inf] * 3, [-math.inf] * 3
    for actor in unreal.get_editor_subsystem(unreal.EditorActorSubsystem).get_all_level_actors():
        origin, extent = actor.get_actor_bounds(False)
        size = max(extent.x, extent.y, extent.z)
        if not 0 < size <= _LARGEST_CONTENT_CM / 2:
            continue
        for axis, (middle, half) in enumerate(
            zip((origin.x, origin.y, origin.z), (extent.x, extent.y, extent.z), strict=True)
        ):
            low[axis], high[axis] = min(low[axis], middle - half), max(high[axis], middle + half)
    if not math.isfinite(low[0]):
        low, high = [-_EMPTY_CM, -_EMPTY_CM, 0.0], [_EMPTY_CM, _EMPTY_CM, _EMPTY_CM]
    centre = [(a + b) / 2 for a, b in zip(low, high, strict=True)]
    radius = max(math.dist(low, high) / 2, _EMPTY_CM / 2)
    pitch, yaw = math.radians(_FRAME_PITCH_DEG), math.radians(_FRAME_YAW_DEG)
    distance = radius / math.sin(math.radians(FIELD_OF_VIEW / 2))
    place = unreal.Vector(
        centre[0] - distance * math.cos(pitch) * math.cos(yaw),
        centre[1] - distance * math.cos(pitch) * math.sin(yaw),
        centre[2] - distance * math.sin(pitch),
    )
    turn = unreal.Rotator(roll=0.0, pitch=_FRAME_PITCH_DEG, yaw=_FRAME_YAW_DEG)
    unreal.get_editor_subsystem(unreal.UnrealEditorSubsystem).set_level_viewport_camera_info(place, turn)
    return viewport_camera()


def _shot_camera(shot: Mapping[str, Any]) -> Record:
    own = shot.get("camera_location") is not None
    width, height, fov_deg = (SHOT_WIDTH, SHOT_HEIGHT, SHOT_FIELD_OF_VIEW) if own else (WIDTH, HEIGHT, FIELD_OF_VIEW)
    camera = {
        "width": int(shot.get("width") or width),
        "height": int(shot.get("height") or height),
        "fov_deg": float(shot.get("field_of_view") or fov_deg),
        "exposure_bias_ev": float(shot.get("exposure_bias_ev") or 0.0),
    }
    if not own:
        return {**viewport_camera(), **camera}
    roll, pitch, yaw = shot.get("camera_rotation") or (0.0, 0.0, 0.0)
    return {**camera, "location_cm": list(shot["camera_location"]), "rotation_deg": [pitch, yaw, roll]}


def _pose(camera: Camera) -> Record:
    """Rotation, field of view and size of a camera, with what it leaves out."""
    rotation = camera.get("rotation_deg")
    if rotation is None:
        x, y, z = (t - e for e, t in zip(camera["location_cm"], camera["target_cm"], strict=True))
        rotation = [math.degrees(math.atan2(z, math.hypot(x, y))), math.degrees(math.atan2(y, x)), 0.0]
    size = camera.get("publish") or {}
    return {
        "rotation_deg": list(rotation),
        "fov_deg": float(camera.get("fov_deg") or FIELD_OF_VIEW),
        "width": int(camera.get("width") or size.get("width") or WIDTH),
        "height": int(camera.get("height") or size.get("height") or HEIGHT),
    }


def _pictures(cameras: Sequence[Camera], files: Sequence[Path], mode: str, actors: bool) -> list[Record]:
    if mode not in MODES:
        raise ValueError(f"mode must be one of {', '.join(MODES)}")
    for path in files:
        path.parent.mkdir(parents=True, exist_ok=True)
    pictures = host().pictures
    if pictures is not None:
        return pictures.take(cameras, [str(path) for path in files], mode, actors)
    for camera, path in zip(cameras, files, strict=True):
        _scene_capture(camera, path, mode)
    return [{} for _ in cameras]


def _scene_capture(camera: Camera, path: Path, mode: str) -> None:
    """A picture by a SceneCapture2D, which is destroyed again."""
    world = unreal.get_editor_subsystem(unreal.UnrealEditorSubsystem).get_editor_world()
    actors = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)
    pitch, yaw, roll = camera["rotation_deg"]
    capture = actors.spawn_actor_from_class(
        unreal.SceneCapture2D, unreal.Vector(*camera["location_cm"]), unreal.Rotator(roll=roll, pitch=pitch, yaw=yaw)
    )
    target = unreal.RenderingLibrary.create_render_target2d(
        world, camera["width"], camera["height"], unreal.TextureRenderTargetFormat.RTF_RGBA8
    )
    try:
        component = capture.capture_component2d
        component.set_editor_property("capture_every_frame", False)
        component.set_editor_property("capture_on_movement", False)
        component.set_editor_property("fov_angle", camera["fov_deg"])
        component.set_editor_property(
            "capture_source",
            unreal.SceneCaptureSource.SCS_BASE_COLOR
            if mode == "base_color"
            else unreal.SceneCaptureSource.SCS_FINAL_COLOR_LDR,
        )
        component.set_editor_property("texture_target", target)
        for _ in range(_CAPTURES_OF_ONE):
            component.capture_scene()
        unreal.RenderingLibrary.export_render_target(world, target, str(path.parent), path.name)
        _trim(path)
    finally:
        unreal.RenderingLibrary.release_render_target2d(target)
        actors.destroy_actor(capture)


def _trim(path: Path) -> None:
    """Cut what some engine versions leave behind the end of a PNG."""
    data = path.read_bytes()
    end = data.find(_PNG_END)
    if end >= 0 and end + len(_PNG_END) < len(data):
        path.write_bytes(data[: end + len(_PNG_END)])
