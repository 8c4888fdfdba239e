"""A made scene for the repair benchmark: many actors in a grid of a few dozen kinds, and a number of edits."""

from __future__ import annotations

import random
from copy import deepcopy
from typing import Any


def _actor(n: int, rng: random.Random, kinds: int) -> dict[str, Any]:
    kind = rng.randrange(kinds)
    mesh = f"/Game/Bench/Meshes/SM_Kind{kind:02d}.SM_Kind{kind:02d}"
    material = f"/Game/Bench/Materials/M_Kind{kind:02d}.M_Kind{kind:02d}"
    place = [round(rng.uniform(-20000, 20000), 3), round(rng.uniform(-20000, 20000), 3), round(rng.uniform(0, 300), 3)]
    return {
        "stable_actor_id": f"sca_source_{rng.getrandbits(128):032x}",
        "actor_guid": f"{rng.getrandbits(128):032X}",
        "actor_origin": "source",
        "logical_object_id": None,
        "actor_role": None,
        "attachment_parent_path": None,
        "attachment_parent_label": None,
        "label": f"SM_Kind{kind:02d}_{n}",
        "name": f"StaticMeshActor_{n}",
        "actor_path": f"/Game/Bench/Input.Input:PersistentLevel.StaticMeshActor_{n}",
        "class": "/Script/Engine.StaticMeshActor",
        "asset_path": mesh,
        "asset_category": None,
        "component_asset_paths": [mesh],
        "material_paths": [material],
        "component_material_slots": [
            {
                "component_identity": "StaticMeshComponent0|/Script/Engine.StaticMeshComponent",
                "slot_index": 0,
                "material_path": material,
                "material_class_path": "/Script/Engine.Material",
                "is_dynamic": False,
            }
        ],
        "actor_tags": [],
        "collision": {
            "collision_enabled": True,
            "primitive_component_count": 1,
            "collision_enabled_component_count": 1,
            "collision_enabled_components": [],
        },
        "transform": {
            "location_cm": place,
            "rotation_deg": [0.0, round(rng.uniform(-180, 180), 4), 0.0],
            "scale": [1.0, 1.0, 1.0],
        },
        "bounds": {"origin_cm": [place[0], place[1], place[2] + 50], "extent_cm": [50.0, 50.0, 50.0]},
        "properties": {},
        "export_diagnostics": {"component_classes": ["/Script/Engine.StaticMeshComponent"]},
        "export_errors": [],
    }


def _edited(actors: list[dict[str, Any]], indices: list[int], rng: random.Random) -> list[dict[str, Any]]:
    """The actors with the named ones moved, turned, scaled, re-meshed or deleted, by turns."""
    scene = deepcopy(actors)
    gone = set()
    for turn, n in enumerate(indices):
        actor, pose = scene[n], scene[n]["transform"]
        edit = turn % 5
        if edit == 0:
            pose["location_cm"][0] += rng.uniform(20, 400)
        elif edit == 1:
            pose["rotation_deg"][1] += 35.0
        elif edit == 2:
            pose["scale"] = [1.4, 1.4, 1.4]
        elif edit == 3:
            actor["asset_path"] = "/Game/Bench/Meshes/SM_Wrong.SM_Wrong"
            actor["component_asset_paths"] = [actor["asset_path"]]
        else:
            gone.add(n)
    return [actor for n, actor in enumerate(scene) if n not in gone]


def scenes(actors: int, edits: int, *, kinds: int = 40, seed: int = 1) -> dict[str, dict[str, Any]]:
    """Snapshots ``input``, ``truth`` and ``candidate``: half of the corruptions repaired, and as much new damage."""
    rng = random.Random(seed)
    truth = [_actor(n, rng, kinds) for n in range(actors)]
    touched = rng.sample(range(actors), edits + edits // 2)
    start = _edited(truth, touched[:edits], rng)
    rng_candidate = random.Random(seed + 1)
    candidate = _edited(truth, touched[edits // 2 :], rng_candidate)
    rng_candidate.shuffle(candidate)
    for n, actor in enumerate(candidate):
        actor["stable_actor_id"] = f"sca_agent_{n:032x}"
    return {
        name: {
            "schema_version": "0.3.0",
            "snapshot_type": "ue_editor_scene",
            "units": "cm",
            "actor_count": len(scene),
            "actors": scene,
            "export_metadata": {"status": "success"},
        }
        for name, scene in (("input", start), ("truth", truth), ("candidate", candidate))
    }
