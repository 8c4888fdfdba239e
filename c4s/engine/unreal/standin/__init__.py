"""A stand-in for Epic's editor: its command line, its log, its crashes, around c4s's own ``unreal`` module.

It makes all that c4s does around an editor testable where there is none, and lets an operator rehearse a fleet of
workers before the first real one. ``python -m c4s.engine.unreal.standin`` installs it and makes content for it. It is a
kind of engine of its own, ``unreal-standin``, and says so in its version: nothing that it made is taken for Unreal's.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Unpack

from c4s.engine.unreal import asset_paths, export_glb, level_suffix
from c4s.engine.unreal.host.installation import PINNED, STAND_IN_KIND

if TYPE_CHECKING:
    from c4s.engine.finding import EngineFinding
    from c4s.engine.inputs import EngineInputs
    from c4s.engine.unreal.host.session import EditorSession

__all__ = [
    "asset_paths",
    "content",
    "export_glb",
    "findings",
    "install",
    "level_suffix",
    "open_session",
    "version",
    "warm",
]

version = f"{PINNED}-standin"


def findings() -> tuple[EngineFinding, ...]:
    """Nothing: it is for rehearsals."""
    return ()


def warm(packs: Sequence[Path]) -> Path:
    """Go through what a real editor would."""
    from c4s.engine.unreal.host.warming import warm as fill

    return fill(STAND_IN_KIND, packs)


def open_session(**given: Unpack[EngineInputs]) -> EditorSession:
    """Start a stand-in on a project of its own and wait until it serves."""
    from c4s.engine.unreal.host.session import EditorSession

    return EditorSession.start(STAND_IN_KIND, **given)
