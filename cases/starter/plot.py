"""Placing assets outdoors: a level that grows actor by actor, everything in cm and degrees."""

from __future__ import annotations

import hashlib
import random
from collections.abc import Iterable

from c4s.scene.level import Level, LevelActor, LevelComponent, Transform
from c4s.scene.transform import normalize_axis
from cases.corruption import STATIC_MESH_ACTOR, STATIC_MESH_COMPONENT, guid_of

STACK_GAP_CM = 0.2
"""Air between stacked things, so that rounding never makes them sink into each other."""


class Plot:
    """A level under construction with the assets of one pack; ``paths`` maps an asset's name to its path."""

    def __init__(self, scene_id: str, paths: dict[str, str], seed: int) -> None:
        self.scene_id, self.paths = scene_id, paths
        self.actors: list[LevelActor] = []
        self.random = random.Random(seed)
        self._numbers: dict[str, int] = {}

    def add(self, asset: str, x: float, y: float, z: float = 0.0, *, yaw: float = 0.0,
            scale: float | tuple[float, float, float] = 1.0) -> str:
        """Place an asset by its name (``Bench``) and return the actor's object name.

        Numbers are given with gaps, so that an actor that appears or is missing cannot be told by its number.
        """
        stem = f"SM_{asset}"
        number = self._numbers.get(stem, 0) + 1
        number += int(hashlib.sha256(f"{self.scene_id}{stem}{number}".encode()).hexdigest(), 16) % 5 == 0
        self._numbers[stem] = number
        name = f"{stem}_{number}"
        factors = (scale, scale, scale) if isinstance(scale, float | int) else scale
        component = LevelComponent(name="StaticMeshComponent0", class_path=STATIC_MESH_COMPONENT,
                                   static_mesh=self.paths[asset])
        self._append(name, STATIC_MESH_ACTOR, [component], Transform(
            location_cm=(round(x, 3), round(y, 3), round(z, 3)),
            rotation_deg=(0.0, round(normalize_axis(yaw), 3), 0.0), scale=factors))
        return name

    def grid(self, asset: str, xs: Iterable[float], ys: Iterable[float], z: float = 0.0, *,
             scale: float | tuple[float, float, float] = 1.0) -> None:
        """Place an asset at every crossing of ``xs`` and ``ys``."""
        rows = list(ys)
        for x in xs:
            for y in rows:
                self.add(asset, x, y, z, scale=scale)

    def daylight(self, pitch: float, yaw: float) -> None:
        """A sun that shines along [pitch, yaw], and the light of the sky."""
        sun = LevelComponent(name="LightComponent0", class_path="/Script/Engine.DirectionalLightComponent",
                             properties={"intensity": 4.0})
        sky = LevelComponent(name="SkyLightComponent0", class_path="/Script/Engine.SkyLightComponent")
        self._append("DirectionalLight_0", "/Script/Engine.DirectionalLight", [sun],
                     Transform(location_cm=(0.0, 0.0, 3000.0), rotation_deg=(pitch, yaw, 0.0)))
        self._append("SkyLight_0", "/Script/Engine.SkyLight", [sky], Transform(location_cm=(0.0, 0.0, 3100.0)))

    def level(self) -> Level:
        """The finished level."""
        return Level(package=f"/Game/Scenes/{self.scene_id}", actors=self.actors)

    def _append(self, name: str, class_path: str, components: list[LevelComponent], transform: Transform) -> None:
        self.actors.append(LevelActor(name=name, label=name, class_path=class_path, components=components,
                                      guid=guid_of(f"{self.scene_id}|{name}"), transform=transform))


def asset_paths(content_folder: str, assets: Iterable[tuple[str, str]]) -> dict[str, str]:
    """Paths of (name, category) pairs, as the pack builder makes them."""
    return {name: f"/Game/{content_folder}/{category.title()}/SM_{name}.SM_{name}" for name, category in assets}
