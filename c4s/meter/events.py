"""JSON messages out of a response as it passes: server-sent events, a streamed JSON array, or one JSON body."""

from __future__ import annotations

import json
from collections.abc import Iterator
from typing import Any

_TELLING = (b"usage", b"error", b"finish", b"message_st", b"Reason", b"response.")
"""An event without any of these tells the meter nothing and is not parsed."""
MOST_BODY_BYTES = 64 << 20


class EventReader:
    """Server-sent events from bytes in any portions."""

    def __init__(self) -> None:
        self._rest = b""
        self._data: list[bytes] = []
        self.done = False
        """Whether the closing ``[DONE]`` was seen."""

    def feed(self, portion: bytes) -> Iterator[Any]:
        """The messages that this portion completes. ``ValueError`` for data that is not JSON."""
        lines = (self._rest + portion).split(b"\n")
        self._rest = lines.pop()
        for line in lines:
            yield from self._line(line.rstrip(b"\r"))

    def end(self) -> Iterator[Any]:
        """What a stream leaves that does not end with a blank line."""
        yield from self._line(self._rest.rstrip(b"\r"))
        self._rest = b""
        yield from self._line(b"")

    def _line(self, line: bytes) -> Iterator[Any]:
        if line.startswith(b"data:"):
            self._data.append(line[5:].removeprefix(b" "))
        elif not line and self._data:
            data, self._data = b"\n".join(self._data), []
            if data.strip() == b"[DONE]":
                self.done = True
            elif any(mark in data for mark in _TELLING):
                yield json.loads(data)


class BodyReader:
    """A JSON body, or a JSON array of messages (a Gemini stream that was not asked for as events)."""

    def __init__(self) -> None:
        self._portions: list[bytes] = []
        self._size = 0
        self.done = False

    def feed(self, portion: bytes) -> Iterator[Any]:
        """Keep the portion; a body over 64 MiB is dropped, and its usage stays unknown."""
        self._size += len(portion)
        if self._size > MOST_BODY_BYTES:
            self._portions.clear()
        else:
            self._portions.append(portion)
        return iter(())

    def end(self) -> Iterator[Any]:
        """The messages of the body. ``ValueError`` when it is not JSON."""
        if not self._portions:
            return
        whole = json.loads(b"".join(self._portions))
        yield from whole if isinstance(whole, list) else [whole]
