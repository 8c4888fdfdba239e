"""Assets that scripts make: copies, other names and places, merging, deleting; and what uses them."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from c4s.engine.headless.glb.level import write_glb
from c4s.engine.headless.process.boot import boot
from c4s.engine.headless.world import state
from c4s.records.pack import Asset, Material, MaterialSlot, Pack

CUBE = "/Engine/BasicShapes/Cube"


@pytest.fixture
def pack(tmp_path: Path) -> Path:
    """A pack with one textured material."""
    folder = tmp_path / "pack"
    (folder / "textures").mkdir(parents=True)
    Image.fromarray(np.full((4, 4, 3), (255, 0, 0), dtype=np.uint8)).save(folder / "textures/red.png")
    flag = Asset(
        id="flag",
        name="Flag",
        path="/Game/T/SM_Flag.SM_Flag",
        category="props",
        bounds_min_cm=(-1, -1, 0),
        bounds_max_cm=(1, 1, 1),
        slots=[MaterialSlot(name="Cloth", material="/Game/T/M_Red.M_Red")],
    )
    Pack(
        pack_id="t",
        content_folder="T",
        title="T",
        license="CC0-1.0",
        assets=[flag],
        materials=[Material(path="/Game/T/M_Red.M_Red", base_color=(1, 1, 1), texture="textures/red.png")],
    ).write(folder / "pack.json")
    return folder


def painted(unreal, material, label="Box"):
    actor = unreal.EditorLevelLibrary.spawn_actor_from_object(unreal.load_asset(CUBE), unreal.Vector())
    actor.set_actor_label(label)
    actor.static_mesh_component.set_material(0, material)
    return actor


def textures(tmp_path: Path) -> int:
    """Pictures in the GLB of the open level."""
    write_glb(state.world(), tmp_path / "level.glb")
    return (tmp_path / "level.glb").read_bytes().count(b"\x89PNG")


def test_a_copied_material_keeps_its_texture(pack, tmp_path):
    unreal = boot([pack], tmp_path / "content")
    copy = unreal.EditorAssetLibrary.duplicate_asset("/Game/T/M_Red", "/Game/Mine/M_Copy")
    second = unreal.EditorAssetLibrary.duplicate_asset("/Game/Mine/M_Copy", "/Game/Mine/M_Second")
    tools = unreal.AssetToolsHelpers.get_asset_tools()
    instance = tools.create_asset(
        "MI_Copy", "/Game/Mine", unreal.MaterialInstanceConstant, unreal.MaterialInstanceConstantFactoryNew()
    )
    instance.set_editor_property("parent", second)
    for material in (copy, second, instance):
        actor = painted(unreal, material)
        assert textures(tmp_path) == 1, material.get_name()
        actor.destroy_actor()
    unreal.EditorAssetLibrary.save_directory("/Game/Mine")
    painted(unreal, instance)
    unreal.EditorLoadingAndSavingUtils.save_map(unreal.EditorLevelLibrary.get_editor_world(), "/Game/Mine/Level")
    boot([pack], tmp_path / "content", start_map="/Game/Mine/Level")
    assert textures(tmp_path) == 1


def test_what_uses_an_asset_follows_its_new_name(pack, tmp_path):
    unreal = boot([pack], tmp_path / "content")
    library, subsystem = unreal.EditorAssetLibrary, unreal.get_editor_subsystem(unreal.EditorAssetSubsystem)
    made = subsystem.duplicate_asset("/Game/T/M_Red", "/Game/Mine/M_A")
    box = painted(unreal, made)
    assert library.save_asset("/Game/Mine/M_A") and library.rename_asset("/Game/Mine/M_A", "/Game/Other/M_B")
    assert not library.does_asset_exist("/Game/Mine/M_A") and library.does_asset_exist("/Game/Other/M_B")
    assert not (tmp_path / "content/Game/Mine/M_A.asset.json").exists()
    assert box.static_mesh_component.get_material(0).get_path_name() == "/Game/Other/M_B.M_B"
    assert unreal.load_asset("/Game/Other/M_B") is made and made.get_name() == "M_B"
    for source, target in (
        ("/Game/T/M_Red", "/Game/T/M_Other"),
        ("/Game/Other/M_B", "/Game/T/M_Red"),
        ("/Game/Other/M_B", "/Engine/M_B"),
        ("/Game/None", "/Game/Mine/M_C"),
    ):
        assert not library.rename_asset(source, target)
    assert library.rename_directory("/Game/Other", "/Game/Last") and library.does_asset_exist("/Game/Last/M_B")
    assert not library.rename_directory("/Game/T", "/Game/U")


def test_deleting_leaves_nothing_in_its_place(pack, tmp_path):
    unreal = boot([pack], tmp_path / "content")
    library = unreal.EditorAssetLibrary
    made = library.duplicate_asset("/Game/T/M_Red", "/Game/Mine/M_A")
    mesh = library.duplicate_asset(CUBE, "/Game/Mine/SM_Box")
    box = painted(unreal, made)
    box.static_mesh_component.set_static_mesh(mesh)
    assert library.delete_loaded_asset(made) and library.delete_asset("/Game/Mine/SM_Box")
    assert box.static_mesh_component.static_mesh is None
    assert len(box.static_mesh_component.get_editor_property("override_materials")) == 0
    assert not library.delete_asset("/Game/T/M_Red") and library.does_asset_exist("/Game/T/M_Red")
    assert not library.delete_directory("/Game/T")


def test_merging_assets(pack, tmp_path):
    unreal = boot([pack], tmp_path / "content")
    library = unreal.EditorAssetLibrary
    kept, gone = (library.duplicate_asset("/Game/T/M_Red", f"/Game/Mine/M_{n}") for n in "AB")
    box = painted(unreal, gone)
    dynamic = painted(unreal, None)
    instance = dynamic.static_mesh_component.create_dynamic_material_instance(0, gone)
    assert not library.consolidate_assets(kept, [unreal.load_asset(CUBE)])
    assert library.consolidate_assets(kept, [gone]) and not library.does_asset_exist("/Game/Mine/M_B")
    assert box.static_mesh_component.get_material(0) is kept and instance.get_editor_property("parent") is kept
    assert list(library.find_package_referencers_for_asset("/Game/Mine/M_A")) == ["/Temp/Untitled_1"]


def test_parameters_have_the_names_that_a_script_gave_them(tmp_path):
    unreal = boot([], tmp_path)
    edit, tools = unreal.MaterialEditingLibrary, unreal.AssetToolsHelpers.get_asset_tools()
    base = tools.create_asset("M_Base", "/Game/M", unreal.Material, unreal.MaterialFactoryNew())
    for kind, name, where in (
        (unreal.MaterialExpressionVectorParameter, "PaintColor", unreal.MaterialProperty.MP_BASE_COLOR),
        (unreal.MaterialExpressionScalarParameter, "Shine", unreal.MaterialProperty.MP_ROUGHNESS),
    ):
        node = edit.create_material_expression(base, kind, -300, 0)
        node.set_editor_property("parameter_name", name)
        assert edit.connect_material_property(node, "", where)
    edit.recompile_material(base)
    made = tools.create_asset(
        "MI_A", "/Game/M", unreal.MaterialInstanceConstant, unreal.MaterialInstanceConstantFactoryNew()
    )
    edit.set_material_instance_parent(made, base)
    assert edit.set_material_instance_vector_parameter_value(made, "paintcolor", unreal.LinearColor(0, 1, 0, 1))
    assert edit.set_material_instance_scalar_parameter_value(made, "Shine", 0.25)
    assert not edit.set_material_instance_scalar_parameter_value(made, "PaintColor", 1.0)
    assert "PaintColor" in list(edit.get_vector_parameter_names(made))
    unreal.EditorAssetLibrary.save_directory("/Game/M")
    unreal = boot([], tmp_path)
    again = unreal.load_asset("/Game/M/MI_A")
    value = unreal.MaterialEditingLibrary.get_material_instance_vector_parameter_value(again, "PaintColor")
    assert value.to_tuple() == (0, 1, 0, 1)
    assert unreal.MaterialEditingLibrary.get_material_instance_scalar_parameter_value(again, "Shine") == 0.25


def test_folders_lists_and_metadata(pack, tmp_path):
    unreal = boot([pack], tmp_path / "content")
    library, subsystem = unreal.EditorAssetLibrary, unreal.get_editor_subsystem(unreal.EditorAssetSubsystem)
    assert library.make_directory("/Game/Mine/Deep") and not library.make_directory("/Engine/Mine")
    made = library.duplicate_asset("/Game/T/M_Red", "/Game/Mine/Deep/M_A")
    assert list(library.list_assets("/Game/Mine", recursive=False)) == []
    assert list(library.list_assets("/Game/Mine/")) == ["/Game/Mine/Deep/M_A.M_A"]
    assert list(library.list_assets("/Game/Mine", True, True)) == ["/Game/Mine/Deep/", "/Game/Mine/Deep/M_A.M_A"]
    assert library.does_directory_have_assets("/Game/Mine") and subsystem.does_directory_contain_assets("/Game/Mine")
    subsystem.set_metadata_tag(made, "Season", "autumn")
    assert subsystem.get_metadata_tag(made, "season") == "autumn"
    assert dict(subsystem.get_metadata_tag_values(made)) == {unreal.Name("Season"): "autumn"}
    assert list(library.list_asset_by_tag_value("Season", "autumn")) == ["/Game/Mine/Deep/M_A.M_A"]
    assert library.duplicate_directory("/Game/Mine", "/Game/Twin")
    assert list(library.list_assets("/Game/Twin")) == ["/Game/Twin/Deep/M_A.M_A"]
    assert library.delete_directory("/Game/Mine") and not library.does_directory_exist("/Game/Mine/Deep")
    registry = unreal.AssetRegistryHelpers.get_asset_registry()
    wanted = unreal.ARFilter(
        class_paths=[unreal.TopLevelAssetPath("/Script/Engine", "MaterialInterface")],
        package_paths=["/Game"],
        recursive_paths=True,
        recursive_classes=True,
    )
    assert [str(d.asset_name) for d in registry.get_assets(wanted)] == ["M_Red", "M_A"]


def test_nothing_in_the_place_of_an_object_is_logged_not_fatal(tmp_path, capsys):
    unreal = boot([], tmp_path)
    actors = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)
    assert actors.spawn_actor_from_object(unreal.load_asset("/Game/None"), unreal.Vector()) is None
    assert actors.spawn_actor_from_class(None, unreal.Vector()) is None
    assert actors.destroy_actor(None) is False
    assert "ObjectToUse is not valid" in capsys.readouterr().out


def test_transactions_open_and_close_and_edits_stay(tmp_path):
    unreal = boot([], tmp_path)
    system = unreal.SystemLibrary
    assert system.begin_transaction("tools", "first", None) == 0
    with unreal.ScopedEditorTransaction("second") as inner:
        actor = unreal.EditorLevelLibrary.spawn_actor_from_class(unreal.StaticMeshActor, unreal.Vector())
        inner.cancel()
    assert system.end_transaction() == 0 and system.end_transaction() == -1
    actor.set_actor_label("Still here")
    with pytest.raises(ValueError, match="mine"), unreal.ScopedEditorTransaction("third"):
        raise ValueError("mine")
    with pytest.raises(TypeError):
        unreal.ScopedEditorTransaction(3)
    assert [a.get_actor_label() for a in unreal.EditorLevelLibrary.get_all_level_actors()] == ["Still here"]


def test_older_functions_warn_their_caller(tmp_path):
    unreal = boot([], tmp_path)
    with pytest.warns(
        DeprecationWarning,
        match="Function 'get_all_level_actors' on 'EditorLevelLibrary' is "
        "deprecated: .* Use the function in Editor Actor Utilities Subsystem",
    ):
        unreal.EditorLevelLibrary.get_all_level_actors()


def test_moves_give_a_hit_and_destroying_gives_nothing(tmp_path):
    unreal = boot([], tmp_path)
    actor = unreal.EditorLevelLibrary.spawn_actor_from_class(unreal.StaticMeshActor, unreal.Vector())
    hit = actor.set_actor_location(unreal.Vector(1, 2, 3), False, False)
    assert isinstance(hit, unreal.HitResult) and not hit.to_tuple()[0]
    actor.root_component.add_local_rotation(unreal.Rotator(yaw=90), False, False)
    actor.add_actor_local_offset(unreal.Vector(10, 0, 0), False, False)
    assert actor.get_actor_location().is_near_equal(unreal.Vector(1, 12, 3))
    assert actor.destroy_actor() is None


def test_properties_by_their_other_names_and_errors_in_unreals_words(tmp_path):
    unreal = boot([], tmp_path)
    lamp = unreal.EditorLevelLibrary.spawn_actor_from_class(unreal.PointLight, unreal.Vector())
    part = lamp.point_light_component
    part.set_editor_property("CastShadows", False)
    assert part.get_editor_property("bCastShadows") is False
    part.set_editor_properties({"intensity": 7, "attenuation_radius": 50.0})
    assert part.get_editor_property("Intensity") == 7.0
    with pytest.raises(TypeError) as caught:
        part.set_editor_property("light_color", unreal.LinearColor(1, 1, 1, 1))
    assert str(caught.value).splitlines() == [
        "PointLightComponent: Failed to convert type 'LinearColor' to property 'LightColor' (StructProperty) for "
        "attribute 'light_color' on 'PointLightComponent'",
        "  TypeError: NativizeProperty: Cannot nativize 'LinearColor' as 'LightColor' (StructProperty)",
        "    TypeError: NativizeStructInstance: Cannot nativize 'LinearColor' as 'Color'",
    ]
    with pytest.raises(TypeError, match=r"set_actor_location\(\) required argument 'sweep' \(pos 2\) not found"):
        lamp.set_actor_location(unreal.Vector())
    with pytest.raises(TypeError, match=r"get_actor_label\(\) takes at most 1 argument \(2 given\)"):
        lamp.get_actor_label(True, True)
    with pytest.raises(
        TypeError,
        match=r"'loc' is an invalid keyword argument for set_actor_scale3d\(\)|"
        r"required argument 'new_scale3d'",
    ):
        lamp.set_actor_scale3d(loc=unreal.Vector())
    with pytest.raises(Exception, match="is read-only and cannot be set"):
        lamp.set_editor_property("root_component", part)
    assert lamp.call_method("get_actor_label") == lamp.get_actor_label()
    assert unreal.get_default_object(unreal.PointLight).get_class() == unreal.PointLight.static_class()
