"""Textures as pyramids of halved pictures in one flat array, and the sRGB transfer functions as tables."""

from __future__ import annotations

import functools
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from c4s.errors import BadInput

MAX_LEVELS = 14
ENCODE_STEPS = 16384
"""The encoding table is indexed by the square root of the linear value times this."""


class Textures(NamedTuple):
    """All textures of a scene, for the kernels."""

    levels: NDArray[np.int64]
    """(textures, MAX_LEVELS, 3): first texel, width, height."""
    level_counts: NDArray[np.int64]
    texels: NDArray[np.uint8]
    """(n, 4) colour and alpha."""
    coding: NDArray[np.int64]
    """Row of ``decode`` that a texture's colours are read by."""
    decode: NDArray[np.float32]
    """(2, 256) value of a byte: 0 sRGB, 1 plain."""


class TexturePicture(NamedTuple):
    """A texture: (H, W, 3 or 4) bytes, and whether they are colours (sRGB) or numbers (normals, roughness)."""

    pixels: NDArray[np.uint8]
    colors: bool


@functools.cache
def decode_table() -> NDArray[np.float32]:
    """Linear value of each sRGB byte (IEC 61966-2-1)."""
    value = [byte / 255 for byte in range(256)]
    return np.array([v / 12.92 if v <= 0.04045 else ((v + 0.055) / 1.055) ** 2.4 for v in value], dtype=np.float32)


@functools.cache
def encode_table() -> NDArray[np.uint8]:
    """sRGB byte of each linear value ``(i / ENCODE_STEPS) ** 2``."""
    value = [(step / ENCODE_STEPS) ** 2 for step in range(ENCODE_STEPS + 1)]
    coded = [12.92 * v if v <= 0.0031308 else 1.055 * v ** (1 / 2.4) - 0.055 for v in value]
    return np.array([int(255 * c + 0.5) for c in coded], dtype=np.uint8)


def srgb_bytes(linear: NDArray[np.float32]) -> NDArray[np.uint8]:
    """sRGB bytes of linear values, clamped to 0..1."""
    steps = np.sqrt(np.clip(linear, 0.0, 1.0)) * np.float32(ENCODE_STEPS) + np.float32(0.5)
    coded: NDArray[np.uint8] = encode_table()[steps.astype(np.int32)]
    return coded


def _halved(picture: NDArray[np.float32]) -> NDArray[np.float32]:
    height, width = picture.shape[:2]
    if height > 1:
        picture = (picture[0 : height // 2 * 2 : 2] + picture[1 : height // 2 * 2 : 2]) * np.float32(0.5)
    if width > 1:
        picture = (picture[:, 0 : width // 2 * 2 : 2] + picture[:, 1 : width // 2 * 2 : 2]) * np.float32(0.5)
    return picture


def _four(picture: NDArray[np.uint8]) -> NDArray[np.uint8]:
    if picture.ndim != 3 or picture.shape[2] not in (3, 4) or picture.dtype != np.uint8 or not picture.size:
        raise BadInput(f"a texture is {picture.dtype} {picture.shape}, not uint8 (H, W, 3 or 4)", where="renderer")
    if picture.shape[2] == 4:
        return picture
    full = np.full((*picture.shape[:2], 4), 255, dtype=np.uint8)
    full[..., :3] = picture
    return full


def build_textures(pictures: Sequence[TexturePicture]) -> Textures:
    """The pyramids of pictures; each level halves the last, colours in linear light."""
    levels = np.zeros((max(1, len(pictures)), MAX_LEVELS, 3), dtype=np.int64)
    counts = np.zeros(max(1, len(pictures)), dtype=np.int64)
    coding = np.zeros(max(1, len(pictures)), dtype=np.int64)
    plain = (np.arange(256) / 255).astype(np.float32)
    parts: list[NDArray[np.uint8]] = []
    start = 0
    for number, picture in enumerate(pictures):
        pixels = _four(picture.pixels)
        coding[number] = 0 if picture.colors else 1
        linear = plain[pixels]
        if picture.colors:
            linear[..., :3] = decode_table()[pixels[..., :3]]
        for level in range(MAX_LEVELS):
            coded = pixels if level == 0 else _coded(linear, picture.colors)
            levels[number, level] = (start, linear.shape[1], linear.shape[0])
            counts[number] = level + 1
            parts.append(coded.reshape(-1, 4))
            start += linear.shape[0] * linear.shape[1]
            if max(linear.shape[:2]) == 1:
                break
            linear = _halved(linear)
    texels = np.concatenate(parts) if parts else np.zeros((1, 4), dtype=np.uint8)
    return Textures(levels, counts, np.ascontiguousarray(texels), coding, np.stack([decode_table(), plain]))


def _coded(values: NDArray[np.float32], colors: bool) -> NDArray[np.uint8]:
    coded: NDArray[np.uint8] = (values * np.float32(255) + np.float32(0.5)).astype(np.uint8)
    if colors:
        coded[..., :3] = srgb_bytes(values[..., :3])
    return coded
