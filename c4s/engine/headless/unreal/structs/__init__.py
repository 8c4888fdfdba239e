"""Unreal's structs. Cm and degrees; ``Rotator(roll, pitch, yaw)``, ``Color(b, g, r, a)``."""

from __future__ import annotations

from c4s.engine.headless.unreal.structs import conversions, directions  # noqa: F401  (they extend structs)
from c4s.engine.headless.unreal.structs.base import ClosedStruct, Later, StructBase
from c4s.engine.headless.unreal.structs.boxes import Box, Box2D, BoxSphereBounds, Guid
from c4s.engine.headless.unreal.structs.colors import Color, LinearColor
from c4s.engine.headless.unreal.structs.grids import IntPoint, IntVector, IntVector2
from c4s.engine.headless.unreal.structs.matrices import Matrix
from c4s.engine.headless.unreal.structs.modes import AxisType, LerpInterpolationMode, MatrixColumns
from c4s.engine.headless.unreal.structs.planes import Vector2D, Vector4
from c4s.engine.headless.unreal.structs.rotations import Quat, Rotator
from c4s.engine.headless.unreal.structs.transforms import IDENTITY_TRANSFORM, Transform
from c4s.engine.headless.unreal.structs.vectors import Plane, Vector

__all__ = [
    "IDENTITY_TRANSFORM",
    "AxisType",
    "Box",
    "Box2D",
    "BoxSphereBounds",
    "ClosedStruct",
    "Color",
    "Guid",
    "IntPoint",
    "IntVector",
    "IntVector2",
    "Later",
    "LerpInterpolationMode",
    "LinearColor",
    "Matrix",
    "MatrixColumns",
    "Plane",
    "Quat",
    "Rotator",
    "StructBase",
    "Transform",
    "Vector",
    "Vector2D",
    "Vector4",
]
