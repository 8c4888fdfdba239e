"""From light to bytes (compiled): the occlusion filter, exposure, and the tone curve."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from c4s.engine.headless.render.compiled import kernel
from c4s.engine.headless.render.kernels import Buffers
from c4s.engine.headless.render.textures import ENCODE_STEPS

BINS_PER_STOP, LOWEST_STOP, BINS = 4, -12, 96
"""The luminance histogram: quarter stops from 2^-12 to 2^12."""
_KEY = 0.30
_HIGHLIGHT = 3.0
_LOWEST_EV, _HIGHEST_EV = -6.0, 5.0
_OCCLUSION_FLOOR = 0.12


@kernel
def combine_rows(first: int, last: int, buffers: Buffers, light: NDArray[np.float32],
                 histogram: NDArray[np.int64]) -> None:
    """Write direct plus occluded ambient light of some rows, and count the luminance of their surfaces.

    Occlusion is averaged over 4x4 neighbours on the same plane, one full period of the sample pattern.
    """
    height, width = buffers.depth.shape
    for y in range(first, last):
        for x in range(width):
            weight, total = 1e-6, 1e-6 * buffers.open[y, x]
            n0, n1, n2 = buffers.normal[y, x, 0], buffers.normal[y, x, 1], buffers.normal[y, x, 2]
            seen = n0 * n0 + n1 * n1 + n2 * n2 > 0.5
            if seen:
                p0, p1, p2 = buffers.point[y, x, 0], buffers.point[y, x, 1], buffers.point[y, x, 2]
                near = 0.004 * buffers.depth[y, x] + 0.5
                for j in range(max(y - 2, 0), min(y + 2, height)):
                    for i in range(max(x - 2, 0), min(x + 2, width)):
                        other, point = buffers.normal[j, i], buffers.point[j, i]
                        if n0 * other[0] + n1 * other[1] + n2 * other[2] < 0.85:
                            continue
                        if abs(n0 * (point[0] - p0) + n1 * (point[1] - p1) + n2 * (point[2] - p2)) < near:
                            weight += 1.0
                            total += buffers.open[j, i]
            share = _OCCLUSION_FLOOR + (1.0 - _OCCLUSION_FLOOR) * total / weight
            for channel in range(3):
                light[y, x, channel] = buffers.direct[y, x, channel] + buffers.ambient[y, x, channel] * share
            if seen:
                luminance = 0.2126 * light[y, x, 0] + 0.7152 * light[y, x, 1] + 0.0722 * light[y, x, 2]
                step = int(math.floor((math.log2(max(luminance, 1e-6)) - LOWEST_STOP) * BINS_PER_STOP))
                histogram[min(max(step, 0), BINS - 1)] += 1


def exposure_for(histogram: NDArray[np.int64]) -> float:
    """Exposure in stops that brings the median surface to mid tone without burning out the brightest twentieth."""
    total = int(histogram.sum())
    if total == 0:
        return 0.0
    running = np.cumsum(histogram)

    def stop(share: float) -> float:
        index = int(np.searchsorted(running, share * total))
        return LOWEST_STOP + (min(index, BINS - 1) + 0.5) / BINS_PER_STOP

    wanted = math.log2(_KEY) - stop(0.5)
    bounded = min(wanted, math.log2(_HIGHLIGHT) - stop(0.95))
    return round(min(max(bounded, _LOWEST_EV), _HIGHEST_EV) * BINS_PER_STOP) / BINS_PER_STOP


@kernel
def develop_rows(first: int, last: int, light: NDArray[np.float32], gain: float, curve: bool,
                 encode: NDArray[np.uint8], rgb: NDArray[np.uint8]) -> None:
    """sRGB bytes of some rows; ``curve`` applies the filmic tone curve (Narkowicz 2015), else values are clamped."""
    width = light.shape[1]
    for y in range(first, last):
        for x in range(width):
            for channel in range(3):
                value = light[y, x, channel] * gain
                if curve:
                    value = value * 0.6
                    value = value * (2.51 * value + 0.03) / (value * (2.43 * value + 0.59) + 0.14)
                value = min(max(value, 0.0), 1.0)
                rgb[y, x, channel] = encode[int(math.sqrt(value) * ENCODE_STEPS + 0.5)]
