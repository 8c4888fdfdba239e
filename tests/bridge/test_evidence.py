"""Evidence from a real, clean engine: the snapshot, the dependencies, the pictures, and their digests."""

from __future__ import annotations

import os
import shutil
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from c4s.errors import BadInput, MachineryFault
from c4s.evidence import Shots, export_and_look, export_evidence, export_level, look
from c4s.files import digest_file, read_json, write_json
from c4s.records.captures import Captures, ClaimViews, ViewCoverage
from c4s.records.folder import EvidenceFolder
from c4s.run.check import noted_digests
from c4s.trees import digest_tree

PACKAGE = "/Game/SavedScenes/Room"


@pytest.fixture
def submission(tmp_path: Path, level: Path) -> Path:
    """A submission that holds the level under its saved name."""
    document = read_json(level)
    path = tmp_path / "submission" / "Game" / "SavedScenes" / "Room.level.json"
    path.parent.mkdir(parents=True)
    write_json(path, {**document, "package": PACKAGE})
    return tmp_path / "submission"


def in_front(snapshot: dict[str, Any]) -> list[dict[str, Any]]:
    """One camera in front of the box, made from the snapshot as the evaluator does."""
    box = next(actor for actor in snapshot["actors"] if actor["label"] == "Box")
    x, y, z = box["bounds"]["origin_cm"]
    return [
        {
            "name": "front",
            "location_cm": [x - 400, y, z + 100],
            "target_cm": [x, y, z],
            "fov_deg": 60,
            "publish": {"width": 160, "height": 90},
        }
    ]


def planned(snapshot: dict[str, Any], _: Any) -> Shots:
    """The camera in front as a plan."""
    return Shots(in_front(snapshot))


def test_everything_is_exported_and_digested(tmp_path: Path, submission: Path) -> None:
    before, out = digest_tree(submission), tmp_path / "trial" / "evidence"
    export_and_look(
        engine="headless", packs=[], submission_content=submission, package=PACKAGE, out=out, cameras=planned
    )
    snapshot, captures = read_json(out / "snapshot.json"), read_json(out / "captures" / "captures.json")
    assert [actor["label"] for actor in snapshot["actors"]] == ["Floor", "Box", "Ball"]
    assert read_json(out / "dependencies.json")["root"] == PACKAGE
    view = captures["views"][0]
    assert view["name"] == "front" and view["file"] == "front.png" and (out / "captures" / "front.png").is_file()
    assert view["camera"]["width"] == 160 and view["visible"]["StaticMeshActor_1"] > 100
    mask = np.load(out / "captures" / view["actors"])
    assert mask["labels"][mask["actor"][45, 80]] == "Box"
    assert set(noted_digests(EvidenceFolder(out))) == {
        "snapshot.json",
        "dependencies.json",
        "captures/captures.json",
        "captures/front.png",
        "captures/front.actors.npz",
    }
    assert all(digest_file(out / name) == value for name, value in noted_digests(EvidenceFolder(out)).items())
    assert digest_tree(submission) == before

    first = noted_digests(EvidenceFolder(out))
    export_and_look(
        engine="headless", packs=[], submission_content=submission, package=PACKAGE, out=out, cameras=planned
    )
    assert noted_digests(EvidenceFolder(out)) == first


def test_two_stages_by_two_engines_make_the_same_evidence(tmp_path: Path, submission: Path) -> None:
    given: dict[str, Any] = {"engine": "headless", "packs": [], "submission_content": submission, "package": PACKAGE}
    out = tmp_path / "evidence"
    snapshot = export_evidence(**given, out=out)
    assert snapshot == read_json(out / "snapshot.json")
    assert set(noted_digests(EvidenceFolder(out))) == {"snapshot.json", "dependencies.json"}
    look(**given, out=out, cameras=[{**in_front(snapshot)[0], "name": "other"}])
    look(**given, out=out, cameras=planned)
    export_and_look(**given, out=tmp_path / "both", cameras=planned)
    assert digest_tree(out) == digest_tree(tmp_path / "both")
    assert all(digest_file(out / name) == value for name, value in noted_digests(EvidenceFolder(out)).items())
    captures = read_json(out / "captures" / "captures.json")
    assert captures["engine"] == snapshot["c4s"]["engine"] == "headless"
    assert captures["engine_version"] == snapshot["c4s"]["engine_version"] != ""
    export_evidence(**given, out=out)
    assert not (out / "captures").exists()


