"""The gateway's tools over standard input and output, for a client that starts its MCP servers itself.

Every request is handed on to the gateway over one connection of its own; what a client cancels is cancelled there.
"""

from __future__ import annotations

import json
import threading
from typing import Any

import mcp_types as wire
from mcp import Client
from mcp.server.lowlevel import Server
from mcp.server.stdio import stdio_server

from c4s.toolbox.client import GatewayConnection
from c4s.toolbox.gateway import Endpoint
from c4s.toolbox.protocol_server import protocol_server

ENDED = "the run has ended"


async def serve_stdio(endpoint: Endpoint, ended: threading.Event) -> None:
    """Answer a client until it closes standard input. Once ``ended`` is set every call is told so.

    Standard output belongs to the protocol meanwhile: what else is written there goes to standard error.
    """
    async with GatewayConnection(endpoint, "legacy") as gateway, stdio_server() as (read, write):
        server = _handed_on(gateway, ended)
        await server.run(read, write, server.create_initialization_options())


def _handed_on(gateway: Client, ended: threading.Event) -> Server[Any]:
    async def list_tools(_: Any, __: wire.PaginatedRequestParams | None) -> wire.ListToolsResult:
        return await gateway.list_tools()

    async def call_tool(context: Any, params: wire.CallToolRequestParams) -> wire.CallToolResult:
        if ended.is_set():
            return _over()
        meta: Any = dict(context.meta or {})
        return await gateway.call_tool(params.name, params.arguments or {}, meta=meta)

    async def list_prompts(_: Any, __: wire.PaginatedRequestParams | None) -> wire.ListPromptsResult:
        return await gateway.list_prompts()

    async def get_prompt(_: Any, params: wire.GetPromptRequestParams) -> wire.GetPromptResult:
        return await gateway.get_prompt(params.name)

    return protocol_server(list_tools, call_tool, list_prompts, get_prompt)


def _over() -> wire.CallToolResult:
    text = json.dumps({"error": ENDED, "stop": ENDED})
    return wire.CallToolResult(content=[wire.TextContent(type="text", text=text)], is_error=True)
