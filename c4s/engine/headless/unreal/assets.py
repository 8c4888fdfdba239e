"""Asset classes: static meshes, materials and their instances, Blueprints."""

# ruff: noqa: RUF012  (each class declares its table of properties; no table is ever changed)

from __future__ import annotations

import re
from typing import Any, ClassVar

from c4s.engine.headless.pose import Pose
from c4s.engine.headless.unreal.containers import Array, Name
from c4s.engine.headless.unreal.core import Class, Object, Prop, api, public
from c4s.engine.headless.unreal.enums import BlendMode, CollisionTraceFlag
from c4s.engine.headless.unreal.structs import Box, BoxSphereBounds, ClosedStruct, LinearColor, Rotator, Vector
from c4s.packs import manifest
from c4s.packs.manifest import Asset
from c4s.packs.meshes import Mesh

_VECTORS = {"basecolor": "base_color", "color": "base_color", "tint": "base_color", "emissivecolor": "emissive"}
_SCALARS = {"roughness": "roughness", "metallic": "metallic", "opacity": "opacity"}
VECTOR_PARAMETERS = ("BaseColor", "EmissiveColor")
SCALAR_PARAMETERS = ("Roughness", "Metallic", "Opacity")


def parameter_field(name: object, vector: bool) -> str | None:
    """Field of a surface that a material parameter drives (``BaseColor``, ``Base Color``, ``Roughness``), or None."""
    return (_VECTORS if vector else _SCALARS).get(re.sub(r"[\s_]", "", str(name)).casefold())


class AssetObject(Object):
    """An object that is the main object of its package."""

    @classmethod
    def _abstract(cls) -> bool:
        return True

    def _path(self) -> str:
        return str(self._object_path)

    def _changed(self, name: str) -> None:
        self._dirty = True

    def _place(self, path: str, created: bool) -> Any:
        self._object_path = path
        self._created = created
        self._dirty = created
        return self

    @classmethod
    def _at(cls, path: str, *, created: bool = False) -> Any:
        return cls._make(path.rsplit(".", 1)[-1], None)._place(path, created)

    def _references(self) -> list[str]:
        return []


@public
class MaterialInterface(AssetObject):
    """Base of materials and their instances."""

    def _surface(self) -> manifest.Material:
        raise Exception(f"{self._name}: this material has no surface")

    @api
    def get_base_material(self) -> Any:
        """The material behind all instances."""
        return self


@public
class Material(MaterialInterface):
    """A material: of a pack, or made by a script."""

    _declares = {"two_sided": Prop("bool", False, attribute=False),
                 "blend_mode": Prop("BlendMode", BlendMode.BLEND_OPAQUE)}

    def _bind(self, record: manifest.Material) -> Any:
        self._material = record
        self._expressions: list[Any] = []
        return self

    def _surface(self) -> manifest.Material:
        record: manifest.Material = self._material
        return record


@public
class Texture(AssetObject):
    """Base of textures. None is an asset of its own here: a texture belongs to its material."""


