"""Contacts and depths of a city of 6,700 actors: c4s against trimesh's CollisionManager, in one run.

``python -m bench.contacts [--actors N]`` prints one JSON object. Both start from nothing (c4s: the snapshot; trimesh:
the same convex bodies as meshes in world space). A sample of pairs is compared with the exact depth, from the Minkowski
difference of the two bodies.

Cold: the process has built no shape yet. Warm: the same process looks at the scene again after a tenth of the actors
has moved. Kept are the shapes alone (hulls under their scales); every pose, pair and depth is computed anew. CPU time
is given beside the clock, since another program on the machine changes only the latter.
"""

from __future__ import annotations

import argparse
import json
import time
from typing import Any

import numpy as np
from scipy.spatial import ConvexHull

from bench.row import Row
from c4s.collision import contacts
from c4s.collision.shape_cache import SHAPES
from c4s.geometry.transform import affine

MINIMUM_CM = 5.0
WRONG_CM, WRONG_SHARE = 0.05, 0.001
BOX = [[x, y, z] for x in (-50, 50) for y in (-50, 50) for z in (-50, 50)]


def city(actors: int, *, kinds: int = 60, seed: int = 3) -> tuple[dict[str, Any], list[np.ndarray]]:
    """A crowded plan of turned and scaled boxes and hulls: the snapshot, and each actor's world vertices."""
    rng = np.random.default_rng(seed)
    meshes: dict[str, Any] = {}
    local: dict[str, np.ndarray] = {}
    for kind in range(kinds):
        path = f"/Game/Bench/SM_{kind}.SM_{kind}"
        if kind % 2:
            local[path] = np.array(BOX, dtype=float)
            body: dict[str, Any] = {"kind": "box", "center": [0, 0, 0], "half_extent": [50, 50, 50]}
        else:
            local[path] = rng.normal(size=(40, 3))
            local[path] *= rng.uniform(40, 80) / np.linalg.norm(local[path], axis=1)[:, None]
            body = {"kind": "hull", "vertices": local[path].tolist()}
        meshes[path] = {"collision": [body]}
    side = 73.0 * actors**0.5
    records, world = [], []
    for n in range(actors):
        path = f"/Game/Bench/SM_{n % kinds}.SM_{n % kinds}"
        transform = {
            "location_cm": [*rng.uniform(0, side, 2).tolist(), 0.0],
            "rotation_deg": [0.0, float(rng.uniform(-180, 180)), 0.0] if n % 3 else rng.uniform(-180, 180, 3).tolist(),
            "scale": rng.choice([0.8, 1.0, 1.25], 3).tolist(),
        }
        records.append(
            {
                "name": f"A{n}",
                "c4s": {
                    "components": [
                        {
                            "name": "Mesh",
                            "class": "StaticMeshComponent",
                            "mesh": path,
                            "collision_enabled": True,
                            "transform": transform,
                        }
                    ]
                },
            }
        )
        matrix = affine(transform["location_cm"], transform["rotation_deg"], transform["scale"])
        world.append(local[path] @ matrix[:3, :3].T + matrix[:3, 3])
    return {"actors": records, "c4s": {"meshes": meshes}}, world


def moved(
    snapshot: dict[str, Any], world: list[np.ndarray], *, every: int = 10
) -> tuple[dict[str, Any], list[np.ndarray]]:
    """The scene after every tenth actor has moved half a metre."""
    step = np.array([50.0, 0.0, 0.0])
    records = list(snapshot["actors"])
    vertices = list(world)
    for n in range(0, len(records), every):
        component = records[n]["c4s"]["components"][0]
        place = component["transform"] | {"location_cm": (component["transform"]["location_cm"] + step).tolist()}
        records[n] = records[n] | {"c4s": {"components": [component | {"transform": place}]}}
        vertices[n] = world[n] + step
    return snapshot | {"actors": records}, vertices


def measured(snapshot: dict[str, Any]) -> tuple[dict[tuple[int, int], float], float, float]:
    """Depths of the contacts by pair of actors, seconds by the clock, and CPU seconds."""
    clock, cpu = time.perf_counter(), time.process_time()
    found = contacts(snapshot, minimum_depth_cm=MINIMUM_CM)
    clock, cpu = time.perf_counter() - clock, time.process_time() - cpu
    return {(c.a_index, c.b_index): c.depth_cm for c in found}, clock, cpu


