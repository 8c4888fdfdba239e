"""What a ray hit: the surface's normal, colour and textures (compiled)."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from c4s.render.compiled import inner
from c4s.render.layout import HIT_U, HIT_V, INSTANCE, LANES, NORMAL, ORIGIN, PRIMITIVE, TFAR
from c4s.render.lighting import Lanes
from c4s.render.packets import Packet
from c4s.render.tables import (
    BASE,
    BLENDS,
    COLOR_MAP,
    EMISSIVE,
    EMISSIVE_MAP,
    METALLIC,
    NORMAL_MAP,
    OPACITY,
    ROUGHNESS,
    ROUGHNESS_METAL_MAP,
    SceneTables,
)
from c4s.render.textures import Textures


@inner
def texel(
    textures: Textures, texture: int, u: float, v: float, spread: float, blend: float, found: NDArray[np.float64]
) -> None:
    """Write the bilinear value of a texture, colour and alpha, to ``found``.

    ``spread`` is the share of the texture that a pixel covers; the level rounds by ``blend``, which differs by sample.
    """
    level = 0
    footprint = spread * math.sqrt(float(textures.levels[texture, 0, 1] * textures.levels[texture, 0, 2]))
    if footprint > 1.0:
        level = min(int(math.log2(min(footprint, 1e6)) + blend), textures.level_counts[texture] - 1)
    first, width, height = textures.levels[texture, level]
    x = (u - math.floor(u)) * width - 0.5
    y = (v - math.floor(v)) * height - 0.5
    left, top = math.floor(x), math.floor(y)
    fx, fy = x - left, y - top
    x0, x1 = left if left >= 0 else width - 1, left + 1 if left + 1 < width else 0
    y0, y1 = top if top >= 0 else height - 1, top + 1 if top + 1 < height else 0
    for channel in range(4):
        row = textures.coding[texture] if channel < 3 else 1
        a = textures.decode[row, textures.texels[first + y0 * width + x0, channel]]
        b = textures.decode[row, textures.texels[first + y0 * width + x1, channel]]
        c = textures.decode[row, textures.texels[first + y1 * width + x0, channel]]
        d = textures.decode[row, textures.texels[first + y1 * width + x1, channel]]
        found[channel] = (a * (1.0 - fx) + b * fx) * (1.0 - fy) + (c * (1.0 - fx) + d * fx) * fy


@inner
def _bend(
    scene: SceneTables, hit: int, a: int, b: int, c: int, bump: NDArray[np.float64], normal: NDArray[np.float64]
) -> None:
    """Turn ``normal`` as a normal texture's value ``bump`` (0 to 1) says; a face without coordinates stays flat."""
    u1, v1 = scene.uvs[b, 0] - scene.uvs[a, 0], scene.uvs[b, 1] - scene.uvs[a, 1]
    u2, v2 = scene.uvs[c, 0] - scene.uvs[a, 0], scene.uvs[c, 1] - scene.uvs[a, 1]
    area = u1 * v2 - u2 * v1
    if abs(area) < 1e-14:
        return
    points, turn = scene.points, scene.linear[hit]
    x = ((points[b, 0] - points[a, 0]) * v2 - (points[c, 0] - points[a, 0]) * v1) / area
    y = ((points[b, 1] - points[a, 1]) * v2 - (points[c, 1] - points[a, 1]) * v1) / area
    z = ((points[b, 2] - points[a, 2]) * v2 - (points[c, 2] - points[a, 2]) * v1) / area
    tx = turn[0, 0] * x + turn[0, 1] * y + turn[0, 2] * z
    ty = turn[1, 0] * x + turn[1, 1] * y + turn[1, 2] * z
    tz = turn[2, 0] * x + turn[2, 1] * y + turn[2, 2] * z
    x = ((points[c, 0] - points[a, 0]) * u1 - (points[b, 0] - points[a, 0]) * u2) / area
    y = ((points[c, 1] - points[a, 1]) * u1 - (points[b, 1] - points[a, 1]) * u2) / area
    z = ((points[c, 2] - points[a, 2]) * u1 - (points[b, 2] - points[a, 2]) * u2) / area
    bx = turn[0, 0] * x + turn[0, 1] * y + turn[0, 2] * z
    by = turn[1, 0] * x + turn[1, 1] * y + turn[1, 2] * z
    bz = turn[2, 0] * x + turn[2, 1] * y + turn[2, 2] * z
    along = 1.0 / max(math.sqrt(tx * tx + ty * ty + tz * tz), 1e-20) * (2.0 * bump[0] - 1.0)
    upwards = -1.0 / max(math.sqrt(bx * bx + by * by + bz * bz), 1e-20) * (2.0 * bump[1] - 1.0)
    out = max(2.0 * bump[2] - 1.0, 0.05)
    x = tx * along + bx * upwards + normal[0] * out
    y = ty * along + by * upwards + normal[1] * out
    z = tz * along + bz * upwards + normal[2] * out
    length = math.sqrt(x * x + y * y + z * z)
    if length > 1e-9:
        normal[0], normal[1], normal[2] = x / length, y / length, z / length


@inner
def _paint(
    scene: SceneTables,
    textures: Textures,
    lanes: Lanes,
    k: int,
    hit: int,
    material: int,
    a: int,
    b: int,
    c: int,
    u: float,
    v: float,
    spread: float,
    blend: float,
) -> float:
    """Apply the textures of a material to lane ``k``; the factor of its opacity is returned."""
    maps, w, found = scene.surface_maps[material], 1.0 - u - v, lanes.texel[k]
    tu = scene.uvs[a, 0] * w + scene.uvs[b, 0] * u + scene.uvs[c, 0] * v
    tv = scene.uvs[a, 1] * w + scene.uvs[b, 1] * u + scene.uvs[c, 1] * v
    opacity = 1.0
    if maps[COLOR_MAP] >= 0:
        texel(textures, maps[COLOR_MAP], tu, tv, spread, blend, found)
        for channel in range(3):
            lanes.albedo[k, channel] *= found[channel]
        if scene.surfaces[material, BLENDS] > 0.0:
            opacity = found[3]
    if maps[EMISSIVE_MAP] >= 0:
        texel(textures, maps[EMISSIVE_MAP], tu, tv, spread, blend, found)
        for channel in range(3):
            lanes.emissive[k, channel] *= found[channel]
    if maps[ROUGHNESS_METAL_MAP] >= 0:
        texel(textures, maps[ROUGHNESS_METAL_MAP], tu, tv, spread, blend, found)
        lanes.roughness[k] *= found[1]
        lanes.metallic[k] *= found[2]
    if maps[NORMAL_MAP] >= 0:
        texel(textures, maps[NORMAL_MAP], tu, tv, spread, blend, found)
        _bend(scene, hit, a, b, c, found, lanes.normal[k])
    return opacity


@inner
def read_hit(
    packet: Packet, k: int, lanes: Lanes, scene: SceneTables, textures: Textures, pixel_size: float, blend: float
) -> float:
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
    if len(scene.colors):
        for channel in range(3):
            albedo[channel] *= (
                scene.colors[a, channel] * w + scene.colors[b, channel] * u + scene.colors[c, channel] * v
            )
    lanes.roughness[k], lanes.metallic[k] = surface[ROUGHNESS], surface[METALLIC]
    slope = max(-(facing[0] * view[0] + facing[1] * view[1] + facing[2] * view[2]), 0.06)
    spread = t * pixel_size * scene.texel_rate[hit] / math.sqrt(slope)
    return float(surface[OPACITY]) * _paint(scene, textures, lanes, k, hit, material, a, b, c, u, v, spread, blend)
