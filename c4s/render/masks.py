"""Which actor each pixel of a picture shows: the mask files beside pictures, and the cameras as documents say them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from c4s.render.types import Camera, Picture

MOST_LABEL = 200
"""Characters of a label in a mask: its table takes the longest for each actor."""
LEAST_VOLUME = 1e-9
"""Determinant of the smallest placement that is drawn."""


def camera_of(view: Mapping[str, Any]) -> Camera:
    """A camera from ``location_cm``, ``rotation_deg`` ([pitch, yaw, roll]), ``fov_deg`` (horizontal), and its size."""
    x, y, z = (float(value) for value in view["location_cm"])
    pitch, yaw, roll = (float(value) for value in view["rotation_deg"])
    return Camera((x, y, z), (pitch, yaw, roll), float(view["fov_deg"]), int(view["width"]), int(view["height"]))


def mask_name(view: str) -> str:
    """The file of a view's mask, beside its picture."""
    return f"{view}.actors.npz"


def write_mask(path: Path, picture: Picture, names: Sequence[str], labels: Sequence[str]) -> None:
    """Write the actor mask and depth of a picture with the table of its actors, which the mask's numbers count."""
    with path.open("wb") as file:
        np.savez_compressed(
            file,
            actor=picture.actor,
            depth_cm=picture.depth_cm.astype(np.float32),
            names=np.array(names, dtype=np.str_),
            labels=np.array([label[:MOST_LABEL] for label in labels], dtype=np.str_),
        )


def visible(picture: Picture, names: Sequence[str]) -> dict[str, int]:
    """Pixels of each actor that the picture shows, by object name."""
    indices, counts = np.unique(picture.actor[picture.actor >= 0], return_counts=True)
    return {names[index]: int(count) for index, count in zip(indices, counts, strict=True)}
