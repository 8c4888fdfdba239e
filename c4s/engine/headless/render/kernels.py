"""The compiled core: rays for a band of tiles, what they hit, and the light there.

A tile is 4x4 pixels, one a lane of Embree's 16-ray packets. Translucent surfaces are layers: the ray goes on behind
them with what they let through. Everything is scalar code in a fixed order, so a scene gives the same bytes whatever
the number of threads.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
from llvmlite import ir
from numba import types as nb_types
from numba.extending import intrinsic
from numpy.typing import NDArray

from c4s.engine.headless.render import lighting as li
from c4s.engine.headless.render.compiled import inner, kernel
from c4s.engine.headless.render.layout import (
    DIRECTION,
    FLAGS,
    GEOMETRY,
    HIT_U,
    HIT_V,
    INSTANCE,
    LANES,
    NORMAL,
    OPAQUE_MASK,
    ORIGIN,
    PRIMITIVE,
    RAY_ID,
    RAY_MASK,
    RAY_WORDS,
    RAYHIT_WORDS,
    TFAR,
    TIME,
    TNEAR,
)
from c4s.engine.headless.render.lighting import Lanes, LightTables, add_light, add_surroundings, new_lanes, sky_radiance
from c4s.engine.headless.render.tables import BASE, EMISSIVE, METALLIC, OPACITY, ROUGHNESS, SceneTables
from c4s.engine.headless.render.textures import Textures

MAX_LAYERS = 6
"""Translucent surfaces seen through before the next one is drawn as opaque."""
_FAR = 1e30


class Patterns(NamedTuple):
    """Sample patterns (``sampling``)."""

    pixel: NDArray[np.float64]
    disk: NDArray[np.float64]
    hemisphere: NDArray[np.float64]


class View(NamedTuple):
    """The camera (eye, forward, and right and up scaled to half the picture) and Embree's entry points."""

    axes: NDArray[np.float64]
    intersect: np.uintp
    occluded: np.uintp
    scene: np.uintp
    lit: bool


class Buffers(NamedTuple):
    """What the kernels write, one entry a pixel."""

    direct: NDArray[np.float32]
    ambient: NDArray[np.float32]
    open: NDArray[np.float32]
    normal: NDArray[np.float32]
    point: NDArray[np.float32]
    actor: NDArray[np.int32]
    depth: NDArray[np.float32]


class Packet(NamedTuple):
    """Sixteen rays: the words as floats and as integers, the valid lanes, and the addresses of both."""

    words: NDArray[np.float32]
    numbers: NDArray[np.int32]
    valid: NDArray[np.int32]
    address: np.uintp
    valid_address: np.uintp


@intrinsic  # type: ignore[untyped-decorator]
def _query(typing_context: Any, function: Any, valid: Any, scene: Any, rays: Any) -> Any:
    """Call an Embree packet query by address, so that the compiled code holds no address and can be kept."""

    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        word = ir.IntType(64)
        pointer = builder.inttoptr(arguments[0], ir.FunctionType(ir.VoidType(), [word] * 4).as_pointer())
        builder.call(pointer, [*arguments[1:], ir.Constant(word, 0)])
        return context.get_dummy_value()

    return nb_types.void(nb_types.uintp, nb_types.uintp, nb_types.uintp, nb_types.uintp), generate


@inner
def _new_packet(words: int) -> Packet:
    raw = np.zeros(words + 16, np.float32)
    start = (64 - (raw.ctypes.data & 63) & 63) // 4
    aligned = raw[start:start + words]
    raw_valid = np.zeros(LANES + 16, np.int32)
    start = (64 - (raw_valid.ctypes.data & 63) & 63) // 4
    valid = raw_valid[start:start + LANES]
    return Packet(aligned, aligned.view(np.int32), valid, np.uintp(aligned.ctypes.data),
                  np.uintp(valid.ctypes.data))