class _Overriding(MaterialInterface):
    """A material given by a parent and parameter values."""

    _declares = {"parent": Prop("MaterialInterface | None", get="_parent", set="_set_parent")}

    def _start(self, name: str, outer: Object | None) -> None:
        super()._start(name, outer)
        self._vectors: dict[str, tuple[float, float, float, float]] = {}
        self._scalars: dict[str, float] = {}

    def _parent(self) -> MaterialInterface | None:
        found: MaterialInterface | None = self._values.get("parent")
        return found

    def _may_follow(self, parent: MaterialInterface | None) -> bool:
        """Whether taking this parent leaves no circle."""
        above: MaterialInterface | None = parent
        while above is not None and above is not self:
            above = above._parent() if isinstance(above, _Overriding) else None
        return above is None

    def _set_parent(self, parent: MaterialInterface | None) -> None:
        if not self._may_follow(parent):
            raise Exception(f"{self._name}: a material instance cannot be its own parent")
        self._values["parent"] = parent

    def _surface(self) -> manifest.Material:
        parent = self._parent()
        base = parent._surface() if parent is not None else manifest.Material(path=self._path())
        update: dict[str, Any] = {"path": self._path(), "class_path": self._class_path()}
        for name, colour in self._vectors.items():
            field = parameter_field(name, True)
            if field:
                update[field] = colour[:3]
        for name, value in self._scalars.items():
            field = parameter_field(name, False)
            if field:
                update[field] = value
        return base.model_copy(update=update)

    def _set_vector(self, name: object, value: LinearColor) -> bool:
        if parameter_field(name, True) is None:
            return False
        self._vectors[str(name)] = (value.r, value.g, value.b, value.a)
        self._dirty = True
        return True

    def _set_scalar(self, name: object, value: float) -> bool:
        if parameter_field(name, False) is None:
            return False
        self._scalars[str(name)] = float(value)
        self._dirty = True
        return True

    def _vector(self, name: object) -> LinearColor:
        field = parameter_field(name, True)
        if not field:
            return LinearColor()
        r, g, b = getattr(self._surface(), field)
        return LinearColor(r, g, b, 1.0)

    def _scalar(self, name: object) -> float:
        field = parameter_field(name, False)
        return float(getattr(self._surface(), field)) if field else 0.0

    @api
    def get_base_material(self) -> Any:
        """The material behind all instances."""
        parent = self._parent()
        return parent.get_base_material() if parent is not None else None

    def _references(self) -> list[str]:
        parent = self._parent()
        return [parent._path()] if parent is not None else []


@public
class MaterialInstance(_Overriding):
    """Base of material instances."""


@public
class MaterialInstanceConstant(MaterialInstance):
    """A material instance asset."""


@public
class MaterialInstanceDynamic(MaterialInstance):
    """A material instance owned by a component, or transient."""

    @classmethod
    def _owned(cls, name: str, outer: Object | None, parent: MaterialInterface | None) -> Any:
        made = cls._make(name, outer)
        made._values["parent"] = parent
        made._created, made._dirty = False, False
        return made

    def _path(self) -> str:
        return Object._path(self)

    @api
    def set_vector_parameter_value(self, parameter_name: Name | str, value: LinearColor) -> None:
        """Set a vector parameter; an unknown one has no effect."""
        self._set_vector(parameter_name, value)

    @api
    def set_scalar_parameter_value(self, parameter_name: Name | str, value: float) -> None:
        """Set a scalar parameter; an unknown one has no effect."""
        self._set_scalar(parameter_name, value)

    @api
    def get_vector_parameter_value(self, parameter_name: Name | str) -> LinearColor:
        """Value of a vector parameter."""
        return self._vector(parameter_name)

    @api
    def get_scalar_parameter_value(self, parameter_name: Name | str) -> float:
        """Value of a scalar parameter."""
        return self._scalar(parameter_name)


@public
class StaticMaterial(ClosedStruct):
    """A slot of a static mesh."""

    _fields = {"material_interface": Prop("MaterialInterface | None", None),
               "material_slot_name": Prop("Name", Name),
               "imported_material_slot_name": Prop("Name", Name, attribute=False)}
    _takes = 2


def _unseen(kind: str, default: Any) -> Prop:
    return Prop(kind, default, attribute=False)


@public
class KBoxElem(ClosedStruct):
    """A box of simple collision; x, y, z are full lengths in cm."""

    _takes = 0
    _fields = {"center": _unseen("Vector", Vector), "rotation": _unseen("Rotator", Rotator), "x": _unseen("float", 0.0),
               "y": _unseen("float", 0.0), "z": _unseen("float", 0.0)}


@public
class KSphereElem(ClosedStruct):
    """A sphere of simple collision."""

    _takes = 0
    _fields = {"center": _unseen("Vector", Vector), "radius": _unseen("float", 0.0)}


@public
class KSphylElem(ClosedStruct):
    """A capsule of simple collision; ``length`` is the cylinder part."""

    _takes = 0
    _fields = {"center": _unseen("Vector", Vector), "rotation": _unseen("Rotator", Rotator),
               "radius": _unseen("float", 0.0), "length": _unseen("float", 0.0)}


