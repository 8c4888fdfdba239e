"""Random numbers: from Python's generator, so ``random.seed`` repeats them, or from a stream of their own seed."""

# ruff: noqa: RUF012  (each class declares its table of properties; no table is ever changed)

from __future__ import annotations

import math
import random
from collections.abc import Callable
from typing import Any

from c4s.engine.headless.unreal.core import Prop, api, public
from c4s.engine.headless.unreal.structs import Box, Rotator, StructBase, Vector

_MULTIPLIER, _INCREMENT, _SPAN = 196314165, 907633515, 2**32


@public
class RandomStream(StructBase):
    """Numbers that follow from a seed: Unreal's linear congruential generator, so equal seeds give equal scenes."""

    _fields = {"initial_seed": Prop("int", 0)}
    initial_seed: int

    def __init__(self, initial_seed: int = 0) -> None:
        super().__init__(initial_seed)
        object.__setattr__(self, "_seed", self.initial_seed)

    def copy(self) -> Any:
        """An independent copy in the same state."""
        made = super().copy()
        object.__setattr__(made, "_seed", self.__dict__["_seed"])
        return made

    def _next(self) -> float:
        seed = (self.__dict__["_seed"] * _MULTIPLIER + _INCREMENT) % _SPAN
        object.__setattr__(self, "_seed", seed)
        return float(seed >> 9) / 2**23

    @api
    def set_seed(self, new_seed: int) -> None:
        """Start anew from a seed."""
        self.initial_seed = new_seed
        self.reset()

    def generate_new_seed(self) -> None:
        """Start anew from a random seed."""
        self.set_seed(random.randrange(2**31))

    def reset(self) -> None:
        """Start anew from the seed."""
        object.__setattr__(self, "_seed", self.initial_seed)

    def random_float(self) -> float:
        """A number from 0 up to 1."""
        return self._next()

    @api
    def random_float_in_range(self, min: float, max: float) -> float:
        """A number between two."""
        return min + (max - min) * self._next()

    @api
    def random_int(self, max: int) -> int:
        """A whole number from 0 up to ``max``, that left out."""
        return int(self._next() * max) if max > 0 else 0

    @api
    def random_int_in_range(self, min: int, max: int) -> int:
        """A whole number between two, both included."""
        return min + self.random_int(max - min + 1)

    def random_bool(self) -> bool:
        """Heads or tails."""
        return self.random_int(2) == 1

    @api
    def random_bool_with_weight(self, weight: float = 0.5) -> bool:
        """True with a probability."""
        return weight > 0 and (weight >= 1 or self._next() <= weight)

    def random_unit_vector(self) -> Vector:
        """A random direction."""
        while True:
            x, y, z = (self._next() * 2 - 1 for _ in range(3))
            if 1e-4 < x * x + y * y + z * z <= 1:
                return Vector(x, y, z).normal(0.0)

    @api
    def random_rotator(self, roll: bool) -> Rotator:
        """A random rotation."""
        yaw, pitch = self._next() * 360, self._next() * 360
        return Rotator(pitch=pitch, yaw=yaw, roll=self._next() * 360 if roll else 0.0)

    @api
    def random_point_in_bounded_box(self, center: Vector, half_size: Vector) -> Vector:
        """A random point in the box of a centre and half size."""
        return Vector(
            *(c - h + 2 * h * self._next() for c, h in zip(center._triple(), half_size._triple(), strict=True))
        )

    @api
    def random_point_in_box(self, box: Box) -> Vector:
        """A random point in a box."""
        return self.random_point_in_bounded_box((box.min + box.max) * 0.5, (box.max - box.min) * 0.5)


def random_float() -> float:
    """A number from 0 up to 1."""
    return random.random()


def random_float_in_range(min: float, max: float) -> float:
    """A number between two."""
    return random.uniform(min, max)


def random_integer(max: int) -> int:
    """A whole number from 0 up to ``max``, that left out."""
    return random.randrange(max) if max > 0 else 0


def random_integer_in_range(min: int, max: int) -> int:
    """A whole number between two, both included."""
    return random.randint(min, max) if min <= max else min


def random_bool() -> bool:
    """Heads or tails."""
    return random.random() < 0.5


def random_bool_with_weight(weight: float = 0.5) -> bool:
    """True with a probability."""
    return random.random() < weight


def random_unit_vector() -> Vector:
    """A random direction."""
    z, angle = random.uniform(-1, 1), random.uniform(0, math.tau)
    flat = math.sqrt(1 - z * z)
    return Vector(flat * math.cos(angle), flat * math.sin(angle), z)


