"""Editor subsystems and the older static libraries with the same functions."""

from __future__ import annotations

from c4s.engine.headless.unreal.subsystems.base import EditorSubsystem

__all__ = ["EditorSubsystem"]
