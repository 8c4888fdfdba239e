"""Functions that are a struct's method under another name: the table says which, and how its parameters are called."""

from __future__ import annotations

import inspect
from collections.abc import Callable
from typing import Any

from c4s.engine.headless.unreal.structs import Color, IntPoint, LinearColor, Quat, Rotator, Transform, Vector, Vector2D

_V, _R, _Q, _T, _C, _2 = Vector, Rotator, Quat, Transform, LinearColor, Vector2D

PLAIN: dict[str, tuple[type, str, str]] = {
    # vectors
    "add_vector_vector": (_V, "add", "a b"),
    "add_vector_float": (_V, "add_float", "a b"),
    "add_vector_int": (_V, "add_int", "a b"),
    "subtract_vector_vector": (_V, "subtract", "a b"),
    "subtract_vector_float": (_V, "subtract_float", "a b"),
    "subtract_vector_int": (_V, "subtract_int", "a b"),
    "multiply_vector_vector": (_V, "multiply", "a b"),
    "multiply_vector_float": (_V, "multiply_float", "a b"),
    "multiply_vector_int": (_V, "multiply_int", "a b"),
    "divide_vector_vector": (_V, "divide", "a b"),
    "divide_vector_float": (_V, "divide_float", "a b"),
    "divide_vector_int": (_V, "divide_int", "a b"),
    "dot_vector_vector": (_V, "dot", "a b"),
    "cross_vector_vector": (_V, "cross", "a b"),
    "negate_vector": (_V, "negated", "a"),
    "normal": (_V, "normal", "a tolerance"),
    "v_size": (_V, "length", "a"),
    "v_size_squared": (_V, "length_squared", "a"),
    "v_size_xy": (_V, "length2d", "a"),
    "v_size_xy_squared": (_V, "length2d_squared", "a"),
    "v_lerp": (_V, "lerp_to", "a b alpha"),
    "v_interp_to": (_V, "interp_to", "current target delta_time interp_speed"),
    "v_interp_to_constant": (_V, "interp_to_constant", "current target delta_time interp_speed"),
    "vector_distance": (_V, "distance", "v1 v2"),
    "vector_distance_squared": (_V, "distance_squared", "v1 v2"),
    "vector_distance2d": (_V, "distance2d", "v1 v2"),
    "vector_distance2d_squared": (_V, "distance2d_squared", "v1 v2"),
    "vector_normal2d": (_V, "normal2d", "a tolerance"),
    "vector_normal_unsafe": (_V, "normal_unsafe", "a"),
    "vector_is_zero": (_V, "is_zero", "a"),
    "vector_is_nearly_zero": (_V, "is_nearly_zero", "a tolerance"),
    "vector_is_unit": (_V, "is_unit", "a squared_lenth_tolerance"),
    "vector_is_normal": (_V, "is_normal", "a"),
    "vector_is_uniform": (_V, "is_uniform", "a tolerance"),
    "vector_is_nan": (_V, "is_nan", "a"),
    "vector_get_abs": (_V, "get_abs", "a"),
    "vector_get_abs_max": (_V, "get_abs_max", "a"),
    "vector_get_abs_min": (_V, "get_abs_min", "a"),
    "get_max_element": (_V, "get_max_element", "a"),
    "get_min_element": (_V, "get_min_element", "a"),
    "vector_component_max": (_V, "get_max", "a b"),
    "vector_component_min": (_V, "get_min", "a b"),
    "vector_get_sign_vector": (_V, "get_sign_vector", "a"),
    "vector_get_projection": (_V, "get_projection", "a"),
    "vector_reciprocal": (_V, "reciprocal", "a"),
    "vector_heading_angle": (_V, "heading_angle", "a"),
    "vector_cosine_angle2d": (_V, "cosine_angle2d", "a b"),
    "vector_to_degrees": (_V, "to_degrees", "a"),
    "vector_to_radians": (_V, "to_radians", "a"),
    "vector_unit_cartesian_to_spherical": (_V, "unit_cartesian_to_spherical", "a"),
    "vector_snapped_to_grid": (_V, "snapped_to_grid", "vect grid_size"),
    "vector_bounded_to_box": (_V, "bounded_to_box", "vect box_min box_max"),
    "vector_bounded_to_cube": (_V, "bounded_to_cube", "vect radius"),
    "clamp_vector_size": (_V, "clamped_size", "a min max"),
    "vector_clamp_size_max": (_V, "clamped_size_max", "a max"),
    "vector_clamp_size2d": (_V, "clamped_size2d", "a min max"),
    "vector_clamp_size_max2d": (_V, "clamped_size_max2d", "a max"),
    "project_vector_on_to_vector": (_V, "project_on_to", "v target"),
    "project_vector_on_to_plane": (_V, "project_on_to_plane", "v plane_normal"),
    "project_point_on_to_plane": (_V, "project_point_on_to_plane", "point plane_base plane_normal"),
    "vector_project_on_to_normal": (_V, "project_on_to_normal", "v normal"),
    "mirror_vector_by_normal": (_V, "mirror_by_vector", "vect normal"),
    "get_reflection_vector": (_V, "mirror_by_vector", "direction surface_normal"),
    "vector_mirror_by_plane": (_V, "mirror_by_plane", "a plane"),
    "vector_slerp_normals": (_V, "slerp_normals", "normal_a normal_b alpha"),
    "vector_slerp_vector_to_direction": (_V, "slerp_vectors", "vector direction alpha"),
    "rotate_angle_axis": (_V, "rotate_angle_axis", "vect angle_deg axis"),
    "rotator_from_axis_and_angle": (_V, "rotator_from_axis_and_angle", "axis angle"),
    "greater_greater_vector_rotator": (_V, "rotate", "a b"),
    "less_less_vector_rotator": (_V, "unrotate", "a b"),
    "equal_equal_vector_vector": (_V, "is_near_equal", "a b error_tolerance"),
    "not_equal_vector_vector": (_V, "is_not_near_equal", "a b error_tolerance"),
    "equal_exactly_vector_vector": (_V, "equals", "a b"),
    "not_equal_exactly_vector_vector": (_V, "not_equal", "a b"),
    "get_direction_unit_vector": (_V, "direction_unit_to", "from_ to"),
    "make_rot_from_x": (_V, "rotator", "x"),
    "f_trunc_vector": (_V, "truncated", "vector"),
    "conv_vector_to_rotator": (_V, "rotator", "vec"),
    "conv_vector_to_quaternion": (_V, "quaternion", "vec"),
    "conv_vector_to_transform": (_V, "transform", "location"),
    "conv_vector_to_vector2d": (_V, "vector2d", "vector"),
    "conv_vector_to_linear_color": (_V, "linear_color", "vec"),
    "quat_find_between_vectors": (_V, "find_quat_between_vectors", "start end"),
    "quat_find_between_normals": (_V, "find_quat_between_normals", "start_normal end_normal"),
    # rows of two
    "add_vector2d_vector2d": (_2, "add", "a b"),
    "add_vector2d_float": (_2, "add_float", "a b"),
    "subtract_vector2d_vector2d": (_2, "subtract", "a b"),
    "subtract_vector2d_float": (_2, "subtract_float", "a b"),
    "multiply_vector2d_vector2d": (_2, "multiply", "a b"),
    "multiply_vector2d_float": (_2, "multiply_float", "a b"),
    "divide_vector2d_vector2d": (_2, "divide", "a b"),
    "divide_vector2d_float": (_2, "divide_float", "a b"),
    "dot_product2d": (_2, "dot", "a b"),
    "cross_product2d": (_2, "cross", "a b"),
    "v_size2d": (_2, "length", "a"),
    "v_size2d_squared": (_2, "length_squared", "a"),
    "distance2d": (_2, "distance", "v1 v2"),
    "distance_squared2d": (_2, "distance_squared", "v1 v2"),
    "normal2d": (_2, "normal_unsafe", "a"),
    "normal_safe2d": (_2, "normal", "a tolerance"),
    "get_rotated2d": (_2, "get_rotated", "a angle_deg"),
    "get_abs2d": (_2, "get_abs", "a"),
    "get_abs_max2d": (_2, "get_abs_max", "a"),
    "get_max2d": (_2, "get_max", "a"),
    "get_min2d": (_2, "get_min", "a"),
    "negated2d": (_2, "negated", "a"),
    "is_zero2d": (_2, "is_zero", "a"),
    "is_nearly_zero2d": (_2, "is_nearly_zero", "a tolerance"),
    "to_sign2d": (_2, "to_sign", "a"),
    "to_rounded2d": (_2, "to_rounded", "a"),
    "to_direction_and_length2d": (_2, "to_direction_and_length", "a"),
    "clamp_axes2d": (_2, "clamped_axes", "a min_axis_val max_axis_val"),
    "spherical2d_to_unit_cartesian": (_2, "spherical_to_unit_cartesian", "a"),
    "vector2d_interp_to": (_2, "interp_to", "current target delta_time interp_speed"),
    "vector2d_interp_to_constant": (_2, "interp_to_constant", "current target delta_time interp_speed"),
    "equal_equal_vector2d_vector2d": (_2, "is_near_equal", "a b error_tolerance"),
    "conv_vector2d_to_vector": (_2, "vector", "vector2d z"),
    "conv_vector2d_to_int_point": (_2, "int_point", "vector2d"),
    "conv_int_point_to_vector2d": (IntPoint, "vector2d", "int_point"),
    # rotations
    "get_forward_vector": (_R, "get_forward_vector", "rot"),
    "get_right_vector": (_R, "get_right_vector", "rot"),
    "get_up_vector": (_R, "get_up_vector", "rot"),
    "get_axes": (_R, "get_axes", "a"),
    "break_rot_into_axes": (_R, "get_axes", "rot"),
    "conv_rotator_to_vector": (_R, "to_vector", "rot"),
    "conv_rotator_to_quaternion": (_R, "quaternion", "rot"),
    "conv_rotator_to_transform": (_R, "transform", "rotator"),
    "compose_rotators": (_R, "combine", "a b"),
    "negate_rotator": (_R, "inversed", "a"),
    "normalized_delta_rotator": (_R, "delta", "a b"),
    "r_lerp": (_R, "lerp", "a b alpha shortest_path"),
    "multiply_rotator_float": (_R, "scale", "a b"),
    "multiply_rotator_int": (_R, "scale_integer", "a b"),
    "equal_equal_rotator_rotator": (_R, "is_near_equal", "a b error_tolerance"),
    "not_equal_rotator_rotator": (_R, "is_not_near_equal", "a b error_tolerance"),
    "quat_rotator": (_Q, "rotator", "q"),
    "quat_euler": (_Q, "euler", "q"),
    "quat_inversed": (_Q, "inversed", "q"),
    "quat_normalized": (_Q, "normalized", "q tolerance"),
    "quat_slerp": (_Q, "slerp_quat", "a b alpha"),
    "quat_rotate_vector": (_Q, "rotate_vector", "q v"),
    "quat_unrotate_vector": (_Q, "unrotate_vector", "q v"),
    "quat_vector_forward": (_Q, "vector_forward", "q"),
    "quat_vector_right": (_Q, "vector_right", "q"),
    "quat_vector_up": (_Q, "vector_up", "q"),
    "quat_get_axis_x": (_Q, "get_axis_x", "q"),
    "quat_get_axis_y": (_Q, "get_axis_y", "q"),
    "quat_get_axis_z": (_Q, "get_axis_z", "q"),
    "quat_get_angle": (_Q, "get_angle", "q"),
    "quat_get_rotation_axis": (_Q, "get_rotation_axis", "q"),
    "quat_angular_distance": (_Q, "angular_distance", "a b"),
    "quat_size": (_Q, "size", "q"),
    "quat_size_squared": (_Q, "size_squared", "q"),
    "quat_is_normalized": (_Q, "is_normalized", "q"),
    "quat_is_identity": (_Q, "is_identity", "q tolerance"),
    "quat_is_finite": (_Q, "is_finite", "q"),
    "quat_is_non_finite": (_Q, "is_non_finite", "q"),
    "quat_log": (_Q, "log", "q"),
    "quat_exp": (_Q, "exp", "q"),
    "multiply_quat_quat": (_Q, "multiply", "a b"),
    "add_quat_quat": (_Q, "add", "a b"),
    "subtract_quat_quat": (_Q, "subtract", "a b"),
    "equal_equal_quat_quat": (_Q, "equals", "a b tolerance"),
    "not_equal_quat_quat": (_Q, "not_equal", "a b error_tolerance"),
    # transforms
    "transform_location": (_T, "transform_location", "t location"),
    "transform_direction": (_T, "transform_direction", "t direction"),
    "transform_rotation": (_T, "transform_rotation", "t rotation"),
    "inverse_transform_location": (_T, "inverse_transform_location", "t location"),
    "inverse_transform_direction": (_T, "inverse_transform_direction", "t direction"),
    "inverse_transform_rotation": (_T, "inverse_transform_rotation", "t rotation"),
    "compose_transforms": (_T, "multiply", "a b"),
    "make_relative_transform": (_T, "make_relative", "a relative_to"),
    "invert_transform": (_T, "inverse", "t"),
    "transform_determinant": (_T, "determinant", "transform"),
    "t_lerp": (_T, "lerp", "a b alpha interp_mode"),
    "t_interp_to": (_T, "interp_to", "current target delta_time interp_speed"),
    "nearly_equal_transform_transform": (
        _T,
        "is_near_equal",
        "a b location_tolerance rotation_tolerance scale3d_tolerance",
    ),
    "equal_equal_transform_transform": (_T, "equals", "a b"),
    "conv_transform_to_matrix": (_T, "to_matrix", "transform"),
    # colours
    "linear_color_lerp": (_C, "lerp_to", "a b alpha"),
    "linear_color_lerp_using_hsv": (_C, "lerp_using_hsv_to", "a b alpha"),
    "linear_color_desaturated": (_C, "desaturated", "color desaturation"),
    "linear_color_distance": (_C, "distance", "c1 c2"),
    "linear_color_get_luminance": (_C, "get_luminance", "color"),
    "linear_color_get_max": (_C, "get_max", "color"),
    "linear_color_get_min": (_C, "get_min", "color"),
    "linear_color_to_new_opacity": (_C, "to_new_opacity", "color opacity"),
    "linear_color_quantize": (_C, "quantize", "color"),
    "linear_color_quantize_round": (_C, "quantize_round", "color"),
    "linear_color_is_near_equal": (_C, "is_near_equal", "a b tolerance"),
    "add_linear_color_linear_color": (_C, "add", "a b"),
    "subtract_linear_color_linear_color": (_C, "subtract", "a b"),
    "multiply_linear_color_linear_color": (_C, "multiply", "a b"),
    "multiply_linear_color_float": (_C, "multiply_float", "a b"),
    "divide_linear_color_linear_color": (_C, "divide", "a b"),
    "equal_equal_linear_color_linear_color": (_C, "equals", "a b"),
    "not_equal_linear_color_linear_color": (_C, "not_equal", "a b"),
    "rgb_to_hsv": (_C, "rgb_into_hsv_components", "color"),
    "rgb_linear_to_hsv": (_C, "rgb_to_hsv", "rgb"),
    "hsv_to_rgb_linear": (_C, "hsv_to_rgb", "hsv"),
    "conv_linear_color_to_color": (_C, "to_color", "linear_color use_srgb"),
    "conv_linear_color_to_vector": (_C, "to_rgb_vector", "linear_color"),
    "c_interp_to": (_C, "interpolate_to", "current target delta_time interp_speed"),
}

