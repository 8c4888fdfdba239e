"""Placements far away from all the others: slips of an editor, a fallen body, a wrong unit."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

LEAST_KM = 1.0
SPANS = 50.0
"""A placement is wild when it lies so many times the spread of the nearest nine tenths away, and ``LEAST_KM``."""


def wild(actors: Sequence[tuple[str, NDArray[np.float64]]]) -> dict[str, str]:
    """What is to be noted of each wild placement: paths and matrices (cm) of all in, notes by path out."""
    if len(actors) < 3:
        return {}
    places = np.array([matrix[:3, 3] for _, matrix in actors])
    places = np.where(np.isfinite(places), places, 0.0)
    middle = np.median(places, axis=0)
    away = np.linalg.norm(places - middle, axis=1)
    limit = max(LEAST_KM * 1e5, SPANS * float(np.quantile(away, 0.9, method="lower")))
    return {
        path: f"it lies {distance / 1e5:.3g} km from the middle of the others, at "
        f"{', '.join(f'{axis} = {value / 100:.4g} m' for axis, value in zip('xyz', place, strict=True))}; "
        f"--without '{path}' leaves it out"
        for (path, _), place, distance in zip(actors, places, away, strict=True)
        if distance > limit
    }
