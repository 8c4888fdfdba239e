"""The compiled core: rays for a list of pixels, what they hit, and the light there.

Eight pixels are traced together, one a lane of Embree's packets. Translucent surfaces are layers: the ray goes on
behind them with what they let through. Everything is scalar code in a fixed order, so a scene gives the
same bytes whatever the number of threads.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from c4s.render.compiled import inner, kernel
from c4s.render.layout import GEOMETRY, INSTANCE, LANES, PRIMITIVE, TFAR, TNEAR
from c4s.render.lighting import LightTables, fog_passes, fog_radiance, sky_radiance
from c4s.render.packets import FAR, Buffers, Scratch, ViewRays, aim, query
from c4s.render.sampling import Patterns
from c4s.render.shade import shade
from c4s.render.surfaces import read_hit
from c4s.render.tables import SceneTables
from c4s.render.textures import Textures

MAX_LAYERS = 6
"""Translucent surfaces seen through before the next one is drawn as opaque."""


@inner
def _start_rays(
    scratch: Scratch,
    count: int,
    pixels: NDArray[np.int64],
    first: int,
    view: ViewRays,
    width: int,
    height: int,
    offset_x: float,
    offset_y: float,
) -> None:
    """Aim the primary packet at an offset within each of ``count`` pixels."""
    primary, lanes, axes = scratch.primary, scratch.lanes, view.axes
    for k in range(LANES):
        primary.valid[k] = 0
        scratch.through[k] = 0.0
        if k >= count:
            continue
        pixel = pixels[first + k]
        x, y = pixel % width, pixel // width
        scratch.pixel[k], scratch.cell[k] = pixel, (y & 3) * 4 + (x & 3)
        sx = (x + offset_x) / width * 2.0 - 1.0
        sy = 1.0 - (y + offset_y) / height * 2.0
        dx = axes[1, 0] + axes[2, 0] * sx + axes[3, 0] * sy
        dy = axes[1, 1] + axes[2, 1] * sx + axes[3, 1] * sy
        dz = axes[1, 2] + axes[2, 2] * sx + axes[3, 2] * sy
        scale = 1.0 / math.sqrt(dx * dx + dy * dy + dz * dz)
        lanes.ray[k, 0], lanes.ray[k, 1], lanes.ray[k, 2] = dx * scale, dy * scale, dz * scale
        aim(primary, k, axes[0], 0.1, dx * scale, dy * scale, dz * scale, FAR, -1)
        scratch.through[k] = 1.0


@inner
def _next_layer(
    scratch: Scratch,
    view: ViewRays,
    scene: SceneTables,
    textures: Textures,
    lights: LightTables,
    out: Buffers,
    pixel_size: float,
    blend: float,
    first_sample: bool,
    last_layer: bool,
) -> bool:
    """Find the next surface of every lane that is still going; whether any goes on behind it is returned."""
    primary, lanes, through = scratch.primary, scratch.lanes, scratch.through
    for k in range(LANES):
        primary.numbers[PRIMITIVE + k] = -1
        primary.numbers[GEOMETRY + k] = -1
        primary.numbers[INSTANCE + k] = -1
    query(view.intersect, primary.valid_address, view.scene, primary.address)
    going = False
    for k in range(LANES):
        lanes.weight[k] = 0.0
        if primary.valid[k] == 0:
            continue
        if primary.numbers[GEOMETRY + k] == -1:
            if view.lit:
                clear = fog_passes(lights, view.axes[0], lanes.ray[k], FAR)
                for channel in range(3):
                    lanes.direct[k, channel] += through[k] * (
                        clear * sky_radiance(lights.sky, lanes.ray[k, 2], channel)
                        + (1.0 - clear) * fog_radiance(lights, lanes.ray[k], channel)
                    )
            primary.valid[k] = 0
            continue
        opacity = read_hit(primary, k, lanes, scene, textures, pixel_size, blend)
        lanes.clear[k] = 1 if opacity < 1.0 else 0
        if last_layer:
            opacity = 1.0
        distance = primary.words[TFAR + k]
        lanes.weight[k] = through[k] * opacity
        pixel = scratch.pixel[k]
        if first_sample:
            out.identity[pixel] = out.identity[pixel] * 31 + lanes.surface[k] + 1
            if out.actor[pixel] == -1 and opacity >= 0.5:
                out.actor[pixel] = scene.actor[primary.numbers[INSTANCE + k]]
                out.depth[pixel] = distance * (
                    lanes.ray[k, 0] * view.axes[1, 0]
                    + lanes.ray[k, 1] * view.axes[1, 1]
                    + lanes.ray[k, 2] * view.axes[1, 2]
                )
                for axis in range(3):
                    out.normal[pixel, axis] = lanes.facing[k, axis]
                    out.point[pixel, axis] = lanes.point[k, axis]
        if not view.lit:
            for channel in range(3):
                lanes.direct[k, channel] += lanes.weight[k] * lanes.albedo[k, channel]
        else:
            clear = fog_passes(lights, view.axes[0], lanes.ray[k], distance)
            if clear < 1.0:
                for channel in range(3):
                    lanes.direct[k, channel] += (
                        lanes.weight[k] * (1.0 - clear) * fog_radiance(lights, lanes.ray[k], channel)
                    )
                lanes.weight[k] *= clear
        through[k] *= 1.0 - opacity
        if through[k] < 0.004:
            primary.valid[k] = 0
        else:
            primary.words[TNEAR + k] = distance + 1e-4 * distance + 0.02
            primary.words[TFAR + k] = FAR
            going = True
    return going


@inner
def _trace_pixels(
    pixels: NDArray[np.int64],
    width: int,
    height: int,
    first_sample: int,
    last_sample: int,
    view: ViewRays,
    scene: SceneTables,
    textures: Textures,
    lights: LightTables,
    patterns: Patterns,
    out: Buffers,
    scratch: Scratch,
) -> None:
    lanes, axes = scratch.lanes, view.axes
    pixel_size = 2.0 * math.sqrt(axes[2, 0] * axes[2, 0] + axes[2, 1] * axes[2, 1] + axes[2, 2] * axes[2, 2]) / width
    for first in range(0, len(pixels), LANES):
        count = min(LANES, len(pixels) - first)
        for k in range(LANES):
            lanes.open[k], lanes.covered[k], lanes.reached[k] = 0.0, 0.0, 0
            for channel in range(3):
                lanes.direct[k, channel], lanes.ambient[k, channel] = 0.0, 0.0
        for sample in range(first_sample, last_sample):
            _start_rays(
                scratch, count, pixels, first, view, width, height, patterns.pixel[sample, 0], patterns.pixel[sample, 1]
            )
            for layer in range(MAX_LAYERS):
                going = _next_layer(
                    scratch,
                    view,
                    scene,
                    textures,
                    lights,
                    out,
                    pixel_size,
                    patterns.blend[sample],
                    sample == 0,
                    layer == MAX_LAYERS - 1,
                )
                if view.lit:
                    shade(scratch, view, lights, patterns, sample)
                if not going:
                    break
        for k in range(count):
            pixel = scratch.pixel[k]
            out.samples[pixel] += last_sample - first_sample
            out.open[pixel, 0] += lanes.open[k]
            out.open[pixel, 1] += lanes.covered[k]
            if first_sample == 0:
                out.identity[pixel] = out.identity[pixel] * 4194304 + lanes.reached[k]
            for channel in range(3):
                out.direct[pixel, channel] += lanes.direct[k, channel]
                out.ambient[pixel, channel] += lanes.ambient[k, channel]


@kernel
def trace_pixels(
    pixels: NDArray[np.int64],
    width: int,
    height: int,
    first_sample: int,
    last_sample: int,
    view: ViewRays,
    scene: SceneTables,
    textures: Textures,
    lights: LightTables,
    patterns: Patterns,
    out: Buffers,
    scratch: Scratch,
) -> None:
    """Add samples ``first_sample`` to ``last_sample - 1`` of some pixels to ``out``."""
    _trace_pixels(
        pixels, width, height, first_sample, last_sample, view, scene, textures, lights, patterns, out, scratch
    )
