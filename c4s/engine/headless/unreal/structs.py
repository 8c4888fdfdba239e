"""Unreal's structs: values, never references. Cm and degrees; ``Rotator(roll, pitch, yaw)``, ``Color(b, g, r, a)``."""

# ruff: noqa: RUF012  (each class declares its table of properties; no table is ever changed)

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any, ClassVar

from c4s.engine.headless.pose import (
    IDENTITY,
    Pose,
    compose,
    conjugate,
    normalized,
    reciprocal,
    relative_to,
    rotate,
)
from c4s.engine.headless.unreal.core import Prop, api, converted, copied, need, public
from c4s.scene.transform import normalize_axis, quat_angle_deg, quat_from_rotator, quat_multiply, rotator_from_quat


class StructBase:
    """Fields by declaration, in constructor order. Equality by value; not hashable."""

    _fields: ClassVar[dict[str, Prop]] = {}
    _takes: ClassVar[int | None] = None
    """How many fields the constructor takes, when not all."""

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        names = list(self._fields)[:self._takes]
        if len(args) > len(names):
            raise TypeError(f"{type(self).__name__}() takes at most {len(names)} arguments ({len(args)} given)")
        given = dict(zip(names, args, strict=False))
        for name, value in kwargs.items():
            if name not in names:
                raise TypeError(f"'{name}' is an invalid keyword argument for {type(self).__name__}()")
            if name in given:
                raise TypeError(f"{type(self).__name__}() got multiple values for argument '{name}'")
            given[name] = value
        for name, prop in self._fields.items():
            if name in given:
                self._put(name, given[name])
            else:
                default = prop.default() if callable(prop.default) else prop.default
                object.__setattr__(self, name, default)

    @classmethod
    def _of_fields(cls, *values: Any) -> Any:
        """A struct with its first fields set, whatever its constructor takes."""
        made = cls()
        for name, value in zip(cls._fields, values, strict=False):
            made._put(name, value)
        return made

    def __setattr__(self, name: str, value: Any) -> None:
        prop = self._fields.get(name)
        if prop is None or not prop.attribute:
            raise AttributeError(f"'{type(self).__name__}' object has no attribute '{name}'")
        self._put(name, value)

    def _put(self, name: str, value: Any) -> None:
        prop = self._fields[name]
        need(value, prop.kind, f"{type(self).__name__}: property '{name}'")
        object.__setattr__(self, name, converted(value, prop.kind))

    def __getattr__(self, name: str) -> Any:
        raise AttributeError(f"'{type(self).__name__}' object has no attribute '{name}'")

    def __eq__(self, other: object) -> bool:
        return type(other) is type(self) and self.to_tuple() == other.to_tuple()

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        inner = ", ".join(f"{n}: {self.__dict__[n]!r}" for n in self._fields)
        return f"<Struct '{type(self).__name__}' {{{inner}}}>"

    def copy(self) -> Any:
        """An independent copy."""
        made = type(self).__new__(type(self))
        for name in self._fields:
            object.__setattr__(made, name, copied(self.__dict__[name]))
        return made

    def __copy__(self) -> Any:
        return self.copy()

    def assign(self, other: Any) -> None:
        """Take over all fields of a struct of the same type."""
        need(other, type(self).__name__, f"{type(self).__name__}.assign")
        for name in self._fields:
            object.__setattr__(self, name, copied(other.__dict__[name]))

    def to_tuple(self) -> tuple[Any, ...]:
        """All fields in order."""
        return tuple(self.__dict__[n] for n in self._fields)

    def get_editor_property(self, name: str) -> Any:
        """A field by name."""
        self._known(name)
        return copied(self.__dict__[str(name)])

    def set_editor_property(self, name: str, value: Any, notify_mode: Any = None) -> None:
        """Set a field by name."""
        self._known(name)
        self._put(str(name), value)

    def _known(self, name: object) -> None:
        prop = self._fields.get(str(name))
        if prop is None or not prop.scripts:
            raise Exception(f"{type(self).__name__}: failed to find property '{name}'")

    def export_text(self) -> str:
        """Unreal's text form."""
        return "(" + ",".join(f"{_camel(n)}={_text(self.__dict__[n])}" for n in self._fields) + ")"


class ClosedStruct(StructBase):
    """A struct with fields that are no attributes: scripts reach them by ``get_editor_property``, or not at all."""

    def __getattribute__(self, name: str) -> Any:
        if not name.startswith("_"):
            prop = type(self)._fields.get(name)
            if prop is not None and not prop.attribute:
                raise AttributeError(f"'{type(self).__name__}' object has no attribute '{name}'")
        return super().__getattribute__(name)


