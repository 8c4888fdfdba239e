"""The three integrity checks, and whose failure a failure is."""

from __future__ import annotations

from typing import Any

import pytest

from c4s.verify.integrity.verdict import ManifestDigests, refused, verify_integrity
from tests.verify_repair.repair_scenes import actor, scene

PACKS = {"office": "a" * 64}
AGREED = ManifestDigests(frozen=PACKS, submission=PACKS, scorer=PACKS)
SCENE = scene(actor("chair", "Chair", (0, 0, 0)), actor("desk", "Desk", (200, 0, 0)))
RESOLVED: dict[str, Any] = {"packages": ["/Game/Room/SM_Chair"], "unresolved": []}


def test_a_sound_submission_is_valid() -> None:
    verdict = verify_integrity(SCENE, RESOLVED, 2, AGREED)
    assert (verdict.status, verdict.score, verdict.population["content_actors"]) == ("valid", None, 2)


def test_an_emptied_level_is_invalid() -> None:
    camera = actor("view", "None", (0, 0, 0)) | {"class": "/Script/Engine.CineCameraActor", "asset_path": None}
    settings = actor("world", "None", (0, 0, 0)) | {"class": "/Script/Engine.WorldSettings", "asset_path": None}
    for left in ((), (camera, settings)):
        verdict = verify_integrity(scene(*left), RESOLVED, 1, AGREED)
        assert (verdict.status, verdict.measurements["reason_code"]) == ("invalid", "minimum_actors")


def test_unsaved_assets_are_named() -> None:
    missing = RESOLVED | {
        "unresolved": ["/Game/Made/M_New.M_New", {"package": "/Game/Made/SM_New"}, "/Engine/Odd", "/Game/Known/T_Old"]
    }
    verdict = verify_integrity(SCENE, missing, 1, AGREED, tolerated=["/Game/Known/T_Old"])
    assert verdict.status == "invalid"
    assert verdict.reason == "unresolved_dependencies: /Game/Made/M_New, /Game/Made/SM_New"


@pytest.mark.parametrize(
    ("changes", "status", "code"),
    [
        ({"submission": {"office": "b" * 64}}, "invalid", "manifest_disagreement"),
        ({"submission": {}}, "invalid", "manifest_disagreement"),
        ({"submission": PACKS | {"smuggled": "c" * 64}}, "invalid", "manifest_disagreement"),
        ({"scorer": {"office": "b" * 64}}, "error", "scorer_manifest"),
    ],
)
def test_manifests_must_agree(changes: dict[str, Any], status: str, code: str) -> None:
    verdict = verify_integrity(SCENE, RESOLVED, 1, AGREED.model_copy(update=changes))
    assert (verdict.status, verdict.measurements["reason_code"]) == (status, code)


@pytest.mark.parametrize(
    "broken",
    [
        [],
        {"actors": []},
        SCENE | {"schema_version": "9"},
        SCENE | {"units": "m"},
        SCENE | {"actors": {}},
        SCENE | {"actor_count": 7},
        SCENE | {"actors": [1], "actor_count": 1},
        SCENE | {"actors": [{"transform": {}}], "actor_count": 1},
        SCENE | {"actors": [{"class": "X"}], "actor_count": 1},
    ],
)
def test_a_wrong_schema_is_invalid(broken: Any) -> None:
    verdict = verify_integrity(broken, RESOLVED, 1, AGREED)
    assert (verdict.status, verdict.measurements["reason_code"]) == ("invalid", "snapshot_schema")


def test_missing_evidence_is_the_evaluators_fault() -> None:
    assert verify_integrity(None, RESOLVED, 1, AGREED).status == "error"
    assert verify_integrity(SCENE, None, 1, AGREED).status == "error"
    failed = SCENE | {"export_metadata": {"status": "error"}}
    assert verify_integrity(failed, RESOLVED, 1, AGREED).status == "error"
    assert refused("unloadable", "the level names no world").status == "invalid"


def test_a_scorer_with_other_content_is_never_the_agents_zero() -> None:
    missing = RESOLVED | {"unresolved": ["/Game/Room/SM_Chair"]}
    emptied = scene()
    for scorer in ({}, {"office": "b" * 64}, PACKS | {"extra": "c" * 64}):
        for given in (SCENE, emptied, None):
            verdict = verify_integrity(given, missing, 1, AGREED.model_copy(update={"scorer": scorer}))
            assert (verdict.status, verdict.measurements["reason_code"]) == ("error", "scorer_manifest")


def test_an_asset_of_the_run_is_not_excused_by_its_folder() -> None:
    unsaved = RESOLVED | {"unresolved": ["/Game/Room/M_Made", "StaticMesh'/Game/Room/SM_Made.SM_Made'"]}
    verdict = verify_integrity(SCENE, unsaved, 1, AGREED)
    assert (verdict.status, verdict.measurements["unresolved"]) == (
        "invalid",
        ["/Game/Room/M_Made", "/Game/Room/SM_Made"],
    )
    many = RESOLVED | {"unresolved": [f"/Game/Made/M_{n:02d}" for n in range(25)]}
    verdict = verify_integrity(SCENE, many, 1, AGREED)
    assert verdict.reason.endswith("and 5 more") and len(verdict.measurements["unresolved"]) == 25


