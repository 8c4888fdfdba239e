"""Numbers of Unreal's mathematics: vectors worked out by hand or by matrices, apart from the engine's own formulas."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from c4s.engine.headless.process.boot import boot
from c4s.engine.headless.unreal import build

u = build()
M = u.MathLibrary
S = math.sqrt(0.5)
angles = st.floats(-179, 179).map(lambda a: round(a, 3))


def close(value, *numbers, within=1e-6):
    got = value.to_tuple() if hasattr(value, "to_tuple") else (value,)
    return all(abs(a - b) <= within for a, b in zip(got, numbers, strict=True))


def matrix(roll, pitch, yaw):
    """Rotation that acts on columns: roll about X, then pitch about Y, then yaw about Z, in Unreal's senses."""
    r, p, w = map(math.radians, (roll, pitch, yaw))
    about_x = np.array([[1, 0, 0], [0, math.cos(r), math.sin(r)], [0, -math.sin(r), math.cos(r)]])
    about_y = np.array([[math.cos(p), 0, -math.sin(p)], [0, 1, 0], [math.sin(p), 0, math.cos(p)]])
    about_z = np.array([[math.cos(w), -math.sin(w), 0], [math.sin(w), math.cos(w), 0], [0, 0, 1]])
    return about_z @ about_y @ about_x


@given(angles, angles, angles)
def test_rotations_turn_as_three_plain_turns_do(roll, pitch, yaw):
    rotator = u.Rotator(roll, pitch, yaw)
    turned = matrix(roll, pitch, yaw)
    for axis, image in zip(np.eye(3), turned.T, strict=True):
        assert close(u.Vector(*map(float, axis)).rotate(rotator), *image, within=1e-9)
    rows = u.Transform(rotation=rotator).to_matrix()
    assert close(rows.x_plane, *turned[:, 0], 0, within=1e-9)
    back = rows.get_rotator()
    assert np.allclose(matrix(back.roll, back.pitch, back.yaw), turned, atol=1e-6)
    quat = rotator.quaternion()
    assert quat == rows.to_quat()
    assert close(quat.unrotate_vector(quat.rotate_vector(u.Vector(1, 2, 3))), 1, 2, 3, within=1e-9)


@pytest.mark.parametrize(
    ("got", "wanted"),
    [
        (lambda: M.find_look_at_rotation(u.Vector(0, 0, 0), u.Vector(0, 5, 5)), (0, 45, 90)),
        (lambda: M.find_look_at_rotation(u.Vector(0, 0, 100), u.Vector(100, 0, 0)), (0, -45, 0)),
        (lambda: M.rotator_from_axis_and_angle(u.Vector(0, 1, 0), 90), (0, -90, 0)),
        (lambda: M.rotator_from_axis_and_angle(u.Vector(0, 0, 3), 30), (0, 0, 30)),
        (lambda: M.rotate_angle_axis(u.Vector(1, 0, 0), 90, u.Vector(0, 0, 1)), (0, 1, 0)),
        (lambda: M.rotate_angle_axis(u.Vector(0, 1, 0), 90, u.Vector(2, 0, 0)), (0, 0, 1)),
        (lambda: M.make_rot_from_x(u.Vector(0, -1, 0)), (0, 0, -90)),
        (lambda: M.make_rot_from_z(u.Vector(0, 0, 1)), (0, 0, 0)),
        (lambda: M.make_rot_from_xz(u.Vector(0, 1, 0), u.Vector(0, 0, 1)), (0, 0, 90)),
        (lambda: M.make_rot_from_zx(u.Vector(0, 1, 0), u.Vector(1, 0, 0)), (90, 0, 0)),
        (lambda: M.make_rotation_from_axes(u.Vector(0, 1, 0), u.Vector(-1, 0, 0), u.Vector(0, 0, 1)), (0, 0, 90)),
        (lambda: M.compose_rotators(u.Rotator(yaw=90), u.Rotator(yaw=45)), (0, 0, 135)),
        (lambda: u.Rotator(yaw=170).delta(u.Rotator(yaw=-170)), (0, 0, -20)),
        (lambda: u.Rotator(yaw=170).lerp(u.Rotator(yaw=-170), 0.5, True), (0, 0, 180)),
        (lambda: u.Rotator(yaw=170).lerp(u.Rotator(yaw=-170), 0.5, False), (0, 0, 0)),
        (lambda: M.r_interp_to(u.Rotator(), u.Rotator(yaw=90), 0.1, 5), (0, 0, 45)),
        (lambda: M.r_interp_to_constant(u.Rotator(), u.Rotator(yaw=90), 0.5, 20), (0, 0, 10)),
        (lambda: u.Vector(3, 4, 0).normal(), (0.6, 0.8, 0)),
        (lambda: u.Vector(0.005, 0, 0).normal(), (0, 0, 0)),
        (lambda: u.Vector(1, 2, 3) ^ u.Vector(4, 5, 6), (-3, 6, -3)),
        (lambda: u.Vector(1, 2, 3) * u.Vector(2, 2, 2) - u.Vector(1, 1, 1), (1, 3, 5)),
        (lambda: u.Vector(149, 251, -49).snapped_to_grid(100), (100, 300, 0)),
        (lambda: u.Vector(3, 4, 5).clamped_size_max2d(2.5), (1.5, 2, 5)),
        (lambda: u.Vector(3, 4, 0).project_on_to(u.Vector(10, 0, 0)), (3, 0, 0)),
        (lambda: u.Vector(1, 0, -1).mirror_by_vector(u.Vector(0, 0, 5)), (1, 0, 1)),
        (lambda: u.Vector(1, 2, 9).project_point_on_to_plane(u.Vector(0, 0, 4), u.Vector(0, 0, 1)), (1, 2, 4)),
        (lambda: u.Vector(1, 0, 0).slerp_normals(u.Vector(0, 1, 0), 0.5), (S, S, 0)),
        (lambda: u.Vector(1, 0, 0).find_quat_between_vectors(u.Vector(0, 1, 0)), (0, 0, S, S)),
        (lambda: u.Vector(0, 0, 0).interp_to(u.Vector(10, 0, 0), 0.1, 5), (5, 0, 0)),
        (lambda: u.Vector(0, 0, 0).interp_to_constant(u.Vector(10, 0, 0), 0.1, 5), (0.5, 0, 0)),
        (lambda: M.find_closest_point_on_segment(u.Vector(5, 9, 0), u.Vector(), u.Vector(4, 0, 0)), (4, 0, 0)),
        (lambda: u.LinearColor(0.5, 1, 0.5, 1).rgb_to_hsv(), (120, 0.5, 1, 1)),
        (lambda: u.LinearColor(240, 1, 0.5, 1).hsv_to_rgb(), (0, 0, 0.5, 1)),
        (lambda: u.LinearColor(1, 0.5, 0.25, 1).to_color(), (137, 188, 255, 255)),
        (lambda: M.conv_color_to_linear_color(u.Color(0, 188, 255, 255)), (1, 0.5028865, 0, 1)),
        (lambda: u.Vector2D(1, 0).get_rotated(90), (0, 1)),
    ],
)
def test_worked_out_by_hand(got, wanted):
    assert close(got(), *wanted, within=1e-5)


