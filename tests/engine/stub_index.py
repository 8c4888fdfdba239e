"""An index of Unreal's Python API (5.6), read from the text of the PyPI package ``unreal-stub``.

The stub is 26 MB, and one line of it is no Python, so it is neither imported nor parsed whole: one pass over the lines
notes where each class lies, and only the classes asked for are parsed.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from importlib import metadata
from pathlib import Path

_CLASS = re.compile(r"class (\w+)\((.*)\):")
_BLOB_DEFAULT = re.compile(r"= (\[.*|\{.*)")
_LISTED = re.compile(r"- ``(\w+)`` \(")
_ENUM_ENTRY = re.compile(r"(\w+): \w+")


@dataclass(frozen=True)
class Parameter:
    """One parameter of a call: whether it may be left out, and how it takes its values."""

    name: str
    required: bool
    kind: str = ""
    """``*`` or ``**`` for the open ones."""


Signature = tuple[Parameter, ...]


def signature_of(node: ast.FunctionDef) -> Signature:
    """Parameters of a function as written, ``self`` and ``cls`` aside."""
    arguments = node.args
    positional = [*arguments.posonlyargs, *arguments.args]
    split = len(positional) - len(arguments.defaults)
    found = [Parameter(argument.arg, index < split) for index, argument in enumerate(positional)]
    if found and found[0].name in ("self", "cls"):
        found = found[1:]
    if arguments.vararg:
        found.append(Parameter(arguments.vararg.arg, False, "*"))
    found += [
        Parameter(argument.arg, default is None)
        for argument, default in zip(arguments.kwonlyargs, arguments.kw_defaults, strict=True)
    ]
    if arguments.kwarg:
        found.append(Parameter(arguments.kwarg.arg, False, "**"))
    return tuple(found)


@dataclass(frozen=True)
class StubClass:
    """What the stub says of one class, its bases aside."""

    name: str
    bases: tuple[str, ...]
    methods: dict[str, Signature]
    nodes: dict[str, ast.FunctionDef]
    """The methods as written, for their defaults and results."""
    properties: frozenset[str]
    """Properties that scripts see as attributes."""
    editor_properties: frozenset[str]
    """All that ``get_editor_property`` takes, as the docstring lists them."""
    constants: frozenset[str]
    """Members of an enum."""


class StubIndex:
    """The stub's classes and functions by name."""

    def __init__(self, path: Path) -> None:
        self._lines = path.read_text(encoding="utf-8").splitlines()
        self._starts: dict[str, int] = {}
        self._functions: dict[str, int] = {}
        self._tops: list[int] = []
        for number, line in enumerate(self._lines):
            if line and not line[0].isspace():
                self._tops.append(number)
                if line.startswith("class "):
                    self._starts[line[6:].split("(", 1)[0].rstrip(":")] = number
                elif line.startswith("def "):
                    self._functions[line[4:].split("(", 1)[0]] = number
        self._parsed: dict[str, StubClass] = {}

    @classmethod
    def installed(cls) -> StubIndex:
        """Of the installed package; ``PackageNotFoundError`` without it."""
        files = metadata.distribution("unreal-stub").files or []
        return cls(next(Path(str(file.locate())) for file in files if file.name == "unreal.py"))

    @cached_property
    def _ends(self) -> dict[int, int]:
        return dict(zip(self._tops, [*self._tops[1:], len(self._lines)], strict=True))

    def _block(self, start: int) -> str:
        lines = self._lines[start : self._ends[start]]
        return "\n".join(
            _BLOB_DEFAULT.sub("= ...) -> None:", line) if line.startswith("    def ") and "= [[" in line else line
            for line in lines
        )

    def classes(self) -> set[str]:
        """Names of all classes."""
        return set(self._starts)

    def below(self, roots: Iterable[str]) -> list[str]:
        """Names of these classes and of all that derive from them, bases first."""
        derived: dict[str, list[str]] = {}
        for name, start in self._starts.items():
            found = _CLASS.match(self._lines[start])
            derived.setdefault(found[2] if found else "", []).append(name)
        told = [name for name in roots if name in self._starts]
        for name in told:
            told += derived.get(name, [])
        return told

    def functions(self) -> set[str]:
        """Names of all functions of the module."""
        return set(self._functions)

    def function(self, name: str) -> Signature:
        """Parameters of a function of the module."""
        node = ast.parse(self._block(self._functions[name])).body[0]
        assert isinstance(node, ast.FunctionDef)
        return signature_of(node)

    def cls(self, name: str) -> StubClass:
        """One class."""
        if name not in self._parsed:
            self._parsed[name] = self._parse(name)
        return self._parsed[name]

    def _parse(self, name: str) -> StubClass:
        node = ast.parse(self._block(self._starts[name])).body[0]
        assert isinstance(node, ast.ClassDef)
        text = (ast.get_docstring(node) or "").partition("**Editor Properties:**")[2]
        methods, nodes, properties, constants = {}, {}, set(), set()
        for item in node.body:
            if isinstance(item, ast.FunctionDef):
                if any(isinstance(d, ast.Name) and d.id == "property" for d in item.decorator_list):
                    properties.add(item.name)
                elif not any(isinstance(d, ast.Attribute) for d in item.decorator_list):
                    methods.setdefault(item.name, signature_of(item))
                    nodes.setdefault(item.name, item)
            elif isinstance(item, ast.AnnAssign) and isinstance(item.target, ast.Name):
                constants.add(item.target.id)
            elif isinstance(item, ast.Assign):
                constants |= {target.id for target in item.targets if isinstance(target, ast.Name)}
        return StubClass(
            name,
            tuple(base.id for base in node.bases if isinstance(base, ast.Name)),
            methods,
            nodes,
            frozenset(properties),
            frozenset(_LISTED.findall(text)),
            frozenset(constants),
        )

    def numbers(self, name: str) -> dict[str, int]:
        """Numbers of an enum's members."""
        rows = re.findall(r"(?m)^    (\w+): \w+ = \.\.\. *#: (\d+)", self._block(self._starts[name]))
        return {member: int(number) for member, number in rows}

    def lineage(self, name: str) -> list[StubClass]:
        """A class and its bases, nearest first, as far as the stub declares them."""
        found = [self.cls(name)]
        for base in found[0].bases:
            found += self.lineage(base) if base in self._starts else []
        return found

    def method(self, name: str, method: str) -> Signature | None:
        """Parameters of a method, its own or inherited, or None."""
        return next((c.methods[method] for c in self.lineage(name) if method in c.methods), None)

    def node(self, name: str, method: str) -> ast.FunctionDef | None:
        """A method as written, its own or inherited, or None."""
        return next((c.nodes[method] for c in self.lineage(name) if method in c.nodes), None)

    def has(self, name: str, member: str) -> bool:
        """Whether a class shows a method, property or constant, its own or inherited."""
        return any(member in c.methods or member in c.properties or member in c.constants for c in self.lineage(name))