def exact(a: np.ndarray, b: np.ndarray) -> float:
    """The exact penetration depth (cm) of two convex bodies."""
    return max(0.0, float(-ConvexHull((a[:, None] - b[None]).reshape(-1, 3)).equations[:, 3].max()))


def wrong(found: dict[tuple[int, int], float], world: list[np.ndarray], pairs: list[tuple[int, int]]) -> int:
    """How many of the pairs have a depth that is off by more than 0.05 cm and 0.1 %."""
    return sum(
        abs(found.get(pair, 0.0) - depth) > max(WRONG_CM, WRONG_SHARE * depth)
        for pair in pairs
        for depth in [exact(world[pair[0]], world[pair[1]])]
    )


def trimesh_contacts(world: list[np.ndarray]) -> dict[tuple[int, int], float]:
    """The deepest contact of each colliding pair by trimesh's CollisionManager."""
    import trimesh

    manager = trimesh.collision.CollisionManager()  # type: ignore[no-untyped-call]
    for n, vertices in enumerate(world):
        manager.add_object(str(n), trimesh.convex.convex_hull(vertices))  # type: ignore[no-untyped-call]
    _, data = manager.in_collision_internal(return_names=False, return_data=True)  # type: ignore[no-untyped-call]
    found: dict[tuple[int, int], float] = {}
    for contact in data:
        low, high = sorted(int(name) for name in contact.names)
        found[low, high] = max(found.get((low, high), 0.0), float(contact.depth))
    return found


def run(actors: int = 6700, sample: int = 300) -> dict[str, Any]:
    """Measure ours cold and warm and the rival, and check a sample of the pairs of each."""
    snapshot, world = city(actors)
    again, world_again = moved(snapshot, world)
    SHAPES.clear()
    ours, our_seconds, our_cpu = measured(snapshot)
    warm, warm_seconds, warm_cpu = measured(again)
    start = time.perf_counter()
    theirs = trimesh_contacts(world)
    rival_seconds = time.perf_counter() - start
    rng = np.random.default_rng(0)
    picked, picked_warm, rivals = (
        [pairs[i] for i in rng.permutation(len(pairs))[:sample].tolist()]
        for pairs in (sorted(ours), sorted(warm), sorted(theirs))
    )
    return {
        "work": "contacts and depths",
        "actors": actors,
        "seconds": round(our_seconds, 3),
        "cpu_seconds": round(our_cpu, 3),
        "contacts_over_5_cm": len(ours),
        "wrong": f"{wrong(ours, world, picked)} of {len(picked)}",
        "warm_seconds": round(warm_seconds, 3),
        "warm_cpu_seconds": round(warm_cpu, 3),
        "warm_contacts": len(warm),
        "warm_wrong": f"{wrong(warm, world_again, picked_warm)} of {len(picked_warm)}",
        "rival": "trimesh CollisionManager",
        "rival_seconds": round(rival_seconds, 3),
        "rival_contacts": len(theirs),
        "rival_wrong": f"{wrong(theirs, world, rivals)} of {len(rivals)}",
        "times_faster": round(rival_seconds / our_seconds, 1),
        "times_faster_warm": round(rival_seconds / warm_seconds, 1),
    }


def rows() -> list[Row]:
    """Cold against 5 times faster and under 3 s, warm under 1 s, with every sampled depth exact."""
    found = run()
    return [
        Row(
            f"contacts and depths, {found['actors']} actors ({found['wrong']} wrong; rival {found['rival_wrong']})",
            found["seconds"],
            "5x, under 3 s, exact",
            found["times_faster"] >= 5 and found["seconds"] < 3 and found["wrong"].startswith("0 of"),
            rival=found["rival"],
            theirs=found["rival_seconds"],
            ratio=found["times_faster"],
        ),
        Row(
            f"  again, a tenth of the actors moved, shapes kept ({found['warm_wrong']} wrong)",
            found["warm_seconds"],
            "5x, under 1 s, exact",
            found["times_faster_warm"] >= 5 and found["warm_seconds"] < 1 and found["warm_wrong"].startswith("0 of"),
            rival=found["rival"],
            theirs=found["rival_seconds"],
            ratio=found["times_faster_warm"],
        ),
    ]


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--actors", type=int, default=6700)
    print(json.dumps(run(parser.parse_args().actors), indent=1))
