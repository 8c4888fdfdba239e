"""Evidence from a real, clean engine: the snapshot, the dependencies, the pictures, and their digests."""

from __future__ import annotations

import os
import shutil
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from c4s.errors import BadInput
from c4s.evidence.collect import collect, export_level
from c4s.files import digest_file, read_json, write_json
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


def look(snapshot: dict[str, Any]) -> list[dict[str, Any]]:
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


def test_everything_is_exported_and_digested(tmp_path: Path, submission: Path) -> None:
    before, out = digest_tree(submission), tmp_path / "trial" / "evidence"
    collect(packs=[], submission_content=submission, package=PACKAGE, out=out, cameras=look)
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
    collect(packs=[], submission_content=submission, package=PACKAGE, out=out, cameras=look)
    assert noted_digests(EvidenceFolder(out)) == first


def test_a_level_that_is_not_there_is_bad_input_and_leaves_nothing(tmp_path: Path, submission: Path) -> None:
    with pytest.raises(BadInput, match="no such start map"):
        collect(packs=[], submission_content=submission, package="/Game/SavedScenes/Other", out=tmp_path / "evidence")
    assert not (tmp_path / "evidence").exists()
    with pytest.raises(BadInput, match="no submission"):
        collect(packs=[], submission_content=tmp_path / "none", package=PACKAGE, out=tmp_path / "evidence")


def test_a_submission_that_links_to_the_truth_is_refused(tmp_path: Path, submission: Path, level: Path) -> None:
    stolen = submission / "Game" / "SavedScenes" / "Room.level.json"
    stolen.unlink()
    stolen.symlink_to(level)
    with pytest.raises(BadInput, match="plain files only"):
        collect(packs=[], submission_content=submission, package=PACKAGE, out=tmp_path / "evidence")
    stolen.unlink()
    os.mkfifo(stolen)
    with pytest.raises(BadInput, match="plain files only"):
        collect(packs=[], submission_content=submission, package=PACKAGE, out=tmp_path / "evidence")


def test_a_truth_is_exported_from_where_agents_cannot_see_it(tmp_path: Path, level: Path) -> None:
    truth = tmp_path / "withheld" / "case" / "truth.level.json"
    truth.parent.mkdir(parents=True)
    shutil.copyfile(level, truth)
    export_level(packs=[], level=truth, out=truth.parent / "truth.snapshot.json")
    snapshot = read_json(truth.parent / "truth.snapshot.json")
    assert snapshot["actor_count"] == 3 and snapshot["map_path"] == "/Game/Start/Room"


def test_a_truncated_level_is_bad_input(tmp_path: Path, level: Path) -> None:
    level.write_text(level.read_text()[:200])
    with pytest.raises(BadInput):
        export_level(packs=[], level=level, out=tmp_path / "snapshot.json")