@inner
def _aim(packet: Packet, k: int, point: NDArray[np.float64], near: float, x: float, y: float, z: float,
         far: float, mask: int) -> None:
    words, numbers = packet.words, packet.numbers
    words[ORIGIN + k], words[ORIGIN + LANES + k], words[ORIGIN + 2 * LANES + k] = point[0], point[1], point[2]
    words[TNEAR + k], words[TIME + k], words[TFAR + k] = near, 0.0, far
    words[DIRECTION + k], words[DIRECTION + LANES + k], words[DIRECTION + 2 * LANES + k] = x, y, z
    numbers[RAY_MASK + k], numbers[RAY_ID + k], numbers[FLAGS + k] = mask, 0, 0
    packet.valid[k] = -1


@inner
def _texel(textures: Textures, texture: int, u: float, v: float, footprint: float, blend: float,
           color: NDArray[np.float64]) -> None:
    """Multiply ``color`` by the bilinear texture value; the level rounds by ``blend``, which differs by sample."""
    level = 0
    if footprint > 1.0:
        level = min(int(math.log2(footprint) + blend), textures.level_counts[texture] - 1)
    first, width, height = textures.levels[texture, level]
    x = (u - math.floor(u)) * width - 0.5
    y = (v - math.floor(v)) * height - 0.5
    left, top = int(math.floor(x)), int(math.floor(y))
    fx, fy = x - left, y - top
    x0, x1 = left % width, (left + 1) % width
    y0, y1 = top % height, (top + 1) % height
    for channel in range(3):
        a = textures.decode[textures.texels[first + y0 * width + x0, channel]]
        b = textures.decode[textures.texels[first + y0 * width + x1, channel]]
        c = textures.decode[textures.texels[first + y1 * width + x0, channel]]
        d = textures.decode[textures.texels[first + y1 * width + x1, channel]]
        color[channel] *= (a * (1.0 - fx) + b * fx) * (1.0 - fy) + (c * (1.0 - fx) + d * fx) * fy


@inner
def _read_hit(packet: Packet, k: int, lanes: Lanes, scene: SceneTables, textures: Textures, pixel_size: float,
              blend: float) -> float:
    """Fill lane ``k`` with the surface that its ray hit; its opacity is returned."""
    words = packet.words
    hit = packet.numbers[INSTANCE + k]
    face = scene.first_face[hit] + packet.numbers[PRIMITIVE + k]
    a, b, c = scene.faces[face]
    u, v, t = words[HIT_U + k], words[HIT_V + k], words[TFAR + k]
    w = 1.0 - u - v
    turn, view, normal, facing = scene.normal_matrix[hit], lanes.ray[k], lanes.normal[k], lanes.facing[k]
    n0 = scene.normals[a, 0] * w + scene.normals[b, 0] * u + scene.normals[c, 0] * v
    n1 = scene.normals[a, 1] * w + scene.normals[b, 1] * u + scene.normals[c, 1] * v
    n2 = scene.normals[a, 2] * w + scene.normals[b, 2] * u + scene.normals[c, 2] * v
    g0, g1, g2 = words[NORMAL + k], words[NORMAL + LANES + k], words[NORMAL + 2 * LANES + k]
    for axis in range(3):
        normal[axis] = turn[axis, 0] * n0 + turn[axis, 1] * n1 + turn[axis, 2] * n2
        facing[axis] = turn[axis, 0] * g0 + turn[axis, 1] * g1 + turn[axis, 2] * g2
    length = 1.0 / max(math.sqrt(facing[0] * facing[0] + facing[1] * facing[1] + facing[2] * facing[2]), 1e-30)
    if facing[0] * view[0] + facing[1] * view[1] + facing[2] * view[2] > 0.0:
        length = -length
    for axis in range(3):
        facing[axis] *= length
    length = math.sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2])
    agree = normal[0] * facing[0] + normal[1] * facing[1] + normal[2] * facing[2]
    lift = 1e-4 * t + 0.02
    for axis in range(3):
        if length < 1e-12:
            normal[axis] = facing[axis]
        else:
            normal[axis] *= 1.0 / length if agree >= 0.0 else -1.0 / length
        lanes.point[k, axis] = words[ORIGIN + axis * LANES + k] + view[axis] * t + facing[axis] * lift
    material = scene.materials[scene.first_material[hit] + scene.face_slot[face]]
    surface, albedo = scene.surfaces[material], lanes.albedo[k]
    for channel in range(3):
        albedo[channel] = surface[BASE + channel]
        lanes.emissive[k, channel] = surface[EMISSIVE + channel]
    lanes.roughness[k], lanes.metallic[k] = surface[ROUGHNESS], surface[METALLIC]
    texture = scene.surface_texture[material]
    if texture >= 0:
        tu = scene.uvs[a, 0] * w + scene.uvs[b, 0] * u + scene.uvs[c, 0] * v
        tv = scene.uvs[a, 1] * w + scene.uvs[b, 1] * u + scene.uvs[c, 1] * v
        slope = max(-(facing[0] * view[0] + facing[1] * view[1] + facing[2] * view[2]), 0.06)
        size = math.sqrt(float(textures.levels[texture, 0, 1] * textures.levels[texture, 0, 2]))
        _texel(textures, texture, tu, tv, t * pixel_size * scene.texel_rate[hit] * size / math.sqrt(slope), blend,
               albedo)
    return surface[OPACITY]


