"""Whatever an agent places has a verdict; whatever a case author writes is judged or refused in one line."""

from __future__ import annotations

import math
from copy import deepcopy
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from c4s.errors import BadInput
from c4s.protocol.bundle import MAXIMUM_NODES, read_requirements
from tests.judge.judged import verify_both, verify_detailed, verify_overview

NAMES = ("desk", "lamp", "crate")
CATALOG = {
    f"/Game/P/SM_{name}.SM_{name}": {"name": name, "category": name, "tags": [], "description": "", "materials": []}
    for name in NAMES
}
PATHS = [*CATALOG, "/Engine/BasicShapes/Cube.Cube", "/Game/Mine/SM_desk.SM_desk"]
WORDS = ["in a row", "ring", "clustered", "scattered"]
QUANTITY = {"mode": "approximately", "value": 3, "lower": None, "upper": None, "qualitative": None}
RELATIONS = ["on", "above", "under", "inside", "near", "against", "apart_from", "along", "between", "around"]


def predicate(name: str, kind: str, number: int = 0, **parameters: Any) -> dict[str, Any]:
    return {
        "node_type": "predicate",
        "id": name,
        "predicate_type": kind,
        "text": kind,
        "source_span": {"start": number, "end": number + 1},
        "semantic_parameters": parameters,
    }


def bundle(predicates: list[dict[str, Any]], subject: str = "desk", reference: str = "lamp") -> dict[str, Any]:
    entities = [
        {"node_type": "entity", "id": name, "name": name, "referent_kind": "collection", "grounding_mode": "actor"}
        for name in NAMES
    ]
    edges = [
        {"edge_type": "argument", "source_id": node["id"], "target_id": target, "ordinal": place, "role": role}
        for node in predicates
        for place, (role, target) in enumerate((("subject", subject), ("reference", reference)))
    ]
    return {
        "graph": {"prompt": "A scene. " * 4, "nodes": [*entities, *predicates], "edges": edges},
        "requirements": [{"node_id": node["id"]} for node in predicates],
    }


ALL = bundle(
    [predicate(f"r{n}", "spatial_relation", n, relation=word) for n, word in enumerate(RELATIONS)]
    + [
        predicate(f"d{n}", "distribution", n, qualifiers=[{"kind": "layout", "name": word}])
        for n, word in enumerate(WORDS)
    ]
)


def actor(number: int, path: str, centre: Any, half: Any, scale: Any = (1, 1, 1)) -> dict[str, Any]:
    return {
        "name": f"a{number}",
        "class": "/Script/Engine.StaticMeshActor",
        "asset_path": path,
        "transform": {"location_cm": list(centre), "rotation_deg": [0, 0, 0], "scale": list(scale)},
        "bounds": {"origin_cm": list(centre), "extent_cm": list(half)},
    }


def captures(scene: list[dict[str, Any]]) -> dict[str, Any]:
    return {"views": [{"visible": {each["name"]: 400 for each in scene}}] * 4}


def scores(asked: dict[str, Any], scene: list[dict[str, Any]], **extra: Any) -> tuple[float, float]:
    snapshot = {"actors": scene, **extra}
    found = [verdict.score for verdict in verify_both(asked, snapshot, CATALOG, captures(scene))]
    assert all(score is not None and 0 <= score <= 1 for score in found)
    return float(found[0] or 0), float(found[1] or 0)


NUMBER = st.one_of(st.floats(-1.7e308, 1.7e308), st.floats(-500, 500), st.sampled_from([0.0, 100.0, 5e-324]))
EXTENT = st.one_of(st.floats(0, 1e300), st.floats(0, 300), st.sampled_from([0.0, 50.0]))
TRIPLE = st.tuples(NUMBER, NUMBER, NUMBER)


