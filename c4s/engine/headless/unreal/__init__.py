"""The strict ``unreal`` module of the headless engine. ``build`` gives the module that scripts import."""

from __future__ import annotations

from importlib import import_module
from pkgutil import walk_packages
from types import ModuleType


def build() -> ModuleType:
    """A module ``unreal`` that shows the public names and nothing else."""
    for part in walk_packages(__path__, f"{__name__}."):
        import_module(part.name)
    core, libraries, table = (import_module(f"{__name__}.{part}") for part in ("core", "libraries", "table"))
    made = ModuleType("unreal", "Unreal Editor's Python API, as far as the headless engine provides it.")
    for name, value in {**core.TYPES, **libraries.FUNCTIONS}.items():
        setattr(made, name, value)

    def later(name: str) -> type:
        found: type | None = None if name.startswith("_") else core.TYPES.get(name)
        if found is None:
            raise AttributeError(f"module 'unreal' has no attribute '{name}'")
        setattr(made, name, found)
        return found

    def listed() -> list[str]:
        return sorted({*vars(made), *table.names()} - {"__dir__", "__getattr__"})

    made.__getattr__ = later  # type: ignore[method-assign]
    made.__dir__ = listed  # type: ignore[method-assign]
    return made
