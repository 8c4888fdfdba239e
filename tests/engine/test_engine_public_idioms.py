"""What scripts of others were seen to do, and what stopped them: names, settings, layers, files of packages."""

from __future__ import annotations

from pathlib import Path

import pytest

from c4s.engine.headless.editor import world

CUBE = "/Engine/BasicShapes/Cube"


pytestmark = pytest.mark.usefixtures("empty_level")


@pytest.fixture
def cubes(unreal, actors):
    mesh = unreal.load_asset(CUBE)
    return [actors.spawn_actor_from_object(mesh, unreal.Vector(300 * i, 0, 50)) for i in range(3)]


def saved(unreal, name="Idioms"):
    library = unreal.EditorLoadingAndSavingUtils
    assert library.save_map(world().map, f"/Game/{name}") and library.load_map(f"/Game/{name}")
    return list(unreal.get_editor_subsystem(unreal.EditorActorSubsystem).get_all_level_actors())


@pytest.mark.parametrize("name", ["Landscape", "LandscapeProxy", "InstancedFoliageActor", "SkeletalMeshActor", "Pawn"])
def test_actor_classes_are_known_by_name_and_nothing_is_one(unreal, actors, cubes, name):
    kind = getattr(unreal, name)
    assert issubclass(kind, unreal.Actor) and not any(isinstance(actor, kind) for actor in cubes)
    assert len(unreal.GameplayStatics.get_all_actors_of_class(world().map, kind)) == 0
    for made in (kind, kind.static_class()):
        with pytest.raises(Exception, match=f"has no actors of class '/Script/.*{name}'"):
            actors.spawn_actor_from_class(made, unreal.Vector())
    assert len(actors.get_all_level_actors()) == 3


def test_component_and_asset_kinds_are_known_by_name(unreal, cubes):
    assert len(cubes[0].get_components_by_class(unreal.AudioComponent)) == 0
    assert not isinstance(unreal.load_asset(CUBE), (unreal.SkeletalMesh, unreal.Texture2D, unreal.LevelSequence))
    subobjects = unreal.get_engine_subsystem(unreal.SubobjectDataSubsystem)
    parent = subobjects.k2_gather_subobject_data_for_instance(cubes[0])[0]
    params = unreal.AddNewSubobjectParams(parent_handle=parent, new_class=unreal.AudioComponent)
    _, why = subobjects.add_new_subobject(params)
    assert "has no components of class" in str(why) and "AudioComponent" in str(why)
    assert len(cubes[0].get_components_by_class(unreal.ActorComponent)) == 1
    assert not hasattr(unreal, "NoSuchActor")


def test_a_level_has_settings_that_are_no_actor_to_place(unreal, actors):
    settings = unreal.EditorLevelLibrary.get_editor_world().get_world_settings()
    settings.set_editor_property("kill_z", -5000.0)
    settings.global_gravity_set = True
    again = world().map.get_world_settings()
    assert (again.kill_z, again.global_gravity_set) == (-5000.0, True)
    assert len(actors.get_all_level_actors()) == 0
    assert actors.spawn_actor_from_class(unreal.WorldSettings, unreal.Vector()) is None


def test_physics_is_a_setting_that_is_kept(unreal, cubes):
    part = cubes[1].static_mesh_component
    assert not part.is_simulating_physics() and not part.is_gravity_enabled()
    part.set_simulate_physics(True)
    part.set_enable_gravity(False)
    kept = saved(unreal)[1].static_mesh_component
    assert kept.is_simulating_physics() and not kept.is_gravity_enabled()
    assert kept.get_world_location().z == 50, "nothing falls in the editor"


