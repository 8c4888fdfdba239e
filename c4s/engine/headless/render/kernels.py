"""The compiled core: rays for a list of pixels, what they hit, and the light there.

Eight pixels are traced together, one a lane of Embree's packets. Translucent surfaces are layers: the ray goes on
behind them with what they let through. Everything is scalar code in a fixed order, so a scene gives the same bytes whatever
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
from c4s.engine.headless.render.embree import aligned_words
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
from c4s.engine.headless.render.sampling import Patterns
from c4s.engine.headless.render.tables import BASE, EMISSIVE, METALLIC, OPACITY, ROUGHNESS, SceneTables
from c4s.engine.headless.render.textures import Textures

MAX_LAYERS = 6
"""Translucent surfaces seen through before the next one is drawn as opaque."""
_FAR = 1e30


class View(NamedTuple):
    """The camera (eye, forward, and right and up scaled to half the picture) and Embree's entry points."""

    axes: NDArray[np.float64]
    intersect: np.uintp
    occluded: np.uintp
    scene: np.uintp
    lit: bool


class Buffers(NamedTuple):
    """What the kernels write, one row a pixel in reading order. Sums are over the samples of a pixel."""

    direct: NDArray[np.float32]
    """(n, 3) sum of the light that ambient occlusion leaves alone."""
    ambient: NDArray[np.float32]
    """(n, 3) sum of the light that it takes from."""
    open: NDArray[np.float32]
    """(n, 2): rays of ambient occlusion that got away, and all of them, by weight."""
    samples: NDArray[np.int32]
    normal: NDArray[np.float32]
    """(n, 3) geometric normal of the centre's surface; zero where nothing is seen."""
    point: NDArray[np.float32]
    """(n, 3) point of the centre's surface."""
    identity: NDArray[np.int64]
    """A number for the surfaces that the centre's ray met and the lights that reach them."""
    actor: NDArray[np.int32]
    depth: NDArray[np.float32]


class Packet(NamedTuple):
    """Eight rays: the words as floats and as integers, the valid lanes, and the addresses of both."""

    words: NDArray[np.float32]
    numbers: NDArray[np.int32]
    valid: NDArray[np.int32]
    address: np.uintp
    valid_address: np.uintp


class Scratch(NamedTuple):
    """What a band works in; each thread has its own."""

    primary: Packet
    shadow: Packet
    lanes: Lanes
    pixel: NDArray[np.int64]
    """Row of ``Buffers`` of each lane."""
    cell: NDArray[np.int64]
    """Place of each lane's pixel in its 4x4 tile."""
    through: NDArray[np.float64]
    """Share of each pixel's light that passes the layers met so far."""
    arriving: NDArray[np.float64]
    """(LANES, 4): direction to a local light, and its irradiance factor."""


@intrinsic  # type: ignore[untyped-decorator]
def _query(typing_context: Any, function: Any, valid: Any, scene: Any, rays: Any) -> Any:
    """Call an Embree packet query by address, so that the compiled code holds no address and can be kept."""

    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        word = ir.IntType(64)
        pointer = builder.inttoptr(arguments[0], ir.FunctionType(ir.VoidType(), [word] * 4).as_pointer())
        builder.call(pointer, [*arguments[1:], ir.Constant(word, 0)])
        return context.get_dummy_value()

    return nb_types.void(nb_types.uintp, nb_types.uintp, nb_types.uintp, nb_types.uintp), generate


def new_packet(words: int) -> Packet:
    """A packet without valid lanes."""
    rays, valid = aligned_words(words), aligned_words(LANES).view(np.int32)
    return Packet(rays, rays.view(np.int32), valid, np.uintp(rays.ctypes.data), np.uintp(valid.ctypes.data))


