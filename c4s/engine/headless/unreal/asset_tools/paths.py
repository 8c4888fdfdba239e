"""Paths of assets, and loading."""

from __future__ import annotations

from typing import Any

from c4s.engine.headless.editor import world
from c4s.packs.store import package_path


def package_of(path: str) -> str:
    """Package of a path in any of the four forms of asset paths."""
    return package_path(str(path))


def load(path: str) -> Any:
    """The asset of a path, or None with a logged warning."""
    found = world().find(path)
    if found is None:
        world().log.warning(f"LoadAsset failed: '{path}' does not exist")
    return found


def in_folder(path: str, folder: str, recursive: bool) -> bool:
    """Whether an asset lies in a folder, or in one below it."""
    folder = folder.rstrip("/")
    parent = package_of(path).rsplit("/", 1)[0]
    return parent == folder or (recursive and parent.startswith(folder + "/"))


def new_object_path(path: str) -> str | None:
    """Object path for a new asset, or None, with the reason logged, where none can be made."""
    package = package_of(path)
    if world().content_file(package, "") is None:
        world().log.error(f"'{path}' is not a package path under /Game/")
        return None
    if world().exists(package) or world().level_file(package) is not None:
        world().log.error(f"'{path}' exists already")
        return None
    return f"{package}.{package.rsplit('/', 1)[-1]}"
