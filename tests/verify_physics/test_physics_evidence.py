"""Contacts and support as records of their own: a verdict from records read back is the verdict computed directly."""

from __future__ import annotations

import copy
import json
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from test_crowds import crowd
from test_edited_support import MESHES, SLAB, WALL, box, picture, scene
from test_physics_verdict import actor, snapshot

from c4s.collision import Contact
from c4s.errors import BadInput
from c4s.files import read_json, write_json
from c4s.verify.physics.verdict import measure_contacts, measure_support, verify_physics

T2S, I2S = "text-to-scene", "image-to-scene/outdoor"


def through_json(record: dict[str, Any]) -> dict[str, Any]:
    found: dict[str, Any] = json.loads(json.dumps(record, allow_nan=False))
    return found


def edited_crowd(seed: int, count: int) -> tuple[dict[str, Any], dict[str, Any]]:
    """A crowd, and its start in which every third actor stood elsewhere."""
    after = crowd(seed, count, 60.0)
    before = copy.deepcopy(after)
    for one in before["actors"][::3]:
        one["transform"]["location_cm"][0] += 500.0
    return after, before


@settings(max_examples=15)
@given(st.integers(0, 2**32 - 1), st.integers(2, 40), st.sampled_from([T2S, I2S]), st.sampled_from([None, 0, 1]))
def test_a_verdict_from_records_is_the_verdict(seed: int, count: int, setting: str, lost: int | None) -> None:
    after, before = edited_crowd(seed, count)
    if lost is not None:
        del after["actors"][lost]["c4s"]
    contacts = measure_contacts(setting, after, before)
    support = measure_support(setting, after, before)
    assert through_json(contacts) == contacts and through_json(support) == support
    direct = verify_physics(setting, after, before)
    assert (
        verify_physics(setting, after, before, contacts=through_json(contacts), support=through_json(support)) == direct
    )
    assert verify_physics(setting, after, before, contacts=contacts) == direct
    assert verify_physics(setting, after, before, support=support) == direct


def test_records_are_files_and_carry_what_the_meshes_told(tmp_path: Path) -> None:
    after, before = scene(SLAB, WALL, picture(1.0), box("Crate", (0, 300, 50))), scene(SLAB, WALL)
    write_json(tmp_path / "contacts.json", measure_contacts(I2S, after, before))
    write_json(tmp_path / "support.json", measure_support(I2S, after, before, meshes=MESHES))
    contacts, support = (read_json(tmp_path / name) for name in ("contacts.json", "support.json"))
    verdict = verify_physics(I2S, after, before, contacts=contacts, support=support)
    assert verdict == verify_physics(I2S, after, before, meshes=MESHES)
    rows = verdict.measurements["leaf_results"][0]["actors"]
    assert [(row["actor"], row["mode"], row["method"]) for row in rows] == [
        ("Picture", "lateral", "vertices"),
        ("Crate", "ground", "vertices"),
    ]


def test_the_verdict_rests_on_the_records_not_on_the_bodies() -> None:
    after, before = scene(SLAB, box("Crate", (0, 0, 50))), scene(SLAB)
    support = measure_support(I2S, after, before, meshes=MESHES)
    support["rows"][0]["state"] = "floating"
    contacts = measure_contacts(I2S, after, before)
    contacts["contacts"] = [ROW]
    assert verify_physics(I2S, after, before, contacts=contacts, support=support).score == 0.0


def test_text_scenes_tell_the_gap_of_each_supported_actor() -> None:
    found = snapshot(
        actor("Low", (0, 0, 40)), actor("On", (0, 0, 142)), actor("Up", (0, 0, 900)), actor("Sky", (0, 0, 0))
    )
    record = measure_support(T2S, found)
    assert [(row["actor"], row["state"], row["gap_cm"]) for row in record["rows"]] == [
        ("Low", "supported", -10.0),
        ("On", "supported", 2.0),
        ("Up", "floating", None),
    ]
    assert record["excluded"] == 1
    record["error"] = "no box"
    assert verify_physics(T2S, found, support=record).measurements["leaf_results"][0]["status"] == "error"


ROW = {"a": 0, "b": 1, "a_name": "Slab", "b_name": "Crate", "depth_cm": 30.0, "trusted": True}


def test_records_of_something_else_are_refused() -> None:
    after, before = scene(SLAB, box("Crate", (0, 0, 50))), scene(SLAB)
    contacts, support = measure_contacts(I2S, after, before), measure_support(I2S, after, before)
    for change in (
        {"scene": support["scene"] | {"actors": 9}},
        {"scene": support["scene"] | {"setting": T2S}},
        {"scene": support["scene"] | {"edited": [0]}},
        {"schema_version": "c4s.support.v9"},
        {"scene": None},
        {"rows": [support["rows"][0] | {"actor": "Slab"}], "contacts": [ROW | {"b_name": "Slab"}]},
        {"rows": [support["rows"][0] | {"index": 2}], "contacts": [ROW | {"a": -1}]},
        {"rows": [{}], "contacts": [{}]},
    ):
        with pytest.raises(BadInput, match="measure the scene again"):
            verify_physics(I2S, after, before, support=support | change)
        with pytest.raises(BadInput, match="measure the scene again"):
            verify_physics(I2S, after, before, contacts=contacts | change)
    with pytest.raises(BadInput):
        verify_physics(I2S, after, before, support=contacts)
    with pytest.raises(BadInput):
        measure_support(I2S, after)


def test_an_unknown_population_is_told_in_both_records() -> None:
    twins = scene(SLAB, box("Twin", (0, 0, 50)), box("Twin", (300, 0, 50)))
    for record in (measure_contacts(I2S, twins, scene(SLAB)), measure_support(I2S, twins, scene(SLAB))):
        assert "two actors have the identity" in record["scene"]["fault"]
    verdict = verify_physics(I2S, twins, scene(SLAB), support=measure_support(I2S, twins, scene(SLAB)))
    assert verdict.status == "not_evaluated"


def test_contacts_of_another_engine_without_a_depth_become_a_record() -> None:
    pair = snapshot(actor("A", (0, 0, 50), bodies=False), actor("B", (20, 0, 50), bodies=False))
    leaf = verify_physics(T2S, pair, contacts=[Contact("A", "B", float("nan"), False, 0, 1)])
    assert leaf.measurements["leaf_results"][1]["unresolved"] == 2
