"""Cameras that scripts place to draw the level into a render target."""

# ruff: noqa: RUF012  (each class declares its table of properties; no table is ever changed)

from __future__ import annotations

from enum import unique
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np
from PIL import Image

from c4s.engine.headless.editor import world
from c4s.engine.headless.unreal.actors import Actor
from c4s.engine.headless.unreal.assets import Texture
from c4s.engine.headless.unreal.components import SceneComponent
from c4s.engine.headless.unreal.core import EnumBase, Object, Prop, api, public
from c4s.engine.headless.unreal.enums import ComponentMobility
from c4s.engine.headless.unreal.lights import PostProcessSettings
from c4s.engine.headless.unreal.structs import LinearColor

MAX_SIDE = 4096


@public
@unique
class SceneCaptureSource(EnumBase):
    """What is drawn: the lit colours, or the surfaces' own; the rest is refused when it is asked for."""

    SCS_SCENE_COLOR_HDR = 0
    SCS_SCENE_COLOR_HDR_NO_ALPHA = 1
    SCS_FINAL_COLOR_LDR = 2
    SCS_SCENE_COLOR_SCENE_DEPTH = 3
    SCS_SCENE_DEPTH = 4
    SCS_DEVICE_DEPTH = 5
    SCS_NORMAL = 6
    SCS_BASE_COLOR = 7
    SCS_FINAL_COLOR_HDR = 8
    SCS_FINAL_TONE_CURVE_HDR = 9


@public
@unique
class TextureRenderTargetFormat(EnumBase):
    """How a picture is kept; here always as bytes."""

    RTF_R8 = 0
    RTF_RG8 = 1
    RTF_RGBA8 = 2
    RTF_RGBA8_SRGB = 3
    RTF_R16F = 4
    RTF_RG16F = 5
    RTF_RGBA16F = 6
    RTF_R32F = 7
    RTF_RG32F = 8
    RTF_RGBA32F = 9
    RTF_RGB10A2 = 10


@public
@unique
class CameraProjectionMode(EnumBase):
    """How a camera draws."""

    PERSPECTIVE = 0
    ORTHOGRAPHIC = 1


_LIT = (
    "SCS_FINAL_COLOR_LDR",
    "SCS_FINAL_COLOR_HDR",
    "SCS_FINAL_TONE_CURVE_HDR",
    "SCS_SCENE_COLOR_HDR",
    "SCS_SCENE_COLOR_HDR_NO_ALPHA",
)


@public
class TextureRenderTarget(Texture):
    """Base of pictures that are drawn into."""


@public
class TextureRenderTarget2D(TextureRenderTarget):
    """A picture that is drawn into."""

    _declares = {
        "size_x": Prop("int", get="_width", writable=False),
        "size_y": Prop("int", get="_height", writable=False),
        "render_target_format": Prop("TextureRenderTargetFormat", TextureRenderTargetFormat.RTF_RGBA16F),
    }

    @classmethod
    def _transient(cls, width: int, height: int, kind: TextureRenderTargetFormat) -> Any:
        made = cls._at("/Engine/Transient.TextureRenderTarget2D_0")
        made._pixels = np.zeros((height, width, 3), dtype=np.uint8)
        made._values["render_target_format"] = kind
        return made

    def _width(self) -> int:
        return int(self._pixels.shape[1])

    def _height(self) -> int:
        return int(self._pixels.shape[0])

    def _fill(self, color: LinearColor) -> None:
        found = color.to_color()
        self._pixels[:] = (found.r, found.g, found.b)


@public
class SceneCaptureComponent(SceneComponent):
    """Base of components that draw the level."""

    _declares = {
        "capture_every_frame": Prop("bool", True),
        "capture_on_movement": Prop("bool", True),
        "capture_source": Prop("SceneCaptureSource", SceneCaptureSource.SCS_SCENE_COLOR_HDR),
        "mobility": Prop("ComponentMobility", ComponentMobility.MOVABLE),
    }


@public
class SceneCaptureComponent2D(SceneCaptureComponent):
    """Draws the level along its +X; ``fov_angle`` is horizontal, in degrees."""

    _declares = {
        "fov_angle": Prop("float", 90.0),
        "ortho_width": Prop("float", 512.0),
        "projection_type": Prop("CameraProjectionMode", CameraProjectionMode.PERSPECTIVE),
        "texture_target": Prop("TextureRenderTarget2D | None", None, saved=False),
        "post_process_settings": Prop("PostProcessSettings", PostProcessSettings),
        "post_process_blend_weight": Prop("float", 1.0),
    }

    @api
    def capture_scene(self) -> None:
        """Draw now, into the texture target; without one nothing happens."""
        target = self.get_editor_property("texture_target")
        if target is None:
            return
        source = self.get_editor_property("capture_source").name
        if source not in _LIT and source != "SCS_BASE_COLOR":
            raise Exception(f"{self._name}: capture source {source} is not drawn by the headless engine")
        if self.get_editor_property("projection_type") is not CameraProjectionMode.PERSPECTIVE:
            raise Exception(f"{self._name}: only perspective captures are drawn by the headless engine")
        pose, settings = self._world_pose(), self.get_editor_property("post_process_settings")
        view: dict[str, Any] = {
            "location_cm": pose.location,
            "rotation_deg": pose.rotation_deg,
            "fov_deg": self.get_editor_property("fov_angle"),
            "width": target._width(),
            "height": target._height(),
        }
        if settings.override_auto_exposure_bias:
            view["exposure_bias_ev"] = settings.auto_exposure_bias * self.get_editor_property(
                "post_process_blend_weight"
            )
        with TemporaryDirectory() as folder:
            file = Path(folder) / "capture.png"
            world().take_pictures([view], [str(file)], "lit" if source in _LIT else "base_color", False)
            with Image.open(file) as picture:
                target._pixels = np.array(picture.convert("RGB"), dtype=np.uint8)


@public
class SceneCapture(Actor):
    """Base of actors that draw the level."""

    @classmethod
    def _abstract(cls) -> bool:
        return True


@public
class SceneCapture2D(SceneCapture):
    """An actor that draws the level."""

    _parts = (("SceneComponent", SceneComponent), ("NewSceneCaptureComponent2D", SceneCaptureComponent2D))
    _declares = {
        "capture_component2d": Prop("SceneCaptureComponent2D", get="_get_capture", writable=False, saved=False)
    }

    def _get_capture(self) -> Object:
        return next(c for c in self._components if isinstance(c, SceneCaptureComponent2D))
