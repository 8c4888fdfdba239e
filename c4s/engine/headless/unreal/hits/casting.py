"""From a script's arguments to a query: shapes, filters, and what a query refuses."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from c4s.collision.mesh_body import MeshBody
from c4s.collision.shapes import Body, scaled_shape
from c4s.engine.headless.editor import world
from c4s.engine.headless.pose import Triple
from c4s.engine.headless.queries import cast
from c4s.engine.headless.queries.channels import OBJECT_TYPES, TRACE_TYPES
from c4s.engine.headless.queries.filters import Answer, Wanted, to_channel, to_object_types, to_profile
from c4s.engine.headless.unreal.containers import Name
from c4s.engine.headless.unreal.core import Class, as_class, subclass_of
from c4s.engine.headless.unreal.hits import results
from c4s.engine.headless.unreal.structs import Rotator, Vector
from c4s.geometry.transform import WORLD_CM, rotation_matrix

NOTHING_CM = 1e-4
"""A shape this small is a point, as in Unreal."""


def channel(query: Any) -> Answer:
    """A ``TraceTypeQuery`` as a filter."""
    return to_channel(TRACE_TYPES[query.value])


def objects(queries: Sequence[Any]) -> Answer:
    """``ObjectTypeQuery`` values as a filter; none is a warning, and nothing is found."""
    if not len(queries):
        world().log.warning("Invalid object types: a query for objects needs at least one object type")
    return to_object_types(OBJECT_TYPES[query.value] for query in queries)


def named(name: Name | str) -> Answer:
    """A profile's name as a filter."""
    return to_profile(str(name))


def context_actor(context: Any) -> Any:
    """The actor that a world context is or belongs to, or None."""
    while context is not None and not hasattr(context, "_components"):
        context = context._outer
    return context


def wanted(answer: Answer, context: Any, ignored: Sequence[Any], ignore_self: bool, triangles: bool) -> Wanted:
    """The filter of a trace."""
    unseen = list(ignored)
    if ignore_self:
        unseen.append(context_actor(context))
    return Wanted(answer, unseen, bool(triangles))


def row(value: Vector) -> Any:
    """A vector as an array."""
    return np.array(value._triple(), dtype=np.float64)


def usable(what: str, context: Any, *numbers: float) -> bool:
    """Whether there is a world to look in and all numbers lie in it; a warning is logged when not."""
    if context is None:
        world().log.warning(f"{what}: A null object was passed as a world context object")
        return False
    if all(abs(number) < WORLD_CM for number in numbers):
        return True
    world().log.warning(f"{what}: the query has numbers that are not finite or outside the world, and finds nothing")
    return False


def sphere(middle: Triple, radius: float) -> Body | None:
    """A sphere in the world (cm); None when it is a point."""
    if radius <= NOTHING_CM:
        return None
    return _placed(MeshBody("sphere", size=(radius, 0.0, 0.0)), middle, (0.0, 0.0, 0.0))


def box(middle: Triple, half: Vector, turn: Rotator) -> Body | None:
    """A box in the world (half extents in cm); None when it is a point."""
    sides = [max(0.0, side) for side in half._triple()]
    if max(sides) <= NOTHING_CM:
        return None
    x, y, z = (max(side, NOTHING_CM) for side in sides)
    return _placed(MeshBody("box", size=(x, y, z)), middle, turn._triple())


def capsule(middle: Triple, radius: float, half_height: float, turn: Rotator | None = None) -> Body | None:
    """A capsule along its Z in the world; ``half_height`` goes to the tip. None when it is a point."""
    if radius <= NOTHING_CM:
        return None
    body = MeshBody("capsule", size=(radius, 2 * max(0.0, half_height - radius), 0.0))
    return _placed(body, middle, (0.0, 0.0, 0.0) if turn is None else turn._triple())


def _placed(body: MeshBody, middle: Triple, turn: Triple) -> Body | None:
    shape = scaled_shape(body, np.ones(3))
    return None if shape is None else shape.place(rotation_matrix(turn), np.array(middle))


def trace(
    what: str,
    context: Any,
    start: Vector,
    end: Vector,
    seen: Wanted,
    *,
    many: bool,
    all_hits: bool = False,
    shape: Callable[[], Body | None] | None = None,
    sizes: Sequence[float] = (),
) -> Any:
    """A line or swept trace as a call returns it. ``shape`` makes the moved body at the start."""
    found: list[cast.Hit] = []
    if usable(what, context, *start._triple(), *end._triple(), *sizes):
        moving = shape() if shape is not None else None
        if moving is None:
            found = cast.ray(row(start), row(end), seen, many=many, all_hits=all_hits)
        else:
            found = cast.sweep(moving, row(end) - row(start), seen, many=many, all_hits=all_hits)
    return (results.many if many else results.first)(found, start, end)


def is_of(thing: Any, kind: Class | type | None) -> bool:
    """Whether an actor or component is of a class; without one every thing is."""
    if kind is None:
        return True
    wanted_class = as_class(kind)
    return bool(
        thing._class() is wanted_class
        if wanted_class._blueprint
        else subclass_of(type(thing), wanted_class._python_type)
    )
