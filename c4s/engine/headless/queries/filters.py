"""What a query looks for: by trace channel, by object types, or by profile."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable
from dataclasses import dataclass
from typing import Any, TypeAlias

from c4s.engine.headless.queries.channels import BLOCK_ALL, Channel, Response, profile

Answer: TypeAlias = Callable[[Any], Response]
"""How a component answers a query."""


def to_channel(channel: Channel) -> Answer:
    """A trace on a channel: it is what each component answers there."""
    return lambda component: Response(component._answers(channel))


def to_object_types(channels: Iterable[Channel]) -> Answer:
    """A query for objects: those of the types block, others are not seen."""
    wanted = frozenset(channels)
    return lambda component: Response.BLOCK if component._channel() in wanted else Response.IGNORE


def to_profile(name: str) -> Answer:
    """A trace that behaves like an object of a profile; an unknown profile blocks as a static object does."""
    own = profile(name) or BLOCK_ALL
    return lambda component: min(own.response(component._channel()), Response(component._answers(own.channel)))


@dataclass(frozen=True)
class Wanted:
    """A query's filter."""

    answer: Answer
    ignored: Collection[Any] = ()
    """Actors that are not seen."""
    triangles: bool = False
    """Meet the triangles of meshes instead of their collision bodies."""
    only: Any = None
    """The one component that is looked at, when there is one."""

    def sees(self, target: Any) -> Response:
        """How a target answers."""
        if target.actor in self.ignored or (self.only is not None and target.component is not self.only):
            return Response.IGNORE
        return self.answer(target.component)
