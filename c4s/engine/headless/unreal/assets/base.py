"""What all assets have."""

from __future__ import annotations

from typing import Any

from c4s.engine.headless.unreal.containers import Name
from c4s.engine.headless.unreal.core import Object


class AssetObject(Object):
    """An object that is the main object of its package."""

    @classmethod
    def _abstract(cls) -> bool:
        return True

    def _path(self) -> str:
        return str(self._object_path)

    def _changed(self, name: str) -> None:
        self._dirty = True

    def _place(self, path: str, created: bool) -> Any:
        self._object_path = path
        self._created = created
        self._dirty = created
        return self

    @classmethod
    def _at(cls, path: str, *, created: bool = False) -> Any:
        return cls._make(path.rsplit(".", 1)[-1], None)._place(path, created)

    def _metadata(self) -> dict[Name, str]:
        """Metadata tags, kept in memory."""
        found: dict[Name, str] = self.__dict__.setdefault("_tags_in_memory", {})
        return found

    def _references(self) -> list[str]:
        return []