@settings(max_examples=150)
@given(
    st.lists(
        st.tuples(st.sampled_from(PATHS), TRIPLE, st.tuples(EXTENT, EXTENT, EXTENT), TRIPLE), min_size=1, max_size=12
    )
)
def test_every_finite_scene_has_both_scores(rows: list[Any]) -> None:
    scores(ALL, [actor(number, *row) for number, row in enumerate(rows)])
    placements = [{"location_cm": list(c), "rotation_deg": list(r), "scale": list(s)} for _, c, s, r in rows]
    whole = actor(0, PATHS[0], (0, 0, 0), (1, 1, 1))
    whole["c4s"] = {"components": [{"mesh": path, "instances": placements} for path in PATHS]}
    meshes = {path: {"bounds_min_cm": [-50, -50, 0], "bounds_max_cm": [50, 50, 90]} for path in PATHS}
    scores(ALL, [whole], c4s={"meshes": meshes})


@pytest.mark.parametrize("place", [lambda n: (0, 0, 0), lambda n: (n * 40, 0, 0), lambda n: (n, n * n, 0)])
def test_thousands_of_instances_in_one_place_or_line(place: Any) -> None:
    meshes = {path: {"bounds_min_cm": [-50, -50, 0], "bounds_max_cm": [50, 50, 90]} for path in PATHS}
    scene = []
    for number, path in enumerate(PATHS):
        placements = [{"location_cm": place(n), "rotation_deg": [0, 0, 0], "scale": [1, 1, 1]} for n in range(1500)]
        one = actor(number, path, (0, 0, 0), (1, 1, 1))
        scene.append({**one, "c4s": {"components": [{"mesh": path, "instances": placements}]}})
    scores(ALL, scene, c4s={"meshes": meshes})


def test_texts_of_a_megabyte_in_a_scene_are_read_or_passed_over() -> None:
    text = "sm desk " * 130_000
    scene = [actor(n, path, (n * 100, 0, 0), (50, 50, 50)) for n, path in enumerate([*PATHS, f"/Game/Mine/{text}"])]
    for each in scene:
        each |= {"label": text, "name": each["name"] + text, "actor_tags": [text]}
    assert scores(ALL, scene) == scores(ALL, [each | {"label": "", "actor_tags": []} for each in scene])


def test_logic_of_any_depth_is_decided() -> None:
    chain = [
        predicate(f"l{n}", "logic", logic={"operator": "not", "requirement_ids": [f"l{n + 1}"]}) for n in range(8000)
    ]
    made = bundle([*chain, predicate("l8000", "existence")])
    made["graph"]["edges"] += [
        {"edge_type": "scope", "source_id": f"l{n}", "target_id": f"l{n + 1}"} for n in range(8000)
    ]
    scene = [actor(0, PATHS[0], (0, 0, 0), (50, 50, 50))]
    decisions = verify_detailed(made, {"actors": scene}, CATALOG).measurements["decisions"]
    assert {row["status"] for row in decisions[::2]} == {"MATCH"}
    assert {row["status"] for row in decisions[1::2]} == {"MISMATCH"}


def test_a_bundle_without_measure_is_one_line() -> None:
    many = [predicate(f"p{n}", "existence") for n in range(100_000)]
    for made in (
        bundle(many),
        bundle([{**predicate("p", "existence"), "text": "x" * 1_000_000}]),
        bundle([predicate("p", "quantity", quantity={"mode": "exact", "value": "many"})]),
        bundle([predicate("p", "quantity", quantity={"mode": "exact", "value": math.inf})]),
        bundle([predicate("p", "quantity", quantity={"mode": "exact", "value": 10**400})]),
        bundle([predicate("p", "existence", logic=[1])]),
        {**bundle([]), "requirements": [{"node_id": "x" * 1_000_000}]},
    ):
        with pytest.raises(BadInput) as caught:
            read_requirements(made, where="case")
        assert caught.value.line().startswith("case: ") and len(caught.value.line()) < 300


