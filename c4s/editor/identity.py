"""Who an actor is, told by tags, names and assets as in the published exporter. Runs inside an engine: stdlib only."""

from __future__ import annotations

import hashlib
import json
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

GENERATED_PREFIX = "sca_generated_"
EXPLICIT = "explicit_tag"
GENERATED = "generated_structural_identity"
SEPARATED = "generated_structural_identity_disambiguated_by_actor_scope"
ALGORITHM = {
    "prefix": GENERATED_PREFIX,
    "hash": "sha256-first-128-bits",
    "canonical_json": "sort_keys=True,separators=(',', ':')",
    "identity_fields": ["actor_name", "class_path", "sorted_unique_component_asset_paths"],
    "collision_disambiguator": "normalized_owning_level_scope_only_when_needed",
}
"""How ids are generated, in the published words."""

ID_TAG = "simcodearena.stable_actor_id"
ORIGIN_TAG = "simcodearena.actor_origin"
_KEYS = {
    "stable_actor_id": (ID_TAG, "stable_actor_id"),
    "actor_origin": (ORIGIN_TAG, "actor_origin"),
    "logical_object_id": ("simcodearena.logical_object_id", "logical_object_id"),
    "actor_role": ("simcodearena.actor_role", "actor_role"),
    "asset_category": (
        "simcodearena.semantic_category",
        "simcodearena.asset_category",
        "semantic_category",
        "asset_category",
        "category",
    ),
}
_ROOT = "$ROOT_LEVEL"
_LEVEL = ":PersistentLevel."


def tag_values(tags: Iterable[str]) -> dict[str, str]:
    """``key=value`` tags: keys without case, both without blanks around them; of equal keys the last counts."""
    found = {}
    for tag in tags:
        key, equals, value = tag.partition("=")
        if equals:
            found[key.strip().lower()] = value.strip()
    return found


def told(values: Mapping[str, str], field: str) -> str | None:
    """What the tags say of a field: the first of its keys that has a value."""
    for key in _KEYS[field]:
        if values.get(key):
            return values[key]
    return None


def doubles(tagged: Sequence[tuple[str, Sequence[str]]]) -> list[str]:
    """Labels of actors whose id tag another one has too, 20 at most, of (label, tags) pairs."""
    named = [(label, told(tag_values(tags), "stable_actor_id")) for label, tags in tagged]
    shared = Counter(own for _, own in named)
    return [label for label, own in named if own and shared[own] > 1][:20]


def _digest(signature: Mapping[str, Any]) -> str:
    canonical = json.dumps(signature, sort_keys=True, separators=(",", ":"))
    return GENERATED_PREFIX + hashlib.sha256(canonical.encode()).hexdigest()[:32]


def generated_id(name: str, class_path: str, asset_paths: Iterable[str]) -> str:
    """The id of an actor without an id tag, from its object name, class and component assets."""
    return _digest({"actor_name": name, "class_path": class_path, "component_asset_paths": sorted(set(asset_paths))})


def _scope(actor_path: str, level: str) -> str:
    """The level that owns an actor; the root level of a map goes by one name, whatever the map is called."""
    owner, inside, _ = actor_path.partition(_LEVEL)
    return _ROOT if inside and owner.split(".", 1)[0] == level else owner


def separate(actors: Sequence[dict[str, Any]], level: str) -> None:
    """Tell actors under one generated id apart by the level that owns them.

    Actors that this cannot tell apart, and copies of a tagged actor, keep the one id: the verifiers say so.
    """
    groups: dict[str, list[dict[str, Any]]] = {}
    for actor in actors:
        groups.setdefault(actor["stable_actor_id"], []).append(actor)
    for shared, group in groups.items():
        scopes = [_scope(actor["actor_path"], level) for actor in group]
        if len(set(scopes)) < max(2, len(group)) or any(
            actor["export_diagnostics"]["stable_actor_id_provenance"] == EXPLICIT for actor in group
        ):
            continue
        for actor, scope in zip(group, scopes, strict=True):
            actor["stable_actor_id"] = _digest({"base_stable_actor_id": shared, "actor_scope": scope})
            actor["export_diagnostics"] |= {
                "stable_actor_id_provenance": SEPARATED,
                "stable_actor_id_base": shared,
                "stable_actor_scope": scope,
            }
