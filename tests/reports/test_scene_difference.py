"""How two scenes differ, told actor by actor."""

from __future__ import annotations

import copy
from typing import Any

from reports.viewer import differences, three_script

LOOK = {"path": "/Game/M.M", "color": [1, 0, 0], "emissive": [0, 0, 0], "opacity": 1.0}


def actor(name: str, x: float = 0.0, *, asset: str = "/Game/A.A", scale: float = 1.0, own: str = "") -> dict[str, Any]:
    return {
        "name": name,
        "label": name,
        "class": "StaticMeshActor",
        "asset": asset,
        "id": own or f"id-{name}",
        "pose": [x, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, scale, 1.0, 1.0],
        "box": [x, 0.0, 0.0, 1.0, 1.0, 1.0],
        "parts": [[0, [0], 0]],
        "state": {},
    }


def scene(*actors: dict[str, Any]) -> dict[str, Any]:
    return {"meshes": [["/Game/A.A", "", [0, 0, 0], [1, 1, 1]]], "materials": [dict(LOOK)], "actors": list(actors)}


def told(truth: dict[str, Any], found: dict[str, Any], **pairs: str) -> list[tuple[str, str, str]]:
    return [(one.kind, one.name, one.told) for one in differences(truth, found, pairs)]


def test_equal_scenes_do_not_differ() -> None:
    whole = scene(actor("a"), actor("b", 5.0))
    assert told(whole, copy.deepcopy(whole)) == []
    assert told(whole, scene(actor("a", 0.5), actor("b", 5.0))) == [], "less than a script rounds"


def test_each_kind_is_told() -> None:
    truth = scene(actor("gone"), actor("far", 100.0), actor("wide", 200.0), actor("flat", 300.0), actor("red", 400.0))
    found = scene(
        actor("far", 130.0),
        actor("wide", 200.0, scale=1.5),
        actor("flat", 300.0, scale=-1.0),
        actor("red", 400.0),
        actor("new", asset="/Game/B.B"),
    )
    found["materials"].append({**LOOK, "path": "/Game/N.N"})
    found["actors"][3]["parts"] = [[0, [1], 0]]
    assert told(truth, found) == [
        ("missing", "", ""),
        ("extra", "new", ""),
        ("moved", "far", "30.0 cm off"),
        ("moved", "flat", "mirrored"),
        ("moved", "wide", "50.0 % scaled"),
        ("changed", "red", "another material"),
    ]


def test_a_verdict_decides_who_is_whom() -> None:
    truth, found = scene(actor("lamp")), scene(actor("near", 10.0), actor("other", 150.0))
    assert [row[:2] for row in told(truth, found)] == [("extra", "other"), ("moved", "near")]
    assert [row[:2] for row in told(truth, found, lamp="other")] == [("extra", "near"), ("moved", "other")]


def test_three_is_in_the_locked_set_up() -> None:
    script = three_script().decode()
    assert script.startswith("/**\n * @license") and "SPDX-License-Identifier: MIT" in script
    assert "eval(" not in script and "new Function" not in script
    assert len(script) < 700_000
