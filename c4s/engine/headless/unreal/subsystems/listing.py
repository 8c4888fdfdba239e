"""All editor subsystems."""

from __future__ import annotations

from c4s.engine.headless.unreal.subsystems.actors import EditorActorSubsystem
from c4s.engine.headless.unreal.subsystems.base import EditorSubsystem
from c4s.engine.headless.unreal.subsystems.editor import UnrealEditorSubsystem
from c4s.engine.headless.unreal.subsystems.levels import LevelEditorSubsystem
from c4s.engine.headless.unreal.subsystems.meshes import StaticMeshEditorSubsystem

SUBSYSTEMS: tuple[type[EditorSubsystem], ...] = (
    EditorActorSubsystem, UnrealEditorSubsystem, LevelEditorSubsystem, StaticMeshEditorSubsystem)
