"""Static meshes."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, TypeVar

from c4s.engine.headless.editor import world
from c4s.engine.headless.unreal.actors import Actor, StaticMeshActor
from c4s.engine.headless.unreal.assets import MaterialInterface, StaticMesh
from c4s.engine.headless.unreal.components import MeshComponent, StaticMeshComponent
from c4s.engine.headless.unreal.core import Object, api, deprecated, public
from c4s.engine.headless.unreal.enums import CollisionTraceFlag
from c4s.engine.headless.unreal.subsystems.base import EditorSubsystem
from c4s.engine.headless.unreal.subsystems.replacing import parts_of, replace_materials, replace_meshes
from c4s.records.pack import HullBody

if TYPE_CHECKING:  # types of the table
    from typing import Any as JoinStaticMeshActorsOptions
    from typing import Any as MergeStaticMeshActorsOptions
    from typing import Any as ScriptCollisionShapeType

_R = TypeVar("_R")


@public
class StaticMeshEditorSubsystem(EditorSubsystem):
    """Collision of static meshes."""

    _class_module = "StaticMeshEditor"

    @api
    def get_simple_collision_count(self, static_mesh: StaticMesh) -> int:
        """Number of boxes, spheres and capsules."""
        return _counts(static_mesh)[0]

    @api
    def get_convex_collision_count(self, static_mesh: StaticMesh) -> int:
        """Number of convex hulls."""
        return _counts(static_mesh)[1]

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

    @api
    def add_simple_collisions(self, static_mesh: StaticMesh, shape_type: ScriptCollisionShapeType) -> int:
        """Not offered: -1, and the log says so."""
        return _refused("AddSimpleCollisions", static_mesh, -1)

    @api
    def remove_collisions(self, static_mesh: StaticMesh) -> bool:
        """Not offered: False, and the log says so."""
        return _refused("RemoveCollisions", static_mesh, False)

    @api
    def set_convex_decomposition_collisions(
        self, static_mesh: StaticMesh, hull_count: int, max_hull_verts: int, hull_precision: int
    ) -> bool:
        """Not offered: False, and the log says so."""
        return _refused("SetConvexDecompositionCollisions", static_mesh, False)

    @api
    def merge_static_mesh_actors(
        self, actors_to_merge: Sequence[StaticMeshActor], merge_options: MergeStaticMeshActorsOptions
    ) -> StaticMeshActor | None:
        """Not offered: None, and the log says so."""
        _unmerged("MergeStaticMeshActors")
        return None

    @api
    def join_static_mesh_actors(
        self, actors_to_join: Sequence[StaticMeshActor], join_options: JoinStaticMeshActorsOptions
    ) -> Actor | None:
        """Not offered: None, and the log says so."""
        _unmerged("JoinStaticMeshActors")
        return None

    @api
    def replace_mesh_components_meshes(
        self,
        mesh_components: Sequence[StaticMeshComponent],
        mesh_to_be_replaced: StaticMesh | None,
        new_mesh: StaticMesh | None,
    ) -> None:
        """Show another mesh where components show one (or any, without one)."""
        replace_meshes(mesh_components, mesh_to_be_replaced, new_mesh)

    @api
    def replace_mesh_components_meshes_on_actors(
        self, actors: Sequence[Actor], mesh_to_be_replaced: StaticMesh | None, new_mesh: StaticMesh | None
    ) -> None:
        """Show another mesh where actors show one (or any, without one)."""
        replace_meshes(parts_of(actors), mesh_to_be_replaced, new_mesh)

    @api
    def replace_mesh_components_materials(
        self,
        mesh_components: Sequence[MeshComponent],
        material_to_be_replaced: MaterialInterface | None,
        new_material: MaterialInterface | None,
    ) -> None:
        """Use another material where components use one (or any, without one)."""
        replace_materials(mesh_components, material_to_be_replaced, new_material)

    @api
    def replace_mesh_components_materials_on_actors(
        self,
        actors: Sequence[Actor],
        material_to_be_replaced: MaterialInterface | None,
        new_material: MaterialInterface | None,
    ) -> None:
        """Use another material where actors use one (or any, without one)."""
        replace_materials(parts_of(actors), material_to_be_replaced, new_material)


_OLD = "The Editor Scripting Utilities Plugin is deprecated - Use the function in Static Mesh Editor Subsystem"


def _refused(what: str, static_mesh: StaticMesh, empty: _R) -> _R:
    world().log.error(f"{what}: the headless engine edits no collision, '{static_mesh._path()}' stays as it is")
    return empty


def _unmerged(what: str) -> None:
    world().log.error(f"{what}: the headless engine merges no meshes, all actors stay as they are")


def _counts(static_mesh: StaticMesh) -> tuple[int, int]:
    """Simple bodies and convex hulls."""
    hulls = sum(isinstance(body, HullBody) for body in static_mesh._asset.collision)
    return len(static_mesh._asset.collision) - hulls, hulls


@public
class EditorStaticMeshLibrary(Object):
    """The older home of the subsystem's functions."""

    _class_module = "EditorScriptingUtilities"

    @classmethod
    @deprecated(_OLD)
    @api
    def get_simple_collision_count(cls, static_mesh: StaticMesh) -> int:
        """Number of boxes, spheres and capsules."""
        return _counts(static_mesh)[0]

    @classmethod
    @deprecated(_OLD)
    @api
    def get_convex_collision_count(cls, static_mesh: StaticMesh) -> int:
        """Number of convex hulls."""
        return _counts(static_mesh)[1]

    @classmethod
    @deprecated(_OLD)
    @api
    def get_collision_complexity(cls, static_mesh: StaticMesh) -> CollisionTraceFlag:
        """Which geometry collides."""
        return CollisionTraceFlag.CTF_USE_DEFAULT

    @classmethod
    @deprecated(_OLD)
    @api
    def get_number_verts(cls, static_mesh: StaticMesh, lod_index: int) -> int:
        """Number of vertices."""
        mesh = static_mesh._geometry()
        return len(mesh.vertices) if mesh is not None else 0

    @classmethod
    @deprecated(_OLD)
    @api
    def get_number_materials(cls, static_mesh: StaticMesh) -> int:
        """Number of slots."""
        return len(static_mesh._asset.slots)

    @classmethod
    @deprecated(_OLD)
    @api
    def get_lod_count(cls, static_mesh: StaticMesh) -> int:
        """Always one level of detail."""
        return 1

    @classmethod
    @deprecated(_OLD)
    @api
    def add_simple_collisions(cls, static_mesh: StaticMesh, shape_type: ScriptCollisionShapeType) -> int:
        """Not offered: -1, and the log says so."""
        return _refused("AddSimpleCollisions", static_mesh, -1)

    @classmethod
    @deprecated(_OLD)
    @api
    def remove_collisions(cls, static_mesh: StaticMesh) -> bool:
        """Not offered: False, and the log says so."""
        return _refused("RemoveCollisions", static_mesh, False)

    @classmethod
    @deprecated(_OLD)
    @api
    def set_convex_decomposition_collisions(
        cls, static_mesh: StaticMesh, hull_count: int, max_hull_verts: int, hull_precision: int
    ) -> bool:
        """Not offered: False, and the log says so."""
        return _refused("SetConvexDecompositionCollisions", static_mesh, False)
