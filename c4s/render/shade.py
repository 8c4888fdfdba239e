"""Light at the points of a packet: sun, local lights and ambient occlusion, each with its rays (compiled)."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from c4s.render import lighting as li
from c4s.render.compiled import inner
from c4s.render.layout import LANES, OPAQUE_MASK, TFAR
from c4s.render.lighting import Lanes, LightTables, add_light, add_surroundings
from c4s.render.packets import FAR, Packet, Scratch, ViewRays, aim, query
from c4s.render.sampling import Patterns


@inner
def _add_sun(
    shadow: Packet,
    lanes: Lanes,
    lights: LightTables,
    view: ViewRays,
    disk: NDArray[np.float64],
    cell: NDArray[np.int64],
    number: int,
) -> None:
    sun, tangents, power, any_lane = lights.to_sun[number], lights.sun_disk[number], lights.sun[number], False
    for k in range(LANES):
        shadow.valid[k] = 0
        if lanes.weight[k] == 0.0:
            continue
        facing = lanes.facing[k]
        a, b = disk[cell[k], 0], disk[cell[k], 1]
        x = sun[0] + tangents[0, 0] * a + tangents[1, 0] * b
        y = sun[1] + tangents[0, 1] * a + tangents[1, 1] * b
        z = sun[2] + tangents[0, 2] * a + tangents[1, 2] * b
        if facing[0] * x + facing[1] * y + facing[2] * z > 0.0:
            aim(shadow, k, lanes.point[k], 0.0, x, y, z, FAR, OPAQUE_MASK)
            any_lane = True
    if any_lane:
        if lights.sun_shadows[number] != 0:
            query(view.occluded, shadow.valid_address, view.scene, shadow.address)
        for k in range(LANES):
            if shadow.valid[k] != 0 and shadow.words[TFAR + k] >= 0.0:
                lanes.reached[k] += 1 + 4096 * number
                add_light(lanes, k, sun[0], sun[1], sun[2], power[0], power[1], power[2])


@inner
def _add_local(
    shadow: Packet,
    lanes: Lanes,
    light: NDArray[np.float64],
    view: ViewRays,
    disk: NDArray[np.float64],
    cell: NDArray[np.int64],
    arriving: NDArray[np.float64],
    bit: int,
) -> None:
    """Add one point or spot light; ``arriving`` is scratch of (LANES, 4): direction and irradiance factor."""
    any_lane = False
    radius, source = light[li.RADIUS], light[li.SOURCE]
    for k in range(LANES):
        shadow.valid[k] = 0
        if lanes.weight[k] == 0.0:
            continue
        point, facing = lanes.point[k], lanes.facing[k]
        x, y, z = light[0] - point[0], light[1] - point[1], light[2] - point[2]
        square = x * x + y * y + z * z
        if square >= radius * radius or facing[0] * x + facing[1] * y + facing[2] * z <= 0.0:
            continue
        distance = math.sqrt(max(square, 1.0))
        x, y, z = x / distance, y / distance, z / distance
        fade = square / (radius * radius)
        fade = 1.0 - fade * fade
        if light[li.FALLOFF] > 0.0:
            strength = (1.0 - square / (radius * radius)) ** light[li.FALLOFF]
        else:
            strength = fade * fade / max(square, max(25.0, source * source))
        if light[li.OUTER_COS] > -0.9999:
            along = -(x * light[li.AXIS] + y * light[li.AXIS + 1] + z * light[li.AXIS + 2])
            edge = (along - light[li.OUTER_COS]) / max(light[li.INNER_COS] - light[li.OUTER_COS], 1e-4)
            edge = min(max(edge, 0.0), 1.0)
            strength *= edge * edge
        wide = light[li.ACROSS] != 0.0 or light[li.ACROSS + 1] != 0.0 or light[li.ACROSS + 2] != 0.0
        if wide:
            strength *= max(0.0, -(x * light[li.AXIS] + y * light[li.AXIS + 1] + z * light[li.AXIS + 2]))
        if strength <= 0.0:
            continue
        arriving[k, 0], arriving[k, 1], arriving[k, 2], arriving[k, 3] = x, y, z, strength
        spread = source / distance
        sx, sy, sz = x + disk[cell[k], 0] * spread * (1.0 - x * x), y + disk[cell[k], 1] * spread * (1.0 - y * y), z
        if wide:
            da, db = disk[cell[k], 0] / distance, disk[cell[k], 1] / distance
            sx = x + light[li.ACROSS] * da + light[li.UPWARDS] * db
            sy = y + light[li.ACROSS + 1] * da + light[li.UPWARDS + 1] * db
            sz = z + light[li.ACROSS + 2] * da + light[li.UPWARDS + 2] * db
        aim(shadow, k, point, 0.0, sx, sy, sz, max(distance - source - 1.0, 0.0), OPAQUE_MASK)
        any_lane = True
    if any_lane:
        if light[li.SHADOWS] > 0.0:
            query(view.occluded, shadow.valid_address, view.scene, shadow.address)
        for k in range(LANES):
            if shadow.valid[k] != 0 and shadow.words[TFAR + k] >= 0.0:
                lanes.reached[k] += bit
                power = arriving[k, 3]
                add_light(
                    lanes,
                    k,
                    arriving[k, 0],
                    arriving[k, 1],
                    arriving[k, 2],
                    light[li.POWER] * power,
                    light[li.POWER + 1] * power,
                    light[li.POWER + 2] * power,
                )


@inner
def _add_occlusion(
    shadow: Packet, lanes: Lanes, view: ViewRays, directions: NDArray[np.float64], cell: NDArray[np.int64], reach: float
) -> None:
    for k in range(LANES):
        shadow.valid[k] = 0
        if lanes.weight[k] == 0.0:
            continue
        if lanes.clear[k] != 0:
            lanes.covered[k] += lanes.weight[k]
            lanes.open[k] += lanes.weight[k]
            continue
        n0, n1, n2 = lanes.facing[k]
        sign = 1.0 if n2 >= 0.0 else -1.0
        a = -1.0 / (sign + n2)
        b = n0 * n1 * a
        spot = cell[k]
        cx, cy, cz = directions[spot, 0], directions[spot, 1], directions[spot, 2]
        x = (1.0 + sign * n0 * n0 * a) * cx + b * cy + n0 * cz
        y = sign * b * cx + (sign + n1 * n1 * a) * cy + n1 * cz
        z = -sign * n0 * cx - n1 * cy + n2 * cz
        aim(shadow, k, lanes.point[k], 0.0, x, y, z, reach * directions[spot, 3], OPAQUE_MASK)
    query(view.occluded, shadow.valid_address, view.scene, shadow.address)
    for k in range(LANES):
        if shadow.valid[k] != 0:
            lanes.covered[k] += lanes.weight[k]
            if shadow.words[TFAR + k] >= 0.0:
                lanes.open[k] += lanes.weight[k]


@inner
def shade(scratch: Scratch, view: ViewRays, lights: LightTables, patterns: Patterns, sample: int) -> None:
    """Light all lanes of one layer."""
    shadow, lanes, cell = scratch.shadow, scratch.lanes, scratch.cell
    for k in range(LANES):
        if lanes.weight[k] != 0.0:
            add_surroundings(lanes, k, lights)
    for number in range(len(lights.sun)):
        if lights.sun[number, 0] + lights.sun[number, 1] + lights.sun[number, 2] > 0.0:
            _add_sun(shadow, lanes, lights, view, patterns.disk[sample], cell, number)
    for number in range(len(lights.local)):
        _add_local(
            shadow, lanes, lights.local[number], view, patterns.disk[sample], cell, scratch.arriving, 2 << (number % 20)
        )
    rays = patterns.hemisphere.shape[1] if sample == 0 else 1
    for number in range(rays):
        _add_occlusion(shadow, lanes, view, patterns.hemisphere[sample, number], cell, lights.occlusion_cm)
