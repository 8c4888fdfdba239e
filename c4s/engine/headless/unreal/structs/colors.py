"""Colours."""

# ruff: noqa: RUF012  (each class declares its table of properties; no table is ever changed)

from __future__ import annotations

import math
from typing import Any

from c4s.engine.headless.unreal.core import Prop, public
from c4s.engine.headless.unreal.structs.base import StructBase
from c4s.engine.headless.unreal.structs.numbers import Components, numbers


@public
class LinearColor(Components):
    """Linear RGBA."""

    _fields = {**numbers("r", "g", "b"), "a": Prop("float", 1.0)}
    r: float
    g: float
    b: float
    a: float

    def __init__(self, r: float = 0.0, g: float = 0.0, b: float = 0.0, a: float = 1.0) -> None:
        super().__init__(r, g, b, a)

    def _bytes(self, srgb: bool) -> Color:
        def level(value: float) -> int:
            value = min(1.0, max(0.0, value))
            if srgb:
                value = 12.92 * value if value <= 0.0031308 else 1.055 * value ** (1 / 2.4) - 0.055
            return math.floor(value * 255.999)

        return Color(b=level(self.b), g=level(self.g), r=level(self.r), a=math.floor(min(1, max(0, self.a)) * 255.999))

    def to_rgbe(self) -> Color:
        """sRGB bytes of this colour."""
        return self._bytes(True)


@public
class Color(StructBase):
    """sRGB bytes; positional order is b, g, r, a."""

    _fields = {"b": Prop("int", 0), "g": Prop("int", 0), "r": Prop("int", 0), "a": Prop("int", 0)}
    b: int
    g: int
    r: int
    a: int

    def __init__(self, b: int = 0, g: int = 0, r: int = 0, a: int = 0) -> None:
        super().__init__(b, g, r, a)

    def _put(self, name: str, value: Any) -> None:
        if isinstance(value, int) and not 0 <= value <= 255:
            raise OverflowError(f"Color: property '{name}': {value} does not fit 0..255")
        super()._put(name, value)
