"""Paths as scripts write them: four forms, in every function that takes one; classes and engine content by path."""

from __future__ import annotations

import pytest

from c4s.engine.headless.editor import world
from c4s.packs.store import bare_path

PACKAGE = "/Engine/BasicShapes/Cube"
FORMS = [
    PACKAGE,
    f"{PACKAGE}.Cube",
    f"StaticMesh'{PACKAGE}.Cube'",
    f"/Script/Engine.StaticMesh'{PACKAGE}.Cube'",
    f"/Script/Engine.StaticMesh'\"{PACKAGE}.Cube\"'",
]


pytestmark = pytest.mark.usefixtures("empty_level")


@pytest.mark.parametrize("path", FORMS)
def test_every_function_takes_every_form(unreal, path):
    library = unreal.EditorAssetLibrary
    cube = unreal.load_asset(PACKAGE)
    for found in (
        unreal.load_asset(path),
        unreal.find_asset(path),
        unreal.load_object(None, path),
        unreal.find_object(None, path),
        unreal.load_asset(path, unreal.StaticMesh),
        library.load_asset(path),
        library.find_asset_data(path).get_asset(),
        unreal.get_editor_subsystem(unreal.EditorAssetSubsystem).load_asset(path),
    ):
        assert found is cube
    assert unreal.load_asset(path, unreal.Material) is None and unreal.find_object(None, path, unreal.Material) is None
    assert library.does_asset_exist(path) and library.do_assets_exist([path]) and library.checkout_asset(path)
    assert list(library.list_assets(path)) == [f"{PACKAGE}.Cube"]
    assert library.save_asset(path) and not library.delete_asset(path)
    assert len(library.find_package_referencers_for_asset(path)) == 0
    assert unreal.find_package(path).get_name() == PACKAGE and unreal.load_package(path).get_name() == PACKAGE


@pytest.mark.parametrize("form", ["{0}", "{0}.{1}", "StaticMesh'{0}.{1}'", "/Script/Engine.StaticMesh'{0}.{1}'"])
def test_assets_are_made_moved_and_deleted_under_every_form(unreal, form):
    library = unreal.EditorAssetLibrary

    def path(name: str) -> str:
        return form.format(f"/Game/Forms/{name}", name)

    made = library.duplicate_asset(FORMS[2], path("One"))
    assert made.get_path_name() == "/Game/Forms/One.One"
    assert library.save_asset(path("One")) and library.rename_asset(path("One"), path("Two"))
    assert library.load_asset(path("Two")) is made and library.delete_asset(path("Two"))
    assert not library.does_asset_exist(path("Two"))


@pytest.mark.parametrize("form", ["{0}", "{0}.{1}", "World'{0}.{1}'", "/Script/Engine.World'{0}.{1}'"])
def test_levels_are_saved_and_opened_under_every_form(unreal, form):
    levels = unreal.get_editor_subsystem(unreal.LevelEditorSubsystem)
    name = f"Map{len(form)}"
    path = form.format(f"/Game/Forms/{name}", name)
    assert levels.new_level(path) and world().package == f"/Game/Forms/{name}"
    assert unreal.EditorLoadingAndSavingUtils.save_map(world().map, path)
    assert levels.load_level(path) and unreal.EditorAssetLibrary.does_asset_exist(path)


@pytest.mark.parametrize(
    "text", ["", "'", "''", "It's", "Cube'Game/A'", "StaticMesh'/Game/A", "/Game/A'", "a b'/Game/A'", "/Game/It's/Here"]
)
def test_what_is_no_export_text_stays_as_it_is(text):
    assert bare_path(text) == text


@pytest.mark.parametrize(
    "path",
    [
        "/Script/Engine.PointLight",
        "Class'/Script/Engine.PointLight'",
        "/Script/CoreUObject.Class'/Script/Engine.PointLight'",
    ],
)
def test_native_classes_are_objects_of_a_path(unreal, path):
    light = unreal.PointLight.static_class()
    for found in (
        unreal.load_class(None, path),
        unreal.load_class(None, path, unreal.Actor),
        unreal.load_object(None, path),
        unreal.find_object(None, path),
        unreal.load_asset(path),
    ):
        assert found is light
    assert unreal.load_class(None, path, unreal.StaticMesh) is None
    assert unreal.load_class(None, "/Script/Engine.PointLights") is None
    assert unreal.load_class(None, "/Script/CinematicCamera.PointLight") is None


def test_actors_and_components_are_found_by_path(unreal, actors):
    actor = actors.spawn_actor_from_class(unreal.PointLight, unreal.Vector())
    part = actor.point_light_component
    assert unreal.find_object(None, actor.get_path_name()) is actor
    assert unreal.load_object(None, part.get_path_name()) is part
    assert unreal.find_object(None, f"PointLight'{actor.get_path_name()}'") is actor
    assert unreal.find_object(None, actor.get_path_name().replace("Untitled_1", "Other")) is None
    assert unreal.find_object(None, part.get_path_name() + "x") is None


@pytest.mark.parametrize(
    ("path", "across"),
    [
        ("/Engine/EditorMeshes/EditorCube", 256),
        ("/Engine/EditorMeshes/EditorSphere", 256),
        ("/Engine/EditorMeshes/EditorCylinder", 256),
        ("/Engine/EditorMeshes/EditorPlane", 256),
        ("/Engine/EngineMeshes/Cube", 256),
        ("/Engine/EngineMeshes/Sphere", 320),
        ("/Engine/EngineMeshes/Cylinder", 256),
        ("/Engine/EngineMeshes/Cone", 256),
    ],
)
def test_engine_meshes_can_be_placed_and_met(unreal, actors, path, across):
    mesh = unreal.load_asset(path)
    actor = actors.spawn_actor_from_object(mesh, unreal.Vector(0, 0, 0))
    origin, extent = actor.get_actor_bounds(True)
    assert origin == unreal.Vector() and extent.x == extent.y == across / 2
    hit = unreal.SystemLibrary.line_trace_single(
        world().map,
        unreal.Vector(1, 1, 1000),
        unreal.Vector(1, 1, -1000),
        unreal.TraceTypeQuery.TRACE_TYPE_QUERY1,
        False,
        [],
        unreal.DrawDebugTrace.NONE,
    )
    assert hit.to_tuple()[4].z == pytest.approx(extent.z, abs=3)
    assert mesh.get_material(0).get_name() == "WorldGridMaterial" and mesh.get_num_triangles(0) > 0


def test_engine_materials_and_the_sky_sphere(unreal, actors):
    for name in ("WorldGridMaterial", "DefaultMaterial"):
        assert isinstance(unreal.load_asset(f"Material'/Engine/EngineMaterials/{name}.{name}'"), unreal.Material)
    kind = unreal.load_class(None, "/Engine/EngineSky/BP_Sky_Sphere.BP_Sky_Sphere_C")
    sky = actors.spawn_actor_from_class(kind, unreal.Vector(1, 2, 3))
    assert sky.get_actor_label() == "BP_Sky_Sphere" and sky.get_actor_bounds(False)[1] == unreal.Vector()
    assert unreal.EditorAssetLibrary.load_blueprint_class("/Engine/EngineSky/BP_Sky_Sphere") is kind
    assert len(unreal.EditorAssetLibrary.list_assets("/Engine/EditorMeshes")) == 4
