"""A model endpoint on loopback that answers a judge's requests from the known truth, over HTTP."""

from __future__ import annotations

import base64
import json
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import Any

from c4s.files import digest_bytes
from cases.judge_check.truth import Truth

_RATED = {"reason": "not looked at", "anchor": "complete", "score": 1.0}
_AWARE = ("global_prompt_alignment", "composition_and_layout", "style_atmosphere_coherence", "completeness_and_polish")
_SEVERE = {"found": False, "confidence": 0, "views": [], "categories": [], "issues": []}
_CLAIMS = "Claims:"


def answer(truth: Truth, body: Any) -> dict[str, Any]:
    """What a model that knows everything says to a request."""
    purpose = body["response_format"]["json_schema"]["name"]
    parts = body["messages"][1]["content"]
    if purpose == "prompt_aware":
        return {"summary": "a scene", **dict.fromkeys(_AWARE, _RATED)}
    if purpose == "prompt_free":
        return {"reason": "not looked at", "anchor": "none", "score": 1.0, "severe": _SEVERE}
    text = parts[-1]["text"]
    urls = [part["image_url"]["url"] for part in parts if part["type"] == "image_url"]
    pictures = [digest_bytes(base64.b64decode(url.split(",", 1)[1])) for url in urls]
    names = [part["text"][:-1] for part in parts if part["type"] == "text" and part["text"].startswith("view-")]
    rows = []
    for claim in json.loads(text[text.index(_CLAIMS) + len(_CLAIMS) :]):
        holds = truth(claim["requirement"], pictures)
        told = "MATCH" if holds else "MISMATCH"
        row = {"claim": claim["claim"], "saw": "the truth", "views": names[:1], "answer": told, "confidence": 0.9}
        rows.append(row if purpose == "arbitration" else {**row, "visible": True})
    return {"answers": rows}


@contextmanager
def truth_endpoint(truth: Truth) -> Iterator[str]:
    """The address of an endpoint that answers while the block runs."""

    class Handler(BaseHTTPRequestHandler):
        protocol_version = "HTTP/1.1"

        def do_POST(self) -> None:
            body = json.loads(self.rfile.read(int(self.headers["content-length"])))
            message = {"role": "assistant", "content": json.dumps(answer(truth, body))}
            usage = {"prompt_tokens": 0, "completion_tokens": 0}
            sent = {"model": "truth", "choices": [{"message": message, "finish_reason": "stop"}], "usage": usage}
            data = json.dumps(sent).encode()
            self.send_response(200)
            self.send_header("Content-Type", "application/json")
            self.send_header("Content-Length", str(len(data)))
            self.end_headers()
            self.wfile.write(data)

        def log_message(self, format: str, *args: Any) -> None:
            """Silent."""

    server = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    thread = threading.Thread(target=server.serve_forever, daemon=True)
    thread.start()
    try:
        yield f"http://127.0.0.1:{server.server_port}/v1"
    finally:
        server.shutdown()
        server.server_close()
        thread.join()
