"""Constants of the Embodied Utility Score (paper, "Embodied Utility Score Implementation"; readings E01 to E09).

The paper gives neither a step nor a cell size of the navigation mesh; ``CELL_CM``, ``CELL_HEIGHT_CM`` and ``STEP_CM``
are ours, and every measurement records what it was made with.
"""

from __future__ import annotations

from typing import Final, Literal

NAVIGATION_POLICY: Final = "c4s.embodied-utility.v1"

AGENT_RADIUS_CM: Final = 50.0
AGENT_HEIGHT_CM: Final = 180.0
AGENT_SLOPE_DEG: Final = 35.0
MIN_REGION_AREA: Final = 150.0
"""As the engine's setting of this name, which is a side in cm: 2.25 square metres."""
SETTLE_LIMIT_S: Final = 300.0
CELL_CM: Final = 12.5
CELL_HEIGHT_CM: Final = 5.0
STEP_CM: Final = 35.0

PLATE_CM: Final = 20_000.0
TOWER_CM: Final = 5_000.0
"""A component wider in plan, or higher, is left out of the bounds of the navigation mesh."""
COMPONENT_PITCH_CM: Final = 200.0
PROJECTION_PITCH_CM: Final = 25.0
STRATUM_CM: Final = 100.0
"""Pitches of the lattices: for components, for targets, and of both upwards."""
PHASE_CM: Final = 6.25
"""Lattices lie this far beside the multiples of their pitch in the world: in the middle of our cells, on no edge."""
REACH_CM: Final = 100.0
"""A sample of a footprint is projected to cells this near in plan."""
SAMPLES: Final[tuple[tuple[float, float], ...]] = (
    (0.0, 0.0),
    (-0.9, -0.9),
    (-0.9, 0.0),
    (-0.9, 0.9),
    (0.0, -0.9),
    (0.0, 0.9),
    (0.9, -0.9),
    (0.9, 0.0),
    (0.9, 0.9),
)
"""Samples of a footprint as shares of its half extents, in the order in which they are tried (published probe)."""
ABOVE_CM: Final = 150.0
BELOW_CM: Final = 50.0
"""A target's base lies at most this much above, or below, the navigation point beneath it; else it is scenery."""
LEAST_POOL: Final = 15
"""A scene with fewer floor-level targets has the utility 0."""

MOST_BUILDS: Final = 3
AGREED_A: Final = 0.05
AGREED_CELLS: Final = 0.005
"""Two builds in a row agree when A differs by no more, and the number of cells by no more than this share."""

ARRIVAL_LEAST_CM: Final = 120.0
ARRIVAL_MOST_CM: Final = 300.0
ARRIVAL_SHARE: Final = 0.25
"""The arrival radius is this share of the smaller half extent, within the two limits."""
ANCHOR_CM: Final = 150.0
"""Walks start within this height of the ground median."""
QUANTILES: Final = (0.20, 0.55, 0.90)
"""Targets of the walks, by route distance."""
SMALL_CM: Final = 1200.0
SMALL_ROUTES: Final = 6
SMALL_LENGTH: Final = 4.0
"""A scene with a smaller half extent is walked from object to object: at most so many routes of so many radii."""
SPEED_CM_S: Final = 200.0
STALL_S: Final = 5.0
STALL_CM: Final = 10.0
STALLS: Final = 2
"""A walk ends after so many windows in a row with less progress."""

Withheld = Literal[
    "not_probed",
    "navigation_too_large",
    "not_settled",
    "settings_not_kept",
    "not_certified",
    "no_anchor",
    "no_route",
    "content_failure",
]
"""Why there is no number. ``content_failure`` is of the machinery: such a scene is excluded, not withheld."""
EXCLUDED: Final[frozenset[Withheld]] = frozenset({"content_failure", "not_probed"})
"""Reasons that are not the scene's: the record counts nowhere."""


def arrival_radius_cm(half_extent_cm: float) -> float:
    """How near is there; ``half_extent_cm`` is half of the shorter plan side of the mesh (eq. eus-w)."""
    return min(ARRIVAL_MOST_CM, max(ARRIVAL_LEAST_CM, ARRIVAL_SHARE * half_extent_cm))