def _camel(name: str) -> str:
    return "".join(part.capitalize() for part in name.split("_"))


def _text(value: Any) -> str:
    if isinstance(value, StructBase):
        return value.export_text()
    return f"{value:.6f}" if isinstance(value, float) else str(value)


def _numbers(*names: str, default: float = 0.0) -> dict[str, Prop]:
    return {name: Prop("float", default) for name in names}


class _Components(StructBase):
    """Structs that are a row of numbers, with arithmetic by component."""

    def _fill(self, *values: float) -> bool:
        """Set all fields at once when every value is a float; False (and nothing set) otherwise."""
        for value in values:
            if type(value) is not float:
                return False
        put = object.__setattr__
        for name, value in zip(self._fields, values, strict=True):
            put(self, name, value)
        return True

    def copy(self) -> Any:
        """An independent copy."""
        made = type(self).__new__(type(self))
        made.__dict__.update(self.__dict__)
        return made

    def _all(self) -> tuple[float, ...]:
        return tuple(getattr(self, n) for n in self._fields)

    def __iter__(self) -> Iterator[float]:
        raise TypeError(f"'{type(self).__name__}' object is not iterable")

    def _with(self, other: Any, operation: Any, sign: str) -> Any:
        if isinstance(other, (int, float)):
            return type(self)(*(operation(a, other) for a in self._all()))
        if type(other) is type(self):
            return type(self)(*(operation(a, b) for a, b in zip(self._all(), other._all(), strict=True)))
        return NotImplemented

    def __add__(self, other: Any) -> Any:
        return self._with(other, lambda a, b: a + b, "+") if type(other) is type(self) else NotImplemented

    def __sub__(self, other: Any) -> Any:
        return self._with(other, lambda a, b: a - b, "-") if type(other) is type(self) else NotImplemented

    def __mul__(self, other: Any) -> Any:
        return self._with(other, lambda a, b: a * b, "*")

    def __truediv__(self, other: Any) -> Any:
        return self._with(other, lambda a, b: a / b, "/")

    def __neg__(self) -> Any:
        return type(self)(*(-a for a in self._all()))

    def _near(self, b: Any, tolerance: float) -> bool:
        need(b, type(self).__name__, f"{type(self).__name__}: comparison")
        return all(abs(p - q) <= tolerance for p, q in zip(self._all(), b._all(), strict=True))


class _Near(_Components):
    """Rows of numbers that compare within a tolerance."""

    def is_near_equal(self, b: Any, error_tolerance: float = 1e-4) -> bool:
        """Whether every component differs by at most the tolerance."""
        return self._near(b, error_tolerance)


class _Constant:
    """A named value of a struct's class, a fresh copy at each use."""

    def __init__(self, *values: float) -> None:
        self._given = values

    def __get__(self, instance: object, owner: type[Any]) -> Any:
        return owner(*self._given)


@public
class Vector2D(_Near):
    """Two numbers."""

    _fields = _numbers("x", "y")
    x: float
    y: float

    def __init__(self, x: float = 0.0, y: float = 0.0) -> None:
        super().__init__(x, y)


