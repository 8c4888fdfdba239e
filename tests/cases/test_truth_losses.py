"""What a truth loses to physics is told with actor, partner, depth, tolerance and bodies."""

from __future__ import annotations

import copy
from typing import Any

import pytest

from c4s.packs.store import PackStore
from cases.losses import losses_of, told

HALF = {"kind": "box", "center": [0, 0, 0], "half_extent": [50, 50, 50]}
AWAY = {"kind": "box", "center": [0, 0, 500], "half_extent": [5, 5, 5]}


def actor(name: str, at: list[float], mesh: str = "crate") -> dict[str, Any]:
    place = {"location_cm": at, "rotation_deg": [0, 0, 0], "scale": [1, 1, 1]}
    component = {
        "name": "Mesh",
        "class": "/Script/Engine.StaticMeshComponent",
        "mesh": mesh,
        "transform": place,
        "collision_enabled": True,
    }
    return {
        "name": name,
        "label": name,
        "stable_actor_id": name,
        "class": "/Script/Engine.StaticMeshActor",
        "component_asset_paths": [mesh],
        "transform": place,
        "bounds": {"origin_cm": at, "extent_cm": [50, 50, 50]},
        "c4s": {"components": [component]},
    }


def scene(*actors: dict[str, Any]) -> dict[str, Any]:
    facts = {"sha256": None, "bounds_min_cm": [-50, -50, -50], "bounds_max_cm": [50, 50, 50], "collision": [AWAY, HALF]}
    return {"actors": list(actors), "c4s": {"meshes": {"crate": facts}}}


def test_a_truth_that_sinks_into_another_is_named_with_its_bodies() -> None:
    truth = scene(actor("a", [0, 0, 50]), actor("b", [80, 0, 50]), actor("c", [500, 0, 50]))
    score, rows = losses_of("text-to-scene", truth, None, PackStore([]))
    assert score is not None and score < 1
    row = next(row for row in rows if row["actor"] == "a")
    assert row == {
        "leaf": "solid_penetration",
        "actor": "a",
        "partner": "b",
        "depth_cm": pytest.approx(20),
        "tolerance_cm": 5.0,
        "body": "#1 box",
        "partner_body": "#1 box",
    }
    assert {row["actor"] for row in rows} == {"a", "b"}
    report = {"cases": [{"case_id": "x", "score": score, "losses": rows}], "judged": 1, "below_one": 1, "losses": 2}
    lines = told(report)
    assert "1 of 1 cases lose points" in lines[0]
    assert "a (#1 box) sinks 20.0 cm into b (#1 box), 5 allowed: x" in lines[1]


def test_a_repair_loses_what_its_edits_lose_and_no_more() -> None:
    truth = scene(actor("a", [0, 0, 50]), actor("b", [80, 0, 50]), actor("high", [500, 0, 250]))
    start = copy.deepcopy(truth)
    start["actors"][2] = actor("high", [900, 0, 250])
    _, rows = losses_of("image-to-scene/indoor", truth, start, PackStore([]))
    assert [(row["leaf"], row["actor"]) for row in rows] == [("floating", "high")]
    assert told({"cases": [], "judged": 3, "below_one": 0, "losses": 0}) == [
        "physics of the truth: 1.000 in all 3 cases"
    ]
