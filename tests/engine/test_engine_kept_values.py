"""Editor properties that the engine only keeps: all that Unreal lists, strict, with its defaults, saved and opened."""

from __future__ import annotations

import json
import subprocess
import sys
from enum import Enum
from pathlib import Path
from types import ModuleType

import kept_defaults
import kept_table
import pytest
from stub_index import StubIndex

from c4s.engine.headless.editor import world
from c4s.engine.headless.process.boot import boot
from c4s.engine.headless.unreal import table

WHOLE = [
    "StaticMesh",
    "StaticMeshComponent",
    "Material",
    "PointLightComponent",
    "SpotLightComponent",
    "RectLightComponent",
    "DirectionalLightComponent",
    "SkyLightComponent",
    "ExponentialHeightFogComponent",
    "SkyAtmosphereComponent",
    "VolumetricCloudComponent",
    "CameraComponent",
    "CineCameraComponent",
    "DecalComponent",
    "MaterialInstanceConstant",
]
"""Classes of which every property is here."""


@pytest.fixture(scope="module")
def unreal(tmp_path_factory: pytest.TempPathFactory) -> ModuleType:
    return boot([], tmp_path_factory.mktemp("kept"))


@pytest.fixture(scope="module")
def stub() -> StubIndex:
    return StubIndex.installed()


def spawn(unreal, kind):
    world().new_map()
    return unreal.get_editor_subsystem(unreal.EditorActorSubsystem).spawn_actor_from_class(kind, unreal.Vector())


def reopened(unreal):
    library = unreal.EditorLoadingAndSavingUtils
    world_ = unreal.get_editor_subsystem(unreal.UnrealEditorSubsystem).get_editor_world()
    assert library.save_map(world_, "/Game/Kept") and library.load_map("/Game/Kept")
    return unreal.get_editor_subsystem(unreal.EditorActorSubsystem).get_all_level_actors()[0]


def test_the_table_is_what_its_command_makes():
    assert table.FILE.read_text() == kept_table.text(kept_table.table())


