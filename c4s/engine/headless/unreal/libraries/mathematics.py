"""``unreal.MathLibrary``: the functions of the files under ``maths``."""

from __future__ import annotations

import inspect
from collections.abc import Callable
from types import ModuleType
from typing import Any

from c4s.engine.headless.unreal.core import Object, api, public
from c4s.engine.headless.unreal.libraries.maths import chance, geometry, scalars, twins


def _functions(*parts: ModuleType) -> dict[str, Callable[..., Any]]:
    return {name: value for part in parts for name, value in vars(part).items()
            if inspect.isfunction(value) and value.__module__ == part.__name__ and not name.startswith("_")}


@public
class MathLibrary(Object):
    """Mathematics."""


for _name, _function in {**_functions(scalars, geometry, chance, twins), **twins.TWINS}.items():
    setattr(MathLibrary, _name, staticmethod(api(_function)))
