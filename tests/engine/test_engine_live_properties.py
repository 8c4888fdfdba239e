"""What an editor property gives is the owner's own value: writing into it edits the owner, and copies edit nothing."""

from __future__ import annotations

import copy
import pickle
from types import ModuleType

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from c4s.engine.headless.editor import world
from c4s.engine.headless.process.boot import boot


@pytest.fixture(scope="module")
def unreal(tmp_path_factory: pytest.TempPathFactory) -> ModuleType:
    return boot([], tmp_path_factory.mktemp("live"))


@pytest.fixture
def cube(unreal):
    world().new_map()
    actors = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)
    return actors.spawn_actor_from_object(unreal.load_asset("/Engine/BasicShapes/Cube"), unreal.Vector())


@pytest.fixture
def volume(unreal):
    world().new_map()
    return unreal.get_editor_subsystem(unreal.EditorActorSubsystem).spawn_actor_from_class(
        unreal.PostProcessVolume, unreal.Vector()
    )


def save(unreal, package: str) -> bool:
    return bool(
        unreal.EditorLoadingAndSavingUtils.save_map(
            unreal.get_editor_subsystem(unreal.UnrealEditorSubsystem).get_editor_world(), package
        )
    )


def reopened(unreal, package: str):
    assert save(unreal, package)
    assert unreal.EditorLoadingAndSavingUtils.load_map(package)
    return unreal.get_editor_subsystem(unreal.EditorActorSubsystem).get_all_level_actors()[0]


def traced(unreal, z: float) -> str | None:
    """Label of what a ray downwards from beside a height meets within a metre."""
    hit = unreal.SystemLibrary.line_trace_single(
        unreal.get_editor_subsystem(unreal.UnrealEditorSubsystem).get_editor_world(),
        unreal.Vector(0, 0, z + 90),
        unreal.Vector(0, 0, z - 10),
        unreal.TraceTypeQuery.TRACE_TYPE_QUERY1,
        False,
        [],
        unreal.DrawDebugTrace.NONE,
    )
    return None if hit is None else str(hit.to_tuple()[9].get_actor_label())


def test_a_field_written_through_a_property_moves_the_actor_for_bounds_traces_and_files(unreal, cube):
    component = cube.static_mesh_component
    assert traced(unreal, 1000) is None and save(unreal, "/Game/Live/Clean") and not world().dirty
    component.relative_location.z = 1000
    assert world().dirty
    assert cube.get_actor_location() == unreal.Vector(0, 0, 1000)
    assert cube.get_actor_bounds(False)[0] == unreal.Vector(0, 0, 1000)
    assert traced(unreal, 1000) == cube.get_actor_label()
    component.relative_scale3d *= 2.0
    component.get_editor_property("relative_rotation").yaw = 30
    assert reopened(unreal, "/Game/Live/Moved").get_actor_transform() == unreal.Transform(
        [0, 0, 1000], [0, 0, 30], [2, 2, 2]
    )


def test_children_follow_a_field(unreal, cube):
    actors = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)
    child = actors.spawn_actor_from_object(unreal.load_asset("/Engine/BasicShapes/Cone"), unreal.Vector(0, 0, 10))
    keep = unreal.AttachmentRule.KEEP_WORLD
    child.attach_to_actor(cube, "None", keep, keep, keep)
    cube.root_component.relative_location.x = 50
    assert child.get_actor_location() == unreal.Vector(50, 0, 10)
    own = child.root_component.relative_location
    child.set_actor_location(unreal.Vector(150, 0, 0), False, False)
    assert own == unreal.Vector(100, 0, 0)


def test_angles_are_kept_as_they_were_written_until_something_else_turns_it(unreal, cube):
    held = cube.root_component.relative_rotation
    cube.root_component.relative_rotation.pitch = 95
    cube.root_component.relative_rotation.yaw = 10
    assert (held.pitch, held.yaw) == (95, 10)
    assert cube.get_actor_rotation() == unreal.Rotator(pitch=95, yaw=10).quaternion().rotator()
    cube.set_actor_rotation(unreal.Rotator(yaw=20), False)
    assert (held.pitch, held.yaw) == (0, pytest.approx(20))


@pytest.mark.parametrize(
    ("edit", "left"),
    [
        (lambda tags: tags.append("x"), ["a", "b", "x"]),
        (lambda tags: tags.extend(["x", "y"]), ["a", "b", "x", "y"]),
        (lambda tags: tags.insert(0, "x"), ["x", "a", "b"]),
        (lambda tags: tags.remove("a"), ["b"]),
        (lambda tags: tags.pop(), ["a"]),
        (lambda tags: tags.clear(), []),
        (lambda tags: tags.reverse(), ["b", "a"]),
        (lambda tags: tags.sort(reverse=True), ["b", "a"]),
        (lambda tags: tags.resize(1), ["a"]),
        (lambda tags: tags.__setitem__(0, "x"), ["x", "b"]),
        (lambda tags: tags.__delitem__(0), ["b"]),
    ],
)
def test_every_edit_of_an_array_edits_its_owner(unreal, cube, edit, left):
    cube.tags = ["a", "b"]
    assert save(unreal, "/Game/Live/Tags")
    edit(cube.tags)
    assert [str(tag) for tag in cube.get_editor_property("tags")] == left and world().dirty
    assert [str(tag) for tag in reopened(unreal, "/Game/Live/Tags").tags] == left