def test_the_engine_starts_without_the_table(tmp_path):
    code = (
        "import sys, builtins\nfrom pathlib import Path\nfrom c4s.engine.headless.process.boot import boot\n"
        f"u = boot([], Path({str(tmp_path)!r}))\nfrom c4s.engine.headless.unreal import table\n"
        "a = u.EditorLevelLibrary.spawn_actor_from_object(u.load_asset('/Engine/BasicShapes/Cube'), u.Vector())\n"
        "a.set_actor_label('x'); print(table._table.cache_info().currsize)\n"
        "a.static_mesh_component.lighting_channels; print(table._table.cache_info().currsize)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.split() == ["0", "1"]


def test_every_setting_of_post_processing(unreal, stub):
    listed = {name for each in stub.lineage("PostProcessSettings") for name in each.editor_properties}
    made = unreal.PostProcessSettings()
    assert len(listed) == 437 and set(type(made)._fields) == listed
    assert all(stub.has("PostProcessSettings", name) is hasattr(made, name) for name in listed)


@pytest.mark.parametrize("name", WHOLE)
def test_every_property_that_unreal_lists(unreal, stub, name):
    known = getattr(unreal, name)._completed()
    left_out = {prop for each in stub.lineage(name) for prop in kept_defaults.LEFT_OUT.get(each.name, {})} | set(
        kept_defaults.LEFT_OUT[""]
    )
    missing = set(stub.cls(name).editor_properties) - set(known) - left_out
    assert {prop for prop in missing if not prop.startswith("on_")} <= {"physics_volume_changed_delegate"}


def test_what_is_true_elsewhere_is_not_kept_beside_it(unreal):
    for name, left_out in kept_defaults.LEFT_OUT.items():
        for kind in (unreal.Actor, unreal.ActorComponent, unreal.MaterialInterface):
            for each in [kind, *everything_below(kind)]:
                line = ["", *(base.__name__ for base in each.__mro__)]
                assert not (set(each._completed()) & set(left_out)) - set(each._declared) or name not in line


def everything_below(kind):
    for each in kind.__subclasses__():
        yield each
        yield from everything_below(each)


def test_defaults_are_unreals_and_are_of_their_kinds(unreal):
    settings = unreal.PostProcessSettings()
    assert settings.film_slope == 0.88 and settings.bloom3_tint == unreal.LinearColor(0.1176, 0.1176, 0.1176, 1)
    assert settings.dynamic_global_illumination_method is unreal.DynamicGlobalIlluminationMethod.LUMEN
    assert settings.lumen_final_gather_screen_traces is True and settings.motion_blur_target_fps == 30
    assert settings.bloom_dirt_mask is None and not settings.override_film_slope
    cloud = spawn(unreal, unreal.VolumetricCloud).volumetric_cloud_component
    assert cloud.tracing_start_max_distance == 350 and cloud.ground_albedo == unreal.Color(170, 170, 170, 255)
    light = spawn(unreal, unreal.PointLight).point_light_component
    assert light.lighting_channels.channel0 is True and light.lighting_channels.channel1 is False


def test_every_type_of_the_table_can_be_made(unreal):
    made = {name: getattr(unreal, name) for name in table.names()}
    assert len(made) > 120 and set(made) <= set(dir(unreal))
    for name, kind in made.items():
        assert getattr(unreal, name) is kind
        if issubclass(kind, Enum):
            assert len(kind) > 0
        elif hasattr(kind, "to_tuple"):
            assert kind() == kind() and kind().copy() == kind()
        elif issubclass(kind, unreal.MaterialExpression):
            assert isinstance(kind(), kind)
        else:
            with pytest.raises(Exception, match="cannot be made"):
                kind()


def test_enums_and_structs_of_the_table_are_unreals(unreal, stub):
    for name in table.names():
        kind = getattr(unreal, name)
        if issubclass(kind, Enum):
            told = stub.numbers(name)
            numbers = {member: each.value for member, each in kind.__members__.items()}
            assert numbers == {**numbers, **told}
        elif hasattr(kind, "to_tuple"):
            shown = {field for field, prop in kind._fields.items() if prop.attribute}
            assert shown == {field for field in kind._fields if stub.has(name, field)}


def test_values_are_checked_strictly(unreal):
    volume = spawn(unreal, unreal.PostProcessVolume)
    actors = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)
    light = actors.spawn_actor_from_class(unreal.RectLight, unreal.Vector()).rect_light_component
    for wrong in (
        lambda: setattr(volume.settings, "film_slope", "steep"),
        lambda: setattr(volume.settings, "bloom_method", 1.5),
        lambda: setattr(volume.settings, "bloom_dirt_mask", light),
        lambda: setattr(volume.settings, "override_film_slope", "yes"),
        lambda: unreal.PostProcessSettings(film_slope="steep"),
        lambda: light.set_editor_property("source_texture_scale", "big"),
        lambda: light.set_editor_property("lighting_channels", 3),
    ):
        with pytest.raises(TypeError):
            wrong()
    with pytest.raises(AttributeError):
        volume.settings.film_slop = 1
    with pytest.raises(Exception, match="Failed to find property 'film_slop'"):
        volume.settings.set_editor_property("film_slop", 1)
    with pytest.raises(Exception, match="read-only"):
        spawn(unreal, unreal.PointLight).set_editor_property("role", unreal.NetRole.ROLE_NONE)
    with pytest.raises(AttributeError):
        unreal.BloomMethods  # noqa: B018


def test_cpp_names_are_accepted_by_name_only(unreal):
    settings = unreal.PostProcessSettings()
    settings.set_editor_property("bOverride_BloomIntensity", True)
    settings.set_editor_property("BloomIntensity", 2)
    assert settings.override_bloom_intensity and settings.get_editor_property("BloomIntensity") == 2
    with pytest.raises(AttributeError):
        settings.bOverride_BloomIntensity = True
    volume = spawn(unreal, unreal.PostProcessVolume)
    volume.set_editor_property("bUnbound", True)
    volume.get_editor_property("Settings").set_editor_property("bOverride_FilmSlope", True)
    assert volume.unbound and volume.settings.override_film_slope


