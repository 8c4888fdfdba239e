"""Contacts against the exact minimum translation from the Minkowski difference."""

from __future__ import annotations

import math

import numpy as np
import pytest
from collision_scenes import actor, cube, scene
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial import ConvexHull

from c4s.collision import contacts, scene_bodies
from c4s.geometry.transform import affine
from tests.work import calls_in, peak_bytes_of

CORNERS = np.array([[x, y, z] for x in (-50, 50) for y in (-50, 50) for z in (-50, 50)], dtype=float)


def hull(vertices) -> list[dict]:
    return [{"kind": "hull", "vertices": np.asarray(vertices).tolist()}]


def exact_depth(a: np.ndarray, b: np.ndarray) -> float:
    """Smallest distance from the origin to the border of the Minkowski difference; 0 outside."""
    planes = ConvexHull((a[:, None] - b[None]).reshape(-1, 3)).equations
    return max(0.0, float(-planes[:, 3].max()))


def depth(*actors, meshes) -> float:
    found = contacts(scene(meshes, *actors))
    assert all(contact.trusted for contact in found)
    return max((contact.depth_cm for contact in found), default=0.0)


def world(vertices, location, rotation, scale) -> np.ndarray:
    return np.asarray(vertices) @ affine(location, rotation, scale)[:3, :3].T + np.asarray(location, dtype=float)


@pytest.mark.parametrize("seed", range(60))
def test_random_hulls_equal_the_minkowski_difference(seed):
    rng = np.random.default_rng(seed)
    local = [rng.normal(size=(int(rng.integers(4, 20)), 3)) * rng.uniform(5, 80, 3) for _ in range(2)]
    poses = [
        (
            rng.uniform(-40, 40, 3) + (seed % 3) * 1e5,
            rng.uniform(-180, 180, 3),
            rng.uniform(0.2, 3, 3) * rng.choice([-1, 1], 3),
        )
        for _ in range(2)
    ]
    meshes = {"a": hull(local[0]), "b": hull(local[1])}
    found = depth(actor("A", "a", *poses[0]), actor("B", "b", *poses[1]), meshes=meshes)
    shift = poses[0][0]
    true = exact_depth(*(world(v, p[0] - shift, p[1], p[2]) for v, p in zip(local, poses, strict=True)))
    assert found == pytest.approx(true, abs=1e-5)


@settings(max_examples=60, deadline=None)
@given(st.lists(st.floats(-120, 120), min_size=3, max_size=3), st.lists(st.floats(0.1, 3), min_size=3, max_size=3))
def test_axis_aligned_boxes_are_exact(offset, scale):
    found = depth(actor("A", "box"), actor("B", "box", offset, scale=scale), meshes={"box": cube()})
    true = min(50 + 50 * s - abs(o) for o, s in zip(offset, scale, strict=True))
    assert found == pytest.approx(max(true, 0.0), abs=1e-6)


@settings(max_examples=60, deadline=None)
@given(
    st.tuples(*[st.floats(-180, 180)] * 3),
    st.tuples(*[st.floats(-80, 80)] * 3),
    st.tuples(*[st.floats(0.2, 2)] * 3),
    st.sampled_from([1, -1]),
)
def test_turned_scaled_and_mirrored_boxes(rotation, offset, scale, mirror):
    scale = (scale[0] * mirror, *scale[1:])
    body = [{"kind": "box", "center": [10, 0, 5], "rotation_deg": [0, 30, 0], "half_extent": [20, 30, 40]}]
    found = depth(actor("A", "box"), actor("B", "body", offset, rotation, scale), meshes={"box": cube(), "body": body})
    corners = (CORNERS / 50 * [20, 30, 40]) @ affine((0, 0, 0), (0, 30, 0), (1, 1, 1))[:3, :3].T + [10, 0, 5]
    assert found == pytest.approx(exact_depth(CORNERS, world(corners, offset, rotation, scale)), abs=1e-5)


@pytest.mark.parametrize(("offset", "expected"), [((0, 0, 0), 55.0), ((30, 0, 0), 25.0), ((54, 0, 0), 1.0)])
def test_a_contained_body_is_measured_to_the_way_out(offset, expected):
    meshes = {"box": cube(), "small": cube(5)}
    assert depth(actor("A", "box"), actor("B", "small", offset), meshes=meshes) == pytest.approx(expected)


@pytest.mark.parametrize("gap", [0.0, 1e-9, 1e-6, 5.0])
def test_flush_and_apart_is_no_contact(gap):
    assert depth(actor("A", "box"), actor("B", "box", (100 + gap, 0, 0)), meshes={"box": cube()}) == 0


def test_a_sphere_takes_the_smallest_axis():
    meshes = {"ball": [{"kind": "sphere", "center": [0, 0, 0], "radius": 50}], "box": cube()}
    found = depth(actor("A", "ball", scale=(3, -2, 0.5)), actor("B", "box", (0, 0, 70)), meshes=meshes)
    assert found == pytest.approx(5.0)


