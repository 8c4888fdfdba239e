"""Lights as flat arrays, and what light does to a surface point (compiled).

Reflection is Lambert plus the GGX microfacet model (Walter et al. 2007, Schlick's Fresnel and masking terms).
Radiance is relative: the sun's irradiance sets the unit, exposure brings a picture into range.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from c4s.errors import BadInput
from c4s.render.compiled import inner
from c4s.render.layout import LANES
from c4s.render.types import Fog, Lights, LocalLight, Rgb

POSITION, POWER, RADIUS, AXIS, INNER_COS, OUTER_COS, SOURCE, ACROSS, UPWARDS, FALLOFF, SHADOWS, LOCAL_COLUMNS = (
    0,
    3,
    6,
    7,
    10,
    11,
    12,
    13,
    16,
    19,
    20,
    21,
)
DENSITY, HALVING, START, CUTOFF, LEAST, FOG_COLOR, GLOW, GLOW_EXPONENT, FOG_COLUMNS = 0, 1, 2, 3, 4, 5, 8, 11, 12
"""Columns of ``LightTables.fog``: exponents of 2 per cm, the least share of light that passes, radiances."""
_FOG_CM = 1000.0
_SKY_CM = 1e7
"""Distance of the sky behind fog."""
_CM2_PER_M2 = 10000.0


class LightTables(NamedTuple):
    """All lights of a scene, for the kernels; points are relative to the tables' origin."""

    to_sun: NDArray[np.float64]
    """(suns, 3)."""
    sun_disk: NDArray[np.float64]
    """(suns, 2, 3) tangents of a sun's disk at distance 1."""
    sun: NDArray[np.float64]
    """(suns, 3) irradiance."""
    sun_shadows: NDArray[np.int64]
    """1 for a sun that casts shadows."""
    sky: NDArray[np.float64]
    """(3, 3) radiance of zenith, horizon and ground."""
    sky_light: NDArray[np.float64]
    """Share of the sky's radiance that lights surfaces, by channel."""
    fog: NDArray[np.float64]
    """FOG_COLUMNS numbers; ``density`` 0 without fog. Its height is relative to the origin's."""
    fog_height: float
    ambient: NDArray[np.float64]
    fill: float
    local: NDArray[np.float64]
    """(lights, LOCAL_COLUMNS)."""
    occlusion_cm: float


class Lanes(NamedTuple):
    """State of the pixels of a packet while one layer of one sample is shaded."""

    point: NDArray[np.float64]
    """A point just off the surface, where secondary rays start."""
    normal: NDArray[np.float64]
    """Shading normal towards the viewer."""
    facing: NDArray[np.float64]
    """Geometric normal towards the viewer."""
    ray: NDArray[np.float64]
    """Unit direction from the eye."""
    albedo: NDArray[np.float64]
    emissive: NDArray[np.float64]
    roughness: NDArray[np.float64]
    metallic: NDArray[np.float64]
    weight: NDArray[np.float64]
    """Share of the pixel's light that comes from this layer; 0 where there is none."""
    direct: NDArray[np.float64]
    ambient: NDArray[np.float64]
    open: NDArray[np.float64]
    """Sum of weight times unoccluded share of the hemisphere."""
    covered: NDArray[np.float64]
    """Sum of weights."""
    surface: NDArray[np.int64]
    """A number for the instance and slot that was hit."""
    clear: NDArray[np.int64]
    """1 for a translucent surface, which takes no ambient occlusion: behind it may be nothing to smooth it over."""
    texel: NDArray[np.float64]
    """(LANES, 4) a texture's value."""
    reached: NDArray[np.int64]
    """A sum of numbers of the lights that arrived."""


def new_lanes() -> Lanes:
    """State of a packet, all zero."""
    return Lanes(
        np.zeros((LANES, 3)),
        np.zeros((LANES, 3)),
        np.zeros((LANES, 3)),
        np.zeros((LANES, 3)),
        np.zeros((LANES, 3)),
        np.zeros((LANES, 3)),
        np.zeros(LANES),
        np.zeros(LANES),
        np.zeros(LANES),
        np.zeros((LANES, 3)),
        np.zeros((LANES, 3)),
        np.zeros(LANES),
        np.zeros(LANES),
        np.zeros(LANES, dtype=np.int64),
        np.zeros(LANES, dtype=np.int64),
        np.zeros((LANES, 4)),
        np.zeros(LANES, dtype=np.int64),
    )


def _unit(vector: tuple[float, float, float]) -> NDArray[np.float64]:
    array = np.asarray(vector, dtype=np.float64)
    length = float(np.linalg.norm(array))
    return array / length if length > 1e-12 else np.array([0.0, 0.0, -1.0])


