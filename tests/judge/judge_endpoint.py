"""A judge's model on loopback: it answers whole requests over HTTP from a table of truths, and may misbehave by script.

It reads what a model would be shown: the claims' sheets, the names of the views, and the schema. Every request is kept.
"""

from __future__ import annotations

import json
import threading
from collections import Counter
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from types import TracebackType
from typing import Any, Self

Body = dict[str, Any]
RATED = {"reason": "as asked", "anchor": "complete", "score": 1.0}
DIMENSIONS = (
    "global_prompt_alignment",
    "composition_and_layout",
    "style_atmosphere_coherence",
    "completeness_and_polish",
)
PAIRED = ("composition_layout", "silhouette_geometry", "material_fidelity", "landmark_content", "lighting_fidelity")
AWARE = {"summary": "a scene", **dict.fromkeys(DIMENSIONS, RATED)}
FREE = {
    "reason": "sound",
    "anchor": "none",
    "score": 1.0,
    "severe": {"found": False, "confidence": 0, "views": [], "categories": [], "issues": []},
}
SAME = {"difference": "none", **dict.fromkeys(PAIRED, 4)}


@dataclass(frozen=True)
class Sent:
    """What an endpoint sends back: a status with a body, or a connection that is dropped."""

    body: bytes
    status: int = 200
    headers: Mapping[str, str] = field(default_factory=dict)
    drop: bool = False


def completion(content: Any, *, finish: str = "stop", usage: Mapping[str, int] | None = None) -> Sent:
    """A whole answer; content that is no text is sent as JSON."""
    text = content if isinstance(content, str) else json.dumps(content)
    told = {"prompt_tokens": 1000, "completion_tokens": 100} if usage is None else dict(usage)
    message = {"role": "assistant", "content": text}
    answer = {"model": "m", "choices": [{"message": message, "finish_reason": finish}], "usage": told}
    return Sent(json.dumps(answer).encode())


def purpose_of(body: Body) -> str:
    """Which rung or call a request is."""
    return str(body["response_format"]["json_schema"]["name"])


def parts_of(body: Body) -> list[Body]:
    """The parts of the user's message."""
    parts: list[Body] = body["messages"][1]["content"]
    return parts


def claims_in(body: Body) -> list[Body]:
    """The claims' sheets of a request."""
    text = parts_of(body)[-1]["text"]
    found: list[Body] = json.loads(text[text.index("Claims:") + len("Claims:") :])
    return found


def views_in(body: Body) -> list[str]:
    """What the pictures of a request are called."""
    texts = [part["text"] for part in parts_of(body) if part["type"] == "text"]
    return [text[:-1] for text in texts if text.startswith("view-") and text.endswith(":")]


def answer_row(claim: str, answer: str, views: list[str], *, binary: bool = False, **changes: Any) -> Body:
    """One answer of the contract."""
    row: Body = {"claim": claim, "saw": "seen", "visible": answer != "UNKNOWN", "views": views[:1], "answer": answer}
    if binary:
        del row["visible"]
    return {**row, "confidence": 0.9, **changes}


@dataclass
class Truth:
    """Answers by the requirement's text; what is not in the table is not met."""

    met: Mapping[str, bool]
    unsure: Callable[[str, Body], bool] = lambda purpose, claim: False
    """Whether the claim is left open on a rung."""

    def __call__(self, body: Body) -> Sent:
        """What a model that sees everything right would answer."""
        purpose = purpose_of(body)
        fixed = {"prompt_aware": AWARE, "prompt_free": FREE, "paired": SAME}
        if purpose in fixed:
            return completion(fixed[purpose])
        binary, views = purpose == "arbitration", views_in(body)
        rows = []
        for claim in claims_in(body):
            met = self.met.get(claim["requirement"], False)
            answer = "UNKNOWN" if self.unsure(purpose, claim) and not binary else "MATCH" if met else "MISMATCH"
            rows.append(answer_row(claim["claim"], answer, views, binary=binary))
        return completion({"answers": rows})


class JudgeEndpoint:
    """The server, a context manager. ``answer`` makes of each request's body what is sent."""

    def __init__(self, answer: Callable[[Body], Sent]) -> None:
        self.answer = answer
        self.bodies: list[Body] = []
        self.raw: list[bytes] = []
        self.heads: list[str] = []
        self.open = self.most_open = 0
        self._lock = threading.Lock()

    def __enter__(self) -> Self:
        endpoint = self

        class Handler(BaseHTTPRequestHandler):
            protocol_version = "HTTP/1.1"

            def do_POST(self) -> None:
                endpoint._serve(self)

            def log_message(self, format: str, *args: Any) -> None:
                """Silent."""

        class Server(ThreadingHTTPServer):
            request_queue_size = 256
            daemon_threads = True

        self._server = Server(("127.0.0.1", 0), Handler)
        self.url = f"http://127.0.0.1:{self._server.server_port}/v1"
        threading.Thread(target=self._server.serve_forever, daemon=True).start()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._server.shutdown()
        self._server.server_close()

    def _serve(self, handler: BaseHTTPRequestHandler) -> None:
        raw = handler.rfile.read(int(handler.headers["content-length"]))
        with self._lock:
            self.open += 1
            self.most_open = max(self.most_open, self.open)
            self.raw.append(raw)
            self.heads.append(str(handler.headers))
            self.bodies.append(json.loads(raw))
        try:
            sent = self.answer(json.loads(raw))
            if sent.drop:
                handler.close_connection = True
                handler.wfile.write(b"HTTP/1.1 200 OK\r\nContent-Length: 100000\r\n\r\n" + sent.body[:20])
                return
            handler.send_response(sent.status)
            handler.send_header("Content-Type", "application/json")
            handler.send_header("Content-Length", str(len(sent.body)))
            for name, value in sent.headers.items():
                handler.send_header(name, value)
            handler.end_headers()
            handler.wfile.write(sent.body)
        except (BrokenPipeError, ConnectionResetError):
            handler.close_connection = True
        finally:
            with self._lock:
                self.open -= 1

    def purposes(self) -> Counter[str]:
        """How many requests of each kind came."""
        return Counter(purpose_of(body) for body in self.bodies)
