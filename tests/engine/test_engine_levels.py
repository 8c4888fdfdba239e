"""Levels and created assets: saving, reopening, refusing."""

from __future__ import annotations

import importlib
import json
from pathlib import Path

import pytest

from c4s.engine.headless.process.boot import boot
from c4s.engine.headless.world import state
from c4s.errors import BadInput
from c4s.records.level import Level, LevelActor, LevelComponent, Transform
from c4s.records.pack import Asset, BlueprintPart, BoxBody, Material, MaterialSlot, Pack
from tests.work import calls_in


@pytest.fixture
def pack(tmp_path: Path) -> Path:
    """A pack with a mesh, a Blueprint of two parts, and a material."""
    box = {"bounds_min_cm": (-20, -20, 0), "bounds_max_cm": (20, 20, 80)}
    mesh = Asset(
        id="sm_post",
        name="Post",
        path="/Game/T/SM_Post.SM_Post",
        category="props",
        mesh="meshes/post.glb",
        mesh_sha256="0" * 64,
        slots=[MaterialSlot(name="Wood", material="/Game/T/M_Wood.M_Wood")],
        collision=[BoxBody(center=(0, 0, 40), half_extent=(20, 20, 40))],
        **box,
    )
    parts = [
        BlueprintPart(name="Left", asset=mesh.path),
        BlueprintPart(name="Right", asset=mesh.path, relative=Transform(location_cm=(100, 0, 0))),
    ]
    gate = Asset(
        id="bp_gate",
        name="Gate",
        kind="blueprint",
        path="/Game/T/BP_Gate.BP_Gate",
        category="props",
        bounds_min_cm=(-20, -20, 0),
        bounds_max_cm=(120, 20, 80),
        parts=parts,
    )
    folder = tmp_path / "pack"
    Pack(
        pack_id="t",
        content_folder="T",
        title="T",
        license="CC0-1.0",
        assets=[mesh, gate],
        materials=[Material(path="/Game/T/M_Wood.M_Wood", base_color=(0.4, 0.2, 0.1))],
    ).write(folder / "pack.json")
    return folder


def exported(what: str):
    """An editor script's export of the open level; those scripts import ``unreal``, so after ``boot`` only."""
    return getattr(importlib.import_module(f"c4s.editor.{what}"), f"export_{what}")()


def build_scene(unreal):
    """One of each kind of thing that a level document holds."""
    spawn = unreal.EditorLevelLibrary.spawn_actor_from_class
    mesh = unreal.load_asset("/Game/T/SM_Post")
    post = unreal.EditorLevelLibrary.spawn_actor_from_object(mesh, unreal.Vector(1, 2, 3), unreal.Rotator(10, 20, 30))
    post.set_actor_scale3d(unreal.Vector(-1.5, 1, 2))
    post.set_editor_property("tags", ["simcodearena.stable_actor_id=sca_source_1", "simcodearena.actor_origin=source"])
    post.set_folder_path("Props/Wood")
    gate = spawn(unreal.load_class(None, "/Game/T/BP_Gate.BP_Gate_C"), unreal.Vector(500, 0, 0), unreal.Rotator(yaw=33))
    keep = unreal.AttachmentRule.KEEP_WORLD
    post.attach_to_actor(gate, "", keep, keep, keep)
    lamp = spawn(unreal.SpotLight, unreal.Vector(0, 0, 300), unreal.Rotator(pitch=-90))
    lamp.spot_light_component.set_light_color(unreal.LinearColor(1, 0.5, 0.25, 1))
    lamp.spot_light_component.set_editor_property("intensity_units", unreal.LightUnits.LUMENS)
    lamp.set_actor_label("Lamp over the gate")
    grade = spawn(unreal.PostProcessVolume, unreal.Vector())
    settings = grade.settings
    settings.override_auto_exposure_bias = True
    settings.auto_exposure_bias = 2.5
    grade.set_editor_property("settings", settings)
    dyed = gate.get_components_by_class(unreal.StaticMeshComponent)[0].create_dynamic_material_instance(0)
    dyed.set_vector_parameter_value("BaseColor", unreal.LinearColor(1, 0, 0))
    quiet = unreal.EditorLevelLibrary.spawn_actor_from_object(unreal.load_asset("/Game/T/SM_Post"), unreal.Vector())
    quiet.static_mesh_component.set_collision_enabled(unreal.CollisionEnabled.NO_COLLISION)
    quiet.set_actor_hidden_in_game(True)
    return post, gate


