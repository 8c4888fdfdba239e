"""The physics verifier on small scenes."""

from __future__ import annotations

from typing import Any

import pytest

from c4s.collision import Contact
from c4s.errors import BadInput
from c4s.verify.actors.roles import roles
from c4s.verify.physics.verdict import verify_physics

CUBE = "/Game/P/SM_Crate.SM_Crate"
I2S = "image-to-scene/indoor"


def actor(name: str, location: Any, half: Any = (50, 50, 50), *, bodies: bool = True, **more: Any) -> dict[str, Any]:
    """A box of the given half extents (cm) as a scaled crate; its pivot is its centre."""
    scale = [h / 50 for h in half]
    transform = {"location_cm": list(location), "rotation_deg": [0.0, 0.0, 0.0], "scale": scale}
    record: dict[str, Any] = {
        "stable_actor_id": f"id_{name}",
        "name": name,
        "label": name,
        "class": "/Script/Engine.StaticMeshActor",
        "asset_path": CUBE,
        "component_asset_paths": [CUBE],
        "collision": {"collision_enabled": True},
        "actor_tags": [],
        "transform": transform,
        "bounds": {"origin_cm": list(location), "extent_cm": [float(h) for h in half]},
    }
    if bodies:
        record["c4s"] = {
            "components": [
                {
                    "name": "Mesh",
                    "class": "/Script/Engine.StaticMeshComponent",
                    "mesh": CUBE,
                    "transform": transform,
                    "collision_enabled": True,
                }
            ]
        }
    return record | more


def snapshot(*actors: dict[str, Any]) -> dict[str, Any]:
    body = {"kind": "box", "center": [0, 0, 0], "half_extent": [50, 50, 50]}
    return {
        "schema_version": "0.3.0",
        "units": "cm",
        "actors": list(actors),
        "c4s": {"engine": "headless", "meshes": {CUBE: {"collision": [body]}}},
    }


def leaves(verdict) -> dict[str, dict[str, Any]]:
    return {leaf["leaf_id"]: leaf for leaf in verdict.measurements["leaf_results"]}


def near_bodies(verdict) -> dict[str, Any]:
    """The diagnostic leaf of edited actors."""
    return next(leaf for leaf in verdict.measurements["diagnostic_leaves"] if leaf["leaf_id"] == "near_bodies")


def test_a_sound_scene_is_one():
    verdict = verify_physics("text-to-scene", snapshot(actor("A", (0, 0, 50)), actor("B", (0, 0, 150))))
    assert verdict.score == 1.0
    assert verdict.population["solid_penetration_evaluated"] == 2


def test_floating_and_penetration_each_cost_their_share():
    scene = snapshot(
        actor("A", (0, 0, 50)), actor("B", (60, 0, 50)), actor("C", (1000, 0, 300)), actor("D", (2000, 0, 50))
    )
    verdict = verify_physics("text-to-scene", scene)
    found = leaves(verdict)
    assert (found["floating"]["score"], found["solid_penetration"]["score"]) == (0.25, 0.5)
    assert verdict.score == 0.625
    deep = found["solid_penetration"]["violations"]
    assert [(v["actor"], v["contacts"][0]["depth_cm"]) for v in deep] == [("A", 40.0), ("B", 40.0)]


@pytest.mark.parametrize(
    ("half", "depth", "violates"),
    [
        ((50, 50, 50), 5.0, False),
        ((50, 50, 50), 5.01, True),
        ((200, 200, 200), 19.9, False),
        ((200, 200, 200), 20.1, True),
        ((1000, 1000, 1000), 49.9, False),
        ((1000, 1000, 1000), 50.1, True),
    ],
)
def test_text_to_scene_tolerance_grows_with_the_actor(half, depth, violates):
    scene = snapshot(actor("A", (0, 0, half[2]), half), actor("B", (2 * half[0] - depth, 0, half[2]), half))
    assert bool(leaves(verify_physics("text-to-scene", scene))["solid_penetration"]["violations"]) is violates


def test_image_to_scene_tolerance_is_fixed():
    before = snapshot(actor("A", (0, 0, 200), (200,) * 3), actor("B", (900, 0, 200), (200,) * 3))
    after = snapshot(actor("A", (0, 0, 200), (200,) * 3), actor("B", (394, 0, 200), (200,) * 3))
    found = leaves(verify_physics(I2S, after, before))
    assert found["solid_penetration"]["evaluated"] == 1
    assert found["solid_penetration"]["score"] == 0.0


