"""Rotations of directions, nearest points, lines and boxes."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from c4s.engine.headless.unreal.core import Object
from c4s.engine.headless.unreal.structs import Box, Color, LinearColor, Matrix, Plane, Quat, Rotator, Transform, Vector
from c4s.geometry.transform import look_at, quat_from_rotator

_SMALL = 1e-8


def find_look_at_rotation(start: Vector, target: Vector) -> Rotator:
    """Rotation that turns +X from ``start`` towards ``target``."""
    return Rotator._of(look_at(start._triple(), target._triple()))


def find_relative_look_at_rotation(start_transform: Transform, target_location: Vector) -> Rotator:
    """Rotation, seen from a transform, that turns +X towards a place."""
    return find_look_at_rotation(Vector(), start_transform.inverse_transform_location(target_location))


def make_rotation_from_axes(forward: Vector, right: Vector, up: Vector) -> Rotator:
    """Rotation of three directions."""
    return _of_axes(forward.normal(_SMALL), right.normal(_SMALL), up.normal(_SMALL))


def _of_axes(x: Vector, y: Vector, z: Vector) -> Rotator:
    return Matrix(Plane(*x._triple()), Plane(*y._triple()), Plane(*z._triple()), Plane(w=1.0)).get_rotator()


def _first_and_second(first: Vector, second: Vector) -> tuple[Vector, Vector, Vector]:
    """The first direction, the second made square to it, and their vector product."""
    one = first.normal(_SMALL)
    two = second.normal(_SMALL)
    if abs(one.dot(two)) > 1 - 1e-4:
        two = Vector(0, 0, 1) if abs(one.z) < 1 - 1e-4 else Vector(1, 0, 0)
    third = one.cross(two).normal(_SMALL)
    return one, third.cross(one), third


def make_rot_from_xy(x: Vector, y: Vector) -> Rotator:
    """Rotation whose +X is a direction and whose +Y comes near another."""
    one, two, three = _first_and_second(x, y)
    return _of_axes(one, two, three)


def make_rot_from_xz(x: Vector, z: Vector) -> Rotator:
    """Rotation whose +X is a direction and whose +Z comes near another."""
    one, two, three = _first_and_second(x, z)
    return _of_axes(one, -three, two)


def make_rot_from_yx(y: Vector, x: Vector) -> Rotator:
    """Rotation whose +Y is a direction and whose +X comes near another."""
    one, two, three = _first_and_second(y, x)
    return _of_axes(two, one, -three)


def make_rot_from_yz(y: Vector, z: Vector) -> Rotator:
    """Rotation whose +Y is a direction and whose +Z comes near another."""
    one, two, three = _first_and_second(y, z)
    return _of_axes(three, one, two)


def make_rot_from_zx(z: Vector, x: Vector) -> Rotator:
    """Rotation whose +Z is a direction and whose +X comes near another."""
    one, two, three = _first_and_second(z, x)
    return _of_axes(two, three, one)


def make_rot_from_zy(z: Vector, y: Vector) -> Rotator:
    """Rotation whose +Z is a direction and whose +Y comes near another."""
    one, two, three = _first_and_second(z, y)
    return _of_axes(-three, two, one)


def _upright(axis: Vector) -> Vector:
    return Vector(0, 0, 1) if abs(axis.normal(_SMALL).z) < 1 - 1e-4 else Vector(1, 0, 0)


def make_rot_from_y(y: Vector) -> Rotator:
    """Rotation whose +Y is a direction; +Z stays up where it can."""
    return make_rot_from_yz(y, _upright(y))


def make_rot_from_z(z: Vector) -> Rotator:
    """Rotation whose +Z is a direction."""
    return make_rot_from_zx(z, _upright(z))


def quat_make_from_euler(euler: Vector) -> Quat:
    """Rotation of roll, pitch, yaw in degrees."""
    return Quat(*quat_from_rotator((euler.y, euler.z, euler.x)))


def conv_matrix_to_rotator(matrix: Matrix) -> Rotator:
    """Rotation of a matrix."""
    return matrix.get_rotator()


def conv_matrix_to_transform(matrix: Matrix) -> Transform:
    """A matrix as a transform."""
    return matrix.transform()


def create_vector_from_yaw_pitch(yaw: float, pitch: float, length: float = 1.0) -> Vector:
    """Direction of a yaw and pitch in degrees, of a length."""
    return Rotator(pitch=pitch, yaw=yaw).get_forward_vector() * length  # type: ignore[no-any-return]


def r_interp_to(current: Rotator, target: Rotator, delta_time: float, interp_speed: float) -> Rotator:
    """A step towards a rotation that slows down as it comes near."""
    if delta_time == 0 or current.is_near_equal(target, 1e-4):
        return current
    return target if interp_speed <= 0 else _stepped(current, target, min(1.0, delta_time * interp_speed))


def r_interp_to_constant(current: Rotator, target: Rotator, delta_time: float, interp_speed: float) -> Rotator:
    """A step of constant speed (degrees per second and angle) towards a rotation."""
    if delta_time == 0 or current.is_near_equal(target, 1e-4):
        return current
    if interp_speed <= 0:
        return target
    step, away = interp_speed * delta_time, target.delta(current)
    return Rotator(
        *(_wrapped(now + max(-step, min(step, by))) for now, by in zip(current._all(), away._all(), strict=True))
    )


def _wrapped(angle: float) -> float:
    turned = math.fmod(angle, 360.0)
    return turned - 360 if turned > 180 else turned + 360 if turned <= -180 else turned


def _stepped(current: Rotator, target: Rotator, alpha: float) -> Rotator:
    away = target.delta(current)
    return Rotator(*(_wrapped(now + by * alpha) for now, by in zip(current._all(), away._all(), strict=True)))


# places


def get_direction_vector(from_: Vector, to: Vector) -> Vector:
    """From one place to another."""
    return to - from_  # type: ignore[no-any-return]


def get_vector_array_average(vectors: Sequence[Vector]) -> Vector:
    """Mean of places; zero for none."""
    found = list(vectors)
    return sum(found[1:], found[0]) / len(found) if found else Vector()


def find_closest_point_on_line(point: Vector, line_origin: Vector, line_direction: Vector) -> Vector:
    """Nearest point of an endless line."""
    return line_origin + (point - line_origin).project_on_to(line_direction)  # type: ignore[no-any-return]


def find_closest_point_on_segment(point: Vector, segment_start: Vector, segment_end: Vector) -> Vector:
    """Nearest point of a line between two places."""
    along = segment_end - segment_start
    squared = along.length_squared()
    alpha = max(0.0, min(1.0, (point - segment_start).dot(along) / squared)) if squared else 0.0
    return segment_start + along * alpha  # type: ignore[no-any-return]


def get_point_distance_to_line(point: Vector, line_origin: Vector, line_direction: Vector) -> float:
    """Distance from an endless line in cm."""
    return point.distance(find_closest_point_on_line(point, line_origin, line_direction))  # type: ignore[no-any-return]


def get_point_distance_to_segment(point: Vector, segment_start: Vector, segment_end: Vector) -> float:
    """Distance from a line between two places in cm."""
    return point.distance(find_closest_point_on_segment(point, segment_start, segment_end))  # type: ignore[no-any-return]


def line_plane_intersection_origin_normal(
    line_start: Vector, line_end: Vector, plane_origin: Vector, plane_normal: Vector
) -> tuple[float, Vector] | None:
    """Where a line between two places meets a plane: how far along, and the place; None when it does not."""
    along = line_end - line_start
    steepness = along.dot(plane_normal)
    if abs(steepness) < _SMALL:
        return None
    t = (plane_origin - line_start).dot(plane_normal) / steepness
    return (t, line_start + along * t) if 0 <= t <= 1 else None


def line_plane_intersection(line_start: Vector, line_end: Vector, a_plane: Plane) -> tuple[float, Vector] | None:
    """Where a line between two places meets a plane: how far along, and the place; None when it does not."""
    normal = Vector(*a_plane._triple())
    return line_plane_intersection_origin_normal(line_start, line_end, normal * a_plane.w, normal)


def make_plane_from_point_and_normal(point: Vector, normal: Vector) -> Plane:
    """The plane through a point."""
    unit = normal.normal(_SMALL)
    return Plane(*unit._triple(), point.dot(unit))


def points_are_coplanar(points: Sequence[Vector], tolerance: float = 0.1) -> bool:
    """Whether all points lie in one plane, within a distance in cm."""
    rows = np.array([p._triple() for p in points])
    if len(rows) < 4:
        return True
    return bool(np.abs((rows - rows.mean(0)) @ np.linalg.svd(rows - rows.mean(0))[2][2]).max() <= tolerance)


def get_slope_degree_angles(my_right_y_axis: Vector, floor_normal: Vector, up_vector: Vector) -> tuple[float, float]:
    """Pitch and roll in degrees of a floor as seen by one that stands on it."""
    ahead = my_right_y_axis.cross(floor_normal)
    along, across = ahead.dot(up_vector), my_right_y_axis.dot(up_vector)
    return 90 - math.degrees(math.acos(along)), 90 - math.degrees(math.acos(across))


# boxes


def make_box_with_origin(origin: Vector, extent: Vector) -> Box:
    """Box of a centre and half size."""
    return Box(origin - extent, origin + extent)


def get_box_center(box: Box) -> Vector:
    """Centre."""
    return (box.min + box.max) * 0.5  # type: ignore[no-any-return]


def get_box_size(box: Box) -> Vector:
    """Full size."""
    return box.max - box.min  # type: ignore[no-any-return]


def get_box_volume(box: Box) -> float:
    """Volume."""
    size = get_box_size(box)
    return size.x * size.y * size.z


def box_is_point_inside(box: Box, point: Vector) -> bool:
    """Whether a point lies truly inside."""
    return all(a < p < b for a, p, b in zip(box.min._triple(), point._triple(), box.max._triple(), strict=True))


def box_intersects(a: Box, b: Box) -> bool:
    """Whether two boxes touch."""
    return all(
        p <= s and r <= q
        for p, q, r, s in zip(a.min._triple(), a.max._triple(), b.min._triple(), b.max._triple(), strict=True)
    )


def box_is_inside(inner_test: Box, outer_test: Box) -> bool:
    """Whether a box lies truly inside another."""
    return box_is_point_inside(outer_test, inner_test.min) and box_is_point_inside(outer_test, inner_test.max)


def box_overlap(a: Box, b: Box) -> Box:
    """What two boxes share; an invalid box for nothing."""
    if not box_intersects(a, b):
        made = Box()
        made.set_editor_property("is_valid", False)
        return made
    return Box(a.min.get_max(b.min), a.max.get_min(b.max))


def box_expand_by(box: Box, negative: Vector, positive: Vector) -> Box:
    """A box grown by cm on each side."""
    return Box(box.min - negative, box.max + positive)


def box_get_closest_point_to(box: Box, point: Vector) -> Vector:
    """Nearest point of a box."""
    return point.bounded_to_box(box.min, box.max)


def is_point_in_box(point: Vector, box_origin: Vector, box_extent: Vector) -> bool:
    """Whether a point lies in the box of a centre and half size."""
    return box_is_point_inside(make_box_with_origin(box_origin, box_extent), point)


def is_point_in_box_with_transform(point: Vector, box_world_transform: Transform, box_extent: Vector) -> bool:
    """Whether a point lies in a box of a half size that was moved and turned."""
    return is_point_in_box(box_world_transform.inverse_transform_location(point), Vector(), box_extent)


def minimum_area_rectangle(
    world_context_object: Object | None,
    points: Sequence[Vector],
    sample_surface_normal: Vector,
    debug_draw: bool = False,
) -> tuple[Vector, Rotator, float, float]:
    """Centre, rotation and sides of the smallest rectangle around points on a surface."""
    frame = make_rot_from_z(sample_surface_normal)
    flat = np.array([p.unrotate(frame)._triple() for p in points])
    best: tuple[float, float, np.ndarray[tuple[int, ...], np.dtype[np.float64]], float, float] | None = None
    for i in range(len(flat)):
        for j in range(i + 1, len(flat)):
            angle = math.atan2(flat[j, 1] - flat[i, 1], flat[j, 0] - flat[i, 0])
            turn = np.array([[math.cos(angle), math.sin(angle)], [-math.sin(angle), math.cos(angle)]])
            turned = flat[:, :2] @ turn.T
            low, high = turned.min(0), turned.max(0)
            area = float(np.prod(high - low))
            if best is None or area < best[0] - 1e-9:
                best = (area, angle, (low + high) / 2 @ turn, float(high[0] - low[0]), float(high[1] - low[1]))
    if best is None:
        return Vector(), Rotator(), 0.0, 0.0
    middle = Vector(float(best[2][0]), float(best[2][1]), float(flat[:, 2].mean())).rotate(frame)
    quarter = Rotator(yaw=math.degrees(best[1])).combine(frame)
    return middle, quarter, best[3], best[4]


# colours


def hsv_to_rgb(h: float, s: float, v: float, a: float = 1.0) -> LinearColor:
    """The colour of a hue in degrees, a saturation and a value."""
    return LinearColor(h, s, v, a).hsv_to_rgb()


def break_color(color: LinearColor) -> tuple[float, float, float, float]:
    """Red, green, blue and alpha."""
    return color.r, color.g, color.b, color.a


def to_hex_linear_color(color: LinearColor) -> str:
    """Eight hex digits of the sRGB bytes: r, g, b, a."""
    found: Color = color.to_color()
    return f"{found.r:02X}{found.g:02X}{found.b:02X}{found.a:02X}"
