"""The level's own lights, fog and post-process for the renderer.

Intensities are Unreal's: lux for suns; candelas, lumens, EV or its unitless number for local lights. A level without
lights gets a clear day, so that it can be read; one with lights is lit by them alone, with a dim sky.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from c4s.engine.headless.pictures.air import Air, air_of, through_air
from c4s.geometry.transform import WORLD_CM
from c4s.render import Fog, Grade, Lights, LocalLight, Sky, Sun
from c4s.render.textures import decode_table
from c4s.render.types import Point, Rgb

if TYPE_CHECKING:
    from c4s.engine.headless.world.world import LightSource

_UNITLESS_PER_CANDELA = 625.0
_EV_OF_ONE_CANDELA = 3.0
_MAX_EV = 30.0
_BULB_CM = 4.0
_DIM_LIGHT = 0.25
_MIN_SUN_DEG = 0.3
_MIN_SKY = 0.05
_DAY_SUN = 4.0
"""Intensity of the sun that the default sky belongs to; the sky follows the level's sun."""
_KEY_STOP = math.log2(0.30)
_MANUAL_EV100 = math.log2(4.0**2 * 60.0)
"""The camera that Unreal's manual exposure assumes: f/4, 1/60 s, ISO 100."""
_DEFAULT_BIAS = 1.0
_NEUTRAL_K = 6500.0
_TINT = 0.05
_XYZ_OF_RGB = np.array(
    [[0.4124564, 0.3575761, 0.1804375], [0.2126729, 0.7151522, 0.0721750], [0.0193339, 0.1191920, 0.9503041]]
)
_BRADFORD = np.array([[0.8951, 0.2664, -0.1614], [-0.7502, 1.7135, 0.0367], [0.0389, -0.0685, 1.0296]])


def lights_of(sources: Sequence[LightSource]) -> Lights:
    """The lights of a level; the first directional light that shines down is the sun that the sky follows."""
    suns: list[Sun] = []
    local: list[LocalLight] = []
    sky: tuple[float, Rgb] | None = None
    fog: LightSource | None = None
    air: Air | None = None
    in_air: list[bool] = []
    shining = False
    for source in sources:
        if source.kind == "ExponentialHeightFogComponent":
            fog = fog or source
        elif source.kind == "SkyAtmosphereComponent":
            air = air or air_of(source.properties)
        if not source.properties.get("affects_world"):
            continue
        shining = True
        intensity = float(source.properties["intensity"])
        if source.kind == "SkyLightComponent":
            sky = (intensity, light_colour(source)) if sky is None or intensity > sky[0] else sky
        elif source.kind == "DirectionalLightComponent":
            direction = _axis(source, 0)
            if direction[2] < 0 and intensity > 0:
                suns.append(
                    Sun(
                        direction,
                        light_colour(source),
                        intensity,
                        max(_MIN_SUN_DEG, float(source.properties["light_source_angle"])),
                        bool(source.properties["cast_shadows"]),
                    )
                )
                in_air.append(bool(source.properties["atmosphere_sun_light"]))
        elif intensity > 0:
            local.append(_local(source))
    day = Sky()
    if not shining:
        return Lights(fog=_fog(fog, day))
    follows = suns[0].intensity / _DAY_SUN if suns else 1.0
    if sky is None:
        dome = Sky(intensity=follows, light=_DIM_LIGHT)
    else:
        dome = Sky(intensity=follows * max(sky[0], _MIN_SKY), light_color=sky[1])
    if air is not None and suns and in_air[0]:
        suns[0], dome = through_air(air, suns[0], dome)
    return Lights(
        sun=suns[0] if suns else None, other_suns=tuple(suns[1:]), sky=dome, local=tuple(local), fog=_fog(fog, dome)
    )


def _axis(source: LightSource, number: int) -> Point:
    rows = source.pose.axes()
    return rows[0][number], rows[1][number], rows[2][number]


def kelvin_rgb(kelvin: float) -> Rgb:
    """Linear RGB of a black body at luminance 1 (Krystek 1985), clamped to 1,000..15,000 K, without negative parts."""
    found = np.linalg.inv(_XYZ_OF_RGB) @ _white(kelvin, 0.0)
    return max(0.0, float(found[0])), max(0.0, float(found[1])), max(0.0, float(found[2]))


