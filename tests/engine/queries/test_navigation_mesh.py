"""The navigation mesh of the headless engine, as scripts ask it, and the evaluator's probe over it."""

from __future__ import annotations

import json
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest
from query_scene import Scene

from c4s.navigation import NavigationSettings, approachable, measure_snapshot, published_output, read_published
from c4s.records.navigation import LETTERS, NavigationEvidence
from c4s.verify.navigation.verdict import verify_navigation
from tests.navigation.published import SCRIPT, faults_of


@pytest.fixture
def place(scene: Scene) -> Scene:
    """A plate of 20 m with a wall through it that has a door of 2 m at one end, and crates on both sides."""
    scene.put("Cube", (0, 0, -10), scale=(20, 20, 0.2)).set_actor_label("Ground plate")
    scene.put("Cube", (0, -100, 150), scale=(0.2, 18, 3)).set_actor_label("Wall")
    for number in range(16):
        x = (-1) ** number * (300 + 30 * number)
        scene.put("Cube", (x, -800 + 90 * number, 25), scale=(0.5, 0.5, 0.5)).set_actor_label(f"Crate {number}")
    return scene


def volume(scene: Scene, half: tuple[float, float, float]) -> Any:
    """A bounds volume of this half size around the origin."""
    library = scene.unreal.EditorLevelLibrary
    made = library.spawn_actor_from_class(scene.unreal.NavMeshBoundsVolume, scene.vector((0, 0, 0)))
    _, extent = made.get_actor_bounds(False)
    made.set_actor_scale3d(scene.vector([a / b for a, b in zip(half, (extent.x, extent.y, extent.z), strict=True)]))
    return made


def test_a_script_builds_a_mesh_and_asks_it(place: Scene) -> None:
    unreal, navigation = place.unreal, place.unreal.NavigationSystemV1
    volume(place, (1200, 1200, 400))
    unreal.SystemLibrary.execute_console_command(place.world, "RebuildNavigation")
    (data,) = [a for a in unreal.EditorLevelLibrary.get_all_level_actors() if isinstance(a, unreal.RecastNavMesh)]
    data.set_editor_property("agent_radius", 50.0)
    unreal.SystemLibrary.execute_console_command(place.world, "RebuildNavigation")
    here, there = place.vector((-500, -900, 0)), place.vector((700, -900, 0))
    found = navigation.project_point_to_navigation(place.world, here, None, None, place.vector((50, 50, 50)))
    assert (found.x, found.y) == pytest.approx((-500, -900), abs=0.02) and abs(found.z) <= 10
    assert navigation.project_point_to_navigation(place.world, place.vector((5000, 0, 0)), None, None) is None
    path = navigation.find_path_to_location_synchronously(place.world, here, there)
    assert path.is_valid() and not path.is_partial()
    around = float(np.hypot(440, 1750) + 120 + np.hypot(640, 1750))
    assert 0.99 * around <= path.get_path_length() <= 1.25 * around
    assert navigation.get_path_length(place.world, here, there)[0] == unreal.NavigationQueryResult.SUCCESS
    stopped = navigation.navigation_raycast(place.world, here, there)
    assert -90 < stopped.x < -40
    place.put("Cube", (0, 900, 150), scale=(0.2, 2.2, 3))
    unreal.SystemLibrary.execute_console_command(place.world, "RebuildNavigation")
    barred = navigation.find_path_to_location_synchronously(place.world, here, there)
    assert barred.is_valid() and barred.is_partial()
    near = navigation.get_random_reachable_point_in_radius(place.world, here, 300.0)
    assert near is not None and near.x < 0


def test_a_volume_brings_the_mesh_and_a_changed_setting_builds_it_anew(place: Scene) -> None:
    unreal, navigation = place.unreal, place.unreal.NavigationSystemV1
    volume(place, (1200, 1200, 400))
    (data,) = [a for a in unreal.EditorLevelLibrary.get_all_level_actors() if isinstance(a, unreal.RecastNavMesh)]
    beside = place.vector((-45, 0, 0))

    def away() -> float:
        found = navigation.project_point_to_navigation(place.world, beside, None, None, place.vector((200, 5, 50)))
        return float(abs(found.x))

    assert 34 <= away() - 10 <= 34 + 2 * 19
    data.set_editor_property("agent_radius", 100.0)
    assert 100 <= away() - 10 <= 100 + 2 * 19
    volume(place, (900, 900, 400))
    assert sum(isinstance(a, unreal.RecastNavMesh) for a in unreal.EditorLevelLibrary.get_all_level_actors()) == 1


