"""Unreal's structs: values, never references. Cm and degrees; ``Rotator(roll, pitch, yaw)``, ``Color(b, g, r, a)``."""

from __future__ import annotations

from c4s.engine.headless.unreal.structs.base import ClosedStruct, StructBase
from c4s.engine.headless.unreal.structs.boxes import Box, BoxSphereBounds, Guid
from c4s.engine.headless.unreal.structs.colors import Color, LinearColor
from c4s.engine.headless.unreal.structs.rotations import Quat, Rotator
from c4s.engine.headless.unreal.structs.transforms import IDENTITY_TRANSFORM, Transform
from c4s.engine.headless.unreal.structs.vectors import Vector, Vector2D, Vector4

__all__ = [
    "IDENTITY_TRANSFORM", "Box", "BoxSphereBounds", "ClosedStruct", "Color", "Guid", "LinearColor", "Quat",
    "Rotator", "StructBase", "Transform", "Vector", "Vector2D", "Vector4",
]
