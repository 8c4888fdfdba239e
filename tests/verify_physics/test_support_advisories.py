"""The support rule's oddities are told for the actors concerned, and only for them."""

from __future__ import annotations

from typing import Any

from c4s.verify.physics.support import text_to_scene_support
from c4s.verify.physics.verdict import verify_physics


def box(name: str, bottom: float, half: float = 10.0, x: float = 0.0, **more: Any) -> dict[str, Any]:
    return {
        "name": name,
        "label": name,
        "class": "/Script/Engine.StaticMeshActor",
        "transform": {"location_cm": [x, 0, bottom], "rotation_deg": [0, 0, 0], "scale": [1, 1, 1]},
        "bounds": {"origin_cm": [x, 0, bottom + half], "extent_cm": [half] * 3},
    } | more


TABLE = box("Table", 0, 50)


def told(*actors: dict[str, Any]) -> dict[str, list[str]]:
    scene = {"actors": list(actors)}
    before = text_to_scene_support(scene).rate
    verdict = verify_physics("text-to-scene", scene)
    assert verdict.measurements["leaf_results"][0]["score"] == before
    return {
        note["code"]: note["actors"]
        for note in verdict.advisories
        if note["code"] in ("sunk_into_its_support", "supported_below_ground", "helper_tested_for_support")
    }


def test_what_reaches_into_its_support() -> None:
    assert told(
        TABLE,
        box("Sunk", 100 - 1e-7),
        box("Deep", 95, x=20),
        box("Deeper", 94.9, x=-20),
        box("Flush", 100),
        box("Beside", 97, x=200),
    ) == {"sunk_into_its_support": ["Sunk", "Deep"]}


def test_what_is_buried() -> None:
    assert told(box("Buried", -500), box("Edge", -5), box("Under", -5.1)) == {
        "supported_below_ground": ["Buried", "Under"]
    }


def test_helpers_that_are_tested() -> None:
    lamp = {"class": "/Script/Engine.PointLight"}
    assert told(
        box("PointLight", 300, **lamp), box("Light_2", 300, **lamp), box("Cup", 300), box("PointLight_low", 0, **lamp)
    ) == {"helper_tested_for_support": ["PointLight"]}


def test_switched_off_collision_is_told_with_how_far_it_shrinks_the_population() -> None:
    meshes = {"/Game/P/Crate": {"collision": [{"kind": "box"}]}, "/Game/P/Grass": {"collision": []}}

    def made(name: str, mesh: str, on: bool, x: float) -> dict[str, Any]:
        return box(name, 0, x=x, component_asset_paths=[mesh], collision={"collision_enabled": on})

    actors = [
        made("Ghost", "/Game/P/Crate", False, 0),
        made("Honest", "/Game/P/Crate", True, 100),
        made("Grass", "/Game/P/Grass", False, 200),
    ]
    verdict = verify_physics("text-to-scene", {"actors": actors, "c4s": {"meshes": meshes}}, contacts=[])
    (note,) = [note for note in verdict.advisories if note["code"] == "collision_switched_off"]
    assert note["actors"] == ["Ghost"] and "1 of 3" in note["text"]