def test_the_frozen_dependency_policy() -> None:
    left_out = ["/Engine/Odd", "/Script/Odd", "/Temp/Odd", "/Paper2D/Odd", "/GAME/KNOWN/T_Old"]
    verdict = verify_integrity(
        SCENE, RESOLVED | {"unresolved": left_out}, 1, AGREED, tolerated=["/Game/Known/T_Old.T_Old"]
    )
    assert (verdict.status, verdict.measurements["tolerated"]) == ("valid", ["/Game/Known/T_Old.T_Old"])
    for name in ("/EngineMade/M", "/Game/Engine/M", "/Game/Known/T_Older", "/Plugin/M"):
        verdict = verify_integrity(SCENE, RESOLVED | {"unresolved": [name]}, 1, AGREED, tolerated=["/Game/Known/T_Old"])
        assert verdict.reason == f"unresolved_dependencies: {name}"


def test_digests_agree_without_regard_to_case_and_both_sides_are_told() -> None:
    upper = {"office": "A" * 64}
    assert verify_integrity(SCENE, RESOLVED, 1, AGREED.model_copy(update={"submission": upper})).status == "valid"
    other = AGREED.model_copy(update={"submission": {"office": "b" * 64}})
    assert verify_integrity(SCENE, RESOLVED, 1, other).reason == (
        f"manifest_disagreement: pack office of the submission has digest {'b' * 12}, not {'a' * 12}"
    )


def test_the_checks_come_in_order() -> None:
    other = AGREED.model_copy(update={"submission": {}})
    unresolved = RESOLVED | {"unresolved": ["/Game/M"]}
    assert [
        verify_integrity(given, dependencies, least, manifest).measurements["reason_code"]
        for given, dependencies, least, manifest in (
            ({}, unresolved, 9, other),
            (SCENE, unresolved, 9, other),
            (SCENE, unresolved, 2, other),
            (SCENE, RESOLVED, 2, other),
        )
    ] == ["snapshot_schema", "minimum_actors", "unresolved_dependencies", "manifest_disagreement"]


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"label": ""}, "has no label"),
        ({"label": None}, "has no label"),
        ({"class": 3}, "has no class"),
        ({"actor_path": ""}, "actor_path is no text"),
        ({"stable_actor_id": 7}, "stable_actor_id is no text"),
        ({"logical_object_id": []}, "logical_object_id is no text"),
        ({"actor_tags": "a"}, "actor_tags"),
        ({"actor_tags": [""]}, "actor_tags"),
        ({"transform": None}, "has no transform"),
        ({"bounds": None}, "has no bounds"),
        ({"bounds": {"origin_cm": [0, 0, 0]}}, "bounds.extent_cm"),
        ({"bounds": {"origin_cm": [0, 0, float("nan")], "extent_cm": [1, 1, 1]}}, "bounds.origin_cm"),
        (
            {"transform": {"location_cm": [0, 0], "rotation_deg": [0, 0, 0], "scale": [1, 1, 1]}},
            "transform.location_cm",
        ),
        ({"transform": {"location_cm": [0, 0, 0], "rotation_deg": [0, True, 0], "scale": [1, 1, 1]}}, "rotation_deg"),
        ({"transform": {"location_cm": [0, 0, 0], "rotation_deg": [0, 0, 0], "scale": ["1", 1, 1]}}, "transform.scale"),
        (
            {"transform": {"location_cm": [0, 0, 0], "rotation_deg": [0, 0, 0], "scale": [10**400, 1, 1]}},
            "transform.scale",
        ),
        ({"properties": []}, "properties"),
        ({"component_material_slots": {}}, "no list"),
        ({"component_material_slots": [3]}, "not an object"),
        ({"component_material_slots": [{"slot_index": 0}]}, "component_identity"),
        ({"component_material_slots": [{"component_identity": "c", "slot_index": -1}]}, "no index"),
        ({"component_material_slots": [{"component_identity": "c", "slot_index": 0, "material_path": ""}]}, "a path"),
        (
            {"component_material_slots": [{"component_identity": "c", "slot_index": 0, "material_path": None}]},
            "dynamic",
        ),
        (
            {
                "component_material_slots": 2
                * [{"component_identity": "c", "slot_index": 0, "material_path": None, "is_dynamic": False}]
            },
            "twice",
        ),
    ],
)
def test_what_the_schema_asks_of_an_actor(change: dict[str, Any], said: str) -> None:
    broken = scene(actor("chair", "Chair", (0, 0, 0)) | change)
    verdict = verify_integrity(broken, RESOLVED, 1, AGREED)
    assert (verdict.status, verdict.measurements["reason_code"]) == ("invalid", "snapshot_schema")
    assert said in verdict.reason and "actor 0" in verdict.reason


def test_what_the_schema_leaves_open() -> None:
    bare = {
        name: value
        for name, value in actor("chair", "Chair", (0, 0, 0)).items()
        if name in ("label", "class", "transform", "bounds")
    }
    loose = bare | {"stable_actor_id": None, "actor_tags": None, "properties": None, "component_material_slots": None}
    for given in (bare, loose):
        assert verify_integrity(scene(given), RESOLVED, 1, AGREED).status == "valid"
    uncounted = {name: value for name, value in SCENE.items() if name != "actor_count"}
    assert verify_integrity(uncounted, RESOLVED, 1, AGREED).status == "valid"
    for count in (True, 2.0, "2", 3):
        assert verify_integrity(SCENE | {"actor_count": count}, RESOLVED, 1, AGREED).status == "invalid"
