"""The table of editor properties, structs and enums that the headless engine keeps beyond those it declares itself.

``python tests/engine/kept_table.py`` writes it anew: names, types and access as the stub of Unreal's Python API lists
them; defaults of structs from their constructors there, those of objects from ``kept_defaults.py``, as the stub tells
none.
"""

from __future__ import annotations

import ast
import json
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from kept_defaults import DEFAULTS, LEFT_OUT, NAMED
from stub_index import StubIndex

from c4s.engine.headless.unreal import build
from c4s.engine.headless.unreal.actors import Actor
from c4s.engine.headless.unreal.assets import AssetObject
from c4s.engine.headless.unreal.components import ActorComponent
from c4s.engine.headless.unreal.expressions import MaterialExpression
from c4s.engine.headless.unreal.lights import DECLARED_SETTINGS
from c4s.engine.headless.unreal.table import FILE, MADE

_ROW = re.compile(r"(?m)^    - ``(\w+)`` \((.+?)\):  \[([\w-]+)\]")
_PLAIN = {"float": "float", "double": "float", "bool": "bool", "str": "str", "Name": "Name", "Text": "Text"}
KNOWN_BY_NAME = (
    *("Actor", "ActorComponent", "LevelStreaming", "FoliageType", "LandscapeGrassType", "LandscapeLayerInfoObject"),
    *("Texture", "SkeletalMesh", "Skeleton", "PhysicsAsset", "AnimationAsset", "SoundBase", "MovieSceneSequence"),
    *("NiagaraSystem", "ParticleSystem", "Font", "DataAsset", "DataTable", "CurveBase", "Blueprint"),
    *("MaterialFunctionInterface", "MaterialParameterCollection", "SubsurfaceProfile"),
)
"""What a level or a content folder may hold: scripts ask whether something is one of these, and here nothing is."""
_WHOLE = re.compile(r"u?int\d+")
_CONTAINERS = ("Map[", "Set[", "FixedArray[")