def test_kept_values_are_saved_and_opened(unreal):
    volume = spawn(unreal, unreal.PostProcessVolume)
    volume.settings.override_film_slope = True
    volume.settings.film_slope = 0.5
    volume.settings.bloom_method = unreal.BloomMethod.BM_FFT
    volume.settings.bloom1_tint = unreal.LinearColor(1, 0.5, 0.25, 1)
    found = reopened(unreal).settings
    assert found.override_film_slope and found.film_slope == 0.5 and found.bloom_method is unreal.BloomMethod.BM_FFT
    assert found.bloom1_tint == unreal.LinearColor(1, 0.5, 0.25, 1)
    light = spawn(unreal, unreal.PointLight).point_light_component
    light.lighting_channels.channel1 = True
    light.set_editor_property("light_function_material", unreal.load_asset("/Engine/BasicShapes/BasicShapeMaterial"))
    light.set_editor_property("max_draw_distance", 900)
    found = reopened(unreal).point_light_component
    assert found.lighting_channels.channel1 and found.get_editor_property("max_draw_distance") == 900
    assert found.light_function_material.get_path_name() == "/Engine/BasicShapes/BasicShapeMaterial.BasicShapeMaterial"


def test_a_clean_process_opens_what_was_kept(unreal, tmp_path):
    decal = spawn(unreal, unreal.DecalActor)
    decal.set_decal_material(unreal.load_asset("/Engine/BasicShapes/BasicShapeMaterial"))
    decal.decal.fade_screen_size = 0.5
    reopened(unreal)
    (saved,) = json.loads((world().content / "Game" / "Kept.level.json").read_text())["actors"]
    assert saved["components"][0]["properties"]["decal_material"].startswith("/Engine/BasicShapes/")
    code = (
        "from pathlib import Path\nfrom c4s.engine.headless.process.boot import boot\n"
        f"u = boot([], Path({str(world().content)!r}))\nu.EditorLoadingAndSavingUtils.load_map('/Game/Kept')\n"
        "(a,) = u.get_editor_subsystem(u.EditorActorSubsystem).get_all_level_actors()\n"
        "print(a.get_decal_material().get_name(), a.decal.fade_screen_size)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.split() == ["BasicShapeMaterial", "0.5"]


def test_kept_values_of_assets_are_saved_where_assets_are(unreal, capsys):
    tools = unreal.AssetToolsHelpers.get_asset_tools()
    made = tools.create_asset("M_Kept", "/Game/Kept", unreal.Material, unreal.MaterialFactoryNew())
    made.set_editor_property("two_sided", True)
    made.set_editor_property("shading_model", unreal.MaterialShadingModel.MSM_UNLIT)
    assert unreal.EditorAssetLibrary.save_loaded_asset(made)
    world().created.clear()
    found = unreal.load_asset("/Game/Kept/M_Kept")
    assert found is not made and found.get_editor_property("two_sided")
    assert found.get_editor_property("shading_model") is unreal.MaterialShadingModel.MSM_UNLIT
    cube = unreal.load_asset("/Engine/BasicShapes/Cube")
    assert unreal.EditorAssetLibrary.save_loaded_asset(cube, False)
    cube.set_editor_property("light_map_resolution", 64)
    assert not unreal.EditorAssetLibrary.save_loaded_asset(cube, False)
    assert "read-only; not saved: light_map_resolution" in capsys.readouterr().out
    cube.set_editor_property("light_map_resolution", 4)


def test_a_document_with_an_unknown_value_is_refused(unreal, tmp_path):
    light = spawn(unreal, unreal.PointLight).point_light_component
    light.set_editor_property("max_draw_distance", 900)
    reopened(unreal)
    file = world().content / "Game" / "Kept.level.json"
    for bad in ('"max_draw_dist"', '"body_instance"'):
        file.write_text(file.read_text().replace('"max_draw_distance"', bad))
        with pytest.raises(Exception, match="no property"):
            unreal.EditorLoadingAndSavingUtils.load_map("/Game/Kept")
        file.write_text(file.read_text().replace(bad, '"max_draw_distance"'))
    assert Path(file).is_file()
