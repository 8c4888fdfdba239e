"""Opening a level from a tick ends a real editor, so what would do that is refused once the start level is open."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import unreal

OPENING = {
    "EditorLoadingAndSavingUtils": ("load_map", "new_blank_map", "new_map_from_template", "load_map_with_dialog"),
    "EditorLevelLibrary": ("load_level", "new_level", "new_level_from_template"),
    "LevelEditorSubsystem": ("load_level", "new_level", "new_level_from_template"),
}
"""Functions that open a level, by the class that has them."""


class LevelsStay(RuntimeError):
    """A script asked for another level."""


class Guarded:
    """A class or subsystem of ``unreal`` without the functions that open a level."""

    def __init__(self, real: Any, closed: tuple[str, ...]) -> None:
        self._real, self._closed = real, closed

    def __getattr__(self, name: str) -> Any:
        found = getattr(self._real, name)
        return _refused(name) if name in self._closed else found


def guard_levels() -> None:
    """Refuse to open levels from now on, through the module's classes and through the subsystem."""
    for name, closed in OPENING.items():
        if not name.endswith("Subsystem"):
            setattr(unreal, name, Guarded(getattr(unreal, name), closed))
    find, wanted = unreal.get_editor_subsystem, unreal.LevelEditorSubsystem
    closed = OPENING["LevelEditorSubsystem"]

    def get_editor_subsystem(subsystem: Any) -> Any:
        found = find(subsystem)
        return Guarded(found, closed) if isinstance(found, wanted) else found

    unreal.get_editor_subsystem = get_editor_subsystem


def _refused(name: str) -> Callable[..., Any]:
    def refuse(*_: Any, **__: Any) -> Any:
        raise LevelsStay(f"{name}: this editor stays in its level; edit it, and save it under any name")

    return refuse
