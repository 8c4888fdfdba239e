"""The stand-in's world: levels and assets in package files of a project's ``Content``, and an editor's weak spots."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from types import MappingProxyType

from c4s.engine.headless.unreal.levels import World as MapObject
from c4s.engine.headless.world.world import UNTITLED, Painter, World
from c4s.engine.unreal.standin.log import EditorLog
from c4s.packs.store import PackStore
from c4s.records.level import Level

_SUFFIXES = {".level.json": ".umap", ".asset.json": ".uasset"}
IN_TICK = "Assertion failed: !GIsSlateTicking [File:Editor/EditorServer.cpp] a level was opened from a Slate tick"


class EditorWorld(World):
    """A world whose packages lie as an editor's do."""

    def __init__(self, store: PackStore, content: Path, painter: Painter, log: EditorLog) -> None:
        super().__init__(store, content, {}, painter)
        self.log = log
        self.in_tick = False
        self.crash: Callable[[str], None] = lambda why: None
        """How the editor ends when it does what ends an editor."""
        self.torn_saves = False
        """Whether a save is cut short by the end of the editor."""

    def content_file(self, package: str, suffix: str) -> Path | None:
        """File of a package below ``Content``; None for one of a pack, which is a link."""
        found = super().content_file(package, suffix)
        if found is None:
            return None
        name = found.relative_to(self.content / "Game").as_posix()
        file = self.content / f"{name.removesuffix(suffix)}{_SUFFIXES.get(suffix, suffix)}"
        return None if file.is_symlink() else file

    def load_map(self, package: str, read: Mapping[Path, Level] = MappingProxyType({})) -> MapObject | None:
        """Open a level; from a tick that is the end."""
        self._not_in_tick()
        return super().load_map(package, read)

    def new_map(self, package: str = UNTITLED) -> MapObject:
        """Open an empty level; from a tick that is the end."""
        self._not_in_tick()
        return super().new_map(package)

    def save_map(self, package: str) -> bool:
        """Save the open level."""
        saved = super().save_map(package)
        file = self.content_file(self.package, ".level.json")
        if saved and self.torn_saves and file is not None:
            data = file.read_bytes()
            file.write_bytes(data[: len(data) // 2])
            self.crash("the disk went away while a package was written")
        return saved

    def _not_in_tick(self) -> None:
        if self.in_tick:
            self.crash(IN_TICK)
