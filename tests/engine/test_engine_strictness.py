"""What the real module refuses is refused: unknown names, wrong arguments, unknown properties, dead objects."""

from __future__ import annotations

from pathlib import Path
from types import ModuleType

import pytest

from c4s.engine.headless.process.boot import boot


@pytest.fixture
def unreal(tmp_path: Path) -> ModuleType:
    return boot([], tmp_path)


@pytest.fixture
def actor(unreal):
    return unreal.EditorLevelLibrary.spawn_actor_from_object(
        unreal.load_asset("/Engine/BasicShapes/Cube.Cube"), unreal.Vector()
    )


def test_unknown_names(unreal, actor):
    for owner, name in (
        (unreal, "MakeScene"),
        (actor, "set_location"),
        (unreal.Vector(), "w"),
        (unreal.EditorAssetLibrary, "find"),
        (actor.static_mesh_component, "mesh"),
        (actor, "actor_guid_text"),
        (unreal.Guid(), "a"),
        (unreal.KBoxElem(), "center"),
    ):
        with pytest.raises(AttributeError):
            getattr(owner, name)
    with pytest.raises(AttributeError):
        actor.label = "x"
    with pytest.raises(AttributeError):
        unreal.Vector().length_cm = 1


@pytest.mark.parametrize(
    "call",
    [
        lambda u, a: a.set_actor_location(u.Vector()),
        lambda u, a: a.set_actor_location([0, 0, 0, 0], False, False),
        lambda u, a: a.set_actor_location("abc", False, False),
        lambda u, a: a.static_mesh_component.set_material(True, None),
        lambda u, a: a.set_actor_rotation(u.Rotator()),
        lambda u, a: a.set_actor_transform(u.Transform()),
        lambda u, a: a.set_actor_location(u.Vector(), False, teleported=False),
        lambda u, a: a.set_actor_label(7),
        lambda u, a: a.get_actor_bounds(),
        lambda u, a: a.add_actor_world_offset(u.Vector()),
        lambda u, a: u.Vector(1, 2, 3, 4),
        lambda u, a: u.Vector("1"),
        lambda u, a: u.Rotator(pitch="x"),
        lambda u, a: u.load_asset(a),
        lambda u, a: u.EditorLevelLibrary.spawn_actor_from_class("StaticMeshActor", u.Vector()),
        lambda u, a: u.EditorLevelLibrary.spawn_actor_from_class(u.StaticMeshActor),
        lambda u, a: a.static_mesh_component.set_static_mesh("/Engine/BasicShapes/Cube"),
        lambda u, a: a.static_mesh_component.set_material(0, "/Game/M"),
        lambda u, a: a.set_editor_property("tags", "one"),
        lambda u, a: u.get_editor_subsystem(u.StaticMeshActor),
        lambda u, a: u.Vector(*u.Vector(1, 2, 3)),
    ],
)
def test_wrong_arguments_are_type_errors(unreal, actor, call):
    with pytest.raises(TypeError):
        call(unreal, actor)


def test_unknown_editor_property(unreal, actor):
    with pytest.raises(Exception, match="StaticMeshActor: Failed to find property 'colour' for attribute 'colour'"):
        actor.get_editor_property("colour")
    with pytest.raises(Exception, match="Failed to find property"):
        actor.static_mesh_component.set_editor_property("bounds", 1)


def test_function_results_are_copies(unreal, actor):
    place = actor.get_actor_location()
    place.x = 99
    assert actor.get_actor_location().x == 0
    transform = actor.get_actor_transform()
    transform.translation.x = 5
    assert actor.get_actor_transform().translation.x == 0
    actor.set_editor_property("tags", [unreal.Name("seen")])
    assert actor.actor_has_tag("SEEN") and str(actor.tags[0]) == "seen"


def test_array_is_no_list_and_name_no_str(unreal):
    found = unreal.EditorLevelLibrary.get_all_level_actors()
    assert not isinstance(found, list) and isinstance(found, unreal.Array)
    assert not isinstance(unreal.Name("a"), str) and unreal.Name("Abc") == "abc"
    with pytest.raises(TypeError):
        unreal.Array(unreal.Vector).append("x")


def test_color_is_b_g_r_a(unreal):
    colour = unreal.Color(1, 2, 3, 4)
    assert (colour.r, colour.g, colour.b, colour.a) == (3, 2, 1, 4)


def test_destroyed_actors_refuse_use(unreal, actor):
    component = actor.static_mesh_component
    assert unreal.EditorLevelLibrary.destroy_actor(actor)
    for use in (actor.get_actor_label, component.get_num_materials):
        with pytest.raises(Exception, match="ObjectInstance is null"):
            use()
    assert not unreal.SystemLibrary.is_valid(actor)


def test_missing_assets_are_none_with_a_warning(unreal, capsys):
    assert unreal.load_asset("/Game/Nothing/Here") is None
    assert unreal.load_class(None, "/Game/Nothing/BP.BP_C") is None
    assert unreal.EditorAssetLibrary.load_asset("/Game/X") is None
    assert capsys.readouterr().out.count("Warning: ") == 3


def test_classes_that_cannot_be_placed(unreal):
    assert unreal.EditorLevelLibrary.spawn_actor_from_class(unreal.StaticMeshComponent, unreal.Vector()) is None
    assert unreal.EditorLevelLibrary.spawn_actor_from_class(unreal.Light, unreal.Vector()) is None
    light = unreal.EditorLevelLibrary.spawn_actor_from_class(unreal.PointLight.static_class(), unreal.Vector())
    assert light.get_class() == unreal.PointLight.static_class()
    assert light.get_class().get_path_name() == "/Script/Engine.PointLight"


def test_only_public_names_are_visible(unreal):
    assert not {n for n in vars(unreal) if n in ("core", "world", "state", "structs")}
    assert str(unreal.LightUnits.CANDELAS) == "<LightUnits.CANDELAS: 1>"
