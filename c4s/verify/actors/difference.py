"""Which recorded fields differ between two records of an actor.

One field list, three uses: what makes an actor a repair target (input against truth), what makes two actors the same
but for their identity, and what makes an actor changed (input against candidate). Scorer facts 2.2 and 2.3.
"""

from __future__ import annotations

import json
from math import isfinite
from typing import Any

from c4s.protocol.repair import GUARD, SAME_LOCATION_CM, SAME_ROTATION_DEG, SAME_SCALE, VISIBLE_PROPERTIES
from c4s.verify.actors.entries import Record
from c4s.verify.actors.kinds import short_class
from c4s.verify.actors.materials import comparable_materials, comparable_slots
from c4s.verify.actors.vectors import angle_deg, same_within, valid_vector

MATERIAL_FIELDS = ("property.material_paths", "property.component_material_slots")
ASSET_FIELDS = ("property.asset_path", "property.component_asset_paths", *MATERIAL_FIELDS)
"""Fields that record which assets and materials an actor refers to."""
_MEMBERS = (
    ("location_cm", "transform.location", SAME_LOCATION_CM),
    ("rotation_deg", "transform.rotation", SAME_ROTATION_DEG),
    ("scale", "transform.scale", SAME_SCALE),
)


def _same_rotation(a: Any, b: Any, *, as_quaternion: bool) -> bool:
    if as_quaternion:
        p, q = valid_vector(a), valid_vector(b)
        if p is not None and q is not None:
            return angle_deg(p, q) <= SAME_ROTATION_DEG + GUARD
    return same_within(a, b, SAME_ROTATION_DEG)


def transform_differences(reference: Record, other: Record, *, as_quaternion: bool) -> list[str]:
    """Transform members of ``reference`` that ``other`` does not reproduce within round-trip noise.

    ``as_quaternion`` False compares raw Euler numbers, so that 180 and -180 degrees differ.
    """
    mine, theirs = reference.get("transform"), other.get("transform")
    if not isinstance(mine, dict) or (mine == theirs and surely_finite(mine)):
        return []
    theirs = theirs if isinstance(theirs, dict) else {}
    found = []
    for member, name, tolerance in _MEMBERS:
        if member not in mine:
            continue
        a, b = mine[member], theirs.get(member)
        same = (
            _same_rotation(a, b, as_quaternion=as_quaternion)
            if member == "rotation_deg"
            else same_within(a, b, tolerance)
        )
        if not same:
            found.append(name)
    return found


def surely_finite(transform: Record) -> bool:
    """A fast yes for a transform of lists of finite numbers. What is no number equals nothing, itself included."""
    vectors = list(transform.values())
    try:
        return set(map(type, vectors)) == {list} and isfinite(sum(map(sum, vectors)))
    except (TypeError, OverflowError):
        return False


def written(value: Any) -> str:
    """A recorded value as canonical text: 5000 and 5000.0 are written differently, NaN like NaN."""
    return json.dumps(value, sort_keys=True)


def _written_alike(a: Any, b: Any) -> bool:
    return (type(a) is type(b) and not a and not b) or written(a) == written(b)


def _visible(properties: Any) -> dict[str, Any]:
    if not isinstance(properties, dict):
        return {}
    return {key.lower(): value for key, value in properties.items() if key.lower() in VISIBLE_PROPERTIES}


def _same_or_empty(a: Any, b: Any) -> bool:
    return bool(a == b) or (not a and not b)


def property_differences(reference: Record, other: Record, *, target: bool) -> list[str]:
    """Recorded fields of ``reference``, transform and bounds aside, that ``other`` does not reproduce.

    Component assets, material slots and visible properties are compared as they are written.

    ``target`` True: classes may differ in their package, and only visible light, fog, sky and exposure properties
    count. False: the class must be equal as recorded, and the whole property dictionary too.
    """
    found = []
    if "class" in reference:
        a, b = reference["class"], other.get("class")
        if not _same_or_empty(a, b) and not (target and short_class(a) == short_class(b)):
            found.append("property.class")
    if "asset_path" in reference and not _same_or_empty(reference["asset_path"], other.get("asset_path")):
        found.append("property.asset_path")
    if "component_asset_paths" in reference and not _written_alike(
        reference["component_asset_paths"] or [], other.get("component_asset_paths") or []
    ):
        found.append("property.component_asset_paths")
    if "material_paths" in reference and comparable_materials(reference) != comparable_materials(other):
        found.append(MATERIAL_FIELDS[0])
    if "component_material_slots" in reference and not _written_alike(
        comparable_slots(reference), comparable_slots(other)
    ):
        found.append(MATERIAL_FIELDS[1])
    if "properties" in reference:
        mine, theirs = reference["properties"], other.get("properties")
        if not _written_alike(_visible(mine), _visible(theirs)) or not (target or mine == theirs):
            found.append("property.properties")
    return found


def target_differences(truth: Record, start: Record) -> list[str]:
    """Fields by which an actor of the input differs from the truth: a non-empty list makes it a repair target."""
    return transform_differences(truth, start, as_quaternion=False) + property_differences(truth, start, target=True)


def same_but_for_identity(truth: Record, start: Record) -> bool:
    """Whether two actors with different identities have identical content, so that neither is a target."""
    if "properties" in truth and truth["properties"] != start.get("properties"):
        return False
    return not transform_differences(truth, start, as_quaternion=True) and not property_differences(
        truth, start, target=True
    )


def changed_fields(start: Record, candidate: Record) -> list[str]:
    """Fields of the input actor that the candidate actor does not reproduce; empty means unchanged."""
    return transform_differences(start, candidate, as_quaternion=True) + property_differences(
        start, candidate, target=False
    )
