"""What is wrong with a snapshot: what the published schema (0.3.x) asks of every scene, whoever exported it.

It asks less than the exporter writes (``c4s.records.snapshot``): the fields by which actors are selected and measured.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import orjson
from pydantic import ValidationError

from c4s.records.snapshot import SCHEMA_VERSION, SceneSnapshot

_SERIES = SCHEMA_VERSION.rpartition(".")[0] + "."
_TRANSFORM = ("location_cm", "rotation_deg", "scale")
_BOUNDS = ("origin_cm", "extent_cm")
_OPTIONAL_TEXTS = ("actor_path", "stable_actor_id", "logical_object_id")


def _text(value: Any) -> bool:
    return isinstance(value, str) and bool(value)


def _triplet(value: Any) -> bool:
    try:
        return (
            isinstance(value, list)
            and len(value) == 3
            and all(isinstance(v, (int, float)) and not isinstance(v, bool) and math.isfinite(v) for v in value)
        )
    except OverflowError:
        return False


def _slot_fault(slots: Any) -> str:
    if not isinstance(slots, list):
        return "component_material_slots is no list"
    seen: set[tuple[str, int]] = set()
    for slot in slots:
        if not isinstance(slot, Mapping):
            return "a material slot is not an object"
        owner, index, path = slot.get("component_identity"), slot.get("slot_index"), slot.get("material_path")
        if not isinstance(owner, str) or not owner:
            return "a material slot has no component_identity"
        if isinstance(index, bool) or not isinstance(index, int) or index < 0:
            return f"material slot index {index!r} is no index"
        if (owner, index) in seen:
            return f"material slot {index} of {owner} is there twice"
        seen.add((owner, index))
        if path is not None and not _text(path):
            return "a material_path is neither a path nor null"
        if not isinstance(slot.get("is_dynamic"), bool):
            return "a material slot does not say whether it is dynamic"
    return ""


def snapshot_fault(snapshot: Any) -> str:
    """What is wrong with a snapshot: its version, its units, or its actors; an empty string when nothing is."""
    if not isinstance(snapshot, Mapping):
        return "the snapshot is not an object"
    version = snapshot.get("schema_version")
    if not isinstance(version, str) or not version.startswith(_SERIES):
        return f"schema_version is {version!r}, not {_SERIES}x"
    if snapshot.get("units") != "cm":
        return f"units are {snapshot.get('units')!r}, not 'cm'"
    return scene_fault(snapshot)


def export_fault(snapshot: Any) -> str:
    """What is wrong with a snapshot that the exporter should have written; an empty string when nothing is.

    It asks for all that the exporter writes, in its types, beside what ``snapshot_fault`` asks.
    """
    try:
        SceneSnapshot.model_validate_json(orjson.dumps(snapshot), strict=True)
    except ValidationError as error:
        first = error.errors(include_input=False, include_url=False, include_context=False)[0]
        return f"{'.'.join(str(part)[:60] for part in first['loc'][:8])}: {first['msg'][:200]}"
    return snapshot_fault(snapshot)


def scene_fault(snapshot: Any) -> str:
    """What is wrong with a snapshot's actors, or an empty string.

    Label and class are texts; location and bounds (cm), rotation (degrees) and scale are three finite numbers each;
    ids, tags, properties and material slots are well-formed where they are given; a declared count is the count.
    """
    if not isinstance(snapshot, Mapping):
        return "the snapshot is not an object"
    actors = snapshot.get("actors")
    if not isinstance(actors, list):
        return "there is no list of actors"
    declared = snapshot.get("actor_count")
    if declared is not None and (
        isinstance(declared, bool) or not isinstance(declared, int) or declared != len(actors)
    ):
        return f"actor_count is {declared!r} but there are {len(actors)} actors"
    return next((fault for number, actor in enumerate(actors) if (fault := _actor_fault(number, actor))), "")


def _actor_fault(number: int, actor: Any) -> str:
    if not isinstance(actor, Mapping):
        return f"actor {number} is not an object"
    for field in ("label", "class"):
        if not _text(actor.get(field)):
            return f"actor {number} has no {field}"
    where = f"actor {number} ({actor['label']})"
    for field in _OPTIONAL_TEXTS:
        if actor.get(field) is not None and not _text(actor[field]):
            return f"{where}: {field} is no text"
    tags = actor.get("actor_tags")
    if tags is not None and not (isinstance(tags, list) and all(map(_text, tags))):
        return f"{where}: actor_tags is no list of texts"
    for section, members in (("transform", _TRANSFORM), ("bounds", _BOUNDS)):
        value = actor.get(section)
        if not isinstance(value, Mapping):
            return f"{where} has no {section}"
        for member in members:
            if not _triplet(value.get(member)):
                return f"{where}: {section}.{member} is not three finite numbers"
    if actor.get("properties") is not None and not isinstance(actor["properties"], Mapping):
        return f"{where}: properties is no object"
    slots = actor.get("component_material_slots")
    fault = _slot_fault(slots) if slots is not None else ""
    return f"{where}: {fault}" if fault else ""
