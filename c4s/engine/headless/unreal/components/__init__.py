"""Components: the scene hierarchy, meshes and instanced meshes."""

from __future__ import annotations

from c4s.engine.headless.unreal.components.base import ABSTRACT_COMPONENTS, ActorComponent, of_class
from c4s.engine.headless.unreal.components.frames import Bounds, finite
from c4s.engine.headless.unreal.components.instances import (
    HierarchicalInstancedStaticMeshComponent,
    InstancedStaticMeshComponent,
)
from c4s.engine.headless.unreal.components.meshes import MeshComponent, StaticMeshComponent
from c4s.engine.headless.unreal.components.primitive import PrimitiveComponent
from c4s.engine.headless.unreal.components.scene import SceneComponent

__all__ = [
    "ABSTRACT_COMPONENTS",
    "ActorComponent",
    "Bounds",
    "HierarchicalInstancedStaticMeshComponent",
    "InstancedStaticMeshComponent",
    "MeshComponent",
    "PrimitiveComponent",
    "SceneComponent",
    "StaticMeshComponent",
    "finite",
    "of_class",
]
