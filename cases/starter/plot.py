"""Placing assets outdoors: a level that grows actor by actor, everything in cm and degrees."""

from __future__ import annotations

import hashlib
import random
from collections.abc import Iterable

from c4s.geometry.transform import normalize_axis
from c4s.records.level import Level, Transform
from cases.starter.stage import Stage, asset_path

STACK_GAP_CM = 0.2
"""Air between stacked things, so that rounding never makes them sink into each other."""


class Plot(Stage):
    """A level under construction with the assets of one pack; ``paths`` maps an asset's name to its path."""

    def __init__(self, scene_id: str, paths: dict[str, str], seed: int) -> None:
        super().__init__(scene_id, paths)
        self.random = random.Random(seed)
        self._numbers: dict[str, int] = {}

    def add(
        self,
        asset: str,
        x: float,
        y: float,
        z: float = 0.0,
        *,
        yaw: float = 0.0,
        scale: float | tuple[float, float, float] = 1.0,
    ) -> str:
        """Place an asset by its name (``Bench``) and return the actor's object name.

        Numbers are given with gaps, so that an actor that appears or is missing cannot be told by its number.
        """
        stem = f"SM_{asset}"
        number = self._numbers.get(stem, 0) + 1
        number += int(hashlib.sha256(f"{self.scene_id}{stem}{number}".encode()).hexdigest(), 16) % 5 == 0
        self._numbers[stem] = number
        return self.add_mesh(
            f"{stem}_{number}",
            asset,
            Transform(
                location_cm=(round(x, 3), round(y, 3), round(z, 3)),
                rotation_deg=(0.0, round(normalize_axis(yaw), 3), 0.0),
                scale=(scale, scale, scale) if isinstance(scale, float | int) else scale,
            ),
        )

    def grid(
        self,
        asset: str,
        xs: Iterable[float],
        ys: Iterable[float],
        z: float = 0.0,
        *,
        scale: float | tuple[float, float, float] = 1.0,
    ) -> None:
        """Place an asset at every crossing of ``xs`` and ``ys``."""
        rows = list(ys)
        for x in xs:
            for y in rows:
                self.add(asset, x, y, z, scale=scale)

    def daylight(self, pitch: float, yaw: float) -> None:
        """A sun that shines along [pitch, yaw], the light of the sky, air and thin fog."""
        self.add_light(
            "DirectionalLight_0",
            "DirectionalLight",
            Transform(location_cm=(0.0, 0.0, 3000.0), rotation_deg=(pitch, yaw, 0.0)),
            intensity=4.0,
        )
        self.add_light("SkyLight_0", "SkyLight", Transform(location_cm=(0.0, 0.0, 3100.0)))
        self.add_air()

    def level(self) -> Level:
        """The finished level."""
        return Level(package=f"/Game/Scenes/{self.scene_id}", actors=self.actors)


def asset_paths(content_folder: str, assets: Iterable[tuple[str, str]]) -> dict[str, str]:
    """Paths of (name, category) pairs, as the pack builder makes them."""
    return {name: asset_path(content_folder, category, name) for name, category in assets}