def _tangents(axis: NDArray[np.float64]) -> NDArray[np.float64]:
    helper = np.array([0.0, 0.0, 1.0]) if abs(axis[2]) < 0.9 else np.array([1.0, 0.0, 0.0])
    first = np.cross(axis, helper)
    first /= np.linalg.norm(first)
    return np.stack([first, np.cross(axis, first)])


def _local_row(light: LocalLight, origin: NDArray[np.float64]) -> list[float]:
    outer = min(max(light.outer_cone_deg, 0.5), 180.0)
    inner_cone = min(max(light.inner_cone_deg, 0.0), outer)
    unit = 1.0 if light.falloff_exponent > 0 else _CM2_PER_M2
    return [
        *(np.asarray(light.position) - origin),
        *(c * light.intensity_cd * unit for c in light.color),
        max(light.attenuation_radius, 1.0),
        *_unit(light.direction),
        math.cos(math.radians(inner_cone)),
        math.cos(math.radians(outer)),
        max(light.source_radius, 0.0),
        *light.across,
        *light.upwards,
        max(light.falloff_exponent, 0.0),
        float(light.casts_shadows),
    ]


def _fog_row(fog: Fog | None) -> list[float]:
    if fog is None:
        return [0.0] * FOG_COLUMNS
    return [
        max(fog.density, 0.0) / _FOG_CM,
        max(fog.falloff, 0.0) / _FOG_CM,
        max(fog.start_cm, 0.0),
        max(fog.cutoff_cm, 0.0),
        1.0 - min(max(fog.max_opacity, 0.0), 1.0),
        *fog.color,
        *fog.glow,
        max(fog.glow_exponent, 0.0),
    ]


def light_tables(lights: Lights, origin: NDArray[np.float64]) -> LightTables:
    """The lights' tables with positions relative to ``origin`` (cm).

    Raises:
        BadInput: a number that is not finite.
    """
    suns = [*([lights.sun] if lights.sun is not None else []), *lights.other_suns]
    to_sun = [-_unit(sun.direction) for sun in suns]
    disks = [
        _tangents(towards) * math.tan(math.radians(min(max(sun.angle_deg, 0.0), 90.0) / 2))
        for towards, sun in zip(to_sun, suns, strict=True)
    ]
    sky = lights.sky

    def radiance(color: Rgb) -> list[float]:
        return [c * sky.intensity for c in color]

    rows = np.array([_local_row(light, origin) for light in lights.local], dtype=np.float64)
    tables = LightTables(
        to_sun=np.array(to_sun, dtype=np.float64).reshape(-1, 3),
        sun_disk=np.array(disks, dtype=np.float64).reshape(-1, 2, 3),
        sun=np.array([[c * sun.intensity for c in sun.color] for sun in suns], dtype=np.float64).reshape(-1, 3),
        sun_shadows=np.array([sun.casts_shadows for sun in suns], dtype=np.int64),
        sky=np.array([radiance(sky.zenith), radiance(sky.horizon), radiance(sky.ground)], dtype=np.float64),
        sky_light=np.array(sky.light_color, dtype=np.float64) * sky.light,
        fog=np.array(_fog_row(lights.fog), dtype=np.float64),
        fog_height=float((lights.fog.height_cm if lights.fog is not None else 0.0) - origin[2]),
        ambient=np.array(lights.ambient, dtype=np.float64),
        fill=float(lights.camera_fill),
        local=rows.reshape(-1, LOCAL_COLUMNS),
        occlusion_cm=max(float(lights.ambient_occlusion_cm), 1.0),
    )
    if not all(np.isfinite(part).all() for part in tables):
        raise BadInput("a light has a value that is not finite", where="renderer")
    return tables


@inner
def sky_radiance(sky: NDArray[np.float64], height: float, channel: int) -> float:
    """Sky in a direction whose Z component is ``height``."""
    horizon = float(sky[1, channel])
    if height >= 0.0:
        return horizon + (float(sky[0, channel]) - horizon) * math.sqrt(min(height, 1.0))
    return horizon + (float(sky[2, channel]) - horizon) * min(1.0, -height * 6.0)


