"""Material expressions of constants, parameters and arithmetic, and their evaluation into a surface."""

# ruff: noqa: RUF012  (each class declares its table of properties; no table is ever changed)

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from c4s.engine.headless.unreal.assets import VECTOR_FIELDS, Material
from c4s.engine.headless.unreal.containers import Name
from c4s.engine.headless.unreal.core import Object, Prop, public
from c4s.engine.headless.unreal.structs import LinearColor

SURFACE_FIELDS = {
    "MP_BASE_COLOR": "base_color",
    "MP_EMISSIVE_COLOR": "emissive",
    "MP_ROUGHNESS": "roughness",
    "MP_METALLIC": "metallic",
    "MP_OPACITY": "opacity",
}
"""Inputs of a material and the field of the surface that each one drives."""


Value = tuple[float, float, float]
CHANNELS = {"R": 0, "G": 1, "B": 2}


@public
class MaterialExpression(Object):
    """Base of expressions."""

    _inputs: tuple[str, ...] = ()
    """Names of its inputs, the first being meant by an empty name."""

    def _start(self, name: str, outer: Object | None) -> None:
        super()._start(name, outer)
        self._wires: dict[str, tuple[MaterialExpression, str]] = {}

    def _value(self) -> Value:
        raise Exception(f"{self._name}: this expression gives no value")

    def _given(self, name: str, constant: str) -> Value:
        """What is wired to an input, else the constant that stands in for it."""
        if name in self._wires:
            return output(*self._wires[name])
        value = self.get_editor_property(constant)
        return (value, value, value)

    def _sources(self) -> list[MaterialExpression]:
        """This expression and all that it is made from."""
        return [self, *(each for source, _ in self._wires.values() for each in source._sources())]


def output(expression: MaterialExpression, name: str) -> Value:
    """The value at an output of an expression: one channel (``R``, ``G``, ``B``), or all."""
    value = expression._value()
    if name in CHANNELS:
        return (value[CHANNELS[name]],) * 3
    return value


@public
class MaterialExpressionConstant(MaterialExpression):
    """One number."""

    _declares = {"r": Prop("float", 0.0)}

    def _value(self) -> Value:
        r = self.get_editor_property("r")
        return (r, r, r)


@public
class MaterialExpressionConstant3Vector(MaterialExpression):
    """A colour."""

    _declares = {"constant": Prop("LinearColor", lambda: LinearColor(0, 0, 0, 1))}

    def _value(self) -> Value:
        c = self.get_editor_property("constant")
        return (c.r, c.g, c.b)


@public
class MaterialExpressionConstant2Vector(MaterialExpression):
    """Two numbers."""

    _declares = {"r": Prop("float", 0.0), "g": Prop("float", 0.0)}

    def _value(self) -> Value:
        return (self.get_editor_property("r"), self.get_editor_property("g"), 0.0)


@public
class MaterialExpressionConstant4Vector(MaterialExpression):
    """A colour with an alpha."""

    _declares = {"constant": Prop("LinearColor", lambda: LinearColor(0, 0, 0, 0))}

    def _value(self) -> Value:
        c = self.get_editor_property("constant")
        return (c.r, c.g, c.b)


@public
class MaterialExpressionMultiply(MaterialExpression):
    """A product."""

    _inputs = ("A", "B")
    _declares = {"const_a": Prop("float", 0.0, attribute=False), "const_b": Prop("float", 1.0, attribute=False)}

    def _value(self) -> Value:
        return _each(lambda a, b: a * b, self._given("A", "const_a"), self._given("B", "const_b"))


@public
class MaterialExpressionAdd(MaterialExpression):
    """A sum."""

    _inputs = ("A", "B")
    _declares = {"const_a": Prop("float", 0.0, attribute=False), "const_b": Prop("float", 1.0, attribute=False)}

    def _value(self) -> Value:
        return _each(lambda a, b: a + b, self._given("A", "const_a"), self._given("B", "const_b"))


