"""Start a headless engine in this process and install its ``unreal`` module."""

from __future__ import annotations

import sys
from collections.abc import Mapping, Sequence
from pathlib import Path
from types import ModuleType
from typing import Any

from c4s.engine.headless.editor import install
from c4s.engine.headless.unreal import build, libraries
from c4s.engine.headless.world.world import World, read_levels
from c4s.errors import BadInput
from c4s.packs.store import PackStore


def boot(
    pack_folders: Sequence[Path],
    content: Path,
    levels: Sequence[Path] = (),
    start_map: str | None = None,
    scratch: Path | None = None,
    offered: Sequence[str] | None = None,
) -> ModuleType:
    """Build the world and install ``unreal`` in ``sys.modules``.

    Args:
        pack_folders: folders that hold a ``pack.json``.
        content: writable root; a level ``/Game/A/B`` lies at ``<content>/Game/A/B.level.json``.
        levels: read-only level documents, known by their own package name.
        start_map: package to open; without it an untitled empty level is open.
        scratch: the project's ``Saved`` folder (default: ``<content>/Saved``); the folder around it is the project's.
        offered: paths of the packs' assets that are there; null for all.

    Raises:
        BadInput: a pack or level is missing or wrong, or there is no such start map.
    """
    content.mkdir(parents=True, exist_ok=True)
    read = read_levels(levels)
    known = {level.package: path for path, level in read.items()}
    world = World(PackStore(pack_folders, offered), content, known, _paint)
    world.scratch = scratch if scratch is not None else content / "Saved"
    install(world)
    module = build()  # before any level: it declares the classes that a level names
    if start_map is not None and world.load_map(start_map, read) is None:
        raise BadInput("no such start map", where=start_map, todo="give its level document in `levels`")
    sys.modules["unreal"] = module
    return module


def _paint(cameras: Sequence[Mapping[str, Any]], files: Sequence[str], mode: str, masks: bool) -> list[dict[str, Any]]:
    """Render the open level; the renderer is loaded with the first picture."""
    from c4s.engine.headless.pictures.take import take

    return take(cameras, files, mode, masks)


def tick(delta_seconds: float) -> None:
    """Call the functions that scripts registered to run after each tick."""
    libraries.tick(delta_seconds)