def test_layers_are_kept_with_the_actors(unreal, cubes):
    layers = unreal.get_editor_subsystem(unreal.LayersSubsystem)
    assert layers.add_actors_to_layer(cubes[:2], "Props") and not layers.add_actor_to_layer(cubes[0], "Props")
    assert layers.add_actor_to_layers(cubes[0], ["Props", "Near"])
    saved(unreal)
    assert [str(name) for name in layers.add_all_layer_names_to()] == ["Props", "Near"]
    assert len(layers.get_actors_from_layer("Props")) == 2 and layers.is_layer("Near")
    assert layers.select_actors_in_layer("Near", True, True) and len(layers.get_selected_actors()) == 1
    assert layers.remove_selected_actors_from_layer("Near") and not layers.is_layer("Near")
    layers.delete_layer("Props")
    assert not layers.get_actors_from_layers(["Props", "Near"])


def test_any_material_expression_is_made_and_connected(unreal):
    tools, edit = unreal.AssetToolsHelpers.get_asset_tools(), unreal.MaterialEditingLibrary
    made = tools.create_asset("M_Odd", "/Game/Odd", unreal.Material, unreal.MaterialFactoryNew())
    call = edit.create_material_expression(made, unreal.MaterialExpressionMaterialFunctionCall, -400, 0)
    call.set_editor_property("MaterialFunction", None)
    far = edit.create_material_expression(made, unreal.MaterialExpressionDistance, -200, 0)
    assert edit.connect_material_expressions(call, "", far, "B")
    assert edit.connect_material_property(far, "", unreal.MaterialProperty.MP_ROUGHNESS)
    rough = made._surface().roughness
    edit.recompile_material(made)
    assert made._surface().roughness == rough, "no constant: the surface stays as it was"
    assert issubclass(unreal.MaterialExpressionDistance, unreal.MaterialExpression)


def test_switches_of_materials_say_that_there_are_none(unreal):
    edit, tools = unreal.MaterialEditingLibrary, unreal.AssetToolsHelpers.get_asset_tools()
    factory = unreal.MaterialInstanceConstantFactoryNew()
    made = tools.create_asset("MI_Switch", "/Game/Odd", unreal.MaterialInstanceConstant, factory)
    assert edit.set_material_instance_static_switch_parameter_value(made, "Wet", True) is False
    assert edit.get_material_instance_static_switch_parameter_value(made, "Wet") is False
    with pytest.raises(Exception, match="Failed to find property 'initial_parent'"):
        factory.set_editor_property("initial_parent", None)


def test_a_blueprint_that_cannot_be_made_says_so(unreal, capsys):
    factory = unreal.BlueprintFactory()
    factory.set_editor_property("parent_class", unreal.Actor)
    tools = unreal.AssetToolsHelpers.get_asset_tools()
    assert tools.create_asset("BP_New", "/Game/Odd", None, factory) is None
    assert unreal.BlueprintEditorLibrary.create_blueprint_asset_with_parent("/Game/Odd/BP_New", unreal.Actor) is None
    assert capsys.readouterr().out.count("makes no Blueprints") == 2


def test_the_file_of_a_package_is_there_when_the_package_is(unreal, cubes):
    file_of = unreal.PackageTools.package_name_to_filename
    saved(unreal, "Maps/Here")
    made = unreal.AssetToolsHelpers.get_asset_tools().create_asset(
        "M_Kept", "/Game/Odd", unreal.Material, unreal.MaterialFactoryNew()
    )
    assert not Path(file_of("/Game/Odd/M_Kept", ".uasset")).is_file(), "in memory only"
    unreal.EditorAssetLibrary.save_loaded_asset(made)
    there = {("/Game/Maps/Here", ".umap"), ("/Game/Odd/M_Kept", ".uasset")}
    for package in ("/Game/Maps/Here", "/Game/Odd/M_Kept", "/Game/Nowhere"):
        for suffix in (".umap", ".uasset"):
            assert Path(file_of(package, suffix)).is_file() is ((package, suffix) in there)
    assert file_of("/Game/Nowhere", ".uasset").endswith("/Game/Nowhere.uasset")


def test_the_version_says_what_is_modelled(unreal):
    told = unreal.SystemLibrary.get_engine_version()
    assert [int(part) for part in told.split(".")[:2]] == [5, 6] and "+5.8-names" in told
    assert unreal.TraceTypeQuery.ECC_VISIBILITY and unreal.ObjectTypeQuery.ECC_WORLD_STATIC
