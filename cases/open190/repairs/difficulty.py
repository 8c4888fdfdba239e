"""The prior of a repair's difficulty (paper, ``app:case-construction-details``), computed from what was changed.

It looks at the number and spatial extent of targets, the coupling of their operations, the relations that are to be
recovered, and at how few pixels tell of it. Each term is between 0 and 1, and so is their weighted mean.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from typing import Final

from c4s.records.level import Vector
from cases.admissible import FULL, LEAST_PIXELS, TargetSighting
from cases.corruption import Corruption
from cases.model import Difficulty
from cases.recipe import SpawnActor

WEIGHTS: Final = {"targets": 0.45, "extent": 0.15, "coupling": 0.1, "relations": 0.1, "ambiguity": 0.2}
MOST_TARGETS, MOST_EXTENT_CM = 6, 1500.0
CLEAR_PIXELS: Final = 0.02 * FULL
"""A target that has as many is plain to see."""
MEDIUM, HARD = 0.25, 0.43
"""From here on a repair is medium, and hard."""


@dataclass(frozen=True)
class Hardness:
    """The terms of a repair's difficulty."""

    targets: float
    extent: float
    coupling: float
    relations: float
    ambiguity: float

    @property
    def prior(self) -> float:
        """Their weighted mean."""
        total = sum(weight * float(getattr(self, name)) for name, weight in WEIGHTS.items())
        return round(total, 6)

    def plain(self) -> dict[str, float]:
        """The terms and their mean."""
        return {**asdict(self), "prior": self.prior}

    @property
    def tier(self) -> Difficulty:
        """The tier that the prior falls into."""
        return "easy" if self.prior < MEDIUM else "medium" if self.prior < HARD else "hard"


def hardness(
    changes: Sequence[Corruption], places_cm: Sequence[Vector], related: int, seen: Sequence[TargetSighting]
) -> Hardness:
    """How hard a repair is.

    Args:
        changes: the authored changes, in order.
        places_cm: where each target is, in the original where it is there.
        related: targets that stand in a relation to others (on, around, in a row).
        seen: how well each target can be seen.
    """
    operations = [one for change in changes for one in change.operations]
    targets = {one.stable_id if isinstance(one, SpawnActor) else one.target for one in operations}
    spread = max((math.dist(a, b) for a in places_cm for b in places_cm), default=0.0)
    shares = [min(1.0, max(0.0, _faint(one))) for one in seen]
    return Hardness(
        targets=min(1.0, max(0, len(targets) - 1) / (MOST_TARGETS - 1)),
        extent=min(1.0, spread / MOST_EXTENT_CM),
        coupling=min(1.0, (len(operations) - len(changes)) / 3),
        relations=min(1.0, related / 4),
        ambiguity=sum(shares) / len(shares) if shares else 0.0,
    )


def _faint(sighting: TargetSighting) -> float:
    """1 for a target that shows as few pixels as it may, 0 for one that is plain to see."""
    shown = sighting.pixels if sighting.changed_pixels is None else min(sighting.pixels, sighting.changed_pixels)
    return 1 - math.log(max(1, shown) / LEAST_PIXELS) / math.log(CLEAR_PIXELS / LEAST_PIXELS)
