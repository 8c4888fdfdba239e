"""A model endpoint that follows a script: it speaks the four wire formats, calls tools, and counts its own usage.

It keeps no state between requests but its books: what it does next follows from the number of tool results in the
request, so a request that a client repeats gets the same answer.
"""

from __future__ import annotations

import asyncio
import json
import re
import socket
import threading
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from types import TracebackType
from typing import Any, Self

import uvicorn
from starlette.types import Receive, Scope, Send

Arguments = Mapping[str, Any] | Callable[[list[str]], Mapping[str, Any]]


@dataclass(frozen=True)
class Use:
    """A tool call of the script. ``arguments`` may be made from the texts of the tool results so far."""

    tool: str
    arguments: Arguments = field(default_factory=dict)


@dataclass(frozen=True)
class Served:
    """One request as the endpoint counted it."""

    wire: str
    model: str
    key: str
    fresh: int
    cache_read: int
    cache_write: int
    output: int
    reasoning: int
    pictures: int
    tools: tuple[str, ...]
    answered: str
    """``tools``, ``text`` or ``side`` (a request without tools: a title, a summary)."""


class ScriptedEndpoint:
    """The server on loopback; a context manager. ``steps`` are tool calls made together; then the text is said."""

    def __init__(self, steps: Sequence[Sequence[Use]], text: str = "The scene is saved.") -> None:
        self.steps, self.text = [list(step) for step in steps], text
        self.served: list[Served] = []
        self.missing: list[str] = []
        self.bodies: list[dict[str, Any]] = []
        self._ready = threading.Event()
        self.port = 0

    def __enter__(self) -> Self:
        listener = socket.socket(socket.AF_INET, socket.SOCK_STREAM, socket.IPPROTO_TCP)
        listener.bind(("127.0.0.1", 0))
        listener.listen(128)
        self.port = listener.getsockname()[1]
        self._server = uvicorn.Server(
            uvicorn.Config(
                self._app,
                log_level="error",
                lifespan="off",
                interface="asgi3",
                access_log=False,
                timeout_graceful_shutdown=1,
            )
        )
        self._thread = threading.Thread(target=self._serve, args=(listener,), daemon=True)
        self._thread.start()
        self._ready.wait()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._server.should_exit = True
        self._thread.join()

    def _serve(self, listener: socket.socket) -> None:
        async def main() -> None:
            self._ready.set()
            await self._server.serve([listener])

        asyncio.run(main())

    @property
    def url(self) -> str:
        return f"http://127.0.0.1:{self.port}"

    def totals(self) -> dict[str, int]:
        """Sums of the endpoint's own counts over all requests."""
        return {
            name: sum(getattr(one, name) for one in self.served)
            for name in ("fresh", "cache_read", "cache_write", "output", "reasoning")
        }

    async def _app(self, scope: Scope, receive: Receive, send: Send) -> None:
        body = b""
        while True:
            message = await receive()
            if message["type"] == "http.disconnect":
                return
            body += message.get("body", b"")
            if not message.get("more_body", False):
                break
        path, headers = scope["path"], {k.decode().lower(): v.decode() for k, v in scope["headers"]}
        key = (
            headers.get("authorization", "").removeprefix("Bearer ")
            or headers.get("x-api-key", "")
            or headers.get("x-goog-api-key", "")
        )
        wire = next((wire for wire in WIRES if re.search(wire.path, path)), None)
        if wire is None or scope["method"] != "POST":
            await _respond(send, 200, "application/json", [b'{"object": "list", "data": [], "models": []}'])
            return
        request = json.loads(body)
        self.bodies.append(request)
        results, pictures, tools = wire.results(request), wire.pictures(request), wire.tools(request)
        uses, said = self._next(results, tools)
        model = request.get("model") or re.sub(r".*/models/([^:]+):.*", r"\1", path)
        answer = json.dumps([[use, arguments] for use, arguments in uses]) + said
        size = len(re.sub(rb"[A-Za-z0-9+/=]{2000,}", b"picture", body)) // 4
        counts = Served(
            wire.name,
            model,
            key,
            fresh=size - size // 2 - size // 8,
            cache_read=size // 2,
            cache_write=0 if wire.name in ("gemini", "openai-responses") else size // 8,
            output=len(answer) // 4 + 11,
            reasoning=0 if wire.name == "anthropic" else 11,
            pictures=pictures,
            tools=tuple(tools),
            answered="tools" if uses else "text" if tools else "side",
        )
        if wire.name in ("gemini", "openai-responses"):
            counts = Served(**{**counts.__dict__, "fresh": size - size // 2})
        self.served.append(counts)
        stream = (wire.name == "gemini" and "stream" in path) or bool(request.get("stream"))
        number = f"{len(self.served)}"
        if stream:
            events = wire.events(model, number, uses, said, counts, request)
            await _respond(send, 200, "text/event-stream", events)
        else:
            await _respond(
                send, 200, "application/json", [json.dumps(wire.whole(model, number, uses, said, counts)).encode()]
            )

    def _next(self, results: list[str], tools: dict[str, Any]) -> tuple[list[tuple[Any, dict[str, Any]]], str]:
        """The next step's calls with the client's names of the tools, or the closing text."""
        if not tools:
            return [], "Scene"
        done = 0
        for step in self.steps:
            if done == len(results):
                uses = []
                for use in step:
                    name = next((name for name in tools if name == use.tool or name.endswith(f"_{use.tool}")), None)
                    if name is None:
                        self.missing.append(use.tool)
                        return [], f"there is no tool {use.tool}"
                    uses.append(
                        (tools[name], dict(use.arguments(results) if callable(use.arguments) else use.arguments))
                    )
                return uses, ""
            done += len(step)
        return [], self.text


async def _respond(send: Send, status: int, kind: str, portions: Sequence[bytes]) -> None:
    await send({"type": "http.response.start", "status": status, "headers": [(b"content-type", kind.encode())]})
    for portion in portions:
        await send({"type": "http.response.body", "body": portion, "more_body": True})
    await send({"type": "http.response.body", "body": b""})


def _event(value: Any, name: str = "") -> bytes:
    return (f"event: {name}\n" if name else "").encode() + b"data: " + json.dumps(value).encode() + b"\n\n"


def _texts(content: Any) -> str:
    if isinstance(content, str):
        return content
    return "".join(part.get("text", "") for part in content or [] if isinstance(part, dict))


class Chat:
    name, path = "openai-chat", r"/chat/completions$"

    def tools(self, request: dict[str, Any]) -> dict[str, Any]:
        return {tool["function"]["name"]: tool["function"]["name"] for tool in request.get("tools") or []}

    def results(self, request: dict[str, Any]) -> list[str]:
        return [_texts(message["content"]) for message in request["messages"] if message["role"] == "tool"]

    def pictures(self, request: dict[str, Any]) -> int:
        return json.dumps(request["messages"]).count('"image_url": {')

    def _calls(self, number: str, uses: list[Any]) -> list[dict[str, Any]]:
        return [
            {
                "index": i,
                "id": f"call_{number}_{i}",
                "type": "function",
                "function": {"name": name, "arguments": json.dumps(arguments)},
            }
            for i, (name, arguments) in enumerate(uses)
        ]

    def _usage(self, c: Served) -> dict[str, Any]:
        total = c.fresh + c.cache_read + c.cache_write
        return {
            "prompt_tokens": total,
            "completion_tokens": c.output,
            "total_tokens": total + c.output,
            "prompt_tokens_details": {"cached_tokens": c.cache_read, "cache_write_tokens": c.cache_write},
            "completion_tokens_details": {"reasoning_tokens": c.reasoning},
        }

    def whole(self, model: str, number: str, uses: list[Any], text: str, counts: Served) -> dict[str, Any]:
        message = {"role": "assistant", "content": text or None}
        if uses:
            message["tool_calls"] = self._calls(number, uses)
        return {
            "id": f"chat-{number}",
            "object": "chat.completion",
            "created": 1,
            "model": model,
            "choices": [{"index": 0, "message": message, "finish_reason": "tool_calls" if uses else "stop"}],
            "usage": self._usage(counts),
        }

    def events(
        self, model: str, number: str, uses: list[Any], text: str, counts: Served, request: dict[str, Any]
    ) -> list[bytes]:
        head = {"id": f"chat-{number}", "object": "chat.completion.chunk", "created": 1, "model": model}
        delta = {"role": "assistant", **({"tool_calls": self._calls(number, uses)} if uses else {"content": text})}
        found = [
            _event({**head, "choices": [{"index": 0, "delta": delta, "finish_reason": None}]}),
            _event({**head, "choices": [{"index": 0, "delta": {}, "finish_reason": "tool_calls" if uses else "stop"}]}),
        ]
        if (request.get("stream_options") or {}).get("include_usage"):
            found.append(_event({**head, "choices": [], "usage": self._usage(counts)}))
        return [*found, b"data: [DONE]\n\n"]


class Responses:
    name, path = "openai-responses", r"/responses$"

    def tools(self, request: dict[str, Any]) -> dict[str, Any]:
        """Client's full name to how a call names it; tools may be grouped in a namespace."""
        found: dict[str, Any] = {}
        for tool in request.get("tools") or []:
            if tool.get("type") == "function":
                found[tool["name"]] = {"name": tool["name"]}
            elif tool.get("type") == "namespace":
                for inner in tool["tools"]:
                    found[f"{tool['name']}_{inner['name']}"] = {"name": inner["name"], "namespace": tool["name"]}
        return found

    def results(self, request: dict[str, Any]) -> list[str]:
        return [_texts(item["output"]) for item in self._items(request) if item.get("type") == "function_call_output"]

    def _items(self, request: dict[str, Any]) -> list[dict[str, Any]]:
        return request["input"] if isinstance(request["input"], list) else []

    def pictures(self, request: dict[str, Any]) -> int:
        return json.dumps(request["input"]).count('"input_image"')

    def _items_out(self, number: str, uses: list[Any], text: str) -> list[dict[str, Any]]:
        if uses:
            return [
                {
                    "type": "function_call",
                    "id": f"fc_{number}_{i}",
                    "call_id": f"call_{number}_{i}",
                    "status": "completed",
                    **name,
                    "arguments": json.dumps(arguments),
                }
                for i, (name, arguments) in enumerate(uses)
            ]
        return [
            {
                "type": "message",
                "id": f"msg_{number}",
                "role": "assistant",
                "status": "completed",
                "content": [{"type": "output_text", "text": text, "annotations": []}],
            }
        ]

    def whole(self, model: str, number: str, uses: list[Any], text: str, counts: Served) -> dict[str, Any]:
        total = counts.fresh + counts.cache_read
        return {
            "id": f"resp-{number}",
            "object": "response",
            "created_at": 1,
            "model": model,
            "status": "completed",
            "output": self._items_out(number, uses, text),
            "error": None,
            "incomplete_details": None,
            "usage": {
                "input_tokens": total,
                "input_tokens_details": {"cached_tokens": counts.cache_read},
                "output_tokens": counts.output,
                "output_tokens_details": {"reasoning_tokens": counts.reasoning},
                "total_tokens": total + counts.output,
            },
        }

    def events(
        self, model: str, number: str, uses: list[Any], text: str, counts: Served, request: dict[str, Any]
    ) -> list[bytes]:
        whole = self.whole(model, number, uses, text, counts)
        begun = {**whole, "status": "in_progress", "output": [], "usage": None}
        found = [_event({"type": "response.created", "response": begun}, "response.created")]
        for i, item in enumerate(whole["output"]):
            found += [
                _event({"type": kind, "output_index": i, "item": item}, kind)
                for kind in ("response.output_item.added", "response.output_item.done")
            ]
        return [*found, _event({"type": "response.completed", "response": whole}, "response.completed")]


class Messages:
    name, path = "anthropic", r"/messages$"

    def tools(self, request: dict[str, Any]) -> dict[str, Any]:
        return {tool["name"]: tool["name"] for tool in request.get("tools") or []}

    def _blocks(self, request: dict[str, Any]) -> list[dict[str, Any]]:
        return [
            block
            for message in request["messages"]
            if isinstance(message["content"], list)
            for block in message["content"]
        ]

    def results(self, request: dict[str, Any]) -> list[str]:
        return [_texts(block.get("content")) for block in self._blocks(request) if block["type"] == "tool_result"]

    def pictures(self, request: dict[str, Any]) -> int:
        return json.dumps(request["messages"]).count('"type": "image"')

    def _content(self, number: str, uses: list[Any], text: str) -> list[dict[str, Any]]:
        return [
            {"type": "tool_use", "id": f"toolu_{number}_{i}", "name": name, "input": arguments}
            for i, (name, arguments) in enumerate(uses)
        ] or [{"type": "text", "text": text}]

    def _usage(self, c: Served) -> dict[str, Any]:
        return {
            "input_tokens": c.fresh,
            "cache_read_input_tokens": c.cache_read,
            "cache_creation_input_tokens": c.cache_write,
            "cache_creation": {"ephemeral_5m_input_tokens": c.cache_write, "ephemeral_1h_input_tokens": 0},
            "output_tokens": c.output,
        }

    def whole(self, model: str, number: str, uses: list[Any], text: str, counts: Served) -> dict[str, Any]:
        return {
            "id": f"msg_{number}",
            "type": "message",
            "role": "assistant",
            "model": model,
            "content": self._content(number, uses, text),
            "stop_reason": "tool_use" if uses else "end_turn",
            "stop_sequence": None,
            "usage": self._usage(counts),
        }

    def events(
        self, model: str, number: str, uses: list[Any], text: str, counts: Served, request: dict[str, Any]
    ) -> list[bytes]:
        whole = self.whole(model, number, uses, text, counts)
        begun = {**whole, "content": [], "stop_reason": None, "usage": {**whole["usage"], "output_tokens": 1}}
        found = [{"type": "message_start", "message": begun}]
        for i, block in enumerate(whole["content"]):
            if uses:
                found += [
                    {"type": "content_block_start", "index": i, "content_block": {**block, "input": {}}},
                    {
                        "type": "content_block_delta",
                        "index": i,
                        "delta": {"type": "input_json_delta", "partial_json": json.dumps(block["input"])},
                    },
                ]
            else:
                found += [
                    {"type": "content_block_start", "index": i, "content_block": {"type": "text", "text": ""}},
                    {"type": "content_block_delta", "index": i, "delta": {"type": "text_delta", "text": text}},
                ]
            found.append({"type": "content_block_stop", "index": i})
        found += [
            {
                "type": "message_delta",
                "delta": {"stop_reason": whole["stop_reason"], "stop_sequence": None},
                "usage": {"output_tokens": counts.output},
            },
            {"type": "message_stop"},
        ]
        return [_event(event, event["type"]) for event in found]


class Gemini:
    name, path = "gemini", r"/models/[^:]+:(generateContent|streamGenerateContent)$"

    def tools(self, request: dict[str, Any]) -> dict[str, Any]:
        return {
            one["name"]: one["name"]
            for tool in request.get("tools") or []
            for one in tool.get("functionDeclarations") or []
        }

    def _parts(self, request: dict[str, Any]) -> list[dict[str, Any]]:
        return [part for content in request["contents"] for part in content.get("parts") or []]

    def results(self, request: dict[str, Any]) -> list[str]:
        return [
            json.dumps(part["functionResponse"].get("response"))
            for part in self._parts(request)
            if "functionResponse" in part
        ]

    def pictures(self, request: dict[str, Any]) -> int:
        return json.dumps(request["contents"]).count('"inlineData"')

    def whole(self, model: str, number: str, uses: list[Any], text: str, counts: Served) -> dict[str, Any]:
        parts = [
            {"functionCall": {"id": f"call_{number}_{i}", "name": name, "args": arguments}}
            for i, (name, arguments) in enumerate(uses)
        ] or [{"text": text}]
        prompt = counts.fresh + counts.cache_read
        return {
            "candidates": [{"index": 0, "content": {"role": "model", "parts": parts}, "finishReason": "STOP"}],
            "modelVersion": model,
            "responseId": f"r-{number}",
            "usageMetadata": {
                "promptTokenCount": prompt,
                "cachedContentTokenCount": counts.cache_read,
                "candidatesTokenCount": counts.output - counts.reasoning,
                "thoughtsTokenCount": counts.reasoning,
                "totalTokenCount": prompt + counts.output,
            },
        }

    def events(
        self, model: str, number: str, uses: list[Any], text: str, counts: Served, request: dict[str, Any]
    ) -> list[bytes]:
        return [_event(self.whole(model, number, uses, text, counts))]


WIRES = (Chat(), Responses(), Messages(), Gemini())
