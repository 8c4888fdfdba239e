"""Editor properties in documents: numbers and strings as they are, structs as rows, enums by name, objects by path."""

from __future__ import annotations

import json
from typing import Any

from c4s.engine.headless.unreal.assets import AssetObject
from c4s.engine.headless.unreal.containers import Array, Name, Text
from c4s.engine.headless.unreal.core import TYPES, EnumBase, Prop, converted, copied, need
from c4s.engine.headless.unreal.structs import Color, Rotator, StructBase
from c4s.errors import BadInput


def encode(value: Any) -> Any:
    """A property value as JSON data."""
    if isinstance(value, (Name, Text)):
        return str(value)
    if isinstance(value, EnumBase):
        return value.name
    if isinstance(value, Color):
        return [value.r, value.g, value.b, value.a]
    if isinstance(value, Rotator):
        return [value.pitch, value.yaw, value.roll]
    if isinstance(value, StructBase):
        if all(prop.kind == "float" for prop in value._fields.values()):
            return list(value.to_tuple())
        return {n: encode(getattr(value, n)) for n, p in value._fields.items() if getattr(value, n) != initial(p)}
    if isinstance(value, Array):
        return [encode(item) for item in value]
    if isinstance(value, AssetObject):
        return value._path()
    return value


def initial(prop: Prop) -> Any:
    """The default of a property."""
    return prop.default() if callable(prop.default) else prop.default


def decode(raw: Any, kind: str, where: str) -> Any:
    """A property value of JSON data; ``BadInput`` when it does not fit the kind."""
    try:
        json.dumps(raw, allow_nan=False)
        return _decode(raw, kind)
    except (TypeError, ValueError, KeyError, OverflowError, AttributeError) as error:
        raise BadInput(f"{raw!r} is no {kind}: {error}", where=where) from None


def _decode(raw: Any, kind: str) -> Any:
    if raw is None or kind in ("float", "int", "bool", "str", "Name", "Text"):
        need(raw, kind, "value")
        return converted(raw, kind) if raw is not None else None
    if kind.startswith("Sequence"):
        item = kind[len("Sequence[") : -1]
        return Array._of(item, [_decode(v, item) for v in raw])
    found = TYPES[kind.split(" | ")[0]]
    if issubclass(found, EnumBase):
        return found[raw]
    if found is Color:
        r, g, b = raw[:3]
        return Color(b=b, g=g, r=r, a=raw[3] if len(raw) > 3 else 255)
    if found is Rotator:
        return Rotator(pitch=raw[0], yaw=raw[1], roll=raw[2])
    if issubclass(found, StructBase):
        if isinstance(raw, dict):
            made = found()
            for name, value in raw.items():
                setattr(made, name, _decode(value, made._fields[name].kind))
            return made
        return found(*raw)
    raise TypeError(f"a {kind} cannot be read from a document")


def stored(properties: dict[str, Prop], values: dict[str, Any]) -> dict[str, Any]:
    """The values that a document keeps: those that differ from the class default."""
    kept = {}
    for name in sorted(values):
        prop = properties.get(name)
        if prop is not None and prop.saved and values[name] != initial(prop):
            kept[name] = encode(values[name])
    return kept


def restore(properties: dict[str, Prop], values: dict[str, Any], raw: dict[str, Any], where: str) -> None:
    """Read a document's values back; ``BadInput`` for a property that the class does not have."""
    for name, value in raw.items():
        prop = properties.get(name)
        if prop is None or not prop.saved:
            raise BadInput(f"no property {name!r} that a document may hold", where=where)
        values[name] = copied(decode(value, prop.kind, f"{where}.{name}"))
