"""Material expressions that give constants, and their evaluation into a surface."""

# ruff: noqa: RUF012  (each class declares its table of properties; no table is ever changed)

from __future__ import annotations

from typing import Any

from c4s.engine.headless.unreal.assets import VECTOR_FIELDS, Material
from c4s.engine.headless.unreal.containers import Name
from c4s.engine.headless.unreal.core import Object, Prop, public
from c4s.engine.headless.unreal.structs import LinearColor

SURFACE_FIELDS = {"MP_BASE_COLOR": "base_color", "MP_EMISSIVE_COLOR": "emissive", "MP_ROUGHNESS": "roughness",
                  "MP_METALLIC": "metallic", "MP_OPACITY": "opacity"}
"""Inputs of a material and the field of the surface that each one drives."""


@public
class MaterialExpression(Object):
    """Base of expressions."""

    def _value(self) -> tuple[float, float, float]:
        raise Exception(f"{self._name}: this expression gives no value")


@public
class MaterialExpressionConstant(MaterialExpression):
    """One number."""

    _declares = {"r": Prop("float", 0.0)}

    def _value(self) -> tuple[float, float, float]:
        r = self.get_editor_property("r")
        return (r, r, r)


@public
class MaterialExpressionConstant3Vector(MaterialExpression):
    """A colour."""

    _declares = {"constant": Prop("LinearColor", lambda: LinearColor(0, 0, 0, 1))}

    def _value(self) -> tuple[float, float, float]:
        c = self.get_editor_property("constant")
        return (c.r, c.g, c.b)


@public
class MaterialExpressionScalarParameter(MaterialExpression):
    """A named number."""

    _declares = {"parameter_name": Prop("Name", Name, attribute=False),
                 "default_value": Prop("float", 0.0, attribute=False)}

    def _value(self) -> tuple[float, float, float]:
        r = self.get_editor_property("default_value")
        return (r, r, r)


@public
class MaterialExpressionVectorParameter(MaterialExpression):
    """A named colour."""

    _declares = {"parameter_name": Prop("Name", Name, attribute=False),
                 "default_value": Prop("LinearColor", lambda: LinearColor(0, 0, 0, 1), attribute=False)}

    def _value(self) -> tuple[float, float, float]:
        c = self.get_editor_property("default_value")
        return (c.r, c.g, c.b)


def recompile(material: Material) -> None:
    """Evaluate a created material's expressions into its surface."""
    update: dict[str, Any] = {}
    named: dict[str, str] = {}
    for field, expression in getattr(material, "_links", {}).items():
        value = expression._value()
        update[field] = value if field in VECTOR_FIELDS else value[0]
        if "parameter_name" in type(expression)._properties:
            named[str(expression.get_editor_property("parameter_name"))] = field
    material._material = material._material.model_copy(update=update)
    material._parameters = {name: field for name, field in named.items() if name != "None"}
    material._dirty = True