@public
class KConvexElem(ClosedStruct):
    """A convex hull of simple collision; its vertices are not readable from Python."""

    _takes = 0
    _fields: ClassVar[dict[str, Prop]] = {"name": _unseen("Name", Name)}


@public
class KAggregateGeom(ClosedStruct):
    """All simple collision of a body."""

    _takes = 0
    _fields = {name: _unseen(f"Sequence[{kind}]", lambda kind=kind: Array._of(kind, []))
               for name, kind in (("box_elems", "KBoxElem"), ("sphere_elems", "KSphereElem"),
                                  ("sphyl_elems", "KSphylElem"), ("convex_elems", "KConvexElem"))}


@public
class BodySetup(Object):
    """Collision of a mesh."""

    _declares = {"agg_geom": Prop("KAggregateGeom", KAggregateGeom, attribute=False, writable=False),
                 "collision_trace_flag": Prop("CollisionTraceFlag", CollisionTraceFlag.CTF_USE_DEFAULT,
                                              attribute=False)}


def aggregate(asset: Asset) -> KAggregateGeom:
    """An asset's collision bodies in Unreal's structs."""
    boxes: list[KBoxElem] = []
    spheres: list[KSphereElem] = []
    capsules: list[KSphylElem] = []
    hulls: list[KConvexElem] = []
    for body in asset.collision:
        if isinstance(body, manifest.BoxBody):
            x, y, z = (2 * h for h in body.half_extent)
            boxes.append(KBoxElem._of_fields(Vector(*body.center), Rotator._of(body.rotation_deg), x, y, z))
        elif isinstance(body, manifest.SphereBody):
            spheres.append(KSphereElem._of_fields(Vector(*body.center), body.radius))
        elif isinstance(body, manifest.CapsuleBody):
            capsules.append(KSphylElem._of_fields(Vector(*body.center), Rotator._of(body.rotation_deg), body.radius,
                                                  body.length))
        else:
            hulls.append(KConvexElem._of_fields(Name(f"Hull_{len(hulls)}")))
    geom: KAggregateGeom = KAggregateGeom._of_fields(boxes, spheres, capsules, hulls)
    return geom


@public
class StaticMesh(AssetObject):
    """A static mesh asset."""

    _declares = {"static_materials": Prop("Sequence[StaticMaterial]", get="_static_materials", writable=False),
                 "body_setup": Prop("BodySetup", get="_body_setup", attribute=False, writable=False)}

    def _bind(self, asset: Asset) -> Any:
        self._asset = asset
        return self

    def _geometry(self) -> Mesh | None:
        """Triangles, of the original where this is a copy; None when no pack holds that any more."""
        from c4s.engine.headless.state import world

        store = world().store
        return store.mesh(self._asset.path) if store.asset(self._asset.path) is not None else None

    def _slot_material(self, index: int) -> MaterialInterface | None:
        from c4s.engine.headless.state import world

        slots = self._asset.slots
        if not 0 <= index < len(slots):
            return None
        found = world().find(slots[index].material)
        return found if isinstance(found, MaterialInterface) else None

    def _static_materials(self) -> Array:
        return Array._of("StaticMaterial", [
            StaticMaterial._of_fields(self._slot_material(i), Name(slot.name), Name(slot.name))
            for i, slot in enumerate(self._asset.slots)])

    def _body_setup(self) -> BodySetup:
        made: BodySetup = BodySetup._make("BodySetup_0", self)
        made._values["agg_geom"] = aggregate(self._asset)
        return made

    def _references(self) -> list[str]:
        return [slot.material for slot in self._asset.slots]

    @api
    def get_material(self, material_index: int) -> MaterialInterface | None:
        """Default material of a slot."""
        return self._slot_material(material_index)

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


@public
class Blueprint(AssetObject):
    """A Blueprint of a pack: an actor class made of meshes."""

    def _bind(self, asset: Asset, generated: Class) -> Any:
        self._asset = asset
        self._generated = generated
        return self

    @api
    def generated_class(self) -> Class:
        """The class whose actors it makes."""
        generated: Class = self._generated
        return generated

    def _references(self) -> list[str]:
        return [part.asset for part in self._asset.parts]
