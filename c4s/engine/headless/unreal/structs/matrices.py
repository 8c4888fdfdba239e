"""4x4 matrices that act on row vectors, as Unreal's: their first three rows are the images of the axes."""

# ruff: noqa: RUF012  (each class declares its table of properties; no table is ever changed)

from __future__ import annotations

import math
from typing import Any

import numpy as np

from c4s.engine.headless.pose import Pose, by_matrix
from c4s.engine.headless.unreal.core import Prop, api, public
from c4s.engine.headless.unreal.structs.base import StructBase
from c4s.engine.headless.unreal.structs.modes import AxisType, MatrixColumns
from c4s.engine.headless.unreal.structs.planes import Vector4
from c4s.engine.headless.unreal.structs.rotations import Quat, Rotator
from c4s.engine.headless.unreal.structs.transforms import Transform
from c4s.engine.headless.unreal.structs.vectors import Plane, Vector
from c4s.geometry.transform import Array

_ROW = {"X": 0, "Y": 1, "Z": 2}
_SMALL = 1e-8


class _Identity:
    def __get__(self, instance: object, owner: type[Any]) -> Any:
        return owner._of(np.eye(4))


@public
class Matrix(StructBase):
    """Four rows; the last one is the origin."""

    _fields = {f"{name}_plane": Prop("Plane", Plane) for name in "xyzw"}
    x_plane: Plane
    y_plane: Plane
    z_plane: Plane
    w_plane: Plane

    IDENTITY = _Identity()

    @classmethod
    def _of(cls, rows: Array) -> Matrix:
        return cls(*(Plane(*map(float, row)) for row in rows))

    def _rows(self) -> Array:
        return np.array([plane._all() for plane in self.to_tuple()])

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Matrix) and self.equals(other)

    __hash__ = None

    def __add__(self, other: Any) -> Any:
        return Matrix._of(self._rows() + other._rows()) if isinstance(other, Matrix) else NotImplemented

    def __mul__(self, other: Any) -> Any:
        if isinstance(other, (int, float)) and not isinstance(other, bool):
            return Matrix._of(self._rows() * other)
        return Matrix._of(self._rows() @ other._rows()) if isinstance(other, Matrix) else NotImplemented

    @api
    def add(self, b: Matrix) -> Matrix:
        """Sum."""
        return self + b  # type: ignore[no-any-return]

    @api
    def multiply(self, b: Matrix) -> Matrix:
        """This first, then ``b``."""
        return self * b  # type: ignore[no-any-return]

    @api
    def multiply_float(self, b: float) -> Matrix:
        """All numbers times a number."""
        return self * b  # type: ignore[no-any-return]

    @api
    def equals(self, b: Matrix, tolerance: float = 1e-4) -> bool:
        """Whether every number differs by at most the tolerance."""
        return bool(np.all(np.abs(self._rows() - b._rows()) <= tolerance))

    @api
    def not_equal(self, b: Matrix, tolerance: float = 1e-4) -> bool:
        """Whether any number differs by more than the tolerance."""
        return not self.equals(b, tolerance)

    def contains_na_n(self) -> bool:
        """Whether any number is not finite."""
        return not bool(np.isfinite(self._rows()).all())

    # application

    @api
    def transform_vector4(self, v: Vector4) -> Vector4:
        """Row vector times matrix."""
        return Vector4(*map(float, np.array(v._all()) @ self._rows()))

    @api
    def transform_position(self, v: Vector) -> Vector4:
        """A point, moved too."""
        return self.transform_vector4(Vector4(v.x, v.y, v.z, 1.0))

    @api
    def transform_vector(self, v: Vector) -> Vector4:
        """A direction, not moved."""
        return self.transform_vector4(Vector4(v.x, v.y, v.z, 0.0))

    @api
    def inverse_transform_position(self, v: Vector) -> Vector:
        """The point whose image is ``v``."""
        return self.get_inverse().transform_position(v).vector()

    @api
    def inverse_transform_vector(self, v: Vector) -> Vector:
        """The direction whose image is ``v``."""
        return self.get_inverse().transform_vector(v).vector()

    # parts

    def get_origin(self) -> Vector:
        """Image of the origin."""
        return Vector(*self.w_plane._triple())

    @api
    def set_origin(self, new_origin: Vector) -> None:
        """Set the image of the origin."""
        self.w_plane = Plane(*new_origin._triple(), self.w_plane.w)

    @api
    def get_scaled_axis(self, axis: AxisType) -> Vector:
        """Image of an axis; zero for none."""
        return Vector(*map(float, self._rows()[_ROW[axis.name], :3])) if axis.name in _ROW else Vector()

    def get_scaled_axes(self) -> tuple[Vector, Vector, Vector]:
        """Images of the axes."""
        x, y, z = (Vector(*map(float, row)) for row in self._rows()[:3, :3])
        return x, y, z

    @api
    def get_unit_axis(self, axis: AxisType) -> Vector:
        """Direction of the image of an axis."""
        return self.get_scaled_axis(axis).normal(_SMALL)

    def get_unit_axes(self) -> tuple[Vector, Vector, Vector]:
        """Directions of the images of the axes."""
        x, y, z = (axis.normal(_SMALL) for axis in self.get_scaled_axes())
        return x, y, z

    @api
    def set_axis(self, axis: AxisType, axis_vector: Vector) -> None:
        """Set the image of an axis."""
        if axis.name in _ROW:
            rows = self._rows()
            rows[_ROW[axis.name], :3] = axis_vector._triple()
            self.assign(Matrix._of(rows))

    @api
    def get_column(self, column: MatrixColumns) -> Vector:
        """First three numbers of a column."""
        return Vector(*map(float, self._rows()[:3, column.value]))

    @api
    def set_column(self, column: MatrixColumns, value: Vector) -> None:
        """Set the first three numbers of a column."""
        rows = self._rows()
        rows[:3, column.value] = value._triple()
        self.assign(Matrix._of(rows))

    @api
    def get_scale_vector(self, tolerance: float = 1e-8) -> Vector:
        """Lengths of the images of the axes."""
        lengths = np.linalg.norm(self._rows()[:3, :3], axis=1)
        return Vector(*(float(v) if v * v > tolerance else 0.0 for v in lengths))

    def get_maximum_axis_scale(self) -> float:
        """Longest image of an axis."""
        return max(axis.length() for axis in self.get_scaled_axes())

    @api
    def get_matrix_without_scale(self, tolerance: float = 1e-8) -> Matrix:
        """With images of the axes of unit length."""
        rows = self._rows()
        squared = (rows[:3, :3] ** 2).sum(axis=1)
        rows[:3, :3] *= np.where(squared > tolerance, 1 / np.sqrt(np.maximum(squared, 1e-300)), 1.0)[:, None]
        return Matrix._of(rows)

    @api
    def remove_scaling(self, tolerance: float = 1e-8) -> None:
        """Make the images of the axes unit vectors, in place."""
        self.assign(self.get_matrix_without_scale(tolerance))

    def remove_translation(self) -> Matrix:
        """With the origin where it is."""
        rows = self._rows()
        rows[3, :3] = 0
        return Matrix._of(rows)

    @api
    def concatenate_translation(self, translation: Vector) -> Matrix:
        """Moved."""
        rows = self._rows()
        rows[3, :3] += translation._triple()
        return Matrix._of(rows)

    @api
    def scale_translation(self, scale3d: Vector) -> Matrix:
        """With the image of the origin scaled."""
        rows = self._rows()
        rows[3, :3] *= scale3d._triple()
        return Matrix._of(rows)

    @api
    def apply_scale(self, scale: float) -> Matrix:
        """Scaled first."""
        rows = self._rows()
        return Matrix._of(np.diag([scale, scale, scale, 1.0]) @ rows)

    @api
    def mirror(self, mirror_axis: AxisType, flip_axis: AxisType) -> Matrix:
        """Mirrored along a world axis, with one of its own axes turned round."""
        rows = self._rows()
        if mirror_axis.name in _ROW:
            rows[:, _ROW[mirror_axis.name]] *= -1
        if flip_axis.name in _ROW:
            rows[_ROW[flip_axis.name], :3] *= -1
        return Matrix._of(rows)

    # as a whole

    def get_determinant(self) -> float:
        """Determinant."""
        return float(np.linalg.det(self._rows()))

    def get_rot_determinant(self) -> float:
        """Determinant of the part without translation."""
        return float(np.linalg.det(self._rows()[:3, :3]))

    def get_inverse(self) -> Matrix:
        """The inverse; the identity for one without."""
        rows = self._rows()
        return Matrix._of(np.asarray(np.linalg.inv(rows)) if np.linalg.det(rows) else np.eye(4))

    def get_transposed(self) -> Matrix:
        """Rows as columns."""
        return Matrix._of(self._rows().T)

    def get_transpose_adjoint(self) -> Matrix:
        """Cofactors of the part without translation: what normals are transformed by."""
        x, y, z = self.get_scaled_axes()
        made = np.eye(4)
        made[:3, :3] = [y.cross(z)._triple(), z.cross(x)._triple(), x.cross(y)._triple()]
        return Matrix._of(made)

    def to_quat(self) -> Quat:
        """Rotation of the images of the axes."""
        return Quat(*by_matrix(self.get_matrix_without_scale()._rows()[:3, :3].T))

    def get_rotator(self) -> Rotator:
        """Rotation of the images of the axes."""
        x, _, z = self.get_unit_axes()
        pitch, yaw = math.degrees(math.atan2(x.z, math.hypot(x.x, x.y))), math.degrees(math.atan2(x.y, x.x))
        side = Rotator(pitch=pitch, yaw=yaw).get_right_vector()
        y = self.get_unit_axes()[1]
        return Rotator(roll=math.degrees(math.atan2(z.dot(side), y.dot(side))), pitch=pitch, yaw=yaw)

    def rotator(self) -> Rotator:
        """Rotation of the images of the axes."""
        return self.get_rotator()

    def transform(self) -> Transform:
        """As a transform; a mirrored one takes its sign on x."""
        rows = self._rows()[:3, :3]
        scale = np.linalg.norm(rows, axis=1)
        if np.linalg.det(rows) < 0:
            scale[0] = -scale[0]
        axes = rows / np.where(np.abs(scale) > _SMALL, scale, 1.0)[:, None]
        size = (float(scale[0]), float(scale[1]), float(scale[2]))
        return Transform._of(Pose(self.get_origin()._triple(), by_matrix(axes.T), size))
