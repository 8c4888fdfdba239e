"""Simple shapes without looks (cm): boxes, spheres and capsules. They have bounds, and no collision here."""

# ruff: noqa: RUF012  (each class declares its table of properties; no table is ever changed)

from __future__ import annotations

from dataclasses import replace
from typing import Any

from c4s.engine.headless.unreal.components.frames import Bounds
from c4s.engine.headless.unreal.components.primitive import PrimitiveComponent
from c4s.engine.headless.unreal.core import Prop, api, as_class, public
from c4s.engine.headless.unreal.enums import CollisionEnabled
from c4s.engine.headless.unreal.structs import Vector


def shape(kind: type[ShapeComponent], **defaults: Any) -> type[ShapeComponent]:
    """A kind of shape with other defaults, for an actor that has them; scripts see the kind itself."""
    as_class(kind)
    declares = {name: replace(kind._declared[name], default=value) for name, value in defaults.items()}
    return type(kind.__name__, (kind,), {"__doc__": kind.__doc__, "__module__": "unreal", "_declares": declares})


@public
class ShapeComponent(PrimitiveComponent):
    """A simple shape without looks."""

    _declares = {
        "collision_enabled": Prop("CollisionEnabled", CollisionEnabled.NO_COLLISION, attribute=False, scripts=False)
    }

    def _least_scale(self) -> float:
        """The smallest factor of its scale, which round shapes follow."""
        return min(map(abs, self._world_pose().scale))

    @api
    def set_line_thickness(self, thickness: float) -> None:
        """Set how thick its lines are drawn; none are drawn here."""
        self.set_editor_property("line_thickness", thickness)


@public
class BoxComponent(ShapeComponent):
    """A box; ``box_extent`` is its half size."""

    _declares = {"box_extent": Prop("Vector", lambda: Vector(32, 32, 32))}

    def _local_bounds(self) -> Bounds | None:
        x, y, z = self.get_editor_property("box_extent")._triple()
        return (-x, -y, -z), (x, y, z)

    @api
    def set_box_extent(self, box_extent: Vector, update_overlaps: bool = True) -> None:
        """Set the half size."""
        self.set_editor_property("box_extent", box_extent)

    @api
    def get_unscaled_box_extent(self) -> Vector:
        """Half size before scaling."""
        return self.get_editor_property("box_extent").copy()  # type: ignore[no-any-return]

    @api
    def get_scaled_box_extent(self) -> Vector:
        """Half size after scaling."""
        own: Vector = self.get_editor_property("box_extent")
        return Vector(*(a * abs(b) for a, b in zip(own._triple(), self._world_pose().scale, strict=True)))


@public
class SphereComponent(ShapeComponent):
    """A sphere."""

    _declares = {"sphere_radius": Prop("float", 32.0)}

    def _local_bounds(self) -> Bounds | None:
        r = self.get_editor_property("sphere_radius")
        return (-r, -r, -r), (r, r, r)

    @api
    def set_sphere_radius(self, sphere_radius: float, update_overlaps: bool = True) -> None:
        """Set the radius."""
        self.set_editor_property("sphere_radius", sphere_radius)

    @api
    def get_unscaled_sphere_radius(self) -> float:
        """Radius before scaling."""
        return float(self.get_editor_property("sphere_radius"))

    @api
    def get_scaled_sphere_radius(self) -> float:
        """Radius after scaling, by the smallest factor."""
        return self.get_unscaled_sphere_radius() * self._least_scale()

    @api
    def get_shape_scale(self) -> float:
        """The smallest factor of its scale."""
        return self._least_scale()


@public
class CapsuleComponent(ShapeComponent):
    """An upright capsule."""

    _declares = {"capsule_radius": Prop("float", 22.0), "capsule_half_height": Prop("float", 44.0)}

    def _local_bounds(self) -> Bounds | None:
        r, h = self.get_unscaled_capsule_size()
        return (-r, -r, -h), (r, r, h)

    @api
    def set_capsule_size(self, radius: float, half_height: float, update_overlaps: bool = True) -> None:
        """Set radius and half height, which is at least the radius."""
        self.set_editor_property("capsule_radius", max(0.0, radius))
        self.set_editor_property("capsule_half_height", max(0.0, radius, half_height))

    @api
    def set_capsule_radius(self, radius: float, update_overlaps: bool = True) -> None:
        """Set the radius; the half height stays, or follows where it would be smaller."""
        self.set_capsule_size(radius, self.get_unscaled_capsule_half_height())

    @api
    def set_capsule_half_height(self, half_height: float, update_overlaps: bool = True) -> None:
        """Set the half height."""
        self.set_capsule_size(self.get_unscaled_capsule_radius(), half_height)

    @api
    def get_unscaled_capsule_size(self) -> tuple[float, float]:
        """Radius and half height before scaling."""
        return self.get_unscaled_capsule_radius(), self.get_unscaled_capsule_half_height()

    @api
    def get_unscaled_capsule_radius(self) -> float:
        """Radius before scaling."""
        return float(self.get_editor_property("capsule_radius"))

    @api
    def get_unscaled_capsule_half_height(self) -> float:
        """Half height before scaling."""
        return float(self.get_editor_property("capsule_half_height"))

    @api
    def get_scaled_capsule_size(self) -> tuple[float, float]:
        """Radius and half height after scaling."""
        return self.get_scaled_capsule_radius(), self.get_scaled_capsule_half_height()

    @api
    def get_scaled_capsule_radius(self) -> float:
        """Radius after scaling, by the smaller of the two factors across."""
        return self.get_unscaled_capsule_radius() * min(map(abs, self._world_pose().scale[:2]))

    @api
    def get_scaled_capsule_half_height(self) -> float:
        """Half height after scaling."""
        return self.get_unscaled_capsule_half_height() * abs(self._world_pose().scale[2])

    @api
    def get_shape_scale(self) -> float:
        """The smallest factor of its scale."""
        return self._least_scale()
