"""The MCP server of the tools, whatever it speaks over."""

from __future__ import annotations

from collections.abc import Callable, Coroutine
from typing import Any

from mcp.server.lowlevel import Server

from c4s.toolbox.registry import TOOLS

Handler = Callable[[Any, Any], Coroutine[Any, Any, Any]]


def protocol_server(list_tools: Handler, call_tool: Handler, list_prompts: Handler, get_prompt: Handler) -> Server[Any]:
    """A server that answers by these four handlers, and checks arguments by the tools' schemas."""
    server: Server[Any] = Server(
        "c4s",
        version="1",
        on_list_tools=list_tools,
        on_call_tool=call_tool,
        on_list_prompts=list_prompts,
        on_get_prompt=get_prompt,
        get_tool_input_schema=lambda name: TOOLS[name].input_schema if name in TOOLS else None,
    )
    server.middleware.clear()  # spans for an exporter that is not there
    return server
