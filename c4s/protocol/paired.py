"""The paired visual rubric of repairs: a submission beside its truth from held-out cameras. Reported, never scored.

The dimensions, their weights, and the shares of a model's score and of measures in each are the published policy's
(``visual-gt-paired-formal``); a dimension is a weighted mean of what is known of it, and so is the whole.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from c4s.protocol.numbers import weighted_mean

PAIRED_POLICY: Final = "visual-gt-paired-formal"
PAIRED_WEIGHTS: Final = {
    "composition_layout": 0.30,
    "silhouette_geometry": 0.25,
    "material_fidelity": 0.20,
    "landmark_content": 0.15,
    "lighting_fidelity": 0.10,
}
SAID: Final = "vlm"
"""A model's score of a dimension, among its parts."""
SILHOUETTE, DEPTH_EDGES = "foreground_silhouette_iou", "depth_edge_similarity"
BASE_COLOR, RGB = "base_color_similarity", "rgb_perceptual_similarity"
PAIRED_BLEND: Final[dict[str, dict[str, float]]] = {
    "composition_layout": {SAID: 0.60, SILHOUETTE: 0.20, DEPTH_EDGES: 0.20},
    "silhouette_geometry": {SAID: 0.50, SILHOUETTE: 0.25, DEPTH_EDGES: 0.25},
    "material_fidelity": {SAID: 0.50, BASE_COLOR: 0.50},
    "landmark_content": {SAID: 1.0},
    "lighting_fidelity": {SAID: 0.50, RGB: 0.50},
}
PAIRED_SCALE: Final = 4
"""A model scores a dimension from 0 to this."""
DEPTH_EDGE_CM: Final = 50.0
"""Neighbouring pixels whose depths differ by more are an edge."""
CHAMFER_PX: Final = 32.0
"""Mean way between the edges of two pictures at which their similarity is 0."""
FAR_CM: Final = 26_000.0
"""What is farther is background."""


def blended(said: Mapping[str, float], measures: Mapping[str, float]) -> dict[str, float]:
    """The dimensions of one pair in [0, 1], each a mean of its known parts; one without any is left out.

    Args:
        said: a model's scores in [0, 1], by dimension.
        measures: of the pictures, in [0, 1], by name.
    """
    made = {}
    for dimension, shares in PAIRED_BLEND.items():
        told = {**measures, **({SAID: said[dimension]} if dimension in said else {})}
        value = _mean({part: told[part] for part in shares if part in told}, shares)
        if value is not None:
            made[dimension] = value
    return made


def paired_score(dimensions: Mapping[str, float]) -> float | None:
    """The whole in [0, 1]: the weighted mean of the dimensions that are known; None without any."""
    return _mean(dimensions, PAIRED_WEIGHTS)


def _mean(values: Mapping[str, float], weights: Mapping[str, float]) -> float | None:
    return weighted_mean((weights[name], value) for name, value in values.items()) if values else None
