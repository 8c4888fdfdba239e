"""The corners in which the physics leaves follow the published verifiers: rounding, edits, missing evidence."""

from __future__ import annotations

import copy
from typing import Any

import pytest
from test_physics_verdict import I2S, actor, leaves, snapshot

from c4s.collision import Contact
from c4s.protocol.physics import physics_from_report
from c4s.verify.physics.edited import edited_actors
from c4s.verify.physics.verdict import report, verify_physics

NAN = float("nan")


def row(count: int, *, bodies: bool = True) -> list[dict[str, Any]]:
    """Crates on the ground, far from each other."""
    return [actor(f"A{n}", (1000 * n, 0, 50), bodies=bodies) for n in range(count)]


@pytest.mark.parametrize(
    ("total", "deep", "leaf", "score"),
    [
        (3, 1, 0.6667, 0.8334),
        (3, 2, 0.3333, 0.6666),
        (6, 1, 0.8333, 0.9166),
        (7, 2, 0.7143, 0.8572),
        (4, 1, 0.75, 0.875),
    ],
)
def test_a_leaf_has_four_decimals_before_it_is_weighted(total: int, deep: int, leaf: float, score: float) -> None:
    """Half of the unrounded third would give 0.8333: the last published digit."""
    scene = snapshot(*row(total, bodies=False), actor("Floor", (0, 0, -10), (400, 400, 10), bodies=False))
    contacts = [Contact(f"A{n}", "Floor", 9.0, True, n, total) for n in range(deep)]
    verdict = verify_physics("text-to-scene", scene, contacts=contacts)
    assert leaves(verdict)["solid_penetration"]["score"] == leaf
    assert verdict.score == physics_from_report(report(verdict))["score"] == score


def test_the_floating_leaf_of_edits_is_rounded_too() -> None:
    tops = [actor(f"B{n}", (1000 * n, 0, 150 if n else 500)) for n in range(3)]
    verdict = verify_physics(I2S, snapshot(*row(3), *tops), snapshot(*row(3)))
    assert leaves(verdict)["floating"]["score"] == 0.3333
    assert verdict.score == 0.8334


@pytest.mark.parametrize("depth", [0.5, 4.0, 12.0, NAN])
def test_a_contact_without_a_trusted_depth_keeps_its_actors_open_however_shallow(depth: float) -> None:
    pair = snapshot(*(actor(n, (i * 380, 0, 200), (200,) * 3, bodies=False) for i, n in enumerate("AB")))
    leaf = leaves(verify_physics("text-to-scene", pair, contacts=[Contact("A", "B", depth, False, 0, 1)]))[
        "solid_penetration"
    ]
    assert (leaf["status"], leaf["evaluated"], leaf["unresolved"]) == ("not_evaluated", 0, 2)
    assert leaf["violations"] == []
    both = [Contact("A", "B", depth, False, 0, 1), Contact("A", "B", 25.0, True, 0, 1)]
    proven = leaves(verify_physics("text-to-scene", pair, contacts=both))["solid_penetration"]
    assert (proven["score"], proven["unresolved"]) == (0.0, 0)
    assert [[c["depth_cm"] for c in item["contacts"]] for item in proven["violations"]] == [[25.0], [25.0]]


@pytest.mark.parametrize(("depth", "violates"), [(5.0, False), (5.0000001, True)])
def test_a_depth_that_another_engine_measured_is_taken_to_the_last_digit(depth: float, violates: bool) -> None:
    leaf = leaves(
        verify_physics(
            "text-to-scene", snapshot(*row(2, bodies=False)), contacts=[Contact("A0", "A1", depth, True, 0, 1)]
        )
    )["solid_penetration"]
    assert leaf["score"] == (0.0 if violates else 1.0)


