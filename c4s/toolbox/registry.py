"""The one registry of the shared tools (paper, Coding-Agent Interface): 25 tools in seven groups."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from c4s.errors import BadInput
from c4s.toolbox import asset_tools, check_tools, environment_tools, planning_tools, python_tools, scene_tools
from c4s.toolbox.schemas import Draft202012Validator
from c4s.toolbox.tool import Tool

ALL_TOOLS: tuple[Tool, ...] = (
    *asset_tools.TOOLS,
    *scene_tools.TOOLS,
    *python_tools.TOOLS,
    *planning_tools.TOOLS,
    *check_tools.TOOLS,
    *environment_tools.TOOLS,
)
TOOLS: Mapping[str, Tool] = {tool.name: tool for tool in ALL_TOOLS}
VALIDATORS: Mapping[str, Draft202012Validator] = {
    tool.name: Draft202012Validator(tool.input_schema) for tool in ALL_TOOLS
}


def tool_set(names: Iterable[str] | None = None) -> frozenset[str]:
    """The tools of a run: all, or the named ones. ``BadInput`` for a name that is no tool."""
    if names is None:
        return frozenset(TOOLS)
    chosen = frozenset(names)
    if unknown := sorted(chosen - set(TOOLS)):
        raise BadInput(f"no such tool: {', '.join(unknown)}", todo=f"the tools are {', '.join(TOOLS)}")
    return chosen