@public
class Vector(_Near):
    """A point or direction in cm."""

    _fields = _numbers("x", "y", "z")
    x: float
    y: float
    z: float

    ZERO = _Constant(0.0, 0.0, 0.0)
    ONE = _Constant(1.0, 1.0, 1.0)
    FORWARD = _Constant(1.0, 0.0, 0.0)
    BACKWARD = _Constant(-1.0, 0.0, 0.0)
    RIGHT = _Constant(0.0, 1.0, 0.0)
    LEFT = _Constant(0.0, -1.0, 0.0)
    UP = _Constant(0.0, 0.0, 1.0)
    DOWN = _Constant(0.0, 0.0, -1.0)

    def assign(self, vector: Any) -> None:
        """Take over all numbers."""
        super().assign(vector)

    def __init__(self, x: float = 0.0, y: float = 0.0, z: float = 0.0) -> None:
        if not self._fill(x, y, z):
            super().__init__(x, y, z)

    def _triple(self) -> tuple[float, float, float]:
        return (self.x, self.y, self.z)

    def length(self) -> float:
        """Length in cm."""
        return math.sqrt(self.x * self.x + self.y * self.y + self.z * self.z)

    def length_squared(self) -> float:
        """Squared length."""
        return self.x * self.x + self.y * self.y + self.z * self.z

    @api
    def dot(self, b: Vector) -> float:
        """Scalar product."""
        return self.x * b.x + self.y * b.y + self.z * b.z

    @api
    def cross(self, b: Vector) -> Vector:
        """Vector product."""
        return Vector(self.y * b.z - self.z * b.y, self.z * b.x - self.x * b.z, self.x * b.y - self.y * b.x)

    def normal(self, tolerance: float = 1e-4) -> Vector:
        """Unit vector in this direction; zero for a (nearly) zero one."""
        size = self.length()
        return Vector() if size * size < tolerance * tolerance else Vector(self.x / size, self.y / size, self.z / size)

    def normalize(self, tolerance: float = 1e-8) -> None:
        """Make it a unit vector in place."""
        self.assign(self.normal(tolerance))

    @api
    def distance(self, v2: Vector) -> float:
        """Distance in cm."""
        return math.dist(self._triple(), v2._triple())

    @api
    def distance2d(self, v2: Vector) -> float:
        """Horizontal distance in cm."""
        return math.hypot(self.x - v2.x, self.y - v2.y)

    def rotator(self) -> Rotator:
        """Rotation that turns +X into this direction."""
        return Rotator(roll=0.0, pitch=math.degrees(math.atan2(self.z, math.hypot(self.x, self.y))),
                       yaw=math.degrees(math.atan2(self.y, self.x)))

    @api
    def rotate(self, b: Rotator) -> Vector:
        """This vector turned by a rotation."""
        return Vector(*rotate(quat_from_rotator(b._triple()), self._triple()))

    def length2d(self) -> float:
        """Horizontal length in cm."""
        return math.hypot(self.x, self.y)

    def is_zero(self) -> bool:
        """Whether all components are exactly 0."""
        return self._triple() == (0.0, 0.0, 0.0)

    @api
    def is_nearly_zero(self, tolerance: float = 1e-4) -> bool:
        """Whether all components lie within the tolerance of 0."""
        return max(map(abs, self._triple())) <= tolerance

    @api
    def lerp_to(self, b: Vector, alpha: float) -> Vector:
        """Linear mix."""
        return Vector(*(p + (q - p) * alpha for p, q in zip(self._triple(), b._triple(), strict=True)))


@public
class Vector4(_Near):
    """Four numbers."""

    _fields = _numbers("x", "y", "z", "w")

    def assign(self, vector: Any) -> None:
        """Take over all numbers."""
        super().assign(vector)

    def __init__(self, x: float = 0.0, y: float = 0.0, z: float = 0.0, w: float = 0.0) -> None:
        super().__init__(x, y, z, w)


@public
class Rotator(_Near):
    """A rotation in degrees; positional order is roll, pitch, yaw."""

    _fields = _numbers("roll", "pitch", "yaw")
    roll: float
    pitch: float
    yaw: float

    def __init__(self, roll: float = 0.0, pitch: float = 0.0, yaw: float = 0.0) -> None:
        if not self._fill(roll, pitch, yaw):
            super().__init__(roll, pitch, yaw)

    @classmethod
    def _of(cls, rotation_deg: tuple[float, float, float]) -> Rotator:
        return cls(roll=rotation_deg[2] + 0.0, pitch=rotation_deg[0] + 0.0, yaw=rotation_deg[1] + 0.0)

    def _triple(self) -> tuple[float, float, float]:
        return (self.pitch, self.yaw, self.roll)

    def quaternion(self) -> Quat:
        """The same rotation as a quaternion."""
        return Quat(*quat_from_rotator(self._triple()))

    def _axis(self, x: float, y: float, z: float) -> Vector:
        return Vector(*rotate(quat_from_rotator(self._triple()), (x, y, z)))

    def get_forward_vector(self) -> Vector:
        """Image of +X."""
        return self._axis(1, 0, 0)

    def get_right_vector(self) -> Vector:
        """Image of +Y."""
        return self._axis(0, 1, 0)

    def get_up_vector(self) -> Vector:
        """Image of +Z."""
        return self._axis(0, 0, 1)

    @api
    def combine(self, b: Rotator) -> Rotator:
        """This rotation first, then ``b``."""
        return Rotator._of(rotator_from_quat(quat_multiply(quat_from_rotator(b._triple()),
                                                           quat_from_rotator(self._triple()))))

    @api
    def delta(self, b: Rotator) -> Rotator:
        """Normalised difference ``self - b``."""
        return Rotator(*(normalize_axis(p - q) for p, q in zip(self._all(), b._all(), strict=True)))

    def inversed(self) -> Rotator:
        """The inverse rotation."""
        return Rotator._of(rotator_from_quat(conjugate(quat_from_rotator(self._triple()))))

    def transform(self) -> Transform:
        """A transform with this rotation only."""
        return Transform(rotation=self)