class Table:
    """What the table says, collected from the classes of the engine onwards."""

    def __init__(self, stub: StubIndex, ours: dict[str, Any]) -> None:
        self.stub, self.ours = stub, ours
        self.classes: dict[str, dict[str, str]] = {}
        self.structs: dict[str, dict[str, str]] = {}
        self.takes: dict[str, int] = {}
        self.enums: dict[str, dict[str, int]] = {}
        self.objects: dict[str, str] = {}
        self.expressions: dict[str, str] = {}

    def collect(self) -> dict[str, Any]:
        """The whole table."""
        kinds = [
            (name, cls)
            for name, cls in self.ours.items()
            if isinstance(cls, type) and issubclass(cls, (ActorComponent, Actor, AssetObject, MaterialExpression))
        ]
        for name, cls in sorted(kinds, key=lambda each: (len(each[1].__mro__), each[0])):
            self.classes[name] = self._class(name, cls)
        for name in self.stub.below(("MaterialExpression",)):
            if name not in self.ours:
                self.expressions[name] = self.stub.cls(name).bases[0]
                above = {prop for prop, _, _ in self._listed(self.expressions[name])}
                rows = {
                    prop: self._row(prop, kind, access, self.stub.has(name, prop), None)
                    for prop, kind, access in self._listed(name)
                    if prop not in above
                }
                self.classes[name] = {prop: row for prop, row in rows.items() if row}
        self.classes = {name: rows for name, rows in self.classes.items() if rows}
        for name in NAMED:
            self._kind(name)
        for name in self.stub.below(KNOWN_BY_NAME):
            self._kind(name)
        self.structs["PostProcessSettings"] = self._fields("PostProcessSettings", {}, [])
        return {
            "classes": self.classes,
            "structs": dict(sorted(self.structs.items())),
            "takes": dict(sorted(self.takes.items())),
            "enums": dict(sorted(self.enums.items())),
            "objects": dict(sorted(self.objects.items())),
            "expressions": dict(sorted(self.expressions.items())),
        }

    def _class(self, name: str, cls: type) -> dict[str, str]:
        inherited = {own for base in cls.__mro__[1:] for own in self.classes.get(base.__name__, {})}
        line = ["", *(each.__name__ for each in cls.__mro__)]
        skipped = set(cls._declared) | inherited | {prop for each in line for prop in LEFT_OUT.get(each, {})}  # type: ignore[attr-defined]
        rows = {}
        for prop, kind, access in self._listed(name):
            if prop in skipped:
                continue
            row = self._row(prop, kind, access, self.stub.has(name, prop), DEFAULTS.get(name, {}).get(prop))
            if row:
                rows[prop] = row
        return rows

    def _listed(self, name: str) -> Iterator[tuple[str, str, str]]:
        block = self.stub._block(self.stub._starts[name])
        text = block.partition("**Editor Properties:**")[2].partition('"""')[0]
        yield from _ROW.findall(text)

    def _row(self, prop: str, kind: str, access: str, shown: bool, default: Any) -> str:
        """``kind=default`` of a property, with ``-`` before it when scripts see no attribute, ``!`` when read-only."""
        own = self._kind(kind)
        if own is None:
            return ""
        marks = ("" if shown else "-") + ("!" if access == "Read-Only" else "")
        return f"{marks}{own}" + ("" if default is None else f"={json.dumps(default, separators=(',', ':'))}")

    def _kind(self, kind: str) -> str | None:
        """The kind in the engine's words; None for what it does not keep (delegates, maps, sets)."""
        kind = _PLAIN.get(kind, kind)
        if kind in _PLAIN.values() or kind in self.ours:
            found = self.ours.get(kind)
            return f"{kind} | None" if isinstance(found, type) and hasattr(found, "_class_path") else kind
        if _WHOLE.fullmatch(kind):
            return "int"
        if kind.startswith("Array["):
            item = self._kind(kind[6:-1])
            return f"Sequence[{item}]" if item else None
        if kind.startswith(_CONTAINERS) or kind not in self.stub.classes():
            return None
        bases = [base.name for base in self.stub.lineage(kind)]
        if "StructBase" in bases:
            self._struct(kind)
            return kind
        if "EnumBase" in bases:
            self.enums.setdefault(kind, self._members(kind))
            return kind
        if "Object" in bases:
            above = self.stub.cls(kind).bases[0]
            if kind not in self.objects:
                self.objects[kind] = above
                if above not in self.ours:
                    self._kind(above)
            return f"{kind} | None"
        return None

    def _members(self, name: str) -> dict[str, int]:
        told = self.stub.numbers(name)
        rows = re.findall(rf"(?m)^    (\w+): {name} = ", self.stub._block(self.stub._starts[name]))
        return {member: told.get(member, number) for number, member in enumerate(rows)}

    def _struct(self, name: str) -> None:
        if name in self.structs:
            return
        self.structs[name] = {}
        node = self.stub.node(name, "__init__")
        arguments, defaults = [], {}
        if node is not None:
            arguments = [argument.arg for argument in node.args.args[1:]]
            given = node.args.defaults
            defaults = {
                argument: _literal(value)
                for argument, value in zip(arguments[len(arguments) - len(given) :], given, strict=True)
            }
        self.structs[name] = self._fields(name, defaults, arguments)
        taken = len([argument for argument in arguments if argument in self.structs[name]])
        if taken != len(self.structs[name]):
            self.takes[name] = taken

    def _fields(self, name: str, defaults: dict[str, Any], first: list[str]) -> dict[str, str]:
        line = reversed(self.stub.lineage(name))
        listed = {prop: (kind, access) for each in line for prop, kind, access in self._listed(each.name)}
        known = DECLARED_SETTINGS if name in self.ours else ()
        rows = {}
        for prop in [*(p for p in first if p in listed), *(p for p in listed if p not in first)]:
            kind, access = listed[prop]
            default = DEFAULTS.get(name, {}).get(prop, defaults.get(prop))
            row = "" if prop in known else self._row(prop, kind, access, self.stub.has(name, prop), default)
            if row:
                rows[prop] = row
        return rows


def _literal(node: ast.expr) -> Any:
    """A default as JSON holds it: enums by member, objects as null; null too for the zero of its type."""
    value = _value(node)
    return None if value in (0, "", False, "None") else value


def _value(node: ast.expr) -> Any:
    if isinstance(node, ast.Attribute):
        return node.attr
    if isinstance(node, ast.List):
        return [_value(item) for item in node.elts]
    try:
        value = ast.literal_eval(node)
    except ValueError:
        return None
    return None if value is Ellipsis else value


def table() -> dict[str, Any]:
    """The table as the installed stub gives it."""
    ours = {name: value for name, value in vars(build()).items() if name not in MADE and name[0] != "_"}
    return Table(StubIndex.installed(), ours).collect()


def text(found: dict[str, Any]) -> str:
    """The file: one class, struct or enum a line."""
    parts = [
        f"{json.dumps(part)}: {{\n"
        + ",\n".join(f" {json.dumps(name)}: {json.dumps(row, separators=(',', ':'))}" for name, row in rows.items())
        + "\n}"
        for part, rows in found.items()
    ]
    return "{\n" + ",\n".join(parts) + "\n}\n"


if __name__ == "__main__":
    Path(FILE).write_text(text(table()), encoding="utf-8")
