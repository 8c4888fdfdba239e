"""Actors: identity, transforms, attachment, components, bounds."""

from __future__ import annotations

from c4s.engine.headless.unreal.actors import attachment, distances, noticing  # noqa: F401  (they extend Actor)
from c4s.engine.headless.unreal.actors.base import Actor, Info, Parts
from c4s.engine.headless.unreal.actors.cameras import CameraActor, CineCameraActor
from c4s.engine.headless.unreal.actors.lighting import (
    DirectionalLight,
    ExponentialHeightFog,
    Light,
    PointLight,
    RectLight,
    SkyAtmosphere,
    SkyLight,
    SpotLight,
)
from c4s.engine.headless.unreal.actors.meshes import StaticMeshActor
from c4s.engine.headless.unreal.actors.volumes import (
    BlockingVolume,
    NavMeshBoundsVolume,
    PlayerStart,
    PostProcessVolume,
    TriggerVolume,
    Volume,
)

__all__ = [
    "Actor",
    "BlockingVolume",
    "CameraActor",
    "CineCameraActor",
    "DirectionalLight",
    "ExponentialHeightFog",
    "Info",
    "Light",
    "NavMeshBoundsVolume",
    "Parts",
    "PlayerStart",
    "PointLight",
    "PostProcessVolume",
    "RectLight",
    "SkyAtmosphere",
    "SkyLight",
    "SpotLight",
    "StaticMeshActor",
    "TriggerVolume",
    "Volume",
]
