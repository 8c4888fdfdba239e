"""Messages between the host and its engine process, on an inherited pair of sockets: a length, then JSON.

A message to the engine may carry one file descriptor (the pipe that a job prints to). A message to the host carries
none, and the host checks its length before it reads it: the process on the other side may run agent code.
"""

from __future__ import annotations

import os
import socket
import struct
from collections.abc import Iterator

from c4s.bounds import BOUNDS

_LENGTH = struct.Struct("!Q")
_CHUNK = 1 << 20


def send(connection: socket.socket, payload: bytes, descriptor: int | None = None) -> None:
    """Send one message, with a descriptor or without."""
    head = _LENGTH.pack(len(payload))
    if descriptor is None:
        connection.sendall(head)
    else:
        socket.send_fds(connection, [head], [descriptor])
    connection.sendall(payload)


def receive(connection: socket.socket) -> tuple[bytes, int | None]:
    """Wait for one message: its payload and its descriptor. ``EOFError`` when the other side is gone."""
    head, descriptors, _, _ = socket.recv_fds(connection, _LENGTH.size, 1)
    while len(head) < _LENGTH.size:
        head += _more(connection, _LENGTH.size - len(head))
    size = _LENGTH.unpack(head)[0]
    payload = bytearray()
    while len(payload) < size:
        payload += _more(connection, size - len(payload))
    return bytes(payload), descriptors[0] if descriptors else None


def _more(connection: socket.socket, size: int) -> bytes:
    part = connection.recv(min(size, _CHUNK))
    if not part:
        raise EOFError
    return part


class Incoming:
    """Messages from a socket that is read when it is readable. ``ValueError`` for a length over the limit."""

    def __init__(self) -> None:
        self._buffer = bytearray()

    def feed(self, data: bytes) -> Iterator[bytes]:
        """The messages that are complete with ``data``."""
        self._buffer += data
        while len(self._buffer) >= _LENGTH.size:
            size = _LENGTH.unpack_from(self._buffer)[0]
            fault = BOUNDS["answer_bytes"].fault(size)
            if fault is not None:
                raise ValueError(f"a message of {size} bytes: {fault}")
            if len(self._buffer) < _LENGTH.size + size:
                return
            message = bytes(self._buffer[_LENGTH.size : _LENGTH.size + size])
            del self._buffer[: _LENGTH.size + size]
            yield message


def close(*descriptors: int) -> None:
    """Close descriptors."""
    for descriptor in descriptors:
        os.close(descriptor)
