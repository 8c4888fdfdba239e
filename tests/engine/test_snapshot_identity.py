"""Identity, role and category in a snapshot: what the tags say, else what the actor is made of."""

from __future__ import annotations

import hashlib
import importlib
import json
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from c4s.editor import identity
from c4s.engine.headless.process.boot import boot
from tests.shared import SHARED

CUBE = "/Engine/BasicShapes/Cube.Cube"
STATIC_MESH_ACTOR = "/Script/Engine.StaticMeshActor"
RECIPE = (
    SHARED / "upstream/benchmark/public/image-to-scene/outdoor/comp-24-suburban-patio-set-repair-v3" / "recipe.json"
)


def export() -> dict[str, Any]:
    """The open level's snapshot; the editor's scripts import ``unreal``, so after ``boot`` only."""
    found: dict[str, Any] = importlib.import_module("c4s.editor.snapshot").export_snapshot()
    return found


def spawn(unreal: Any, *tag_lists: list[str]) -> list[Any]:
    """A cube for each list of tags."""
    cubes = []
    for number, tags in enumerate(tag_lists):
        cube = unreal.EditorLevelLibrary.spawn_actor_from_object(
            unreal.load_asset(CUBE), unreal.Vector(300 * number, 0, 50)
        )
        cube.set_editor_property("tags", tags)
        cubes.append(cube)
    return cubes


def test_the_published_recipe_names_the_id_of_an_actor_without_a_tag():
    if not RECIPE.is_file():
        pytest.skip(f"the published task is not here: {RECIPE}")
    recipe = json.loads(RECIPE.read_text(encoding="utf-8"))
    (spawned,) = [operation for operation in recipe["operations"] if operation["op"] == "spawn_actor"]
    assert spawned["identity_tag"] is False
    made = identity.generated_id(spawned["object_name"], STATIC_MESH_ACTOR, [spawned["from"]["static_mesh"]])
    assert made == spawned["stable_id"]


@pytest.mark.parametrize(
    ("name", "written"),
    [("Crate_1", '"actor_name":"Crate_1"'), ("Tür", '"actor_name":"T\\u00fcr"'), ('A"b', '"actor_name":"A\\"b"')],
)
def test_a_generated_id_is_the_hash_of_name_class_and_sorted_assets(name, written):
    text = f'{{{written},"class_path":"/Game/P/BP_X.BP_X_C","component_asset_paths":["/Game/P/A.A","/Game/P/B.B"]}}'
    expected = "sca_generated_" + hashlib.sha256(text.encode()).hexdigest()[:32]
    assets = ["/Game/P/B.B", "/Game/P/A.A", "/Game/P/B.B"]
    assert identity.generated_id(name, "/Game/P/BP_X.BP_X_C", assets) == expected


@pytest.mark.parametrize(
    ("tags", "fields"),
    [
        (["simcodearena.stable_actor_id=a"], {"stable_actor_id": "a"}),
        (["stable_actor_id=a"], {"stable_actor_id": "a"}),
        (["stable_actor_id=bare", "simcodearena.stable_actor_id=full"], {"stable_actor_id": "full"}),
        (["simcodearena.stable_actor_id=", "stable_actor_id=bare"], {"stable_actor_id": "bare"}),
        ([" SimCodeArena.Stable_Actor_Id = a=b "], {"stable_actor_id": "a=b"}),
        (["stable_actor_id=first", "stable_actor_id=last"], {"stable_actor_id": "last"}),
        (["simcodearena.logical_object_id=table"], {"logical_object_id": "table"}),
        (["logical_object_id=table", "actor_role=leg"], {"logical_object_id": "table", "actor_role": "leg"}),
        (["simcodearena.actor_origin=source"], {"actor_origin": "source"}),
        (["category=c"], {"asset_category": "c"}),
        (["category=c", "asset_category=a"], {"asset_category": "a"}),
        (["asset_category=a", "semantic_category=s"], {"asset_category": "s"}),
        (["semantic_category=s", "simcodearena.asset_category=x"], {"asset_category": "x"}),
        (["simcodearena.asset_category=x", "simcodearena.semantic_category=y"], {"asset_category": "y"}),
        (["simcodearena.category=c", "plain", "=x"], {}),
    ],
)
def test_tags_are_read_as_published(tags, fields, tmp_path):
    unreal = boot([], tmp_path)
    spawn(unreal, tags)
    (actor,) = export()["actors"]
    told = {"actor_origin": None, "logical_object_id": None, "actor_role": None, "asset_category": None} | fields
    made = identity.generated_id(actor["name"], STATIC_MESH_ACTOR, [CUBE])
    assert {name: actor[name] for name in told} == told and actor["actor_tags"] == tags
    assert actor["stable_actor_id"] == fields.get("stable_actor_id", made)
    assert actor["export_diagnostics"]["stable_actor_id_provenance"] == (
        "explicit_tag" if "stable_actor_id" in fields else "generated_structural_identity"
    )