def test_no_edit_and_deletion_only_are_neutral():
    scene = snapshot(actor("A", (0, 0, 500)), actor("B", (20, 0, 500)))
    for candidate in (scene, snapshot(scene["actors"][0])):
        verdict = verify_physics(I2S, candidate, scene)
        assert verdict.score == 1.0
        assert [leaf["status"] for leaf in leaves(verdict).values()] == ["measured", "measured"]
        assert verdict.population["selected"] == 0
        assert [note["code"] for note in verdict.advisories] == ["empty_population"]


@pytest.mark.parametrize("edit", [{"label": "renamed"}, {"actor_tags": ["x"]}])
def test_labels_and_tags_are_edits(edit):
    before = snapshot(actor("A", (0, 0, 500)))
    after = snapshot(actor("A", (0, 0, 500), **edit))
    assert leaves(verify_physics(I2S, after, before))["floating"]["score"] == 1.0


@pytest.mark.parametrize(
    ("place", "floats"),
    [
        ((0, 0, 150), False),
        ((0, 0, 155), False),
        ((0, 0, 155.1), True),
        ((0, 0, 147), False),
        ((100, 0, 60), False),
        ((105, 0, 60), False),
        ((105.1, 0, 60), True),
        ((0, 300, 50), True),
        ((0, 0, -50), True),
    ],
)
def test_bodies_hold_edited_actors_from_below_or_the_side(place, floats):
    base = actor("A", (0, 0, 50))
    found = near_bodies(verify_physics(I2S, snapshot(base, actor("B", place)), snapshot(base)))
    assert found["evaluated"] == 1
    assert (found["score"] == 1.0) is floats


@pytest.mark.parametrize(
    ("gap", "floats"), [(0.0, False), (0.3, False), (1.0, False), (2.2, False), (4.9, False), (5.0, False), (5.1, True)]
)
@pytest.mark.parametrize("axis", [0, 2])
def test_thin_things_hold_and_are_held_all_along_the_way(gap, floats, axis):
    thin, place = [50.0, 50.0, 50.0], [0.0, 0.0, 200.0]
    thin[axis] = 0.25
    place[axis] += 0.5 + gap
    plate, foot = actor("Plate", (0, 0, 200), thin), actor("Foot", place, thin)
    found = near_bodies(verify_physics(I2S, snapshot(plate, foot), snapshot(plate)))
    assert (found["score"] == 1.0) is floats


def test_two_actors_under_one_identity_leave_both_leaves_unevaluated():
    base = actor("A", (0, 0, 50))
    copies = snapshot(base, actor("B", (0, 0, 150)), actor("B", (300, 0, 50)))
    verdict = verify_physics(I2S, copies, snapshot(base))
    assert (verdict.status, verdict.score) == ("not_evaluated", None)
    assert "two actors have the identity stable:id_B" in verdict.reason
    assert {leaf["status"] for leaf in leaves(verdict).values()} == {"not_evaluated"}
    with pytest.raises(BadInput, match="input snapshot: two actors"):
        verify_physics(I2S, snapshot(base), copies)


def test_what_only_touches_a_ceiling_is_not_held():
    ceiling = actor("Ceiling", (0, 0, 300))
    found = leaves(verify_physics(I2S, snapshot(ceiling, actor("Lamp", (0, 0, 245), (5, 5, 5))), snapshot(ceiling)))
    assert found["floating"]["score"] == 1.0


def test_edited_lights_only_leave_nothing_to_evaluate():
    light = actor("L", (0, 0, 300)) | {"class": "/Script/Engine.PointLight"}
    verdict = verify_physics(I2S, snapshot(light), snapshot())
    found = leaves(verdict)
    assert (found["floating"]["status"], found["floating"]["score"]) == ("measured", 0.0)
    assert (found["solid_penetration"]["status"], found["solid_penetration"]["score"]) == ("not_applicable", None)
    assert verdict.score == 0.5
    assert [note["code"] for note in verdict.advisories] == ["all_excluded"]