def test_a_plan_looks_through_cameras_before_it_chooses(tmp_path: Path, submission: Path) -> None:
    out, told = tmp_path / "evidence", []

    def plan(snapshot: dict[str, Any], probe: Any) -> Shots:
        box = next(actor for actor in snapshot["actors"] if actor["label"] == "Box")
        x, y, z = box["bounds"]["origin_cm"]
        size = {"fov_deg": 60, "width": 160, "height": 90}
        cameras = [
            {"name": "away", "location_cm": [x - 400, y, z], "rotation_deg": [0, 180, 0], **size},
            {"name": "front", "location_cm": [x - 400, y, z], "rotation_deg": [0, 0, 0], **size},
            {"name": "touching", "location_cm": [x - 60, y, z], "rotation_deg": [0, 0, 0], **size},
        ]
        told.extend(probe(cameras))
        assert probe([]) == []
        claim = ClaimViews(primary=["front"], targets=[box["name"]], coverage=ViewCoverage(targets=1, sought=1, seen=1))
        return Shots([{**cameras[1], "purpose": "claim"}], {"r1": claim})

    given: dict[str, Any] = {"engine": "headless", "packs": [], "submission_content": submission, "package": PACKAGE}
    export_and_look(**given, out=out, cameras=plan)
    away, front, touching = told
    assert "StaticMeshActor_1" not in away["visible"] and away["empty_share"] > 0.4
    assert front["near_share"] == 0 and front["visible"]["StaticMeshActor_1"] > 100
    assert "StaticMeshActor_1" not in front["edge"]
    assert touching["near_share"] > 0.5 and "StaticMeshActor_1" in touching["edge"]
    captures = Captures.read(out / "captures" / "captures.json")
    assert [(view.name, view.purpose) for view in captures.views] == [("front", "claim")]
    assert captures.claims["r1"].targets == ["StaticMeshActor_1"]
    (view,) = captures.of("claim")
    assert view.visible is not None
    assert view.visible["StaticMeshActor_1"] == pytest.approx(front["visible"]["StaticMeshActor_1"], rel=0.01)


def test_a_look_is_by_the_engine_that_exported(tmp_path: Path, submission: Path) -> None:
    given: dict[str, Any] = {"engine": "headless", "packs": [], "submission_content": submission, "package": PACKAGE}
    out = tmp_path / "evidence"
    with pytest.raises(BadInput, match="snapshot"):
        look(**given, out=out, cameras=planned)
    snapshot = export_evidence(**given, out=out)
    before = digest_tree(out)
    with pytest.raises(BadInput, match="no camera"):
        look(**given, out=out, cameras=[])
    assert digest_tree(out) == before
    write_json(out / "snapshot.json", {**snapshot, "c4s": {**snapshot["c4s"], "engine": "unreal"}})
    with pytest.raises(MachineryFault, match="this one is headless"):
        look(**given, out=out, cameras=planned)
    with pytest.raises(BadInput, match="there is headless"):
        export_evidence(**{**given, "engine": "unity"}, out=out)


def test_a_level_that_is_not_there_is_bad_input_and_leaves_nothing(tmp_path: Path, submission: Path) -> None:
    with pytest.raises(BadInput, match="no such start map"):
        export_and_look(
            engine="headless",
            packs=[],
            submission_content=submission,
            package="/Game/SavedScenes/Other",
            out=tmp_path / "evidence",
        )
    assert not (tmp_path / "evidence").exists()
    with pytest.raises(BadInput, match="no submission"):
        export_and_look(
            engine="headless",
            packs=[],
            submission_content=tmp_path / "none",
            package=PACKAGE,
            out=tmp_path / "evidence",
        )


def test_a_submission_that_links_to_the_truth_is_refused(tmp_path: Path, submission: Path, level: Path) -> None:
    stolen = submission / "Game" / "SavedScenes" / "Room.level.json"
    stolen.unlink()
    stolen.symlink_to(level)
    with pytest.raises(BadInput, match="plain files only"):
        export_and_look(
            engine="headless", packs=[], submission_content=submission, package=PACKAGE, out=tmp_path / "evidence"
        )
    stolen.unlink()
    os.mkfifo(stolen)
    with pytest.raises(BadInput, match="plain files only"):
        export_and_look(
            engine="headless", packs=[], submission_content=submission, package=PACKAGE, out=tmp_path / "evidence"
        )


def test_a_truth_is_exported_from_where_agents_cannot_see_it(tmp_path: Path, level: Path) -> None:
    truth = tmp_path / "withheld" / "case" / "truth.level.json"
    truth.parent.mkdir(parents=True)
    shutil.copyfile(level, truth)
    export_level(engine="headless", packs=[], level=truth, out=truth.parent / "truth.snapshot.json")
    snapshot = read_json(truth.parent / "truth.snapshot.json")
    assert snapshot["actor_count"] == 3 and snapshot["map_path"] == "/Game/Start/Room"


def test_a_truncated_level_is_bad_input(tmp_path: Path, level: Path) -> None:
    level.write_text(level.read_text()[:200])
    with pytest.raises(BadInput):
        export_level(engine="headless", packs=[], level=level, out=tmp_path / "snapshot.json")
