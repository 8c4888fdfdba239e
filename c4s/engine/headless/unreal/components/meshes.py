"""Components with material slots."""

# ruff: noqa: RUF012  (each class declares its table of properties; no table is ever changed)

from __future__ import annotations

from c4s.engine.headless.unreal.assets import MaterialInstanceDynamic, MaterialInterface, StaticMesh
from c4s.engine.headless.unreal.components.frames import Bounds
from c4s.engine.headless.unreal.components.primitive import PrimitiveComponent
from c4s.engine.headless.unreal.containers import Array, Name
from c4s.engine.headless.unreal.core import Object, Prop, api, public, with_setters
from c4s.engine.headless.unreal.kept import KEPT
from c4s.engine.headless.unreal.setters import SETTERS
from c4s.engine.headless.unreal.structs import LinearColor, Vector


@public
class MeshComponent(PrimitiveComponent):
    """A component with material slots."""

    _declares = {
        "override_materials": Prop(
            "Sequence[MaterialInterface | None]", get="_override_array", writable=False, attribute=False, saved=False
        )
    }

    def _start(self, name: str, outer: Object | None) -> None:
        super()._start(name, outer)
        self._materials: dict[int, MaterialInterface] = {}

    def _slot_count(self) -> int:
        return 0

    def _default_material(self, index: int) -> MaterialInterface | None:
        return None

    def _material(self, index: int) -> MaterialInterface | None:
        override = self._materials.get(index)
        if override is not None and not override._dead:
            return override
        return self._default_material(index) if 0 <= index < self._slot_count() else None

    def _swap_material(self, slot: int, old: object, new: MaterialInterface | None) -> None:
        """Use ``new`` where a slot, or the dynamic instance on it, used ``old``."""
        used = self._materials[slot]
        if used is not old:
            used._values["parent"] = new
        elif new is None:
            del self._materials[slot]
        else:
            self._materials[slot] = new
        self._changed("override_materials")

    def _override_array(self) -> Array:
        size = max(self._materials, default=-1) + 1
        return Array._of("MaterialInterface | None", [self._materials.get(i) for i in range(size)])

    @api
    def get_num_materials(self) -> int:
        """Number of slots."""
        return self._slot_count()

    @api
    def get_material(self, element_index: int) -> MaterialInterface | None:
        """Override or the mesh's default."""
        return self._material(element_index)

    @api
    def get_materials(self) -> Array:
        """Material of each slot."""
        return Array._of("MaterialInterface | None", [self._material(i) for i in range(self._slot_count())])

    @api
    def set_material(self, element_index: int, material: MaterialInterface | None) -> None:
        """Override the material of a slot; None takes the override away."""
        if element_index < 0:
            return
        if material is None:
            self._materials.pop(element_index, None)
        else:
            self._materials[element_index] = material
        self._changed("override_materials")

    @api
    def get_material_index(self, material_slot_name: Name | str) -> int:
        """Index of a slot by name, -1 when there is none."""
        names = [str(n).casefold() for n in self.get_material_slot_names()]
        wanted = str(material_slot_name).casefold()
        return names.index(wanted) if wanted in names else -1

    @api
    def get_material_slot_names(self) -> Array:
        """Names of the slots."""
        return Array._of("Name", [])

    @api
    def set_material_by_name(self, material_slot_name: Name | str, material: MaterialInterface | None) -> None:
        """Override the material of a slot by its name."""
        index = self.get_material_index(material_slot_name)
        if index >= 0:
            self.set_material(index, material)

    @api
    def create_dynamic_material_instance(
        self, element_index: int, source_material: MaterialInterface | None = None, optional_name: Name | str = "None"
    ) -> MaterialInstanceDynamic | None:
        """Put a dynamic instance, owned by this component, on a slot."""
        source = source_material if source_material is not None else self._material(element_index)
        if source is None:
            return None
        taken = {m._name for m in self._materials.values()}
        serial = 0
        while f"MaterialInstanceDynamic_{serial}" in taken:
            serial += 1
        name = f"MaterialInstanceDynamic_{serial}" if str(optional_name) == "None" else str(optional_name)
        made: MaterialInstanceDynamic = MaterialInstanceDynamic._owned(name, self, source)
        self.set_material(element_index, made)
        return made

    def _dynamic_instances(self) -> list[MaterialInstanceDynamic]:
        """The dynamic instance on each slot that has a material; made where there is none."""
        found = []
        for index in range(self._slot_count()):
            used = self._material(index)
            made = used if isinstance(used, MaterialInstanceDynamic) else self.create_dynamic_material_instance(index)
            found += [made] if made is not None else []
        return found

    @api
    def set_vector_parameter_value_on_materials(self, parameter_name: Name | str, parameter_value: Vector) -> None:
        """Set a vector parameter on all slots, by dynamic instances of their materials."""
        value = LinearColor(parameter_value.x, parameter_value.y, parameter_value.z, 1.0)
        for material in self._dynamic_instances():
            material._set_vector(parameter_name, value)

    @api
    def set_color_parameter_value_on_materials(self, parameter_name: Name | str, parameter_value: LinearColor) -> None:
        """Set a colour parameter on all slots, by dynamic instances of their materials."""
        for material in self._dynamic_instances():
            material._set_vector(parameter_name, parameter_value)

    @api
    def set_scalar_parameter_value_on_materials(self, parameter_name: Name | str, parameter_value: float) -> None:
        """Set a scalar parameter on all slots, by dynamic instances of their materials."""
        for material in self._dynamic_instances():
            material._set_scalar(parameter_name, parameter_value)

    @api
    def create_and_set_material_instance_dynamic(self, element_index: int) -> MaterialInstanceDynamic | None:
        """Put a dynamic instance of the slot's material on it."""
        return self.create_dynamic_material_instance(element_index)


