"""Material expressions of constants, parameters and arithmetic, and their evaluation into a surface."""

# ruff: noqa: RUF012  (each class declares its table of properties; no table is ever changed)

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from c4s.engine.headless.editor import world
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


class NoConstant(Exception):
    """An expression has no value that is the same at every place of a surface."""


@public
class MaterialExpression(Object):
    """Base of expressions."""

    _inputs: tuple[str, ...] = ()
    """Names of its inputs, the first being meant by an empty name."""
    _any_input = False
    """Whether its inputs are not known: any name is one."""

    def _start(self, name: str, outer: Object | None) -> None:
        super()._start(name, outer)
        self._wires: dict[str, tuple[MaterialExpression, str]] = {}

    def _value(self) -> Value:
        raise NoConstant(f"{self._name} gives no value that is the same everywhere")

    def _given(self, name: str, constant: str) -> Value:
        """What is wired to an input, else the constant that stands in for it."""
        if name in self._wires:
            return output(*self._wires[name])
        value = self.get_editor_property(constant)
        return (value, value, value)

    def _wired(self, name: str) -> Value:
        """What is wired to an input that no constant stands in for."""
        if name not in self._wires:
            raise NoConstant(f"{self._name}: its input {name} is not connected")
        return output(*self._wires[name])

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
        return _all(lambda a: 1 - a, self._wired("Input"))


def _all(of: Callable[[float], float], a: Value) -> Value:
    return tuple(map(of, a))  # type: ignore[return-value]


def _each(of: Callable[[float, float], float], a: Value, b: Value) -> Value:
    return tuple(of(p, q) for p, q in zip(a, b, strict=True))  # type: ignore[return-value]


@public
class MaterialExpressionPower(MaterialExpression):
    """A power; of a negative base it is zero here."""

    _inputs = ("Base", "Exponent")
    _declares = {"const_exponent": Prop("float", 2.0, attribute=False)}

    def _value(self) -> Value:
        return _each(
            lambda a, b: a**b if a > 0 else 0.0, self._wired("Base"), self._given("Exponent", "const_exponent")
        )


@public
class MaterialExpressionMin(MaterialExpression):
    """The smaller of two."""

    _inputs = ("A", "B")
    _declares = {"const_a": Prop("float", 0.0, attribute=False), "const_b": Prop("float", 1.0, attribute=False)}

    def _value(self) -> Value:
        return _each(min, self._given("A", "const_a"), self._given("B", "const_b"))


@public
class MaterialExpressionMax(MaterialExpression):
    """The larger of two."""

    _inputs = ("A", "B")
    _declares = {"const_a": Prop("float", 0.0, attribute=False), "const_b": Prop("float", 1.0, attribute=False)}

    def _value(self) -> Value:
        return _each(max, self._given("A", "const_a"), self._given("B", "const_b"))


@public
class MaterialExpressionClamp(MaterialExpression):
    """A value moved between two."""

    _inputs = ("Input", "Min", "Max")
    _declares = {"min_default": Prop("float", 0.0, attribute=False), "max_default": Prop("float", 1.0, attribute=False)}

    def _value(self) -> Value:
        low, high = self._given("Min", "min_default"), self._given("Max", "max_default")
        return _each(min, _each(max, self._wired("Input"), low), high)


@public
class MaterialExpressionSaturate(MaterialExpression):
    """A value moved between 0 and 1."""

    _inputs = ("Input",)

    def _value(self) -> Value:
        return _all(lambda a: min(max(a, 0.0), 1.0), self._wired("Input"))


@public
class MaterialExpressionAbs(MaterialExpression):
    """A value without its sign."""

    _inputs = ("Input",)

    def _value(self) -> Value:
        return _all(abs, self._wired("Input"))


@public
class MaterialExpressionDesaturation(MaterialExpression):
    """A colour moved towards its grey."""

    _inputs = ("Input", "Fraction")

    def _value(self) -> Value:
        colour = self._wired("Input")
        share = output(*self._wires["Fraction"])[0] if "Fraction" in self._wires else 1.0
        grey = 0.3 * colour[0] + 0.59 * colour[1] + 0.11 * colour[2]
        return _all(lambda a: a + (grey - a) * share, colour)


@public
class MaterialExpressionAppendVector(MaterialExpression):
    """A number behind others; here a third one behind two."""

    _inputs = ("A", "B")

    def _value(self) -> Value:
        a, b = self._wired("A"), self._wired("B")
        return (a[0], a[1], b[0])


@public
class MaterialExpressionComponentMask(MaterialExpression):
    """Some channels of a value."""

    _inputs = ("Input",)
    _declares = {name: Prop("bool", False, attribute=False) for name in "rgba"}

    def _value(self) -> Value:
        given = self._wired("Input")
        kept = [value for name, value in zip("rgb", given, strict=True) if self.get_editor_property(name)]
        return (kept * 3)[:3] if len(kept) == 1 else [*kept, 0.0, 0.0, 0.0][:3]  # type: ignore[return-value]


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

    A field that no constant drives stays as it is, and the log says so. An instance that overrides a parameter sets
    what the parameter drives, without the arithmetic in between.
    """
    update: dict[str, Any] = {}
    named: dict[str, str] = {}
    for field, (expression, name) in links(material).items():
        if field not in SURFACE_FIELDS.values():
            continue
        try:
            value = output(expression, name)
        except NoConstant as error:
            world().log.warning(f"'{material._path()}': {error}; its {field} stays as it is")
            continue
        update[field] = value if field in VECTOR_FIELDS else value[0]
        named |= {
            str(each.get_editor_property("parameter_name")): field
            for each in expression._sources()
            if isinstance(each, _PARAMETERS[field in VECTOR_FIELDS])
        }
    material._material = material._material.model_copy(update=update)
    material._parameters = {name: field for name, field in named.items() if name != "None"}
    material._dirty = True
