"""The bridge: one JSON line a request, one JSON line a reply, one connection a request, over a Unix or TCP socket.

The message format is the benchmark's editor bridge, so a client here speaks to the headless engine and to a real editor
alike. Replies carry ``status``: ``ok``/``success``/``partial``, ``running`` (with ``job_id``), or ``error``/``failed``/
``failure`` with ``error``.
"""

from __future__ import annotations

import json
import socket
import time
from collections.abc import Mapping
from pathlib import Path
from typing import Any, Protocol

from c4s.bounds import BOUNDS, Bound
from c4s.errors import MachineryFault
from c4s.files import parse_bounded

OVER_TIME = "JobOverTime"
"""The ``fault`` of a job that was ended because it ran longer than it may."""
FAILED = frozenset({"error", "failed", "failure"})
MAX_REQUEST_BYTES = 64 << 20
MAX_UNIX_PATH = 103
_CHUNK = 1 << 18


def reply_bound(kind: str) -> Bound:
    """How large the answer to a kind of request may be: a function's value may hold a whole scene, others cannot."""
    return BOUNDS["answer_bytes" if kind == "call_function" else "small_answer_bytes"]


class BridgeFault(MachineryFault):
    """The engine's side of the bridge is gone, silent, or speaks nonsense."""


class Bridge(Protocol):
    """Anything that answers bridge requests."""

    def request(self, kind: str, params: Mapping[str, Any] | None = None, *, timeout_s: float = 60.0) -> dict[str, Any]:
        """Send one request and return its reply, whatever its status. ``BridgeFault`` when there is none in time."""
        ...


def encode(message: Mapping[str, Any]) -> bytes:
    """A message as one line of JSON in ASCII. NaN and infinities are refused (``ValueError``)."""
    return json.dumps(message, allow_nan=False, separators=(",", ":")).encode("ascii") + b"\n"


def read_line(connection: socket.socket, limit: int, deadline: float) -> bytes:
    """Read up to the first line break or the end of the stream.

    ``deadline`` is a ``time.monotonic()`` value. ``TimeoutError`` behind it, ``ValueError`` over ``limit`` bytes.
    """
    parts: list[bytes] = []
    size = 0
    while True:
        remaining = deadline - time.monotonic()
        if remaining <= 0:
            raise TimeoutError
        connection.settimeout(remaining)
        part = connection.recv(_CHUNK)
        line, found, _ = part.partition(b"\n")
        parts.append(line)
        size += len(line)
        if size > limit:
            raise ValueError(f"a message of more than {limit >> 20} MiB")
        if found or not part:
            return b"".join(parts)


def decode(line: bytes) -> dict[str, Any]:
    """One message. Integers of more than 64 bits become floats.

    ``ValueError`` unless it is a JSON object within the bounds of an answer; they are looked at before it is read.
    """
    message = parse_bounded(line, BOUNDS["answer_bytes"], BOUNDS["answer_values"])
    if not isinstance(message, dict):
        raise ValueError("a message that is not an object")
    return message


class SocketBridge:
    """A bridge behind a Unix socket (a ``Path``) or a TCP address (host and port)."""

    def __init__(self, address: Path | tuple[str, int]) -> None:
        if isinstance(address, Path) and len(str(address).encode()) > MAX_UNIX_PATH:
            raise MachineryFault(f"a Unix socket path may have {MAX_UNIX_PATH} bytes", where=str(address))
        self.address = address

    def request(self, kind: str, params: Mapping[str, Any] | None = None, *, timeout_s: float = 60.0) -> dict[str, Any]:
        """Send one request on a connection of its own and return its reply."""
        deadline = time.monotonic() + timeout_s
        try:
            with self._connect(timeout_s) as connection:
                connection.sendall(encode({"type": kind, "params": dict(params or {})}))
                line = read_line(connection, reply_bound(kind).most, deadline)
        except TimeoutError:
            raise BridgeFault(f"no answer to {kind} in {timeout_s:g} s", where=str(self.address)) from None
        except OSError as error:
            raise BridgeFault(f"cannot reach the engine for {kind}: {error}", where=str(self.address)) from error
        except ValueError as error:
            raise BridgeFault(f"the engine answered {kind} with {error}", where=str(self.address)) from error
        if not line:
            raise BridgeFault(f"the engine closed the connection without an answer to {kind}", where=str(self.address))
        try:
            return decode(line)
        except ValueError as error:
            raise BridgeFault(f"the answer to {kind} is no message: {error}", where=str(self.address)) from error

    def _connect(self, timeout_s: float) -> socket.socket:
        if isinstance(self.address, Path):
            connection = socket.socket(socket.AF_UNIX)
            connection.settimeout(timeout_s)
            try:
                connection.connect(str(self.address))
            except OSError:
                connection.close()
                raise
            return connection
        return socket.create_connection(self.address, timeout_s)
