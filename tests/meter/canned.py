"""An upstream on loopback that answers with exact bytes, and can fall silent or break off."""

from __future__ import annotations

import socket
import threading
from collections.abc import Sequence
from dataclasses import dataclass
from types import TracebackType
from typing import Any, Self


@dataclass(frozen=True)
class Reply:
    """Portions of a body; ``then``: ``end`` closes it properly, ``cut`` breaks off, ``hold`` waits for ``release``."""

    portions: Sequence[bytes]
    status: str = "200 OK"
    kind: str = "application/json"
    then: str = "end"
    headers: Sequence[str] = ()


class CannedUpstream:
    """One reply a request, in order; the last one again and again. Requests are kept as (head, body)."""

    def __init__(self, *replies: Reply) -> None:
        self.replies = list(replies)
        self.requests: list[tuple[str, bytes]] = []
        self.release = threading.Event()
        self.held = threading.Event()
        self.hung_up = threading.Event()
        """Set when the other side closed while a reply was held."""
        self._lock = threading.Lock()

    def __enter__(self) -> Self:
        self._listener = socket.create_server(("127.0.0.1", 0))
        self.url = f"http://127.0.0.1:{self._listener.getsockname()[1]}"
        threading.Thread(target=self._accept, daemon=True).start()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.release.set()
        self._listener.close()

    def _accept(self) -> None:
        while True:
            try:
                connection, _ = self._listener.accept()
            except OSError:
                return
            threading.Thread(target=self._serve, args=(connection,), daemon=True).start()

    def _serve(self, connection: Any) -> None:
        with connection, connection.makefile("rwb") as stream:
            head = b""
            while not head.endswith(b"\r\n\r\n"):
                line = stream.readline()
                if not line:
                    return
                head += line
            text = head.decode("latin-1")
            length = next(
                (int(line.split(":")[1]) for line in text.lower().split("\r\n") if line.startswith("content-length:")),
                0,
            )
            body = stream.read(length)
            with self._lock:
                self.requests.append((text, body))
                reply = self.replies.pop(0) if len(self.replies) > 1 else self.replies[0]
            lines = [
                f"HTTP/1.1 {reply.status}",
                f"Content-Type: {reply.kind}",
                "Transfer-Encoding: chunked",
                "Connection: close",
                *reply.headers,
                "",
                "",
            ]
            stream.write("\r\n".join(lines).encode())
            for portion in reply.portions:
                stream.write(f"{len(portion):x}\r\n".encode() + portion + b"\r\n")
                stream.flush()
            stream.flush()
            if reply.then == "hold":
                self.held.set()
                connection.settimeout(20)
                try:
                    if connection.recv(1) == b"":
                        self.hung_up.set()
                except OSError:
                    self.release.wait(20)
                return
            if reply.then == "end":
                stream.write(b"0\r\n\r\n")
