"""Light, sky, fog, camera and volume components, with the properties that the snapshot and the renderer read."""

# ruff: noqa: RUF012  (each class declares its table of properties; no table is ever changed)

from __future__ import annotations

from c4s.engine.headless.unreal.components import Bounds, PrimitiveComponent, SceneComponent
from c4s.engine.headless.unreal.core import Prop, api, public, with_setters
from c4s.engine.headless.unreal.enums import AutoExposureMethod, CollisionEnabled, ComponentMobility, LightUnits
from c4s.engine.headless.unreal.kept import KEPT
from c4s.engine.headless.unreal.setters import SETTERS
from c4s.engine.headless.unreal.structs import ClosedStruct, Color, Later, LinearColor, Vector4
from c4s.engine.headless.unreal.table import fields


@public
@with_setters(SETTERS["LightComponentBase"])
class LightComponentBase(SceneComponent):
    """What all lights have."""

    _declares = {
        **KEPT["LightComponentBase"],
        "intensity": Prop("float", 3.1415927),
        "light_color": Prop("Color", lambda: Color(255, 255, 255, 255)),
        "affects_world": Prop("bool", True),
        "cast_shadows": Prop("bool", True),
        "cast_static_shadows": Prop("bool", True),
        "cast_dynamic_shadows": Prop("bool", True),
        "indirect_lighting_intensity": Prop("float", 1.0),
        "volumetric_scattering_intensity": Prop("float", 1.0),
        "mobility": Prop("ComponentMobility", ComponentMobility.STATIONARY),
    }

    @api
    def set_cast_shadows(self, new_value: bool) -> None:
        """Set whether it casts shadows."""
        self.set_editor_property("cast_shadows", new_value)

    @api
    def get_light_color(self) -> LinearColor:
        """Colour, sRGB decoded."""
        colour = self.get_editor_property("light_color")

        def linear(value: int) -> float:
            v = value / 255
            return v / 12.92 if v <= 0.04045 else float(((v + 0.055) / 1.055) ** 2.4)

        return LinearColor(linear(colour.r), linear(colour.g), linear(colour.b), colour.a / 255)


@public
@with_setters(SETTERS["LightComponent"])
class LightComponent(LightComponentBase):
    """Directional and local lights."""

    _declares = {
        **KEPT["LightComponent"],
        "temperature": Prop("float", 6500.0),
        "use_temperature": Prop("bool", False),
        "specular_scale": Prop("float", 1.0),
        "cast_volumetric_shadow": Prop("bool", True),
    }

    @api
    def set_intensity(self, new_intensity: float) -> None:
        """Set the intensity in the light's units."""
        self.set_editor_property("intensity", new_intensity)

    @api
    def set_light_color(self, new_light_color: LinearColor, srgb: bool = True) -> None:
        """Set the colour from linear numbers, stored as bytes (sRGB encoded unless told otherwise)."""
        self.set_editor_property("light_color", new_light_color._bytes(bool(srgb)))

    @api
    def set_temperature(self, new_temperature: float) -> None:
        """Set the colour temperature in kelvin."""
        self.set_editor_property("temperature", new_temperature)

    @api
    def set_use_temperature(self, new_value: bool) -> None:
        """Set whether the temperature colours the light."""
        self.set_editor_property("use_temperature", new_value)

    @api
    def set_indirect_lighting_intensity(self, new_intensity: float) -> None:
        """Set the factor of bounced light."""
        self.set_editor_property("indirect_lighting_intensity", new_intensity)

    @api
    def set_volumetric_scattering_intensity(self, new_intensity: float) -> None:
        """Set the factor of scattering in fog."""
        self.set_editor_property("volumetric_scattering_intensity", new_intensity)

    @api
    def set_specular_scale(self, new_value: float) -> None:
        """Set the factor of highlights."""
        self.set_editor_property("specular_scale", new_value)


@public
@with_setters(SETTERS["DirectionalLightComponent"])
class DirectionalLightComponent(LightComponent):
    """A sun; it shines along its +X; intensity in lux."""

    _declares = {
        **KEPT["DirectionalLightComponent"],
        "intensity": Prop("float", 10.0),
        "light_source_angle": Prop("float", 0.5357),
        "atmosphere_sun_light": Prop("bool", True),
    }

    @api
    def set_atmosphere_sun_light(self, new_value: bool) -> None:
        """Set whether it is the sun of the sky."""
        self.set_editor_property("atmosphere_sun_light", new_value)

    @api
    def set_light_source_angle(self, new_value: float) -> None:
        """Set the angle of the disk in degrees."""
        self.set_editor_property("light_source_angle", new_value)


