"""Fixed sample patterns: the same for every picture, so that a scene gives the same bytes every time.

Neighbouring pixels of a 4x4 tile use different directions; the ambient occlusion filter blends a tile, so the
pattern leaves no grain.
"""

from __future__ import annotations

import functools
import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

CELLS = 16
"""Pixels of a tile."""
_GOLDEN = 0.6180339887498949
_PLASTIC = 0.7548776662466927
_FIRST_RAYS = 3
_DITHER = (0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5)


@functools.cache
def pixel_offsets(samples: int) -> NDArray[np.float64]:
    """(samples, 2) positions within a pixel: its centre, then points around it."""
    offsets = np.full((samples, 2), 0.5)
    for number in range(1, samples):
        angle = 2 * math.pi * (number - 1) / (samples - 1) + 0.4
        radius = 0.4 if samples <= 6 or number % 2 else 0.22
        offsets[number] += (round(radius * math.cos(angle), 6), round(radius * math.sin(angle), 6))
    return offsets


@functools.cache
def disk_points(samples: int) -> NDArray[np.float64]:
    """(samples, CELLS, 2) points of the unit disk: the first covers it over a tile, the others in each pixel."""
    points = np.zeros((samples, CELLS, 2))
    for sample in range(samples):
        for cell in range(CELLS):
            step = _DITHER[cell]
            turn = step / CELLS if sample == 0 else (sample - 1 + step / CELLS) / (samples - 1)
            radius = math.sqrt(((step * 7 + sample * 5) % CELLS + 0.5) / CELLS)
            angle = 2 * math.pi * turn
            points[sample, cell] = (round(radius * math.cos(angle), 6), round(radius * math.sin(angle), 6))
    return points


@functools.cache
def texture_blends(samples: int) -> NDArray[np.float64]:
    """(samples,) what each sample adds to a texture's level before rounding down; their mean is 0.5."""
    return np.array([0.5, *((number + 0.5) / (samples - 1) for number in range(samples - 1))])


@functools.cache
def hemisphere_directions(samples: int, rays: int) -> NDArray[np.float64]:
    """(samples, rays, CELLS, 4): cosine-weighted directions around +Z and the share of the full reach of each."""
    directions = np.zeros((samples * rays, CELLS, 4))
    total = samples * rays * CELLS
    for ray in range(samples * rays):
        for cell in range(CELLS):
            number = ray * CELLS + _DITHER[cell]
            height = ((number * _PLASTIC) % 1.0 * (total - 1) + 0.5) / total
            angle = 2 * math.pi * ((number * _GOLDEN * _GOLDEN) % 1.0)
            flat = math.sqrt(height)
            reach = 0.35 + 0.65 * ((number * _GOLDEN) % 1.0)
            values = (flat * math.cos(angle), flat * math.sin(angle), math.sqrt(1 - height), reach)
            directions[ray, cell] = [round(value, 6) for value in values]
    return directions.reshape(samples, rays, CELLS, 4)


@functools.lru_cache(maxsize=4)
def tile_order(width: int, height: int) -> NDArray[np.int64]:
    """All pixels in reading order of 4x4 tiles, so that those of a packet lie together."""
    y, x = np.mgrid[0:height, 0:width]
    tile = (y // 4) * ((width + 3) // 4) + x // 4
    order: NDArray[np.int64] = np.argsort((tile * 16 + (y & 3) * 4 + (x & 3)).ravel(), kind="stable")
    return order


class Patterns(NamedTuple):
    """All patterns of a picture, for the kernels."""

    pixel: NDArray[np.float64]
    blend: NDArray[np.float64]
    disk: NDArray[np.float64]
    hemisphere: NDArray[np.float64]


def patterns_for(samples: int) -> Patterns:
    """Patterns for a picture with so many samples a pixel; the first sample sends more occlusion rays."""
    return Patterns(
        pixel_offsets(samples),
        texture_blends(samples),
        disk_points(samples),
        hemisphere_directions(samples, _FIRST_RAYS if samples > 1 else 1),
    )
