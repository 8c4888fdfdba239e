"""Lights, sky, air and fog."""

# ruff: noqa: RUF012  (each class declares its table of properties; no table is ever changed)

from __future__ import annotations

from c4s.engine.headless.unreal.actors.base import Actor, Info
from c4s.engine.headless.unreal.core import Prop, api, public
from c4s.engine.headless.unreal.lights import (
    DirectionalLightComponent,
    ExponentialHeightFogComponent,
    LightComponent,
    PointLightComponent,
    RectLightComponent,
    SkyAtmosphereComponent,
    SkyLightComponent,
    SpotLightComponent,
)
from c4s.engine.headless.unreal.structs import LinearColor


@public
class Light(Actor):
    """Base of lights."""

    _declares = {"light_component": Prop("LightComponent", get="_get_root", writable=False, saved=False)}

    def _shining(self) -> LightComponent:
        root = self._root()
        assert isinstance(root, LightComponent)
        return root

    @api
    def set_brightness(self, new_brightness: float) -> None:
        """Set the intensity."""
        self._shining().set_intensity(new_brightness)

    @api
    def get_brightness(self) -> float:
        """The intensity."""
        return float(self._shining().get_editor_property("intensity"))

    @api
    def set_light_color(self, new_light_color: LinearColor) -> None:
        """Set the colour from linear numbers."""
        self._shining().set_light_color(new_light_color)

    @api
    def get_light_color(self) -> LinearColor:
        """Colour, sRGB decoded."""
        return self._shining().get_light_color()

    @api
    def set_cast_shadows(self, new_value: bool) -> None:
        """Set whether it casts shadows."""
        self._shining().set_cast_shadows(new_value)

    @api
    def set_enabled(self, set_enabled: bool) -> None:
        """Switch on or off."""
        self._shining().set_visibility(set_enabled)

    @api
    def is_enabled(self) -> bool:
        """Whether it is on."""
        return self._shining().is_visible()

    @api
    def toggle_enabled(self) -> None:
        """Switch."""
        self.set_enabled(not self.is_enabled())


@public
class DirectionalLight(Light):
    """A sun."""

    _parts = (("LightComponent0", DirectionalLightComponent),)
    _declares = {
        "directional_light_component": Prop(
            "DirectionalLightComponent", get="_get_root", attribute=False, writable=False, saved=False
        )
    }


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
    _declares = {
        "sky_atmosphere_component": Prop("SkyAtmosphereComponent", get="_get_root", writable=False, saved=False)
    }


@public
class ExponentialHeightFog(Info):
    """Fog."""

    _parts = (("HeightFogComponent0", ExponentialHeightFogComponent),)
    _declares = {"component": Prop("ExponentialHeightFogComponent", get="_get_root", writable=False, saved=False)}
