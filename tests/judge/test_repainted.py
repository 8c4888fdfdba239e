"""What a thing shows goes before what its asset is called: things with other materials than their asset's."""

from __future__ import annotations

from typing import Any

import pytest

from c4s.protocol.bundle import read_requirements
from c4s.semantics.state import StateDecider
from tests.judge.test_rule_judge import bundle, entity, predicate

_PATH = "/Game/P/SM_TractorRed.SM_TractorRed"
_COLORS = {"Red": [0.5, 0.03, 0.02], "Green": [0.03, 0.22, 0.06], "Glass": [0.05, 0.1, 0.3], "Brick": [0.4, 0.2, 0.1]}


def _material(name: str) -> dict[str, Any]:
    return {"path": f"/Game/P/M_{name}.M_{name}", "texture": None, "base_color": _COLORS[name]}


def _catalog(*own: str) -> dict[str, Any]:
    told = {"name": "Tractor Red", "category": "vehicles", "tags": ["tractor"], "description": "Red steel tractor"}
    other = {
        "name": "Wall",
        "category": "walls",
        "tags": [],
        "description": "",
        "materials": [*map(_material, _COLORS)],
    }
    return {_PATH: {**told, "materials": [_material(name) for name in own]}, "/Game/P/SM_Wall.SM_Wall": other}


def _said(own: tuple[str, ...], shown: tuple[str, ...], kind: str, words: str) -> str:
    actor = {
        "name": "a",
        "class": "/Script/Engine.StaticMeshActor",
        "asset_path": _PATH,
        "component_asset_paths": [_PATH],
        "material_paths": [_material(name)["path"] for name in shown],
        "transform": {"location_cm": [0, 0, 50], "rotation_deg": [0, 0, 0], "scale": [1, 1, 1]},
        "bounds": {"origin_cm": [0, 0, 50], "extent_cm": [50, 50, 50]},
    }
    asked = bundle([entity("tractor")], predicate("attribute", "tractor", qualifiers=[{"kind": kind, "name": words}]))
    return StateDecider(read_requirements(asked), {"actors": [actor]}, _catalog(*own)).decide("p0").status


@pytest.mark.parametrize(
    ("shown", "kind", "words", "status"),
    [
        (("Red", "Glass"), "color", "red", "MATCH"),
        (("Red", "Glass"), "material", "steel", "MATCH"),
        (("Green",), "color", "red", "MISMATCH"),
        (("Green",), "color", "green", "MATCH"),
        (("Brick",), "material", "steel", "MISMATCH"),
        (("Brick",), "material", "brick", "MATCH"),
        (("Green", "Glass"), "color", "red", "MISMATCH"),
        (("Red", "Glass", "Brick"), "color", "red", "MATCH"),
    ],
)
def test_words_of_an_asset_tell_nothing_of_a_thing_that_was_repainted(
    shown: tuple[str, ...], kind: str, words: str, status: str
) -> None:
    assert _said(("Red", "Glass"), shown, kind, words) == status


def test_the_colour_of_a_window_is_not_that_of_the_thing() -> None:
    assert _said(("Red", "Glass"), ("Red", "Glass"), "color", "blue") == "UNKNOWN"
