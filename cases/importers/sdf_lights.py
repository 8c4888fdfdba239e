"""Lights of SDF: their strength, colour, reach and direction in the engine's terms."""

from __future__ import annotations

from typing import Literal
from xml.etree.ElementTree import Element

import numpy as np

from c4s.errors import BadInput
from cases.importers.imported import SceneLight
from cases.importers.sdf_frames import Matrix, numbers
from cases.importers.sdf_shapes import to_unreal

SUN_INTENSITY = 4.0
POINT_INTENSITY = 8000.0
"""What a full white SDF light becomes; SDF's lights have no physical unit."""
KINDS: dict[str, Literal["point", "spot", "directional"]] = {
    "point": "point",
    "spot": "spot",
    "directional": "directional",
}


def light_of(element: Element, name: str, frame: Matrix) -> SceneLight:
    """A light of SDF that stands at ``frame`` (SDF's axes); ``BadInput`` for an unknown kind and for no numbers."""
    kind = element.get("type", "")
    if kind not in KINDS:
        raise BadInput(f"a light of type {kind!r} is not supported")
    r, g, b = (min(1.0, max(0.0, value)) for value in numbers(element.findtext("diffuse"), 3, 1.0))
    strong, matrix = max(r, g, b, 1e-6), to_unreal(frame)
    level = strong * numbers(element.findtext("intensity"), 1, 1.0)[0]
    direction = np.asarray(numbers(element.findtext("direction") or "0 0 -1", 3)) * [1, -1, 1]
    cone = [
        round(float(np.degrees(numbers(element.findtext(f"spot/{part}_angle"), 1, angle)[0])) / 2, 4)
        for part, angle in (("inner", 0.6), ("outer", 1.0))
    ]
    reach = min(100 * numbers(element.findtext("attenuation/range"), 1, 10.0)[0], 100_000.0)
    if kind != "point":
        matrix[:3, :3] = _along(matrix[:3, :3] @ direction)
    return SceneLight(
        name,
        KINDS[kind],
        matrix,
        (r / strong, g / strong, b / strong),
        level * (SUN_INTENSITY if kind == "directional" else POINT_INTENSITY),
        reach,
        cone_deg=(cone[0], cone[1]) if kind == "spot" else None,
    )


def _along(direction: Matrix) -> Matrix:
    """A rotation whose X axis points along a direction."""
    x = direction / max(float(np.linalg.norm(direction)), 1e-12)
    side = np.cross([0.0, 0.0, 1.0] if abs(x[2]) < 0.99 else [1.0, 0.0, 0.0], x)
    side /= np.linalg.norm(side)
    return np.stack([x, side, np.cross(x, side)], axis=1)
