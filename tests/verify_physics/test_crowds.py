"""Scenes with hundreds of actors at one point: the same verdict as from all of their contacts, of bounded size."""

from __future__ import annotations

from typing import Any

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from c4s.collision import scene_bodies, scene_contacts
from c4s.verify.physics.verdict import MOST_LISTED, verify_physics

KINDS = {
    "box": [{"kind": "box", "center": [0, 0, 0], "half_extent": [20, 30, 40]}],
    "ball": [{"kind": "sphere", "center": [0, 0, 0], "radius": 25}],
    "ice": [{"kind": "hull", "vertices": [[0, 0, 0], [40, 0, 0], [0, 40, 0], [0, 0, 60], [30, 30, 30]]}],
}


def crowd(seed: int, count: int, spread_cm: float) -> dict[str, Any]:
    rng = np.random.default_rng(seed)
    actors = []
    for n in range(count):
        kind = str(rng.choice(list(KINDS)))
        transform = {
            "location_cm": (rng.normal(size=3) * spread_cm + (0, 0, 100)).tolist(),
            "rotation_deg": rng.uniform(-180, 180, 3).tolist(),
            "scale": [1.0, 1.0, 1.0],
        }
        actors.append(
            {
                "name": f"A{n}",
                "label": f"A{n}",
                "class": "/Script/Engine.StaticMeshActor",
                "asset_path": kind,
                "component_asset_paths": [kind],
                "transform": transform,
                "logical_object_id": [None, "table", "chair"][int(rng.integers(3))],
                "collision": {"collision_enabled": bool(rng.random() > 0.2)},
                "bounds": {"origin_cm": transform["location_cm"], "extent_cm": rng.uniform(20, 300, 3).tolist()},
                "c4s": {
                    "components": [
                        {
                            "name": "Mesh",
                            "class": "/Script/Engine.StaticMeshComponent",
                            "mesh": kind,
                            "transform": transform,
                            "collision_enabled": True,
                        }
                    ]
                },
            }
        )
    return {
        "schema_version": "0.3.0",
        "units": "cm",
        "actors": actors,
        "c4s": {"engine": "headless", "meshes": {kind: {"collision": body} for kind, body in KINDS.items()}},
    }


@settings(max_examples=15)
@given(st.integers(0, 2**32 - 1), st.sampled_from([0.0, 2.0, 20.0, 60.0]), st.integers(50, 220))
def test_the_verdict_is_that_of_all_contacts(seed: int, spread_cm: float, count: int) -> None:
    scene = crowd(seed, count, spread_cm)
    every = scene_contacts(scene, scene_bodies(scene), minimum_depth_cm=5.0)
    found, wanted = (verify_physics("text-to-scene", scene, contacts=contacts) for contacts in (None, every))
    assert found.score == wanted.score
    states = [
        [(row["actor"], row["state"], row["tolerance_cm"]) for row in verdict.measurements["leaf_results"][1]["actors"]]
        for verdict in (found, wanted)
    ]
    assert states[0] == states[1]


def test_a_thousand_copies_make_a_short_verdict() -> None:
    scene = crowd(7, 1000, 0.0)
    for actor in scene["actors"]:
        actor |= {"logical_object_id": None, "collision": {"collision_enabled": True}}
    leaf = verify_physics("text-to-scene", scene).measurements["leaf_results"][1]
    assert leaf["failed"] == len(scene["actors"])
    for row in leaf["actors"]:
        assert len(row["contacts"]) == MOST_LISTED < row["contacts_found"]
