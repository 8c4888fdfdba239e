"""The agent's checks against the verifier: the same scene gives the same numbers."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from c4s.collision import contacts
from c4s.verify.physics.verdict import verify_physics

PLACES = [
    ("Ground", "floor_tile", (0, 0, -10), (0, 0, 0)),
    ("Desk", "oak_table", (0, 0, 0), (0, 0, 0)),
    ("On desk", "crate", (40, 0, 75), (0, 30, 0)),
    ("In desk", "crate", (-40, 0, 60), (0, 0, 0)),
    ("Hanging", "crate", (165, 10, 60), (0, 0, 0)),
    ("Nearly down", "crate", (140, -140, 4), (0, 0, 0)),
    ("Tilted", "crate", (-140, 140, 10), (30, 0, 20)),
    ("Couch", "sofa", (0, 140, 0), (0, 0, 0)),
    ("In couch", "oak_table", (60, 130, 3), (0, 15, 0)),
]


@pytest.mark.parametrize("setting", ["text-to-scene", "image-to-scene/indoor"])
def test_tools_and_verdict_tell_the_same(open_run: Callable, setting: str) -> None:
    opened = open_run(setting=setting)
    client = opened.client
    client.call(
        "execute_python_script",
        execution_mode="sync",
        script=(
            "import unreal\ns = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)\n"
            "s.destroy_actors(s.get_all_level_actors())"
        ),
    )
    for label, asset, location, rotation in PLACES:
        client.call("spawn_actor", name=label, static_mesh=asset, location=list(location), rotation=list(rotation))
    snapshot = opened.engine.call("snapshot.export_snapshot")
    floating, solid = verify_physics(setting, snapshot, {"actors": []}, alone=True).measurements["leaf_results"]
    measured = client.call("measure_scene").data
    assert measured["actors"] == len(PLACES) == snapshot["actor_count"]
    assert measured["floating_rate"] == floating["score"] and measured["floating_tested"] == floating["evaluated"]
    assert {row["name"] for row in measured["floating"]} == set(floating["floating_actors"])
    assert "Hanging" in {row["label"] for row in measured["floating"]}
    assert measured["collision_rate"] == pytest.approx(1 - solid["score"], abs=1e-4)
    assert measured["collision_tested"] == solid["evaluated"]
    assert {(row["name"], row["tolerance_cm"]) for row in measured["colliding"]} == {
        (row["actor"], row["tolerance_cm"]) for row in solid["violations"]
    }
    assert {row["label"] for row in measured["colliding"]} >= {"Desk", "In desk", "Couch", "In couch"}
    hanging = client.call("check_floating").data
    assert {row["name"] for row in hanging["scored_as_floating"]} == set(floating["floating_actors"])
    gaps = {row["label"]: row["gap_cm"] for row in hanging["floating"]}
    assert gaps["Hanging"] == pytest.approx(60, abs=0.01) and "Nearly down" not in gaps
    pairs = client.call("check_collisions", touch_tolerance_cm=5).data["pairs"]
    wanted = sorted(contacts(snapshot, minimum_depth_cm=5.0), key=lambda contact: -contact.depth_cm)
    assert [(row["a"]["name"], row["b"]["name"]) for row in pairs] == [(one.a, one.b) for one in wanted]
    assert [row["depth_cm"] for row in pairs] == pytest.approx([one.depth_cm for one in wanted], abs=0.01)
    at_fault = {row["name"] for row in measured["colliding"]}
    assert at_fault <= {row[side]["name"] for row in pairs for side in ("a", "b")}


def test_a_copied_identity_tag_is_told(open_run: Callable) -> None:
    """Copies of a tagged actor share its identity: physics cannot be scored, and the agent reads why."""
    client = open_run(setting="image-to-scene/indoor").client
    script = (
        "import unreal\ns = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)\n"
        "actor = s.get_all_level_actors()[0]\nactor.tags = ['simcodearena.stable_actor_id=sca_source_1']\n"
        "s.duplicate_actor(actor, None, unreal.Vector(0, 0, 300))"
    )
    client.call("execute_python_script", execution_mode="sync", script=script)
    measured = client.call("measure_scene").data
    assert "two actors have the identity stable:sca_source_1" in measured["not_evaluated"]
    assert measured["floating_rate"] is None and measured["collision_rate"] is None
