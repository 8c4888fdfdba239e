"""Small scenes for the repair tests, in the published snapshot form."""

from __future__ import annotations

from copy import deepcopy
from typing import Any

Scene = dict[str, Any]


def actor(label: str, kind: str, place: tuple[float, float, float], yaw: float = 0.0, scale: float = 1.0) -> Scene:
    mesh = f"/Game/Room/SM_{kind}.SM_{kind}"
    material = f"/Game/Room/M_{kind}.M_{kind}"
    return {
        "stable_actor_id": f"id_{label}",
        "label": label,
        "class": "/Script/Engine.StaticMeshActor",
        "asset_path": mesh,
        "component_asset_paths": [mesh],
        "material_paths": [material],
        "component_material_slots": [
            {
                "component_identity": "StaticMeshComponent0|StaticMeshComponent",
                "slot_index": 0,
                "material_path": material,
                "material_class_path": "/Script/Engine.Material",
                "is_dynamic": False,
            }
        ],
        "transform": {"location_cm": list(place), "rotation_deg": [0.0, yaw, 0.0], "scale": [scale] * 3},
        "bounds": {"origin_cm": list(place), "extent_cm": [10.0 * abs(scale)] * 3},
        "properties": {},
    }


def scene(*actors: Scene) -> Scene:
    return {
        "schema_version": "0.3.0",
        "units": "cm",
        "actor_count": len(actors),
        "actors": deepcopy(list(actors)),
        "export_metadata": {"status": "success"},
    }


def renamed(given: Scene, salt: str) -> Scene:
    """The same scene with new ids and labels."""
    result = deepcopy(given)
    for n, record in enumerate(result["actors"]):
        record["stable_actor_id"], record["label"] = f"{salt}_{n}", f"{salt} {n}"
    return result


def without(given: Scene, *labels: str) -> Scene:
    return scene(*(record for record in given["actors"] if record["label"] not in labels))


def moved(given: Scene, label: str, dx: float) -> Scene:
    result = deepcopy(given)
    for record in result["actors"]:
        if record["label"] == label:
            record["transform"]["location_cm"][0] += dx
            record["bounds"]["origin_cm"][0] += dx
    return result


def with_actor(given: Scene, *extra: Scene) -> Scene:
    return scene(*given["actors"], *extra)
