"""A real Unreal Editor behind the seam (see docs/unreal.md). This is its face to ``c4s.engine.base``.

``host`` is trusted and stays beside the evaluator; ``boot`` runs inside the editor, beside agent code; ``standin`` is
an executable with the editor's command line for rehearsals.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, Unpack

from c4s.engine.unreal.host.installation import KIND, PINNED
from c4s.errors import BadInput

if TYPE_CHECKING:
    from c4s.engine.finding import EngineFinding
    from c4s.engine.inputs import EngineInputs
    from c4s.engine.unreal.host.session import EditorSession

__all__ = ["asset_paths", "export_glb", "findings", "level_suffix", "open_session", "standin", "version", "warm"]

version = PINNED
level_suffix = ".umap"


def open_session(**given: Unpack[EngineInputs]) -> EditorSession:
    """Start an editor on a project of its own and wait until it serves."""
    from c4s.engine.unreal.host.session import EditorSession

    return EditorSession.start(KIND, **given)


def findings() -> list[EngineFinding]:
    """The editor with its version, its plugins, and the GPUs."""
    from c4s.engine.unreal.host.inspection import findings as found

    return found()


def warm(packs: Sequence[Path]) -> Path:
    """Let an editor load all that the packs hold, so that its shaders are compiled for all later ones."""
    from c4s.engine.unreal.host.warming import warm as fill

    return fill(KIND, packs)


def asset_paths(level: Path) -> list[str]:
    """Paths of the meshes, Blueprint classes and materials that a level document names, sorted."""
    from c4s.records.level import Level

    document = Level.read(level)
    materials = {path for actor in document.actors for part in actor.components for path in part.materials.values()}
    return sorted({path for path in document.made_of() if not path.startswith("/Script/")} | materials)


def export_glb(level: Path, packs: Sequence[Path], glb: Path, *, walk: bool = False) -> dict[str, Any]:
    """``BadInput``: only the editor itself can read what it saved."""
    raise BadInput("a real editor's levels are not written as GLB", where=str(level), todo="use the engine headless")
