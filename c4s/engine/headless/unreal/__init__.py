"""The strict ``unreal`` module of the headless engine. ``build`` gives the module that scripts import."""

from __future__ import annotations

from importlib import import_module
from pkgutil import walk_packages
from types import ModuleType


def build() -> ModuleType:
    """A module ``unreal`` that shows the public names and nothing else."""
    for part in walk_packages(__path__, f"{__name__}."):
        import_module(part.name)
    core, libraries = import_module(f"{__name__}.core"), import_module(f"{__name__}.libraries")
    made = ModuleType("unreal", "Unreal Editor's Python API, as far as the headless engine provides it.")
    for name, value in {**core.TYPES, **libraries.FUNCTIONS}.items():
        setattr(made, name, value)
    return made