def test_a_saved_level_reopens_equal(pack, tmp_path):
    unreal = boot([pack], tmp_path / "content")
    build_scene(unreal)
    world = unreal.EditorLevelLibrary.get_editor_world()
    assert unreal.EditorLoadingAndSavingUtils.save_map(world, "/Game/SavedScenes/Yard")
    before, file = exported("snapshot"), tmp_path / "content/Game/SavedScenes/Yard.level.json"
    Level.read(file)
    first = file.read_bytes()
    unreal = boot([pack], tmp_path / "content", start_map="/Game/SavedScenes/Yard")
    assert exported("snapshot") == before
    assert unreal.EditorLevelLibrary.save_current_level() and file.read_bytes() == first
    saves = (tmp_path / "content/saves.jsonl").read_text().splitlines()
    assert [json.loads(line)["package"] for line in saves] == ["/Game/SavedScenes/Yard"] * 2


def test_snapshot_of_a_scene(pack, tmp_path):
    unreal = boot([pack], tmp_path / "content")
    build_scene(unreal)
    shot = json.loads(json.dumps(exported("snapshot"), allow_nan=False))
    post, gate, lamp, grade, quiet = shot["actors"]
    assert shot["schema_version"] == "0.3.0" and shot["actor_count"] == 5
    assert post["stable_actor_id"] == "sca_source_1" and post["actor_origin"] == "source"
    assert post["attachment_parent_label"] == "BP_Gate" and post["asset_path"] == "/Game/T/SM_Post.SM_Post"
    assert post["transform"]["location_cm"] == pytest.approx([1, 2, 3])
    assert post["transform"]["rotation_deg"] == pytest.approx([20, 30, 10])
    assert gate["class"] == "/Game/T/BP_Gate.BP_Gate_C" and gate["stable_actor_id"].startswith("sca_generated_")
    assert [c["mesh"] for c in gate["c4s"]["components"]][1:] == ["/Game/T/SM_Post.SM_Post"] * 2
    left, right = gate["component_material_slots"]
    assert left["is_dynamic"] and not right["is_dynamic"] and right["component_identity"].startswith("Right|")
    assert lamp["properties"]["intensity_units"] == "<LightUnits.LUMENS: 2>"
    assert lamp["properties"]["light_color"] == [255, 188, 137, 255]
    assert grade["properties"] == {}
    assert not quiet["collision"]["collision_enabled"] and not quiet["c4s"]["components"][0]["collision_enabled"]
    facts = shot["c4s"]["meshes"]["/Game/T/SM_Post.SM_Post"]
    assert facts["sha256"] == "0" * 64 and facts["collision"][0]["kind"] == "box"


