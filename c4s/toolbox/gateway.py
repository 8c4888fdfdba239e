"""The gateway: one MCP server on loopback for many runs. A token selects the run: a bearer's, or the end of the path.

The SDK's low-level server speaks streamable HTTP (stateful, events), so ``tools/list`` and ``tools/call`` are ours.
Three things are done in front of it: the door (``c4s.loopback``), the token check, and joining of two posts with one
request id that are in flight at the same time, which the SDK would leave hanging.
"""

from __future__ import annotations

import asyncio
import base64
import hashlib
import json
import socket
import threading
from collections import Counter
from collections.abc import MutableMapping
from dataclasses import dataclass
from types import TracebackType
from typing import Any, Self

import mcp_types as wire
import uvicorn
from mcp.shared.exceptions import MCPError
from starlette.responses import JSONResponse
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from c4s import loopback
from c4s.errors import MachineryFault
from c4s.files import parse_json
from c4s.toolbox.gateway_run import CallAnswer, Run
from c4s.toolbox.protocol_server import protocol_server
from c4s.toolbox.registry import ALL_TOOLS
from c4s.toolbox.size import MAX_BODY_BYTES
from c4s.toolbox.skill import skill_text

START_TIMEOUT_S = 20.0
SKILL = "skill"
"""Name of the MCP prompt that gives the skill text."""
PATH = "/mcp"
MOST_SESSIONS = 256
"""Sessions that a run may open in all."""
CLOSE = {"Connection": "close"}
ASKED = "asked"
"""Where the state of a request holds the call that it asked for."""
SIZE = "anthropic/maxResultSizeChars"
"""Where a client reads how much text the answers of a tool may have."""
REQUEST_KEYS = ("claudecode/toolUseId", "callId", "c4s/callId")
"""Where clients put the identity of a call in ``_meta`` (Claude Code, Codex, ours)."""


@dataclass(frozen=True)
class Endpoint:
    """Where a client reaches a run, and the token that selects it."""

    url: str
    token: str

    @property
    def url_with_token(self) -> str:
        """The address for a client that cannot send headers: the token is its last part."""
        return f"{self.url}/{self.token}"


