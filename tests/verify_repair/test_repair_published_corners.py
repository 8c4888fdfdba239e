"""Corners of the published comparison rules, read in the published source: what counts as equal, and who is who."""

from __future__ import annotations

from copy import deepcopy
from typing import Any

import pytest

from c4s.verify.repair.batch import repair_row
from tests.verify_repair.repair_scenes import Scene, actor, moved, scene

ROOM = scene(
    actor("globe", "Globe", (0, 0, 80)), actor("chair", "Chair", (120, 0, 0)), actor("plant", "Plant", (-150, 40, 0))
)
START = moved(ROOM, "chair", 60)


def everywhere(change: dict[str, Any], *numbers: int) -> dict[str, Scene]:
    """The case with some actors changed alike in all three scenes; the chair is repaired."""
    scenes = {name: deepcopy(value) for name, value in (("input", START), ("ground_truth", ROOM), ("candidate", ROOM))}
    for given in scenes.values():
        for number in numbers:
            record = given["actors"][number]
            record |= {name: value for name, value in change.items() if name != "location_cm"}
            if "location_cm" in change:
                record["transform"]["location_cm"] = change["location_cm"]
    return scenes


def counts(scenes: dict[str, Scene]) -> Any:
    answer = repair_row({"name": "case", **scenes})
    return "refused" if "error" in answer else (answer["tp"], answer["fp"], answer["fn"])


@pytest.mark.parametrize("vector", [[float("nan"), 0, 0], None, "x", ["a", 0, 0], {}])
def test_vectors_that_are_no_numbers_differ_even_from_themselves(vector: Any) -> None:
    assert counts(everywhere({"location_cm": vector}, 0)) == (1, 1, 1)


@pytest.mark.parametrize("vector", [["0", "0", "80"], [True, 0, 0]])
def test_what_can_be_read_as_numbers_is_compared_as_numbers(vector: Any) -> None:
    assert counts(everywhere({"location_cm": vector}, 0)) == (1, 0, 0)


def test_an_id_that_is_no_text_is_none() -> None:
    assert counts(everywhere({"stable_actor_id": 7}, 0, 2)) == (1, 0, 0)


def test_a_blank_label_is_a_label() -> None:
    assert counts(everywhere({"stable_actor_id": None, "label": "  "}, 0)) == (1, 0, 0)


def test_labels_that_differ_in_blanks_are_two_identities() -> None:
    scenes = everywhere({"stable_actor_id": None}, 0, 2)
    for given in scenes.values():
        given["actors"][0]["label"], given["actors"][2]["label"] = "a", " a"
    assert counts(scenes) == (1, 0, 0)


@pytest.mark.parametrize("nothing", [None, "", "  "])
def test_empty_component_assets_are_no_part_of_the_kind(nothing: Any) -> None:
    scenes = everywhere({}, 0)
    for given in (scenes["input"], scenes["ground_truth"], scenes["candidate"]):
        given["actors"][1]["component_asset_paths"].append(nothing)
    scenes["candidate"]["actors"][1]["component_asset_paths"].pop()
    assert counts(scenes) == (1, 0, 0)


@pytest.mark.parametrize(("before", "after"), [(5000, 5000.0), (1, True), (0, -0.0)])
def test_visible_properties_are_compared_as_they_are_written(before: Any, after: Any) -> None:
    scenes = everywhere({"properties": {"Intensity": before}}, 0)
    for name in ("ground_truth", "candidate"):
        scenes[name]["actors"][0]["properties"] = {"Intensity": after}
    assert counts(scenes) == (2, 0, 0)


@pytest.mark.parametrize(("before", "after"), [(5000, 5000.0), (1, True)])
def test_other_properties_are_compared_as_values(before: Any, after: Any) -> None:
    scenes = everywhere({"properties": {"mass": before}}, 0)
    scenes["candidate"]["actors"][0]["properties"] = {"mass": after}
    assert counts(scenes) == (1, 0, 0)
