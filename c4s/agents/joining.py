"""Agent clients of other distributions, which join by the entry-point group ``c4s.agents``.

An entry point's name is the client's, its object a class that is made without arguments (``c4s.agents.base.Agent``). No
name of c4s's own can be taken.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass
from importlib.metadata import EntryPoint, entry_points
from typing import Any

from c4s.errors import BadInput
from c4s.names import name_fault

GROUP = "c4s.agents"


@dataclass(frozen=True)
class Joined:
    """A client of another distribution."""

    name: str
    entry_points: tuple[EntryPoint, ...]
    problem: str
    """Why it cannot be used; empty where it can, as far as is known before it is loaded."""

    @property
    def distribution(self) -> str:
        """Name and version of what it comes from."""
        found = self.entry_points[0].dist
        return f"{found.name} {found.version}" if found is not None else "an unknown distribution"

    def make(self) -> Any:
        """An object of its class. ``BadInput`` where it cannot be used or loaded."""
        where = f"entry point {self.name!r} of {self.distribution}"
        if self.problem:
            raise BadInput(self.problem, where=where)
        try:
            made = self.entry_points[0].load()()
        except Exception as error:
            raise BadInput(
                f"this agent client cannot be loaded: {type(error).__name__.removesuffix('Error')}: {error}",
                where=where,
            ) from error
        if not callable(getattr(made, "run", None)):
            raise BadInput("this agent client has no method `run`", where=where, todo="see docs/agents.md")
        return made


def joined(own: Collection[str]) -> dict[str, Joined]:
    """The clients of other distributions that are installed here, by name; ``own`` are c4s's."""
    found: dict[str, list[EntryPoint]] = {}
    for entry in entry_points(group=GROUP):
        found.setdefault(entry.name, []).append(entry)
    return {name: Joined(name, tuple(entries), _problem(name, entries, own)) for name, entries in sorted(found.items())}


def _problem(name: str, entries: list[EntryPoint], own: Collection[str]) -> str:
    if name in own:
        return f"the name {name!r} is that of a client of c4s's own"
    if len({entry.value for entry in entries}) > 1:
        return f"{len(entries)} distributions have a client of this name"
    fault = name_fault(name)
    return f"{name!r} is no name of a client: {fault}" if fault else ""
