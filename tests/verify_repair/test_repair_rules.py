"""The rules of Actor Repair F1 on small scenes: the paper's example, invariants, and what explains a count."""

from __future__ import annotations

import json
import random
from copy import deepcopy
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from c4s.errors import BadInput
from c4s.verify.repair import RELAXED, STRICT, repair, repair_verdict, verify_repair
from c4s.verify.repair.batch import repair_batch
from tests.verify_repair.repair_scenes import Scene, actor, moved, renamed, scene, with_actor, without

ROOM = scene(
    actor("globe", "Globe", (0, 0, 80)),
    actor("chair", "Chair", (120, 0, 0)),
    actor("plant", "Plant", (-150, 40, 0)),
    actor("desk", "Desk", (0, 200, 0)),
)
BOX = actor("box", "Box", (300, 300, 0))
START = with_actor(moved(without(ROOM, "globe"), "chair", 60), BOX)


def counts(start: Scene, truth: Scene, candidate: Scene) -> tuple[int, int, int]:
    result = repair(start, truth, candidate)
    return result.tp, result.fp, result.fn


def test_the_globe_example_of_the_paper() -> None:
    candidate = renamed(without(moved(ROOM, "chair", 30), "plant"), "agent")
    result = repair(START, ROOM, candidate)
    assert (result.tp, result.fp, result.fn) == (2, 2, 1)
    assert result.precision == 0.5
    assert result.recall == pytest.approx(2 / 3)
    assert result.f1 == pytest.approx(4 / 7)


def test_explanation_names_every_target_and_every_false_positive() -> None:
    verdict = repair_verdict(START, ROOM, without(moved(ROOM, "chair", 30), "plant"))
    found = verdict.measurements
    rows = {row["actor"]: row for row in found["targets"]}
    assert {name: row["outcome"] for name, row in rows.items()} == {"globe": "TP", "box": "TP", "chair": "FN"}
    assert rows["chair"]["failed"] == ["position", "bounds_center"]
    assert rows["chair"]["errors"]["position_cm"] == 30.0
    assert sorted((row["actor"], row["kind"]) for row in found["false_positives"]) == [
        ("chair", "repair_target_wrong"),
        ("plant", "background_lost"),
    ]
    assert len(found["false_positives"]) == found["fp"]


def test_profiles_are_recorded_and_differ_where_they_should() -> None:
    candidate = moved(ROOM, "chair", 4)
    profiles = repair_verdict(START, ROOM, candidate).measurements["profiles"]
    assert [profiles[name]["tp"] for name in ("strict", "nominal", "relaxed")] == [2, 3, 3]
    assert repair(START, ROOM, candidate, STRICT).tp == 2
    assert repair(START, ROOM, moved(ROOM, "chair", 9), RELAXED).tp == 3


def test_no_operation_and_a_perfect_repair() -> None:
    assert counts(START, ROOM, ROOM) == (3, 0, 0)
    assert counts(START, ROOM, START) == (0, 1, 3)


@pytest.mark.parametrize(
    ("start", "truth", "candidate", "text"),
    [
        (ROOM, ROOM, ROOM, "no repair target"),
        (START, ROOM, {"actors": None}, "list 'actors'"),
        (START, ROOM, {"actors": [], "export_metadata": {"status": "error"}}, "did not succeed"),
        ({**START, "export_metadata": {}}, ROOM, ROOM, "did not succeed"),
        (with_actor(START, START["actors"][0]), ROOM, ROOM, "two actors"),
        (START, ROOM, [], "JSON object"),
        (START, ROOM, {"actors": [3]}, "not a JSON object"),
        (START, ROOM, {"actors": [{"class": "X"}]}, "no id"),
    ],
)
def test_scenes_that_cannot_be_scored_are_refused(start: Any, truth: Any, candidate: Any, text: str) -> None:
    with pytest.raises(BadInput, match=text):
        repair(start, truth, candidate)


def test_files_are_read_with_their_digests_and_faults_are_told_apart(tmp_path: Path) -> None:
    paths = {}
    for name, value in (
        ("input", START),
        ("truth", ROOM),
        ("candidate", ROOM),
        ("double", with_actor(ROOM, ROOM["actors"][0])),
        ("failed", {"actors": [], "export_metadata": {"status": "error"}}),
    ):
        paths[name] = tmp_path / f"{name}.json"
        paths[name].write_text(json.dumps(value))
    verdict = verify_repair(paths["input"], paths["truth"], paths["candidate"])
    assert (verdict.status, verdict.score) == ("measured", 1.0)
    assert set(verdict.inputs) == {"input_snapshot", "truth_snapshot", "candidate_snapshot"}
    assert verify_repair(paths["input"], paths["truth"], paths["double"]).status == "not_evaluated"
    assert verify_repair(paths["input"], paths["truth"], paths["failed"]).status == "error"
    paths["candidate"].write_text('{"actors": [')
    with pytest.raises(BadInput, match="not valid JSON"):
        verify_repair(paths["input"], paths["truth"], paths["candidate"])
    with pytest.raises(BadInput, match="no such snapshot"):
        verify_repair(paths["input"], paths["truth"], tmp_path / "absent.json")


