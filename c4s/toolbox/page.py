"""The page of the tools, made from the registry: ``python -m c4s.toolbox.page > docs/tools.md``."""

from __future__ import annotations

from itertools import groupby

from c4s.toolbox.registry import ALL_TOOLS
from c4s.toolbox.size import ANSWER_SIZE, ERROR_SIZE
from c4s.toolbox.tool import Tool, kind

_HEAD = """\
# The {count} tools

Made by `python -m c4s.toolbox.page > docs/tools.md`; a test keeps it equal. Lengths are centimetres and rotations
[pitch, yaw, roll] in degrees where nothing else is said. Every answer is one JSON text,
`{{"result" | "error", "budget", "stop"?}}`, and at most one PNG of at most 2 MB. Its text has at most {most:,}
characters (an error {error:,}), unless the arguments ask for more where that is said; long lists come in parts, and
what is left out is counted. Arguments marked * must be given; arguments that are not listed are refused.
"""


def _tool(tool: Tool) -> str:
    rows = [
        f"| `{name}`{'*' if name in tool.required else ''} | {kind(schema)} | {schema['description']} |"
        for name, schema in tool.properties.items()
    ]
    table = ["| argument | type | meaning |", "|---|---|---|", *rows] if rows else ["No arguments."]
    return "\n".join([f"### {tool.name}", "", tool.description, "", *table, ""])


def tools_page() -> str:
    """The page as Markdown."""
    parts = [_HEAD.format(count=len(ALL_TOOLS), most=ANSWER_SIZE, error=ERROR_SIZE)]
    for group, tools in groupby(ALL_TOOLS, key=lambda tool: tool.group):
        parts += [f"## {group}\n", *map(_tool, tools)]
    return "\n".join(parts)


if __name__ == "__main__":
    print(tools_page(), end="")
