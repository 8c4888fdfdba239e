"""The arguments of a call: what is written down of them, and whether they fit the tool's schema."""

from __future__ import annotations

import difflib
from collections.abc import Mapping
from typing import Any

from c4s.files import canonical_json
from c4s.toolbox.registry import TOOLS, VALIDATORS
from c4s.toolbox.schemas import ValidationError
from c4s.toolbox.tool import Schema, kind

_SHOWN_CHARACTERS = 1000
_SHOWN = 200
"""Characters of a wrong value, a name or a description that an error repeats."""


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
        f"invalid arguments{f' in {where}' if where else ''}: {_wrong(errors[0])} "
        f"({name} takes {takes}; * must be given)"
    )


def _wrong(error: ValidationError) -> str:
    """What is wrong, and what is allowed there."""
    schema: Schema = dict(error.schema) if isinstance(error.schema, Mapping) else {}
    if error.validator == "additionalProperties":
        known = list(schema["properties"])
        given = error.instance if isinstance(error.instance, Mapping) else {}
        strange = sorted(set(given) - set(known))
        near = difflib.get_close_matches(strange[0][:_SHOWN], known, n=1)
        return f"there is no {strange[0][:_SHOWN]!r}" + (f": did you mean {near[0]!r}?" if near else "")
    if error.validator == "required":
        return error.message[:_SHOWN]
    shown = repr(error.instance)
    shown = shown if len(shown) <= _SHOWN else f"{shown[:_SHOWN]} ..."
    allowed = kind(schema) if {"type", "enum", "anyOf"} & schema.keys() else ""
    meant = str(schema.get("description", ""))[:_SHOWN]
    return f"{shown} is not allowed: it must be {allowed}" + (f" - {meant}" if meant else "")
