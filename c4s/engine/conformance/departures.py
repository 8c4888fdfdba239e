"""Where an engine is known to do otherwise, by kind and check, with its reason. One that has ended is a failure."""

from __future__ import annotations

_EDITOR = {
    "a-saved-level-opens-again": "opening a level from a tick ends an editor, so its start script refuses it; "
    "a clean engine opens the level"
}
DEPARTURES: dict[str, dict[str, str]] = {"unreal": _EDITOR, "unreal-standin": _EDITOR}
