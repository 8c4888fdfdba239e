"""The strict ``unreal`` module of the headless engine. ``build`` gives the module that scripts import."""

from __future__ import annotations

from importlib import import_module
from types import ModuleType

_PARTS = ("core", "structs", "enums", "assets", "components", "lights", "actors", "levels", "subsystems", "expressions",
          "asset_tools", "traces", "paths", "pictures", "subobjects", "libraries")


def build() -> ModuleType:
    """A module ``unreal`` that shows the public names and nothing else."""
    parts = {name: import_module(f"{__name__}.{name}") for name in _PARTS}
    made = ModuleType("unreal", "Unreal Editor's Python API, as far as the headless engine provides it.")
    for name, value in {**parts["core"].TYPES, **parts["libraries"].FUNCTIONS}.items():
        setattr(made, name, value)
    return made
