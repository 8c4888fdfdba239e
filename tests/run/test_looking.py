"""What a repair is photographed from: its agent's cameras, and held-out ones that the original is seen from too."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from c4s.files import read_json
from c4s.records.captures import Captures
from c4s.records.folder import TrialFolder
from c4s.records.suite import SuiteFolder
from c4s.semantics.sight.pairs import HELD_OUT_DEG
from tests.run.conftest import trial_in
from tests.run.handed_on import baselines_home

CASE = "indoor-flat-02-living-room"


@pytest.fixture(scope="module")
def trials(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, dict[str, TrialFolder]]:
    """A repair by an agent that does nothing, and by one that restores everything."""
    own = baselines_home(tmp_path_factory)
    return own, {agent: trial_in(own, "small", agent, CASE) for agent in ("noop", "oracle")}


def test_the_original_is_seen_from_the_same_held_out_cameras(trials: tuple[Path, dict[str, TrialFolder]]) -> None:
    own, folders = trials
    for agent, folder in folders.items():
        captures = Captures.read(folder.evidence.captures_index)
        targets, truths = captures.of("target"), captures.of("truth")
        assert 1 < len(targets) == len(truths) <= 4 and len(captures.of("reference")) == 2
        for target, truth in zip(targets, truths, strict=True):
            assert target.pair == truth.pair != "" and target.camera == truth.camera
            masks = [np.load(folder.evidence.captures / str(view.actors))["actor"] for view in (target, truth)]
            assert (np.array_equal(*masks)) == (agent == "oracle")
        kept = [Captures.read(index).views for index in (own / "cache/truths").glob("*/captures/captures.json")]
        assert kept.count(truths) == 1, "the original is photographed once a case"


def test_held_out_cameras_are_none_of_the_agent(trials: tuple[Path, dict[str, TrialFolder]]) -> None:
    own, folders = trials
    suite = SuiteFolder(own / "suites/small")
    known = read_json(suite.withheld(CASE) / "cameras.json")["views"]
    told = suite.agent(suite.withheld_case(CASE).alias)
    assert not [path for path in told.rglob("*") if "target" in path.name]
    for view in Captures.read(folders["noop"].evidence.captures_index).of("target"):
        for other in known:
            one = np.array(_ahead(view.camera.rotation_deg))
            two = np.subtract(other["target_cm"], other["location_cm"])
            angle = math.degrees(math.acos(float(one @ two / np.linalg.norm(two))))
            away = float(np.linalg.norm(np.subtract(view.camera.location_cm, other["location_cm"])))
            assert angle >= HELD_OUT_DEG / 2 or away > 150


def _ahead(rotation: tuple[float, float, float]) -> list[float]:
    pitch, yaw = math.radians(rotation[0]), math.radians(rotation[1])
    return [math.cos(pitch) * math.cos(yaw), math.cos(pitch) * math.sin(yaw), math.sin(pitch)]
