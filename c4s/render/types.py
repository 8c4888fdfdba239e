"""What a picture is made of and from: surfaces, instances, lights, the camera, and the picture itself.

World units are centimetres and degrees in Unreal's left-handed axes (X forward, Y right, Z up). Colours are linear RGB.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Literal, TypeAlias

import numpy as np
from numpy.typing import NDArray

from c4s.errors import BadInput

Rgb: TypeAlias = tuple[float, float, float]
Point: TypeAlias = tuple[float, float, float]
Mode: TypeAlias = Literal["lit", "base_color"]
Alpha: TypeAlias = Literal["opaque", "mask", "blend"]


@dataclass(frozen=True, eq=False)
class SurfaceMaterial:
    """How a surface looks. A material is known by identity: share one object between instances."""

    base_color: Rgb = (0.5, 0.5, 0.5)
    roughness: float = 0.8
    metallic: float = 0.0
    emissive: Rgb = (0.0, 0.0, 0.0)
    """Radiance that the surface sends out; it lights no other surface."""
    opacity: float = 1.0
    """Below 1 the surface lets what is behind it through, unrefracted, and casts no shadow."""
    texture: NDArray[np.uint8] | None = None
    """(H, W, 3) sRGB picture, or (H, W, 4) with alpha, first row at v = 0; it multiplies ``base_color``."""
    alpha: Alpha = "opaque"
    """What the texture's alpha does: nothing; cuts holes where it is below ``alpha_cutoff``, for shadows too; or scales
    ``opacity``."""
    alpha_cutoff: float = 0.5
    normal_texture: NDArray[np.uint8] | None = None
    """(H, W, 3) tangent-space normals as in glTF: green points to the picture's top."""
    roughness_metal_texture: NDArray[np.uint8] | None = None
    """(H, W, 3) as in glTF: green multiplies ``roughness``, blue ``metallic``."""
    emissive_texture: NDArray[np.uint8] | None = None
    """(H, W, 3) sRGB; it multiplies ``emissive``."""


@dataclass(frozen=True, eq=False)
class Instance:
    """A mesh placed in the world."""

    mesh: int
    """Index into the renderer's meshes."""
    matrix: NDArray[np.float64]
    """4x4, local cm to world cm, for column vectors. Mirroring and uneven scale are allowed."""
    materials: tuple[SurfaceMaterial, ...]
    """One a material slot; a slot without one is drawn in a neutral grey."""
    actor: int
    """Number written into the actor mask, 0 or more. Several instances may share it."""


@dataclass(frozen=True)
class Sun:
    """A directional light."""

    direction: Point = (-0.45, 0.55, -0.75)
    """The way the light travels (a DirectionalLight's forward vector); any length."""
    color: Rgb = (1.0, 0.95, 0.87)
    intensity: float = 4.0
    """Irradiance on a surface that faces the sun; a white one then sends out intensity / pi."""
    angle_deg: float = 1.2
    """Apparent diameter; wider is softer."""
    casts_shadows: bool = True


@dataclass(frozen=True)
class LocalLight:
    """A point light; a spot light when the outer cone is below 180 degrees; a rectangle when it has an extent."""

    position: Point
    """cm."""
    color: Rgb = (1.0, 1.0, 1.0)
    intensity_cd: float = 8.0
    """Candela: the irradiance at one metre, in the sun's unit."""
    attenuation_radius: float = 1000.0
    """cm; the light fades to nothing here."""
    direction: Point = (0.0, 0.0, -1.0)
    inner_cone_deg: float = 180.0
    """Half angle of full strength."""
    outer_cone_deg: float = 180.0
    """Half angle beyond which there is no light."""
    source_radius: float = 4.0
    """cm; larger is softer."""
    across: Point = (0.0, 0.0, 0.0)
    upwards: Point = (0.0, 0.0, 0.0)
    """Half the sides of a shining rectangle (cm); it sends light along ``direction`` by the cosine."""
    falloff_exponent: float = 0.0
    """Above 0 the light falls off as (1 - (distance / radius)^2) to this power and not by the inverse square; the
    intensity is then the irradiance at the light itself."""
    casts_shadows: bool = True


@dataclass(frozen=True)
class Sky:
    """The background, and the light that it gives to every surface according to where the surface faces."""

    zenith: Rgb = (0.20, 0.38, 0.72)
    horizon: Rgb = (0.68, 0.78, 0.88)
    ground: Rgb = (0.30, 0.29, 0.27)
    intensity: float = 1.0
    light: float = 0.8
    """Share of the sky's radiance that lights surfaces (a SkyLight); 0 leaves only the background."""
    light_color: Rgb = (1.0, 1.0, 1.0)
    """It multiplies the light on surfaces, not the background."""


