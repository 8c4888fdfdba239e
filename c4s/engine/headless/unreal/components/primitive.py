"""Components with geometry: bounds, collision and shadows."""

# ruff: noqa: RUF012  (each class declares its table of properties; no table is ever changed)

from __future__ import annotations

from c4s.engine.headless.unreal.components.queries import ComponentQueries, overlapped
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
    }

    @api
    def set_simulate_physics(self, simulate: bool) -> None:
        """Refused: the headless engine has no dynamics."""
        raise Exception("set_simulate_physics: the headless engine has no dynamics")

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
