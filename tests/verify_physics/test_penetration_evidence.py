"""What the physics verdict says of penetration: roles, tolerances, evidence trusted and missing, and contacts."""

from __future__ import annotations

import json
import math
import random
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from test_physics_verdict import CUBE, I2S, actor, leaves, snapshot
from typer.testing import CliRunner

from c4s.cli.main import app
from c4s.collision import Contact
from c4s.errors import BadInput
from c4s.verify.physics.penetration import adaptive_tolerance_cm
from c4s.verify.physics.verdict import verify_physics

NAN = float("nan")


def penetration(scene: dict[str, Any], **more: Any) -> dict[str, Any]:
    return leaves(verify_physics("text-to-scene", scene, **more))["solid_penetration"]


def states(leaf: dict[str, Any]) -> dict[str, str]:
    return {row["actor"]: row["state"] for row in leaf["actors"]}


@pytest.mark.parametrize(
    ("extent", "tolerance"),
    [
        ((50, 50, 50), 5.0),
        ((51, 900, 900), 5.1),
        ((0, 0, 0), 5.0),
        ((500, 500, 2), 5.0),
        ((499.9, 500, 501), 49.99),
        ((500, 500, 500), 50.0),
        ((9000, 9000, 9000), 50.0),
    ],
)
def test_the_tolerance_is_a_twentieth_of_the_shortest_span(extent, tolerance):
    assert adaptive_tolerance_cm(extent) == pytest.approx(tolerance)


def test_each_actor_has_its_state_tolerance_and_contacts_in_the_verdict():
    big = actor("Big", (0, 0, 300), (300, 300, 300))
    small = actor("Small", (340, 0, 50))
    other = actor("Other", (430, 0, 50))
    leaf = penetration(snapshot(big, small, other, actor("Far", (5000, 0, 50))))
    rows = {row["actor"]: row for row in leaf["actors"]}
    assert {
        name: (row["state"], row["tolerance_cm"], [(c["actor"], c["depth_cm"], c["trusted"]) for c in row["contacts"]])
        for name, row in rows.items()
    } == {
        "Big": ("clean", 30.0, [("Small", 10.0, True)]),
        "Small": ("violating", 5.0, [("Big", 10.0, True), ("Other", 10.0, True)]),
        "Other": ("violating", 5.0, [("Small", 10.0, True)]),
        "Far": ("clean", 5.0, []),
    }
    assert (leaf["evaluated"], leaf["failed"], leaf["unresolved"], leaf["score"]) == (4, 2, 0, 0.5)
    assert [row["actor"] for row in leaf["violations"]] == ["Small", "Other"]


@pytest.mark.parametrize("depth", [5.0, 5.0 + 1e-9, 4.99])
@pytest.mark.parametrize("yaw", [0.0, 17.0, 45.0, 133.3])
@pytest.mark.parametrize("far", [0.0, 1e5])
def test_exactly_the_tolerance_is_no_violation_at_any_turn(depth, yaw, far):
    along = [math.cos(math.radians(yaw)) * (100 - depth) + far, math.sin(math.radians(yaw)) * (100 - depth), 50]
    pair = [actor("A", (far, 0, 50)), actor("B", along)]
    for record in pair:
        record["transform"]["rotation_deg"] = [0.0, yaw, 0.0]
    assert states(penetration(snapshot(*pair))) == {"A": "clean", "B": "clean"}


def test_an_untrusted_deeper_contact_keeps_a_clean_actor_open():
    scene = snapshot(actor("A", (0, 0, 200), (200,) * 3), actor("B", (380, 0, 200), (200,) * 3))
    sure, doubt = Contact("A", "B", 10.0, True, 0, 1), Contact("A", "B", 30.0, False, 0, 1)
    assert set(states(penetration(scene, contacts=[sure])).values()) == {"clean"}
    leaf = penetration(scene, contacts=[sure, doubt])
    assert (leaf["status"], leaf["score"], leaf["evaluated"], leaf["unresolved"]) == ("not_evaluated", None, 0, 2)
    assert [c["trusted"] for c in leaf["actors"][0]["contacts"]] == [False, True]
    proof = penetration(scene, contacts=[doubt, Contact("A", "B", 25.0, True, 0, 1)])
    assert set(states(proof).values()) == {"violating"}