IN_PLACE: dict[str, tuple[type, str, str]] = {
    "vector_assign": (_V, "assign", "a vector"),
    "vector_set": (_V, "set", "a x y z"),
    "vector_normalize": (_V, "normalize", "a tolerance"),
    "vector_unwind_euler": (_V, "unwind_euler", "a"),
    "vector_add_bounded": (_V, "add_bounded", "a add_vect radius"),
    "set2d": (_2, "set", "a x y"),
    "normalize2d": (_2, "normalize", "a tolerance"),
    "quat_normalize": (_Q, "normalize", "q tolerance"),
    "quat_set_from_euler": (_Q, "set_from_euler", "q euler"),
    "quat_set_components": (_Q, "set_components", "q x y z w"),
    "quat_enforce_shortest_arc_with": (_Q, "ensure_shortest_arc_to", "a b"),
    "linear_color_set": (_C, "set", "out_color color"),
    "linear_color_set_rgba": (_C, "set_rgba", "out_color r g b a"),
    "linear_color_set_from_hsv": (_C, "set_from_hsv", "out_color h s v a"),
    "linear_color_set_from_srgb": (_C, "set_from_srgb", "out_color srgb"),
    "linear_color_set_from_pow22": (_C, "set_from_pow22", "out_color color"),
    "linear_color_set_random_hue": (_C, "set_random_hue", "out_color"),
    "linear_color_set_temperature": (_C, "set_temperature", "out_color temperature"),
}
"""Methods that change the struct; the function changes a copy, and returns that."""


