"""Whose collision is switched off although there is something to collide with."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any


def bodied_meshes(snapshot: Mapping[str, Any]) -> set[str]:
    """The meshes of a snapshot that have collision bodies."""
    extra = snapshot.get("c4s")
    meshes = extra.get("meshes") if isinstance(extra, Mapping) else None
    return {path for path, facts in (meshes or {}).items() if isinstance(facts, Mapping) and facts.get("collision")}


def is_switched_off(actor: Mapping[str, Any], bodied: set[str]) -> bool:
    """Whether an actor of such a mesh collides with nothing."""
    collision = actor.get("collision")
    off = isinstance(collision, Mapping) and collision.get("collision_enabled") is False
    return off and not bodied.isdisjoint(map(str, actor.get("component_asset_paths") or []))