@pytest.mark.parametrize("bounds", [None, {"origin_cm": [0, 0, NAN], "extent_cm": [1, 1, 1]}, {"extent_cm": [1, 1, 1]}])
def test_an_actor_without_a_valid_box_is_unresolved(bounds):
    boxless = actor("Lost", (5000, 0, 50)) | {"bounds": bounds}
    clean = snapshot(boxless, actor("A", (0, 0, 50)))
    after = leaves(verify_physics(I2S, clean, snapshot()))["solid_penetration"]
    assert (after["status"], after["score"], after["evaluated"], after["unresolved"]) == ("not_evaluated", None, 1, 1)
    assert [row["reason"] for row in after["actors"] if row["state"] == "unresolved"] == ["no valid world box"]
    proven = leaves(
        verify_physics(I2S, snapshot(boxless, actor("A", (0, 0, 50)), actor("B", (60, 0, 50))), snapshot())
    )["solid_penetration"]
    assert (proven["status"], proven["score"], proven["unresolved"]) == ("measured", 0.0, 1)


def test_a_neighbour_without_known_bodies_leaves_an_actor_open_and_a_far_one_does_not():
    scene = snapshot(actor("Unknown", (0, 0, 50), bodies=False), actor("Near", (90, 0, 50)), actor("Far", (900, 0, 50)))
    leaf = penetration(scene)
    assert states(leaf) == {"Unknown": "unresolved", "Near": "unresolved", "Far": "clean"}
    assert leaf["score"] is None
    reasons = {row["actor"]: row.get("reason", "") for row in leaf["actors"]}
    assert "no collision bodies" in reasons["Unknown"] and "meets the box" in reasons["Near"]


@pytest.mark.parametrize(
    "mesh", [None, {"collision": None}, {"collision": [{"kind": "sphere", "center": [0, 0, 0], "radius": NAN}]}]
)
def test_unreadable_bodies_never_make_an_actor_clean(mesh):
    scene = snapshot(actor("A", (0, 0, 50)), actor("B", (20, 0, 50)))
    scene["c4s"]["meshes"][CUBE] = mesh
    assert set(states(penetration(scene)).values()) == {"unresolved"}


def test_a_backdrop_is_not_scored_but_containment_in_it_is():
    dome = actor("Mountain", (0, 0, 0), (40000, 40000, 20000))
    leaf = penetration(snapshot(dome, *(actor(f"C{i}", (i * 300, 0, 50)) for i in range(5))))
    assert states(leaf) == {f"C{i}": "violating" for i in range(5)}
    assert {c["actor"] for row in leaf["violations"] for c in row["contacts"]} == {"Mountain"}


@pytest.mark.parametrize(
    "change", [{"collision": {"collision_enabled": False}}, {"class": "/Script/Engine.PointLight"}, {"label": "River"}]
)
def test_contacts_with_what_is_not_solid_do_not_count(change):
    leaf = penetration(snapshot(actor("A", (0, 0, 50)), actor("B", (20, 0, 50)) | change))
    assert [(row["state"], row["contacts"]) for row in leaf["actors"]] == [("clean", [])]


def test_image_to_scene_scores_the_edited_actors_against_all():
    base = [actor("A", (0, 0, 50)), actor("B", (20, 0, 50))]
    after = snapshot(*base, actor("New", (100, 0, 50)))
    leaf = leaves(verify_physics(I2S, after, snapshot(*base)))["solid_penetration"]
    assert [(row["actor"], row["state"], [c["actor"] for c in row["contacts"]]) for row in leaf["actors"]] == [
        ("New", "violating", ["B"])
    ]


