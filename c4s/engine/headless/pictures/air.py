"""What a SkyAtmosphere does to the sun and the sky: both redden and dim as the sun sinks.

The air is flat and scatters once: Rayleigh, Mie and ozone extinction with Unreal's coefficients, air mass by Kasten and
Young (1989), sky radiance by the closed form for light scattered once on its way through a layer (Chandrasekhar 1960).
The renderer's own day sky belongs to a sun at ``_DAY_HEIGHT_DEG``; its colours are multiplied by what changes.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

from c4s.render import Sky, Sun
from c4s.render.types import Rgb

_DAY_HEIGHT_DEG = 50.0
_HORIZON_DEG = 3.0
"""Height of the part of the sky that stands for the horizon."""
_OZONE_KM = 15.0
"""The absorbing layer: a tent from 10 to 40 km."""
_LEAST = 1e-6


@dataclass(frozen=True)
class Air:
    """Vertical optical depths of the whole air by channel."""

    scatters: Rgb
    absorbs: Rgb
    luminance: Rgb
    """It multiplies the sky."""


def air_of(properties: Mapping[str, Any]) -> Air:
    """The air of a SkyAtmosphereComponent; coefficients are per km, heights in km."""

    def column(color: Any, scale: str, km: float) -> list[float]:
        share = max(float(properties[scale]), 0.0) * max(km, 0.0)
        return [max(float(channel), 0.0) * share for channel in (color.r, color.g, color.b)]

    mie_km = float(properties["mie_exponential_distribution"])
    rayleigh = column(
        properties["rayleigh_scattering"],
        "rayleigh_scattering_scale",
        float(properties["rayleigh_exponential_distribution"]),
    )
    mie = column(properties["mie_scattering"], "mie_scattering_scale", mie_km)
    haze = column(properties["mie_absorption"], "mie_absorption_scale", mie_km)
    ozone = column(properties["other_absorption"], "other_absorption_scale", _OZONE_KM)
    factor = properties["sky_luminance_factor"]
    return Air(
        (rayleigh[0] + mie[0], rayleigh[1] + mie[1], rayleigh[2] + mie[2]),
        (haze[0] + ozone[0], haze[1] + ozone[1], haze[2] + ozone[2]),
        (factor.r, factor.g, factor.b),
    )


def air_mass(height_deg: float) -> float:
    """Times the vertical way through the air, for a ray at a height of 0..90 degrees."""
    height = min(max(height_deg, 0.0), 90.0)
    return 1.0 / (math.sin(math.radians(height)) + 0.50572 * math.pow(height + 6.07995, -1.6364))


def _passes(air: Air, height_deg: float, channel: int) -> float:
    return math.exp(-(air.scatters[channel] + air.absorbs[channel]) * air_mass(height_deg))


def _scattered(air: Air, sun_deg: float, view_deg: float, channel: int) -> float:
    """Sky radiance at a height, up to a factor that the sun's height does not change."""
    depth, sun, view = air.scatters[channel], air_mass(sun_deg), air_mass(view_deg)
    if abs(sun - view) < 1e-3:
        once = depth * view * math.exp(-depth * view)
    else:
        once = view / (sun - view) * (math.exp(-depth * view) - math.exp(-depth * sun))
    return once * math.exp(-air.absorbs[channel] * sun)


def through_air(air: Air, sun: Sun, sky: Sky) -> tuple[Sun, Sky]:
    """The sun as it arrives, and the sky that it makes. A sun overhead has the strength that its light names."""
    x, y, z = sun.direction
    height = math.degrees(math.asin(min(max(-z / max(math.hypot(x, y, z), 1e-12), 0.0), 1.0)))

    def arrives(channel: int) -> float:
        return sun.color[channel] * _passes(air, height, channel) / _passes(air, 90.0, channel)

    def shines(color: Rgb, view_deg: float) -> Rgb:
        found = [
            color[channel]
            * air.luminance[channel]
            * _scattered(air, height, view_deg, channel)
            / max(_scattered(air, _DAY_HEIGHT_DEG, view_deg, channel), _LEAST)
            for channel in range(3)
        ]
        return found[0], found[1], found[2]

    return (
        replace(sun, color=(arrives(0), arrives(1), arrives(2))),
        replace(
            sky,
            zenith=shines(sky.zenith, 90.0),
            horizon=shines(sky.horizon, _HORIZON_DEG),
            ground=shines(sky.ground, _HORIZON_DEG),
        ),
    )
