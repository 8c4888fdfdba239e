"""What the readers of mesh files hand over: surfaces and parts in Unreal's axes and cm."""

from __future__ import annotations

import io
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Literal

import numpy as np
from numpy.typing import NDArray
from PIL import Image

Colour = tuple[float, float, float]
MAX_TEXTURE = 1024
"""Textures are reduced to this many pixels a side: a pack is read by every engine process."""


@dataclass(frozen=True)
class Surface:
    """What a face looks like: linear base colour, and PNGs of textures, which mean what they mean in ``Material``."""

    name: str
    color: Colour = (0.5, 0.5, 0.5)
    roughness: float = 0.8
    metallic: float = 0.0
    emissive: Colour = (0.0, 0.0, 0.0)
    opacity: float = 1.0
    texture: bytes | None = None
    alpha: Literal["opaque", "mask", "blend"] = "opaque"
    alpha_cutoff: float = 0.5
    normal_texture: bytes | None = None
    roughness_metal_texture: bytes | None = None
    emissive_texture: bytes | None = None


@dataclass(frozen=True)
class SourcePart:
    """The triangles of one node and one surface; cm, Unreal's axes; the arrays of vertices as in ``Mesh``."""

    node: str
    surface: Surface
    vertices: NDArray[np.float64]
    faces: NDArray[np.int64]
    normals: NDArray[np.float64]
    uvs: NDArray[np.float64]
    colors: NDArray[np.float64] | None = None


@dataclass
class Source:
    """A read mesh file."""

    parts: list[SourcePart]
    notes: list[str] = field(default_factory=list)


def linear(channel: float) -> float:
    """A display (sRGB) channel in [0, 1] as linear light."""
    return channel / 12.92 if channel <= 0.04045 else float(((channel + 0.055) / 1.055) ** 2.4)


def color_of(values: object) -> Colour:
    """Three channels in [0, 1], rounded to four digits."""
    r, g, b = (round(min(1.0, max(0.0, float(value))), 4) + 0.0 for value in np.asarray(values, dtype=float)[:3])
    return r, g, b


def linear_of(shown: NDArray[np.float64]) -> NDArray[np.float64]:
    """Display (sRGB) channels in [0, 1] as linear light."""
    return np.where(shown <= 0.04045, shown / 12.92, ((shown + 0.055) / 1.055) ** 2.4)


def texture_png(image: Image.Image, *, alpha: bool = False) -> bytes:
    """PNG bytes of a picture, reduced to ``MAX_TEXTURE``; without its transparency unless ``alpha``."""
    image = image.convert("RGBA") if image.mode in ("P", "LA", "PA") or alpha else image
    image = image if alpha else image.convert("RGB")
    return _encoded(image.mode, image.size, image.tobytes())


def has_alpha(image: Image.Image) -> bool:
    """Whether any pixel of a picture is transparent."""
    if image.mode in ("P", "PA") and "transparency" in image.info:
        image = image.convert("RGBA")
    return "A" in image.getbands() and bool(np.asarray(image.getchannel("A")).min() < 255)


@lru_cache(maxsize=8)
def _encoded(mode: str, size: tuple[int, int], data: bytes) -> bytes:
    image = Image.frombytes(mode, size, data)
    if max(image.size) > MAX_TEXTURE:
        factor = MAX_TEXTURE / max(image.size)
        image = image.resize(
            (max(1, round(image.width * factor)), max(1, round(image.height * factor))), Image.Resampling.BOX
        )
    out = io.BytesIO()
    image.save(out, format="PNG")
    return out.getvalue()