@pytest.mark.parametrize(
    ("got", "wanted"),
    [
        (lambda: u.Vector(1, 2, 3) | u.Vector(4, 5, 6), 32),
        (lambda: M.map_range_clamped(15, 0, 10, 0, 100), 100),
        (lambda: M.map_range_unclamped(15, 0, 10, 0, 100), 150),
        (lambda: M.round(-0.5), 0),
        (lambda: M.round(2.5), 3),
        (lambda: M.grid_snap_float(26, 10), 30),
        (lambda: M.normalize_axis(270), -90),
        (lambda: M.clamp_axis(-90), 270),
        (lambda: M.clamp_angle(100, -45, 45), 45),
        (lambda: M.fixed_turn(350, 20, 10), 0),
        (lambda: M.f_mod(-7, 3), (-2, -1)),
        (lambda: M.percent_int_int(-7, 3), -1),
        (lambda: M.f_wrap(370, 0, 360), 10),
        (lambda: M.deg_atan2(1, 1), 45),
        (lambda: M.get_point_distance_to_line(u.Vector(0, 3, 4), u.Vector(), u.Vector(1, 0, 0)), 5),
        (lambda: u.Rotator(yaw=90).quaternion().get_angle(), math.pi / 2),
        (lambda: M.safe_divide(1, 0), 0),
        (lambda: M.divide_float_float(-1, 0), -math.inf),
        (lambda: M.to_hex_linear_color(u.LinearColor(1, 0, 0, 1)), "FF0000FF"),
    ],
)
def test_numbers_worked_out_by_hand(got, wanted):
    assert got() == pytest.approx(wanted) if not isinstance(wanted, str) else got() == wanted


def test_a_stream_repeats_the_published_generator():
    """The recurrence seed * 196314165 + 907633515 (mod 2^32), its upper 23 bits as a fraction."""
    stream = u.RandomStream(42)
    seed, wanted = 42, []
    for _ in range(4):
        seed = (seed * 196314165 + 907633515) % 2**32
        wanted.append((seed >> 9) / 2**23)
    assert [stream.random_float() for _ in range(4)] == wanted
    stream.reset()
    assert M.random_float_from_stream(stream) == wanted[0]
    assert all(3 <= stream.random_int_in_range(3, 5) <= 5 for _ in range(50))