def test_an_id_survives_what_does_not_make_an_actor(tmp_path):
    unreal = boot([], tmp_path)
    (cube,) = spawn(unreal, [])
    (before,) = export()["actors"]
    cube.set_actor_location(unreal.Vector(9, 9, 9), False, True)
    cube.set_actor_label("Another")
    cube.set_folder_path("Elsewhere")
    cube.set_editor_property("tags", ["plain"])
    (after,) = export()["actors"]
    assert after["stable_actor_id"] == before["stable_actor_id"] and after["label"] != before["label"]
    cube.static_mesh_component.set_static_mesh(unreal.load_asset("/Engine/BasicShapes/Cone"))
    assert export()["actors"][0]["stable_actor_id"] != before["stable_actor_id"]


def record(path: str, stable_id: str, provenance: str = identity.GENERATED) -> dict[str, Any]:
    return {
        "stable_actor_id": stable_id,
        "actor_path": path,
        "export_diagnostics": {"stable_actor_id_provenance": provenance},
    }


def test_one_generated_id_in_two_levels_becomes_two():
    base = identity.generated_id("Rock_1", STATIC_MESH_ACTOR, [CUBE])
    root, below = "/Game/M/Town.Town:PersistentLevel.Rock_1", "/Game/M/Sub.Sub:PersistentLevel.Rock_1"
    actors = [record(root, base), record(below, base)]
    identity.separate(actors, "/Game/M/Town")
    for actor, scope in zip(actors, ("$ROOT_LEVEL", "/Game/M/Sub.Sub"), strict=True):
        text = f'{{"actor_scope":"{scope}","base_stable_actor_id":"{base}"}}'
        assert actor["stable_actor_id"] == "sca_generated_" + hashlib.sha256(text.encode()).hexdigest()[:32]
        assert actor["export_diagnostics"] == {
            "stable_actor_id_provenance": "generated_structural_identity_disambiguated_by_actor_scope",
            "stable_actor_id_base": base,
            "stable_actor_scope": scope,
        }
    copied = [record("/Game/M/Copy.Copy:PersistentLevel.Rock_1", base), record(below, base)]
    identity.separate(copied, "/Game/M/Copy")
    assert [each["stable_actor_id"] for each in copied] == [each["stable_actor_id"] for each in actors]


PLACES = st.sampled_from(["/Game/A.A:PersistentLevel.X", "/Game/B.B:PersistentLevel.X", "/Game/C.C:PersistentLevel.X"])


@given(
    st.lists(
        st.tuples(PLACES, st.sampled_from(["one", "two"]), st.sampled_from([identity.EXPLICIT, identity.GENERATED])),
        max_size=6,
    )
)
def test_ids_are_told_apart_only_where_levels_tell_all_of_them_apart(rows):
    actors = [record(*row) for row in rows]
    identity.separate(actors, "/Game/A")
    for stable_id in ("one", "two"):
        group = [(actor, row) for actor, row in zip(actors, rows, strict=True) if row[1] == stable_id]
        places = {row[0] for _, row in group}
        apart = len(group) > 1 and len(places) == len(group) and all(row[2] == identity.GENERATED for _, row in group)
        found = [actor["stable_actor_id"] for actor, _ in group]
        assert (len(set(found)) == len(group) and stable_id not in found) if apart else set(found) <= {stable_id}


def test_a_copy_of_a_tagged_actor_keeps_its_id_for_the_verifiers_to_tell(tmp_path):
    unreal = boot([], tmp_path)
    (cube,) = spawn(unreal, ["stable_actor_id=a"])
    unreal.get_editor_subsystem(unreal.EditorActorSubsystem).duplicate_actor(cube, None, unreal.Vector(500, 0, 0))
    assert [actor["stable_actor_id"] for actor in export()["actors"]] == ["a", "a"]
