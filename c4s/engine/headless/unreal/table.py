"""Editor properties, structs and enums of Unreal that the headless engine keeps as values, from a table.

``table.json`` is made from the stub of Unreal's Python API by ``python tests/engine/kept_table.py``. It is read when a
script first names something that the engine does not declare itself: the engine starts without it. A row is
``kind=default``, with ``-`` before it where scripts see no attribute and ``!`` where the property is read-only.
"""

from __future__ import annotations

import json
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

from c4s.engine.headless.unreal.containers import Array
from c4s.engine.headless.unreal.core import TYPES, EnumBase, Prop, public
from c4s.engine.headless.unreal.core.later import offer
from c4s.engine.headless.unreal.structs import ClosedStruct

FILE = Path(__file__).with_name("table.json")


MADE: set[str] = set()
"""Names of the types that were made from the table so far."""


@cache
def _table() -> dict[str, dict[str, Any]]:
    found: dict[str, dict[str, Any]] = json.loads(FILE.read_bytes())
    return found


def names() -> set[str]:
    """Names of all types of the table."""
    return {name for part in ("structs", "enums", "objects", "expressions") for name in _table()[part]}


def properties(name: str) -> dict[str, Prop]:
    """The properties that the table has for a class, its own only."""
    return _props(_table()["classes"].get(name, {}))


def fields(name: str) -> dict[str, Prop]:
    """The fields that the table has for a struct, beyond those that are declared."""
    return _props(_table()["structs"].get(name, {}))


def made(name: str) -> type | None:
    """A struct, enum or class of the table, published; None when the table has none of that name."""
    found = _made(name)
    if found is not None:
        MADE.add(name)
        public(found)
    return found


def _made(name: str) -> type | None:
    table = _table()
    if name in table["enums"]:
        make: Any = EnumBase
        kind: type = make(name, table["enums"][name], module="unreal")
        return kind
    if name in table["structs"]:
        members = {"__doc__": "Kept values.", "_fields": fields(name), "_takes": table["takes"].get(name)}
        return type(name, (ClosedStruct,), members)
    if name in table["objects"]:
        above: Any = TYPES[table["objects"][name]]
        return type(name, (above,), {"__doc__": "None exists here.", "_absent": True})
    if name in table["expressions"]:
        above = TYPES[table["expressions"][name]]
        return type(name, (above,), {"__doc__": "Made and connected; drives nothing here.", "_any_input": True})
    return None


def _props(rows: dict[str, str]) -> dict[str, Prop]:
    return {name: _prop(row) for name, row in rows.items()}


@cache
def _prop(row: str) -> Prop:
    left, _, default = row.partition("=")
    kind = left.lstrip("-!")
    marks = left[: len(left) - len(kind)]
    return Prop(
        kind,
        _default(kind, json.loads(default) if default else None),
        attribute="-" not in marks,
        writable="!" not in marks,
    )


def _default(kind: str, told: Any) -> Any:
    """The default as a property takes it: a value, or what makes one."""
    plain: dict[str, Any] = {"float": 0.0, "int": 0, "bool": False, "str": ""}
    if kind in plain:
        return type(plain[kind])(told) if told is not None else plain[kind]
    if kind.endswith(" | None"):
        return None
    if kind.startswith("Sequence"):
        item = kind[len("Sequence[") : -1]
        return lambda: Array._of(item, [])
    return _maker(kind, told)


def _maker(kind: str, told: Any) -> Callable[[], Any]:
    def make() -> Any:
        found: Any = TYPES[kind]
        if issubclass(found, EnumBase):
            return next(iter(found)) if told is None else found[told]
        return found() if told is None else found._from_parts(_parts(found, told))

    return make


def _parts(kind: Any, told: list[Any]) -> list[Any]:
    """Constructor arguments, with enums for the names of their members."""
    kinds = [prop.kind for prop in kind._fields.values()]
    return [_part(TYPES.get(kind), value) for kind, value in zip(kinds, told, strict=False)]


def _part(kind: Any, value: Any) -> Any:
    if isinstance(value, list):
        return _parts(kind, value)
    is_enum = isinstance(value, str) and kind is not None and issubclass(kind, EnumBase)
    return kind[value] if is_enum else value


offer(types=made, properties=properties)
