"""Lateral support of edited actors: a thin standing panel that lies on something much larger (scorer fact 4).

Only the largest panel of an actor is looked at. A grid of short lines leaves each of its two faces; the face with more
lines that meet a support counts. A line stops at the first surface, whatever that is.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from c4s.collision import NOISE_CM
from c4s.collision.mesh_body import Array
from c4s.protocol.rules import (
    GAP_CM,
    PANEL_FACING,
    PANEL_GRID,
    PANEL_NORMAL_Z,
    PANEL_RATIO,
    PANEL_REACH,
    PANEL_SHARE,
    PANEL_START_CM,
    PANEL_THINNESS,
    PANEL_UPRIGHT_Z,
)
from c4s.verify.physics.surfaces import FirstHits

_SMALL = 1e-4
LINES = 2 * PANEL_GRID**2
"""Lines of a panel: first those of the face against its normal, then those of the other."""
_SLACK = 1e-9


class Panel(NamedTuple):
    """A thin standing box."""

    centre: Array
    normal: Array
    upright: Array
    """Unit vectors across its thin side, up its face, and along it."""
    sideways: Array
    half: tuple[float, float, float]
    """Half extents in cm along these three."""

    @property
    def area_cm2(self) -> float:
        """Of one face."""
        return 4 * self.half[1] * self.half[2]


class Lateral(NamedTuple):
    """What holds a panel."""

    held: bool
    share: float
    """Of the lines of its better face."""
    distance_cm: float | None
    holders: list[int]


def panel_of(low: Sequence[float], high: Sequence[float], pose: Array) -> Panel | None:
    """The panel that a mesh with these local bounds (cm) is under a pose (4 x 4); None when it is none."""
    middle, local = (np.array(high) + np.array(low)) / 2, np.abs(np.array(high) - np.array(low)) / 2
    lengths = np.linalg.norm(pose[:3, :3], axis=0)
    if float(lengths.min()) <= 1e-6:
        return None
    half, axes = local * lengths, (pose[:3, :3] / lengths).T
    thin = int(np.argmin(half))
    a, b = (axis for axis in range(3) if axis != thin)
    if half[thin] <= _SMALL or min(half[a], half[b]) < half[thin] * PANEL_THINNESS * (1 - _SLACK):
        return None
    up, side = (b, a) if abs(axes[b, 2]) > abs(axes[a, 2]) else (a, b)
    if abs(axes[thin, 2]) > PANEL_NORMAL_Z + _SLACK or abs(axes[up, 2]) < PANEL_UPRIGHT_Z - _SLACK:
        return None
    centre = pose[:3, :3] @ middle + pose[:3, 3]
    found = Panel(centre, axes[thin], axes[up], axes[side], (float(half[thin]), float(half[up]), float(half[side])))
    return found if found.area_cm2 > _SMALL else None


def panel_lines(panel: Panel) -> tuple[Array, Array]:
    """Starts and steps of its lines."""
    spread = np.linspace(-PANEL_REACH, PANEL_REACH, PANEL_GRID)
    up, side = (grid.ravel() for grid in np.meshgrid(spread * panel.half[1], spread * panel.half[2], indexing="ij"))
    face = panel.centre + up[:, None] * panel.upright + side[:, None] * panel.sideways
    starts, steps = [], []
    for sign in (-1.0, 1.0):
        out = sign * panel.normal
        starts.append(face + out * (panel.half[0] - PANEL_START_CM))
        steps.append(np.tile(out * (GAP_CM + 2 * PANEL_START_CM), (len(face), 1)))
    return np.concatenate(starts), np.concatenate(steps)


def held_sideways(panel: Panel, hits: FirstHits, extents: Sequence[Array | None], support: Sequence[bool]) -> Lateral:
    """Judge a panel by what its lines met.

    Args:
        panel: the panel.
        hits: what its ``LINES`` lines met, in order.
        extents: half extents (cm) of the world box of every actor.
        support: whether what a line met may support the panel.
    """
    count, best = PANEL_GRID**2, Lateral(False, 0.0, None, [])
    for face, sign in enumerate((-1.0, 1.0)):
        out, found = sign * panel.normal, []
        for k in range(face * count, (face + 1) * count):
            actor = int(hits.actor[k])
            extent = extents[actor] if actor >= 0 else None
            if extent is None or not support[k] or abs(float(hits.normal[k] @ out)) < PANEL_FACING - _SLACK:
                continue
            way = float((hits.point[k] - panel.centre) @ out) - panel.half[0]
            span = 2 * float(np.abs(panel.upright) @ extent), 2 * float(np.abs(panel.sideways) @ extent)
            if way <= GAP_CM + NOISE_CM and span[0] * span[1] >= PANEL_RATIO * panel.area_cm2 * (1 - _SLACK):
                found.append((actor, max(0.0, way)))
        if len(found) / count > best.share or not face:
            best = Lateral(
                len(found) / count >= PANEL_SHARE,
                len(found) / count,
                min((way for _, way in found), default=None),
                sorted({actor for actor, _ in found}),
            )
    return best
