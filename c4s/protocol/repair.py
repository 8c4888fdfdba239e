"""Limits and identifiers of Actor Repair F1 as data.

Sources: paper, appendix "Ground-Truth-Based Verifier", table of acceptance tests; tolerance profiles of the selective
repair analysis. Only the acceptance limits vary with a profile: targets, correspondence and change detection do not.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

REPAIR_POLICY = "unified-actor-repair-success-f1.v2"
"""Published id. It stands for the newer of the two published rule sets under this id (with rebinding)."""

GUARD = 1e-9
"""Boundary guard of acceptance tests and of angles."""

SAME_LOCATION_CM = 0.1
SAME_ROTATION_DEG = 0.01
SAME_SCALE = 1e-4
"""Editor round-trip noise, per component: below these an actor counts as unchanged."""

ANGLE_COST = 0.2
FIELD_COST = 0.05
"""Weights of the assignment cost: ``d/(1+d) + 0.2*angle/180 + 0.05*changed fields`` (d in cm)."""

VISIBLE_PROPERTIES = frozenset(
    {
        "intensity",
        "intensity_units",
        "light_color",
        "temperature",
        "use_temperature",
        "source_angle",
        "indirect_lighting_intensity",
        "volumetric_scattering_intensity",
        "fog_density",
        "fog_height_falloff",
        "start_distance",
        "sun_disk_scale",
        "cloud_opacity",
        "exposure_compensation",
        "min_brightness",
        "max_brightness",
        "white_temp",
        "color_saturation",
        "color_contrast",
        "color_gamma",
        "color_gain",
        "color_offset",
    }
)
"""Property names (lower case) whose difference makes an actor a repair target."""

ProfileName = Literal["strict", "nominal", "relaxed"]


@dataclass(frozen=True, slots=True)
class Tolerances:
    """Acceptance limits: positions in cm, rotation in degrees, scale and extent as a ratio."""

    name: ProfileName
    position_cm: float
    rotation_deg: float
    ratio: float


STRICT = Tolerances("strict", 2.5, 2.5, 0.025)
NOMINAL = Tolerances("nominal", 5.0, 5.0, 0.05)
RELAXED = Tolerances("relaxed", 10.0, 10.0, 0.10)
PROFILES: dict[ProfileName, Tolerances] = {t.name: t for t in (STRICT, NOMINAL, RELAXED)}
