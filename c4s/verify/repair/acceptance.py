"""Does a candidate actor reproduce a target's state? The acceptance tests of the paper's threshold table.

Limits are inclusive with a guard of 1e-9. Missing, malformed or non-finite required evidence fails.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from c4s.verify.repair.actors import Record, descriptor
from c4s.verify.repair.materials import material_set, slot_map
from c4s.verify.repair.policy import GUARD, Tolerances
from c4s.verify.repair.vectors import Vector3, angle_deg, valid_vector


@dataclass(frozen=True, slots=True)
class Errors:
    """Measured errors of a candidate actor against a target; None where the evidence does not allow a number."""

    descriptor_equal: bool
    position_cm: float | None
    rotation_deg: float | None
    scale_pct: float | None
    bounds_center_cm: float | None
    bounds_extent_pct: float | None
    failed: tuple[str, ...]
    """Names of the tests that fail; empty means accepted."""

    @property
    def accepted(self) -> bool:
        """Whether every applicable test passes."""
        return not self.failed


def _ratio(candidate: Vector3, truth: Vector3) -> float | None:
    """Largest deviation from ratio 1 over the axes; None when a truth component is zero."""
    if 0.0 in truth:
        return None
    return max(abs(c / g - 1) for c, g in zip(candidate, truth, strict=True))


def _extent_ratio(candidate: Vector3, truth: Vector3) -> float | None:
    if min(candidate) < 0 or min(truth) < 0:
        return None
    worst = 0.0
    for c, g in zip(candidate, truth, strict=True):
        if g == 0:
            if c != 0:
                return None
            continue
        worst = max(worst, abs(c / g - 1))
    return worst


def _measure(rule: Callable[[Vector3, Vector3], float | None], candidate: Any, truth: Any) -> float | None:
    c, g = valid_vector(candidate), valid_vector(truth)
    return None if c is None or g is None else rule(c, g)


def _members(record: Record, name: str) -> dict[str, Any]:
    value = record.get(name)
    return value if isinstance(value, dict) else {}


def _attribute_failures(truth: Record, candidate: Record) -> list[str]:
    failed = []
    if "properties" in truth:
        mine, theirs = truth["properties"], candidate.get("properties")
        if not isinstance(mine, dict) or not isinstance(theirs, dict) or mine != theirs:
            failed.append("properties")
    for name, read in (("material_paths", material_set), ("component_material_slots", slot_map)):
        if name in truth:
            mine, theirs = read(truth[name]), read(candidate.get(name))
            if mine is None or mine != theirs:
                failed.append(name)
    return failed


def measure(truth: Record, candidate: Record, limits: Tolerances) -> Errors:
    """Measure a candidate actor against a target's state and name the tests that it fails."""
    mine, theirs = _members(truth, "transform"), _members(candidate, "transform")
    same_kind = bool(descriptor(truth)[0]) and descriptor(truth) == descriptor(candidate)
    position = _measure(math.dist, theirs.get("location_cm"), mine.get("location_cm"))
    rotation = _measure(angle_deg, theirs.get("rotation_deg"), mine.get("rotation_deg"))
    scale = _measure(_ratio, theirs.get("scale"), mine.get("scale"))
    failed = [] if same_kind else ["descriptor"]
    for name, value, limit in (("position", position, limits.position_cm), ("rotation", rotation, limits.rotation_deg),
                               ("scale", scale, limits.ratio)):
        if value is None or not value <= limit + GUARD:
            failed.append(name)
    center = extent = None
    if truth.get("bounds") is not None:
        wanted, found = _members(truth, "bounds"), _members(candidate, "bounds")
        if "origin_cm" in wanted:
            center = _measure(math.dist, found.get("origin_cm"), wanted["origin_cm"])
            if center is None or not center <= limits.position_cm + GUARD:
                failed.append("bounds_center")
        if "extent_cm" in wanted:
            extent = _measure(_extent_ratio, found.get("extent_cm"), wanted["extent_cm"])
            if extent is None or not extent <= limits.ratio + GUARD:
                failed.append("bounds_extent")
    failed += _attribute_failures(truth, candidate)
    return Errors(same_kind, position, rotation, None if scale is None else 100 * scale, center,
                  None if extent is None else 100 * extent, tuple(failed))
