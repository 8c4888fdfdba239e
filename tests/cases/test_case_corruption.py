"""Corruption recipes: what each kind of change does to a level, and what may not be built."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from c4s.errors import BadInput
from c4s.records.level import Level, LevelActor, LevelComponent, Transform
from cases.applying import apply
from cases.checks import check_repair
from cases.corruption import (
    STATIC_MESH_ACTOR,
    STATIC_MESH_COMPONENT,
    Author,
    Corruption,
    guid_of,
    id_of,
    with_identities,
)
from cases.model import CaseView, RepairCase
from cases.recipe import KINDS, Recipe

A, B = "/Game/P/SM_A.SM_A", "/Game/P/SM_B.SM_B"


def actor(name: str, mesh: str = A, place: Transform | None = None) -> LevelActor:
    component = LevelComponent(
        name="StaticMeshComponent0", class_path=STATIC_MESH_COMPONENT, static_mesh=mesh, materials={0: "/Game/P/M.M"}
    )
    return LevelActor(
        name=name,
        label=name,
        class_path=STATIC_MESH_ACTOR,
        guid=guid_of(name),
        components=[component],
        transform=place or Transform(),
    )


@pytest.fixture()
def author() -> Author:
    return Author(Level(package="/Game/T", actors=[actor("SM_A_1"), actor("SM_A_3"), actor("SM_B_1", B)]), "scene")


def changed(author: Author, *changes: Corruption) -> dict[str, LevelActor]:
    level = apply(author.level, [o for change in changes for o in change.operations], "/Game/In")
    assert level.package == "/Game/In"
    return {actor.name: actor for actor in level.actors}


def test_each_kind_changes_what_it_says_and_nothing_else(author: Author) -> None:
    before = {actor.name: actor for actor in author.level.actors}
    assert set(before) - set(changed(author, author.removal("SM_A_1"))) == {"SM_A_1"}
    for change, check in (
        (author.move("SM_A_1", by_cm=(1, 2, 3)), lambda t: t.location_cm == (1, 2, 3)),
        (author.rotate("SM_A_1", 270), lambda t: t.rotation_deg == (0, -90, 0)),
        (author.rescale("SM_A_1", 2.0), lambda t: t.scale == (2, 2, 2)),
        (author.mirror("SM_A_1", "x"), lambda t: t.scale == (-1, 1, 1)),
    ):
        after = changed(author, change)
        assert check(after["SM_A_1"].transform), change.kind
        assert {n: a for n, a in after.items() if n != "SM_A_1"} == {n: a for n, a in before.items() if n != "SM_A_1"}
    swapped = changed(author, author.replacement("SM_A_1", B))["SM_A_1"].components[0]
    assert swapped.static_mesh == B and swapped.materials == author.actors["SM_B_1"].components[0].materials


def test_spawned_actors_look_like_the_others_and_copies_keep_their_materials(author: Author) -> None:
    after = changed(author, author.duplication("SM_B_1", (9, 0, 0)), author.insertion(A, (5, 0, 0), yaw_deg=30))
    fresh = {name: a for name, a in after.items() if name not in author.actors}
    copy = next(a for a in fresh.values() if a.components[0].static_mesh == B)
    added = next(a for a in fresh.values() if a.components[0].static_mesh == A)
    assert copy.components[0].materials == {0: "/Game/P/M.M"} and copy.transform.location_cm == (9, 0, 0)
    assert added.name not in author.actors and added.transform.rotation_deg == (0, 30, 0)
    assert all(str(id_of(a)).startswith("sca_source_") for a in after.values())
    assert len({id_of(a) for a in after.values()}) == len(after) and len({a.guid for a in after.values()}) == len(after)


def test_a_recipe_survives_its_published_form(author: Author) -> None:
    changes = [
        author.removal("SM_A_1"),
        author.duplication("SM_B_1", (1, 2, 3)),
        author.replacement("SM_A_3", B),
        author.mirror("SM_B_1"),
    ]
    recipe = Recipe(
        case_id="c",
        setting="image-to-scene/indoor",
        scene_id="scene",
        source_map="/Game/T",
        ground_truth_map="/Game/T",
        input_map="/Game/In",
        operations=[o for change in changes for o in change.operations],
    )
    plain = recipe.plain()
    assert [o["op"] for o in plain["operations"]] == ["remove_actor", "spawn_actor", "set_static_mesh", "set_transform"]
    assert plain["operations"][1]["from"] == {"static_mesh": B} and "location_cm" not in plain["operations"][3]
    assert Recipe.parse(plain) == recipe


@given(st.lists(st.sampled_from(KINDS), min_size=1, max_size=5), st.integers(0, 2))
def test_identities_stay_with_what_is_not_touched(kinds: list[str], which: int) -> None:
    level = Level(package="/Game/T", actors=[actor(f"SM_A_{n}") for n in range(8)])
    author = Author(level, "scene")
    made = [_change(author, kind, f"SM_A_{n + which}") for n, kind in enumerate(kinds)]
    after = apply(author.level, [o for change in made for o in change.operations], "/Game/In")
    untouched = {f"SM_A_{n}" for n in range(8)} - {f"SM_A_{n + which}" for n in range(len(kinds))}
    kept = {a.name: a for a in after.actors}
    assert all(kept[name] == author.actors[name] for name in untouched)
    grown = sum(kind in ("insertion", "duplication") for kind in kinds) - sum(kind == "removal" for kind in kinds)
    assert len(after.actors) == 8 + grown
    assert with_identities(after, "scene") == after


def _change(author: Author, kind: str, name: str) -> Corruption:
    match kind:
        case "insertion":
            return author.insertion(B, (400, 0, 0))
        case "duplication":
            return author.duplication(name, (800, 0, 0))
        case "replacement":
            return author.replacement(name, B)
        case "move":
            return author.move(name, by_cm=(50, 0, 0))
        case "rotate":
            return author.rotate(name, 45)
        case "rescale":
            return author.rescale(name, 1.4)
        case "mirror":
            return author.mirror(name)
    return author.removal(name)


def test_wrong_changes_are_refused(author: Author) -> None:
    for wrong in (
        lambda: author.removal("SM_Z_9"),
        lambda: author.replacement("SM_A_1", A),
        lambda: changed(author, author.removal("SM_A_1"), author.rotate("SM_A_1", 20)),
    ):
        with pytest.raises(BadInput):
            wrong()


@pytest.mark.parametrize("changes", [["move_little"], [], ["remove_and_add_one_look"]])
def test_cases_that_cannot_be_scored_fairly_are_refused(author: Author, changes: list[str]) -> None:
    made = {
        "move_little": author.move("SM_A_1", by_cm=(3, 0, 0)),
        "remove_and_add_one_look": Corruption(
            "removal", (*author.removal("SM_A_1").operations, *author.duplication("SM_A_3", (90, 0, 0)).operations)
        ),
    }
    case = RepairCase(
        "c", "scene", "t", [made[name] for name in changes], "Layout", "easy", [CaseView("v", (0, 0, 0), (1, 0, 0))]
    )
    with pytest.raises(BadInput, match="c: "):
        check_repair(case, case.operations, author.level, apply(author.level, case.operations, "/Game/In"))
