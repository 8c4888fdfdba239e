"""What the packs of a case hold of the meshes and materials that a snapshot names."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache, lru_cache
from pathlib import Path
from typing import Any, Final

from c4s.files import digest_file
from c4s.home import packs_root
from c4s.packs.meshes import Mesh
from c4s.packs.store import PackStore
from c4s.records.pack import MANIFEST, Material
from c4s.records.suite import AgentCase

STORES_KEPT: Final = 8


class Content:
    """The packs of a case that are on this machine."""

    def __init__(self, folders: tuple[Path, ...]) -> None:
        self._store = PackStore(folders)

    def mesh(self, path: str, facts: Mapping[str, Any]) -> Mesh | None:
        """The mesh that a snapshot shows under a path (``SceneFacts.meshes``); None where no pack has it."""
        return self._store.recorded_mesh(path, facts)

    def material(self, path: str) -> Material | None:
        """The material of a path; None where no pack has it."""
        return self._store.material(path)

    def texture(self, material: Material) -> tuple[str, Path] | None:
        """The base-colour picture of a material: its SHA-256 and its file; None where it has none."""
        file = self._store.texture_file(material)
        return (_digest(file), file) if file is not None and file.is_file() else None


@lru_cache(STORES_KEPT)
def _opened(folders: tuple[Path, ...]) -> Content:
    return Content(folders)


@cache
def _digest(file: Path) -> str:
    return digest_file(file)


def content_of(case: AgentCase) -> Content:
    """The packs of a case, read once. Packs that are not here are left out."""
    folders = (packs_root() / pack.pack_id for pack in case.packs)
    return _opened(tuple(folder for folder in folders if (folder / MANIFEST).is_file()))
