"""The page of the tools, made from the registry: ``python -m c4s.toolbox.page > docs/tools.md``."""

from __future__ import annotations

from itertools import groupby
from typing import Any

from c4s.toolbox.registry import ALL_TOOLS
from c4s.toolbox.tool import Tool

_HEAD = """\
# The {count} tools

Made by `python -m c4s.toolbox.page > docs/tools.md`; a test keeps it equal. Lengths are centimetres and rotations
[pitch, yaw, roll] in degrees where nothing else is said. Every answer is one JSON text,
`{{"result" | "error", "budget", "stop"?}}`, and at most one PNG of at most 2 MB. Arguments marked * must be given;
arguments that are not listed are refused.
"""


def _kind(schema: dict[str, Any]) -> str:
    """The type of an argument in a few words, with its limits."""
    if "anyOf" in schema:
        return " or ".join(_kind(one) for one in schema["anyOf"])
    if "enum" in schema:
        return " / ".join(f"`{value}`" for value in schema["enum"])
    kinds = schema["type"]
    words = " or ".join(kinds) if isinstance(kinds, list) else str(kinds)
    if words == "array":
        low, high = schema.get("minItems"), schema.get("maxItems")
        size = "" if high is None else f"{high} " if low == high else f"up to {high} "
        first, _, rest = _kind(schema["items"]).partition(" ")
        return f"list of {size}{first}s {rest}".strip()
    low, high = schema.get("minimum", schema.get("exclusiveMinimum")), schema.get("maximum")
    if low is not None or high is not None:
        over = "> " if "exclusiveMinimum" in schema else ""
        words += f" ({over}{low:g} ...)" if high is None else f" ({over}{low:g} to {high:g})"
    return words + (f", up to {schema['maxLength']} characters" if "maxLength" in schema else "")


def _tool(tool: Tool) -> str:
    rows = [
        f"| `{name}`{'*' if name in tool.required else ''} | {_kind(schema)} | {schema['description']} |"
        for name, schema in tool.properties.items()
    ]
    table = ["| argument | type | meaning |", "|---|---|---|", *rows] if rows else ["No arguments."]
    return "\n".join([f"### {tool.name}", "", tool.description, "", *table, ""])


def tools_page() -> str:
    """The page as Markdown."""
    parts = [_HEAD.format(count=len(ALL_TOOLS))]
    for group, tools in groupby(ALL_TOOLS, key=lambda tool: tool.group):
        parts += [f"## {group}\n", *map(_tool, tools)]
    return "\n".join(parts)


if __name__ == "__main__":
    print(tools_page(), end="")
