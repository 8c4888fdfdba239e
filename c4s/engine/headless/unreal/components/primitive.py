"""Components with geometry: bounds, collision and shadows."""

# ruff: noqa: RUF012  (each class declares its table of properties; no table is ever changed)

from __future__ import annotations

from typing import Any

from c4s.engine.headless.unreal.components.scene import SceneComponent
from c4s.engine.headless.unreal.containers import Name
from c4s.engine.headless.unreal.core import Prop, api, public
from c4s.engine.headless.unreal.enums import CollisionEnabled


@public
class PrimitiveComponent(SceneComponent):
    """A component with geometry: bounds, collision and materials."""

    _declares = {"cast_shadow": Prop("bool", True), "hidden_in_scene_capture": Prop("bool", False),
                 "collision_enabled": Prop("CollisionEnabled", CollisionEnabled.QUERY_AND_PHYSICS, attribute=False,
                                           scripts=False),
                 "collision_profile_name": Prop("Name", Name("BlockAllDynamic"), attribute=False, scripts=False)}

    def _own(self, name: str) -> Any:
        """Value of a property that scripts reach by methods only."""
        return self._read(name, type(self)._properties[name])

    def _put(self, name: str, value: Any) -> None:
        """Set a property that scripts reach by methods only."""
        self._write(name, type(self)._properties[name], value)

    def _collides(self) -> bool:
        owner = self._outer
        if owner is not None and not owner._values.get("actor_enable_collision", True):
            return False
        return bool(self._own("collision_enabled") is not CollisionEnabled.NO_COLLISION)

    @api
    def get_collision_enabled(self) -> CollisionEnabled:
        """What the collision takes part in."""
        found: CollisionEnabled = self._own("collision_enabled")
        return found if self._collides() else CollisionEnabled.NO_COLLISION

    @api
    def set_collision_enabled(self, new_type: CollisionEnabled) -> None:
        """Set what the collision takes part in."""
        self._put("collision_enabled", new_type)

    @api
    def is_collision_enabled(self) -> bool:
        """Whether there is any collision."""
        return self._collides()

    @api
    def get_collision_profile_name(self) -> Name:
        """Name of the collision profile."""
        found: Name = self._own("collision_profile_name")
        return found

    @api
    def set_collision_profile_name(self, collision_profile_name: Name | str, update_overlaps: bool = True) -> None:
        """Set the profile; ``NoCollision`` switches collision off."""
        self._put("collision_profile_name", collision_profile_name)
        off = Name(str(collision_profile_name)) == "NoCollision"
        self._put("collision_enabled", CollisionEnabled.NO_COLLISION if off
                                 else CollisionEnabled.QUERY_AND_PHYSICS)

    @api
    def set_simulate_physics(self, simulate: bool) -> None:
        """Refused: the headless engine has no dynamics."""
        raise Exception("set_simulate_physics: the headless engine has no dynamics")

    @api
    def set_cast_shadow(self, new_cast_shadow: bool) -> None:
        """Set whether it casts a shadow."""
        self.set_editor_property("cast_shadow", new_cast_shadow)