ODD: st.SearchStrategy[Any] = st.one_of(
    st.none(),
    st.booleans(),
    st.sampled_from(["", "logic", "set", "between", "qualitative", "p0", "\ud800", [], {}, [1], {"a": 1}]),
    st.floats(),
    st.integers(-(10**30), 10**30),
)


def places(value: Any) -> list[tuple[Any, ...]]:
    """Every path into nested data."""
    items = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    return [path for key, inner in items for path in [(key,), *((key, *rest) for rest in places(inner))]]


@settings(max_examples=400)
@given(st.data())
def test_a_damaged_bundle_is_judged_or_one_line(data: st.DataObject) -> None:
    logic = {"operator": "any_of", "requirement_ids": ["r0", "d1"]}
    asked = deepcopy(bundle([predicate("l", "logic", logic=logic), predicate("q", "quantity", quantity=QUANTITY)]))
    for part in ("nodes", "edges"):
        asked["graph"][part] += [one for one in deepcopy(ALL["graph"][part]) if one not in asked["graph"][part]]
    asked["requirements"] += deepcopy(ALL["requirements"])
    for _ in range(data.draw(st.integers(1, 3))):
        *way, last = data.draw(st.sampled_from(places(asked) or [("x",)]))
        holder: Any = asked
        for key in way:
            holder = holder[key]
        holder[last] = data.draw(ODD)
    scene = [actor(n, path, (n * 100, 0, 0), (50, 50, 50)) for n, path in enumerate(PATHS)]
    try:
        verify_both(asked, {"actors": scene}, CATALOG, captures(scene))
    except BadInput as error:
        assert "\n" not in error.line()


def test_the_largest_bundle_is_judged() -> None:
    most = [predicate(f"p{n}", "existence", n % 30) for n in range(MAXIMUM_NODES - len(NAMES))]
    scene = [actor(n, path, (n * 100, 0, 0), (50, 50, 50)) for n, path in enumerate(PATHS)]
    scores(bundle(most), scene)


def test_an_actor_shows_no_more_things_than_its_pixels_have_room_for() -> None:
    meshes = {PATHS[0]: {"bounds_min_cm": [-50, -50, 0], "bounds_max_cm": [50, 50, 90]}}
    placements = [{"location_cm": [n * 300, 0, 0], "rotation_deg": [0, 0, 0], "scale": [1, 1, 1]} for n in range(100)]
    one = {
        **actor(0, PATHS[0], (0, 0, 0), (1, 1, 1)),
        "c4s": {"components": [{"mesh": PATHS[0], "instances": placements}]},
    }
    shown: dict[str, Any] = {"views": [{"visible": {"a0": pixels}} for pixels in (47, 100, 0, 46)]}
    found = verify_overview(ALL, {"actors": [one], "c4s": {"meshes": meshes}}, CATALOG, shown)
    parts = {part["name"]: part for part in found.measurements["dimensions"]["completeness_and_polish"]["parts"]}
    assert parts["visible_things"]["detail"] == {"things": 100, "seen": 3, "set_aside": 0}


def test_an_invisible_component_is_not_placed() -> None:
    meshes = {PATHS[0]: {"bounds_min_cm": [-50, -50, 0], "bounds_max_cm": [50, 50, 90]}}
    place = {"location_cm": [0, 0, 0], "rotation_deg": [0, 0, 0], "scale": [1, 1, 1]}
    asked = bundle([predicate("p", "existence")])
    for shown, status in (({}, "MATCH"), ({"visible": True}, "MATCH"), ({"visible": False}, "MISMATCH")):
        parts = [{"mesh": PATHS[0], "transform": place, **shown}]
        one = {**actor(0, PATHS[0], (0, 0, 0), (1, 1, 1)), "c4s": {"components": parts}}
        snapshot = {"actors": [one], "c4s": {"meshes": meshes}}
        assert verify_detailed(asked, snapshot, CATALOG).measurements["decisions"][0]["status"] == status
