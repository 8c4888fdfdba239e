"""``setup_environment`` in a repair costs nothing: the truth and that call score what the truth scores."""

from __future__ import annotations

from pathlib import Path

import pytest

from bench.answers import PACK, opened
from c4s.evidence import export_evidence
from c4s.records.level import Level
from c4s.verify.repair.verdict import verify_repair
from cases.applying import apply
from cases.corruption import with_identities
from cases.model import RepairCase
from cases.starter import harbour_scene
from cases.starter.outdoor_cases import cases, scenes
from tests.built import built_packs


@pytest.fixture(scope="module")
def packs(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return built_packs(tmp_path_factory, PACK)


def exported(root: Path, packs: Path, package: str) -> Path:
    """The snapshot of a saved level, from a clean engine."""
    out = root / package.rpartition("/")[2]
    export_evidence(
        engine="headless", packs=[packs / PACK], submission_content=root / "content", package=package, out=out
    )
    return out / "snapshot.json"


def placed(root: Path, level: Level) -> str:
    """Write a level into the content; its package."""
    level.write(root / "content" / f"{level.package[1:]}.level.json")
    return level.package


def test_the_truth_and_the_call_score_one(tmp_path: Path, packs: Path) -> None:
    case = next(case for case in cases(scenes()) if case.case_id == "outdoor-harbour-market-row")
    assert isinstance(case, RepairCase)
    truth = with_identities(harbour_scene.build().level, harbour_scene.SCENE_ID)
    bare = truth.model_copy(
        update={
            "actors": [actor for actor in truth.actors if "Fog" not in actor.class_path],
            "package": "/Game/T/Truth",
        }
    )
    start = apply(bare, case.operations, "/Game/T/Start")
    with opened(tmp_path, bare, packs) as client:
        told = client.call("setup_environment", time_of_day="noon", ground_size=100).data
        assert told["added"] == [] and "Fog" in told["missing"] and "Ground" in told["stands"]
        assert "nothing was added" in told["note"] and "ground_size and time_of_day not used" in told["note"]
        client.call("setup_environment")
        assert client.call("measure_scene").data["changed_or_added"] == 0
        client.call("save_scene_as", name="called")
    snapshots = {
        "start": exported(tmp_path, packs, placed(tmp_path, start)),
        "truth": exported(tmp_path, packs, placed(tmp_path, bare)),
        "called": exported(tmp_path, packs, "/Game/SavedScenes/called"),
    }
    scores = [
        verify_repair(snapshots["start"], snapshots["truth"], snapshots[name]).score
        for name in ("truth", "called", "start")
    ]
    assert scores[:2] == [1.0, 1.0] and scores[2] == 0.0