@inner
def _add_sun(shadow: Packet, lanes: Lanes, lights: LightTables, view: View, disk: NDArray[np.float64]) -> None:
    sun, any_lane = lights.to_sun, False
    for k in range(LANES):
        shadow.valid[k] = 0
        if lanes.weight[k] == 0.0:
            continue
        facing = lanes.facing[k]
        a, b = disk[k, 0], disk[k, 1]
        x = sun[0] + lights.sun_disk[0, 0] * a + lights.sun_disk[1, 0] * b
        y = sun[1] + lights.sun_disk[0, 1] * a + lights.sun_disk[1, 1] * b
        z = sun[2] + lights.sun_disk[0, 2] * a + lights.sun_disk[1, 2] * b
        if facing[0] * x + facing[1] * y + facing[2] * z > 0.0:
            _aim(shadow, k, lanes.point[k], 0.0, x, y, z, _FAR, OPAQUE_MASK)
            any_lane = True
    if any_lane:
        _query(view.occluded, shadow.valid_address, view.scene, shadow.address)
        for k in range(LANES):
            if shadow.valid[k] != 0 and shadow.words[TFAR + k] >= 0.0:
                add_light(lanes, k, sun[0], sun[1], sun[2], lights.sun[0], lights.sun[1], lights.sun[2])


@inner
def _add_local(shadow: Packet, lanes: Lanes, light: NDArray[np.float64], share: float, view: View,
               disk: NDArray[np.float64], arriving: NDArray[np.float64]) -> None:
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
        strength = share * fade * fade / max(square, max(25.0, source * source))
        if light[li.OUTER_COS] > -0.9999:
            along = -(x * light[li.AXIS] + y * light[li.AXIS + 1] + z * light[li.AXIS + 2])
            edge = (along - light[li.OUTER_COS]) / max(light[li.INNER_COS] - light[li.OUTER_COS], 1e-4)
            edge = min(max(edge, 0.0), 1.0)
            strength *= edge * edge
        if strength <= 0.0:
            continue
        arriving[k, 0], arriving[k, 1], arriving[k, 2], arriving[k, 3] = x, y, z, strength
        spread = source / distance
        sx, sy, sz = x + disk[k, 0] * spread * (1.0 - x * x), y + disk[k, 1] * spread * (1.0 - y * y), z
        _aim(shadow, k, point, 0.0, sx, sy, sz, max(distance - source - 1.0, 0.0), OPAQUE_MASK)
        any_lane = True
    if any_lane:
        _query(view.occluded, shadow.valid_address, view.scene, shadow.address)
        for k in range(LANES):
            if shadow.valid[k] != 0 and shadow.words[TFAR + k] >= 0.0:
                power = arriving[k, 3]
                add_light(lanes, k, arriving[k, 0], arriving[k, 1], arriving[k, 2], light[li.POWER] * power,
                          light[li.POWER + 1] * power, light[li.POWER + 2] * power)