def test_a_capsule_keeps_round_ends():
    meshes = {"cap": [{"kind": "capsule", "center": [0, 0, 0], "radius": 10, "length": 80}], "box": cube()}
    upright = depth(actor("A", "cap", scale=(1, 1, 2)), actor("B", "box", (0, 0, 140)), meshes=meshes)
    assert upright == pytest.approx(10.0)
    wide = depth(actor("A", "cap", scale=(3, 1, 1)), actor("B", "box", (75, 0, 0)), meshes=meshes)
    assert wide == pytest.approx(5.0)


@pytest.mark.parametrize("mesh", ["ball", "cap", "flat", "box", "solid"])
@pytest.mark.parametrize("other", ["ball", "cap", "flat", "box", "solid"])
@pytest.mark.parametrize(
    "place",
    [
        ((0, 0, 0), (0, 0, 0)),
        ((0, 0, 0), (90, 0, 0)),
        ((20, 0, 0), (0, 0, 90)),
        ((1e-6, 0, 0), (0, 0, 0)),
        ((0, 0, -1e-6), (0, 45, 0)),
    ],
)
def test_degenerate_pairs_end_and_stay_under_the_push_out(mesh, other, place):
    meshes = {
        "ball": [{"kind": "sphere", "center": [0, 0, 0], "radius": 50}],
        "cap": [{"kind": "capsule", "center": [0, 0, 0], "radius": 20, "length": 60}],
        "flat": hull(CORNERS * [1, 1, 0]),
        "box": cube(),
        "solid": hull(CORNERS),
    }
    found = contacts(scene(meshes, actor("A", mesh), actor("B", other, *place)))
    assert all(math.isfinite(c.depth_cm) and 0 < c.depth_cm <= 150 and c.trusted for c in found)
    if {mesh, other} == {"ball", "flat"} and place[0] == (0, 0, 0):
        assert found[0].depth_cm == pytest.approx(50, abs=1e-4)


def test_scale_zero_and_collision_off_have_no_body():
    off = actor("C", "box")
    off["c4s"]["components"][0]["collision_enabled"] = False
    meshes = {"box": cube()}
    assert contacts(scene(meshes, actor("A", "box"), actor("B", "box", scale=(0, 0, 0)), off)) == []


def test_instances_belong_to_their_actor():
    crowd = actor("A", "box")
    crowd["c4s"]["components"][0]["instances"] = [
        {"location_cm": [x, 0, 0], "rotation_deg": [0, 0, 0], "scale": [1, 1, 1]} for x in (0, 50, 1000)
    ]
    found = contacts(scene({"box": cube()}, crowd, actor("B", "box", (1090, 0, 0))))
    assert [(c.a, c.b) for c in found] == [("A", "B")]
    assert found[0].depth_cm == pytest.approx(10)


def test_a_snapshot_without_bodies_has_no_guessed_contacts():
    plain = {"name": "A", "transform": {}, "bounds": {"origin_cm": [0, 0, 0], "extent_cm": [9, 9, 9]}}
    assert contacts({"actors": [plain, dict(plain, name="B")]}) == []


@pytest.mark.parametrize("meshes", [{"box": None}, {}])
def test_a_mesh_with_unreadable_bodies_is_unresolved(meshes):
    found = scene_bodies(scene(meshes, actor("A", "box"), actor("B", "box")))
    assert (found.bodies, sorted(found.unresolved)) == ([], [0, 1])


def test_chosen_actors_keep_their_contacts_with_all_others():
    boxes = [actor(f"B{i}", "box", (i * 90.0, 0, 0)) for i in range(5)]
    everything = contacts(scene({"box": cube()}, *boxes))
    chosen = contacts(scene({"box": cube()}, *boxes), actors={"B2"})
    assert chosen == [c for c in everything if "B2" in (c.a, c.b)]
    assert len(everything) == 4


def city(number: int) -> dict:
    """Turned boxes and hulls side by side: every one overlaps its neighbours."""
    rng = np.random.default_rng(5)
    side = math.ceil(math.sqrt(number))
    meshes = {"box": cube(), "hull": hull(rng.normal(size=(20, 3)) * 30)}
    actors = [
        actor(
            f"A{i}",
            "hull" if i % 4 == 0 else "box",
            (i % side * 75.0, i // side * 75.0, 0),
            (0, float(rng.uniform(0, 360)), 0),
        )
        for i in range(number)
    ]
    return scene(meshes, *actors)


def test_the_work_in_a_city_grows_with_its_contacts_not_with_its_pairs():
    found, calls = {}, {}
    for number in (1675, 6700):
        snapshot = city(number)
        found[number] = len(contacts(snapshot, minimum_depth_cm=5.0))
        calls[number] = calls_in(lambda given=snapshot: contacts(given, minimum_depth_cm=5.0))
    assert found[6700] > 5000 and calls[6700]["_touch"] < found[6700]
    assert calls[6700].total() < 4.4 * calls[1675].total() and calls[6700].total() < 200 * 6700
    assert peak_bytes_of(lambda: contacts(snapshot, minimum_depth_cm=5.0)) < 10_000 * 6700
