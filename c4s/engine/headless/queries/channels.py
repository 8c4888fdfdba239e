"""Unreal's collision channels, responses and the profiles of a fresh project (the engine's default settings)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import IntEnum
from types import MappingProxyType


class Channel(IntEnum):
    """Object and trace channels in Unreal's order."""

    WORLD_STATIC = 0
    WORLD_DYNAMIC = 1
    PAWN = 2
    VISIBILITY = 3
    CAMERA = 4
    PHYSICS_BODY = 5
    VEHICLE = 6
    DESTRUCTIBLE = 7


class Response(IntEnum):
    """How one side answers a channel; of two sides the smaller counts."""

    IGNORE = 0
    OVERLAP = 1
    BLOCK = 2


OBJECT_TYPES = (
    Channel.WORLD_STATIC,
    Channel.WORLD_DYNAMIC,
    Channel.PAWN,
    Channel.PHYSICS_BODY,
    Channel.VEHICLE,
    Channel.DESTRUCTIBLE,
)
"""Channels of ``ObjectTypeQuery`` 1 to 6."""
TRACE_TYPES = (Channel.VISIBILITY, Channel.CAMERA)
"""Channels of ``TraceTypeQuery`` 1 and 2."""


@dataclass(frozen=True)
class Profile:
    """A collision profile: the object's own channel, whether queries see it, and its answers (else it blocks)."""

    channel: Channel
    enabled: str = "QUERY_AND_PHYSICS"
    """Member of ``CollisionEnabled``."""
    responses: Mapping[Channel, Response] = field(default_factory=lambda: MappingProxyType({}))

    def response(self, channel: Channel) -> Response:
        """Its answer to a channel."""
        return self.responses.get(channel, Response.BLOCK)


_OBJECTS_AND_CAMERA: dict[Channel, Response] = dict.fromkeys(set(Channel) - {Channel.VISIBILITY}, Response.OVERLAP)
_ALL = dict.fromkeys(Channel, Response.OVERLAP)
_UNSEEN = {Channel.VISIBILITY: Response.IGNORE}
_NO_PAWNS = {Channel.PAWN: Response.IGNORE, Channel.VEHICLE: Response.IGNORE}

BLOCK_ALL = Profile(Channel.WORLD_STATIC)
PROFILES: dict[str, Profile] = {
    "nocollision": Profile(Channel.WORLD_STATIC, "NO_COLLISION", {**_UNSEEN, Channel.CAMERA: Response.IGNORE}),
    "blockall": BLOCK_ALL,
    "overlapall": Profile(Channel.WORLD_STATIC, "QUERY_ONLY", _ALL),
    "blockalldynamic": Profile(Channel.WORLD_DYNAMIC),
    "overlapalldynamic": Profile(Channel.WORLD_DYNAMIC, "QUERY_ONLY", _ALL),
    "ignoreonlypawn": Profile(Channel.WORLD_DYNAMIC, "QUERY_ONLY", _NO_PAWNS),
    "overlaponlypawn": Profile(
        Channel.WORLD_DYNAMIC,
        "QUERY_ONLY",
        {Channel.PAWN: Response.OVERLAP, Channel.VEHICLE: Response.OVERLAP, Channel.CAMERA: Response.IGNORE},
    ),
    "pawn": Profile(Channel.PAWN, responses=_UNSEEN),
    "spectator": Profile(
        Channel.PAWN,
        "QUERY_ONLY",
        {channel: Response.IGNORE for channel in Channel if channel is not Channel.WORLD_STATIC},
    ),
    "charactermesh": Profile(Channel.PAWN, "QUERY_ONLY", {**_NO_PAWNS, **_UNSEEN}),
    "physicsactor": Profile(Channel.PHYSICS_BODY),
    "destructible": Profile(Channel.DESTRUCTIBLE),
    "invisiblewall": Profile(Channel.WORLD_STATIC, responses=_UNSEEN),
    "invisiblewalldynamic": Profile(Channel.WORLD_DYNAMIC, responses=_UNSEEN),
    "trigger": Profile(Channel.WORLD_DYNAMIC, "QUERY_ONLY", {**_OBJECTS_AND_CAMERA, **_UNSEEN}),
    "ragdoll": Profile(Channel.PHYSICS_BODY, responses={Channel.PAWN: Response.IGNORE, **_UNSEEN}),
    "vehicle": Profile(Channel.VEHICLE),
    "ui": Profile(Channel.WORLD_DYNAMIC, "QUERY_ONLY", _OBJECTS_AND_CAMERA),
}
"""By lower-case name: Unreal compares names without case."""


def profile(name: str) -> Profile | None:
    """A profile by its name, or None."""
    return PROFILES.get(name.casefold())
