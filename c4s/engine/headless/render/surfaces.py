"""What a ray hit: the surface's normal, colour and texture (compiled)."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from c4s.engine.headless.render.compiled import inner
from c4s.engine.headless.render.layout import HIT_U, HIT_V, INSTANCE, LANES, NORMAL, ORIGIN, PRIMITIVE, TFAR
from c4s.engine.headless.render.lighting import Lanes
from c4s.engine.headless.render.packets import Packet
from c4s.engine.headless.render.tables import BASE, EMISSIVE, METALLIC, OPACITY, ROUGHNESS, SceneTables
from c4s.engine.headless.render.textures import Textures


@inner
def texel(textures: Textures, texture: int, u: float, v: float, footprint: float, blend: float,
           color: NDArray[np.float64]) -> None:
    """Multiply ``color`` by the bilinear texture value; the level rounds by ``blend``, which differs by sample."""
    level = 0
    if footprint > 1.0:
        level = min(int(math.log2(min(footprint, 1e6)) + blend), textures.level_counts[texture] - 1)
    first, width, height = textures.levels[texture, level]
    x = (u - math.floor(u)) * width - 0.5
    y = (v - math.floor(v)) * height - 0.5
    left, top = math.floor(x), math.floor(y)
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
def read_hit(packet: Packet, k: int, lanes: Lanes, scene: SceneTables, textures: Textures, pixel_size: float,
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
        texel(textures, texture, tu, tv, t * pixel_size * scene.texel_rate[hit] * size / math.sqrt(slope), blend,
               albedo)
    return float(surface[OPACITY])