def new_scratch() -> Scratch:
    """Scratch for one band."""
    return Scratch(new_packet(RAYHIT_WORDS), new_packet(RAY_WORDS), new_lanes(),
                   np.zeros(LANES, dtype=np.int64), np.zeros(LANES, dtype=np.int64), np.zeros(LANES),
                   np.zeros((LANES, 4)))


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
    lanes.surface[k] = hit * 64 + scene.face_slot[face]
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
def _add_sun(shadow: Packet, lanes: Lanes, lights: LightTables, view: View, disk: NDArray[np.float64],
             cell: NDArray[np.int64]) -> None:
    sun, any_lane = lights.to_sun, False
    for k in range(LANES):
        shadow.valid[k] = 0
        if lanes.weight[k] == 0.0:
            continue
        facing = lanes.facing[k]
        a, b = disk[cell[k], 0], disk[cell[k], 1]
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
                lanes.reached[k] += 1
                add_light(lanes, k, sun[0], sun[1], sun[2], lights.sun[0], lights.sun[1], lights.sun[2])


@inner
def _add_local(shadow: Packet, lanes: Lanes, light: NDArray[np.float64], view: View,
               disk: NDArray[np.float64], cell: NDArray[np.int64], arriving: NDArray[np.float64], bit: int) -> None:
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
        strength = fade * fade / max(square, max(25.0, source * source))
        if light[li.OUTER_COS] > -0.9999:
            along = -(x * light[li.AXIS] + y * light[li.AXIS + 1] + z * light[li.AXIS + 2])
            edge = (along - light[li.OUTER_COS]) / max(light[li.INNER_COS] - light[li.OUTER_COS], 1e-4)
            edge = min(max(edge, 0.0), 1.0)
            strength *= edge * edge
        if strength <= 0.0:
            continue
        arriving[k, 0], arriving[k, 1], arriving[k, 2], arriving[k, 3] = x, y, z, strength
        spread = source / distance
        sx, sy, sz = x + disk[cell[k], 0] * spread * (1.0 - x * x), y + disk[cell[k], 1] * spread * (1.0 - y * y), z
        _aim(shadow, k, point, 0.0, sx, sy, sz, max(distance - source - 1.0, 0.0), OPAQUE_MASK)
        any_lane = True
    if any_lane:
        _query(view.occluded, shadow.valid_address, view.scene, shadow.address)
        for k in range(LANES):
            if shadow.valid[k] != 0 and shadow.words[TFAR + k] >= 0.0:
                lanes.reached[k] += bit
                power = arriving[k, 3]
                add_light(lanes, k, arriving[k, 0], arriving[k, 1], arriving[k, 2], light[li.POWER] * power,
                          light[li.POWER + 1] * power, light[li.POWER + 2] * power)


@inner
def _add_occlusion(shadow: Packet, lanes: Lanes, view: View, directions: NDArray[np.float64], cell: NDArray[np.int64],
                   reach: float) -> None:
    for k in range(LANES):
        shadow.valid[k] = 0
        if lanes.weight[k] == 0.0:
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
        _aim(shadow, k, lanes.point[k], 0.0, x, y, z, reach * directions[spot, 3], OPAQUE_MASK)
    _query(view.occluded, shadow.valid_address, view.scene, shadow.address)
    for k in range(LANES):
        if shadow.valid[k] != 0:
            lanes.covered[k] += lanes.weight[k]
            if shadow.words[TFAR + k] >= 0.0:
                lanes.open[k] += lanes.weight[k]


@inner
def _shade(scratch: Scratch, view: View, lights: LightTables, patterns: Patterns, sample: int) -> None:
    """Light all lanes of one layer. With many local lights the samples of a pixel take turns at them."""
    shadow, lanes, cell = scratch.shadow, scratch.lanes, scratch.cell
    for k in range(LANES):
        if lanes.weight[k] != 0.0:
            add_surroundings(lanes, k, lights)
    if lights.sun[0] + lights.sun[1] + lights.sun[2] > 0.0:
        _add_sun(shadow, lanes, lights, view, patterns.disk[sample], cell)
    for number in range(len(lights.local)):
        _add_local(shadow, lanes, lights.local[number], view, patterns.disk[sample], cell, scratch.arriving,
                   2 << (number % 20))
    rays = patterns.hemisphere.shape[1] if sample == 0 else 1
    for number in range(rays):
        _add_occlusion(shadow, lanes, view, patterns.hemisphere[sample, number], cell, lights.occlusion_cm)


