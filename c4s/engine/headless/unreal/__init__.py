"""The strict ``unreal`` module of the headless engine. ``build`` gives the module that scripts import."""

from __future__ import annotations

from types import ModuleType


def build() -> ModuleType:
    """A module ``unreal`` that shows the public names and nothing else."""
    from c4s.engine.headless.unreal import core, libraries

    made = ModuleType("unreal", "Unreal Editor's Python API, as far as the headless engine provides it.")
    for name, value in {**core.TYPES, **libraries.FUNCTIONS}.items():
        setattr(made, name, value)
    return made
