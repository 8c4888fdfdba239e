"""Film cameras, arithmetic between material expressions, and the setters that are made from tables."""

from __future__ import annotations

from pathlib import Path
from types import ModuleType

import pytest

from c4s.engine.headless.process.boot import boot


@pytest.fixture
def unreal(tmp_path: Path) -> ModuleType:
    return boot([], tmp_path / "content")


def spawn(unreal: ModuleType, cls: type):
    return unreal.EditorLevelLibrary.spawn_actor_from_class(cls, unreal.Vector())


def test_a_film_camera_sees_as_wide_as_its_lens(unreal):
    camera = spawn(unreal, unreal.CineCameraActor).get_cine_camera_component()
    assert camera.get_horizontal_field_of_view() == pytest.approx(37.497, abs=1e-3)
    assert camera.get_editor_property("field_of_view") == camera.get_horizontal_field_of_view()
    camera.set_field_of_view(90.0)
    assert camera.current_focal_length == pytest.approx(23.76 / 2)
    camera.set_editor_property("current_focal_length", 1.0)
    assert camera.current_focal_length == 4.0, "the lens ends there"
    focus = camera.focus_settings
    focus.manual_focus_distance = 250.0
    assert camera.current_focus_distance == 250.0
    with pytest.raises(Exception, match="read-only"):
        camera.set_editor_property("current_focus_distance", 1.0)


def test_a_film_camera_is_saved_and_opened(unreal, tmp_path):
    spawn(unreal, unreal.CineCameraActor).get_cine_camera_component().set_editor_property("current_focal_length", 85.0)
    library = unreal.EditorLoadingAndSavingUtils
    assert library.save_map(unreal.EditorLevelLibrary.get_editor_world(), "/Game/Cine")
    library.load_map("/Game/Cine")
    (actor,) = unreal.EditorLevelLibrary.get_all_level_actors()
    assert actor.get_class().get_path_name() == "/Script/CinematicCamera.CineCameraActor"
    assert actor.get_cine_camera_component().current_focal_length == 85.0


def test_arithmetic_drives_a_surface_and_its_parameters_reach_instances(unreal):
    tools, edit = unreal.AssetToolsHelpers.get_asset_tools(), unreal.MaterialEditingLibrary
    material = tools.create_asset("M_Mix", "/Game/Made", unreal.Material, unreal.MaterialFactoryNew())

    def make(kind: str, **values):
        made = edit.create_material_expression(material, getattr(unreal, f"MaterialExpression{kind}"))
        made.set_editor_properties(values)
        return made

    tint = make("VectorParameter", parameter_name="Tint", default_value=unreal.LinearColor(0.8, 0.4, 0.2, 1))
    mixed = make("LinearInterpolate", const_b=0.0, const_alpha=0.25)
    darker = make("Multiply", const_b=0.5)
    assert edit.connect_material_expressions(tint, "", mixed, "A")
    assert edit.connect_material_expressions(mixed, "", darker, "")
    assert not edit.connect_material_expressions(mixed, "", darker, "Alpha"), "no such input"
    assert not edit.connect_material_expressions(darker, "", mixed, "B"), "a circle"
    assert edit.connect_material_property(darker, "", unreal.MaterialProperty.MP_BASE_COLOR)
    one_minus = make("OneMinus")
    assert edit.connect_material_expressions(tint, "G", one_minus, "")
    assert edit.connect_material_property(one_minus, "", unreal.MaterialProperty.MP_ROUGHNESS)
    surface = material._surface()
    assert surface.base_color == pytest.approx((0.3, 0.15, 0.075)) and surface.roughness == pytest.approx(0.6)
    assert edit.get_num_material_expressions(material) == 4
    assert [str(n) for n in edit.get_scalar_parameter_names(material)] == ["Roughness", "Metallic", "Opacity"]

    instance = tools.create_asset(
        "MI_Mix", "/Game/Made", unreal.MaterialInstanceConstant, unreal.MaterialInstanceConstantFactoryNew()
    )
    edit.set_material_instance_parent(instance, material)
    assert edit.set_material_instance_vector_parameter_value(instance, "Tint", unreal.LinearColor(0, 0, 1, 1))
    assert [str(data.asset_name) for data in edit.get_child_instances(material)] == ["MI_Mix"]
    edit.clear_all_material_instance_parameters(instance)
    assert instance._surface().base_color == surface.base_color
    edit.delete_material_expression(material, mixed)
    edit.recompile_material(material)
    assert material._surface().base_color == (0, 0, 0)


def test_parameters_on_all_materials_of_a_component(unreal):
    box = unreal.EditorLevelLibrary.spawn_actor_from_object(
        unreal.load_asset("/Engine/BasicShapes/Cube"), unreal.Vector()
    ).static_mesh_component
    box.set_vector_parameter_value_on_materials("BaseColor", unreal.Vector(1, 0.5, 0))
    box.set_scalar_parameter_value_on_materials("Roughness", 0.25)
    made = box.get_material(0)
    assert isinstance(made, unreal.MaterialInstanceDynamic)
    assert (made._surface().base_color, made._surface().roughness) == ((1, 0.5, 0), 0.25)


def test_setters_from_tables_are_as_strict_as_others(unreal):
    sun = spawn(unreal, unreal.DirectionalLight).get_component_by_class(unreal.DirectionalLightComponent)
    sun.set_atmosphere_sun_light_index(1)
    sun.set_shadow_bias(new_value=0.75)
    assert (sun.get_editor_property("atmosphere_sun_light_index"), sun.shadow_bias) == (1, 0.75)
    with pytest.raises(TypeError, match=r"required argument 'new_value' \(pos 1\) not found"):
        sun.set_shadow_bias()
    with pytest.raises(TypeError, match="required argument 'new_value'"):
        sun.set_shadow_bias(value=1.0)
    with pytest.raises(TypeError, match="Cannot nativize 'str' as 'float'"):
        sun.set_shadow_bias("much")


def test_assets_are_renamed_and_named_by_the_asset_tools(unreal):
    tools = unreal.AssetToolsHelpers.get_asset_tools()
    made = tools.create_asset("M_A", "/Game/Made", unreal.Material, unreal.MaterialFactoryNew())
    assert tools.create_unique_asset_name("/Game/Made/M_A", "") == ("/Game/Made/M_A1", "M_A1")
    assert tools.create_unique_asset_name("/Game/Made/M_", "B") == ("/Game/Made/M_B", "M_B")
    assert tools.duplicate_asset("M_C", "/Game/Made", made) is not None
    assert tools.rename_assets([unreal.AssetRenameData(made, "/Game/Other", "M_Z")])
    assert unreal.EditorAssetLibrary.does_asset_exist("/Game/Other/M_Z")
