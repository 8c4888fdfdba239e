"""Measures of two pictures of one size, each in [0, 1], 1 where they agree. Deterministic.

The published policy names four; which formulas stand behind them is not published, so these are ours. Base colours are
in no capture: that measure is not taken, and what it would blend with counts alone.
"""

from __future__ import annotations

import io
import zipfile
import zlib
from collections.abc import Mapping
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray
from PIL import Image, UnidentifiedImageError

from c4s.errors import BadInput
from c4s.protocol.paired import CHAMFER_PX, DEPTH_EDGE_CM, DEPTH_EDGES, FAR_CM, RGB, SILHOUETTE

Array: TypeAlias = NDArray[np.float64]
Flags: TypeAlias = NDArray[np.bool_]
WINDOW_PX = 8
_C1, _C2 = 0.01**2, 0.03**2
"""Constants of structural similarity for values in [0, 1]."""


def picture_of(png: bytes, where: str) -> Array:
    """A picture as (height, width, 3) in [0, 1]. ``BadInput`` for what is none."""
    try:
        with Image.open(io.BytesIO(png)) as image:
            return np.asarray(image.convert("RGB"), dtype=np.float64) / 255.0
    except (UnidentifiedImageError, OSError, ValueError, Image.DecompressionBombError):
        raise BadInput("this is no picture", where=where) from None


def mask_arrays(npz: bytes, where: str, *names: str) -> list[NDArray[Any]]:
    """Arrays of an actor mask by name. ``BadInput`` for what is none, or is damaged."""
    try:
        with np.load(io.BytesIO(npz), allow_pickle=False) as stored:
            return [stored[name] for name in names]
    except (OSError, ValueError, KeyError, EOFError, zipfile.BadZipFile, zlib.error):
        raise BadInput("this is no actor mask", where=where) from None


def mask_of(npz: bytes, where: str) -> tuple[Flags, Array]:
    """Foreground and depth (cm) of an actor mask: what shows an actor nearer than the far plane."""
    actor, told = mask_arrays(npz, where, "actor", "depth_cm")
    depth = told.astype(np.float64)
    near = np.isfinite(depth) & (depth < FAR_CM)
    return (actor >= 0) & near, np.where(near, depth, FAR_CM)


def pixel_measures(target: Array, truth: Array) -> dict[str, float]:
    """``rgb_perceptual_similarity``: mean structural similarity of the three channels over windows of 8 x 8 pixels."""
    if target.shape != truth.shape:
        return {}
    return {RGB: float(np.mean([_similarity(target[..., band], truth[..., band]) for band in range(3)]))}


def mask_measures(target: tuple[Flags, Array], truth: tuple[Flags, Array]) -> Mapping[str, Any]:
    """``foreground_silhouette_iou``, and ``depth_edge_similarity``: 1 less the mean way from the depth edges of each
    picture to those of the other, against 32 pixels."""
    (shown, depth), (wanted, wanted_depth) = target, truth
    if shown.shape != wanted.shape:
        return {}
    union = int((shown | wanted).sum())
    return {
        SILHOUETTE: float((shown & wanted).sum() / union) if union else 1.0,
        DEPTH_EDGES: _edge_similarity(_edges(depth), _edges(wanted_depth)),
    }


def _similarity(one: Array, other: Array) -> float:
    from scipy.ndimage import uniform_filter

    a, b = uniform_filter(one, WINDOW_PX), uniform_filter(other, WINDOW_PX)
    spread = uniform_filter(one * one, WINDOW_PX) - a * a + uniform_filter(other * other, WINDOW_PX) - b * b
    common = uniform_filter(one * other, WINDOW_PX) - a * b
    found = ((2 * a * b + _C1) * (2 * common + _C2)) / ((a * a + b * b + _C1) * (spread + _C2))
    return float(np.clip(found, 0.0, 1.0).mean())


def _edges(depth: Array) -> Flags:
    edge = np.zeros(depth.shape, dtype=bool)
    edge[:, 1:] |= np.abs(np.diff(depth, axis=1)) > DEPTH_EDGE_CM
    edge[1:, :] |= np.abs(np.diff(depth, axis=0)) > DEPTH_EDGE_CM
    return edge


def _edge_similarity(one: Flags, other: Flags) -> float:
    if not one.any() or not other.any():
        return float(one.any() == other.any())
    from scipy.ndimage import distance_transform_edt

    ways = [distance_transform_edt(~edges)[seen].mean() for edges, seen in ((other, one), (one, other))]
    return float(max(0.0, 1.0 - np.mean(ways) / CHAMFER_PX))