class Inside:
    """Calls the editor's scripts in this process, as an engine does."""

    def request(self, kind: str, params: Any = None, timeout_s: float = 300.0) -> dict[str, Any]:
        raise NotImplementedError(kind)

    def call(self, function: str, /, *, timeout_s: float = 600.0, **params: Any) -> Any:
        import importlib

        module, name = function.split(".")
        return getattr(importlib.import_module(f"c4s.editor.{module}"), name)(**params)


def test_the_evaluators_probe_finds_what_the_walkable_space_finds(place: Scene, engine: ModuleType) -> None:
    from c4s.editor.snapshot import export_snapshot
    from c4s.evidence.walk import probe_navigation

    snapshot = export_snapshot()
    probed = NavigationEvidence.parse(probe_navigation(Inside(), snapshot).plain())  # type: ignore[arg-type]
    measured = measure_snapshot(snapshot)
    assert probed.made_by == "engine_mesh" and probed.fault is None
    assert probed.kept == NavigationSettings().plain()
    ours, theirs = ([LETTERS[letter] for letter in one.builds[-1].falls] for one in (measured, probed))
    assert approachable(theirs) == pytest.approx(approachable(ours) or 0.0, abs=0.06)
    assert probed.builds[-1].cells == pytest.approx(measured.builds[-1].cells, rel=0.01)
    assert len(probed.builds) == 2 and probed.small == measured.small
    assert probed.walks and all(walk.left_cm[-1] <= 10 for walk in probed.walks)


def test_a_level_without_a_volume_has_nothing_to_build(scene: Scene, tmp_path: Path, capsys: Any) -> None:
    scene.unreal.SystemLibrary.execute_console_command(scene.world, "RebuildNavigation")
    assert "no NavMeshBoundsVolume" in capsys.readouterr().out


@pytest.mark.skipif(not SCRIPT.is_file(), reason="the published measure_reachability.py is not here")
def test_the_published_probe_runs_as_it_is_and_its_output_is_evidence(
    place: Scene, engine: ModuleType, tmp_path: Path
) -> None:
    from c4s.editor.snapshot import export_snapshot

    snapshot, out = export_snapshot(), tmp_path / "reachability.json"
    volume(place, (1200, 1200, 400))
    (data,) = [a for a in engine.EditorLevelLibrary.get_all_level_actors() if isinstance(a, engine.RecastNavMesh)]
    for name, value in NavigationSettings().properties().items():
        data.set_editor_property(name, value)
    options = {"settle_wait_s": 0.01, "sample_count": 40}
    given = {"SCENE_REACHABILITY_OUTPUT": str(out), "SCENE_REACHABILITY_OPTIONS_JSON": json.dumps(options)}
    exec(compile(SCRIPT.read_text(), SCRIPT.name, "exec"), {"__name__": "__main__", **given})
    theirs = json.loads(out.read_text())
    assert theirs["diagnostics"]["status"] == "success" and faults_of(theirs) == []
    measured = measure_snapshot(snapshot)
    ours = json.loads(json.dumps(published_output(measured, snapshot)))
    assert faults_of(ours) == [] and theirs["actors"].keys() - ours["actors"].keys() == {
        path for path in theirs["actors"] if "NavMesh" in path
    }
    read = read_published(theirs, snapshot)
    assert read.made_by == "published_probe" and read.kept.keys() == measured.kept.keys() - {"min_region_area"}
    shares = [approachable([LETTERS[letter] for letter in one.builds[-1].falls]) for one in (read, measured)]
    assert shares[0] == pytest.approx(shares[1], abs=0.06)
    found = verify_navigation(read, snapshot)
    assert found.measurements["reason_code"] == "settings_not_kept" and found.score is None
