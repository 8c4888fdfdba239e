"""A plain client of the gateway for agents that run in this process: the SDK's MCP client behind blocking calls.

The SDK is loaded when a client connects: whoever only asks which agents there are needs none.
"""

from __future__ import annotations

import base64
import json
import ssl
import uuid
from contextlib import AsyncExitStack, ExitStack
from dataclasses import dataclass
from types import TracebackType
from typing import TYPE_CHECKING, Any, Literal, Self

from c4s.errors import AgentFault, MachineryFault
from c4s.toolbox.size import MAX_BODY_BYTES

if TYPE_CHECKING:
    import mcp_types as wire
    from anyio.from_thread import BlockingPortal
    from mcp import Client

    from c4s.toolbox.gateway import Endpoint

CONNECT_TIMEOUT_S = 30.0
ACTORS_A_CALL = 1000
MOST_CALL_BYTES = MAX_BODY_BYTES - (64 << 10)
"""Of a call's name and arguments; the rest of what the gateway takes is for what goes around them."""
MOST_NESTING = 64
NO_CERTIFICATES = ssl.SSLContext(ssl.PROTOCOL_TLS_CLIENT)
"""The gateway is plain HTTP on this machine; loading the usual certificates takes longer than a call."""


class RunStopped(AgentFault):
    """The run takes no more calls: a budget is spent, or it was ended."""


class CallRefused(AgentFault):
    """A tool call failed; the message is what the agent is told."""


@dataclass(frozen=True)
class ToolAnswer:
    """The answer to a call: data, PNG pictures, and the budget left."""

    data: dict[str, Any]
    images: tuple[bytes, ...]
    budget: dict[str, Any]


class GatewayClient:
    """Calls tools of a run. A context manager; one call at a time a thread, any number of threads."""

    def __init__(self, endpoint: Endpoint, *, mode: Literal["auto", "legacy"] = "legacy") -> None:
        self._endpoint, self._mode = endpoint, mode
        self._stack = ExitStack()
        self._portal: BlockingPortal | None = None
        self._client: Client | None = None

    def __enter__(self) -> Self:
        from anyio.from_thread import start_blocking_portal

        try:
            self._portal = self._stack.enter_context(start_blocking_portal())
            self._client = self._stack.enter_context(
                self._portal.wrap_async_context_manager(GatewayConnection(self._endpoint, self._mode))
            )
        except BaseException:
            self._stack.close()
            raise
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._stack.close()

    def _opened(self) -> tuple[BlockingPortal, Client]:
        if self._portal is None or self._client is None:
            raise MachineryFault("the gateway client is not open")
        return self._portal, self._client

    def tools(self) -> list[wire.Tool]:
        """The tools of this run, with their schemas."""
        portal, client = self._opened()
        return portal.call(client.list_tools).tools

    def prompt(self, name: str) -> str:
        """Text of a prompt that the server offers."""
        import mcp_types as wire

        portal, client = self._opened()
        found = portal.call(client.get_prompt, name)
        return "".join(
            message.content.text for message in found.messages if isinstance(message.content, wire.TextContent)
        )

    def answer(self, name: str, arguments: dict[str, Any], *, call_id: str | None = None) -> wire.CallToolResult:
        """One call as it comes over the wire. ``call_id`` identifies the call; a repeat gets the first answer.

        ``CallRefused`` for a call that cannot be sent (``call_fault``); nothing of it reaches the gateway.
        """
        portal, client = self._opened()
        fault = call_fault(name, arguments)
        if fault is not None:
            raise CallRefused(fault, where=name[:100].encode(errors="replace").decode())
        meta: Any = {"c4s/callId": call_id or uuid.uuid4().hex}

        async def send() -> wire.CallToolResult:
            return await client.call_tool(name, arguments, meta=meta)

        return portal.call(send)

    def call(self, name: str, /, **arguments: Any) -> ToolAnswer:
        """Call a tool. ``CallRefused`` when it failed, ``RunStopped`` when the run takes no more calls."""
        import mcp_types as wire

        answer = self.answer(name, arguments)
        payload = json.loads(next(block.text for block in answer.content if isinstance(block, wire.TextContent)))
        if "stop" in payload:
            raise RunStopped(str(payload["stop"]))
        if answer.is_error:
            raise CallRefused(str(payload["error"]), where=name)
        images = tuple(base64.b64decode(block.data) for block in answer.content if isinstance(block, wire.ImageContent))
        return ToolAnswer(payload["result"], images, payload["budget"])

    def actors(self) -> list[dict[str, Any]]:
        """All actors of the level, part by part: a call for each thousand."""
        found: list[dict[str, Any]] = []
        offset: int | None = 0
        while offset is not None:
            part = self.call("get_actors_in_level", offset=offset, limit=ACTORS_A_CALL).data
            found += part["actors"]
            offset = part["next"]
        return found


def call_fault(name: str, arguments: dict[str, Any]) -> str | None:
    """Why a call cannot be sent, or None: it is nested too deep, too large, or no text that UTF-8 can hold."""
    if _nested(arguments):
        return f"the arguments are nested more than {MOST_NESTING} deep"
    try:
        size = len(json.dumps([name, arguments], ensure_ascii=False, default=str).encode())
    except UnicodeEncodeError:
        return "a text of the call holds half a surrogate pair"
    except ValueError as error:
        return f"the arguments cannot be sent: {error}"
    return None if size <= MOST_CALL_BYTES else f"the call has {size:,} bytes, more than {MOST_CALL_BYTES:,}"


def _nested(value: Any) -> bool:
    layer = [value]
    for _ in range(MOST_NESTING):
        held = [part for part in layer if isinstance(part, (dict, list, tuple))]
        layer = [part for one in held for part in (one.values() if isinstance(one, dict) else one)]
    return any(isinstance(part, (dict, list, tuple)) for part in layer)


class GatewayConnection:
    """The SDK client with the run's token on every request."""

    def __init__(self, endpoint: Endpoint, mode: Literal["auto", "legacy"]) -> None:
        self._endpoint, self._mode = endpoint, mode
        self._stack = AsyncExitStack()

    async def __aenter__(self) -> Client:
        import httpx2
        from mcp import Client
        from mcp.client.streamable_http import streamable_http_client

        http = await self._stack.enter_async_context(
            httpx2.AsyncClient(
                headers={"Authorization": f"Bearer {self._endpoint.token}"},
                trust_env=False,
                verify=NO_CERTIFICATES,
                timeout=httpx2.Timeout(CONNECT_TIMEOUT_S, read=None),
            )
        )
        transport = streamable_http_client(self._endpoint.url, http_client=http, max_sse_event_size=None)
        return await self._stack.enter_async_context(Client(transport, mode=self._mode))

    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        await self._stack.__aexit__(kind, error, trace)
