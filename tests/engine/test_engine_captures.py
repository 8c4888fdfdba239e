"""Pictures that scripts take with a capture actor and a render target."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from c4s.engine.headless.process.boot import boot


def test_a_capture_actor_draws_into_its_target(tmp_path: Path):
    unreal = boot([], tmp_path / "content")
    world = unreal.get_editor_subsystem(unreal.UnrealEditorSubsystem).get_editor_world()
    spawn = unreal.EditorLevelLibrary.spawn_actor_from_class
    cube = unreal.EditorLevelLibrary.spawn_actor_from_object(
        unreal.load_asset("/Engine/BasicShapes/Cube"), unreal.Vector(300, 0, 0)
    )
    red = cube.static_mesh_component.create_dynamic_material_instance(0)
    red.set_vector_parameter_value("BaseColor", unreal.LinearColor(1, 0, 0, 1))
    capture = spawn(unreal.SceneCapture2D, unreal.Vector()).capture_component2d
    target = unreal.RenderingLibrary.create_render_target2d(world, 40, 30, unreal.TextureRenderTargetFormat.RTF_RGBA8)
    capture.capture_scene()
    capture.set_editor_property("texture_target", target)
    capture.set_editor_property("capture_source", unreal.SceneCaptureSource.SCS_BASE_COLOR)
    capture.capture_scene()
    unreal.RenderingLibrary.export_render_target(world, target, str(tmp_path), "shot")
    with Image.open(tmp_path / "shot.png") as picture:
        pixels = np.asarray(picture)
    assert pixels.shape == (30, 40, 3)
    centre = unreal.RenderingLibrary.read_render_target_pixel(world, target, 20, 15)
    assert centre.r > 200 and centre.g < 40 and centre.b < 40
    assert tuple(pixels[15, 20]) == (centre.r, centre.g, centre.b)
    reds = (pixels[..., 0] > 150) & (pixels[..., 1] < 60)
    near_face_cm, half_width = 250.0, 20.0
    assert abs(np.count_nonzero(reds[15]) - 2 * half_width * 50 / near_face_cm) <= 2
    capture.get_owner().set_actor_rotation(unreal.Rotator(yaw=180), False)
    capture.capture_scene()
    away = unreal.RenderingLibrary.read_render_target_pixel(world, target, 20, 15)
    assert not (away.r > 150 and away.g < 60)


def test_what_cannot_be_drawn_is_said(tmp_path: Path):
    unreal = boot([], tmp_path)
    capture = unreal.EditorLevelLibrary.spawn_actor_from_class(unreal.SceneCapture2D, unreal.Vector())
    part = capture.capture_component2d
    assert unreal.RenderingLibrary.create_render_target2d(None, 0, 10) is None
    part.texture_target = unreal.RenderingLibrary.create_render_target2d(None, 8, 8)
    part.capture_source = unreal.SceneCaptureSource.SCS_NORMAL
    with pytest.raises(Exception, match="SCS_NORMAL is not drawn"):
        part.capture_scene()
    assert unreal.EditorLevelLibrary.spawn_actor_from_class(unreal.SceneCapture, unreal.Vector()) is None
