"""Channels and responses as Unreal's enums."""

from __future__ import annotations

from enum import unique

from c4s.engine.headless.unreal.core import EnumBase, public


@public
class ObjectTypeQuery(EnumBase):
    """Object types: world static, world dynamic, pawn, physics body, vehicle, destructible; by 5.8's names too."""

    OBJECT_TYPE_QUERY1 = 0
    OBJECT_TYPE_QUERY2 = 1
    OBJECT_TYPE_QUERY3 = 2
    OBJECT_TYPE_QUERY4 = 3
    OBJECT_TYPE_QUERY5 = 4
    OBJECT_TYPE_QUERY6 = 5
    ECC_WORLD_STATIC = 0
    ECC_WORLD_DYNAMIC = 1
    ECC_PAWN = 2
    ECC_PHYSICS_BODY = 3
    ECC_VEHICLE = 4
    ECC_DESTRUCTIBLE = 5


@public
@unique
class CollisionChannel(EnumBase):
    """Object and trace channels."""

    ECC_WORLD_STATIC = 0
    ECC_WORLD_DYNAMIC = 1
    ECC_PAWN = 2
    ECC_VISIBILITY = 3
    ECC_CAMERA = 4
    ECC_PHYSICS_BODY = 5
    ECC_VEHICLE = 6
    ECC_DESTRUCTIBLE = 7


@public
@unique
class CollisionResponseType(EnumBase):
    """How a component answers a channel."""

    ECR_IGNORE = 0
    ECR_OVERLAP = 1
    ECR_BLOCK = 2
