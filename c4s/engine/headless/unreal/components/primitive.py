"""Components with geometry: bounds, collision and shadows."""

# ruff: noqa: RUF012  (each class declares its table of properties; no table is ever changed)

from __future__ import annotations

from c4s.engine.headless.unreal.components.queries import ComponentQueries, overlapped
from c4s.engine.headless.unreal.containers import Name
from c4s.engine.headless.unreal.core import Prop, api, public, with_setters
from c4s.engine.headless.unreal.kept import KEPT
from c4s.engine.headless.unreal.setters import SETTERS


@public
@with_setters(SETTERS["PrimitiveComponent"])
class PrimitiveComponent(ComponentQueries):
    """A component with geometry: bounds, collision and materials."""

    _declares = {
        **KEPT["PrimitiveComponent"],
        "cast_shadow": Prop("bool", True),
        "hidden_in_scene_capture": Prop("bool", False),
        "simulate_physics": Prop("bool", False, attribute=False, scripts=False),
        "enable_gravity": Prop("bool", True, attribute=False, scripts=False),
    }

    @api
    def set_simulate_physics(self, simulate: bool) -> None:
        """Set whether it would fall in play. Nothing moves by itself in the editor, and there is no play here."""
        self._put("simulate_physics", simulate)

    @api
    def is_simulating_physics(self, bone_name: Name | str = "None") -> bool:
        """Whether it would fall in play."""
        return bool(self._own("simulate_physics"))

    @api
    def is_any_simulating_physics(self) -> bool:
        """Whether it would fall in play."""
        return bool(self._own("simulate_physics"))

    @api
    def set_enable_gravity(self, gravity_enabled: bool) -> None:
        """Set whether gravity would pull it in play."""
        self._put("enable_gravity", gravity_enabled)

    @api
    def is_gravity_enabled(self) -> bool:
        """Whether gravity would pull it in play; never without simulated physics."""
        return bool(self._own("simulate_physics") and self._own("enable_gravity"))

    @api
    def set_cast_shadow(self, new_cast_shadow: bool) -> None:
        """Set whether it casts a shadow."""
        self.set_editor_property("cast_shadow", new_cast_shadow)

    @api
    def ignore_component_when_moving(self, component: PrimitiveComponent | None, should_ignore: bool) -> None:
        """Let swept moves pass through a component, or not any more."""
        self._ignore(component, should_ignore)

    @api
    def is_overlapping_component(self, other_comp: PrimitiveComponent) -> bool:
        """Whether it overlaps a component, and both notice that."""
        return other_comp in overlapped(self)