def _white(kelvin: float, tint: float) -> Any:
    """XYZ of a black body at luminance 1, moved by ``tint`` across the line of black bodies."""
    t = min(max(kelvin, 1000.0), 15000.0)

    def uv(t: float) -> tuple[float, float]:
        return (
            (0.860117757 + 1.54118254e-4 * t + 1.28641212e-7 * t * t) / (1 + 8.42420235e-4 * t + 7.08145163e-7 * t * t),
            (0.317398726 + 4.22806245e-5 * t + 4.20481691e-8 * t * t) / (1 - 2.89741816e-5 * t + 1.61456053e-7 * t * t),
        )

    (u, v), (near_u, near_v) = uv(t), uv(t + 1.0)
    along = math.hypot(near_u - u, near_v - v)
    u, v = u - tint * _TINT * (near_v - v) / along, v + tint * _TINT * (near_u - u) / along
    x, y = 3 * u / (2 * u - 8 * v + 4), 2 * v / (2 * u - 8 * v + 4)
    return np.array([x / y, 1.0, (1 - x - y) / y])


def light_colour(source: LightSource) -> Rgb:
    """Linear colour of a light, whose bytes are sRGB, times that of its temperature where it uses one."""
    colour = source.properties["light_color"]
    red, green, blue = (float(decode_table()[int(byte)]) for byte in (colour.r, colour.g, colour.b))
    if not source.properties.get("use_temperature"):
        return red, green, blue
    warm = kelvin_rgb(float(source.properties["temperature"]))
    return red * warm[0], green * warm[1], blue * warm[2]


def _source_radius(properties: Mapping[str, Any]) -> float:
    """In cm; a point has the size of a bulb."""
    return max(_BULB_CM, float(properties.get("source_radius", 0.0)))


def candela_of(source: LightSource) -> float:
    """Luminous intensity of a local light along its axis; nits are those of its source as it is seen from there."""
    properties = source.properties
    solid_angle, area_cm2 = 4 * math.pi, math.pi * _source_radius(properties) ** 2
    if source.kind == "SpotLightComponent":
        outer = min(max(float(properties["outer_cone_angle"]), 1.0), 89.0)
        solid_angle = 2 * math.pi * (1 - math.cos(math.radians(outer)))
    elif source.kind == "RectLightComponent":
        solid_angle, area_cm2 = math.pi, float(properties["source_width"]) * float(properties["source_height"])
    intensity, units = float(properties["intensity"]), str(properties["intensity_units"].name)
    return {
        "UNITLESS": intensity / _UNITLESS_PER_CANDELA,
        "LUMENS": intensity / solid_angle,
        "CANDELAS": intensity,
        "NITS": intensity * area_cm2 / 1e4,
        "EV": float(2.0 ** (min(intensity, _MAX_EV) - _EV_OF_ONE_CANDELA)),
    }[units]


def _local(source: LightSource) -> LocalLight:
    """A point, spot or rectangle light."""
    properties = source.properties
    inner, outer = 180.0, 180.0
    across: Point = (0.0, 0.0, 0.0)
    upwards: Point = (0.0, 0.0, 0.0)
    if source.kind == "SpotLightComponent":
        inner, outer = (float(properties[f"{part}_cone_angle"]) for part in ("inner", "outer"))
    elif source.kind == "RectLightComponent":
        wide, high = (float(properties[f"source_{side}"]) / 2 for side in ("width", "height"))
        right, up = _axis(source, 1), _axis(source, 2)
        across = (right[0] * wide, right[1] * wide, right[2] * wide)
        upwards = (up[0] * high, up[1] * high, up[2] * high)
    intensity, candela = float(properties["intensity"]), candela_of(source)
    by_exponent = not properties.get("use_inverse_squared_falloff", True)
    return LocalLight(
        source.pose.location,
        light_colour(source),
        intensity if by_exponent else candela,
        min(float(properties["attenuation_radius"]), WORLD_CM),
        _axis(source, 0),
        inner,
        outer,
        min(_source_radius(properties), WORLD_CM),
        across,
        upwards,
        float(properties["light_falloff_exponent"]) if by_exponent else 0.0,
        bool(properties["cast_shadows"]),
    )


def _fog(source: LightSource | None, sky: Sky) -> Fog | None:
    """The level's fog; one without a colour of its own takes the horizon's."""
    if source is None:
        return None
    properties = source.properties
    own = properties["fog_inscattering_luminance"]
    color: Rgb = (own.r, own.g, own.b)
    if max(color) <= 0:
        color = (sky.horizon[0] * sky.intensity, sky.horizon[1] * sky.intensity, sky.horizon[2] * sky.intensity)
    return Fog(
        float(properties["fog_density"]),
        float(properties["fog_height_falloff"]),
        float(source.pose.location[2]),
        color,
        float(properties["start_distance"]),
        float(properties["fog_cutoff_distance"]),
        float(properties["fog_max_opacity"]),
    )


