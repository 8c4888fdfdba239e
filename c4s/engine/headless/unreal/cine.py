"""The film camera's component: its field of view follows from the focal length and the sensor."""

# ruff: noqa: RUF012  (each class declares its table of properties; no table is ever changed)

from __future__ import annotations

import math
from enum import unique

from c4s.engine.headless.unreal.core import EnumBase, Prop, api, public
from c4s.engine.headless.unreal.lights import CameraComponent
from c4s.engine.headless.unreal.structs import StructBase

_SENSOR_WIDTH_MM, _SENSOR_HEIGHT_MM = 23.76, 13.365
"""The default filmback, 16:9 Digital Film."""


@public
@unique
class CameraFocusMethod(EnumBase):
    """How the distance of focus is found. Pictures here are sharp everywhere."""

    DO_NOT_OVERRIDE = 0
    MANUAL = 1
    TRACKING = 2
    DISABLE = 3


@public
class CameraFilmbackSettings(StructBase):
    """Size of the sensor in mm."""

    _fields = {
        "sensor_width": Prop("float", 0.0),
        "sensor_height": Prop("float", 0.0),
        "sensor_horizontal_offset": Prop("float", 0.0),
        "sensor_vertical_offset": Prop("float", 0.0),
        "sensor_aspect_ratio": Prop("float", 0.0),
    }


@public
class CameraLensSettings(StructBase):
    """Limits of a lens (mm, and f-stops)."""

    _fields = {
        "min_focal_length": Prop("float", 0.0),
        "max_focal_length": Prop("float", 0.0),
        "min_f_stop": Prop("float", 0.0),
        "max_f_stop": Prop("float", 0.0),
        "minimum_focus_distance": Prop("float", 0.0),
        "squeeze_factor": Prop("float", 0.0),
        "diaphragm_blade_count": Prop("int", 0),
    }


@public
class CameraFocusSettings(StructBase):
    """Where the camera focuses (cm)."""

    _fields = {
        "focus_method": Prop("CameraFocusMethod", CameraFocusMethod.DO_NOT_OVERRIDE),
        "manual_focus_distance": Prop("float", 0.0),
        "smooth_focus_changes": Prop("bool", False),
        "focus_smoothing_interp_speed": Prop("float", 0.0),
        "focus_offset": Prop("float", 0.0),
    }

    def __init__(self, **kwargs: object) -> None:
        super().__init__(**kwargs)


def _filmback() -> CameraFilmbackSettings:
    return CameraFilmbackSettings(_SENSOR_WIDTH_MM, _SENSOR_HEIGHT_MM, 0.0, 0.0, _SENSOR_WIDTH_MM / _SENSOR_HEIGHT_MM)


@public
class CineCameraComponent(CameraComponent):
    """A film camera; writing its field of view changes the focal length, as in Unreal."""

    _class_module = "CinematicCamera"
    _declares = {
        "filmback": Prop("CameraFilmbackSettings", _filmback),
        "lens_settings": Prop("CameraLensSettings", lambda: CameraLensSettings(4, 1000, 1.2, 22, 15, 1, 7)),
        "focus_settings": Prop(
            "CameraFocusSettings",
            lambda: CameraFocusSettings(
                focus_method=CameraFocusMethod.MANUAL, manual_focus_distance=100000.0, focus_smoothing_interp_speed=8.0
            ),
        ),
        "current_focal_length": Prop("float", 35.0, set="_set_focal_length"),
        "current_aperture": Prop("float", 2.8),
        "current_focus_distance": Prop("float", get="_focus_distance", writable=False, saved=False),
        "field_of_view": Prop("float", get="_wide_deg", set="_set_wide_deg", saved=False),
        "current_horizontal_fov": Prop("float", get="_wide_deg", attribute=False, writable=False, saved=False),
        "aspect_ratio": Prop("float", get="_aspect", writable=False, saved=False),
    }

    def _set_focal_length(self, value: float) -> None:
        lens = self.get_editor_property("lens_settings")
        self._values["current_focal_length"] = min(max(float(value), lens.min_focal_length), lens.max_focal_length)

    def _angle_deg(self, side_mm: float) -> float:
        length = self.get_editor_property("current_focal_length")
        return math.degrees(2 * math.atan(side_mm / (2 * length))) if length > 0 else 0.0

    def _wide_deg(self) -> float:
        squeeze = self.get_editor_property("lens_settings").squeeze_factor or 1.0
        return self._angle_deg(self.get_editor_property("filmback").sensor_width * squeeze)

    def _set_wide_deg(self, value: float) -> None:
        if 0 < value < 180:
            width = self.get_editor_property("filmback").sensor_width
            self._set_focal_length(width / (2 * math.tan(math.radians(value) / 2)))

    def _aspect(self) -> float:
        filmback = self.get_editor_property("filmback")
        return float(filmback.sensor_width / filmback.sensor_height) if filmback.sensor_height else 0.0

    def _focus_distance(self) -> float:
        return float(self.get_editor_property("focus_settings").manual_focus_distance)

    @api
    def get_horizontal_field_of_view(self) -> float:
        """In degrees."""
        return self._wide_deg()

    @api
    def get_vertical_field_of_view(self) -> float:
        """In degrees."""
        return self._angle_deg(self.get_editor_property("filmback").sensor_height)
