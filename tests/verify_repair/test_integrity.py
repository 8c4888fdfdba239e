"""The three integrity checks, and whose failure a failure is."""

from __future__ import annotations

from typing import Any

import pytest

from c4s.verify.integrity import ManifestDigests, unloadable, verify_integrity
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
    missing = RESOLVED | {"unresolved": ["/Game/Made/M_New.M_New", {"package": "/Game/Made/SM_New"}, "/Engine/Odd",
                                         "/Game/Known/T_Old"]}
    verdict = verify_integrity(SCENE, missing, 1, AGREED, tolerated=["/Game/Known/T_Old"])
    assert verdict.status == "invalid"
    assert verdict.reason == "unresolved_dependencies: /Game/Made/M_New, /Game/Made/SM_New"


@pytest.mark.parametrize(("changes", "status", "code"), [
    ({"submission": {"office": "b" * 64}}, "invalid", "manifest_disagreement"),
    ({"submission": {}}, "invalid", "manifest_disagreement"),
    ({"submission": PACKS | {"smuggled": "c" * 64}}, "invalid", "manifest_disagreement"),
    ({"scorer": {"office": "b" * 64}}, "error", "scorer_manifest")])
def test_manifests_must_agree(changes: dict[str, Any], status: str, code: str) -> None:
    verdict = verify_integrity(SCENE, RESOLVED, 1, AGREED.model_copy(update=changes))
    assert (verdict.status, verdict.measurements["reason_code"]) == (status, code)


@pytest.mark.parametrize("broken", [
    [], {"actors": []}, SCENE | {"schema_version": "9"}, SCENE | {"units": "m"}, SCENE | {"actors": {}},
    SCENE | {"actor_count": 7}, SCENE | {"actors": [1], "actor_count": 1},
    SCENE | {"actors": [{"transform": {}}], "actor_count": 1}, SCENE | {"actors": [{"class": "X"}], "actor_count": 1}])
def test_a_wrong_schema_is_invalid(broken: Any) -> None:
    verdict = verify_integrity(broken, RESOLVED, 1, AGREED)
    assert (verdict.status, verdict.measurements["reason_code"]) == ("invalid", "snapshot_schema")


def test_missing_evidence_is_the_evaluators_fault() -> None:
    assert verify_integrity(None, RESOLVED, 1, AGREED).status == "error"
    assert verify_integrity(SCENE, None, 1, AGREED).status == "error"
    failed = SCENE | {"export_metadata": {"status": "error"}}
    assert verify_integrity(failed, RESOLVED, 1, AGREED).status == "error"
    assert unloadable("the level names no world").status == "invalid"
