"""The reference of all file formats, read off their JSON Schemas."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

_HEAD = """# Formats

Every file that c4s writes has a format with a name and a version, and one checker. Field by field, as in the JSON
Schemas of `docs/schemas`; `python -m c4s.records.schemas` makes those from the record models.
"""


def formats_page(schemas: Path) -> str:
    """The page as Markdown, from a folder of ``*.schema.json``."""
    parts = [_HEAD]
    for path in sorted(schemas.glob("*.schema.json")):
        schema = json.loads(path.read_text(encoding="utf-8"))
        parts += [f"## {path.name.removesuffix('.schema.json')}\n", *_object(schema)]
        for name, inner in schema.get("$defs", {}).items():
            if inner.get("properties"):
                parts += [f"`{name}`:\n", *_object(inner)]
    return "\n".join(parts)


def _object(schema: dict[str, Any]) -> list[str]:
    needed = set(schema.get("required", ()))
    rows = [
        f"| `{name}` | {_kind(field)} | {'yes' if name in needed else 'no'} | {_cell(field.get('description', ''))} |"
        for name, field in schema.get("properties", {}).items()
    ]
    about = [_cell(schema["description"]) + "\n"] if schema.get("description") else []
    return [*about, "| Field | Type | Needed | What it is |", "|---|---|---|---|", *rows, ""]


def _kind(field: dict[str, Any]) -> str:
    if "$ref" in field:
        return f"`{field['$ref'].rpartition('/')[2]}`"
    if "const" in field:
        return f"`{json.dumps(field['const'])}`"
    if "enum" in field:
        return ", ".join(f"`{json.dumps(value)}`" for value in field["enum"])
    for joined in ("anyOf", "oneOf", "allOf"):
        if joined in field:
            return " or ".join(dict.fromkeys(_kind(one) for one in field[joined]))
    if field.get("type") == "array":
        return f"array of {_kind(field.get('items') or {})}"
    if field.get("type") == "object" and isinstance(field.get("additionalProperties"), dict):
        return f"object of {_kind(field['additionalProperties'])}"
    return str(field.get("type", "any"))


def _cell(text: str) -> str:
    return " ".join(text.split()).replace("|", "\\|").replace("<", "\\<").replace("``", "`")
