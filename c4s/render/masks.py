"""Which actor each pixel of a picture shows: the mask files beside pictures, and the cameras as documents say them."""

from __future__ import annotations

import zipfile
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from c4s.render.types import Camera, Picture

MOST_LABEL = 200
"""Characters of a label in a mask: its table takes the longest for each actor."""
LEAST_VOLUME = 1e-9
"""Determinant of the smallest placement that is drawn."""
_NPZ_LEVEL = 1
"""Half the time of numpy's, a tenth more bytes."""
_LOST_BITS = 7
"""Of a depth's mantissa: 16 bits stay, 0.001 % of the depth; what is left takes half the bytes and time."""
NEAR_CM = 40.0
"""What is nearer to the eye than this stands in the way."""


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
    tables = {
        "actor": picture.actor,
        "depth_cm": _short(picture.depth_cm),
        "names": np.array(names, dtype=np.str_),
        "labels": np.array([label[:MOST_LABEL] for label in labels], dtype=np.str_),
    }
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED, compresslevel=_NPZ_LEVEL) as archive:
        for name, table in tables.items():
            with archive.open(f"{name}.npy", "w", force_zip64=True) as file:
                np.lib.format.write_array(file, table, allow_pickle=False)


def _short(depth_cm: NDArray[np.float32]) -> NDArray[np.float32]:
    """Depths rounded to the bits that a mask keeps; infinite ones stay so."""
    half, kept = np.uint32(1 << (_LOST_BITS - 1)), np.uint32(2**32 - (1 << _LOST_BITS))
    return ((np.ascontiguousarray(depth_cm, dtype=np.float32).view(np.uint32) + half) & kept).view(np.float32)


def visible(picture: Picture, names: Sequence[str]) -> dict[str, int]:
    """Pixels of each actor that the picture shows, by object name."""
    indices, counts = np.unique(picture.actor[picture.actor >= 0], return_counts=True)
    return {names[index]: int(count) for index, count in zip(indices, counts, strict=True)}


def glimpse(picture: Picture, names: Sequence[str]) -> dict[str, Any]:
    """What a picture shows, without the picture.

    ``visible``: pixels of each actor by object name; ``edge``: the names of those that touch the picture's border;
    ``near_share``: share of the pixels that show something right before the eye; ``empty_share``: that show nothing.
    """
    mask = picture.actor
    border = np.unique(np.concatenate([mask[0], mask[-1], mask[:, 0], mask[:, -1]]))
    return {
        "visible": visible(picture, names),
        "edge": [names[index] for index in border.tolist() if index >= 0],
        "near_share": float((picture.depth_cm < NEAR_CM).mean()),
        "empty_share": float((mask < 0).mean()),
    }
