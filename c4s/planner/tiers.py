"""The order of building: ground, then structures, then what stands on the ground, then what stands on things."""

from __future__ import annotations

from c4s.planner.place import PlacedEntry

GROUND, STRUCTURE, FURNITURE, DETAIL = 0, 1, 2, 3
NAMES = {GROUND: "ground", STRUCTURE: "structures", FURNITURE: "props", DETAIL: "details"}
FLAT_RATIO = 0.06
STRUCTURE_HEIGHT_CM = 250.0
STRUCTURE_AREA_CM2 = 6.0e4


def is_ground(entry: PlacedEntry) -> bool:
    """Whether an entry is a flat tile: at least 1 m wide and far lower than wide."""
    width = 2 * min(entry.half_x, entry.half_y)
    return width >= 100.0 and entry.height <= max(FLAT_RATIO * width, 12.0) and entry.on is None


def tier_of(entry: PlacedEntry) -> int:
    """Build tier of an entry."""
    if is_ground(entry):
        return GROUND
    if entry.on is not None:
        return DETAIL
    area = 4 * entry.half_x * entry.half_y
    return STRUCTURE if entry.height >= STRUCTURE_HEIGHT_CM and area >= STRUCTURE_AREA_CM2 else FURNITURE
