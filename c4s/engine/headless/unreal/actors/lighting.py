"""Lights, sky, air and fog."""

# ruff: noqa: RUF012  (each class declares its table of properties; no table is ever changed)

from __future__ import annotations

from c4s.engine.headless.unreal.actors.base import Actor, Info
from c4s.engine.headless.unreal.core import Prop, api, public
from c4s.engine.headless.unreal.lights import (
    DirectionalLightComponent,
    ExponentialHeightFogComponent,
    PointLightComponent,
    RectLightComponent,
    SkyAtmosphereComponent,
    SkyLightComponent,
    SpotLightComponent,
)


@public
class Light(Actor):
    """Base of lights."""

    _declares = {"light_component": Prop("LightComponent", get="_get_root", writable=False, saved=False)}

    @api
    def set_brightness(self, new_brightness: float) -> None:
        """Set the intensity."""
        self._root().set_intensity(new_brightness)

    @api
    def get_brightness(self) -> float:
        """The intensity."""
        return float(self._root().get_editor_property("intensity"))


@public
class DirectionalLight(Light):
    """A sun."""

    _parts = (("LightComponent0", DirectionalLightComponent),)


@public
class PointLight(Light):
    """A light in all directions."""

    _parts = (("LightComponent0", PointLightComponent),)
    _declares = {"point_light_component": Prop("PointLightComponent", get="_get_root", writable=False, saved=False)}


@public
class SpotLight(Light):
    """A cone of light."""

    _parts = (("LightComponent0", SpotLightComponent),)
    _declares = {"spot_light_component": Prop("SpotLightComponent", get="_get_root", writable=False, saved=False)}


@public
class RectLight(Light):
    """A shining rectangle."""

    _parts = (("LightComponent0", RectLightComponent),)
    _declares = {"rect_light_component": Prop("RectLightComponent", get="_get_root", writable=False, saved=False)}


@public
class SkyLight(Info):
    """Light of the sky."""

    _parts = (("SkyLightComponent0", SkyLightComponent),)
    _declares = {"light_component": Prop("SkyLightComponent", get="_get_root", writable=False, saved=False)}


@public
class SkyAtmosphere(Info):
    """The air."""

    _parts = (("SkyAtmosphereComponent", SkyAtmosphereComponent),)
    _declares = {"sky_atmosphere_component": Prop("SkyAtmosphereComponent", get="_get_root", writable=False,
                                                  saved=False)}


@public
class ExponentialHeightFog(Info):
    """Fog."""

    _parts = (("HeightFogComponent0", ExponentialHeightFogComponent),)
    _declares = {"component": Prop("ExponentialHeightFogComponent", get="_get_root", writable=False, saved=False)}
