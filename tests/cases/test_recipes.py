"""Recipes: published ones are read unchanged and applied, chains of labels, and what is refused and where."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from c4s.errors import BadInput
from c4s.records.level import Level, LevelActor, LevelComponent, Transform
from cases.applying import apply, apply_recipe
from cases.checks import check_repair
from cases.corruption import (
    STABLE_ID_TAG,
    STATIC_MESH_ACTOR,
    STATIC_MESH_COMPONENT,
    Author,
    compound,
    guid_of,
    id_of,
    meshes,
)
from cases.model import CaseView, RepairCase
from cases.recipe import LONGEST_CHAIN, Recipe, SetStaticMesh, SetTransform, SpawnActor
from tests.shared import SHARED

PUBLISHED = sorted((SHARED / "upstream/benchmark/public").rglob("recipe.json"))
CHAINS = {"a20-s01": 1, "a20-s02": 1, "a20-s06": 1, "comp-15": 4, "comp-24": 3, "comp-41": 4, "comp-44": 4}
MESH = "/Game/P/SM_A.SM_A"


def actor(name: str, mesh: str = MESH, stable_id: str = "", **more: Any) -> LevelActor:
    component = LevelComponent(name="StaticMeshComponent0", class_path=STATIC_MESH_COMPONENT, static_mesh=mesh)
    tags = [STABLE_ID_TAG + (stable_id or f"sca_source_{name}")]
    made = {"label": name, "class_path": STATIC_MESH_ACTOR, "guid": guid_of(name), "components": [component]}
    return LevelActor(name=name, tags=tags, **{**made, **more})


def original_of(recipe: Recipe) -> Level:
    """A level with every actor that a recipe speaks of, as it must be in the original."""
    known: dict[str, LevelActor] = {}
    for number, operation in enumerate(recipe.operations):
        place = Transform(location_cm=(100.0 * number, 7.0, 3.0))
        match operation:
            case SpawnActor():
                kind = operation.source.get("class", STATIC_MESH_ACTOR)
                made = actor(
                    f"Like_{number}",
                    operation.source.get("static_mesh", MESH),
                    operation.like or "",
                    class_path=kind,
                    transform=place,
                )
            case SetStaticMesh():
                made = actor(f"Target_{number}", operation.replaces, operation.target, transform=place)
            case _:
                made = actor(f"Target_{number}", MESH, operation.target, transform=place)
        known.setdefault(str(id_of(made)), made)
    streamed = [change.source for change in recipe.level_structure]
    others = [actor("Streamed", properties={"world_asset": f"{name}.buildings"}) for name in streamed]
    return Level(package=recipe.ground_truth_map, actors=[*known.values(), actor("Other"), *others])


@pytest.mark.skipif(not PUBLISHED, reason="needs ../shared/upstream")
@pytest.mark.parametrize("file", PUBLISHED, ids=lambda file: file.parent.name)
def test_published_recipes_are_read_unchanged_and_applied(file: Path) -> None:
    recipe = Recipe.read(file)
    assert recipe.plain() == json.loads(file.read_text())
    assert len(recipe.labels) == CHAINS["-".join(recipe.case_id.split("-")[:2])]
    before = original_of(recipe)
    after = apply_recipe(before, recipe, where=str(file))
    assert after.package == recipe.input_map
    expected = json.loads((file.parent / "input.fingerprint.json").read_text())
    was = {id_of(one): one for one in before.actors}
    now = {id_of(one) or one.guid: one for one in after.actors}
    streamed = {one.name for one in before.actors if one.name == "Streamed"}
    changed = {key for key, one in now.items() if was.get(key) != one and one.name not in streamed}
    told = {key if key in now else guid_of(key) for key in expected["changed_or_added"]}
    again = 2 * len(recipe.level_structure)
    """Actors of the streamed level of comp-15 that the published input names anew."""
    assert changed <= told and len(told - changed) == again
    gone = {key for key in was if key not in now}
    assert gone <= set(expected["removed"]) and len(expected["removed"]) - len(gone) == again
    for operation in recipe.operations:
        one = now[operation.target] if not isinstance(operation, SpawnActor) and operation.target in now else None
        if isinstance(operation, SetTransform) and one is not None:
            wanted = operation.plain()
            assert {name: list(getattr(one.transform, name)) for name in wanted.keys() - {"op", "target"}} == {
                name: value for name, value in wanted.items() if name not in ("op", "target")
            }
        if isinstance(operation, SetStaticMesh) and one is not None:
            assert meshes(one) == [operation.static_mesh]
            (slot,) = operation.expect.material_slots
            assert one.components[0].materials == {0: slot.material_path}
        if isinstance(operation, SpawnActor):
            spawned = next(each for each in after.actors if each.label == operation.label)
            assert spawned.transform.location_cm == operation.location_cm
            assert (id_of(spawned) == operation.stable_id) is operation.identity_tag
    for change in recipe.level_structure:
        text = after.model_dump_json()
        assert change.source not in text and f"{change.target}.buildings" in text


def plain_recipe(**more: Any) -> dict[str, Any]:
    return {
        "case_id": "c",
        "setting": "image-to-scene/indoor",
        "scene_id": "s",
        "source_map": "/Game/T",
        "ground_truth_map": "/Game/T",
        "input_map": "/Game/In",
        "operations": [{"op": "remove_actor", "target": "sca_source_A"}],
        **more,
    }


EXPECTED_SLOT = {
    "component_identity": "StaticMeshComponent0|/Script/Engine.StaticMeshComponent",
    "is_dynamic": False,
    "material_class_path": "/Script/Engine.Material",
    "material_path": "/Game/P/M.M",
    "slot_index": 1,
}
SPAWN = {
    "op": "spawn_actor",
    "stable_id": "sca_generated_1",
    "object_name": "SM_B_1",
    "label": "B",
    "from": {"static_mesh": "/Game/P/SM_B.SM_B"},
    "location_cm": [1, 2, 3],
}


@pytest.mark.parametrize(
    ("wrong", "place"),
    [
        ({"operations": [{"op": "paint", "target": "a"}]}, "operations.0"),
        ({"operations": []}, "operations"),
        ({"operations": [{"op": "set_transform", "target": "a"}]}, "operations.0.set_transform"),
        ({"operations": [{**SPAWN, "from": {}}]}, "operations.0.spawn_actor.from"),
        ({"operations": [{**SPAWN, "from": {"static_mesh": "../x"}}]}, "operations.0.spawn_actor.from.static_mesh"),
        ({"operations": [{**SPAWN, "expect": {"paint": 1}}]}, "operations.0.spawn_actor.expect.paint"),
        (
            {"operations": [{**SPAWN, "expect": {"material_slots": [{**EXPECTED_SLOT, "slot_index": -1}]}}]},
            "operations.0.spawn_actor.expect.material_slots.0.slot_index",
        ),
        ({"level_structure": [{"op": "retarget_streaming_level", "from": "/Game/A"}]}, "level_structure.0.to"),
        ({"entries": [{"label": "move", "operations": [1]}]}, "value"),
        ({"entries": [{"label": "move", "operations": [0]}] * 6}, "entries"),
        ({"input_map": "/Game/../x"}, "input_map"),
    ],
)
def test_a_wrong_recipe_is_refused_by_file_entry_and_field(tmp_path: Path, wrong: dict[str, Any], place: str) -> None:
    file = tmp_path / "recipe.json"
    file.write_text(json.dumps(plain_recipe(**wrong)))
    with pytest.raises(BadInput) as caught:
        Recipe.read(file)
    assert str(file) in str(caught.value) and f"'{place}'" in str(caught.value)


@pytest.mark.parametrize(
    ("operation", "said"),
    [
        ({"op": "remove_actor", "target": "sca_source_Z"}, "no actor has this stable id"),
        ({**SPAWN, "object_name": "A"}, "an actor of this object name exists"),
        ({**SPAWN, "expect": {"like": "sca_source_Z"}}, "no actor has this stable id"),
        ({**SPAWN, "expect": {"like": "sca_source_A"}}, "does not show /Game/P/SM_B.SM_B"),
        ({**SPAWN, "from": {"class": "/Game/P/BP_C.BP_C_C"}}, "none is a /Game/P/BP_C.BP_C_C"),
        ({**SPAWN, "expect": {"component_asset_paths": [MESH]}}, "expect.component_asset_paths"),
        (
            {**SPAWN, "expect": {"material_slots": [{**EXPECTED_SLOT, "component_identity": "Lamp|/S"}]}},
            "expect.material_slots.0.component_identity",
        ),
        (
            {"op": "set_static_mesh", "target": "sca_source_A", "component": "Box", "static_mesh": MESH}
            | {"replaces": MESH},
            "it has 'StaticMeshComponent0'",
        ),
    ],
)
def test_what_does_not_fit_the_scene_is_refused_by_entry(operation: dict[str, Any], said: str) -> None:
    moved = {"op": "set_transform", "target": "sca_source_A", "scale": [1, 1, 2]}
    recipe = Recipe.parse(plain_recipe(operations=[moved, operation]))
    with pytest.raises(BadInput) as caught:
        apply_recipe(Level(package="/Game/T", actors=[actor("A")]), recipe, where="case/recipe.json")
    text = str(caught.value)
    assert "case/recipe.json: operations.1" in text and operation["op"] in text and said in text
    with pytest.raises(BadInput, match="is for the level /Game/T, not /Game/Other"):
        apply_recipe(Level(package="/Game/Other", actors=[actor("A")]), recipe)


def test_a_spawned_actor_is_as_expected() -> None:
    expect = {
        "component_asset_paths": ["/Game/P/SM_B.SM_B"],
        "material_slots": [EXPECTED_SLOT, {**EXPECTED_SLOT, "slot_index": 2, "is_dynamic": True}],
        "tags": ["Awning"],
        "properties": {"mobility": "MOVABLE"},
    }
    recipe = Recipe.parse(plain_recipe(operations=[{**SPAWN, "expect": expect}]))
    assert recipe.plain()["operations"][0]["expect"] == expect
    spawned = apply_recipe(Level(package="/Game/T", actors=[actor("A")]), recipe).actors[-1]
    assert spawned.components[0].materials == {1: "/Game/P/M.M"} and spawned.properties == {"mobility": "MOVABLE"}
    assert spawned.tags[0] == "Awning" and id_of(spawned) == "sca_generated_1"


@given(st.lists(st.integers(1, 4), min_size=1, max_size=7))
def test_a_chain_has_one_to_five_entries_of_one_or_several_operations(sizes: list[int]) -> None:
    level = Level(package="/Game/T", actors=[actor(f"A_{n}") for n in range(sum(sizes))])
    author = Author(level, "scene")
    names = iter(author.actors)
    chain = [compound("move", *(author.move(next(names), by_cm=(90, 0, 0)) for _ in range(size))) for size in sizes]
    case = RepairCase("c", "scene", "t", chain, "Layout", "easy", [CaseView("v", (0, 0, 0), (1, 0, 0))])
    after = apply(author.level, case.operations, "/Game/In")
    if len(sizes) > LONGEST_CHAIN:
        with pytest.raises(BadInput, match="at most 5 changes"):
            check_repair(case, case.operations, author.level, after)
        return
    check_repair(case, case.operations, author.level, after)
    recipe = Recipe.parse(plain_recipe(operations=[one.plain() for one in case.operations]))
    recipe = recipe.model_copy(update={"entries": case.entries})
    assert Recipe.parse(recipe.plain()) == recipe
    assert recipe.labels == ["move"] * len(sizes) == case.kinds
    assert [len(entry.operations) for entry in case.entries] == sizes