def conv_color_to_linear_color(color: Color) -> LinearColor:
    """The colour of sRGB bytes."""
    return LinearColor._of_bytes(color)


def _twin(name: str, row: tuple[type, str, str], changes: bool) -> Callable[..., Any]:
    owner, method, names = row
    function = getattr(owner, method)
    known = inspect.signature(function)
    first, *rest = names.split()

    def call(*args: Any, **kwargs: Any) -> Any:
        bound = signature.bind(*args, **kwargs)
        subject, *others = bound.arguments.values()
        if not changes:
            return function(subject, *others)
        subject = subject.copy()
        function(subject, *others)
        return subject

    kinds = [
        p.replace(annotation=owner.__name__ if p.annotation == "Any" else p.annotation)
        for p in list(known.parameters.values())[1:]
    ]
    result = (
        owner.__name__
        if changes
        else {"Any": owner.__name__}.get(str(known.return_annotation), known.return_annotation)
    )
    signature = inspect.Signature(
        [
            inspect.Parameter(first, inspect.Parameter.POSITIONAL_OR_KEYWORD, annotation=owner.__name__),
            *(p.replace(name=n) for n, p in zip(rest, kinds, strict=True)),
        ],
        return_annotation=result,
    )
    call.__name__, call.__doc__ = name, function.__doc__
    call.__signature__ = signature  # type: ignore[attr-defined]
    return call


TWINS: dict[str, Callable[..., Any]] = {
    name: _twin(name, row, changes)
    for table, changes in ((PLAIN, False), (IN_PLACE, True))
    for name, row in table.items()
}
