"""Unreal's text form of structs, ``(X=1.000000,Y=2.000000)``: written and read."""

from __future__ import annotations

from typing import Any

from c4s.engine.headless.unreal.core import TYPES, camel


def write_text(value: Any) -> str:
    """A field's value."""
    if hasattr(value, "export_text"):
        return str(value.export_text())
    return f"{value:.6f}" if isinstance(value, float) else str(value)


def read_text(struct: Any, content: str) -> bool:
    """Set the fields that the text names; False, with nothing set, when it is not the text of such a struct."""
    names = {camel(name).casefold(): name for name in struct._fields}
    found: dict[str, Any] = {}
    try:
        for part in _parts(content):
            key, sign, raw = part.partition("=")
            if not sign:
                return False
            name = names[key.strip().casefold()]
            found[name] = _value(raw.strip(), struct._fields[name].kind)
        for name, value in found.items():
            struct._put(name, value)
    except (KeyError, ValueError, TypeError):
        return False
    return True


def _parts(content: str) -> list[str]:
    text = content.strip()
    if not (text.startswith("(") and text.endswith(")")):
        raise ValueError("no brackets")
    parts, depth, start = [], 0, 1
    for index, letter in enumerate(text[1:-1], 1):
        depth += (letter == "(") - (letter == ")")
        if letter == "," and not depth:
            parts.append(text[start:index])
            start = index + 1
    return [part for part in [*parts, text[start:-1]] if part.strip()]


def _value(raw: str, kind: str) -> Any:
    if kind in ("float", "int"):
        return float(raw) if kind == "float" else int(raw)
    if kind == "bool":
        return {"true": True, "false": False}[raw.casefold()]
    if kind in ("str", "Name", "Text"):
        return raw.strip('"')
    made: Any = TYPES[kind]()
    if not read_text(made, raw):
        raise ValueError(raw)
    return made
