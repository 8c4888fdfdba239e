"""A level document as a GLB file, read in this process: no script runs, so no engine process is needed."""

from __future__ import annotations

import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from c4s.engine.headless.glb.level import write_glb
from c4s.engine.headless.glb.walkable import walkable_layers
from c4s.engine.headless.process.boot import boot
from c4s.engine.headless.world.documents import references
from c4s.engine.headless.world.state import world
from c4s.records.level import Level


def export(level: Path, packs: Sequence[Path], glb: Path, *, walk: bool = False) -> dict[str, Any]:
    """Write ``level`` to ``glb``: what it holds by count, and under ``unresolved`` the assets that no pack holds.

    With ``walk`` its walkable area too, whose layers are named under ``layers``.
    """
    document = Level.read(level)
    with tempfile.TemporaryDirectory(prefix="c4s-glb-") as folder:
        content = _content_root(level, document.package)
        boot(
            packs,
            content or Path(folder),
            levels=[] if content else [level],
            start_map=document.package,
            scratch=Path(folder) / "Saved",
        )
        unresolved = [path for path in references(document) if world().find(path) is None]
        layers = walkable_layers() if walk else []
        told = write_glb(world(), glb, layers)
        return {**told, "layers": [layer.name for layer in layers], "unresolved": unresolved}


def _content_root(level: Path, package: str) -> Path | None:
    """The writable root that a saved level lies under, with the assets saved beside it; None for a lone document."""
    place, inside = level.resolve(), Path(f"{package[1:]}.level.json")
    return place.parents[len(inside.parts) - 1] if place.parts[-len(inside.parts) :] == inside.parts else None