def random_rotator(roll: bool = False) -> Rotator:
    """A random rotation."""
    return Rotator(
        pitch=random.uniform(0, 360), yaw=random.uniform(0, 360), roll=random.uniform(0, 360) if roll else 0.0
    )


def random_point_in_bounding_box(center: Vector, half_size: Vector) -> Vector:
    """A random point in the box of a centre and half size."""
    return center.random_point_in_box_extents(half_size)


def random_unit_vector_in_cone_in_degrees(cone_dir: Vector, cone_half_angle_in_degrees: float) -> Vector:
    """A random direction within degrees of another."""
    if cone_half_angle_in_degrees <= 0:
        return cone_dir.normal(1e-8)
    cosine = random.uniform(math.cos(math.radians(cone_half_angle_in_degrees)), 1)
    angle, flat = random.uniform(0, math.tau), math.sqrt(1 - cosine * cosine)
    return Vector(cosine, flat * math.cos(angle), flat * math.sin(angle)).rotate(cone_dir.rotator())  # type: ignore[no-any-return]


def random_integer_in_range_from_stream(stream: RandomStream, min: int, max: int) -> int:
    """A whole number between two, both included."""
    return stream.random_int_in_range(min, max)


def random_integer_from_stream(stream: RandomStream, max: int) -> int:
    """A whole number from 0 up to ``max``, that left out."""
    return stream.random_int(max)


def random_float_in_range_from_stream(stream: RandomStream, min: float, max: float) -> float:
    """A number between two."""
    return stream.random_float_in_range(min, max)


def random_float_from_stream(stream: RandomStream) -> float:
    """A number from 0 up to 1."""
    return stream.random_float()


def random_bool_from_stream(stream: RandomStream) -> bool:
    """Heads or tails."""
    return stream.random_bool()


def random_unit_vector_from_stream(stream: RandomStream) -> Vector:
    """A random direction."""
    return stream.random_unit_vector()


def random_rotator_from_stream(stream: RandomStream, roll: bool) -> Rotator:
    """A random rotation."""
    return stream.random_rotator(roll)


def random_point_in_bounding_box_from_stream(stream: RandomStream, center: Vector, half_size: Vector) -> Vector:
    """A random point in the box of a centre and half size."""
    return stream.random_point_in_bounded_box(center, half_size)


def random_unit_vector_in_cone_in_radians(cone_dir: Vector, cone_half_angle_in_radians: float) -> Vector:
    """A random direction within radians of another."""
    return random_unit_vector_in_cone_in_degrees(cone_dir, math.degrees(cone_half_angle_in_radians))


def random_point_in_bounding_box_box(box: Box) -> Vector:
    """A random point in a box."""
    return box.random_point_in_box_extents()


def random_point_in_bounding_box_from_stream_box(stream: RandomStream, box: Box) -> Vector:
    """A random point in a box."""
    return stream.random_point_in_box(box)


def random_bool_with_weight_from_stream(random_stream: RandomStream, weight: float = 0.5) -> bool:
    """True with a probability."""
    return random_stream.random_bool_with_weight(weight)


def set_random_stream_seed(stream: RandomStream, new_seed: int) -> RandomStream:
    """A stream that starts anew from a seed."""
    made: RandomStream = stream.copy()
    made.set_seed(new_seed)
    return made


def seed_random_stream(stream: RandomStream) -> RandomStream:
    """A stream that starts anew from a random seed."""
    made: RandomStream = stream.copy()
    made.generate_new_seed()
    return made


def reset_random_stream(stream: RandomStream) -> None:
    """Let a stream start anew from its seed."""
    stream.reset()


OTHER_NAMES: dict[str, Callable[..., Any]] = {
    "rand": random_integer,
    "rand_range": random_integer_in_range,
    "rand_bool": random_bool,
    "f_rand": random_float,
    "f_rand_range": random_float_in_range,
    "v_rand": random_unit_vector,
    "rot_rand": random_rotator,
    "random_integer64": random_integer,
    "random_integer64_in_range": random_integer_in_range,
    "random_unit_vector_in_cone": random_unit_vector_in_cone_in_radians,
    "rand_from_stream": random_integer_from_stream,
    "rand_range_from_stream": random_integer_in_range_from_stream,
    "rand_bool_from_stream": random_bool_from_stream,
    "f_rand_from_stream": random_float_from_stream,
    "f_rand_range_from_stream": random_float_in_range_from_stream,
    "v_rand_from_stream": random_unit_vector_from_stream,
    "rot_rand_from_stream": random_rotator_from_stream,
}
"""Functions that have a second name."""
