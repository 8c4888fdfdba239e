"""Volumes and the player start."""

# ruff: noqa: RUF012  (each class declares its table of properties; no table is ever changed)

from __future__ import annotations

from c4s.engine.headless.editor import world
from c4s.engine.headless.pose import IDENTITY
from c4s.engine.headless.unreal.actors.base import Actor
from c4s.engine.headless.unreal.components.shapes import CapsuleComponent, shape
from c4s.engine.headless.unreal.containers import Name
from c4s.engine.headless.unreal.core import Prop, public
from c4s.engine.headless.unreal.lights import BrushComponent, PostProcessSettings

NAVIGATION_DATA = "/Script/NavigationSystem.RecastNavMesh"
"""Class of the navigation data that a level with navigation bounds has."""


@public
class PlayerStart(Actor):
    """Where a player starts."""

    _parts = (("CollisionCapsule", shape(CapsuleComponent, capsule_radius=40.0, capsule_half_height=92.0)),)
    _declares = {"player_start_tag": Prop("Name", Name)}


@public
class Volume(Actor):
    """A box in space."""

    _parts = (("BrushComponent0", BrushComponent),)
    _declares = {"brush_component": Prop("BrushComponent", get="_get_root", writable=False, saved=False)}


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
    """The region in which paths are found. The first one of a level brings the navigation data with it."""

    _class_module = "NavigationSystem"

    def _placed(self) -> None:
        if all(actor._class()._path() != NAVIGATION_DATA for actor in world().actor_list()):
            world().spawn(NAVIGATION_DATA, IDENTITY, "RecastNavMesh-Default")
            world().selection = [self]


@public
class LightmassImportanceVolume(Volume):
    """Where baked light matters; none is baked here."""


@public
class PhysicsVolume(Volume):
    """A volume with its own physics; there are none here."""


@public
class KillZVolume(PhysicsVolume):
    """A volume that ends what falls into it, in play."""


@public
class PainCausingVolume(PhysicsVolume):
    """A volume that hurts, in play."""


@public
class CameraBlockingVolume(Volume):
    """A volume that cameras stay out of, in play."""


@public
class CullDistanceVolume(Volume):
    """A volume that hides small things far away; pictures here show all of them."""


@public
class AudioVolume(Volume):
    """A volume with its own sound; there is none here."""
