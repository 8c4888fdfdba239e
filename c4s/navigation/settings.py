"""What a navigation mesh is made with. Every measurement records all of it."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import Any, Final

from c4s.protocol import navigation as rules

PROPERTIES: Final = {
    "radius_cm": "agent_radius",
    "height_cm": "agent_height",
    "slope_deg": "agent_max_slope",
    "step_cm": "agent_max_step_height",
    "min_region_area": "min_region_area",
    "cell_cm": "cell_size",
    "cell_height_cm": "cell_height",
}
"""The editor property of a ``RecastNavMesh`` that holds each setting."""


@dataclass(frozen=True)
class NavigationSettings:
    """The body and the grid (cm, degrees)."""

    radius_cm: float = rules.AGENT_RADIUS_CM
    height_cm: float = rules.AGENT_HEIGHT_CM
    slope_deg: float = rules.AGENT_SLOPE_DEG
    step_cm: float = rules.STEP_CM
    min_region_area: float = rules.MIN_REGION_AREA
    """A side in cm: what connects fewer square centimetres than its square is no ground."""
    cell_cm: float = rules.CELL_CM
    cell_height_cm: float = rules.CELL_HEIGHT_CM

    @property
    def radius_cells(self) -> int:
        """The radius in cells, rounded up."""
        return math.ceil(self.radius_cm / self.cell_cm - 1e-4)

    @property
    def height_steps(self) -> int:
        """The height in cell heights, rounded up."""
        return math.ceil(self.height_cm / self.cell_height_cm - 1e-4)

    @property
    def climb_steps(self) -> int:
        """The step in cell heights, rounded down."""
        return math.floor(self.step_cm / self.cell_height_cm + 1e-4)

    @property
    def least_cells(self) -> int:
        """Cells of the smallest region."""
        return int((self.min_region_area / self.cell_cm) ** 2)

    def plain(self) -> dict[str, float]:
        """As a record keeps it."""
        return asdict(self)

    def properties(self) -> dict[str, float]:
        """As the editor properties of a ``RecastNavMesh``."""
        return {PROPERTIES[name]: value for name, value in self.plain().items()}


def settings_told(properties: Mapping[str, Any]) -> dict[str, float]:
    """The settings that the editor properties of a ``RecastNavMesh`` tell."""
    told = {name: properties.get(own) for name, own in PROPERTIES.items()}
    return {name: float(value) for name, value in told.items() if isinstance(value, int | float)}
