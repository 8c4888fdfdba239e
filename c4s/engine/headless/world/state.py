"""The one world of an engine process. The ``unreal`` module speaks of "the" editor, so there is one at a time."""

from __future__ import annotations

from typing import TYPE_CHECKING

from c4s.errors import MachineryFault

if TYPE_CHECKING:
    from c4s.engine.headless.world.world import World

_current: World | None = None


def install(world: World) -> None:
    """Make ``world`` the current one; objects of an earlier one are dead."""
    global _current
    if _current is not None:
        _current.close()
    _current = world


def world() -> World:
    """The current world; ``MachineryFault`` before ``boot``."""
    if _current is None:
        raise MachineryFault(
            "the headless engine has not been booted", todo="call c4s.engine.headless.process.boot.boot"
        )
    return _current
