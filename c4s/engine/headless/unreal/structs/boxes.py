"""Ids and bounds."""

# ruff: noqa: RUF012  (each class declares its table of properties; no table is ever changed)

from __future__ import annotations

import random

from c4s.engine.headless.unreal.core import Prop, public
from c4s.engine.headless.unreal.structs.base import ClosedStruct, StructBase
from c4s.engine.headless.unreal.structs.planes import Vector2D
from c4s.engine.headless.unreal.structs.vectors import Vector


@public
class Guid(ClosedStruct):
    """A globally unique id."""

    _fields = {n: Prop("int", 0, attribute=False) for n in ("a", "b", "c", "d")}
    _takes = 0

    @classmethod
    def _of(cls, text: str) -> Guid:
        made = cls.__new__(cls)
        made.__dict__.update(a=int(text[:8], 16), b=int(text[8:16], 16), c=int(text[16:24], 16), d=int(text[24:], 16))
        return made

    def to_string(self) -> str:
        """32 upper-case hex digits."""
        return "".join([f"{number:08X}" for number in self.to_tuple()])


@public
class SoftObjectPath(ClosedStruct):
    """The path of an asset that need not be there."""

    _fields = {"path_string": Prop("str", "", attribute=False, scripts=False)}


@public
class Box(StructBase):
    """An axis-aligned box."""

    _fields = {"min": Prop("Vector", Vector), "max": Prop("Vector", Vector), "is_valid": Prop("bool", True)}
    _takes = 2
    min: Vector
    max: Vector

    def random_point_in_box_extents(self) -> Vector:
        """A random point inside."""
        return Vector(*map(random.uniform, self.min._triple(), self.max._triple()))


@public
class Box2D(StructBase):
    """An axis-aligned rectangle."""

    _fields = {"min": Prop("Vector2D", Vector2D), "max": Prop("Vector2D", Vector2D), "is_valid": Prop("bool", True)}
    _takes = 2


@public
class BoxSphereBounds(StructBase):
    """Bounds as a box (centre and half extent) and a sphere."""

    _fields = {
        "origin": Prop("Vector", Vector),
        "box_extent": Prop("Vector", Vector),
        "sphere_radius": Prop("float", 0.0),
    }
