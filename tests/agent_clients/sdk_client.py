"""A small agent client as a program of its own, on the official MCP SDK: any program that is no adapter's stands so.

``sdk_client.py chat|gemini MCP_FILE MODEL``: the tool server stands in the file, as clients read it; the model's
address and token in ``MODEL_URL`` and ``MODEL_TOKEN``, or in the two variables of a Gemini client; the prompt on
standard input.
"""

from __future__ import annotations

import asyncio
import json
import os
import sys
from pathlib import Path
from typing import Any

import httpx2
from mcp import Client
from mcp.client.streamable_http import streamable_http_client

Call = tuple[str, str, dict[str, Any]]
"""Id, tool and arguments of a call that the model asks for."""
PREFIX = "c4s_"


class Chat:
    """Chat completions."""

    def __init__(self, model: str, prompt: str, tools: list[Any]) -> None:
        self.messages: list[dict[str, Any]] = [{"role": "user", "content": prompt}]
        self.path = "/v1/chat/completions"
        self.headers = {"Authorization": f"Bearer {os.environ['MODEL_TOKEN']}"}
        self.fixed = {
            "model": model,
            "tools": [
                {
                    "type": "function",
                    "function": {
                        "name": PREFIX + tool.name,
                        "description": tool.description,
                        "parameters": tool.input_schema,
                    },
                }
                for tool in tools
            ],
        }

    def body(self) -> dict[str, Any]:
        return {**self.fixed, "messages": self.messages}

    def read(self, answer: Any) -> tuple[list[Call], str]:
        message = answer["choices"][0]["message"]
        self.messages.append(message)
        return [
            (call["id"], call["function"]["name"].removeprefix(PREFIX), json.loads(call["function"]["arguments"]))
            for call in message.get("tool_calls") or []
        ], message["content"] or ""

    def add(self, told: list[tuple[Call, str, list[str]]]) -> None:
        self.messages += [{"role": "tool", "tool_call_id": call[0], "content": text} for call, text, _ in told]
        self.messages += [
            {
                "role": "user",
                "content": [{"type": "image_url", "image_url": {"url": f"data:image/png;base64,{picture}"}}],
            }
            for *_, pictures in told
            for picture in pictures
        ]


class Gemini:
    """generateContent."""

    def __init__(self, model: str, prompt: str, tools: list[Any]) -> None:
        self.contents: list[dict[str, Any]] = [{"role": "user", "parts": [{"text": prompt}]}]
        self.path = f"/v1beta/models/{model}:generateContent"
        self.headers = {"x-goog-api-key": os.environ["GEMINI_API_KEY"]}
        self.tools = [
            {
                "functionDeclarations": [
                    {
                        "name": PREFIX + tool.name,
                        "description": tool.description,
                        "parametersJsonSchema": tool.input_schema,
                    }
                    for tool in tools
                ]
            }
        ]

    def body(self) -> dict[str, Any]:
        return {"contents": self.contents, "tools": self.tools}

    def read(self, answer: Any) -> tuple[list[Call], str]:
        content = answer["candidates"][0]["content"]
        self.contents.append(content)
        calls = [part["functionCall"] for part in content["parts"] if "functionCall" in part]
        return [(call["id"], call["name"].removeprefix(PREFIX), call["args"]) for call in calls], "".join(
            part.get("text", "") for part in content["parts"]
        )

    def add(self, told: list[tuple[Call, str, list[str]]]) -> None:
        parts: list[dict[str, Any]] = [
            {"functionResponse": {"id": call[0], "name": PREFIX + call[1], "response": {"output": text}}}
            for call, text, _ in told
        ]
        parts += [
            {"inlineData": {"mimeType": "image/png", "data": picture}} for *_, pictures in told for picture in pictures
        ]
        self.contents.append({"role": "user", "parts": parts})


async def main(wire: str, mcp_file: str, model: str) -> None:
    (server,) = json.loads(Path(mcp_file).read_text())["mcpServers"].values()
    url = os.environ.get("MODEL_URL") or os.environ["GOOGLE_GEMINI_BASE_URL"]
    async with (
        httpx2.AsyncClient(trust_env=False, timeout=300) as http,
        httpx2.AsyncClient(trust_env=False, timeout=300, headers=server["headers"]) as tools_http,
        Client(
            streamable_http_client(server.get("url") or server["serverUrl"], http_client=tools_http), mode="auto"
        ) as client,
    ):
        talk = (Gemini if wire == "gemini" else Chat)(model, sys.stdin.read(), (await client.list_tools()).tools)

        async def carry_out(call: Call) -> tuple[Call, str, list[str]]:
            answer = await client.call_tool(call[1], call[2])
            return (
                call,
                "".join(block.text for block in answer.content if block.type == "text"),
                [block.data for block in answer.content if block.type == "image"],
            )

        while True:
            answer = await http.post(url + talk.path, json=talk.body(), headers=talk.headers)
            calls, text = talk.read(answer.raise_for_status().json())
            if not calls:
                print(json.dumps({"text": text, "protocol": client.protocol_version}))
                return
            talk.add(await asyncio.gather(*map(carry_out, calls)))


if __name__ == "__main__":
    asyncio.run(main(*sys.argv[1:4]))
