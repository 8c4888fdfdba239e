"""Numbers of the tools as values of ``unreal``, and how the tools' scene side refuses. Runs inside an engine."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import Any

import unreal


class SceneRefused(ValueError):
    """What was asked cannot be done; the message is for the agent."""


def rounded(values: Iterable[float]) -> list[float]:
    """Numbers as the tools tell them: four decimals, no negative zero."""
    return [round(float(value), 4) + 0.0 for value in values]


def vector(values: Sequence[float], what: str) -> Any:
    """An ``unreal.Vector`` of three finite numbers; ``what`` names them in the refusal of others."""
    numbers = [float(value) for value in values]
    if len(numbers) != 3 or not all(math.isfinite(value) for value in numbers):
        raise SceneRefused(f"{what} must be three finite numbers")
    return unreal.Vector(*numbers)


def rotator(values: Sequence[float]) -> Any:
    """An ``unreal.Rotator`` of [pitch, yaw, roll] in degrees."""
    numbers = [float(value) for value in values]
    if len(numbers) != 3 or not all(math.isfinite(value) for value in numbers):
        raise SceneRefused("rotation must be three finite numbers [pitch, yaw, roll]")
    return unreal.Rotator(roll=numbers[2], pitch=numbers[0], yaw=numbers[1])


def scale_of(value: float | Sequence[float]) -> Any:
    """An ``unreal.Vector`` of three factors, or of one for all three; none may be 0."""
    factors = [value] * 3 if isinstance(value, (int, float)) else value
    if any(factor == 0 for factor in factors):
        raise SceneRefused("scale must not be 0: an actor without size cannot be seen or undone")
    return vector(factors, "scale")
