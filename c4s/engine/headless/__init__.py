"""The headless engine: c4s's own strict ``unreal`` module over levels that are readable documents (see DESIGN.md).

This is its face to ``c4s.engine.base``. ``host`` is trusted and stays beside the evaluator; ``process`` and all that it
loads run beside agent code.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, Unpack

from c4s.engine.headless.version import ENGINE_VERSION

if TYPE_CHECKING:
    from c4s.engine.finding import EngineFinding
    from c4s.engine.headless.host.session import EngineSession
    from c4s.engine.inputs import EngineInputs

__all__ = [
    "asset_paths",
    "editor",
    "export_glb",
    "findings",
    "host",
    "level_suffix",
    "log",
    "open_session",
    "pictures",
    "unreal",
    "version",
    "warm",
    "world",
]

version = ENGINE_VERSION
level_suffix = ".level.json"


def open_session(**given: Unpack[EngineInputs]) -> EngineSession:
    """Start an engine process in a sandbox and wait until it serves."""
    from c4s.engine.headless.host.session import EngineSession

    return EngineSession.start(**given)


def findings() -> tuple[EngineFinding, ...]:
    """Nothing beside the default install and a sandbox."""
    return ()


def warm(packs: Sequence[Path]) -> Path:
    """Compile the kernels of the renderer; packs need nothing."""
    from c4s.engine.headless.host.kernels import compiled

    return compiled()


def asset_paths(level: Path) -> list[str]:
    """Paths of all assets and Blueprint classes that a level document names, sorted."""
    from c4s.engine.headless.world.documents import references
    from c4s.records.level import Level

    return references(Level.read(level))


def export_glb(level: Path, packs: Sequence[Path], glb: Path, *, walk: bool = False) -> dict[str, Any]:
    """Write a level document as one GLB in this process; ``unresolved`` lists the assets that no pack holds."""
    from c4s.engine.headless.glb.export import export

    return export(level, packs, glb, walk=walk)
