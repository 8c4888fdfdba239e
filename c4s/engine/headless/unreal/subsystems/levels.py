"""Opening and saving levels."""

from __future__ import annotations

from typing import Any

from c4s.engine.headless.state import world
from c4s.engine.headless.unreal.core import api, public
from c4s.engine.headless.unreal.levels import World
from c4s.engine.headless.unreal.subsystems.base import EditorSubsystem


def open_map(path: str) -> World | None:
    """Open a level by its package path."""
    return world().load_map(str(path))


def new_level_at(path: str) -> bool:
    if world().level_file(str(path).split(".", 1)[0]) is not None:
        world().log.error(f"NewLevel: '{path}' exists already")
        return False
    if world().content_file(str(path).split(".", 1)[0], ".level.json") is None or world().exists(str(path)):
        world().log.error(f"NewLevel: '{path}' cannot be a level")
        return False
    world().new_map(str(path).split(".", 1)[0])
    return world().save_map(str(path))


def save_current() -> bool:
    """Save the open level under its own name; False when it has none yet."""
    return world().save_map(world().package)


@public
class LevelEditorSubsystem(EditorSubsystem):
    """Opening and saving levels."""

    _class_module = "LevelEditor"

    @api
    def load_level(self, asset_path: str) -> bool:
        """Open a level; the current one is closed without saving."""
        return open_map(asset_path) is not None

    @api
    def new_level(self, asset_path: str, is_partitioned_world: bool = False) -> bool:
        """Open and save an empty level."""
        return new_level_at(asset_path)

    @api
    def save_current_level(self) -> bool:
        """Save the open level."""
        return save_current()

    @api
    def save_all_dirty_levels(self) -> bool:
        """Save the open level if it was edited."""
        return save_current() if world().dirty else True

    @api
    def get_current_level(self) -> Any:
        """The open level."""
        return world().map._level

    @api
    def editor_invalidate_viewports(self) -> None:
        """Viewports are drawn on demand here."""
