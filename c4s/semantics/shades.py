"""Colours as people name them: from a word to the shades that pass for it, in a perceptual space.

Shades are CIELAB in polar form: lightness 0 to 100, chroma from 0 (grey) on, hue in degrees (0 red, 90 yellow, 180
green, 270 blue). A word has two regions: shades that surely are of it, in light and in shade, and the wider one
beyond which nothing passes for it.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from c4s.semantics.boxes import Flags
from c4s.semantics.inventory import Array

WHITE_POINT: Final = np.array([0.95047, 1.0, 1.08883])
TO_XYZ: Final = np.array(
    [[0.4124564, 0.3575761, 0.1804375], [0.2126729, 0.7151522, 0.0721750], [0.0193339, 0.1191920, 0.9503041]]
)
HUE_SLACK_DEG, CHROMA_SLACK, LIGHT_SLACK = 20.0, 8.0, 15.0
"""How much wider the region of possible shades is."""


@dataclass(frozen=True)
class Shades:
    """A region of shades; hues run from the first to the second, through 360 where the first is the larger."""

    hue: tuple[float, float] = (0.0, 360.0)
    chroma: tuple[float, float] = (0.0, 200.0)
    light: tuple[float, float] = (0.0, 100.0)

    def hold(self, shades: Array, slack: float = 0.0) -> Flags:
        """Which of the shades (n, 3: lightness, chroma, hue) lie in it; ``slack`` 1 widens it to what is possible."""
        light, chroma, hue = shades.T
        inside = (chroma >= self.chroma[0] - slack * CHROMA_SLACK) & (chroma <= self.chroma[1] + slack * CHROMA_SLACK)
        inside &= (light >= self.light[0] - slack * LIGHT_SLACK) & (light <= self.light[1] + slack * LIGHT_SLACK)
        span = (self.hue[1] - self.hue[0]) % 360.0 or 360.0
        turned = (hue - self.hue[0] + slack * HUE_SLACK_DEG) % 360.0
        return np.asarray(inside & (turned <= span + 2 * slack * HUE_SLACK_DEG))


def _hued(first: float, last: float, light: tuple[float, float] = (8.0, 100.0), least: float = 14.0) -> Shades:
    return Shades(hue=(first, last), chroma=(least, 200.0), light=light)


SHADES: Final[dict[str, Shades]] = {
    "black": Shades(chroma=(0.0, 12.0), light=(0.0, 25.0)),
    "white": Shades(chroma=(0.0, 14.0), light=(60.0, 100.0)),
    "grey": Shades(chroma=(0.0, 10.0), light=(15.0, 85.0)),
    "silver": Shades(chroma=(0.0, 10.0), light=(35.0, 95.0)),
    "cream": Shades(hue=(50.0, 110.0), chroma=(4.0, 30.0), light=(55.0, 100.0)),
    "red": _hued(350.0, 45.0, least=22.0),
    "rust": _hued(25.0, 70.0),
    "orange": _hued(40.0, 75.0, (25.0, 90.0), 25.0),
    "brown": _hued(30.0, 90.0, (8.0, 62.0), 8.0),
    "mustard": _hued(65.0, 100.0, (25.0, 85.0), 20.0),
    "yellow": _hued(70.0, 112.0, (30.0, 100.0), 20.0),
    "gold": _hued(60.0, 105.0, (20.0, 95.0), 18.0),
    "green": _hued(100.0, 185.0, least=9.0),
    "sage": _hued(95.0, 185.0, (20.0, 85.0), 4.0),
    "teal": _hued(165.0, 235.0, least=6.0),
    "turquoise": _hued(165.0, 235.0, (25.0, 95.0), 10.0),
    "blue": _hued(215.0, 305.0, least=8.0),
    "purple": _hued(290.0, 345.0, least=10.0),
    "pink": _hued(330.0, 25.0, (45.0, 100.0), 12.0),
}
_SAME: Final = {
    "gray": "grey",
    "violet": "purple",
    "lilac": "purple",
    "beige": "cream",
    "ivory": "cream",
    "crimson": "red",
    "scarlet": "red",
    "navy": "blue",
    "cyan": "turquoise",
    "golden": "gold",
    "ochre": "mustard",
    "terracotta": "rust",
    "olive": "sage",
}


def shades_of(word: str) -> Shades | None:
    """The shades that a word names; None for a word that names none."""
    return SHADES.get(_SAME.get(word, word))


def to_shades(rgb: Array) -> Array:
    """Lightness, chroma and hue (n, 3) of sRGB colours (n, 3) in [0, 1]."""
    value = np.asarray(rgb, dtype=float)
    linear = np.where(value <= 0.04045, value / 12.92, ((value + 0.055) / 1.055) ** 2.4)
    xyz = linear @ TO_XYZ.T / WHITE_POINT
    bent = np.where(xyz > (6 / 29) ** 3, np.cbrt(xyz), xyz / (3 * (6 / 29) ** 2) + 4 / 29)
    light = 116 * bent[:, 1] - 16
    a, b = 500 * (bent[:, 0] - bent[:, 1]), 200 * (bent[:, 1] - bent[:, 2])
    return np.column_stack([light, np.hypot(a, b), np.degrees(np.arctan2(b, a)) % 360.0])