def test_created_assets_live_in_memory_until_saved(pack, tmp_path):
    unreal = boot([pack], tmp_path / "content")
    tools = unreal.AssetToolsHelpers.get_asset_tools()
    names = ("MI_Kept", "MI_Lost")
    for name in names:
        made = tools.create_asset(
            name, "/Game/Mine", unreal.MaterialInstanceConstant, unreal.MaterialInstanceConstantFactoryNew()
        )
        unreal.MaterialEditingLibrary.set_material_instance_parent(made, unreal.load_asset("/Game/T/M_Wood"))
        assert unreal.MaterialEditingLibrary.set_material_instance_vector_parameter_value(
            made, "BaseColor", unreal.LinearColor(0, 0, 1)
        )
        post = unreal.EditorLevelLibrary.spawn_actor_from_object(unreal.load_asset("/Game/T/SM_Post"), unreal.Vector())
        post.static_mesh_component.set_material(0, made)
    assert unreal.EditorAssetLibrary.save_asset("/Game/Mine/MI_Kept")
    unreal.EditorLoadingAndSavingUtils.save_map(unreal.EditorLevelLibrary.get_editor_world(), "/Game/SavedScenes/A")
    unreal = boot([pack], tmp_path / "content", start_map="/Game/SavedScenes/A")
    assert unreal.EditorAssetLibrary.does_asset_exist("/Game/Mine/MI_Kept")
    assert not unreal.EditorAssetLibrary.does_asset_exist("/Game/Mine/MI_Lost")
    drawn = list(state.world().drawables())
    assert [d.materials[0].base_color for d in drawn] == [(0, 0, 1), (0.4, 0.2, 0.1)]
    found = exported("dependencies")
    assert found["unresolved"] == ["/Game/Mine/MI_Lost"]
    assert found["packages"] == ["/Game/Mine/MI_Kept", "/Game/T/M_Wood", "/Game/T/SM_Post"]


def test_material_made_of_expressions(tmp_path):
    unreal = boot([], tmp_path)
    made = unreal.AssetToolsHelpers.get_asset_tools().create_asset(
        "M_Red", "/Game/M", unreal.Material, unreal.MaterialFactoryNew()
    )
    edit = unreal.MaterialEditingLibrary
    node = edit.create_material_expression(made, unreal.MaterialExpressionConstant3Vector, -300, 0)
    node.set_editor_property("constant", unreal.LinearColor(0.8, 0.1, 0.1))
    assert edit.connect_material_property(node, "", unreal.MaterialProperty.MP_BASE_COLOR)
    edit.recompile_material(made)
    cube = unreal.EditorLevelLibrary.spawn_actor_from_object(
        unreal.load_asset("/Engine/BasicShapes/Cube"), unreal.Vector()
    )
    cube.static_mesh_component.set_material(0, made)
    assert next(state.world().drawables()).materials[0].base_color == (0.8, 0.1, 0.1)


def test_loading_closes_without_saving(pack, tmp_path):
    unreal = boot([pack], tmp_path / "content")
    unreal.get_editor_subsystem(unreal.LevelEditorSubsystem).new_level("/Game/L/One")
    actor = unreal.EditorLevelLibrary.spawn_actor_from_class(unreal.StaticMeshActor, unreal.Vector())
    assert unreal.EditorLoadingAndSavingUtils.load_map("/Game/L/Missing") is None
    assert actor.get_name() == "StaticMeshActor_0"
    assert unreal.EditorLoadingAndSavingUtils.load_map("/Game/L/One").get_path_name() == "/Game/L/One.One"
    assert len(unreal.EditorLevelLibrary.get_all_level_actors()) == 0
    with pytest.raises(Exception, match="ObjectInstance is null"):
        actor.get_name()


@pytest.mark.parametrize(
    "path", ["/Game/../../etc/x", "/Engine/Maps/X", "Game/X", "/Game/", "/Game/a b", "/Game/T/SM_Post"]
)
def test_places_where_no_level_can_be_saved(pack, tmp_path, path):
    unreal = boot([pack], tmp_path / "content")
    assert not unreal.EditorLoadingAndSavingUtils.save_map(unreal.EditorLevelLibrary.get_editor_world(), path)
    assert not list(tmp_path.rglob("*.level.json"))


