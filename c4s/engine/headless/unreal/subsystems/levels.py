"""Opening and saving levels."""

from __future__ import annotations

from typing import Any

from c4s.engine.headless.editor import world
from c4s.engine.headless.unreal.actors import Actor
from c4s.engine.headless.unreal.containers import Array, Name
from c4s.engine.headless.unreal.core import api, public
from c4s.engine.headless.unreal.levels import World
from c4s.engine.headless.unreal.subsystems.base import EditorSubsystem
from c4s.packs.store import package_path


def open_map(path: str) -> World | None:
    """Open a level by its package path."""
    return world().load_map(str(path))  # type: ignore[no-any-return]


def new_level_at(path: str) -> bool:
    if world().level_file(package_path(str(path))) is not None:
        world().log.error(f"NewLevel: '{path}' exists already")
        return False
    if world().content_file(package_path(str(path)), ".level.json") is None or world().exists(str(path)):
        world().log.error(f"NewLevel: '{path}' cannot be a level")
        return False
    world().new_map(package_path(str(path)))
    return world().save_map(str(path))


def new_level_like(path: str, template: str) -> bool:
    """Open and save a copy of a level; False, and nothing is opened, when that cannot be."""
    package = package_path(str(path))
    if world().level_file(package_path(str(template))) is None or world().level_file(package) is not None:
        world().log.error(f"NewLevelFromTemplate: '{template}' cannot become '{path}'")
        return False
    return world().load_map(str(template)) is not None and world().save_map(package)


def is_current_level(name: object) -> bool:
    """Whether a name is that of the open level: there is one level, the persistent one."""
    return str(name).casefold() in (world().package.rsplit("/", 1)[-1].casefold(), "persistentlevel", "none")


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

    @api
    def new_level_from_template(self, asset_path: str, template_asset_path: str) -> bool:
        """Open and save a copy of a level."""
        return new_level_like(asset_path, template_asset_path)

    @api
    def set_current_level_by_name(self, level_name: Name | str) -> bool:
        """There is one level, the persistent one."""
        return is_current_level(level_name)

    @api
    def is_in_play_in_editor(self) -> bool:
        """No game is played here."""
        return False

    @api
    def editor_set_game_view(self, game_view: bool, viewport_config_key: Name | str = "None") -> None:
        """Viewports show nothing but the level here."""

    @api
    def editor_get_game_view(self, viewport_config_key: Name | str = "None") -> bool:
        """Viewports show nothing but the level here."""
        return True

    @api
    def editor_set_viewport_realtime(self, realtime: bool, viewport_config_key: Name | str = "None") -> None:
        """Viewports are drawn on demand here."""

    @api
    def get_viewport_config_keys(self) -> Array:
        """The one viewport."""
        return Array._of("Name", [Name("Viewport")])

    @api
    def get_active_viewport_config_key(self) -> Name:
        """The one viewport."""
        return Name("Viewport")

    @api
    def pilot_level_actor(self, actor_to_pilot: Actor, viewport_config_key: Name | str = "None") -> None:
        """Look from where an actor is."""
        world().camera = actor_to_pilot._pose()

    @api
    def eject_pilot_level_actor(self, viewport_config_key: Name | str = "None") -> None:
        """The viewport stays where it is."""
