"""The one world of an engine process, for what knows more of it than scripts do: pictures, GLB files, the snapshot."""

from __future__ import annotations

from c4s.engine.headless import editor
from c4s.engine.headless.world.world import World


def world() -> World:
    """The current world; ``MachineryFault`` before ``boot``."""
    current = editor.world()
    if not isinstance(current, World):
        raise TypeError(f"{type(current).__name__} is no World")
    return current
