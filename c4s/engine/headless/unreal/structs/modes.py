"""Choices of mathematical functions."""

from __future__ import annotations

from enum import unique

from c4s.engine.headless.unreal.core import EnumBase, public


@public
@unique
class LerpInterpolationMode(EnumBase):
    """How rotations are mixed."""

    QUAT_INTERP = 0
    EULER_INTERP = 1
    DUAL_QUAT_INTERP = 2


@public
@unique
class AxisType(EnumBase):
    """An axis."""

    NONE = 0
    X = 1
    Y = 2
    Z = 3


@public
@unique
class MatrixColumns(EnumBase):
    """A column of a matrix."""

    FIRST = 0
    SECOND = 1
    THIRD = 2
    FOURTH = 3
