"""Does a candidate actor reproduce a target's state? The acceptance tests of the paper's threshold table.

Limits are inclusive with a guard of 1e-9. Missing, malformed or non-finite required evidence fails.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Literal, TypeAlias

from c4s.protocol.repair import GUARD, Tolerances
from c4s.verify.actors.entries import Record
from c4s.verify.actors.kinds import descriptor
from c4s.verify.actors.materials import material_set, slot_map
from c4s.verify.actors.vectors import Vector3, angle_deg, valid_vector

Quantity: TypeAlias = Literal["distance", "angle", "ratio"]


@dataclass(frozen=True, slots=True)
class Errors:
    """Measured errors of a candidate actor against a target; None where the evidence does not allow a number."""

    position_cm: float | None
    rotation_deg: float | None
    scale_pct: float | None
    bounds_center_cm: float | None
    bounds_extent_pct: float | None
    descriptor_equal: bool
    unequal: tuple[str, ...]
    """Names of the attributes that must be equal and are not."""
    numbers: tuple[tuple[str, Quantity, float | None], ...]
    """Test, quantity and unrounded value of each applicable test that has a tolerance, in the order of the paper."""

    def failed(self, limits: Tolerances) -> tuple[str, ...]:
        """Names of the tests that fail; empty means accepted."""
        limit = {"distance": limits.position_cm, "angle": limits.rotation_deg, "ratio": limits.ratio}
        far = tuple(
            name for name, quantity, value in self.numbers if value is None or not value <= limit[quantity] + GUARD
        )
        return (() if self.descriptor_equal else ("descriptor",)) + far + self.unequal

    def accepted(self, limits: Tolerances) -> bool:
        """Whether every applicable test passes."""
        return not self.failed(limits)


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


def measure(truth: Record, candidate: Record) -> Errors:
    """Measure a candidate actor against a target's state."""
    mine, theirs = _members(truth, "transform"), _members(candidate, "transform")
    same_kind = bool(descriptor(truth)[0]) and descriptor(truth) == descriptor(candidate)
    position = _measure(math.dist, theirs.get("location_cm"), mine.get("location_cm"))
    rotation = _measure(angle_deg, theirs.get("rotation_deg"), mine.get("rotation_deg"))
    scale = _measure(_ratio, theirs.get("scale"), mine.get("scale"))
    numbers: list[tuple[str, Quantity, float | None]] = [
        ("position", "distance", position),
        ("rotation", "angle", rotation),
        ("scale", "ratio", scale),
    ]
    center = extent = None
    if truth.get("bounds") is not None:
        wanted, found = _members(truth, "bounds"), _members(candidate, "bounds")
        if "origin_cm" in wanted:
            center = _measure(math.dist, found.get("origin_cm"), wanted["origin_cm"])
            numbers.append(("bounds_center", "distance", center))
        if "extent_cm" in wanted:
            extent = _measure(_extent_ratio, found.get("extent_cm"), wanted["extent_cm"])
            numbers.append(("bounds_extent", "ratio", extent))
    return Errors(
        position,
        rotation,
        None if scale is None else 100 * scale,
        center,
        None if extent is None else 100 * extent,
        same_kind,
        tuple(_attribute_failures(truth, candidate)),
        tuple(numbers),
    )
