"""Colours."""

# ruff: noqa: RUF012  (each class declares its table of properties; no table is ever changed)

from __future__ import annotations

import colorsys
import math
import random
from typing import Any

from c4s.engine.headless.unreal.core import Prop, api, public
from c4s.engine.headless.unreal.structs.base import StructBase
from c4s.engine.headless.unreal.structs.numbers import Constant, Multiplied, clamped, numbers, quotient
from c4s.engine.headless.unreal.structs.vectors import Vector


def _encoded(value: float) -> float:
    """sRGB of a linear number 0..1."""
    return 12.92 * value if value <= 0.0031308 else float(1.055 * value ** (1 / 2.4) - 0.055)


def _decoded(value: float) -> float:
    """Linear number of an sRGB one 0..1."""
    return value / 12.92 if value <= 0.04045 else float(((value + 0.055) / 1.055) ** 2.4)


@public
class LinearColor(Multiplied):
    """Linear RGBA; positional order is r, g, b, a, each 0 when left out."""

    _fields = numbers("r", "g", "b", "a")
    r: float
    g: float
    b: float
    a: float

    WHITE = Constant(1.0, 1.0, 1.0, 1.0)
    GRAY = Constant(0.5, 0.5, 0.5, 1.0)
    BLACK = Constant(0.0, 0.0, 0.0, 1.0)
    TRANSPARENT = Constant(0.0, 0.0, 0.0, 0.0)
    RED = Constant(1.0, 0.0, 0.0, 1.0)
    GREEN = Constant(0.0, 1.0, 0.0, 1.0)
    BLUE = Constant(0.0, 0.0, 1.0, 1.0)
    YELLOW = Constant(1.0, 1.0, 0.0, 1.0)

    def __init__(self, r: float = 0.0, g: float = 0.0, b: float = 0.0, a: float = 0.0) -> None:
        super().__init__(r, g, b, a)

    def _bytes(self, srgb: bool) -> Color:
        def level(value: float) -> int:
            value = clamped(value, 0.0, 1.0)
            return math.floor((_encoded(value) if srgb else value) * 255.999)

        return Color(b=level(self.b), g=level(self.g), r=level(self.r), a=math.floor(clamped(self.a, 0, 1) * 255.999))

    @classmethod
    def _of_bytes(cls, color: Color, gamma: float | None = None) -> LinearColor:
        def linear(value: int) -> float:
            return _decoded(value / 255) if gamma is None else float((value / 255) ** gamma)

        return cls(linear(color.r), linear(color.g), linear(color.b), color.a / 255)

    @api
    def to_color(self, use_srgb: bool = True) -> Color:
        """Bytes of this colour, sRGB encoded unless told otherwise."""
        return self._bytes(use_srgb)

    def to_rgbe(self) -> Color:
        """Bytes with a shared exponent in a."""
        most = max(self.r, self.g, self.b)
        if most < 1e-32:
            return Color()
        mantissa, exponent = math.frexp(most)
        scale = mantissa * 255.999 / most
        r, g, b = (int(clamped(v * scale, 0, 255)) for v in (self.r, self.g, self.b))
        return Color(b=b, g=g, r=r, a=int(clamped(exponent + 128, 0, 255)))

    def quantize(self) -> Color:
        """Bytes of the linear numbers, cut."""
        r, g, b, a = (int(clamped(v, 0, 1) * 255) for v in self._all())
        return Color(b=b, g=g, r=r, a=a)

    def quantize_round(self) -> Color:
        """Bytes of the linear numbers, rounded."""
        r, g, b, a = (math.floor(clamped(v, 0, 1) * 255 + 0.5) for v in self._all())
        return Color(b=b, g=g, r=r, a=a)

    @api
    def divide(self, b: LinearColor) -> LinearColor:
        """Quotient by component."""
        return self / b  # type: ignore[no-any-return]

    @api
    def multiply_float(self, b: float) -> LinearColor:
        """Product with a number, alpha too."""
        return LinearColor(*(a * b for a in self._all()))

    @api
    def is_near_equal(self, b: LinearColor, tolerance: float = 1e-4) -> bool:
        """Whether every component differs by at most the tolerance."""
        return self._near(b, tolerance)

    @api
    def set(self, color: LinearColor) -> None:
        """Take over all numbers."""
        self._take(color)

    @api
    def set_rgba(self, r: float, g: float, b: float, a: float = 1.0) -> None:
        """Set all numbers."""
        self._take(LinearColor(r, g, b, a))

    @api
    def set_from_hsv(self, h: float, s: float, v: float, a: float = 1.0) -> None:
        """Become the colour of a hue in degrees, a saturation and a value."""
        self._take(LinearColor(h, s, v, a).hsv_to_rgb())

    @api
    def set_from_srgb(self, srgb: Color) -> None:
        """Become the colour of sRGB bytes."""
        self._take(LinearColor._of_bytes(srgb))

    @api
    def set_from_pow22(self, color: Color) -> None:
        """Become the colour of bytes of gamma 2.2."""
        self._take(LinearColor._of_bytes(color, 2.2))

    def set_random_hue(self) -> None:
        """Become a bright colour of a random hue."""
        self._take(LinearColor(random.uniform(0, 360), 1.0, 1.0, 1.0).hsv_to_rgb())

    @api
    def set_temperature(self, temperature: float) -> None:
        """Become the colour of a black body in kelvin."""
        self._take(_black_body(temperature))

    def get_luminance(self) -> float:
        """Brightness."""
        return 0.3 * self.r + 0.59 * self.g + 0.11 * self.b

    def get_max(self) -> float:
        """Largest of all four."""
        return max(self._all())

    def get_min(self) -> float:
        """Smallest of all four."""
        return min(self._all())

    @api
    def distance(self, c2: LinearColor) -> float:
        """Euclidean distance of all four."""
        return math.dist(self._all(), c2._all())

    @api
    def desaturated(self, desaturation: float) -> LinearColor:
        """Mixed with its grey."""
        grey = self.get_luminance()
        return self.lerp_to(LinearColor(grey, grey, grey, 0.0), desaturation)

    @api
    def lerp_to(self, b: LinearColor, alpha: float) -> LinearColor:
        """Linear mix."""
        return LinearColor(*(p + (q - p) * alpha for p, q in zip(self._all(), b._all(), strict=True)))

    @api
    def lerp_using_hsv_to(self, b: LinearColor, alpha: float) -> LinearColor:
        """Mix of hue (the shorter way), saturation and value."""
        mine, theirs = self.rgb_to_hsv(), b.rgb_to_hsv()
        from_hue, to_hue = mine.r, theirs.r
        if abs(from_hue - to_hue) > 180:
            from_hue, to_hue = (from_hue, to_hue + 360) if to_hue < from_hue else (from_hue + 360, to_hue)
        made = mine.lerp_to(theirs, alpha)
        made.r = (from_hue + (to_hue - from_hue) * alpha) % 360
        return made.hsv_to_rgb()

    @api
    def interpolate_to(self, target: LinearColor, delta_time: float, interp_speed: float) -> LinearColor:
        """A step towards a target that slows down as it comes near."""
        if interp_speed <= 0 or self.distance(target) < 1e-4:
            return target
        return self.lerp_to(target, clamped(delta_time * interp_speed, 0.0, 1.0))

    @api
    def to_new_opacity(self, opacity: float) -> LinearColor:
        """With another alpha."""
        return LinearColor(self.r, self.g, self.b, opacity)

    def to_rgb_vector(self) -> Vector:
        """r, g and b."""
        return Vector(self.r, self.g, self.b)

    def rgb_to_hsv(self) -> LinearColor:
        """Hue in degrees, saturation, value and alpha."""
        most, least = max(self.r, self.g, self.b), min(self.r, self.g, self.b)
        span = most - least
        hue = colorsys.rgb_to_hsv(self.r - least, self.g - least, self.b - least)[0] * 360 if span > 0 else 0.0
        return LinearColor(hue, quotient(span, most) if most else 0.0, most, self.a)

    def rgb_into_hsv(self) -> LinearColor:
        """Hue in degrees, saturation, value and alpha."""
        return self.rgb_to_hsv()

    def rgb_into_hsv_components(self) -> tuple[float, float, float, float]:
        """Hue in degrees, saturation, value and alpha."""
        found = self.rgb_to_hsv()
        return found.r, found.g, found.b, found.a

    def hsv_to_rgb(self) -> LinearColor:
        """The colour whose hue (degrees), saturation and value these are."""
        return LinearColor(*colorsys.hsv_to_rgb(self.r / 360 % 1.0, self.g, self.b), self.a)

    def hsv_into_rgb(self) -> LinearColor:
        """The colour whose hue (degrees), saturation and value these are."""
        return self.hsv_to_rgb()