def test_given_levels_are_read_only_and_unknown_things_are_told(pack, tmp_path, capsys):
    level = Level(
        package="/Game/Given/Start",
        actors=[
            LevelActor(
                name="Lost_0",
                label="Lost",
                class_path="/Script/Engine.StaticMeshActor",
                guid="AB" * 16,
                components=[
                    LevelComponent(
                        name="StaticMeshComponent0",
                        class_path="/Script/Engine.StaticMeshComponent",
                        static_mesh="/Game/T/SM_Gone.SM_Gone",
                    )
                ],
            )
        ],
    )
    level.write(tmp_path / "start.level.json")
    unreal = boot([pack], tmp_path / "content", levels=[tmp_path / "start.level.json"], start_map="/Game/Given/Start")
    assert "SM_Gone" in capsys.readouterr().out
    assert not unreal.EditorLevelLibrary.save_current_level()
    assert exported("dependencies")["unresolved"] == ["/Game/T/SM_Gone"]


def test_wrong_documents_are_bad_input(tmp_path):
    file = tmp_path / "a.level.json"
    file.write_text('{"schema_version": "c4s.level.v1", "package": "/Game/A", "actors": [')
    with pytest.raises(BadInput):
        boot([], tmp_path / "content", levels=[file])
    with pytest.raises(BadInput, match="no such start map"):
        boot([], tmp_path / "content", start_map="/Game/Nowhere")


def test_the_work_of_saving_and_loading_grows_with_the_actors(tmp_path):
    unreal = boot([], tmp_path)
    cube = unreal.load_asset("/Engine/BasicShapes/Cube")
    world, saving, loading = state.world(), {}, {}
    for number in (500, 2000):
        for i in range(len(world.actors), number):
            place = unreal.Vector(i, -i, 0.5)
            unreal.EditorLevelLibrary.spawn_actor_from_object(cube, place, unreal.Rotator(yaw=i % 360))
        saving[number] = calls_in(lambda: world.save_map("/Game/S/Big")).total()
        loading[number] = calls_in(lambda: world.load_map("/Game/S/Big")).total()
        assert len(world.actors) == number
    assert saving[2000] < 4.2 * saving[500] and saving[2000] < 110 * 2000
    assert loading[2000] < 4.2 * loading[500] and loading[2000] < 280 * 2000


def place(**changes):
    """A level document of one cube with some of its content changed."""
    component = {
        "name": "StaticMeshComponent0",
        "class_path": "/Script/Engine.StaticMeshComponent",
        "static_mesh": "/Engine/BasicShapes/Cube.Cube",
        **changes.pop("component", {}),
    }
    actor = {
        "name": "A_0",
        "label": "A",
        "class_path": "/Script/Engine.StaticMeshActor",
        "guid": "AB" * 16,
        "components": [component],
        **changes,
    }
    return {"schema_version": "c4s.level.v1", "package": "/Game/A", "actors": [actor]}


@pytest.mark.parametrize(
    "document",
    [
        place(transform={"location_cm": [float("nan"), 0, 0]}),
        place(guid="xyz"),
        place(parent="Nobody"),
        place(parent="A_0"),
        place(properties={"colour": 1}),
        place(component={"properties": {"visible": [1]}}),
        place(component={"class_path": "/Script/Engine.Magic"}),
        place(component={"properties": {"dynamic_materials": {"0": {"name": "x"}}}}),
        place(component={"properties": {"dynamic_materials": {"first": {"name": "x", "parent": ""}}}}),
    ],
)
def test_tampered_levels_are_bad_input(tmp_path, document):
    (tmp_path / "a.level.json").write_text(json.dumps(document))
    with pytest.raises(BadInput):
        boot([], tmp_path / "content", levels=[tmp_path / "a.level.json"], start_map="/Game/A")


def test_material_instances_that_follow_each_other_are_refused(tmp_path):
    for name, parent in (("A", "B"), ("B", "A")):
        file = tmp_path / f"Game/M/{name}.asset.json"
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(
            json.dumps(
                {
                    "path": f"/Game/M/{name}.{name}",
                    "parent": f"/Game/M/{parent}.{parent}",
                    "class_path": "/Script/Engine.MaterialInstanceConstant",
                }
            )
        )
    unreal = boot([], tmp_path)
    with pytest.raises(BadInput, match="parent"):
        unreal.load_asset("/Game/M/A")