def test_what_rotators_and_quaternions_do_not_do():
    for wrong in (
        lambda: u.Rotator() + u.Rotator(),
        lambda: u.Rotator() * 2.0,
        lambda: u.Vector() + 1.0,
        lambda: 2 * u.Vector(),
        lambda: u.Quat() * 2.0,
        lambda: u.Vector() * "2",
        lambda: list(u.Vector(1, 2, 3)),
        lambda: u.Transform() + u.Transform(),
    ):
        with pytest.raises(TypeError):
            wrong()
    assert -u.Rotator(yaw=30) == u.Rotator(yaw=-30) and u.Rotator(yaw=370) == u.Rotator(yaw=10)
    assert u.Vector(0, 0, 1e-9) != u.Vector() and u.Vector(0, 0, 1e-9).is_near_equal(u.Vector())


def test_operators_in_place_change_the_struct_itself():
    place = u.Vector(1, 2, 3)
    same = place
    place += u.Vector(1, 1, 1)
    place *= 2.0
    assert same is place and same == u.Vector(4, 6, 8)
    same.normalize()
    assert abs(place.length() - 1) < 1e-12
    zero = u.Vector()
    zero.normalize()
    assert zero == u.Vector() and u.Vector(1, 0, 0) / 0.0 != u.Vector()


def test_structs_take_sequences_and_mappings_as_unreal_does(tmp_path: Path):
    unreal = boot([], tmp_path)
    actor = unreal.EditorLevelLibrary.spawn_actor_from_class(unreal.StaticMeshActor, (1, 2, 3), [0, 0, 90])
    assert actor.get_actor_location() == unreal.Vector(1, 2, 3)
    assert actor.get_actor_rotation() == unreal.Rotator(yaw=90)
    actor.set_actor_location([4, 5], False, False)
    assert actor.get_actor_location() == unreal.Vector(4, 5, 0)
    actor.set_actor_scale3d({"x": 2, "y": 3, "z": 4})
    assert actor.get_actor_scale3d() == unreal.Vector(2, 3, 4)
    assert unreal.Vector.cast((1, 2, 3)) == unreal.Vector(1, 2, 3)
    with pytest.raises(TypeError, match="Struct has 3 initialization parameters, but the given sequence had 4"):
        unreal.Vector.cast((1, 2, 3, 4))


def test_structs_as_text():
    made = u.Vector()
    assert made.import_text("(X=1.5,Y=-2,Z=3)") and made == u.Vector(1.5, -2, 3)
    assert not made.import_text("X=1") and not made.import_text("(W=1)") and made == u.Vector(1.5, -2, 3)
    box = u.Box()
    assert box.import_text(u.Box(u.Vector(1, 2, 3), u.Vector(4, 5, 6)).export_text()) and box.max == u.Vector(4, 5, 6)


def test_a_matrix_is_a_transform_and_back():
    transform = u.Transform(u.Vector(10, 20, 30), u.Rotator(10, 20, 30), u.Vector(-2, 3, 4))
    rows = transform.to_matrix()
    assert close(
        rows.transform_position(u.Vector(1, 1, 1)).vector(), *transform.transform_location(u.Vector(1, 1, 1)).to_tuple()
    )
    assert rows.get_determinant() == pytest.approx(-24) and close(rows.get_scale_vector(), 2, 3, 4)
    assert rows.transform() == transform
    assert (rows * rows.get_inverse()) == u.Matrix.IDENTITY
    assert close(
        rows.inverse_transform_position(u.Vector(1, 2, 3)),
        *transform.inverse_transform_location(u.Vector(1, 2, 3)).to_tuple(),
    )
    assert transform.lerp(u.Transform(), 1.0) == u.Transform()


def test_containers_are_typed():
    found = u.Map(str, int)
    found["a"] = 1
    found.update({"b": 2})
    assert dict(found) == {"a": 1, "b": 2} and found.get("c", 7) == 7 and found.pop("a") == 1
    names = u.Set(u.Name)
    names.update(["Tree", "tree", "Rock"])
    assert len(names) == 2 and "ROCK" in names
    assert len(names.difference(["rock"])) == 1 and names.issuperset(["TREE"])
    rows = u.Array.cast(u.Vector, [(1, 2, 3), u.Vector(4, 5, 6)])
    rows.resize(3)
    assert rows[0] == u.Vector(1, 2, 3) and rows[2] == u.Vector()
    fixed = u.FixedArray(int, 2)
    fixed[1] = 5
    assert list(fixed) == [0, 5]
    for wrong in (lambda: found.update({"c": "x"}), lambda: rows.append(3), lambda: fixed.__setitem__(0, "x")):
        with pytest.raises(TypeError):
            wrong()
    assert str(u.Text("{0} of {total}").format(2, total=5)) == "2 of 5"
    assert u.LightUnits.cast(1) is u.LightUnits.CANDELAS and str(u.LightUnits.LUMENS.get_display_name()) == "Lumens"
