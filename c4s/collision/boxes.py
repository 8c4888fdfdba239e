"""The depth of box pairs in closed form: the separating-axis test over the 15 axes of two boxes.

Every face of the Minkowski difference of two boxes has one of these axes as its normal (three faces of each, nine
products of edges), so the smallest overlap is the exact minimum translation.
"""

from __future__ import annotations

import numpy as np

from c4s.collision.mesh_body import Array

PARALLEL = 1e-8
"""Sine of the angle under which two edges count as parallel: their product is no axis of its own."""


def box_depths(half_a: Array, rotation_a: Array, half_b: Array, rotation_b: Array, offset: Array) -> Array:
    """Depths in cm of n box pairs; negative where an axis separates them (then no distance, only its sign counts).

    Args:
        half_a, half_b: half extents (n, 3).
        rotation_a, rotation_b: poses (n, 3, 3), columns are the boxes' axes.
        offset: centre of b minus centre of a (n, 3).
    """
    turn = np.einsum("nki,nkj->nij", rotation_a, rotation_b)
    span = np.abs(turn)
    along_a = np.einsum("nki,nk->ni", rotation_a, offset)
    along_b = np.einsum("nki,nk->ni", rotation_b, offset)
    depth = np.minimum(
        (half_a + np.einsum("nij,nj->ni", span, half_b) - np.abs(along_a)).min(axis=1),
        (half_b + np.einsum("nij,ni->nj", span, half_a) - np.abs(along_b)).min(axis=1),
    )
    for i in range(3):
        i1, i2 = (i + 1) % 3, (i + 2) % 3
        for j in range(3):
            j1, j2 = (j + 1) % 3, (j + 2) % 3
            length = np.hypot(turn[:, i1, j], turn[:, i2, j])
            reach = (
                half_a[:, i1] * span[:, i2, j]
                + half_a[:, i2] * span[:, i1, j]
                + half_b[:, j1] * span[:, i, j2]
                + half_b[:, j2] * span[:, i, j1]
            )
            apart = np.abs(along_a[:, i2] * turn[:, i1, j] - along_a[:, i1] * turn[:, i2, j])
            crossing = length > PARALLEL
            depth = np.where(crossing, np.minimum(depth, (reach - apart) / np.where(crossing, length, 1.0)), depth)
    return np.asarray(depth)
