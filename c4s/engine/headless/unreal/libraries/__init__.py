"""Static function libraries and module functions: system, gameplay, mathematics, logging, loading."""

from __future__ import annotations

from c4s.engine.headless.unreal.libraries.module import FUNCTIONS
from c4s.engine.headless.unreal.libraries.ticks import tick, ticking

__all__ = ["FUNCTIONS", "tick", "ticking"]
