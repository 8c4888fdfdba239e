"""Fixed sample patterns: the same for every picture, so that a scene gives the same bytes every time.

Neighbouring pixels of a 4x4 tile use different directions; the ambient occlusion filter blends a tile, so the
pattern leaves no grain.
"""

from __future__ import annotations

import functools
import math

import numpy as np
from numpy.typing import NDArray

from c4s.engine.headless.render.layout import LANES

_GOLDEN = 0.6180339887498949
_PLASTIC = 0.7548776662466927
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
    """(samples, LANES, 2) points of the unit disk, evenly spread over the samples of a pixel and over a tile."""
    points = np.zeros((samples, LANES, 2))
    for sample in range(samples):
        for lane in range(LANES):
            step = _DITHER[lane]
            radius = math.sqrt(((sample * LANES + step * 7 % LANES) + 0.5) / (samples * LANES))
            angle = 2 * math.pi * ((step / LANES + sample * _GOLDEN) % 1.0)
            points[sample, lane] = (round(radius * math.cos(angle), 6), round(radius * math.sin(angle), 6))
    return points


@functools.cache
def hemisphere_directions(samples: int) -> NDArray[np.float64]:
    """(samples, LANES, 4): cosine-weighted directions around +Z and the share of the full reach of each."""
    directions = np.zeros((samples, LANES, 4))
    total = samples * LANES
    for sample in range(samples):
        for lane in range(LANES):
            number = sample * LANES + _DITHER[lane]
            height = ((number * _PLASTIC) % 1.0 * (total - 1) + 0.5) / total
            angle = 2 * math.pi * ((number * _GOLDEN * _GOLDEN) % 1.0)
            flat = math.sqrt(height)
            reach = 0.35 + 0.65 * ((number * _GOLDEN) % 1.0)
            values = (flat * math.cos(angle), flat * math.sin(angle), math.sqrt(1 - height), reach)
            directions[sample, lane] = [round(value, 6) for value in values]
    return directions
