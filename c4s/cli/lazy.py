"""A group whose commands are imported when one is called: starting ``c4s`` costs what the called command needs."""

from __future__ import annotations

import importlib
from collections.abc import Iterator, Mapping
from typing import Any, ClassVar

import typer
from typer.core import TyperCommand, TyperGroup


class LazyGroup(TyperGroup):
    """Subclasses say in ``table`` what there is; help shows it without an import."""

    table: ClassVar[Mapping[str, tuple[str, str]]] = {}
    """For each command, in the order of the help: ``module:attribute``, a function or a ``Typer``, and its help's first
    line."""

    def __init__(self, **attributes: Any) -> None:
        super().__init__(**{**attributes, "commands": _Commands(self.table)})

    def format_help(self, ctx: Any, formatter: Any) -> None:
        """The help with every command's line from the table."""
        shown = {name: TyperCommand(name, help=line) for name, (_, line) in self.table.items()}
        TyperGroup(name=self.name, commands=dict(shown), help=self.help, params=self.params).format_help(ctx, formatter)


class _Commands(Mapping[str, Any]):
    """Commands by name, each imported when it is first asked for."""

    def __init__(self, table: Mapping[str, tuple[str, str]]) -> None:
        self._table = table
        self._loaded: dict[str, Any] = {}

    def __getitem__(self, name: str) -> Any:
        if name not in self._loaded:
            module, _, attribute = self._table[name][0].partition(":")
            self._loaded[name] = _command(name, getattr(importlib.import_module(module), attribute))
        return self._loaded[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._table)

    def __len__(self) -> int:
        return len(self._table)


def _command(name: str, made_of: Any) -> Any:
    if isinstance(made_of, typer.Typer):
        command: Any = typer.main.get_group(made_of)
        command.name = name
        return command
    alone = typer.Typer(add_completion=False, pretty_exceptions_enable=False)
    alone.command(name)(made_of)
    return typer.main.get_command(alone)
