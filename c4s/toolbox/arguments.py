"""The arguments of a call: what is written down of them, and whether they fit the tool's schema."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from c4s.files import canonical_json
from c4s.toolbox.registry import TOOLS, VALIDATORS

_SHOWN_CHARACTERS = 1000


def plain(arguments: Mapping[str, Any]) -> tuple[dict[str, Any], bytes, str]:
    """Arguments that can be written down, the same as JSON, and what is wrong with them (a number that is none)."""
    given = dict(arguments)
    try:
        return given, canonical_json(given).encode(), ""
    except ValueError as error:
        shown = {"unusable": repr(given)[:_SHOWN_CHARACTERS].encode("ascii", "backslashreplace").decode()}
        return shown, canonical_json(shown).encode(), f"invalid arguments: {error}"


def schema_problem(name: str, arguments: dict[str, Any]) -> str:
    """The first way in which arguments break the tool's schema, in one line; empty when they do not."""
    errors = sorted(VALIDATORS[name].iter_errors(arguments), key=lambda error: list(map(str, error.absolute_path)))
    if not errors:
        return ""
    where = ".".join(map(str, errors[0].absolute_path))[:200]
    tool = TOOLS[name]
    takes = ", ".join(f"{key}*" if key in tool.required else key for key in tool.properties) or "no arguments"
    return (
        f"invalid arguments{f' in {where}' if where else ''}: {errors[0].message[:500]} "
        f"({name} takes {takes}; * must be given)"
    )