@public
class MaterialExpressionSubtract(MaterialExpression):
    """A difference."""

    _inputs = ("A", "B")
    _declares = {"const_a": Prop("float", 1.0, attribute=False), "const_b": Prop("float", 1.0, attribute=False)}

    def _value(self) -> Value:
        return _each(lambda a, b: a - b, self._given("A", "const_a"), self._given("B", "const_b"))


@public
class MaterialExpressionDivide(MaterialExpression):
    """A quotient; nothing divided by zero is zero here."""

    _inputs = ("A", "B")
    _declares = {"const_a": Prop("float", 1.0, attribute=False), "const_b": Prop("float", 2.0, attribute=False)}

    def _value(self) -> Value:
        return _each(lambda a, b: a / b if b else 0.0, self._given("A", "const_a"), self._given("B", "const_b"))


@public
class MaterialExpressionLinearInterpolate(MaterialExpression):
    """A mix of two values."""

    _inputs = ("A", "B", "Alpha")
    _declares = {
        "const_a": Prop("float", 0.0, attribute=False),
        "const_b": Prop("float", 1.0, attribute=False),
        "const_alpha": Prop("float", 0.5, attribute=False),
    }

    def _value(self) -> Value:
        share = self._given("Alpha", "const_alpha")
        a, b = self._given("A", "const_a"), self._given("B", "const_b")
        return tuple(p + (q - p) * t for p, q, t in zip(a, b, share, strict=True))  # type: ignore[return-value]


@public
class MaterialExpressionOneMinus(MaterialExpression):
    """One less a value."""

    _inputs = ("Input",)

    def _value(self) -> Value:
        if "Input" not in self._wires:
            raise Exception(f"{self._name}: its input is not connected")
        return tuple(1 - value for value in output(*self._wires["Input"]))  # type: ignore[return-value]


def _each(of: Callable[[float, float], float], a: Value, b: Value) -> Value:
    return tuple(of(p, q) for p, q in zip(a, b, strict=True))  # type: ignore[return-value]


@public
class MaterialExpressionScalarParameter(MaterialExpression):
    """A named number."""

    _declares = {
        "parameter_name": Prop("Name", Name, attribute=False),
        "default_value": Prop("float", 0.0, attribute=False),
    }

    def _value(self) -> Value:
        r = self.get_editor_property("default_value")
        return (r, r, r)


@public
class MaterialExpressionVectorParameter(MaterialExpression):
    """A named colour."""

    _declares = {
        "parameter_name": Prop("Name", Name, attribute=False),
        "default_value": Prop("LinearColor", lambda: LinearColor(0, 0, 0, 1), attribute=False),
    }

    def _value(self) -> Value:
        c = self.get_editor_property("default_value")
        return (c.r, c.g, c.b)


_PARAMETERS = {True: MaterialExpressionVectorParameter, False: MaterialExpressionScalarParameter}
"""What an instance overrides a colour by, and what a number."""


def links(material: Material) -> dict[str, tuple[MaterialExpression, str]]:
    """What drives each field of a material's surface: an expression and the name of its output."""
    found: dict[str, tuple[MaterialExpression, str]] = material.__dict__.setdefault("_links", {})
    return found


def recompile(material: Material) -> None:
    """Evaluate a created material's expressions into its surface.

    An instance that overrides a parameter sets what the parameter drives, without the arithmetic in between.
    """
    update: dict[str, Any] = {}
    named: dict[str, str] = {}
    for field, (expression, name) in links(material).items():
        value = output(expression, name)
        update[field] = value if field in VECTOR_FIELDS else value[0]
        named |= {
            str(each.get_editor_property("parameter_name")): field
            for each in expression._sources()
            if isinstance(each, _PARAMETERS[field in VECTOR_FIELDS])
        }
    material._material = material._material.model_copy(update=update)
    material._parameters = {name: field for name, field in named.items() if name != "None"}
    material._dirty = True
