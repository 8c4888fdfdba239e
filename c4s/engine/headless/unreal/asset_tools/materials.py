"""Editing of materials."""

from __future__ import annotations

from typing import Any

from c4s.engine.headless.editor import world
from c4s.engine.headless.unreal.asset_tools.registry import AssetData
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
from c4s.engine.headless.unreal.expressions import SURFACE_FIELDS, MaterialExpression, links, recompile
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
    def set_material_instance_vector_parameter_value(
        cls,
        instance: MaterialInstanceConstant,
        parameter_name: Name | str,
        value: LinearColor,
        association: MaterialParameterAssociation = _GLOBAL,
    ) -> bool:
        """Set a vector parameter; False for one that the parent does not have, or a read-only asset."""
        return bool(instance._created and instance._set_vector(parameter_name, value))

    @classmethod
    @api
    def set_material_instance_scalar_parameter_value(
        cls,
        instance: MaterialInstanceConstant,
        parameter_name: Name | str,
        value: float,
        association: MaterialParameterAssociation = _GLOBAL,
    ) -> bool:
        """Set a scalar parameter; False for one that the parent does not have, or a read-only asset."""
        return bool(instance._created and instance._set_scalar(parameter_name, value))

    @classmethod
    @api
    def set_material_instance_texture_parameter_value(
        cls,
        instance: MaterialInstanceConstant,
        parameter_name: Name | str,
        value: Texture | None,
        association: MaterialParameterAssociation = _GLOBAL,
    ) -> bool:
        """False: materials here have no texture parameters."""
        return False

    @classmethod
    @api
    def get_texture_parameter_names(cls, material: MaterialInterface) -> Array:
        """None: materials here have no texture parameters."""
        return Array._of("Name", [])

    @classmethod
    @api
    def get_material_instance_vector_parameter_value(
        cls,
        instance: MaterialInstanceConstant,
        parameter_name: Name | str,
        association: MaterialParameterAssociation = _GLOBAL,
    ) -> LinearColor:
        """Value of a vector parameter."""
        return instance._vector(parameter_name)

    @classmethod
    @api
    def get_material_instance_scalar_parameter_value(
        cls,
        instance: MaterialInstanceConstant,
        parameter_name: Name | str,
        association: MaterialParameterAssociation = _GLOBAL,
    ) -> float:
        """Value of a scalar parameter."""
        return instance._scalar(parameter_name)

    @classmethod
    @api
    def get_vector_parameter_names(cls, material: MaterialInterface) -> Array:
        """Vector parameters of a material: the surface's colours."""
        own = [n for n, field in material._named().items() if field in VECTOR_FIELDS]
        return Array._of("Name", [Name(n) for n in dict.fromkeys((*own, *VECTOR_PARAMETERS))])

    @classmethod
    @api
    def get_scalar_parameter_names(cls, material: MaterialInterface) -> Array:
        """Scalar parameters of a material: the surface's factors."""
        own = [n for n, field in material._named().items() if field not in VECTOR_FIELDS]
        return Array._of("Name", [Name(n) for n in dict.fromkeys((*own, *SCALAR_PARAMETERS))])

    @classmethod
    @api
    def update_material_instance(cls, instance: MaterialInstanceConstant) -> None:
        """Values count at once."""

    @classmethod
    @api
    def create_material_expression(
        cls, material: Material, expression_class: Class | type, node_pos_x: int = 0, node_pos_y: int = 0
    ) -> Any:
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
    def connect_material_property(
        cls, from_expression: MaterialExpression, from_output_name: str, property_: MaterialProperty
    ) -> bool:
        """Let an expression drive an input of its material; one that a surface here does not have changes nothing."""
        material, field = from_expression._outer, SURFACE_FIELDS.get(property_.name, property_.name)
        if not isinstance(material, Material):
            return False
        links(material)[field] = (from_expression, from_output_name)
        recompile(material)
        return True

    @classmethod
    @api
    def connect_material_expressions(
        cls,
        from_expression: MaterialExpression,
        from_output_name: str,
        to_expression: MaterialExpression,
        to_input_name: str,
    ) -> bool:
        """Let an expression feed an input of another (its first for an empty name); False for a wrong one, a circle."""
        names = {name.casefold(): name for name in to_expression._inputs}
        wanted = names.get(to_input_name.casefold()) if to_input_name else next(iter(to_expression._inputs), None)
        if to_expression._any_input:
            wanted = to_input_name or "Input"
        if (
            wanted is None
            or from_expression._outer is not to_expression._outer
            or to_expression in from_expression._sources()
        ):
            return False
        to_expression._wires[wanted] = (from_expression, from_output_name)
        return True

    @classmethod
    @api
    def get_material_property_input_node(
        cls, material: Material, property_: MaterialProperty
    ) -> MaterialExpression | None:
        """The expression that drives an input of a material, or None."""
        return links(material).get(SURFACE_FIELDS.get(property_.name, property_.name), (None, ""))[0]

    @classmethod
    @api
    def get_material_property_input_node_output_name(cls, material: Material, property_: MaterialProperty) -> str:
        """Which output drives an input of a material; empty for all, or none."""
        return links(material).get(SURFACE_FIELDS.get(property_.name, property_.name), (None, ""))[1]

    @classmethod
    @api
    def get_material_expression_input_names(cls, material_expression: MaterialExpression) -> Array:
        """Names of the inputs of an expression."""
        return Array._of("str", list(material_expression._inputs))

    @classmethod
    @api
    def get_num_material_expressions(cls, material: Material) -> int:
        """Number of expressions."""
        return len(material._expressions)

    @classmethod
    @api
    def layout_material_expressions(cls, material: Material) -> None:
        """Nothing is drawn here, so nothing is put in order."""

    @classmethod
    @api
    def delete_material_expression(cls, material: Material, expression: MaterialExpression) -> None:
        """Take an expression away, and what it feeds."""
        material._expressions = [each for each in material._expressions if each is not expression]
        for each in material._expressions:
            each._wires = {name: wire for name, wire in each._wires.items() if wire[0] is not expression}
        for field in [field for field, wire in links(material).items() if wire[0] is expression]:
            del links(material)[field]

    @classmethod
    @api
    def delete_all_material_expressions(cls, material: Material) -> None:
        """Take all expressions away."""
        material._expressions = []
        links(material).clear()

    @classmethod
    @api
    def get_material_default_vector_parameter_value(cls, material: Material, parameter_name: Name | str) -> LinearColor:
        """Value of a vector parameter in the material itself."""
        field = material._field(parameter_name, True)
        r, g, b = getattr(material._surface(), field) if field else (0.0, 0.0, 0.0)
        return LinearColor(r, g, b, 1.0) if field else LinearColor()

    @classmethod
    @api
    def get_material_default_scalar_parameter_value(cls, material: Material, parameter_name: Name | str) -> float:
        """Value of a scalar parameter in the material itself."""
        field = material._field(parameter_name, False)
        return float(getattr(material._surface(), field)) if field else 0.0

    @classmethod
    @api
    def get_material_default_texture_parameter_value(
        cls, material: Material, parameter_name: Name | str
    ) -> Texture | None:
        """None: materials here have no texture parameters."""
        return None

    @classmethod
    @api
    def get_material_instance_texture_parameter_value(
        cls,
        instance: MaterialInstanceConstant,
        parameter_name: Name | str,
        association: MaterialParameterAssociation = _GLOBAL,
    ) -> Texture | None:
        """None: materials here have no texture parameters."""
        return None

    @classmethod
    @api
    def get_static_switch_parameter_names(cls, material: MaterialInterface) -> Array:
        """None: materials here have no switches."""
        return Array._of("Name", [])

    @classmethod
    @api
    def set_material_instance_static_switch_parameter_value(
        cls,
        instance: MaterialInstanceConstant,
        parameter_name: Name | str,
        value: bool,
        association: MaterialParameterAssociation = _GLOBAL,
        update_material_instance: bool = True,
    ) -> bool:
        """False: materials here have no switches."""
        return False

    @classmethod
    @api
    def get_material_instance_static_switch_parameter_value(
        cls,
        instance: MaterialInstanceConstant,
        parameter_name: Name | str,
        association: MaterialParameterAssociation = _GLOBAL,
    ) -> bool:
        """False: materials here have no switches."""
        return False

    @classmethod
    @api
    def get_material_default_static_switch_parameter_value(cls, material: Material, parameter_name: Name | str) -> bool:
        """False: materials here have no switches."""
        return False

    @classmethod
    @api
    def get_used_textures(cls, material: Material) -> Array:
        """None: a texture is no asset of its own here."""
        return Array._of("Texture", [])

    @classmethod
    @api
    def clear_all_material_instance_parameters(cls, instance: MaterialInstanceConstant) -> None:
        """Take all of an instance's own values away."""
        if instance._created:
            instance._vectors, instance._scalars, instance._dirty = {}, {}, True

    @classmethod
    @api
    def get_child_instances(cls, parent: MaterialInterface) -> Array:
        """Asset data of the instances whose parent this is."""
        return Array._of(
            "AssetData",
            [
                AssetData._for(asset._path(), asset._class_path())
                for asset in world().assets()
                if isinstance(asset, MaterialInstanceConstant) and asset._parent() is parent
            ],
        )

    @classmethod
    @api
    def recompile_material(cls, material: Material) -> None:
        """Evaluate the expressions."""
        recompile(material)