@inner
def _start_rays(scratch: Scratch, count: int, pixels: NDArray[np.int64], first: int, view: View, width: int,
                height: int, offset_x: float, offset_y: float) -> None:
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
        _aim(primary, k, axes[0], 0.1, dx * scale, dy * scale, dz * scale, _FAR, -1)
        scratch.through[k] = 1.0


@inner
def _next_layer(scratch: Scratch, view: View, scene: SceneTables, textures: Textures, lights: LightTables,
                out: Buffers, pixel_size: float, blend: float, first_sample: bool, last_layer: bool) -> bool:
    """Find the next surface of every lane that is still going; whether any goes on behind it is returned."""
    primary, lanes, through = scratch.primary, scratch.lanes, scratch.through
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
        if primary.numbers[GEOMETRY + k] == -1:
            if view.lit:
                for channel in range(3):
                    lanes.direct[k, channel] += through[k] * sky_radiance(lights.sky, lanes.ray[k, 2], channel)
            primary.valid[k] = 0
            continue
        opacity = _read_hit(primary, k, lanes, scene, textures, pixel_size, blend)
        if last_layer:
            opacity = 1.0
        distance = primary.words[TFAR + k]
        lanes.weight[k] = through[k] * opacity
        pixel = scratch.pixel[k]
        if first_sample:
            out.identity[pixel] = out.identity[pixel] * 31 + lanes.surface[k] + 1
            if out.actor[pixel] == -1 and opacity >= 0.5:
                out.actor[pixel] = scene.actor[primary.numbers[INSTANCE + k]]
                out.depth[pixel] = distance * (lanes.ray[k, 0] * view.axes[1, 0] + lanes.ray[k, 1] * view.axes[1, 1]
                                               + lanes.ray[k, 2] * view.axes[1, 2])
                for axis in range(3):
                    out.normal[pixel, axis] = lanes.facing[k, axis]
                    out.point[pixel, axis] = lanes.point[k, axis]
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
    return going


@inner
def _trace_pixels(pixels: NDArray[np.int64], width: int, height: int, first_sample: int, last_sample: int, view: View,
                  scene: SceneTables, textures: Textures, lights: LightTables, patterns: Patterns, out: Buffers,
                  scratch: Scratch) -> None:
    lanes, axes = scratch.lanes, view.axes
    pixel_size = 2.0 * math.sqrt(axes[2, 0] * axes[2, 0] + axes[2, 1] * axes[2, 1] + axes[2, 2] * axes[2, 2]) / width
    for first in range(0, len(pixels), LANES):
        count = min(LANES, len(pixels) - first)
        for k in range(LANES):
            lanes.open[k], lanes.covered[k], lanes.reached[k] = 0.0, 0.0, 0
            for channel in range(3):
                lanes.direct[k, channel], lanes.ambient[k, channel] = 0.0, 0.0
        for sample in range(first_sample, last_sample):
            _start_rays(scratch, count, pixels, first, view, width, height, patterns.pixel[sample, 0],
                        patterns.pixel[sample, 1])
            for layer in range(MAX_LAYERS):
                going = _next_layer(scratch, view, scene, textures, lights, out, pixel_size, patterns.blend[sample],
                                    sample == 0, layer == MAX_LAYERS - 1)
                if view.lit:
                    _shade(scratch, view, lights, patterns, sample)
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
def trace_pixels(pixels: NDArray[np.int64], width: int, height: int, first_sample: int, last_sample: int, view: View,
                 scene: SceneTables, textures: Textures, lights: LightTables, patterns: Patterns, out: Buffers,
                 scratch: Scratch) -> None:
    """Add samples ``first_sample`` to ``last_sample - 1`` of some pixels to ``out``."""
    _trace_pixels(pixels, width, height, first_sample, last_sample, view, scene, textures, lights, patterns, out,
                  scratch)
