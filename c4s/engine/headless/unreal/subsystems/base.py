"""What all editor subsystems have."""

from __future__ import annotations

from c4s.engine.headless.unreal.core import Object, public


@public
class EditorSubsystem(Object):
    """Base of editor subsystems."""

    _class_module = "EditorSubsystem"
