"""Bodies of a scene: what is known, what is not, what is kept between scenes; and the order of actors."""

from __future__ import annotations

import copy
from typing import Any

import numpy as np
import pytest
from collision_scenes import actor, cube, scene
from hypothesis import given, settings
from hypothesis import strategies as st

from c4s.collision import contacts, scene_bodies
from c4s.collision.mesh_body import MeshBody
from c4s.collision.shape_cache import ShapeCache

NAN, INF = float("nan"), float("inf")
POINT, LINE = [[5, 5, 5]] * 4, [[0, 0, 0], [10, 20, 30], [20, 40, 60], [10, 20, 30]]


def hull(vertices: Any) -> list[dict[str, Any]]:
    return [{"kind": "hull", "vertices": vertices}]


def crowd(seed: int, count: int = 24) -> dict[str, Any]:
    """Boxes and hulls, a sphere and a capsule among them, close together."""
    rng = np.random.default_rng(seed)
    meshes = {
        "box": cube(),
        "hull": hull((rng.normal(size=(12, 3)) * 40).tolist()),
        "ball": [{"kind": "sphere", "center": [0, 0, 0], "radius": 45}],
        "cap": [{"kind": "capsule", "center": [0, 0, 0], "radius": 20, "length": 70}],
    }
    return scene(
        meshes,
        *(
            actor(
                f"A{n}",
                ("box", "hull", "ball", "cap")[n % 4],
                rng.uniform(-150, 150, 3),
                rng.uniform(-180, 180, 3),
                rng.choice([-1, 1], 3) * rng.uniform(0.5, 1.5),
            )
            for n in range(count)
        ),
    )


@settings(max_examples=25, deadline=None)
@given(st.integers(0, 10_000), st.randoms(use_true_random=False))
def test_the_order_of_actors_changes_no_digit(seed, random):
    snapshot = crowd(seed)
    found = {frozenset((c.a, c.b)): (c.depth_cm, c.trusted) for c in contacts(snapshot)}
    random.shuffle(snapshot["actors"])
    assert {frozenset((c.a, c.b)): (c.depth_cm, c.trusted) for c in contacts(snapshot)} == found
    assert len(found) > 10


@pytest.mark.parametrize("vertices", [[], POINT, LINE, [[0, 0, 0], [1, 0, 0]], [[1e-300, 0, 0]] * 5])
def test_a_mesh_without_area_has_no_body(vertices):
    found = scene_bodies(scene({"m": hull(vertices)}, actor("A", "m")))
    assert (found.bodies, found.unresolved) == ([], {})


def test_doubled_vertices_and_inner_points_change_nothing():
    corners = [[x, y, z] for x in (-50, 50) for y in (-50, 50) for z in (-50, 50)]
    meshes = {"m": hull(corners * 3 + [[0, 0, 0], [10, 20, -30], [50, 0, 0], [50, 50, 0]]), "box": cube()}
    found = contacts(scene(meshes, actor("A", "box"), actor("B", "m", (93, 0, 0))))
    assert [c.depth_cm for c in found] == [pytest.approx(7.0)]


