"""The meter: an HTTP pass-through on loopback between clients and models, for many runs. A token selects the run.

Bytes of an answer go on as they come; what is read of them is read on the side. The real key is put in here and is in
no other process. Requests that ask for output are metered; a list of models and a token count pass without; everything
else is refused, because it could cost money that no record tells.
"""

from __future__ import annotations

import asyncio
import hmac
import re
import socket
import threading
from types import TracebackType
from typing import Self
from urllib.parse import parse_qsl

import httpx
import uvicorn
from starlette.types import Receive, Scope, Send

from c4s import loopback
from c4s.errors import MachineryFault
from c4s.meter.exchange import Exchange, Timeouts
from c4s.meter.metered import MeterRun
from c4s.meter.wire import wire_of
from c4s.proxies import check_proxies

START_TIMEOUT_S = 20.0
_FREE = re.compile(r"(^|/)models(/[^/:]+(/[^/:]+)?)?$|/messages/count_tokens$|/models/[^:]+:countTokens$")
"""Paths that cost nothing: lists and descriptions of models, token counts."""


class Meter:
    """The server. Use it as a context manager; opening and closing runs is thread-safe."""

    def __init__(self, timeouts: Timeouts | None = None, limits: loopback.DoorLimits | None = None) -> None:
        self._limits = limits or loopback.DoorLimits()
        self._timeouts = timeouts or Timeouts()
        self._runs: dict[str, MeterRun] = {}
        self._server: uvicorn.Server | None = None
        self._thread: threading.Thread | None = None
        self._ready = threading.Event()
        self._client: httpx.AsyncClient | None = None
        self.port = 0

    def __enter__(self) -> Self:
        """Listen. The protocol is named so that asyncio turns off Nagle's algorithm, which would add 40 ms."""
        check_proxies()
        listener = socket.socket(socket.AF_INET, socket.SOCK_STREAM, socket.IPPROTO_TCP)
        listener.bind(("127.0.0.1", 0))
        listener.listen(loopback.BACKLOG)
        self.port = listener.getsockname()[1]
        self._server = uvicorn.Server(
            loopback.config(self._app, self._limits, log_level="critical", lifespan="off", interface="asgi3")
        )
        self._thread = threading.Thread(target=self._serve, args=(listener,), name="meter", daemon=True)
        self._thread.start()
        if not self._ready.wait(START_TIMEOUT_S):
            raise MachineryFault("the model meter did not start", where=f"127.0.0.1:{self.port}")
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        assert self._server is not None and self._thread is not None
        self._runs.clear()
        self._server.should_exit = True
        self._thread.join()

    def _serve(self, listener: socket.socket) -> None:
        async def main() -> None:
            assert self._server is not None
            limits = httpx.Limits(max_connections=None, max_keepalive_connections=64)
            async with httpx.AsyncClient(limits=limits, timeout=self._timeouts.httpx, follow_redirects=False) as client:
                self._client = client
                self._ready.set()
                await self._server.serve([listener])

        asyncio.run(main())

    @property
    def url(self) -> str:
        """Base address; a client's base URL is this, with the path that its format expects."""
        return f"http://127.0.0.1:{self.port}"

    def open_run(self, run: MeterRun) -> str:
        """Admit a run; its base address."""
        self._runs[run.run_id] = run
        return self.url

    def close_run(self, run: MeterRun) -> None:
        """Forget a run's token."""
        self._runs.pop(run.run_id, None)

    async def _app(self, scope: Scope, receive: Receive, send: Send) -> None:
        if scope["type"] != "http":
            return
        assert self._client is not None
        path = scope["path"]
        wire = wire_of(path) if scope["method"] == "POST" else None
        exchange = Exchange(self._client, scope, receive, send, wire, self._run_of(scope))
        strange = loopback.foreign(scope)
        if strange is not None:
            await exchange.refuse(403, "forbidden", strange, record=False)
        elif exchange.run is None:
            await exchange.refuse(401, "unauthorized", "this token belongs to no run", record=False)
        elif not loopback.let_in(scope, exchange.run):
            await exchange.refuse(429, "too_many_connections", "this run has too many connections", record=False)
        elif wire is None and not _FREE.search(path):
            await exchange.refuse(404, "not_found", f"the meter does not pass on {scope['method']} {path}")
        elif wire is not None and wire.name not in exchange.run.upstream.formats:
            await exchange.refuse(404, "not_found", f"this run's model endpoint does not speak {wire.name}")
        else:
            await exchange.run_through()

    def _run_of(self, scope: Scope) -> MeterRun | None:
        """The run of a request's token, wherever the client's format puts it."""
        headers = {name.decode("latin-1").lower(): value.decode("latin-1") for name, value in scope["headers"]}
        query = dict(parse_qsl(scope["query_string"].decode("latin-1")))
        given = [
            headers.get("authorization", "").partition(" ")[2],
            headers.get("x-api-key", ""),
            headers.get("x-goog-api-key", ""),
            query.get("key", ""),
        ]
        tokens = [token.strip().encode() for token in given if token.strip()]
        return next(
            (
                run
                for run in list(self._runs.values())
                if any(hmac.compare_digest(run.token.encode(), token) for token in tokens)
            ),
            None,
        )
