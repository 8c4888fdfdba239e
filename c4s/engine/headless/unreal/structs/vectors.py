"""Vectors."""

# ruff: noqa: RUF012  (each class declares its table of properties; no table is ever changed)

from __future__ import annotations

import math
import random
from typing import Any

from c4s.engine.headless.unreal.core import Prop, api, public
from c4s.engine.headless.unreal.structs.numbers import SMALL, Constant, Scaled, clamped, numbers, quotient


@public
class Vector(Scaled):
    """A point or direction in cm."""

    _fields = numbers("x", "y", "z")
    x: float
    y: float
    z: float

    ZERO = Constant(0.0, 0.0, 0.0)
    ONE = Constant(1.0, 1.0, 1.0)
    FORWARD = Constant(1.0, 0.0, 0.0)
    BACKWARD = Constant(-1.0, 0.0, 0.0)
    RIGHT = Constant(0.0, 1.0, 0.0)
    LEFT = Constant(0.0, -1.0, 0.0)
    UP = Constant(0.0, 0.0, 1.0)
    DOWN = Constant(0.0, 0.0, -1.0)

    def __init__(self, x: float = 0.0, y: float = 0.0, z: float = 0.0) -> None:
        if type(x) is type(y) is type(z) is float:
            own = self.__dict__
            own["x"], own["y"], own["z"] = x, y, z
        else:
            super().__init__(x, y, z)

    def _triple(self) -> tuple[float, float, float]:
        return (self.x, self.y, self.z)

    def _times(self, factor: float) -> Vector:
        return Vector(self.x * factor, self.y * factor, self.z * factor)

    def __or__(self, other: Any) -> Any:
        return self.dot(other) if isinstance(other, Vector) else NotImplemented

    def __xor__(self, other: Any) -> Any:
        return self.cross(other) if isinstance(other, Vector) else NotImplemented

    def set(self, x: float, y: float, z: float) -> None:
        """Set all numbers."""
        self._take(Vector(x, y, z))

    def assign(self, vector: Any) -> None:
        """Take over all numbers."""
        super().assign(vector)

    @api
    def add_int(self, b: int) -> Vector:
        """A number added to every component."""
        return Vector(self.x + b, self.y + b, self.z + b)

    @api
    def subtract_int(self, b: int) -> Vector:
        """A number taken from every component."""
        return Vector(self.x - b, self.y - b, self.z - b)

    @api
    def multiply_int(self, b: int) -> Vector:
        """Product with a number."""
        return Vector(self.x * b, self.y * b, self.z * b)

    @api
    def divide_int(self, b: int = 1) -> Vector:
        """Quotient by a number."""
        return Vector(quotient(self.x, b), quotient(self.y, b), quotient(self.z, b))

    @api
    def divide(self, b: Vector = (1.0, 1.0, 1.0)) -> Vector:  # type: ignore[assignment]
        """Quotient by component."""
        return self / Vector.cast(b)  # type: ignore[no-any-return]

    def reciprocal(self) -> Vector:
        """1 / x by component; a huge number for 0."""
        return Vector(*(1 / a if a else 3.4e38 for a in self._triple()))

    @api
    def dot(self, b: Vector) -> float:
        """Scalar product."""
        return self.x * b.x + self.y * b.y + self.z * b.z

    @api
    def cross(self, b: Vector) -> Vector:
        """Vector product."""
        return Vector(self.y * b.z - self.z * b.y, self.z * b.x - self.x * b.z, self.x * b.y - self.y * b.x)

    def length(self) -> float:
        """Length in cm."""
        return math.sqrt(self.x * self.x + self.y * self.y + self.z * self.z)

    def length_squared(self) -> float:
        """Squared length."""
        return self.x * self.x + self.y * self.y + self.z * self.z

    def length2d(self) -> float:
        """Horizontal length in cm."""
        return math.hypot(self.x, self.y)

    def length2d_squared(self) -> float:
        """Squared horizontal length."""
        return self.x * self.x + self.y * self.y

    @api
    def normal(self, tolerance: float = 1e-4) -> Vector:
        """Unit vector in this direction; zero when the squared length is below the tolerance."""
        squared = self.length_squared()
        return self._times(0.0 if squared < tolerance else 1 / math.sqrt(squared))

    # what it looks like

    @api
    def is_nearly_zero(self, tolerance: float = 1e-4) -> bool:
        """Whether all components lie within the tolerance of 0."""
        return max(map(abs, self._triple())) <= tolerance

    @api
    def is_unit(self, squared_lenth_tolerance: float = 1e-4) -> bool:
        """Whether the squared length is 1, within the tolerance."""
        return abs(1 - self.length_squared()) < squared_lenth_tolerance

    @api
    def is_uniform(self, tolerance: float = 1e-4) -> bool:
        """Whether all components agree within the tolerance."""
        return max(self._triple()) - min(self._triple()) <= tolerance

    def is_normal(self) -> bool:
        """Whether it is a unit vector, roughly."""
        return abs(1 - self.length_squared()) < 0.01

    def is_nan(self) -> bool:
        """Whether any number is not finite."""
        return not all(map(math.isfinite, self._triple()))

    def get_abs(self) -> Vector:
        """Without signs."""
        return Vector(abs(self.x), abs(self.y), abs(self.z))

    def get_abs_max(self) -> float:
        """Largest number without sign."""
        return max(map(abs, self._triple()))

    def get_abs_min(self) -> float:
        """Smallest number without sign."""
        return min(map(abs, self._triple()))

    def get_max_element(self) -> float:
        """Largest number."""
        return max(self._triple())

    def get_min_element(self) -> float:
        """Smallest number."""
        return min(self._triple())

    @api
    def get_max(self, b: Vector) -> Vector:
        """Larger numbers by component."""
        return Vector(*map(max, self._triple(), b._triple()))

    @api
    def get_min(self, b: Vector) -> Vector:
        """Smaller numbers by component."""
        return Vector(*map(min, self._triple(), b._triple()))

    def get_sign_vector(self) -> Vector:
        """1 or -1 by component."""
        return Vector(*(1.0 if a >= 0 else -1.0 for a in self._triple()))

    def get_projection(self) -> Vector:
        """Divided by z."""
        return Vector(quotient(self.x, self.z), quotient(self.y, self.z), 1.0)

    # bounds

    @api
    def bounded_to_cube(self, radius: float) -> Vector:
        """Moved into the cube of a half side."""
        return Vector(*(clamped(a, -radius, radius) for a in self._triple()))

    @api
    def bounded_to_box(self, box_min: Vector, box_max: Vector) -> Vector:
        """Moved into a box."""
        return Vector(*map(clamped, self._triple(), box_min._triple(), box_max._triple()))

    @api
    def add_bounded(self, add_vect: Vector, radius: float) -> None:
        """Add, and stay within the cube of a half side."""
        self._take((self + add_vect).bounded_to_cube(radius))

    @api
    def clamped_size(self, min: float, max: float) -> Vector:
        """With its length moved between two."""
        size = self.length()
        return Vector() if size <= SMALL else self._times(clamped(size, min, max) / size)

    @api
    def clamped_size_max(self, max: float) -> Vector:
        """With a length of at most ``max``."""
        if max < 1e-4:
            return Vector()
        size = self.length()
        return self._times(max / size) if size > max else self.copy()

    @api
    def clamped_size2d(self, min: float, max: float) -> Vector:
        """With its horizontal length moved between two."""
        size = self.length2d()
        factor = clamped(size, min, max) / size if size > SMALL else 0.0
        return Vector(self.x * factor, self.y * factor, self.z)

    @api
    def clamped_size_max2d(self, max: float) -> Vector:
        """With a horizontal length of at most ``max``."""
        size = self.length2d()
        factor = 0.0 if max < 1e-4 else max / size if size > max else 1.0
        return Vector(self.x * factor, self.y * factor, self.z)

    @api
    def snapped_to_grid(self, grid_size: float) -> Vector:
        """Moved to the nearest point of a grid (cm); 0 changes nothing."""
        if grid_size == 0:
            return Vector(*self._triple())
        return Vector(*(math.floor((a + grid_size / 2) / grid_size) * grid_size for a in self._triple()))

    @api
    def random_point_in_box_extents(self, half_size: Vector) -> Vector:
        """A random point in the box of a half size around this one."""
        return Vector(*(random.uniform(c - h, c + h) for c, h in zip(self._triple(), half_size._triple(), strict=True)))

    # conversions

    def unwind_euler(self) -> None:
        """Wrap all numbers as angles to -180..180 degrees."""
        self._take(Vector(*(math.remainder(a, 360.0) for a in self._triple())))

    def to_degrees(self) -> Vector:
        """Radians as degrees."""
        return Vector(*map(math.degrees, self._triple()))

    def to_radians(self) -> Vector:
        """Degrees as radians."""
        return Vector(*map(math.radians, self._triple()))


@public
class Plane(Vector):
    """A plane: its normal, and its distance from the origin along that (cm)."""

    _fields = {**numbers("x", "y", "z"), "w": Prop("float", 0.0)}
    w: float

    def __init__(self, x: float = 0.0, y: float = 0.0, z: float = 0.0, w: float = 0.0) -> None:
        if not self._fill(x, y, z, w):
            super(Vector, self).__init__(x, y, z, w)
