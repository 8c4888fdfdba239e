"""A model endpoint on loopback that gives scripted answers, one a request; it keeps the requests."""

from __future__ import annotations

import json
import threading
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any


@dataclass(frozen=True)
class Raw:
    """What is sent as it is: a status and the bytes of a body."""

    body: bytes
    status: int = 200


@dataclass
class ModelEndpoint:
    """What was asked, and where."""

    url: str
    bodies: list[dict[str, Any]] = field(default_factory=list)

    def describe(self, home: Path) -> None:
        """Write it to a home's ``endpoints.yaml`` under the name ``near``."""
        home.mkdir(parents=True, exist_ok=True)
        text = json.dumps({"endpoints": {"near": {"url": self.url, "formats": ["openai-chat"]}}})
        (home / "endpoints.yaml").write_text(text)


def completion(content: Any, finish: str = "stop") -> Raw:
    """An answer of this content; what is no text is sent as JSON."""
    text = content if isinstance(content, str) else json.dumps(content)
    message = {"role": "assistant", "content": text}
    return Raw(json.dumps({"model": "m", "choices": [{"message": message, "finish_reason": finish}]}).encode())


@contextmanager
def model_endpoint(answers: Sequence[Any]) -> Iterator[ModelEndpoint]:
    """Serves the answers in order, the last one again and again."""
    script = [answer if isinstance(answer, Raw) else completion(answer) for answer in answers]

    class Handler(BaseHTTPRequestHandler):
        def do_POST(self) -> None:
            body = json.loads(self.rfile.read(int(self.headers["content-length"])))
            endpoint.bodies.append(body)
            answer = script[min(len(endpoint.bodies), len(script)) - 1]
            self.send_response(answer.status)
            self.send_header("content-length", str(len(answer.body)))
            self.end_headers()
            self.wfile.write(answer.body)

        def log_message(self, *_: Any) -> None:
            """Nothing is written."""

    server = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    endpoint = ModelEndpoint(f"http://127.0.0.1:{server.server_port}/v1")
    thread = threading.Thread(target=server.serve_forever, kwargs={"poll_interval": 0.01})
    thread.start()
    try:
        yield endpoint
    finally:
        server.shutdown()
        server.server_close()
        thread.join()
