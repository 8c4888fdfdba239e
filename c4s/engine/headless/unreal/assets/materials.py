"""Materials, their instances and parameters."""

# ruff: noqa: RUF012  (each class declares its table of properties; no table is ever changed)

from __future__ import annotations

import math
import re
from typing import Any

from c4s.bounds import BOUNDS
from c4s.engine.headless.unreal.assets.base import AssetObject
from c4s.engine.headless.unreal.containers import Array, Name
from c4s.engine.headless.unreal.core import TYPES, Object, Prop, api, public
from c4s.engine.headless.unreal.enums import BlendMode
from c4s.engine.headless.unreal.kept import KEPT
from c4s.engine.headless.unreal.structs import LinearColor
from c4s.records import pack

_VECTORS = {"basecolor": "base_color", "color": "base_color", "tint": "base_color", "emissivecolor": "emissive"}
_SCALARS = {"roughness": "roughness", "metallic": "metallic", "opacity": "opacity"}
VECTOR_FIELDS = ("base_color", "emissive")
VECTOR_PARAMETERS = ("BaseColor", "EmissiveColor")
SCALAR_PARAMETERS = ("Roughness", "Metallic", "Opacity")


def parameter_field(name: object, vector: bool) -> str | None:
    """Field of a surface that a material parameter drives (``BaseColor``, ``Base Color``, ``Roughness``), or None."""
    return (_VECTORS if vector else _SCALARS).get(re.sub(r"[\s_]", "", str(name)).casefold())


@public
class MaterialInterface(AssetObject):
    """Base of materials and their instances."""

    def _surface(self) -> pack.Material:
        raise Exception(f"{self._name}: this material has no surface")

    def _origin_path(self) -> str:
        """Path of the pack's material whose textures this one shows."""
        return self._path()

    def _field(self, name: object, vector: bool) -> str | None:
        """Field of the surface that a parameter drives, or None."""
        return parameter_field(name, vector)

    def _named(self) -> dict[str, str]:
        """Parameters that a script gave its own names, and the field that each one drives."""
        return {}

    @api
    def get_base_material(self) -> Any:
        """The material behind all instances."""
        return self


@public
class Material(MaterialInterface):
    """A material: of a pack, or made by a script."""

    _declares = {
        **KEPT["Material"],
        "two_sided": Prop("bool", False, attribute=False),
        "blend_mode": Prop("BlendMode", BlendMode.BLEND_OPAQUE),
    }

    def _bind(self, record: pack.Material, origin: str | None = None) -> Any:
        self._material = record
        self._origin = origin or record.path
        self._expressions: list[Any] = []
        self._parameters: dict[str, str] = {}
        return self

    def _surface(self) -> pack.Material:
        record: pack.Material = self._material
        return record

    def _origin_path(self) -> str:
        return str(self._origin)

    def _named(self) -> dict[str, str]:
        found: dict[str, str] = self._parameters
        return found

    def _field(self, name: object, vector: bool) -> str | None:
        for own, field in self._named().items():
            if own.casefold() == str(name).casefold() and (field in VECTOR_FIELDS) is vector:
                return field
        return parameter_field(name, vector)


@public
class Texture(AssetObject):
    """Base of textures. None is an asset of its own here: a texture belongs to its material."""


@public
class Texture2D(Texture):
    """A picture."""


class _Overriding(MaterialInterface):
    """A material given by a parent and parameter values."""

    _declares = {
        "parent": Prop("MaterialInterface | None", get="_parent", set="_set_parent", saved=False),
        "scalar_parameter_values": Prop(
            "Sequence[ScalarParameterValue]", get="_scalar_rows", writable=False, saved=False
        ),
        "vector_parameter_values": Prop(
            "Sequence[VectorParameterValue]", get="_vector_rows", writable=False, saved=False
        ),
        "texture_parameter_values": Prop(
            "Sequence[TextureParameterValue]", get="_texture_rows", writable=False, saved=False
        ),
    }

    def _start(self, name: str, outer: Object | None) -> None:
        super()._start(name, outer)
        self._vectors: dict[str, tuple[float, float, float, float]] = {}
        self._scalars: dict[str, float] = {}

    def _parent(self) -> MaterialInterface | None:
        found: MaterialInterface | None = self._values.get("parent")
        return found

    def _may_follow(self, parent: MaterialInterface | None) -> bool:
        """Whether taking this parent leaves no circle, and no chain that is too long to be read again."""
        above: MaterialInterface | None = parent
        parents = 0
        while above is not None and above is not self:
            above, parents = above._parent() if isinstance(above, _Overriding) else None, parents + 1
        return above is None and BOUNDS["material_parents"].fault(parents) is None

    def _set_parent(self, parent: MaterialInterface | None) -> None:
        if not self._may_follow(parent):
            raise Exception(f"{self._name}: a material instance cannot be its own parent, nor below too many")
        self._values["parent"] = parent

    def _surface(self) -> pack.Material:
        parent = self._parent()
        base = parent._surface() if parent is not None else pack.Material(path=self._path())
        update: dict[str, Any] = {"path": self._path(), "class_path": self._class_path()}
        for name, colour in self._vectors.items():
            field = self._field(name, True)
            if field:
                update[field] = colour[:3]
        for name, value in self._scalars.items():
            field = self._field(name, False)
            if field:
                update[field] = value
        return base.model_copy(update=update)

    def _field(self, name: object, vector: bool) -> str | None:
        parent = self._parent()
        return parent._field(name, vector) if parent is not None else parameter_field(name, vector)

    def _named(self) -> dict[str, str]:
        parent = self._parent()
        return parent._named() if parent is not None else {}

    def _origin_path(self) -> str:
        parent = self._parent()
        return parent._origin_path() if parent is not None else self._path()

    def _rows(self, kind: str, values: dict[str, Any]) -> Array:
        """Its own values as structs of the table; names belong to no layer."""
        made: Any = TYPES[kind]
        rows = []
        for name, value in values.items():
            row = made()
            row.parameter_info.name = name
            row.parameter_value = value
            rows.append(row)
        return Array._of(kind, rows)

    def _scalar_rows(self) -> Array:
        return self._rows("ScalarParameterValue", self._scalars)

    def _vector_rows(self) -> Array:
        return self._rows("VectorParameterValue", self._vectors)

    def _texture_rows(self) -> Array:
        return self._rows("TextureParameterValue", {})

    def _set_vector(self, name: object, value: LinearColor) -> bool:
        if self._field(name, True) is None or not all(math.isfinite(part) for part in value.to_tuple()):
            return False
        self._vectors[str(name)] = (value.r, value.g, value.b, value.a)
        self._dirty = True
        return True

    def _set_scalar(self, name: object, value: float) -> bool:
        if self._field(name, False) is None or not math.isfinite(value):
            return False
        self._scalars[str(name)] = float(value)
        self._dirty = True
        return True

    def _vector(self, name: object) -> LinearColor:
        field = self._field(name, True)
        if not field:
            return LinearColor()
        r, g, b = getattr(self._surface(), field)
        return LinearColor(r, g, b, 1.0)

    def _scalar(self, name: object) -> float:
        field = self._field(name, False)
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

    @api
    def get_vector_parameter_value(self, parameter_name: Name | str) -> LinearColor:
        """Value of a vector parameter."""
        return self._vector(parameter_name)

    @api
    def get_scalar_parameter_value(self, parameter_name: Name | str) -> float:
        """Value of a scalar parameter."""
        return self._scalar(parameter_name)

    @api
    def get_texture_parameter_value(self, parameter_name: Name | str) -> Texture | None:
        """None: materials here have no texture parameters."""
        return None


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