@public
@with_setters(SETTERS["StaticMeshComponent"])
class StaticMeshComponent(MeshComponent):
    """Shows a static mesh."""

    _declares = {
        **KEPT["StaticMeshComponent"],
        "static_mesh": Prop("StaticMesh | None", get="_get_mesh", set="_set_mesh", saved=False),
    }

    def _start(self, name: str, outer: Object | None) -> None:
        super()._start(name, outer)
        self._mesh: StaticMesh | None = None

    def _get_mesh(self) -> StaticMesh | None:
        mesh: StaticMesh | None = self._mesh
        return mesh

    def _set_mesh(self, value: StaticMesh | None) -> None:
        self._mesh = value

    def _slot_count(self) -> int:
        return len(self._mesh._asset.slots) if self._mesh is not None else 0

    def _default_material(self, index: int) -> MaterialInterface | None:
        found: MaterialInterface | None = self._mesh._slot_material(index) if self._mesh is not None else None
        return found

    def _local_bounds(self) -> Bounds | None:
        if self._mesh is None:
            return None
        return self._mesh._asset.bounds_min_cm, self._mesh._asset.bounds_max_cm

    @api
    def set_static_mesh(self, new_mesh: StaticMesh | None) -> bool:
        """Show another mesh; False when it is shown already."""
        if new_mesh is self._mesh:
            return False
        self._mesh = new_mesh
        self._changed("static_mesh")
        return True

    @api
    def get_material_slot_names(self) -> Array:
        """Names of the slots."""
        slots = self._mesh._asset.slots if self._mesh is not None else []
        return Array._of("Name", [Name(slot.name) for slot in slots])

    @api
    def get_local_bounds(self) -> tuple[Vector, Vector]:
        """Lower and upper corner of the local bounds (cm)."""
        bounds = self._local_bounds()
        return (Vector(*bounds[0]), Vector(*bounds[1])) if bounds else (Vector(), Vector())
