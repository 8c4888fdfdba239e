"""Editor properties in documents: numbers and strings as they are, structs as rows, enums by name, objects by path."""

from __future__ import annotations

import json
from collections.abc import Callable
from typing import Any

from c4s.engine.headless.unreal.assets import AssetObject
from c4s.engine.headless.unreal.containers import Array, Name, Text
from c4s.engine.headless.unreal.core import TYPES, EnumBase, Object, Prop, converted, copied, need
from c4s.engine.headless.unreal.structs import Color, Rotator, StructBase
from c4s.errors import BadInput

Find = Callable[[str], Any]
"""The asset of a path, or None."""


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
        held = value.__dict__
        return {n: encode(held[n]) for n, p in value._fields.items() if held[n] != initial(p)}
    if isinstance(value, Array):
        return [encode(item) for item in value]
    if isinstance(value, AssetObject):
        return None if value._dead else value._path()
    return None if isinstance(value, Object) else value


def initial(prop: Prop) -> Any:
    """The default of a property."""
    return prop.default() if callable(prop.default) else prop.default


def decode(raw: Any, kind: str, where: str, find: Find) -> Any:
    """A property value of JSON data; ``BadInput`` when it does not fit the kind. An asset that is gone is None."""
    try:
        json.dumps(raw, allow_nan=False)
        return _decode(raw, kind, find)
    except (TypeError, ValueError, KeyError, OverflowError, AttributeError) as error:
        raise BadInput(f"{raw!r:.200} is no {kind}: {error!s:.200}", where=where) from None


def _decode(raw: Any, kind: str, find: Find) -> Any:
    if raw is None or kind in ("float", "int", "bool", "str", "Name", "Text"):
        need(raw, kind, "value")
        return converted(raw, kind) if raw is not None else None
    if kind.startswith("Sequence"):
        item = kind[len("Sequence[") : -1]
        return Array._of(item, [_decode(v, item, find) for v in raw])
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
                made._put(name, _decode(value, made._fields[name].kind, find))
            return made
        return found(*raw)
    if issubclass(found, Object) and isinstance(raw, str):
        named = find(raw)
        return named if isinstance(named, found) else None
    raise TypeError(f"a {kind} cannot be read from a document")


def stored(properties: dict[str, Prop], values: dict[str, Any]) -> dict[str, Any]:
    """The values that a document keeps: those that differ from the class default."""
    kept = {}
    for name in sorted(values):
        prop = properties.get(name)
        if prop is not None and prop.saved and values[name] != initial(prop):
            kept[name] = encode(values[name])
    return kept


def restore(owner: Object, raw: dict[str, Any], where: str, find: Find) -> None:
    """Read a document's values back; ``BadInput`` for a property that the class does not have."""
    for name, value in raw.items():
        prop = owner._known(name)
        if prop is None or not prop.saved:
            raise BadInput(f"no property {name!r} that a document may hold", where=where)
        owner._values[name] = copied(decode(value, prop.kind, f"{where}.{name}", find))


def asset_paths(kind: type[Object] | None, raw: dict[str, Any]) -> list[str]:
    """Paths of the assets that an object's values name."""
    found = []
    for name, value in raw.items():
        prop = kind._known(name) if kind is not None else None
        if prop is not None and prop.kind.endswith(" | None") and isinstance(value, str):
            found.append(value)
    return found