@public
class Quat(_Components):
    """A unit quaternion x, y, z, w."""

    _fields = {**_numbers("x", "y", "z"), "w": Prop("float", 1.0)}
    x: float
    y: float
    z: float
    w: float

    def equals(self, b: Quat, tolerance: float = 1e-4) -> bool:
        """Whether every component differs by at most the tolerance."""
        return self._near(b, tolerance)

    def __init__(self, x: float = 0.0, y: float = 0.0, z: float = 0.0, w: float = 1.0) -> None:
        if not self._fill(x, y, z, w):
            super().__init__(x, y, z, w)

    def _four(self) -> tuple[float, float, float, float]:
        return (self.x, self.y, self.z, self.w)

    def __mul__(self, other: Any) -> Any:
        if isinstance(other, Quat):
            return Quat(*quat_multiply(self._four(), other._four()))
        return super().__mul__(other)

    @api
    def multiply(self, b: Quat) -> Quat:
        """Product: ``b`` first, then this."""
        return Quat(*quat_multiply(self._four(), b._four()))

    def rotator(self) -> Rotator:
        """The same rotation as angles."""
        return Rotator._of(rotator_from_quat(self._four()))

    def euler(self) -> Vector:
        """Roll, pitch, yaw in degrees as a vector."""
        pitch, yaw, roll = rotator_from_quat(self._four())
        return Vector(roll, pitch, yaw)

    def inversed(self) -> Quat:
        """The inverse rotation."""
        return Quat(*conjugate(self._four()))

    def normalized(self, tolerance: float = 1e-4) -> Quat:
        """The unit quaternion in the same direction."""
        return Quat(*normalized(self._four()))

    @api
    def rotate_vector(self, v: Vector) -> Vector:
        """``v`` turned."""
        return Vector(*rotate(self._four(), v._triple()))

    @api
    def unrotate_vector(self, v: Vector) -> Vector:
        """``v`` turned back."""
        return Vector(*rotate(conjugate(self._four()), v._triple()))

    @api
    def angular_distance(self, b: Quat) -> float:
        """Angle between two rotations in radians."""
        return math.radians(quat_angle_deg(self._four(), b._four()))

    def get_axis_x(self) -> Vector:
        """Image of +X."""
        return Vector(*rotate(self._four(), (1, 0, 0)))

    def get_axis_y(self) -> Vector:
        """Image of +Y."""
        return Vector(*rotate(self._four(), (0, 1, 0)))

    def get_axis_z(self) -> Vector:
        """Image of +Z."""
        return Vector(*rotate(self._four(), (0, 0, 1)))


@public
class Transform(StructBase):
    """Translation (cm), rotation (a Quat) and scale; built from location, Rotator and scale."""

    _fields = {"translation": Prop("Vector"), "rotation": Prop("Quat"), "scale3d": Prop("Vector")}
    translation: Vector
    rotation: Quat
    scale3d: Vector

    def __init__(self, location: Any = None, rotation: Any = None, scale: Any = None) -> None:
        for value, kind, name in ((location, "Vector", "location"), (rotation, "Rotator", "rotation"),
                                  (scale, "Vector", "scale")):
            if value is not None:
                need(value, kind, f"Transform: parameter '{name}'")
        super().__init__(location if location is not None else Vector(),
                         rotation.quaternion() if rotation is not None else Quat(),
                         scale if scale is not None else Vector(1, 1, 1))

    @classmethod
    def _of(cls, pose: Pose) -> Transform:
        made = cls.__new__(cls)
        made.__dict__.update(translation=Vector(*pose.location), rotation=Quat(*pose.quat), scale3d=Vector(*pose.scale))
        return made

    def _pose(self) -> Pose:
        return Pose(self.translation._triple(), normalized(self.rotation._four()), self.scale3d._triple())

    def __mul__(self, other: Any) -> Any:
        return Transform._of(compose(self._pose(), other._pose())) if isinstance(other, Transform) else NotImplemented

    @api
    def multiply(self, b: Transform) -> Transform:
        """This transform first, then ``b``."""
        return Transform._of(compose(self._pose(), b._pose()))

    @api
    def make_relative(self, relative_to: Transform) -> Transform:
        """This transform seen from another."""
        return _relative(self, relative_to)

    def inverse(self) -> Transform:
        """The inverse transform (exact without rotation under non-uniform scale)."""
        pose = self._pose()
        back = conjugate(pose.quat)
        scale = (reciprocal(pose.scale[0]), reciprocal(pose.scale[1]), reciprocal(pose.scale[2]))
        turned = rotate(back, pose.location)
        return Transform._of(Pose((-turned[0] * scale[0], -turned[1] * scale[1], -turned[2] * scale[2]), back, scale))

    @api
    def transform_location(self, location: Vector) -> Vector:
        """World position of a local point."""
        return Vector(*self._pose().point(location._triple()))

    @api
    def inverse_transform_location(self, location: Vector) -> Vector:
        """Local position of a world point."""
        return Vector(*self._pose().inverse_point(location._triple()))

    @api
    def transform_direction(self, direction: Vector) -> Vector:
        """A direction turned, not scaled."""
        return Vector(*rotate(self._pose().quat, direction._triple()))

    @api
    def inverse_transform_direction(self, direction: Vector) -> Vector:
        """A direction turned back, not scaled."""
        return Vector(*rotate(conjugate(self._pose().quat), direction._triple()))

    @api
    def transform_rotation(self, rotation: Rotator) -> Rotator:
        """A local rotation in the world."""
        return Rotator._of(rotator_from_quat(quat_multiply(self._pose().quat, quat_from_rotator(rotation._triple()))))

    def determinant(self) -> float:
        """Product of the scale factors."""
        return self.scale3d.x * self.scale3d.y * self.scale3d.z

    @api
    def is_near_equal(self, b: Transform, location_tolerance: float = 1e-4, rotation_tolerance: float = 1e-4,
                      scale3d_tolerance: float = 1e-4) -> bool:
        """Whether all parts agree within the tolerances."""
        same = abs(sum(p * q for p, q in zip(self.rotation._four(), b.rotation._four(), strict=True)))
        return (self.translation.is_near_equal(b.translation, location_tolerance)
                and 1 - same <= rotation_tolerance and self.scale3d.is_near_equal(b.scale3d, scale3d_tolerance))


