"""Support of edited actors in a city of 6,700: its base plate moved under all of them, and every actor edited.

What moved is probed by its own vertices or box, so the cost is that of the lines and of what they cross.

    python -m bench support
"""

from __future__ import annotations

import copy
import time
from typing import Any

import numpy as np

from bench.contacts import city
from bench.row import Row
from c4s.collision import scene_bodies
from c4s.protocol.settings import OUTDOOR_REPAIR, Setting
from c4s.verify.physics.verdict import measure_support

ACTORS, GOAL_S = 6_700, 5.0
SETTING: Setting = OUTDOOR_REPAIR


def plate(snapshot: dict[str, Any]) -> dict[str, Any]:
    """The city with the boxes of its actors, on a base plate that comes last."""
    scene = scene_bodies(snapshot)
    bodies: dict[int, list[Any]] = {}
    for body, owner in zip(scene.bodies, scene.owners, strict=True):
        bodies.setdefault(owner, []).append(body)
    actors = []
    for index, actor in enumerate(snapshot["actors"]):
        low = np.min([body.low for body in bodies[index]], axis=0)
        high = np.max([body.high for body in bodies[index]], axis=0)
        box = {"origin_cm": ((low + high) / 2).tolist(), "extent_cm": ((high - low) / 2).tolist()}
        actors.append(actor | {"stable_actor_id": f"id-{index}", "bounds": box})
    half = [60_000.0, 60_000.0, 10.0]
    place = {"location_cm": [0.0, 0.0, -10.0], "rotation_deg": [0.0, 0.0, 0.0], "scale": [1.0, 1.0, 1.0]}
    component = {
        "name": "Mesh",
        "class": "/Script/Engine.StaticMeshComponent",
        "mesh": "plate",
        "transform": place,
        "collision_enabled": True,
    }
    base = {
        "name": "Base",
        "label": "Base",
        "stable_actor_id": "base",
        "class": "/Script/Engine.StaticMeshActor",
        "component_asset_paths": ["plate"],
        "transform": place,
        "bounds": {"origin_cm": place["location_cm"], "extent_cm": half},
        "c4s": {"components": [component]},
    }
    facts = {
        "sha256": None,
        "bounds_min_cm": [-side for side in half],
        "bounds_max_cm": half,
        "collision": [{"kind": "box", "center": [0.0, 0.0, 0.0], "half_extent": half}],
    }
    meshes = {**snapshot["c4s"]["meshes"], "plate": facts}
    return {**snapshot, "actors": [*actors, base], "c4s": {**snapshot["c4s"], "meshes": meshes}}


def seconds(snapshot: dict[str, Any], start: dict[str, Any]) -> tuple[float, int]:
    """Processor time of one measurement, and how many actors it tested."""
    begin = time.process_time()
    record = measure_support(SETTING, snapshot, start)
    return time.process_time() - begin, len(record["rows"])


def rows() -> list[Row]:
    """Both under 5 s."""
    snapshot = plate(city(ACTORS)[0])
    start = copy.deepcopy(snapshot)
    start["actors"][-1]["transform"]["location_cm"][2] -= 50.0
    found = [
        ("base plate moved", *seconds(snapshot, start)),
        ("every actor edited", *seconds(snapshot, {"actors": []})),
    ]
    return [
        Row(f"support among {ACTORS} actors, {what} ({tested} tested)", spent, f"under {GOAL_S:g} s", spent < GOAL_S)
        for what, spent, tested in found
    ]