def test_what_was_read_follows_a_property_that_is_replaced(unreal, cube, volume):
    settings_, gain = volume.settings, volume.settings.color_gain
    volume.settings = unreal.PostProcessSettings(bloom_intensity=4, color_gain=[1, 2, 3, 4])
    assert settings_.bloom_intensity == 4 and gain == unreal.Vector4(1, 2, 3, 4)
    settings_.color_gain = unreal.Vector4(5, 5, 5, 5)
    assert gain.x == 5 and volume.settings.color_gain.x == 5
    gain.y = 6
    assert volume.settings.color_gain == unreal.Vector4(5, 6, 5, 5)
    assert volume.settings is settings_


def test_nested_fields_are_saved(unreal, volume):
    volume.settings.override_color_gain = True
    volume.settings.get_editor_property("color_gain").set_editor_property("z", 0.25)
    assert reopened(unreal, "/Game/Live/Nested").settings.color_gain.z == 0.25


def test_what_is_given_to_a_property_stays_the_givers(unreal, cube, volume):
    mine = unreal.PostProcessSettings(bloom_intensity=4)
    volume.settings = mine
    mine.bloom_intensity = 9
    assert volume.settings.bloom_intensity == 4
    there = unreal.Vector(1, 2, 3)
    volume.root_component.relative_location = there
    there.x = 9
    assert volume.get_actor_location() == unreal.Vector(1, 2, 3)
    volume.root_component.relative_location.y = 7
    assert there == unreal.Vector(9, 2, 3)


def copies(value):
    yield value.copy()
    yield copy.copy(value)
    yield copy.deepcopy(value)
    yield pickle.loads(pickle.dumps(value))


def test_copies_belong_to_nobody(unreal, cube, volume, monkeypatch):
    monkeypatch.setitem(__import__("sys").modules, "unreal", unreal)
    for own in copies(volume.root_component.relative_location):
        own.x = 500
    for own in copies(volume.settings):
        own.bloom_intensity = 500
        own.color_gain.x = 500
    volume.tags = ["a"]
    for own in copies(volume.tags):
        own.append("b")
        assert len(own) == 2
    assert volume.get_actor_location().x == 0 and len(volume.tags) == 1
    assert volume.settings.bloom_intensity == 0.675 and volume.settings.color_gain.x == 1


def test_what_a_property_refuses_its_fields_refuse(unreal, cube, volume):
    held = volume.root_component.relative_location
    volume.settings.bloom_intensity = 2
    for write in (
        lambda: setattr(held, "x", float("nan")),
        lambda: held.assign(unreal.Vector(float("inf"), 0, 0)),
        lambda: held.set(1e400, 0, 0),
        lambda: setattr(volume.settings, "bloom_intensity", float("nan")),
        lambda: setattr(volume.settings, "color_gain", unreal.Vector4(float("nan"), 0, 0, 0)),
        lambda: setattr(volume.settings.color_gain, "x", float("inf")),
    ):
        with pytest.raises(Exception, match="finite"):
            write()
    for write in (lambda: setattr(held, "x", "far"), lambda: volume.tags.append(7)):
        with pytest.raises(TypeError):
            write()
    assert held == unreal.Vector() and volume.get_actor_location() == unreal.Vector()
    assert volume.settings.bloom_intensity == 2 and volume.settings.color_gain == unreal.Vector4(1, 1, 1, 1)
    assert len(volume.tags) == 0


def test_what_was_read_of_a_destroyed_actor_can_be_read_and_not_written(unreal, volume):
    held, tags, gain = volume.root_component.relative_location, volume.tags, volume.settings.color_gain
    held.x = 3
    unreal.get_editor_subsystem(unreal.EditorActorSubsystem).destroy_actor(volume)
    for write in (
        lambda: setattr(held, "x", 4),
        lambda: tags.append("b"),
        lambda: setattr(gain, "x", 4),
        lambda: held.assign(unreal.Vector()),
    ):
        with pytest.raises(Exception, match="ObjectInstance is null"):
            write()
    assert held.x == 3 and len(tags) == 0 and gain.x == 1
    assert held.copy() + unreal.Vector(1, 0, 0) == unreal.Vector(4, 0, 0)


FINITE = st.floats(-1e6, 1e6)


@settings(max_examples=40, deadline=None)
@given(start=st.tuples(FINITE, FINITE, FINITE), field=st.sampled_from("xyz"), value=FINITE)
def test_writing_a_field_is_setting_the_property(unreal, start, field, value):
    world().new_map()
    actors = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)
    one, two = (actors.spawn_actor_from_class(unreal.StaticMeshActor, unreal.Vector(*start)) for _ in range(2))
    setattr(one.root_component.relative_location, field, value)
    whole = two.root_component.relative_location.copy()
    setattr(whole, field, value)
    two.root_component.relative_location = whole
    assert one.get_actor_location().to_tuple() == two.get_actor_location().to_tuple()
