"""Colours of proxies: from the words of name and category, else one that the category always gets. Linear RGB."""

from __future__ import annotations

import colorsys
import hashlib
from collections.abc import Sequence

Colour = tuple[float, float, float]

WORDS: tuple[tuple[tuple[str, ...], Colour], ...] = (
    (("gold", "golden", "brass", "crown"), (0.80, 0.55, 0.12)),
    (
        ("tree", "leaf", "bush", "shrub", "grass", "plant", "ivy", "palm", "hedge", "vegetation", "foliage", "moss"),
        (0.10, 0.26, 0.06),
    ),
    (("water", "river", "sea", "puddle", "fountain", "waterfall", "waterffall", "pool"), (0.06, 0.30, 0.38)),
    (("glass", "window", "pane"), (0.28, 0.42, 0.52)),
    (
        (
            "wood",
            "wooden",
            "plank",
            "crate",
            "barrel",
            "bench",
            "table",
            "chair",
            "door",
            "beam",
            "log",
            "cart",
            "pier",
            "fence",
            "pallet",
            "shelf",
        ),
        (0.30, 0.16, 0.07),
    ),
    (("brick", "chimney", "roof", "tile", "terracotta"), (0.38, 0.12, 0.06)),
    (("road", "asphalt", "street", "tire", "tyre", "wheel"), (0.10, 0.10, 0.11)),
    (
        (
            "metal",
            "iron",
            "steel",
            "pipe",
            "vent",
            "lamp",
            "lantern",
            "rail",
            "railing",
            "bollard",
            "antenna",
            "conditioning",
            "tubing",
            "container",
            "crane",
        ),
        (0.16, 0.17, 0.19),
    ),
    (("neon", "light", "led", "sign", "screen", "showcase"), (0.75, 0.10, 0.42)),
    (("rock", "stone", "boulder", "cliff", "concrete", "cobble", "pavement", "curb", "quay"), (0.36, 0.34, 0.31)),
    (
        (
            "sand",
            "arch",
            "tower",
            "wall",
            "pillar",
            "column",
            "parapet",
            "teeth",
            "stair",
            "stairs",
            "bazaar",
            "minaret",
            "dome",
            "architecture",
        ),
        (0.58, 0.44, 0.27),
    ),
    (
        ("cloth", "fabric", "awning", "canopy", "curtain", "flag", "carpet", "rug", "tent", "umbrella"),
        (0.55, 0.09, 0.10),
    ),
    (("ground", "dirt", "soil", "mud", "field", "path", "terrain"), (0.24, 0.18, 0.10)),
    (("snow", "marble", "plaster", "white"), (0.75, 0.74, 0.71)),
    (("car", "truck", "van", "vehicle", "lorean", "boat", "ship"), (0.12, 0.24, 0.45)),
    (("house", "building", "facade", "townhouse"), (0.62, 0.50, 0.34)),
)
NAMED: dict[str, Colour] = {
    "red": (0.5, 0.04, 0.03),
    "blue": (0.05, 0.12, 0.45),
    "green": (0.06, 0.30, 0.09),
    "yellow": (0.75, 0.52, 0.05),
    "orange": (0.75, 0.25, 0.03),
    "pink": (0.75, 0.22, 0.40),
    "purple": (0.25, 0.08, 0.42),
    "black": (0.02, 0.02, 0.02),
    "brown": (0.22, 0.11, 0.05),
    "grey": (0.25, 0.25, 0.25),
    "gray": (0.25, 0.25, 0.25),
    "cyan": (0.05, 0.5, 0.55),
}


def base_colour(words: Sequence[str], category: str, identity: str) -> Colour:
    """The main colour, varied a little by identity so that neighbours can be told apart."""
    colour = next((NAMED[word] for word in words if word in NAMED), None)
    if colour is None:
        colour = next((found for keys, found in WORDS for word in words if word in keys), None)
    if colour is None:
        hue = int.from_bytes(hashlib.sha256(category.encode()).digest()[:2], "big") / 65536
        colour = colorsys.hsv_to_rgb(hue, 0.35, 0.45)
    shade = 0.8 + 0.4 * hashlib.sha256(identity.encode()).digest()[0] / 255
    return (min(1.0, colour[0] * shade), min(1.0, colour[1] * shade), min(1.0, colour[2] * shade))


def accent(colour: Colour) -> Colour:
    """A second colour that stands out against the first: darker on light, lighter on dark."""
    bright = sum(colour) / 3
    return tuple(c * 0.4 for c in colour) if bright > 0.15 else tuple(0.25 + c * 0.6 for c in colour)  # type: ignore[return-value]