def test_actors_without_a_name_are_judged_too():
    pair = [actor(n, (i * 20, 0, 50)) for i, n in enumerate("AB")]
    for record in pair:
        del record["name"]
    leaf = leaves(verify_physics(I2S, snapshot(*pair), snapshot()))["solid_penetration"]
    assert states(leaf) == {"A": "violating", "B": "violating"}


@settings(max_examples=20, deadline=None)
@given(st.integers(0, 100_000))
def test_order_names_and_ids_change_nothing(seed):
    rng = random.Random(seed)
    made = [
        actor(
            f"A{n}",
            [rng.uniform(-200, 200), rng.uniform(-200, 200), 50.0],
            [rng.uniform(20, 150) for _ in range(3)],
            bodies=rng.random() < 0.97,
        )
        for n in range(12)
    ]
    first = penetration(snapshot(*made))
    order = rng.sample(range(12), 12)
    renamed = [made[n] | {"name": f"Z{n}", "label": f"Z{n}", "stable_actor_id": f"other{n}"} for n in order]
    second = penetration(snapshot(*renamed))
    for field in ("status", "score", "evaluated", "failed", "unresolved"):
        assert first[field] == second[field]
    assert {f"Z{name[1:]}": state for name, state in states(first).items()} == states(second)
    depths = [sorted(c["depth_cm"] for row in leaf["actors"] for c in row["contacts"]) for leaf in (first, second)]
    assert depths[0] == depths[1]


@pytest.mark.parametrize("broken", [{"actors": [7]}, {"actors": {"A": {}}}, {}])
def test_a_scene_or_an_input_without_actors_is_bad_input(broken):
    with pytest.raises(BadInput, match="the snapshot has no list of actors"):
        verify_physics("text-to-scene", broken)
    with pytest.raises(BadInput, match="the input snapshot has no list of actors"):
        verify_physics(I2S, snapshot(actor("A", (0, 0, 50))), broken)


JUNK = st.recursive(
    st.none() | st.booleans() | st.integers(-5, 5) | st.floats() | st.sampled_from(["", "x", CUBE]),
    lambda part: (
        st.lists(part, max_size=3)
        | st.dictionaries(
            st.sampled_from(["components", "mesh", "transform", "location_cm", "origin_cm", "meshes"]), part, max_size=3
        )
    ),
    max_leaves=5,
)


@settings(max_examples=150, deadline=None)
@given(
    st.sampled_from(
        [
            "collision",
            "transform",
            "component_asset_paths",
            "actor_tags",
            "c4s",
            "export_diagnostics",
            "label",
            "name",
            "class",
            "asset_path",
            "logical_object_id",
            "material_paths",
        ]
    ),
    JUNK,
)
def test_a_damaged_actor_ends_no_run_and_is_never_proven_clean_by_it(field, value):
    """Both actors overlap deeply: whatever is damaged, the other one is violating or open, unless the damage says that
    the first has no collision."""
    damaged = actor("A", (0, 0, 50)) | {field: value}
    leaf = leaves(verify_physics(I2S, snapshot(damaged, actor("B", (20, 0, 50))), snapshot()))["solid_penetration"]
    if leaf["evaluated"] == 2:
        assert leaf["failed"] in (0, 2)
    assert len(leaf["actors"]) in (1, 2)


def test_the_command_shows_it(tmp_path):
    path = tmp_path / "scene.json"
    path.write_text(json.dumps(snapshot(actor("A", (0, 0, 50)), actor("B", (60, 0, 50)))))
    done = CliRunner().invoke(app, ["verify", "physics", "--snapshot", str(path), "--json"])
    assert done.exit_code == 0
    verdict = json.loads(done.stdout)
    solid = verdict["measurements"]["leaf_results"][1]
    assert [(row["actor"], row["contacts"][0]["depth_cm"]) for row in solid["actors"]] == [("A", 40.0), ("B", 40.0)]
    assert verdict["measurements"]["roles"] == {"A": "scored_solid", "B": "scored_solid"}