@pytest.mark.parametrize(
    "body",
    [
        {"kind": "hull", "vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, NAN]]},
        {"kind": "hull", "vertices": None},
        {"kind": "hull", "vertices": [[0, 0], [1, 0], [0, 1]]},
        {"kind": "hull", "vertices": [[0, 0, "1"]]},
        {"kind": "hull", "vertices": [[-1.7e308, 0, 0], [1.7e308, 0, 0], [0, 1, 0], [0, 0, 1]]},
        {"kind": "sphere", "center": [0, 0, 0], "radius": NAN},
        {"kind": "sphere", "center": [0, 0, 0]},
        {"kind": "capsule", "center": [0, 0, 0], "radius": 5, "length": INF},
        {"kind": "box", "center": [0, 0, NAN], "half_extent": [1, 1, 1]},
        {"kind": "box", "center": [0, 0, 0], "half_extent": [1, True, 1]},
        {"kind": "box", "center": [0, 0, 0], "half_extent": [1, 1, 1], "rotation_deg": [0, INF, 0]},
        {"kind": "cone"},
        "box",
        None,
        7,
        {},
    ],
)
def test_a_broken_body_leaves_its_actor_unresolved(body):
    found = scene_bodies(scene({"bad": [*cube(), body], "good": cube()}, actor("A", "bad"), actor("B", "good")))
    assert (found.owners, list(found.unresolved)) == ([1], [0])
    assert "A" not in {name for c in contacts(scene({"m": [body]}, actor("A", "m"))) for name in (c.a, c.b)}


@pytest.mark.parametrize(
    "change",
    [
        {"location_cm": [0, NAN, 0]},
        {"location_cm": None},
        {"scale": [1, INF, 1]},
        {"scale": [1, 1]},
        {"scale": ["1", "1", "1"]},
        {"rotation_deg": None},
        {"rotation_deg": [0, NAN, 0]},
        {"quaternion_xyzw": [0, 0, 0, 0]},
        {"quaternion_xyzw": [0, 0, NAN, 1]},
        {"quaternion_xyzw": [0, 0, 1]},
        {"scale": [1e308, 1e308, 1e308]},
        {"location_cm": [10**400, 0, 0]},
    ],
)
@pytest.mark.parametrize("mesh", ["box", "hull"])
def test_a_broken_transform_leaves_its_actor_unresolved(change, mesh):
    meshes = {"box": cube(), "hull": hull([[0, 0, 0], [50, 0, 0], [0, 50, 0], [0, 0, 50]])}
    bad = actor("A", mesh)
    bad["c4s"]["components"][0]["transform"] = bad["transform"] | change
    found = scene_bodies(scene(meshes, bad, actor("B", "box")))
    assert (found.owners, list(found.unresolved)) == ([1], [0])


@pytest.mark.parametrize(
    "components",
    [
        [None],
        ["x"],
        [{"mesh": "box", "collision_enabled": True}],
        [{"mesh": ["box"], "collision_enabled": True, "transform": {}}],
        "none",
    ],
)
def test_broken_components_leave_their_actor_unresolved(components):
    broken = actor("A", "box") | {"c4s": {"components": components}}
    assert list(scene_bodies(scene({"box": cube()}, broken)).unresolved) == [0]


def test_a_quaternion_of_any_length_is_a_rotation():
    turned = actor("B", "box", (110, 0, 0))
    turned["c4s"]["components"][0]["transform"] = turned["transform"] | {"quaternion_xyzw": [0, 0, 7, 7 * 2**0.5 + 7]}
    found = contacts(scene({"box": cube()}, actor("A", "box"), turned))
    assert [c.depth_cm for c in found] == [pytest.approx(50 + 50 * 2**0.5 - 110, abs=1e-6)]


def test_a_second_look_after_actors_moved_is_right():
    first = crowd(1)
    moved = copy.deepcopy(first)
    for n in (2, 5, 11):
        moved["actors"][n]["transform"]["location_cm"][0] += 60.0
        moved["actors"][n]["transform"]["scale"] = [1.3, 0.7, -1.1]
    before = contacts(first)
    after = contacts(moved)
    assert after != before and contacts(first) == before
    renamed = copy.deepcopy(moved)
    renamed["c4s"]["meshes"] = {
        name: hull([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]) for name in moved["c4s"]["meshes"]
    }
    assert contacts(renamed) == [] and contacts(moved) == after


def test_the_cache_drops_what_was_not_used_for_longest():
    cache = ShapeCache(most_corners=80)
    bodies = [MeshBody("box", size=(float(n), 1.0, 1.0)) for n in range(1, 30)]
    kept = cache.shape(bodies[0], (1.0, 1.0, 1.0))
    for body in bodies[1:]:
        cache.shape(body, (1.0, 1.0, 1.0))
        assert cache.shape(bodies[0], (1.0, 1.0, 1.0)) is kept
        assert len(cache) <= 10
    assert cache.shape(bodies[0], (2.0, 1.0, 1.0)) is not kept
