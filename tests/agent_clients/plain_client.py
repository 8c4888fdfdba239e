"""A small agent client as a program of its own, on the standard library: chat completions and one MCP server.

``plain_client.py MODEL MODEL_URL MODEL_TOKEN TOOLS_URL TOOLS_TOKEN [PROBE ...]``: the prompt is on standard input. Each
``PROBE`` is a path to read or an address ``host:port`` to reach; what came of it is printed as a JSON line.
"""

from __future__ import annotations

import json
import os
import socket
import sys
import urllib.request
from pathlib import Path
from typing import Any


def post(url: str, body: Any, headers: dict[str, str]) -> tuple[Any, dict[str, str]]:
    request = urllib.request.Request(
        url,
        json.dumps(body).encode(),
        {"Content-Type": "application/json", "Accept": "application/json, text/event-stream", **headers},
    )
    with urllib.request.urlopen(request, timeout=60) as answer:
        text = answer.read().decode()
    if text.startswith(("event:", "data:", ":", "id:")):
        text = next(line[5:] for line in text.splitlines() if line.startswith("data:") and len(line) > 6)
    return (json.loads(text) if text.strip() else None), {k.lower(): v for k, v in answer.headers.items()}


class Tools:
    """The tool server over streamable HTTP."""

    def __init__(self, url: str, token: str) -> None:
        self.url, self.headers, self.number = url, {"Authorization": f"Bearer {token}"}, 0
        _, headers = self._send(
            "initialize",
            {"protocolVersion": "2025-03-26", "capabilities": {}, "clientInfo": {"name": "plain", "version": "1"}},
        )
        self.headers["Mcp-Session-Id"] = headers["mcp-session-id"]
        post(url, {"jsonrpc": "2.0", "method": "notifications/initialized"}, self.headers)

    def _send(self, method: str, params: dict[str, Any]) -> tuple[Any, dict[str, str]]:
        self.number += 1
        return post(self.url, {"jsonrpc": "2.0", "id": self.number, "method": method, "params": params}, self.headers)

    def names(self) -> list[str]:
        return [tool["name"] for tool in self._send("tools/list", {})[0]["result"]["tools"]]

    def call(self, name: str, arguments: dict[str, Any]) -> str:
        content = self._send("tools/call", {"name": name, "arguments": arguments})[0]["result"]["content"]
        return "".join(block.get("text", "") for block in content)


def probe(what: str) -> str:
    host, colon, port = what.partition(":")
    try:
        if colon:
            socket.create_connection((host, int(port)), timeout=5).close()
        else:
            list(Path(what).iterdir()) if Path(what).is_dir() else Path(what).read_bytes()
    except OSError as error:
        return type(error).__name__
    return "reached"


def main() -> None:
    model, model_url, model_token, tools_url, tools_token, *probes = sys.argv[1:]
    found = {what: probe(what) for what in probes}
    home = [path.name for path in Path().iterdir()]
    print(json.dumps({"probes": found, "environment": dict(os.environ), "home": home}), flush=True)
    tools = Tools(tools_url, tools_token)
    specs = [{"type": "function", "function": {"name": name}} for name in tools.names()]
    messages: list[dict[str, Any]] = [{"role": "user", "content": sys.stdin.read()}]
    while True:
        answer, _ = post(
            f"{model_url}/v1/chat/completions",
            {"model": model, "messages": messages, "tools": specs},
            {"Authorization": f"Bearer {model_token}"},
        )
        message = answer["choices"][0]["message"]
        messages.append(message)
        if not message.get("tool_calls"):
            return
        messages += [
            {
                "role": "tool",
                "tool_call_id": call["id"],
                "content": tools.call(call["function"]["name"], json.loads(call["function"]["arguments"])),
            }
            for call in message["tool_calls"]
        ]


if __name__ == "__main__":
    main()
