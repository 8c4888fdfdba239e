"""Corners of Repair F1 where the published scorer's reading of odd records and of ties decides."""

from __future__ import annotations

from copy import deepcopy
from typing import Any

import pytest

from c4s.verify.repair import repair
from tests.verify_repair.repair_scenes import Scene, actor, moved, scene

WALL = actor("wall", "Wall", (0, 0, 50))
CHAIR = actor("chair", "Chair", (100, 0, 50))


def counts(start: Scene, truth: Scene, candidate: Scene) -> tuple[int, int, int]:
    result = repair(start, truth, candidate)
    return result.tp, result.fp, result.fn


def with_slot(**change: Any) -> Scene:
    chair = deepcopy(CHAIR)
    chair["component_material_slots"][0] |= change
    return chair


@pytest.mark.parametrize(
    ("slot", "reached"),
    [
        ({"component_identity": ""}, False),
        ({"component_identity": "  "}, False),
        ({"component_identity": None}, False),
        ({"component_identity": 5}, True),
        ({"is_dynamic": 1}, True),
        ({"is_dynamic": True}, False),
        ({"material_path": "Material'/Game/Room/M_Chair.M_Chair'"}, True),
        ({"material_path": "'M_Chair'"}, False),
    ],
)
def test_which_material_slots_can_be_measured(slot: dict[str, Any], reached: bool) -> None:
    chair = with_slot(**slot)
    assert counts(scene(WALL), scene(WALL, chair), scene(WALL, chair)) == ((1, 0, 0) if reached else (0, 1, 1))


@pytest.mark.parametrize(
    "written", ["Material'/Game/Room/M_Chair.M_Chair'", " /Game/Room/M_Chair.M_Chair\n", "/GAME/Room/M_Chair.M_Chair"]
)
def test_material_paths_are_compared_without_export_quotes_blanks_and_case(written: str) -> None:
    other = with_slot(material_path=written) | {"material_paths": [written]}
    assert counts(scene(WALL), scene(WALL, CHAIR), scene(WALL, other)) == (1, 0, 0)
    assert counts(scene(WALL), scene(WALL, other), scene(WALL, CHAIR)) == (1, 0, 0)


def test_a_target_whose_input_actor_was_a_camera_takes_over_the_actor_of_a_removal() -> None:
    """The camera is no semantic actor of the input, so nothing stands for the target yet."""
    camera = deepcopy(CHAIR) | {"class": "/Script/Engine.CameraActor"}
    old = actor("old", "Chair", (500, 0, 50))
    made = deepcopy(CHAIR) | {"stable_actor_id": "id_made", "label": "made"}
    assert counts(scene(WALL, camera, old), scene(WALL, CHAIR), scene(WALL, made)) == (2, 0, 0)


def test_only_semantic_actors_are_the_same_but_for_identity() -> None:
    helper = deepcopy(CHAIR) | {"stable_actor_id": "id_cam", "asset_path": "/Engine/MatineeCam_SM.MatineeCam_SM"}
    wanted = {key: value for key, value in CHAIR.items() if key != "asset_path"}
    assert counts(scene(WALL, helper), scene(WALL, wanted), scene(WALL, wanted)) == (1, 0, 0)


def test_a_class_with_blanks_around_it_is_the_same_capture_helper() -> None:
    camera = deepcopy(CHAIR) | {"class": " /Script/Engine.CameraActor ", "stable_actor_id": "id_cam"}
    start, truth = scene(WALL), scene(WALL, CHAIR)
    assert counts(start, truth, scene(WALL, CHAIR, camera)) == (1, 0, 0)


@pytest.mark.parametrize("order", [(0, 1), (1, 0)])
def test_of_two_equal_actors_the_new_one_stands_for_the_target(order: tuple[int, int]) -> None:
    """A moved background actor and a new one are alike: the moved one is a wrong edit, not a repurposed loss too."""
    background = actor("spare", "Chair", (200, 0, 50))
    twins = [deepcopy(CHAIR) | {"stable_actor_id": f"id_twin{n}", "label": f"twin{n}"} for n in order]
    assert counts(scene(WALL, background), scene(WALL, background, CHAIR), scene(WALL, *twins)) == (1, 1, 0)
    away = moved(scene(background), "spare", -100)["actors"][0]
    assert counts(scene(WALL, background), scene(WALL, background, CHAIR), scene(WALL, away, twins[0])) == (1, 1, 0)