def grade_at(sources: Sequence[LightSource], location_cm: Point) -> Grade:
    """The post-process of a camera: of the volumes that hold it or are unbound, by priority, each value that a volume
    overrides. A volume counts from a blend weight of one half; nothing is blended."""
    chosen: dict[str, Any] = {}
    volumes = [source for source in sources if source.kind == "PostProcessVolume"]
    for volume in sorted(volumes, key=lambda source: float(source.properties["priority"])):
        if float(volume.properties["blend_weight"]) >= 0.5 and _holds(volume, location_cm):
            chosen.update(overridden(volume.properties["settings"]))
    return grade_of(chosen)


def _holds(volume: LightSource, location_cm: Point) -> bool:
    if volume.properties["unbound"]:
        return True
    matrix = volume.pose.matrix()
    if np.linalg.det(matrix[:3, :3]) == 0:
        return False
    local = np.linalg.solve(matrix, np.array([*location_cm, 1.0]))[:3]
    return bool((np.abs(local) <= 100.0).all())


def overridden(settings: Any) -> dict[str, Any]:
    """The values of post-process settings whose ``override_`` flag is set."""
    flags = [name for name in settings._fields if name.startswith("override_") and settings.get_editor_property(name)]
    names = [flag.removeprefix("override_") for flag in flags]
    return {name: settings.get_editor_property(name) for name in names if name in settings._fields}


def grade_of(chosen: Mapping[str, Any]) -> Grade:
    """The grade of post-process values by name; brightness limits are EV at ISO 100."""
    bias = float(chosen.get("auto_exposure_bias", _DEFAULT_BIAS))
    fixed: float | None = None
    method = chosen.get("auto_exposure_method")
    if method is not None and method.name == "AEM_MANUAL":
        physical = chosen.get("auto_exposure_apply_physical_camera_exposure", True)
        fixed = _gain_of_ev100(_MANUAL_EV100 if physical else 0.0)

    def triple(name: str, default: float) -> Rgb:
        value = chosen.get(name)
        if value is None:
            return default, default, default
        if name == "color_offset":
            return value.x + value.w, value.y + value.w, value.z + value.w
        return value.x * value.w, value.y * value.w, value.z * value.w

    kelvin, tint = float(chosen.get("white_temp", _NEUTRAL_K)), float(chosen.get("white_tint", 0.0))
    plain = Grade()
    balance = plain.white_balance if kelvin == _NEUTRAL_K and tint == 0 else _balance(kelvin, tint)
    lowest, highest = -math.inf, math.inf
    if "auto_exposure_max_brightness" in chosen:
        lowest = _gain_of_ev100(float(chosen["auto_exposure_max_brightness"]))
    if "auto_exposure_min_brightness" in chosen:
        highest = _gain_of_ev100(float(chosen["auto_exposure_min_brightness"]))
    return Grade(
        fixed,
        min(lowest, highest),
        highest,
        bias - _DEFAULT_BIAS,
        balance,
        triple("color_saturation", 1.0),
        triple("color_contrast", 1.0),
        triple("color_gamma", 1.0),
        triple("color_gain", 1.0),
        triple("color_offset", 0.0),
    )


def _gain_of_ev100(ev100: float) -> float:
    """Exposure in the renderer's stops that Unreal gives a scene metered at this EV."""
    return _KEY_STOP + _EV_OF_ONE_CANDELA - ev100


def _balance(kelvin: float, tint: float) -> tuple[Rgb, Rgb, Rgb]:
    """Bradford adaptation that turns light of the given white into that of 6500 K, as rows for linear RGB."""
    source, target = _BRADFORD @ _white(kelvin, tint), _BRADFORD @ _white(_NEUTRAL_K, 0.0)
    adapt = np.linalg.inv(_BRADFORD) @ np.diag(target / source) @ _BRADFORD
    rows = (np.linalg.inv(_XYZ_OF_RGB) @ adapt @ _XYZ_OF_RGB).round(6).tolist()
    (a, b, c), (d, e, f), (g, h, i) = rows
    return (a, b, c), (d, e, f), (g, h, i)