def test_one_edit_without_evidence_withholds_the_floating_leaf() -> None:
    """A floating neighbour does not lift it, unlike a violation in the penetration leaf."""
    lost = actor("Lost", (9000, 0, 50), bodies=False)
    leaf = leaves(verify_physics(I2S, snapshot(actor("Up", (0, 0, 500)), lost), snapshot()))["floating"]
    assert (leaf["status"], leaf["score"], leaf["failed"], leaf["unresolved"]) == ("not_evaluated", None, 1, 1)


def test_an_empty_text_scene_is_not_evaluated_and_an_unedited_one_is_neutral() -> None:
    empty = verify_physics("text-to-scene", snapshot())
    assert [leaf["status"] for leaf in leaves(empty).values()] == ["not_evaluated"] * 2
    assert (empty.score, empty.advisories) == (0.0, [])
    assert verify_physics(I2S, snapshot(), snapshot()).score == 1.0


def test_ids_of_a_logical_object_are_compared_as_text() -> None:
    pair = [actor("A", (0, 0, 50), logical_object_id="7"), actor("B", (20, 0, 50), logical_object_id=7)]
    assert leaves(verify_physics("text-to-scene", snapshot(*pair)))["solid_penetration"]["score"] == 1.0


EDITS = [
    ({}, False),
    ({"label": "renamed"}, True),
    ({"actor_tags": ["x"]}, True),
    ({"actor_tags": None}, False),
    ({"actor_role": "prop"}, True),
    ({"actor_role": ""}, False),
    ({"actor_origin": "agent"}, True),
    ({"logical_object_id": "o"}, True),
    ({"properties": {"intensity": 2}}, True),
    ({"properties": {"intensity": 1, "mobility": "static"}}, False),
    ({"class": "StaticMeshActor"}, True),
    ({"asset_path": "/Game/P/SM_Other.SM_Other"}, True),
    ({"bounds": None}, False),
    ({"name": "Other"}, False),
    ({"transform": {"location_cm": [0.05, 0, 50], "rotation_deg": [0, 180, 0], "scale": [1, 1, 1]}}, False),
    ({"transform": {"location_cm": [0, 0, 50], "rotation_deg": [0, -180, 0], "scale": [1, 1, 1]}}, True),
]


@pytest.mark.parametrize(("change", "edited"), EDITS)
def test_what_counts_as_an_edit(change: dict[str, Any], edited: bool) -> None:
    old = actor(
        "A", (0, 0, 50), actor_role=None, actor_origin=None, logical_object_id=None, properties={"intensity": 1}
    )
    old["transform"]["rotation_deg"] = [0, 180, 0]
    new = copy.deepcopy(old) | change
    assert edited_actors(snapshot(new), snapshot(old)) == ([0] if edited else [])


@pytest.mark.parametrize("field", ["label", "actor_tags", "actor_role", "properties", "asset_path"])
def test_what_the_input_does_not_record_is_no_edit(field: str) -> None:
    new = actor("A", (0, 0, 50), actor_role="x", properties={"intensity": 1}, actor_tags=["t"])
    old = {key: value for key, value in new.items() if key != field}
    assert edited_actors(snapshot(new), snapshot(old)) == []


def test_every_rule_behind_a_verdict_is_named() -> None:
    one = actor("A", (0, 0, 50))
    for setting, start, profile, tolerance in (
        (
            "text-to-scene",
            None,
            "absolute-physical-safety-candidate-all-v3",
            "actor_shortest_full_aabb_span_clamped_v1",
        ),
        (I2S, snapshot(), "image-to-scene-edited-actors-physical-safety", "fixed_declared_tolerance"),
    ):
        verdict = verify_physics(setting, snapshot(one), start)
        assert (verdict.policy, verdict.measurements["profile"]) == ("physics-all-leaves-zero.v2", profile)
        assert verdict.measurements["role_policy"] == "deterministic_scene_relative_physics_roles_v1"
        assert leaves(verdict)["solid_penetration"]["tolerance_policy"] == tolerance
        assert all(leaf["metric"] for leaf in leaves(verdict).values())
