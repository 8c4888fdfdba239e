"""World boxes of actors, from the local boxes of their meshes."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

import numpy as np
from numpy.typing import NDArray

from c4s.geometry.transform import affine, transformed_box
from c4s.records.level import LevelActor, Transform, Vector
from c4s.records.pack import Asset

Array = NDArray[np.float64]
Boxes = Mapping[str, tuple[Vector, Vector]]
"""Local boxes of meshes by path: lowest and highest corner in cm."""


def boxes_of(assets: Iterable[Asset]) -> Boxes:
    """The local boxes of assets."""
    return {asset.path: (asset.bounds_min_cm, asset.bounds_max_cm) for asset in assets}


def world_box(actor: LevelActor, place: Transform, boxes: Boxes) -> tuple[Array, Array]:
    """World box of all meshes of an actor at a place; NaN where one is not known or there is none."""
    corners = []
    for component in actor.components:
        if component.static_mesh is None:
            continue
        if component.static_mesh not in boxes:
            return np.full(3, np.nan), np.full(3, np.nan)
        matrix = affine(place.location_cm, place.rotation_deg, place.scale)
        if component is not actor.components[0]:
            part = component.relative
            matrix = matrix @ affine(part.location_cm, part.rotation_deg, part.scale)
        origin, half = transformed_box(matrix, *boxes[component.static_mesh])
        corners += [origin - half, origin + half]
    if not corners:
        return np.full(3, np.nan), np.full(3, np.nan)
    return np.min(corners, axis=0), np.max(corners, axis=0)