@dataclass(frozen=True)
class Fog:
    """Fog that thins out with height, as Unreal's exponential height fog."""

    density: float = 0.02
    """Exponent of 2 per 1000 cm, as an ExponentialHeightFog's ``fog_density``."""
    falloff: float = 0.2
    """Halvings per 1000 cm of height."""
    height_cm: float = 0.0
    color: Rgb = (0.45, 0.64, 0.77)
    """Radiance of dense fog."""
    start_cm: float = 0.0
    cutoff_cm: float = 0.0
    """Distance from which nothing is fogged; 0 for none."""
    max_opacity: float = 1.0
    glow: Rgb = (0.0, 0.0, 0.0)
    """Radiance added towards the first sun, by the cosine to the power of ``glow_exponent``."""
    glow_exponent: float = 4.0


@dataclass(frozen=True)
class Lights:
    """All light of a scene. The default is a clear day."""

    sun: Sun | None = field(default_factory=Sun)
    other_suns: tuple[Sun, ...] = ()
    sky: Sky = field(default_factory=Sky)
    ambient: Rgb = (0.04, 0.04, 0.04)
    """Radiance that reaches every surface from everywhere."""
    local: tuple[LocalLight, ...] = ()
    camera_fill: float = 0.25
    """Irradiance of a shadowless light at the camera, in the sun's unit."""
    exposure_ev: float | None = None
    """Exposure in stops; ``None`` adapts to the picture, in steps of a quarter stop."""
    fog: Fog | None = None
    ambient_occlusion_cm: float = 160.0
    """Reach of ambient occlusion."""


@dataclass(frozen=True)
class Grade:
    """What is done to a lit picture after the light is known. The default changes nothing.

    Saturation, contrast, gamma, gain and offset act in this order on exposed linear RGB, before the tone curve.
    """

    exposure_ev: float | None = None
    """Exposure in stops in place of the lights' or the automatic one."""
    lowest_ev: float = -math.inf
    highest_ev: float = math.inf
    """Limits of the automatic exposure, stops."""
    bias_ev: float = 0.0
    white_balance: tuple[Rgb, Rgb, Rgb] = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
    """Rows of the matrix that linear RGB is multiplied by first."""
    saturation: Rgb = (1.0, 1.0, 1.0)
    contrast: Rgb = (1.0, 1.0, 1.0)
    """Power around mid grey, 0.18."""
    gamma: Rgb = (1.0, 1.0, 1.0)
    gain: Rgb = (1.0, 1.0, 1.0)
    offset: Rgb = (0.0, 0.0, 0.0)


@dataclass(frozen=True)
class Camera:
    """A pinhole camera. At rotation 0 it looks along +X, with +Y to the right of the picture and +Z up."""

    location_cm: Point
    rotation_deg: Point = (0.0, 0.0, 0.0)
    """[pitch, yaw, roll]."""
    hfov_deg: float = 90.0
    """Horizontal field of view."""
    width: int = 1280
    height: int = 720

    def __post_init__(self) -> None:
        """Refuse a camera that cannot take a picture."""
        numbers = (*self.location_cm, *self.rotation_deg, self.hfov_deg)
        if not np.isfinite(np.asarray(numbers, dtype=float)).all():
            raise BadInput("the camera has a coordinate that is not finite", where="camera")
        if not 0.1 <= self.hfov_deg <= 179.0:
            raise BadInput(f"field of view {self.hfov_deg} is not within 0.1..179 degrees", where="camera")
        if not (1 <= self.width <= 8192 and 1 <= self.height <= 8192):
            raise BadInput(f"picture size {self.width} x {self.height} is not within 1..8192", where="camera")


@dataclass(frozen=True, eq=False)
class Picture:
    """A picture with, for every pixel, whose surface it shows and how far away that is.

    Mask and depth belong to the ray through the pixel's centre and show the first surface of opacity 0.5 or more.
    """

    rgb: NDArray[np.uint8]
    """(H, W, 3) sRGB."""
    actor: NDArray[np.int32]
    """(H, W) actor number, -1 where nothing is seen."""
    depth_cm: NDArray[np.float32]
    """(H, W) distance along the viewing direction, inf where nothing is seen."""
