"""Editing of materials."""

from __future__ import annotations

from typing import Any

from c4s.engine.headless.state import world
from c4s.engine.headless.unreal.assets import (
    SCALAR_PARAMETERS,
    VECTOR_FIELDS,
    VECTOR_PARAMETERS,
    Material,
    MaterialInstanceConstant,
    MaterialInterface,
    Texture,
)
from c4s.engine.headless.unreal.containers import Array, Name
from c4s.engine.headless.unreal.core import Class, Object, api, as_class, public
from c4s.engine.headless.unreal.enums import MaterialParameterAssociation, MaterialProperty
from c4s.engine.headless.unreal.expressions import SURFACE_FIELDS, MaterialExpression, recompile
from c4s.engine.headless.unreal.structs import LinearColor

_GLOBAL = MaterialParameterAssociation.GLOBAL_PARAMETER


@public
class MaterialEditingLibrary(Object):
    """Editing of created materials and instances."""

    _class_module = "MaterialEditor"

    @classmethod
    @api
    def set_material_instance_parent(cls, instance: MaterialInstanceConstant, new_parent: MaterialInterface) -> None:
        """Set the parent."""
        if instance._created:
            instance.set_editor_property("parent", new_parent)

    @classmethod
    @api
    def set_material_instance_vector_parameter_value(cls, instance: MaterialInstanceConstant,
                                                     parameter_name: Name | str, value: LinearColor,
                                                     association: MaterialParameterAssociation = _GLOBAL) -> bool:
        """Set a vector parameter; False for one that the parent does not have, or a read-only asset."""
        return bool(instance._created and instance._set_vector(parameter_name, value))

    @classmethod
    @api
    def set_material_instance_scalar_parameter_value(cls, instance: MaterialInstanceConstant,
                                                     parameter_name: Name | str, value: float,
                                                     association: MaterialParameterAssociation = _GLOBAL) -> bool:
        """Set a scalar parameter; False for one that the parent does not have, or a read-only asset."""
        return bool(instance._created and instance._set_scalar(parameter_name, value))

    @classmethod
    @api
    def set_material_instance_texture_parameter_value(cls, instance: MaterialInstanceConstant,
                                                      parameter_name: Name | str, value: Texture | None,
                                                      association: MaterialParameterAssociation = _GLOBAL) -> bool:
        """False: materials here have no texture parameters."""
        return False

    @classmethod
    @api
    def get_texture_parameter_names(cls, material: MaterialInterface) -> Array:
        """None: materials here have no texture parameters."""
        return Array._of("Name", [])

    @classmethod
    @api
    def get_material_instance_vector_parameter_value(cls, instance: MaterialInstanceConstant,
                                                     parameter_name: Name | str,
                                                     association: MaterialParameterAssociation = _GLOBAL
                                                     ) -> LinearColor:
        """Value of a vector parameter."""
        return instance._vector(parameter_name)

    @classmethod
    @api
    def get_material_instance_scalar_parameter_value(cls, instance: MaterialInstanceConstant,
                                                     parameter_name: Name | str,
                                                     association: MaterialParameterAssociation = _GLOBAL) -> float:
        """Value of a scalar parameter."""
        return instance._scalar(parameter_name)

    @classmethod
    @api
    def get_vector_parameter_names(cls, material: MaterialInterface) -> Array:
        """Vector parameters of a material: the surface's colours."""
        own = [n for n, field in material._named().items() if field in VECTOR_FIELDS]
        return Array._of("Name", [Name(n) for n in (*own, *VECTOR_PARAMETERS)])

    @classmethod
    @api
    def get_scalar_parameter_names(cls, material: MaterialInterface) -> Array:
        """Scalar parameters of a material: the surface's factors."""
        own = [n for n, field in material._named().items() if field not in VECTOR_FIELDS]
        return Array._of("Name", [Name(n) for n in (*own, *SCALAR_PARAMETERS)])

    @classmethod
    @api
    def update_material_instance(cls, instance: MaterialInstanceConstant) -> None:
        """Values count at once."""

    @classmethod
    @api
    def create_material_expression(cls, material: Material, expression_class: Class | type, node_pos_x: int = 0,
                                   node_pos_y: int = 0) -> Any:
        """Add an expression to a created material; None for a read-only one."""
        if not material._created:
            world().log.error(f"'{material._path()}' is read-only")
            return None
        kind = as_class(expression_class)._python_type
        made = kind._make(f"{kind.__name__}_{len(material._expressions)}", material)
        material._expressions.append(made)
        return made

    @classmethod
    @api
    def connect_material_property(cls, from_expression: MaterialExpression, from_output_name: str,
                                  property_: MaterialProperty) -> bool:
        """Let an expression drive an input of its material; False for inputs that a surface here does not have."""
        material, field = from_expression._outer, SURFACE_FIELDS.get(property_.name)
        if field is None or not isinstance(material, Material):
            return False
        material._links = {**getattr(material, "_links", {}), field: from_expression}
        recompile(material)
        return True

    @classmethod
    @api
    def recompile_material(cls, material: Material) -> None:
        """Evaluate the expressions."""
        recompile(material)