def test_ground_tiles_alone_are_supported_but_have_no_penetration_to_measure():
    tiles = snapshot(*(actor(f"Ground_{n}", (400.0 * n, 0, -10), (400, 400, 20)) for n in range(3)))
    verdict = verify_physics("text-to-scene", tiles)
    found = leaves(verdict)
    assert (found["floating"]["status"], found["floating"]["score"]) == ("measured", 0.0)
    assert (found["solid_penetration"]["status"], verdict.score) == ("not_applicable", 0.5)
    assert "all_excluded" in [note["code"] for note in verdict.advisories]


def test_published_snapshots_without_bodies_are_not_guessed():
    plain = snapshot(actor("A", (0, 0, 50), bodies=False), actor("B", (20, 0, 50), bodies=False))
    del plain["c4s"]
    verdict = verify_physics("text-to-scene", plain)
    solid = leaves(verdict)["solid_penetration"]
    assert (solid["status"], solid["score"], solid["unresolved"]) == ("not_evaluated", None, 2)
    assert verdict.score == 0.5
    measured = verify_physics("text-to-scene", plain, contacts=[Contact("A", "B", 80.0, True, 0, 1)])
    assert leaves(measured)["solid_penetration"]["score"] == 0.0


def test_an_untrusted_contact_is_unresolved_and_a_proof_lifts_it():
    plain = snapshot(*(actor(n, (i * 300, 0, 50), bodies=False) for i, n in enumerate("ABC")))
    doubt = Contact("A", "B", 30.0, False, 0, 1)
    assert leaves(verify_physics("text-to-scene", plain, contacts=[doubt]))["solid_penetration"]["score"] is None
    verdict = verify_physics("text-to-scene", plain, contacts=[doubt, Contact("B", "C", 30.0, True, 1, 2)])
    assert leaves(verdict)["solid_penetration"]["score"] == 0.0
    assert "violation_lifts_unresolved" in [note["code"] for note in verdict.advisories]


def test_one_logical_object_does_not_collide_with_itself():
    pair = [actor(n, (i * 20, 0, 50), logical_object_id="car") for i, n in enumerate("AB")]
    assert leaves(verify_physics("text-to-scene", snapshot(*pair)))["solid_penetration"]["score"] == 1.0


def test_roles():
    scene = [
        actor("SM_FloorTile1", (0, 0, 0), (200, 200, 2)),
        actor("FloorLamp", (0, 0, 90), (20, 20, 90)),
        actor("River_Water", (0, 0, 0)),
        actor("Smoke", (0, 0, 0)) | {"class": "/Script/Niagara.NiagaraActor"},
        actor("A", (0, 0, 0), collision={"collision_enabled": False}),
        actor("B", (0, 0, 0), bounds=None),
        *(actor(f"C{i}", (i * 200, 0, 50)) for i in range(5)),
        actor("Mountain_Ring", (0, 0, 0), (40000, 40000, 20000)),
        actor("Tower", (0, 0, 0), (40000, 40000, 20000)),
    ]
    assert roles(scene) == [
        "support_surface",
        "scored_solid",
        "non_solid",
        "non_solid",
        "non_solid",
        "unresolved",
        *["scored_solid"] * 5,
        "environment_proxy",
        "scored_solid",
    ]


def test_a_support_surface_is_not_scored_but_its_contacts_are():
    scene = snapshot(actor("Ground", (0, 0, -50), (500, 500, 50)), actor("A", (0, 0, 20)))
    found = leaves(verify_physics("text-to-scene", scene))["solid_penetration"]
    assert (found["evaluated"], found["score"]) == (1, 0.0)


def test_bad_input_is_one_line():
    with pytest.raises(BadInput):
        verify_physics("text-to-scene", {"actors": "none"})
    with pytest.raises(BadInput):
        verify_physics(I2S, snapshot())


def test_a_solid_whose_label_is_never_scored_is_named():
    verdict = verify_physics("text-to-scene", snapshot(actor("Lighthouse", (0, 0, 500)), actor("Crate", (300, 0, 50))))
    notes = {note["code"]: note["actors"] for note in verdict.advisories}
    assert notes["label_never_supported"] == ["Lighthouse"] and leaves(verdict)["floating"]["failed"] == 0
