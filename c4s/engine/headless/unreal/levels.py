"""The world and level objects of the open map."""

from __future__ import annotations

from typing import Any

from c4s.engine.headless.editor import world
from c4s.engine.headless.unreal.actors.settings import WorldSettings
from c4s.engine.headless.unreal.assets import AssetObject
from c4s.engine.headless.unreal.core import Object, api, public


@public
class Level(Object):
    """The persistent level."""

    def _path(self) -> str:
        return f"{world().map_path()}:PersistentLevel"


@public
class World(AssetObject):
    """The open map."""

    def _path(self) -> str:
        return str(self._object_path)

    def _lay(self) -> Any:
        self._level = Level._make("PersistentLevel", self)
        self._settings = WorldSettings._make("WorldSettings", self._level)
        return self

    @api
    def get_world_settings(self) -> WorldSettings:
        """How the level plays."""
        settings: WorldSettings = self._settings
        return settings
