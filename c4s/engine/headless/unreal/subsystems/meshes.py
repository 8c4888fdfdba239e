"""Static meshes."""

from __future__ import annotations

from c4s.engine.headless.unreal.assets import StaticMesh
from c4s.engine.headless.unreal.core import api, public
from c4s.engine.headless.unreal.enums import CollisionTraceFlag
from c4s.engine.headless.unreal.subsystems.base import EditorSubsystem
from c4s.packs.manifest import HullBody


@public
class StaticMeshEditorSubsystem(EditorSubsystem):
    """Collision of static meshes."""

    _class_module = "StaticMeshEditor"

    @api
    def get_simple_collision_count(self, static_mesh: StaticMesh) -> int:
        """Number of boxes, spheres and capsules."""
        return sum(not isinstance(b, HullBody) for b in static_mesh._asset.collision)

    @api
    def get_convex_collision_count(self, static_mesh: StaticMesh) -> int:
        """Number of convex hulls."""
        return sum(isinstance(b, HullBody) for b in static_mesh._asset.collision)

    @api
    def get_collision_complexity(self, static_mesh: StaticMesh) -> CollisionTraceFlag:
        """Which geometry collides."""
        return CollisionTraceFlag.CTF_USE_DEFAULT

    @api
    def get_number_verts(self, static_mesh: StaticMesh, lod_index: int) -> int:
        """Number of vertices."""
        mesh = static_mesh._geometry()
        return len(mesh.vertices) if mesh is not None else 0

    @api
    def get_number_materials(self, static_mesh: StaticMesh) -> int:
        """Number of slots."""
        return len(static_mesh._asset.slots)

    @api
    def get_lod_count(self, static_mesh: StaticMesh) -> int:
        """Always one level of detail."""
        return 1
