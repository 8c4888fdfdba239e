"""The source tree of the checkout, as the house rules read it: every package that ships, benchmarks and tests."""

from __future__ import annotations

import ast
from dataclasses import dataclass
from functools import cache
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
TEXT = (".sql", ".j2", ".js", ".yaml")
"""Suffixes of files that are no Python and can spell a name."""


@dataclass(frozen=True)
class Source:
    """A file: its path from the root of the checkout, its text, and what it says if it is Python."""

    path: str
    text: str
    nodes: tuple[ast.AST, ...]
    strings: tuple[str, ...]
    """The strings of a Python file, docstrings apart; the whole text of another."""

    def within(self, *folders: str) -> bool:
        """Whether the file lies in, or is, one of these paths."""
        return any(self.path == folder or self.path.startswith(f"{folder}/") for folder in folders)


def source(path: str, text: str) -> Source:
    """A file of the tree."""
    if not path.endswith(".py"):
        return Source(path, text, (), (text,))
    nodes = tuple(ast.walk(ast.parse(text)))
    told = {id(node.value) for node in nodes if isinstance(node, ast.Expr)}
    constants = (node for node in nodes if isinstance(node, ast.Constant) and id(node) not in told)
    return Source(path, text, nodes, tuple(node.value for node in constants if isinstance(node.value, str)))


@cache
def packages() -> tuple[str, ...]:
    """The top folders that hold Python."""
    return tuple(sorted({file.parent.name for file in ROOT.glob("[!.]*/*.py")}))


@cache
def sources() -> tuple[Source, ...]:
    """Every file of the packages that a rule can be broken in."""
    return tuple(
        source(str(file.relative_to(ROOT)), file.read_text())
        for package in packages()
        for file in sorted((ROOT / package).rglob("*"))
        if file.suffix in (".py", *TEXT)
    )