class Gateway:
    """The server. Use it as a context manager; ``open`` and ``close`` of runs are thread-safe."""

    def __init__(self, limits: loopback.DoorLimits | None = None, *, port: int = 0) -> None:
        """``port`` 0 is any that is free; ``BadInput`` at the start where another one is taken."""
        self._limits = limits or loopback.DoorLimits()
        self._runs: dict[bytes, Run] = {}
        """By the digest of their token: the time of a look-up tells nothing of a token."""
        self._session_owner: dict[str, Run] = {}
        self._opened: Counter[Run] = Counter()
        """How many sessions a run has opened."""
        self._in_flight: dict[tuple[str, str], _Flight] = {}
        self._loop: asyncio.AbstractEventLoop | None = None
        self._server: uvicorn.Server | None = None
        self._thread: threading.Thread | None = None
        self._ready = threading.Event()
        self.port = port

    def __enter__(self) -> Self:
        listener = loopback.listener(self.port)
        self.port = listener.getsockname()[1]
        self._server = uvicorn.Server(loopback.config(self._app(), self._limits, log_level="critical", lifespan="on"))
        self._thread = threading.Thread(target=self._serve, args=(listener,), name="gateway", daemon=True)
        self._thread.start()
        if not self._ready.wait(START_TIMEOUT_S):
            raise MachineryFault("the gateway did not start", where=f"127.0.0.1:{self.port}")
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        assert self._server is not None and self._thread is not None
        for run in list(self._runs.values()):
            self.close_run(run)
        self._server.should_exit = True
        self._thread.join()

    def _serve(self, listener: socket.socket) -> None:
        async def main() -> None:
            assert self._server is not None
            self._loop = asyncio.get_running_loop()
            self._ready.set()
            await self._server.serve([listener])

        asyncio.run(main())

    def open_run(self, run: Run) -> Endpoint:
        """Admit a run and start its clock."""
        assert self._loop is not None, "the gateway has not started"
        self._runs[_digest(run.token)] = run
        run.start(self._loop)
        return Endpoint(f"http://127.0.0.1:{self.port}{PATH}", run.token)

    def close_run(self, run: Run) -> None:
        """End a run, if it has not ended, and forget its token."""
        run.end("finished", "the agent has finished")
        self._runs.pop(_digest(run.token), None)
        for session, owner in list(self._session_owner.items()):
            if owner is run:
                del self._session_owner[session]
        self._opened.pop(run, None)

    def _app(self) -> ASGIApp:
        server = protocol_server(_list_tools, _call_tool, _list_prompts, _get_prompt)
        inner = server.streamable_http_app(
            host="127.0.0.1", max_request_body_size=MAX_BODY_BYTES, session_idle_timeout=None
        )

        async def app(scope: Scope, receive: Receive, send: Send) -> None:
            if scope["type"] != "http":
                await inner(scope, receive, send)
                return
            strange = loopback.foreign(scope)
            if strange is not None:
                await JSONResponse({"error": strange}, 403, CLOSE)(scope, receive, send)
                return
            headers = dict(scope["headers"])  # lower-case names, as ASGI has them
            run = self._run_of(_token_of(scope["path"], headers.get(b"authorization", b"").decode("latin-1")))
            session = headers.get(b"mcp-session-id", b"").decode("latin-1")
            if run is None:
                await JSONResponse({"error": "unauthorized"}, 401, {"WWW-Authenticate": "Bearer", **CLOSE})(
                    scope, receive, send
                )
            elif not loopback.let_in(scope, run):
                await JSONResponse({"error": "this run has too many connections"}, 429, CLOSE)(scope, receive, send)
            elif session and self._session_owner.get(session) is not run:
                await JSONResponse({"error": "session not found"}, 404)(scope, receive, send)
            else:
                scope.setdefault("state", {})["run"] = run
                scope = {**scope, "path": PATH, "raw_path": PATH.encode()}
                heard = _Heard(receive, send)
                await self._forward(inner, run, session, scope, heard.receive, heard.send)
                if heard.hung_up and ASKED in scope["state"]:
                    run.lose(scope["state"][ASKED])

        return app

    def _run_of(self, token: str) -> Run | None:
        return self._runs.get(_digest(token)) if token else None

    async def _forward(
        self, inner: ASGIApp, run: Run, session: str, scope: Scope, receive: Receive, send: Send
    ) -> None:
        """Hand a request to the SDK; a repeat of one that is in flight waits for the first one's response."""

        async def noting(message: Message) -> None:
            """Pass on an answer; a session that it opens belongs to the run."""
            if message["type"] == "http.response.start":
                for key, value in message["headers"]:
                    if key.lower() == b"mcp-session-id":
                        self._session_owner[value.decode("latin-1")] = run
                        self._opened[run] += 1
            await send(message)

        if not session and self._opened[run] >= MOST_SESSIONS:
            await JSONResponse({"error": "this run has opened too many sessions"}, 429)(scope, receive, send)
            return
        if scope["method"] != "POST" or not session:
            await inner(scope, receive, noting if not session else send)
            return
        body, replay = await _read_body(receive)
        call = _call_of(body)
        if call is None:
            await inner(scope, replay, send)
            return
        flight = self._in_flight.get((session, call[0]))
        if flight is not None:
            if flight.body != body:
                await JSONResponse({"error": "another request with this id is in flight"}, 409)(scope, receive, send)
                return
            run.record_duplicate(call[1], f"{session}:{call[0]}")
            await flight.replay(send)
            return
        flight = self._in_flight[session, call[0]] = _Flight(body)
        try:
            await inner(scope, replay, flight.recording(send))
        finally:
            del self._in_flight[session, call[0]]
            flight.done.set()


def _token_of(path: str, authorization: str) -> str:
    """The token that a request shows: a bearer's, else the end of its path; empty for one that shows none."""
    scheme, _, token = authorization.partition(" ")
    if scheme.lower() == "bearer":
        return token.strip() if path == PATH else ""
    return path.removeprefix(f"{PATH}/") if path.startswith(f"{PATH}/") else ""


def _digest(token: str) -> bytes:
    return hashlib.sha256(token.encode()).digest()


class _Heard:
    """The two ends of a request, and whether its client hung up before the answer was out."""

    def __init__(self, receive: Receive, send: Send) -> None:
        self._receive, self._send = receive, send
        self._answered = False
        self.hung_up = False

    async def receive(self) -> Message:
        message = await self._receive()
        if message["type"] == "http.disconnect" and not self._answered:
            self.hung_up = True
        return message

    async def send(self, message: Message) -> None:
        if message["type"] == "http.response.body" and not message.get("more_body", False):
            self._answered = True
        await self._send(message)


