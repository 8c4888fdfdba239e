"""Names of the colours that a thing shows, by area: what a person would say first about its looks."""

from __future__ import annotations

import io
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from catalog.ingest.surface import SourcePart, linear_of

NAMED: dict[str, tuple[int, int, int]] = {
    "black": (22, 22, 24),
    "dark grey": (70, 72, 75),
    "grey": (128, 128, 128),
    "light grey": (190, 192, 195),
    "white": (245, 245, 243),
    "red": (200, 40, 40),
    "dark red": (115, 30, 35),
    "orange": (230, 130, 45),
    "brown": (120, 78, 48),
    "dark brown": (70, 46, 34),
    "light brown": (178, 130, 90),
    "beige": (222, 200, 165),
    "yellow": (240, 205, 60),
    "olive": (120, 120, 50),
    "green": (80, 150, 70),
    "dark green": (35, 80, 50),
    "light green": (160, 205, 120),
    "teal": (45, 135, 135),
    "light blue": (140, 190, 225),
    "blue": (50, 95, 190),
    "dark blue": (35, 50, 100),
    "purple": (120, 70, 150),
    "pink": (235, 150, 175),
}
"""Display (sRGB) colours."""
LEAST_SHARE = 0.12
MOST = 3
SAMPLES = 1000


def _lab(shown: NDArray[np.float64]) -> NDArray[np.float64]:
    """CIE L*a*b* (D65) of display colours in [0, 1]."""
    xyz = linear_of(shown) @ np.array([[0.4124, 0.2126, 0.0193], [0.3576, 0.7152, 0.1192], [0.1805, 0.0722, 0.9505]])
    ratio = xyz / [0.9505, 1.0, 1.089]
    curve = np.where(ratio > 0.008856, np.cbrt(ratio), 7.787 * ratio + 16 / 116)
    return np.stack(
        [116 * curve[..., 1] - 16, 500 * (curve[..., 0] - curve[..., 1]), 200 * (curve[..., 1] - curve[..., 2])],
        axis=-1,
    )


_LAB = _lab(np.array(list(NAMED.values())) / 255)


def named(shown: NDArray[np.float64]) -> list[str]:
    """The nearest named colour of each display colour in [0, 1]."""
    distance = np.linalg.norm(_lab(np.asarray(shown, float))[:, None] - _LAB[None], axis=2)
    names = list(NAMED)
    return [names[index] for index in np.argmin(distance, axis=1)]


def colours_of(parts: list[SourcePart]) -> list[str]:
    """Up to ``MOST`` colour names that each cover at least ``LEAST_SHARE`` of the surface, the largest first."""
    share: dict[str, float] = {}
    for part in parts:
        corners = part.vertices[part.faces]
        areas = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
        step = max(1, len(areas) // SAMPLES)
        shown = _shown(part, np.arange(0, len(areas), step))
        for name, area in zip(named(shown), areas[::step], strict=True):
            share[name] = share.get(name, 0.0) + float(area) * step
    whole = sum(share.values())
    ordered = sorted(share, key=lambda name: (-share[name], name))
    return [name for name in ordered if whole and share[name] >= LEAST_SHARE * whole][:MOST]


def _shown(part: SourcePart, faces: NDArray[np.int64]) -> NDArray[np.float64]:
    """Display colours of some triangles in their middle."""
    surface, corners = part.surface, part.faces[faces]
    color = np.tile(np.asarray(surface.color, float), (len(faces), 1))
    if part.colors is not None:
        color = color * part.colors[corners].mean(axis=1)
    if surface.texture is not None:
        picture = _pixels(surface.texture)
        middle = part.uvs[corners].mean(axis=1) % 1.0
        rows = np.minimum((middle[:, 1] * len(picture)).astype(int), len(picture) - 1)
        columns = np.minimum((middle[:, 0] * picture.shape[1]).astype(int), picture.shape[1] - 1)
        color = color * picture[rows, columns]
    color = np.clip(color + np.asarray(surface.emissive, float), 0.0, 1.0)
    shown: NDArray[np.float64] = np.where(color <= 0.0031308, color * 12.92, 1.055 * color ** (1 / 2.4) - 0.055)
    return shown


@lru_cache(maxsize=16)
def _pixels(png: bytes) -> NDArray[np.float64]:
    """A small linear copy of a picture."""
    image = Image.open(io.BytesIO(png)).convert("RGB")
    image.thumbnail((256, 256))
    return linear_of(np.asarray(image, float) / 255)