def _black_body(kelvin: float) -> LinearColor:
    """Colour of a black body, 1000 to 15000 K: the locus in CIE 1960 (Krystek 1985), as linear sRGB of Y = 1."""
    t = clamped(kelvin, 1000.0, 15000.0)
    u = (0.860117757 + 1.54118254e-4 * t + 1.28641212e-7 * t * t) / (1.0 + 8.42420235e-4 * t + 7.08145163e-7 * t * t)
    v = (0.317398726 + 4.22806245e-5 * t + 4.20481691e-8 * t * t) / (1.0 - 2.89741816e-5 * t + 1.61456053e-7 * t * t)
    x, y = 3 * u / (2 * u - 8 * v + 4), 2 * v / (2 * u - 8 * v + 4)
    big_x, big_z = x / y, (1 - x - y) / y
    return LinearColor(
        3.2404542 * big_x - 1.5371385 - 0.4985314 * big_z,
        -0.9692660 * big_x + 1.8760108 + 0.0415560 * big_z,
        0.0556434 * big_x - 0.2040259 + 1.0572252 * big_z,
        1.0,
    )


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
        if isinstance(value, (int, float)) and not 0 <= value <= 255:
            raise OverflowError(f"Color: property '{name}': {value} does not fit 0..255")
        super()._put(name, value)