@inner
def _add_occlusion(shadow: Packet, lanes: Lanes, view: View, directions: NDArray[np.float64], reach: float) -> None:
    for k in range(LANES):
        shadow.valid[k] = 0
        if lanes.weight[k] == 0.0:
            continue
        n0, n1, n2 = lanes.facing[k]
        sign = 1.0 if n2 >= 0.0 else -1.0
        a = -1.0 / (sign + n2)
        b = n0 * n1 * a
        cx, cy, cz = directions[k, 0], directions[k, 1], directions[k, 2]
        x = (1.0 + sign * n0 * n0 * a) * cx + b * cy + n0 * cz
        y = sign * b * cx + (sign + n1 * n1 * a) * cy + n1 * cz
        z = -sign * n0 * cx - n1 * cy + n2 * cz
        _aim(shadow, k, lanes.point[k], 0.0, x, y, z, reach * directions[k, 3], OPAQUE_MASK)
    _query(view.occluded, shadow.valid_address, view.scene, shadow.address)
    for k in range(LANES):
        if shadow.valid[k] != 0:
            lanes.covered[k] += lanes.weight[k]
            if shadow.words[TFAR + k] >= 0.0:
                lanes.open[k] += lanes.weight[k]


@inner
def _shade(shadow: Packet, lanes: Lanes, view: View, lights: LightTables, patterns: Patterns, sample: int,
           arriving: NDArray[np.float64]) -> None:
    """Light all lanes of one layer."""
    samples, count = len(patterns.pixel), len(lights.local)
    for k in range(LANES):
        if lanes.weight[k] != 0.0:
            add_surroundings(lanes, k, lights)
    if lights.sun[0] + lights.sun[1] + lights.sun[2] > 0.0:
        _add_sun(shadow, lanes, lights, view, patterns.disk[sample])
    turns = min(samples, max(1, (count + 3) // 4))
    share = samples / ((samples - 1 - sample % turns) // turns * 1.0 + 1.0) if turns > 1 else 1.0
    for number in range(count):
        if turns == 1 or (number + sample) % turns == 0:
            _add_local(shadow, lanes, lights.local[number], share if turns > 1 else 1.0, view,
                       patterns.disk[sample], arriving)
    _add_occlusion(shadow, lanes, view, patterns.hemisphere[sample], lights.occlusion_cm)


@kernel
def trace_band(first_row: int, last_row: int, view: View, scene: SceneTables, textures: Textures, lights: LightTables,
               patterns: Patterns, out: Buffers) -> None:
    """Trace the rows of tiles ``first_row`` to ``last_row - 1`` into ``out``."""
    height, width = out.depth.shape
    eye, forward, right, up = view.axes[0], view.axes[1], view.axes[2], view.axes[3]
    samples = len(patterns.pixel)
    pixel_size = 2.0 * math.sqrt(right[0] * right[0] + right[1] * right[1] + right[2] * right[2]) / width
    primary, shadow, lanes = _new_packet(RAYHIT_WORDS), _new_packet(RAY_WORDS), new_lanes()
    through, arriving = np.zeros(LANES), np.zeros((LANES, 4))
    for tile_y in range(first_row, last_row):
        for tile_x in range((width + 3) // 4):
            lanes.direct[:] = 0.0
            lanes.ambient[:] = 0.0
            lanes.open[:] = 0.0
            lanes.covered[:] = 0.0
            for sample in range(samples):
                for k in range(LANES):
                    x, y = tile_x * 4 + (k & 3), tile_y * 4 + (k >> 2)
                    primary.valid[k] = 0
                    through[k] = 0.0
                    if x >= width or y >= height:
                        continue
                    sx = (x + patterns.pixel[sample, 0]) / width * 2.0 - 1.0
                    sy = 1.0 - (y + patterns.pixel[sample, 1]) / height * 2.0
                    ray = lanes.ray[k]
                    for axis in range(3):
                        ray[axis] = forward[axis] + right[axis] * sx + up[axis] * sy
                    scale = 1.0 / math.sqrt(ray[0] * ray[0] + ray[1] * ray[1] + ray[2] * ray[2])
                    for axis in range(3):
                        ray[axis] *= scale
                    _aim(primary, k, eye, 0.1, ray[0], ray[1], ray[2], _FAR, -1)
                    through[k] = 1.0
                    if sample == 0:
                        out.actor[y, x] = -1
                        out.depth[y, x] = np.inf
                        for axis in range(3):
                            out.normal[y, x, axis] = 0.0
                for layer in range(MAX_LAYERS):
                    for k in range(LANES):
                        primary.numbers[PRIMITIVE + k] = -1
                        primary.numbers[GEOMETRY + k] = -1
                        primary.numbers[INSTANCE + k] = -1
                    _query(view.intersect, primary.valid_address, view.scene, primary.address)
                    going = False
                    for k in range(LANES):
                        lanes.weight[k] = 0.0
                        if primary.valid[k] == 0:
                            continue
                        x, y = tile_x * 4 + (k & 3), tile_y * 4 + (k >> 2)
                        if primary.numbers[GEOMETRY + k] == -1:
                            if view.lit:
                                for channel in range(3):
                                    lanes.direct[k, channel] += through[k] * sky_radiance(
                                        lights.sky, lanes.ray[k, 2], channel)
                            primary.valid[k] = 0
                            continue
                        opacity = _read_hit(primary, k, lanes, scene, textures, pixel_size,
                                            (sample + 0.5) / samples)
                        distance = primary.words[TFAR + k]
                        if layer == MAX_LAYERS - 1:
                            opacity = 1.0
                        lanes.weight[k] = through[k] * opacity
                        if sample == 0 and out.actor[y, x] == -1 and opacity >= 0.5:
                            ray = lanes.ray[k]
                            out.actor[y, x] = scene.actor[primary.numbers[INSTANCE + k]]
                            out.depth[y, x] = distance * (
                                ray[0] * forward[0] + ray[1] * forward[1] + ray[2] * forward[2])
                            for axis in range(3):
                                out.normal[y, x, axis] = lanes.facing[k, axis]
                                out.point[y, x, axis] = lanes.point[k, axis]
                        if not view.lit:
                            for channel in range(3):
                                lanes.direct[k, channel] += lanes.weight[k] * lanes.albedo[k, channel]
                        through[k] *= 1.0 - opacity
                        if through[k] < 0.004:
                            primary.valid[k] = 0
                        else:
                            primary.words[TNEAR + k] = distance + 1e-4 * distance + 0.02
                            primary.words[TFAR + k] = _FAR
                            going = True
                    if view.lit:
                        _shade(shadow, lanes, view, lights, patterns, sample, arriving)
                    if not going:
                        break
            for k in range(LANES):
                x, y = tile_x * 4 + (k & 3), tile_y * 4 + (k >> 2)
                if x >= width or y >= height:
                    continue
                out.open[y, x] = lanes.open[k] / lanes.covered[k] if lanes.covered[k] > 0.0 else 1.0
                for channel in range(3):
                    out.direct[y, x, channel] = lanes.direct[k, channel] / samples
                    out.ambient[y, x, channel] = lanes.ambient[k, channel] / samples