def _relative(transform: Transform, base: Transform) -> Transform:
    return Transform._of(relative_to(transform._pose(), base._pose()))


@public
class LinearColor(_Components):
    """Linear RGBA."""

    _fields = {**_numbers("r", "g", "b"), "a": Prop("float", 1.0)}
    r: float
    g: float
    b: float
    a: float

    def __init__(self, r: float = 0.0, g: float = 0.0, b: float = 0.0, a: float = 1.0) -> None:
        super().__init__(r, g, b, a)

    def _bytes(self, srgb: bool) -> Color:
        def level(value: float) -> int:
            value = min(1.0, max(0.0, value))
            if srgb:
                value = 12.92 * value if value <= 0.0031308 else 1.055 * value ** (1 / 2.4) - 0.055
            return math.floor(value * 255.999)

        return Color(b=level(self.b), g=level(self.g), r=level(self.r), a=math.floor(min(1, max(0, self.a)) * 255.999))

    def to_rgbe(self) -> Color:
        """sRGB bytes of this colour."""
        return self._bytes(True)


@public
class Color(StructBase):
    """sRGB bytes; positional order is b, g, r, a."""

    _fields = {"b": Prop("int", 0), "g": Prop("int", 0), "r": Prop("int", 0), "a": Prop("int", 0)}
    b: int
    g: int
    r: int
    a: int

    def __init__(self, b: int = 0, g: int = 0, r: int = 0, a: int = 0) -> None:
        super().__init__(b, g, r, a)

    def _put(self, name: str, value: Any) -> None:
        if isinstance(value, int) and not 0 <= value <= 255:
            raise OverflowError(f"Color: property '{name}': {value} does not fit 0..255")
        super()._put(name, value)


@public
class Guid(ClosedStruct):
    """A globally unique id."""

    _fields = {n: Prop("int", 0, attribute=False) for n in ("a", "b", "c", "d")}
    _takes = 0

    @classmethod
    def _of(cls, text: str) -> Guid:
        made: Guid = cls._of_fields(*(int(text[i * 8:i * 8 + 8], 16) for i in range(4)))
        return made

    def to_string(self) -> str:
        """32 upper-case hex digits."""
        return "".join(f"{number:08X}" for number in self.to_tuple())


@public
class Box(StructBase):
    """An axis-aligned box."""

    _fields = {"min": Prop("Vector", Vector), "max": Prop("Vector", Vector), "is_valid": Prop("bool", True)}
    _takes = 2


@public
class BoxSphereBounds(StructBase):
    """Bounds as a box (centre and half extent) and a sphere."""

    _fields = {"origin": Prop("Vector", Vector), "box_extent": Prop("Vector", Vector),
               "sphere_radius": Prop("float", 0.0)}


IDENTITY_TRANSFORM = Transform._of(IDENTITY)
