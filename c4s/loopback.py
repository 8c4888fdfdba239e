"""The front door of a server on loopback: how many connections it keeps, and how long one may be silent.

A connection is a stranger until a request on it has shown whose it is (``Visitor.let_in``). Strangers are few and have
a deadline; a newcomer takes the place of the oldest of them. One owner keeps no more than its share, so that no flood
takes the place of another owner's connections.
"""

from __future__ import annotations

import asyncio
import errno
import re
import socket
from collections import Counter
from collections.abc import Hashable, Mapping
from dataclasses import dataclass
from functools import partial
from typing import Any, cast

import h11
import uvicorn
from starlette.types import ASGIApp, Scope
from uvicorn.protocols.http.h11_impl import H11Protocol

from c4s.errors import BadInput

_HERE = re.compile(r"(127\.0\.0\.1|localhost|\[::1\])(:\d{1,5})?", re.IGNORECASE)
BACKLOG = 64
"""Connections that wait to be accepted; asyncio takes as many at once, beyond the limits, before it looks at one."""


@dataclass(frozen=True)
class DoorLimits:
    """Connections in number, times in seconds, sizes in bytes."""

    connections: int = 400
    """Of the whole server."""
    strangers: int = 64
    """Of those, ones that have shown no token."""
    of_one: int = 48
    """Of those, ones that belong to one owner."""
    head_s: float = 10.0
    """From the opening of a connection, or the answer before, to the end of a request's head."""
    body_s: float = 60.0
    """From the end of a request's head to the end of its body."""
    head_bytes: int = 32 << 10


def config(app: ASGIApp, limits: DoorLimits, **options: Any) -> uvicorn.Config:
    """A server's configuration behind such a door; ``options`` are uvicorn's. Web sockets are not spoken."""
    protocol = partial(Visitor, door=_Door(limits))
    return uvicorn.Config(
        app,
        http=cast(Any, protocol),
        ws="none",
        backlog=BACKLOG,
        proxy_headers=False,
        access_log=False,
        server_header=False,
        timeout_graceful_shutdown=1,
        h11_max_incomplete_event_size=limits.head_bytes,
        **options,
    )


def listener(port: int) -> socket.socket:
    """A socket that listens on loopback, at a port or (0) at any that is free. ``BadInput`` where it cannot be had."""
    try:
        return socket.create_server(("127.0.0.1", port), backlog=BACKLOG)
    except OSError as error:
        if error.errno not in (errno.EADDRINUSE, errno.EACCES) or not port:
            raise
        what = "is taken" if error.errno == errno.EADDRINUSE else "may not be used"
        raise BadInput(f"port {port} {what}", where="127.0.0.1", todo="choose another one") from None


def foreign(scope: Scope) -> str | None:
    """Why a request was not meant for a server on loopback (a page of another site led a browser here); else None."""
    told: Mapping[bytes, list[str]] = {b"host": [], b"origin": []}
    for name, value in scope["headers"]:
        if name in told:
            told[name].append(value.decode("latin-1"))
    if len(told[b"host"]) != 1 or not _HERE.fullmatch(told[b"host"][0]):
        return "this server is called 127.0.0.1"
    for origin in told[b"origin"]:
        scheme, _, host = origin.partition("://")
        if scheme not in ("http", "https") or not _HERE.fullmatch(host):
            return "requests of pages from elsewhere are not answered"
    return None


def let_in(scope: Scope, owner: Hashable) -> bool:
    """Note that the connection of a request belongs to somebody; False when that one has too many."""
    return cast(Visitor, scope["state"][_VISITOR]).let_in(owner)


_VISITOR = "c4s.loopback.visitor"


class _Door:
    """The connections of a server. Belongs to its event loop."""

    def __init__(self, limits: DoorLimits) -> None:
        self.limits = limits
        self.strangers: dict[Visitor, None] = {}
        self.known: dict[Visitor, Hashable] = {}
        self.held: Counter[Hashable] = Counter()

    def arrive(self, visitor: Visitor) -> None:
        """Take a newcomer in, in the place of the oldest stranger where there is none free."""
        full = len(self.strangers) + len(self.known) >= self.limits.connections
        if self.strangers and (full or len(self.strangers) >= self.limits.strangers):
            self.send_away(next(iter(self.strangers)))
        elif full:
            self.send_away(visitor)
            return
        self.strangers[visitor] = None

    def send_away(self, visitor: Visitor) -> None:
        """Close a connection at once."""
        self.leave(visitor)
        visitor.transport.abort()

    def leave(self, visitor: Visitor) -> None:
        """Forget a connection."""
        self.strangers.pop(visitor, None)
        owner = self.known.pop(visitor, None)
        if owner is not None:
            self.held[owner] -= 1
            if not self.held[owner]:
                del self.held[owner]


class Visitor(H11Protocol):
    """One connection."""

    def __init__(self, *, door: _Door, app_state: dict[str, Any], **named: Any) -> None:
        super().__init__(app_state={**app_state, _VISITOR: self}, **named)
        self._door = door
        self._awaited: str | None = None
        self._deadline: asyncio.TimerHandle | None = None

    def let_in(self, owner: Hashable) -> bool:
        """Note whose the connection is; False when that one has too many already."""
        door = self._door
        if door.known.get(self) == owner:
            return True
        if self.transport.is_closing() or door.held[owner] >= door.limits.of_one:
            return False
        door.leave(self)
        door.known[self] = owner
        door.held[owner] += 1
        return True

    def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]
        super().connection_made(transport)
        self._door.arrive(self)
        self._await()

    def connection_lost(self, exc: Exception | None) -> None:
        self._door.leave(self)
        if self._deadline is not None:
            self._deadline.cancel()
        super().connection_lost(exc)

    def data_received(self, data: bytes) -> None:
        super().data_received(data)
        self._await()

    def on_response_complete(self) -> None:
        super().on_response_complete()
        self._awaited = None
        self._await()

    def _await(self) -> None:
        """Set the deadline of what has to come next; there is none while an answer is made."""
        state = self.conn.their_state
        awaited = "head" if state is h11.IDLE else "body" if state is h11.SEND_BODY else None
        if awaited == self._awaited:
            return
        self._awaited = awaited
        if self._deadline is not None:
            self._deadline.cancel()
        if awaited is not None and not self.transport.is_closing():
            limits = self._door.limits
            self._deadline = self.loop.call_later(
                limits.head_s if awaited == "head" else limits.body_s, self._door.send_away, self
            )
