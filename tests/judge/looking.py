"""A probe for the pure planner: what cameras see of a snapshot's boxes when nothing is in the way."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from c4s.geometry.transform import rotation_matrix
from c4s.semantics.inventory import Thing, inventory

Scene = dict[str, Any]


def actor(name: str, origin: Sequence[float], extent: Sequence[float], **more: Any) -> dict[str, Any]:
    """An actor of one mesh, as a snapshot without components has it."""
    return {
        "name": name,
        "asset_path": f"/Game/P/{name.split('_')[0]}",
        "component_asset_paths": [f"/Game/P/{name.split('_')[0]}"],
        "bounds": {"origin_cm": list(origin), "extent_cm": list(extent)},
        **more,
    }


def scene(actors: Sequence[dict[str, Any]]) -> Scene:
    """A snapshot of actors."""
    return {"actors": list(actors)}


def unhidden(snapshot: Scene) -> Any:
    """A probe of a snapshot: each thing before the camera has the pixels of a ball of its size."""
    things = inventory(snapshot, {})

    def probe(cameras: Sequence[Mapping[str, Any]]) -> list[dict[str, Any]]:
        return [_glimpse(camera, things) for camera in cameras]

    return probe


def _glimpse(camera: Mapping[str, Any], things: Sequence[Thing]) -> dict[str, Any]:
    assert all(math.isfinite(v) for v in (*camera["location_cm"], *camera["rotation_deg"], camera["fov_deg"]))
    turn = rotation_matrix(camera["rotation_deg"])
    across = math.tan(math.radians(camera["fov_deg"]) / 2)
    visible: dict[str, int] = {}
    edge = set()
    for thing in things:
        ahead, *aside = ((thing.centre - camera["location_cm"]) @ turn).tolist()
        x, y = (abs(v) / max(ahead, 1.0) / across for v in (aside[0], aside[1] * 16 / 9))
        if ahead <= 1 or max(x, y) > 1:
            continue
        radius = float(np.linalg.norm(thing.high - thing.low)) / 2 / ahead / across * camera["width"] / 2
        if pixels := int(min(3.0 * radius * radius, camera["width"] * camera["height"])):
            visible[thing.actor] = visible.get(thing.actor, 0) + pixels
        if max(x, y) > 0.97:
            edge.add(thing.actor)
    return {"visible": visible, "edge": sorted(edge), "near_share": 0.0, "empty_share": 0.5}
