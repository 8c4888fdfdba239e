"""Cameras."""

# ruff: noqa: RUF012  (each class declares its table of properties; no table is ever changed)

from __future__ import annotations

from typing import Any

from c4s.engine.headless.unreal.actors.base import Actor
from c4s.engine.headless.unreal.cine import CineCameraComponent
from c4s.engine.headless.unreal.components import SceneComponent
from c4s.engine.headless.unreal.core import Prop, api, public
from c4s.engine.headless.unreal.lights import CameraComponent


@public
class CameraActor(Actor):
    """A camera."""

    _parts = (("SceneComponent", SceneComponent), ("CameraComponent", CameraComponent))
    _declares = {
        "camera_component": Prop("CameraComponent", get="_get_camera", writable=False, saved=False),
        "scene_component": Prop("SceneComponent", get="_get_root", writable=False, saved=False),
    }

    def _get_camera(self) -> Any:
        return next(c for c in self._components if isinstance(c, CameraComponent))


@public
class CineCameraActor(CameraActor):
    """A film camera."""

    _class_module = "CinematicCamera"
    _parts = (("SceneComponent", SceneComponent), ("CameraComponent", CineCameraComponent))

    @api
    def get_cine_camera_component(self) -> CineCameraComponent:
        """Its camera."""
        found = self._get_camera()
        assert isinstance(found, CineCameraComponent)
        return found
