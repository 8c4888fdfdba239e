"""From light to bytes (compiled): the occlusion filter, exposure, and the tone curve."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from c4s.errors import BadInput
from c4s.render.compiled import inner, kernel
from c4s.render.packets import Buffers
from c4s.render.textures import ENCODE_STEPS
from c4s.render.types import Grade

BINS_PER_STOP, LOWEST_STOP, BINS = 4, -14, 132
"""The luminance histogram: quarter stops from 2^-14 to 2^19."""
_KEY = 0.30
_HIGHLIGHT = 3.0
_LOWEST_EV, _HIGHEST_EV = -17.0, 5.0
_OCCLUSION_FLOOR = 0.12


@kernel
def mark_edges(first: int, last: int, width: int, height: int, buffers: Buffers, edge: NDArray[np.bool_]) -> None:
    """Mark the pixels of some rows that need more samples: a neighbour shows another surface, slope or light."""
    for y in range(first, last):
        for x in range(width):
            here = y * width + x
            n0, n1, n2 = buffers.normal[here, 0], buffers.normal[here, 1], buffers.normal[here, 2]
            p0, p1, p2 = buffers.point[here, 0], buffers.point[here, 1], buffers.point[here, 2]
            seen = n0 * n0 + n1 * n1 + n2 * n2 > 0.5
            near = 0.004 * buffers.depth[here] + 0.5 if seen else 0.0
            found = False
            for j in range(max(y - 1, 0), min(y + 2, height)):
                for i in range(max(x - 1, 0), min(x + 2, width)):
                    there = j * width + i
                    if buffers.identity[there] != buffers.identity[here]:
                        found = True
                    elif seen:
                        other, point = buffers.normal, buffers.point
                        if n0 * other[there, 0] + n1 * other[there, 1] + n2 * other[there, 2] < 0.97:
                            found = True
                        away = n0 * (point[there, 0] - p0) + n1 * (point[there, 1] - p1) + n2 * (point[there, 2] - p2)
                        if abs(away) > near:
                            found = True
            edge[here] = found


@inner
def _blocked_columns(y: int, width: int, height: int, buffers: Buffers, blocked: NDArray[np.int64]) -> None:
    """Count by column the pixels of a filter's rows of which some ray of occlusion was blocked."""
    for x in range(width):
        blocked[x] = 0
    for j in range(max(y - 2, 0), min(y + 2, height)):
        for x in range(width):
            there = j * width + x
            if buffers.open[there, 0] != buffers.open[there, 1]:
                blocked[x] += 1


@kernel
def combine_rows(
    first: int,
    last: int,
    width: int,
    height: int,
    buffers: Buffers,
    light: NDArray[np.float32],
    histogram: NDArray[np.int64],
) -> None:
    """Write direct plus occluded ambient light of some rows, and count the luminance of their surfaces.

    Occlusion is averaged over 4x4 neighbours on the same plane, one full period of the sample pattern; where no ray of
    theirs was blocked there is none.
    """
    normal, point = buffers.normal, buffers.point
    blocked = np.zeros(width, dtype=np.int64)
    for y in range(first, last):
        _blocked_columns(y, width, height, buffers, blocked)
        for x in range(width):
            here = y * width + x
            away, rays = 1e-6 + buffers.open[here, 0], 1e-6 + buffers.open[here, 1]
            n0, n1, n2 = normal[here, 0], normal[here, 1], normal[here, 2]
            seen = n0 * n0 + n1 * n1 + n2 * n2 > 0.5
            near_blocked = 0
            for i in range(max(x - 2, 0), min(x + 2, width)):
                near_blocked += blocked[i]
            if seen and near_blocked > 0:
                away, rays = 1e-6, 1e-6
                p0, p1, p2 = point[here, 0], point[here, 1], point[here, 2]
                near = 0.004 * buffers.depth[here] + 0.5
                for j in range(max(y - 2, 0), min(y + 2, height)):
                    for i in range(max(x - 2, 0), min(x + 2, width)):
                        there = j * width + i
                        if n0 * normal[there, 0] + n1 * normal[there, 1] + n2 * normal[there, 2] < 0.85:
                            continue
                        if (
                            abs(n0 * (point[there, 0] - p0) + n1 * (point[there, 1] - p1) + n2 * (point[there, 2] - p2))
                            < near
                        ):
                            away += buffers.open[there, 0]
                            rays += buffers.open[there, 1]
            share = (_OCCLUSION_FLOOR + (1.0 - _OCCLUSION_FLOOR) * away / rays) / buffers.samples[here]
            luminance = 0.0
            for channel in range(3):
                value = buffers.direct[here, channel] / buffers.samples[here] + buffers.ambient[here, channel] * share
                light[here, channel] = value
                luminance += value * (0.2126 if channel == 0 else (0.7152 if channel == 1 else 0.0722))
            if seen:
                bounded = min(luminance, 5e5) if luminance > 1e-6 else 1e-6
                step = math.floor((math.log2(bounded) - LOWEST_STOP) * BINS_PER_STOP)
                histogram[min(max(step, 0), BINS - 1)] += 1