@public
class LocalLightComponent(LightComponent):
    """A light with a place and a reach."""

    _declares = {
        **KEPT["LocalLightComponent"],
        "intensity": Prop("float", 5000.0),
        "intensity_units": Prop("LightUnits", LightUnits.UNITLESS),
        "attenuation_radius": Prop("float", 1000.0),
    }

    @api
    def set_attenuation_radius(self, new_radius: float) -> None:
        """Set the reach in cm."""
        self.set_editor_property("attenuation_radius", new_radius)

    @api
    def set_intensity_units(self, new_intensity_units: LightUnits) -> None:
        """Set the units of the intensity; its number stays."""
        self.set_editor_property("intensity_units", new_intensity_units)


@public
@with_setters(SETTERS["PointLightComponent"])
class PointLightComponent(LocalLightComponent):
    """A light in all directions."""

    _declares = {
        "source_radius": Prop("float", 0.0),
        "soft_source_radius": Prop("float", 0.0),
        "source_length": Prop("float", 0.0),
        "use_inverse_squared_falloff": Prop("bool", True),
        "light_falloff_exponent": Prop("float", 8.0),
    }

    @api
    def set_source_radius(self, new_value: float) -> None:
        """Set the radius of the source in cm."""
        self.set_editor_property("source_radius", new_value)


@public
class SpotLightComponent(PointLightComponent):
    """A cone of light along +X."""

    _declares = {"inner_cone_angle": Prop("float", 0.0), "outer_cone_angle": Prop("float", 44.0)}

    @api
    def set_inner_cone_angle(self, new_inner_cone_angle: float) -> None:
        """Set the inner half angle in degrees."""
        self.set_editor_property("inner_cone_angle", new_inner_cone_angle)

    @api
    def set_outer_cone_angle(self, new_outer_cone_angle: float) -> None:
        """Set the outer half angle in degrees."""
        self.set_editor_property("outer_cone_angle", new_outer_cone_angle)


@public
@with_setters(SETTERS["RectLightComponent"])
class RectLightComponent(LocalLightComponent):
    """A shining rectangle that faces +X."""

    _declares = {
        "source_width": Prop("float", 64.0),
        "source_height": Prop("float", 64.0),
        "barn_door_angle": Prop("float", 88.0),
        "barn_door_length": Prop("float", 20.0),
    }

    @api
    def set_source_width(self, new_value: float) -> None:
        """Set the width in cm."""
        self.set_editor_property("source_width", new_value)

    @api
    def set_source_height(self, new_value: float) -> None:
        """Set the height in cm."""
        self.set_editor_property("source_height", new_value)


@public
@with_setters(SETTERS["SkyLightComponent"])
class SkyLightComponent(LightComponentBase):
    """Light of the sky."""

    _declares = {
        **KEPT["SkyLightComponent"],
        "intensity": Prop("float", 1.0),
        "real_time_capture": Prop("bool", False),
        "lower_hemisphere_is_black": Prop("bool", True),
        "lower_hemisphere_color": Prop("LinearColor", lambda: LinearColor(0, 0, 0, 1)),
    }

    @api
    def set_intensity(self, new_intensity: float) -> None:
        """Set the intensity."""
        self.set_editor_property("intensity", new_intensity)

    @api
    def set_light_color(self, new_light_color: LinearColor) -> None:
        """Set the colour from linear numbers."""
        self.set_editor_property("light_color", new_light_color._bytes(True))

    @api
    def recapture_sky(self) -> None:
        """Nothing is captured here: the sky is evaluated when it is rendered."""


