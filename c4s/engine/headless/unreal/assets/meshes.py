"""Static meshes."""

# ruff: noqa: RUF012  (each class declares its table of properties; no table is ever changed)

from __future__ import annotations

from typing import Any

from c4s.engine.headless.editor import world
from c4s.engine.headless.pose import Pose
from c4s.engine.headless.unreal.assets.base import AssetObject
from c4s.engine.headless.unreal.assets.collision import BodySetup, aggregate
from c4s.engine.headless.unreal.assets.descriptions import StaticMeshDescription, StaticMeshSocket
from c4s.engine.headless.unreal.assets.materials import MaterialInterface
from c4s.engine.headless.unreal.containers import Array, Name
from c4s.engine.headless.unreal.core import Object, Prop, api, public
from c4s.engine.headless.unreal.structs import Box, BoxSphereBounds, ClosedStruct, Vector
from c4s.packs.meshes import Mesh
from c4s.records.pack import Asset


@public
class StaticMaterial(ClosedStruct):
    """A slot of a static mesh."""

    _fields = {
        "material_interface": Prop("MaterialInterface | None", None),
        "material_slot_name": Prop("Name", Name),
        "imported_material_slot_name": Prop("Name", Name, attribute=False),
    }
    _takes = 2


@public
class StaticMesh(AssetObject):
    """A static mesh asset."""

    _declares = {
        "static_materials": Prop("Sequence[StaticMaterial]", get="_static_materials", writable=False),
        "body_setup": Prop("BodySetup", get="_body_setup", attribute=False, writable=False),
    }

    def _start(self, name: str, outer: Object | None) -> None:
        super()._start(name, outer)
        self._slot_overrides: dict[int, MaterialInterface] = {}

    def _bind(self, asset: Asset) -> Any:
        self._asset = asset
        return self

    def _geometry(self) -> Mesh | None:
        """Triangles, of the original where this is a copy; None when no pack holds that any more."""
        store = world().store
        return store.mesh(self._asset.path) if store.asset(self._asset.path) is not None else None

    def _slot_material(self, index: int) -> MaterialInterface | None:
        slots = self._asset.slots
        if not 0 <= index < len(slots):
            return None
        if index in self._slot_overrides:
            return self._slot_overrides[index]
        found = world().find(slots[index].material)
        return found if isinstance(found, MaterialInterface) else None

    def _static_materials(self) -> Array:
        return Array._of(
            "StaticMaterial",
            [
                StaticMaterial._of_fields(self._slot_material(i), Name(slot.name), Name(slot.name))
                for i, slot in enumerate(self._asset.slots)
            ],
        )

    def _body_setup(self) -> BodySetup:
        made: BodySetup = BodySetup._make("BodySetup_0", self)
        made._values["agg_geom"] = aggregate(self._asset)
        return made

    def _references(self) -> list[str]:
        """What its slots show; of a copy also the original, where that is missing and there is nothing to show."""
        lost = [] if world().store.asset(self._asset.path) is not None else [self._asset.path]
        return lost + [
            self._slot_overrides[i]._path() if i in self._slot_overrides else slot.material
            for i, slot in enumerate(self._asset.slots)
        ]

    @api
    def get_material(self, material_index: int) -> MaterialInterface | None:
        """Default material of a slot."""
        return self._slot_material(material_index)

    @api
    def set_material(self, material_index: int, new_material: MaterialInterface | None) -> None:
        """Set the default material of a slot of a created mesh; meshes of packs are read-only."""
        if not self._created:
            world().log.error(f"'{self._path()}' is read-only")
        elif new_material is not None and 0 <= material_index < len(self._asset.slots):
            self._slot_overrides[material_index] = new_material
            self._dirty = True

    @api
    def get_num_vertices(self, lod_index: int) -> int:
        """Vertices of the mesh."""
        mesh = self._geometry()
        return len(mesh.vertices) if mesh is not None and lod_index == 0 else 0

    @api
    def get_material_index(self, material_slot_name: Name | str) -> int:
        """Index of a slot by name, -1 when there is none."""
        for index, slot in enumerate(self._asset.slots):
            if slot.name.casefold() == str(material_slot_name).casefold():
                return index
        return -1

    @api
    def get_bounding_box(self) -> Box:
        """Local bounds as corners (cm)."""
        return Box(Vector(*self._asset.bounds_min_cm), Vector(*self._asset.bounds_max_cm))

    @api
    def get_bounds(self) -> BoxSphereBounds:
        """Local bounds as centre, half extent and radius (cm)."""
        low, high = self._asset.bounds_min_cm, self._asset.bounds_max_cm
        origin, extent = Pose((0, 0, 0), (0, 0, 0, 1), (1, 1, 1)).box(low, high)
        half = Vector(*extent)
        return BoxSphereBounds(Vector(*origin), half, half.length())

    @api
    def get_num_lods(self) -> int:
        """Always one level of detail."""
        return 1

    @api
    def get_num_triangles(self, lod_index: int) -> int:
        """Triangles of the mesh."""
        mesh = self._geometry()
        return len(mesh.faces) if mesh is not None and lod_index == 0 else 0

    @api
    def get_num_sections(self, lod: int) -> int:
        """Sections: one a slot."""
        return len(self._asset.slots) if lod == 0 else 0

    @api
    def get_static_mesh_description(self, lod_index: int) -> StaticMeshDescription | None:
        """The geometry of the one level of detail; None for another, or where no pack holds it any more."""
        mesh = self._geometry() if lod_index == 0 else None
        if mesh is None:
            return None
        made: StaticMeshDescription = StaticMeshDescription._make("StaticMeshDescription_0", self)
        return made._bind(mesh, len(self._asset.slots))  # type: ignore[no-any-return]

    @api
    def find_socket(self, socket_name: Name | str) -> StaticMeshSocket | None:
        """None: meshes here have no sockets."""
        return None

    @api
    def get_sockets_by_tag(self, socket_tag: str) -> Array:
        """None: meshes here have no sockets."""
        return Array._of("StaticMeshSocket", [])