class _Flight:
    """A call in flight: its body, and its response as it goes out."""

    def __init__(self, body: bytes) -> None:
        self.body = body
        self.done = asyncio.Event()
        self._messages: list[Message] = []

    def recording(self, send: Send) -> Send:
        async def both(message: Message) -> None:
            self._messages.append(message)
            await send(message)

        return both

    async def replay(self, send: Send) -> None:
        await self.done.wait()
        for message in self._messages:
            await send(message)


async def _read_body(receive: Receive) -> tuple[bytes, Receive]:
    """The body, up to a little over the limit (the SDK refuses more), and a ``receive`` that gives it again."""
    taken: list[Message] = []
    body = b""
    while len(body) <= MAX_BODY_BYTES:
        message = await receive()
        taken.append(message)
        body += message.get("body", b"")
        if message["type"] != "http.request" or not message.get("more_body", False):
            break

    async def replay() -> MutableMapping[str, Any]:
        return taken.pop(0) if taken else await receive()

    return body, replay


def _call_of(body: bytes) -> tuple[str, str] | None:
    """(request id as JSON, tool name) of a ``tools/call`` post."""
    try:
        message = parse_json(body)
    except (ValueError, RecursionError):
        return None
    if not isinstance(message, dict) or message.get("method") != "tools/call" or "id" not in message:
        return None
    params = message.get("params")
    return json.dumps(message["id"]), str(params.get("name")) if isinstance(params, dict) else ""


def _run_in(context: Any) -> Run:
    request = context.request
    run = request.scope["state"]["run"] if request is not None else None
    if not isinstance(run, Run):
        raise MCPError(wire.INVALID_REQUEST, "no run")
    return run


async def _list_tools(context: Any, _: wire.PaginatedRequestParams | None) -> wire.ListToolsResult:
    run = _run_in(context)
    return wire.ListToolsResult(
        tools=[
            wire.Tool(
                name=tool.name, description=tool.description, input_schema=tool.input_schema, meta={SIZE: tool.most}
            )
            for tool in ALL_TOOLS
            if tool.name in run.tools
        ]
    )


async def _list_prompts(context: Any, _: wire.PaginatedRequestParams | None) -> wire.ListPromptsResult:
    _run_in(context)
    return wire.ListPromptsResult(prompts=[wire.Prompt(name=SKILL, description="How to use these tools.")])


async def _get_prompt(context: Any, params: wire.GetPromptRequestParams) -> wire.GetPromptResult:
    _run_in(context)
    if params.name != SKILL:
        raise MCPError(wire.INVALID_PARAMS, f"the only prompt is {SKILL!r}")
    text = wire.TextContent(type="text", text=skill_text())
    return wire.GetPromptResult(messages=[wire.PromptMessage(role="user", content=text)])


async def _call_tool(context: Any, params: wire.CallToolRequestParams) -> wire.CallToolResult:
    run = _run_in(context)
    asked = run.ask(params.name, params.arguments or {}, *_request_key(context))
    context.request.scope["state"][ASKED] = asked
    try:
        return _wire_answer(await asyncio.shield(asked.answered))
    except asyncio.CancelledError:
        run.lose(asked)
        raise


def _request_key(context: Any) -> tuple[str | None, bool]:
    """The identity of a call, and whether it is the client's own id of the tool use; else it is made of session and
    request id, where there is a session."""
    meta = dict(context.meta or {})
    for name in REQUEST_KEYS:
        if meta.get(name):
            return f"{name}:{meta[name]}", True
    session = context.request.headers.get("mcp-session-id")
    return (f"{session}:{json.dumps(context.request_id)}" if session else None), False


def _wire_answer(answer: CallAnswer) -> wire.CallToolResult:
    """Text first, then the picture. Never ``structuredContent``: clients drop it or the picture."""
    content: list[wire.ContentBlock] = [wire.TextContent(type="text", text=answer.text)]
    if answer.image is not None:
        content.append(
            wire.ImageContent(type="image", mime_type="image/png", data=base64.b64encode(answer.image).decode())
        )
    return wire.CallToolResult(content=content, is_error=answer.error)