@public
@with_setters(SETTERS["ExponentialHeightFogComponent"])
class ExponentialHeightFogComponent(SceneComponent):
    """Fog that thins out with height."""

    _declares = {
        **KEPT["ExponentialHeightFogComponent"],
        "fog_density": Prop("float", 0.02),
        "fog_height_falloff": Prop("float", 0.2),
        "start_distance": Prop("float", 0.0),
        "fog_max_opacity": Prop("float", 1.0),
        "fog_cutoff_distance": Prop("float", 0.0),
        "enable_volumetric_fog": Prop("bool", False),
        "fog_inscattering_luminance": Prop("LinearColor", lambda: LinearColor(0, 0, 0, 1)),
        "directional_inscattering_exponent": Prop("float", 4.0),
    }

    @api
    def set_fog_density(self, value: float) -> None:
        """Set the density."""
        self.set_editor_property("fog_density", value)

    @api
    def set_fog_height_falloff(self, value: float) -> None:
        """Set how fast the fog thins out."""
        self.set_editor_property("fog_height_falloff", value)

    @api
    def set_fog_max_opacity(self, value: float) -> None:
        """Set the largest opacity."""
        self.set_editor_property("fog_max_opacity", value)

    @api
    def set_start_distance(self, value: float) -> None:
        """Set the distance from the camera (cm) at which the fog begins."""
        self.set_editor_property("start_distance", value)

    @api
    def set_fog_inscattering_color(self, value: LinearColor) -> None:
        """Set the colour."""
        self.set_editor_property("fog_inscattering_luminance", value)

    @api
    def set_volumetric_fog(self, new_value: bool) -> None:
        """Set whether the fog is volumetric."""
        self.set_editor_property("enable_volumetric_fog", new_value)


@public
@with_setters(SETTERS["SkyAtmosphereComponent"])
class SkyAtmosphereComponent(SceneComponent):
    """The air."""

    _declares = {
        **KEPT["SkyAtmosphereComponent"],
        "rayleigh_scattering_scale": Prop("float", 0.0331),
        "mie_scattering_scale": Prop("float", 0.003996),
        "atmosphere_height": Prop("float", 60.0),
        "bottom_radius": Prop("float", 6360.0),
        "multi_scattering_factor": Prop("float", 1.0),
        "sky_luminance_factor": Prop("LinearColor", lambda: LinearColor(1, 1, 1, 1)),
    }


def _grade(default: float) -> Prop:
    return Prop("Vector4", lambda: Vector4(default, default, default, default))


DECLARED_SETTINGS: dict[str, Prop] = {
    "auto_exposure_method": Prop("AutoExposureMethod", AutoExposureMethod.AEM_HISTOGRAM),
    "auto_exposure_bias": Prop("float", 1.0),
    "auto_exposure_min_brightness": Prop("float", -10.0),
    "auto_exposure_max_brightness": Prop("float", 20.0),
    "auto_exposure_apply_physical_camera_exposure": Prop("bool", True),
    "bloom_intensity": Prop("float", 0.675),
    "vignette_intensity": Prop("float", 0.4),
    "white_temp": Prop("float", 6500.0),
    "white_tint": Prop("float", 0.0),
    "color_saturation": _grade(1.0),
    "color_contrast": _grade(1.0),
    "color_gamma": _grade(1.0),
    "color_gain": _grade(1.0),
    "color_offset": _grade(0.0),
    "ambient_occlusion_intensity": Prop("float", 0.5),
    "motion_blur_amount": Prop("float", 0.5),
    "film_grain_intensity": Prop("float", 0.0),
    "lens_flare_intensity": Prop("float", 1.0),
}
"""The settings that pictures here may show; the table has the others, and the ``override_`` flags of all."""


@public
class PostProcessSettings(ClosedStruct):
    """Exposure, grading and effects; each value counts when its ``override_`` flag is set."""

    _fields = Later(lambda: {**fields("PostProcessSettings"), **DECLARED_SETTINGS})

    def __init__(self, **kwargs: object) -> None:
        super().__init__(**kwargs)


@public
@with_setters(SETTERS["CameraComponent"])
class CameraComponent(SceneComponent):
    """A camera; ``field_of_view`` is horizontal, in degrees."""

    _declares = {
        "field_of_view": Prop("float", 90.0),
        "aspect_ratio": Prop("float", 16 / 9),
        "constrain_aspect_ratio": Prop("bool", True),
        "post_process_settings": Prop("PostProcessSettings", PostProcessSettings),
        "post_process_blend_weight": Prop("float", 1.0),
        "mobility": Prop("ComponentMobility", ComponentMobility.MOVABLE),
    }

    @api
    def set_field_of_view(self, field_of_view: float) -> None:
        """Set the horizontal field of view in degrees."""
        self.set_editor_property("field_of_view", field_of_view)


@public
class BrushComponent(PrimitiveComponent):
    """The box of a volume: 200 cm on a side before scaling."""

    _declares = {
        "collision_enabled": Prop("CollisionEnabled", CollisionEnabled.NO_COLLISION, attribute=False, scripts=False)
    }

    def _local_bounds(self) -> Bounds | None:
        return (-100.0, -100.0, -100.0), (100.0, 100.0, 100.0)