@inner
def fog_passes(lights: LightTables, eye: NDArray[np.float64], ray: NDArray[np.float64], distance: float) -> float:
    """Share of the light that passes the fog between the eye and a point ``distance`` cm along a unit ray."""
    fog = lights.fog
    if fog[DENSITY] <= 0.0 or (fog[CUTOFF] > 0.0 and distance > fog[CUTOFF]):
        return 1.0
    length = min(distance, _SKY_CM) - fog[START]
    if length <= 0.0:
        return 1.0
    low = eye[2] + ray[2] * fog[START] - lights.fog_height
    at_eye = fog[DENSITY] * 2.0 ** min(max(-fog[HALVING] * low, -60.0), 60.0)
    fall = min(max(fog[HALVING] * ray[2] * length, -60.0), 60.0)
    mean = (1.0 - 2.0**-fall) / fall if abs(fall) > 1e-4 else math.log(2.0)
    return float(max(2.0 ** max(-at_eye * length * mean, -60.0), fog[LEAST]))


@inner
def fog_radiance(lights: LightTables, ray: NDArray[np.float64], channel: int) -> float:
    """Radiance of dense fog along a ray."""
    fog = lights.fog
    found = fog[FOG_COLOR + channel]
    if len(lights.to_sun) > 0 and fog[GLOW + channel] > 0.0:
        sun = lights.to_sun[0]
        along = max(ray[0] * sun[0] + ray[1] * sun[1] + ray[2] * sun[2], 0.0)
        found += fog[GLOW + channel] * along ** fog[GLOW_EXPONENT]
    return float(found)


@inner
def add_light(lanes: Lanes, k: int, x: float, y: float, z: float, red: float, green: float, blue: float) -> None:
    """Add light that arrives at lane ``k`` from the unit direction (x, y, z) with the given irradiance."""
    normal, view = lanes.normal[k], lanes.ray[k]
    towards = normal[0] * x + normal[1] * y + normal[2] * z
    if towards <= 0.0:
        return
    hx, hy, hz = x - view[0], y - view[1], z - view[2]
    length = 1.0 / math.sqrt(max(hx * hx + hy * hy + hz * hz, 1e-12))
    normal_half = (normal[0] * hx + normal[1] * hy + normal[2] * hz) * length
    view_half = max(0.0, -(view[0] * hx + view[1] * hy + view[2] * hz) * length)
    normal_view = max(0.05, -(normal[0] * view[0] + normal[1] * view[1] + normal[2] * view[2]))
    rough = max(lanes.roughness[k], 0.2)
    a2 = rough * rough * rough * rough
    spread = normal_half * normal_half * (a2 - 1.0) + 1.0
    mask = (rough + 1.0) * (rough + 1.0) / 8.0
    lobe = (
        a2 / (math.pi * spread * spread) / (4.0 * (normal_view * (1.0 - mask) + mask) * (towards * (1.0 - mask) + mask))
    )
    fresnel = (1.0 - view_half) * (1.0 - view_half)
    fresnel = fresnel * fresnel * (1.0 - view_half)
    metal, strength = lanes.metallic[k], towards * lanes.weight[k]
    for channel in range(3):
        albedo = lanes.albedo[k, channel]
        base = 0.04 + (albedo - 0.04) * metal
        reflected = albedo * (1.0 - metal) / math.pi + lobe * (base + (1.0 - base) * fresnel)
        arriving = red if channel == 0 else (green if channel == 1 else blue)
        lanes.direct[k, channel] += strength * arriving * reflected


@inner
def add_surroundings(lanes: Lanes, k: int, lights: LightTables) -> None:
    """Add what lane ``k`` receives from the sky, the ambient light and the fill light, and what it sends out itself."""
    normal, view, weight = lanes.normal[k], lanes.ray[k], lanes.weight[k]
    along = normal[0] * view[0] + normal[1] * view[1] + normal[2] * view[2]
    up = 0.5 + 0.5 * normal[2]
    mirrored = view[2] - 2.0 * along * normal[2]
    rough, metal = lanes.roughness[k], lanes.metallic[k]
    blurred = mirrored * (1.0 - rough) + normal[2] * rough
    grazing = 1.0 - max(0.0, -along)
    grazing = grazing * grazing * grazing * grazing * grazing
    for channel in range(3):
        albedo = lanes.albedo[k, channel]
        above = 0.5 * (lights.sky[0, channel] + lights.sky[1, channel])
        below = lights.sky[2, channel]
        diffuse = lights.sky_light[channel] * (below + (above - below) * up) + lights.ambient[channel]
        seen = lights.sky_light[channel] * sky_radiance(lights.sky, blurred, channel) + lights.ambient[channel]
        base = 0.04 + (albedo - 0.04) * metal
        mirror = base + (max(1.0 - rough, base) - base) * grazing
        lanes.ambient[k, channel] += weight * (albedo * (1.0 - metal) * diffuse + mirror * seen * (1.0 - 0.5 * rough))
        lanes.direct[k, channel] += weight * (
            lanes.emissive[k, channel] + albedo * max(0.0, -along) * lights.fill / math.pi
        )
