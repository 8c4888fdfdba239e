"""Which state of the level this is: a number that rises with every job that may have changed it.

Any script may change anything, so a job counts unless it is a function that only reads. Code of agents that may run
between jobs, in a tick function or a thread of its own, leaves no number at all.
"""

from __future__ import annotations

import sys
from collections.abc import Mapping
from typing import Any

from c4s.engine.headless.unreal.libraries import ticking

READERS = frozenset(
    {
        "capture.capture_views",
        "capture.take_screenshots",
        "capture.viewport_camera",
        "dependencies.export_dependencies",
        "scene_tools.actor_ids",
        "scene_tools.current_level",
        "scene_tools.find_actors",
        "scene_tools.list_actors",
        "snapshot.export_if_changed",
        "snapshot.export_snapshot",
    }
)
"""Functions of ``c4s.editor`` that change nothing which a snapshot tells."""
OWN_THREADS = 2
"""The one that runs jobs, and the one that hears the host."""

_jobs = 0


def begin(order: Mapping[str, Any]) -> None:
    """Note that a job begins."""
    global _jobs
    if order.get("function") not in READERS:
        _jobs += 1


def revision() -> int | None:
    """The number of the level's state; None when it may change at any moment."""
    if ticking() or len(sys._current_frames()) > OWN_THREADS:
        return None
    return _jobs
