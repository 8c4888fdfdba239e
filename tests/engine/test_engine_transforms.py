"""Transforms of the `unreal` module against the numeric vectors of Unreal's conventions."""

from __future__ import annotations

import math
from pathlib import Path
from types import ModuleType

import pytest
from hypothesis import given
from hypothesis import strategies as st

from c4s.engine.headless.pose import Pose, compose, relative_to
from c4s.engine.headless.process.boot import boot

VECTORS = [
    ((0, 90, 0), (0, 0, 0.707107, 0.707107), (0, 1, 0)),
    ((90, 0, 0), (0, -0.707107, 0, 0.707107), (0, 0, 1)),
    ((0, 0, 90), (-0.707107, 0, 0, 0.707107), (1, 0, 0)),
    ((-45, 30, 0), (-0.099046, 0.369644, 0.239118, 0.892399), (0.612372, 0.353553, -0.707107)),
    ((10, 20, 30), (-0.239298, -0.127679, 0.144878, 0.951549), (0.925417, 0.336824, 0.173648)),
]

angle = st.floats(-180, 180, allow_nan=False)
length = st.floats(-5000, 5000, allow_nan=False)
factor = st.floats(0.1, 4).flatmap(lambda f: st.sampled_from([f, -f]))


@pytest.fixture
def unreal(tmp_path: Path) -> ModuleType:
    return boot([], tmp_path)


@pytest.mark.parametrize(("rotation", "quat", "forward"), VECTORS)
def test_rotator_is_roll_pitch_yaw_and_turns_as_unreal_does(unreal, rotation, quat, forward):
    pitch, yaw, roll = rotation
    rotator = unreal.Rotator(roll, pitch, yaw)
    made, axis = rotator.quaternion(), rotator.get_forward_vector()
    assert (made.x, made.y, made.z, made.w) == pytest.approx(quat, abs=1e-6)
    assert (axis.x, axis.y, axis.z) == pytest.approx(forward, abs=1e-6)


def test_positive_roll_takes_up_towards_y(unreal):
    up = unreal.Rotator(roll=90).get_up_vector()
    assert (up.x, up.y, up.z) == pytest.approx((0, 1, 0), abs=1e-12)


def test_multiplication_applies_the_left_transform_first(unreal):
    first = unreal.Transform(unreal.Vector(10, 0, 0), unreal.Rotator(), unreal.Vector(1, 1, 1))
    then = unreal.Transform(unreal.Vector(0, 0, 5), unreal.Rotator(yaw=90), unreal.Vector(2, 2, 2))
    both = first * then
    assert both.translation.is_near_equal(unreal.Vector(0, 20, 5), 1e-9)
    assert both.scale3d == unreal.Vector(2, 2, 2)


def test_a_turned_child_of_a_stretched_parent_has_no_shear():
    child = Pose.from_rotator((0, 0, 0), (0, 45, 0))
    world = compose(child, Pose.from_rotator((0, 0, 0), (0, 0, 0), (3, 1, 1)))
    assert world.scale == (3, 1, 1) and world.rotation_deg == pytest.approx((0, 45, 0))


@given(
    st.tuples(length, length, length),
    st.tuples(angle, angle, angle),
    st.tuples(length, length, length),
    st.tuples(angle, angle, angle),
    st.floats(0.1, 4),
    st.tuples(factor, factor, factor),
)
def test_relative_pose_composes_back(place, turn, base, base_turn, base_scale, scale):
    world = Pose.from_rotator(place, turn, scale)
    parent = Pose.from_rotator(base, base_turn, (base_scale,) * 3)
    back = compose(relative_to(world, parent), parent)
    assert back.location == pytest.approx(world.location, abs=1e-6)
    assert back.scale == pytest.approx(world.scale, rel=1e-9)
    assert abs(sum(a * b for a, b in zip(back.quat, world.quat, strict=True))) == pytest.approx(1, abs=1e-9)


def test_mirrored_scale_stays_a_mirror(unreal):
    actor = unreal.EditorLevelLibrary.spawn_actor_from_class(unreal.StaticMeshActor, unreal.Vector())
    actor.set_actor_scale3d(unreal.Vector(-1, 1, 1))
    actor.set_actor_rotation(unreal.Rotator(yaw=30), False)
    assert actor.get_actor_scale3d() == unreal.Vector(-1, 1, 1)
    assert actor.get_actor_rotation().yaw == 30


def test_bounds_are_the_turned_local_box(unreal):
    cube = unreal.load_asset("/Engine/BasicShapes/Cube")
    actor = unreal.EditorLevelLibrary.spawn_actor_from_object(cube, unreal.Vector(100, 0, 50), unreal.Rotator(yaw=45))
    origin, extent = actor.get_actor_bounds(False)
    assert origin == unreal.Vector(100, 0, 50)
    assert (extent.x, extent.y, extent.z) == pytest.approx((50 * math.sqrt(2), 50 * math.sqrt(2), 50))


def test_attached_actor_follows_and_keeps_its_place_when_the_parent_goes(unreal):
    spawn = unreal.EditorLevelLibrary.spawn_actor_from_class
    table = spawn(unreal.StaticMeshActor, unreal.Vector(100, 0, 0))
    cup = spawn(unreal.StaticMeshActor, unreal.Vector(110, 0, 70))
    keep = unreal.AttachmentRule.KEEP_WORLD
    assert cup.attach_to_actor(table, "None", keep, keep, keep)
    assert not table.attach_to_actor(cup, "None", keep, keep, keep)
    table.set_actor_location_and_rotation(unreal.Vector(), unreal.Rotator(yaw=90), False, False)
    assert cup.get_actor_location().is_near_equal(unreal.Vector(0, 10, 70), 1e-9)
    assert cup.get_attach_parent_actor() is table and list(table.get_attached_actors()) == [cup]
    table.destroy_actor()
    assert cup.get_attach_parent_actor() is None
    assert cup.get_actor_location().is_near_equal(unreal.Vector(0, 10, 70), 1e-9)


def test_snapping_takes_the_parents_pose(unreal):
    spawn = unreal.EditorLevelLibrary.spawn_actor_from_class
    base = spawn(unreal.StaticMeshActor, unreal.Vector(1, 2, 3), unreal.Rotator(yaw=40))
    other = spawn(unreal.StaticMeshActor, unreal.Vector(500, 0, 0))
    snap = unreal.AttachmentRule.SNAP_TO_TARGET
    other.attach_to_actor(base, "", snap, snap, snap, False)
    assert other.get_actor_location() == unreal.Vector(1, 2, 3) and other.get_actor_rotation().yaw == pytest.approx(40)


def test_not_finite_is_refused(unreal):
    actor = unreal.EditorLevelLibrary.spawn_actor_from_class(unreal.StaticMeshActor, unreal.Vector(1, 2, 3))
    with pytest.raises(Exception, match="finite"):
        actor.set_actor_location(unreal.Vector(math.nan, 0, 0), False, False)
    assert actor.get_actor_location() == unreal.Vector(1, 2, 3)
