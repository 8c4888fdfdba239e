"""A client on the official MCP SDK that starts the tool server it is told, saves the scene as it is, and leaves."""

from __future__ import annotations

import os
import sys

import anyio
from mcp import Client, StdioServerParameters


async def main() -> int:
    """One call; 1 where it failed."""
    server = StdioServerParameters(command=sys.argv[1], args=sys.argv[2:], env=dict(os.environ))
    async with Client(server) as client:
        await client.list_tools()
        answer = await client.call_tool("save_scene_as", {"name": "saved"})
        return int(bool(answer.is_error))


if __name__ == "__main__":
    sys.exit(anyio.run(main))
