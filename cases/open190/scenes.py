"""The table of scenes: each is a function that lays out a ``StagedPlace``."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

from cases.open190.layout import StagedPlace
from catalog.kits.styles import Style

Kind = Literal["indoor", "outdoor", "text"]
Build = Callable[[StagedPlace], None]


@dataclass(frozen=True)
class SceneSpec:
    """A scene before it is built. ``plate_m`` is the side of the plate of a text scene."""

    scene_id: str
    kind: Kind
    title: str
    style: Style
    build: Build
    plate_m: float = 0.0
    slot: bool = False
    """Whether a scene that people made may stand in its place where its package is installed."""

    def place(self) -> StagedPlace:
        """Lay the scene out."""
        place = StagedPlace(self.scene_id, self.style, "1", tops_only=self.kind == "text")
        self.build(place)
        if all(actor.name != "LightSun" for actor in place.actors):
            place.sun(place.uni(-48, -30), place.uni(20, 160), colour=(255, 246, 232))
        return place


REGISTERED: dict[str, SceneSpec] = {}
"""By their modules, as these are imported; ``cases.open190.library`` has them in order."""


def scene(
    scene_id: str, kind: Kind, title: str, style: Style, plate_m: float = 0.0, *, slot: bool = False
) -> Callable[[Build], Build]:
    """Register a scene."""

    def register(build: Build) -> Build:
        REGISTERED[scene_id] = SceneSpec(scene_id, kind, title, style, build, plate_m, slot)
        return build

    return register
