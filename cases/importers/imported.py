"""A scene as an importer read it: meshes, placed things, lights and cameras, and what is not in it."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from typing import Literal

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from c4s.errors import BadInput
from c4s.geometry.transform import rotator_from_quat
from c4s.records.level import Transform
from c4s.records.pack import CollisionBody
from catalog.ingest.surface import SourcePart

Matrix = NDArray[np.float64]
PLACE_DIGITS = 7
"""Of angles (degrees) and scale factors: a corner 100 m from its pivot stays within a thousandth of a millimetre."""


@dataclass
class SceneAsset:
    """A mesh that actors share: parts in cm and Unreal's axes about its pivot.

    ``ground``: its bodies are taken as they are told: slabs under its surface, a trunk within leaves.
    """

    name: str
    parts: list[SourcePart]
    collision: list[CollisionBody] = field(default_factory=list)
    ground: bool = False


@dataclass
class SceneActor:
    """A placed mesh: its path in the source (``Cafe/chair_1``), its asset's key, its matrix (cm, Unreal's axes).

    ``movable``: the source says that it is not fixed to its place.
    """

    path: str
    asset: str
    matrix: Matrix
    movable: bool = False


@dataclass
class SceneLight:
    """A light: world matrix (it shines along X), linear colour and strength as in the engine.

    ``units`` of a point or spot light, the engine's own measure when left out; ``cone_deg`` are the inner and outer
    half angles of a spot light.
    """

    path: str
    kind: Literal["point", "spot", "directional"]
    matrix: Matrix
    color: tuple[float, float, float] = (1.0, 1.0, 1.0)
    intensity: float = 1.0
    radius_cm: float = 1000.0
    units: Literal["CANDELAS"] | None = None
    cone_deg: tuple[float, float] | None = None


@dataclass
class SceneCamera:
    """A camera: world matrix (it looks along X), horizontal field of view in degrees, width over height."""

    path: str
    matrix: Matrix
    fov_deg: float
    aspect: float


@dataclass
class ImportedScene:
    """A scene as an importer read it. ``skipped`` names what is not in it and why."""

    metric: bool = False
    """The format itself says that its unit is the metre."""
    assets: dict[str, SceneAsset] = field(default_factory=dict)
    actors: list[SceneActor] = field(default_factory=list)
    lights: list[SceneLight] = field(default_factory=list)
    cameras: list[SceneCamera] = field(default_factory=list)
    skipped: list[dict[str, str]] = field(default_factory=list)
    notes: list[dict[str, str]] = field(default_factory=list)

    def skip(self, name: str, reason: str, kind: str = "") -> None:
        """Record that something of the source is left out; what has one ``kind`` is told together.

        Without one it is the reason, its quoted names left out.
        """
        self.skipped.append({"name": name, "reason": reason, "kind": _kind(kind or reason)})

    def note(self, name: str, text: str) -> None:
        """Record something about what was read, once."""
        row = {"name": name, "note": text}
        if row not in self.notes:
            self.notes.append(row)


def _kind(reason: str) -> str:
    """A reason without what it says of one thing alone: quoted names, what stands in brackets or behind a colon."""
    return " ".join(re.sub(r"'[^']*'|\([^)]*\)|: .*", " ", reason).split()) or reason


def place(matrix: Matrix) -> tuple[Transform, bool]:
    """Location, rotation and scale of a matrix, and whether it has a shear that these cannot hold."""
    scale = np.linalg.norm(matrix[:3, :3], axis=0)
    if not np.isfinite(matrix).all() or scale.min() < 1e-9:
        raise BadInput("an actor's transform has a number that is not finite, or a scale of nothing")
    axes = matrix[:3, :3] / scale
    if np.linalg.det(axes) < 0:
        scale[0], axes[:, 0] = -scale[0], -axes[:, 0]
    sheared = bool(np.abs(axes.T @ axes - np.eye(3)).max() > 1e-3)
    u, _, v = np.linalg.svd(axes)
    rotation = rotator_from_quat(Rotation.from_matrix(u @ v).as_quat().tolist())
    place = [
        tuple(round(float(value), digits) + 0.0 for value in values)
        for values, digits in ((matrix[:3, 3], 4), (rotation, PLACE_DIGITS), (scale, PLACE_DIGITS))
    ]
    return Transform(location_cm=place[0], rotation_deg=place[1], scale=place[2]), sheared
