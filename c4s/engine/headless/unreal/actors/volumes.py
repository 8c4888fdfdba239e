"""Volumes and the player start."""

# ruff: noqa: RUF012  (each class declares its table of properties; no table is ever changed)

from __future__ import annotations

from c4s.engine.headless.unreal.actors.base import Actor
from c4s.engine.headless.unreal.containers import Name
from c4s.engine.headless.unreal.core import Prop, public
from c4s.engine.headless.unreal.lights import BrushComponent, CapsuleComponent, PostProcessSettings


@public
class PlayerStart(Actor):
    """Where a player starts."""

    _parts = (("CollisionCapsule", CapsuleComponent),)
    _declares = {"player_start_tag": Prop("Name", Name)}


@public
class Volume(Actor):
    """A box in space."""

    _parts = (("BrushComponent0", BrushComponent),)


@public
class PostProcessVolume(Volume):
    """Exposure and grading of a region, or of everything when unbound."""

    _declares = {
        "settings": Prop("PostProcessSettings", PostProcessSettings),
        "unbound": Prop("bool", False),
        "enabled": Prop("bool", True),
        "blend_radius": Prop("float", 100.0),
        "blend_weight": Prop("float", 1.0),
        "priority": Prop("float", 0.0),
    }


@public
class BlockingVolume(Volume):
    """A volume that blocks."""


@public
class TriggerVolume(Volume):
    """A volume that notices."""


@public
class NavMeshBoundsVolume(Volume):
    """The region in which paths are found."""

    _class_module = "NavigationSystem"


@public
class LightmassImportanceVolume(Volume):
    """Where baked light matters; none is baked here."""
