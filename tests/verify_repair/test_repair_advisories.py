"""Oddities of the protocol are told for the actors concerned, and false positives with how far they are off."""

from __future__ import annotations

from copy import deepcopy
from typing import Any

from c4s.records.verdict import Verdict
from c4s.verify.repair import repair_verdict
from tests.verify_repair.repair_scenes import Scene, actor, moved, scene, with_actor, without

ROOM = scene(
    actor("globe", "Globe", (0, 0, 80)), actor("chair", "Chair", (120, 0, 0)), actor("plant", "Plant", (-150, 40, 0))
)
START = moved(ROOM, "chair", 60)


def told(verdict: Verdict) -> dict[str, list[str]]:
    return {advisory["code"]: advisory["actors"] for advisory in verdict.advisories}


def edited(given: Scene, label: str, **fields: Any) -> Scene:
    result = deepcopy(given)
    next(record for record in result["actors"] if record["label"] == label).update(fields)
    return result


def test_a_clean_repair_has_none() -> None:
    assert told(repair_verdict(START, ROOM, ROOM)) == {}


def test_a_material_of_the_level_cannot_be_matched_under_another_package() -> None:
    def painted(package: str, given: Scene) -> Scene:
        path = f"/Game/{package}.{package}:PersistentLevel.Chair.Mesh.Paint"
        slot = ROOM["actors"][1]["component_material_slots"][0] | {"material_path": path}
        return edited(given, "chair", material_paths=[path], component_material_slots=[slot])

    verdict = repair_verdict(painted("Input", START), painted("Truth", ROOM), painted("Saved", ROOM))
    assert told(verdict) == {"level-local-material": ["chair"]} and verdict.measurements["tp"] == 0


def test_restoring_a_property_that_makes_no_target_is_charged() -> None:
    truth = edited(ROOM, "plant", properties={"mobility": "movable"})
    verdict = repair_verdict(START, truth, truth)
    assert told(verdict) == {"restored-property-charged": ["plant"]}
    assert (verdict.measurements["tp"], verdict.measurements["fp"]) == (1, 1)


def test_a_target_that_only_its_box_misses() -> None:
    turned = edited(ROOM, "chair", bounds={"origin_cm": [120, 0, 0], "extent_cm": [11.0, 10.0, 10.0]})
    verdict = repair_verdict(START, ROOM, turned)
    assert told(verdict) == {"box-alone-fails": ["chair"]} and verdict.measurements["fn"] == 1


def test_a_removal_by_clearing_the_mesh() -> None:
    start = with_actor(START, actor("extra", "Box", (300, 0, 0)))
    cleared = edited(
        with_actor(ROOM, actor("extra", "Box", (300, 0, 0))), "extra", asset_path=None, component_asset_paths=[]
    )
    verdict = repair_verdict(start, ROOM, cleared)
    assert told(verdict) == {"cleared-removal": ["extra"]}
    assert (verdict.measurements["tp"], verdict.measurements["fp"]) == (2, 1)


def test_a_survivor_names_both_actors() -> None:
    truth = scene(actor("kept", "Globe", (0, 0, 0)), actor("chair", "Chair", (500, 0, 0)))
    start = scene(
        actor("kept", "Globe", (0, 0, 0)), actor("chair", "Chair", (700, 0, 0)), actor("spare", "Chair", (490, 0, 0))
    )
    candidate = moved(without(start, "chair"), "spare", 10)
    verdict = repair_verdict(start, truth, candidate)
    assert told(verdict)["rebound-survivor"] == ["chair", "spare"]
    assert (verdict.measurements["tp"], verdict.measurements["fp"], verdict.measurements["fn"]) == (2, 0, 0)


def test_a_false_positive_tells_how_far_it_is_off() -> None:
    verdict = repair_verdict(START, ROOM, moved(moved(START, "chair", -50), "plant", 7))
    rows = {row["actor"]: row for row in verdict.measurements["false_positives"]}
    assert rows["plant"]["kind"] == "background_changed" and "errors" not in rows["plant"]
    assert rows["plant"]["moved"] == {"position_cm": 7.0, "rotation_deg": 0.0, "scale_pct": 0.0}
    assert rows["chair"]["moved"]["position_cm"] == 50.0 and rows["chair"]["errors"]["position_cm"] == 10.0