def exposure_for(histogram: NDArray[np.int64], lowest_ev: float, highest_ev: float) -> float:
    """Exposure in stops that brings the median surface to mid tone without burning out the brightest twentieth.

    It keeps within the limits, in stops.
    """
    total = int(histogram.sum())
    if total == 0:
        return 0.0
    running = np.cumsum(histogram)

    def stop(share: float) -> float:
        index = int(np.searchsorted(running, share * total))
        return LOWEST_STOP + (min(index, BINS - 1) + 0.5) / BINS_PER_STOP

    wanted = math.log2(_KEY) - stop(0.5)
    bounded = min(wanted, math.log2(_HIGHLIGHT) - stop(0.95))
    steps = round(min(max(bounded, _LOWEST_EV), _HIGHEST_EV) * BINS_PER_STOP) / BINS_PER_STOP
    return min(max(steps, lowest_ev), highest_ev)


SATURATION, CONTRAST, GAMMA, GAIN, OFFSET = 3, 4, 5, 6, 7
"""Rows of a grade's table after the white balance."""


def grade_table(grade: Grade) -> NDArray[np.float64]:
    """(8, 3) numbers of a grade; of no rows for one that changes no colour.

    Raises:
        BadInput: a number that is not finite.
    """
    table = np.array(
        [*grade.white_balance, grade.saturation, grade.contrast, grade.gamma, grade.gain, grade.offset],
        dtype=np.float64,
    )
    if not np.isfinite(table).all():
        raise BadInput("the grade has a value that is not finite", where="renderer")
    plain = Grade()
    same = np.array([*plain.white_balance, plain.saturation, plain.contrast, plain.gamma, plain.gain, plain.offset])
    return np.zeros((0, 3)) if (table == same).all() else table


@inner
def _graded(color: NDArray[np.float64], grade: NDArray[np.float64]) -> None:
    red, green, blue = color[0], color[1], color[2]
    for channel in range(3):
        color[channel] = max(0.0, grade[channel, 0] * red + grade[channel, 1] * green + grade[channel, 2] * blue)
    grey = 0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2]
    for channel in range(3):
        value = max(0.0, grey + (color[channel] - grey) * grade[SATURATION, channel])
        value = 0.18 * (value / 0.18) ** grade[CONTRAST, channel]
        value = value ** (1.0 / max(grade[GAMMA, channel], 0.01))
        color[channel] = value * grade[GAIN, channel] + grade[OFFSET, channel]


@kernel
def develop_pixels(
    first: int,
    last: int,
    light: NDArray[np.float32],
    gain: float,
    curve: bool,
    grade: NDArray[np.float64],
    encode: NDArray[np.uint8],
    rgb: NDArray[np.uint8],
) -> None:
    """sRGB bytes of some pixels; ``curve`` grades and applies the filmic tone curve (Narkowicz 2015), else values are
    clamped."""
    color = np.zeros(3)
    for pixel in range(first, last):
        for channel in range(3):
            color[channel] = light[pixel, channel] * gain * (0.6 if curve else 1.0)
        if curve and len(grade):
            _graded(color, grade)
        for channel in range(3):
            value = color[channel]
            if curve:
                value = value * (2.51 * value + 0.03) / (value * (2.43 * value + 0.59) + 0.14)
            value = min(value, 1.0) if value > 0.0 else 0.0
            rgb[pixel, channel] = encode[int(math.sqrt(value) * ENCODE_STEPS + 0.5)]