def test_advisories_name_the_oddities() -> None:
    turned = deepcopy(ROOM)
    turned["actors"][1]["transform"]["rotation_deg"][1] = 180.0
    start = deepcopy(turned)
    start["actors"][1]["transform"]["rotation_deg"][1] = -180.0
    phantom = repair_verdict(start, turned, start)
    assert (phantom.score, [a["code"] for a in phantom.advisories]) == (1.0, ["euler-phantom-target"])
    dynamic = deepcopy(ROOM)
    dynamic["actors"][0]["component_material_slots"][0]["is_dynamic"] = True
    hopeless = repair_verdict(moved(dynamic, "globe", 50), dynamic, dynamic)
    assert (hopeless.score, hopeless.advisories[0]["code"]) == (0.0, "unmeasurable-material-slot")
    swapped = repair_verdict(with_actor(without(ROOM, "chair"), actor("other", "Chair", (500, 0, 0))), ROOM, ROOM)
    assert swapped.advisories[0]["code"] == "removal-shares-a-descriptor"
    assert swapped.score == pytest.approx(2 / 3)


def test_a_batch_goes_on_after_a_bad_row() -> None:
    rows = [{"name": "bad"}, 3, {"name": "good", "input": START, "ground_truth": ROOM, "candidate": ROOM}]
    answers = list(repair_batch(rows))
    assert "error" in answers[0] and "error" in answers[1]
    assert answers[2]["f1"] == 1.0


KINDS = st.sampled_from(["Chair", "Box", "Lamp"])
PLACES = st.tuples(st.integers(-6, 6), st.integers(-6, 6), st.integers(0, 1))


@st.composite
def repairs(draw: st.DrawFn) -> tuple[Scene, Scene, Scene]:
    """An input, a truth and a candidate that share most actors."""
    actors = [
        actor(f"a{n}", draw(KINDS), tuple(100.0 * v for v in draw(PLACES)), draw(st.sampled_from([0.0, 90.0])))
        for n in range(draw(st.integers(2, 8)))
    ]
    truth = scene(*actors)

    def damaged() -> Scene:
        kept = []
        for record in truth["actors"]:
            fate = draw(st.sampled_from(["keep", "keep", "keep", "move", "drop", "mesh"]))
            record = deepcopy(record)
            if fate == "move":
                record["transform"]["location_cm"][0] += draw(st.sampled_from([0.05, 3.0, 47.0]))
            elif fate == "mesh":
                record["asset_path"] = "/Game/Room/SM_Wrong.SM_Wrong"
                record["component_asset_paths"] = ["/Game/Room/SM_Wrong.SM_Wrong"]
            if fate != "drop":
                kept.append(record)
        return scene(*kept)

    start = damaged()
    if draw(st.booleans()):
        start = with_actor(start, actor("extra", draw(KINDS), (33.0, 44.0, 0.0)))
    if not any(True for _ in start["actors"]) or start["actors"] == truth["actors"]:
        start = with_actor(start, actor("stray", "Box", (777.0, 0.0, 0.0)))
    return start, truth, damaged()


def scored(start: Scene, truth: Scene, candidate: Scene) -> tuple[int, int, int] | None:
    try:
        return counts(start, truth, candidate)
    except BadInput:
        return None


@settings(max_examples=120, deadline=None)
@given(repairs(), st.randoms(use_true_random=False))
def test_order_and_names_of_the_candidate_change_nothing(case: tuple[Scene, Scene, Scene], rng: random.Random) -> None:
    start, truth, candidate = case
    shuffled = renamed(candidate, "new")
    rng.shuffle(shuffled["actors"])
    assert scored(start, truth, candidate) == scored(start, truth, shuffled)


@settings(max_examples=120, deadline=None)
@given(repairs())
def test_every_target_counts_once_and_the_rows_add_up(case: tuple[Scene, Scene, Scene]) -> None:
    start, truth, candidate = case
    if scored(start, truth, candidate) is None:
        return
    found = repair_verdict(start, truth, candidate).measurements
    assert found["tp"] + found["fn"] == len(found["targets"])
    assert sum(row["outcome"] == "TP" for row in found["targets"]) == found["tp"]
    assert len(found["false_positives"]) == found["fp"]
    assert found["profiles"]["strict"]["tp"] <= found["tp"] <= found["profiles"]["relaxed"]["tp"]


@settings(max_examples=120, deadline=None)
@given(repairs())
def test_one_stray_actor_is_one_more_false_positive(case: tuple[Scene, Scene, Scene]) -> None:
    start, truth, candidate = case
    before = scored(start, truth, candidate)
    if before is None:
        return
    stray = actor("unasked", "NothingElseIsThis", (9999.0, 9999.0, 0.0))
    stray["class"] = "/Script/Engine.SkeletalMeshActor"
    assert scored(start, truth, with_actor(candidate, stray)) == (before[0], before[1] + 1, before[2])


@settings(max_examples=60, deadline=None)
@given(repairs())
def test_the_truth_itself_repairs_everything_unless_an_advisory_says_why_not(case: tuple[Scene, Scene, Scene]) -> None:
    start, truth, _ = case
    if scored(start, truth, truth) is None:
        return
    verdict = repair_verdict(start, truth, truth)
    same_kind = any(a["code"] == "removal-shares-a-descriptor" for a in verdict.advisories)
    assert verdict.score == 1.0 or same_kind
