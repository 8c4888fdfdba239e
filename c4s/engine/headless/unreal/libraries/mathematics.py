"""``unreal.MathLibrary``: the functions of the files under ``maths``."""

from __future__ import annotations

import inspect
from collections.abc import Callable
from types import ModuleType
from typing import Any

from c4s.engine.headless.unreal.core import Object, api, public
from c4s.engine.headless.unreal.libraries.maths import (
    angles,
    arithmetic,
    chance,
    choices,
    comparisons,
    geometry,
    ranges,
    twins,
)


def _functions(*parts: ModuleType) -> dict[str, Callable[..., Any]]:
    return {
        name: value
        for part in parts
        for name, value in vars(part).items()
        if inspect.isfunction(value) and value.__module__ == part.__name__ and not name.startswith("_")
    }


@public
class MathLibrary(Object):
    """Mathematics."""


_OWN = _functions(arithmetic, ranges, comparisons, angles, geometry, chance, choices, twins)
_ALL = {**_OWN, **twins.TWINS, **chance.OTHER_NAMES}
for _name, _function in _ALL.items():
    setattr(MathLibrary, _name, staticmethod(api(_function)))
