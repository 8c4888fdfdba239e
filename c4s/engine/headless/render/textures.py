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
    """(n, 3) sRGB."""
    decode: NDArray[np.float32]
    """(256,) linear value of an sRGB byte."""


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
        picture = (picture[0:height // 2 * 2:2] + picture[1:height // 2 * 2:2]) * np.float32(0.5)
    if width > 1:
        picture = (picture[:, 0:width // 2 * 2:2] + picture[:, 1:width // 2 * 2:2]) * np.float32(0.5)
    return picture


def build_textures(pictures: Sequence[NDArray[np.uint8]]) -> Textures:
    """The pyramids of (H, W, 3) sRGB pictures; each level halves the last in linear light."""
    levels = np.zeros((max(1, len(pictures)), MAX_LEVELS, 3), dtype=np.int64)
    counts = np.zeros(max(1, len(pictures)), dtype=np.int64)
    parts: list[NDArray[np.uint8]] = []
    start = 0
    for number, picture in enumerate(pictures):
        if picture.ndim != 3 or picture.shape[2] != 3 or picture.dtype != np.uint8 or not picture.size:
            raise BadInput(f"a texture is {picture.dtype} {picture.shape}, not uint8 (H, W, 3)", where="renderer")
        linear = decode_table()[picture]
        for level in range(MAX_LEVELS):
            coded = picture if level == 0 else srgb_bytes(linear)
            levels[number, level] = (start, linear.shape[1], linear.shape[0])
            counts[number] = level + 1
            parts.append(coded.reshape(-1, 3))
            start += linear.shape[0] * linear.shape[1]
            if max(linear.shape[:2]) == 1:
                break
            linear = _halved(linear)
    texels = np.concatenate(parts) if parts else np.zeros((1, 3), dtype=np.uint8)
    return Textures(levels, counts, np.ascontiguousarray(texels), decode_table().copy())
