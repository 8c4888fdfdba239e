"""Which actors moved or changed since the queries last looked. Any change of an actor is noted here."""

from __future__ import annotations

from typing import Any

_changed: dict[Any, None] = {}


def note(actor: Any) -> None:
    """Note that an actor's place, shape or collision may be another."""
    _changed[actor] = None


def taken() -> list[Any]:
    """The actors noted so far, in the order of their first change; they are forgotten here."""
    found = list(_changed)
    _changed.clear()
    return found
