"""Engines behind one seam: ``open_engine`` starts one, ``Engine`` is what may be used of it (see DESIGN.md)."""

from c4s.engine.base import (
    DEFAULT_ENGINE,
    Calls,
    Engine,
    EngineCallError,
    EngineDied,
    backend,
    engine_kinds,
    open_engine,
)

__all__ = [
    "DEFAULT_ENGINE",
    "Calls",
    "Engine",
    "EngineCallError",
    "EngineDied",
    "answers",
    "backend",
    "bridge",
    "channel",
    "confine",
    "conformance",
    "content",
    "engine_kinds",
    "host",
    "inputs",
    "inside",
    "open_engine",
]
