"""Real HTTP servers on loopback: one takes notices, one is an OTLP collector that decodes what it is sent."""

from __future__ import annotations

import gzip
import json
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import Any

from opentelemetry.proto.collector.metrics.v1.metrics_service_pb2 import ExportMetricsServiceRequest
from opentelemetry.proto.collector.trace.v1.trace_service_pb2 import ExportTraceServiceRequest


class Receiver(ThreadingHTTPServer):
    """Keeps the bodies of all requests by path."""

    def __init__(self, status: int) -> None:
        self.status = status
        self.bodies: list[tuple[str, bytes]] = []
        super().__init__(("127.0.0.1", 0), _Handler)

    @property
    def url(self) -> str:
        return f"http://127.0.0.1:{self.server_port}"

    def notices(self) -> list[dict[str, Any]]:
        return [json.loads(body) for _, body in self.bodies]

    def spans(self) -> list[Any]:
        """All spans of all traces that came."""
        found = []
        for path, body in self.bodies:
            if path == "/v1/traces":
                told = ExportTraceServiceRequest.FromString(body)
                found += [span for one in told.resource_spans for scope in one.scope_spans for span in scope.spans]
        return found

    def metrics(self) -> dict[str, Any]:
        """The last of each metric that came."""
        found = {}
        for path, body in self.bodies:
            if path == "/v1/metrics":
                told = ExportMetricsServiceRequest.FromString(body)
                for one in told.resource_metrics:
                    for scope in one.scope_metrics:
                        found |= {metric.name: metric for metric in scope.metrics}
        return found


class _Handler(BaseHTTPRequestHandler):
    server: Receiver

    def do_POST(self) -> None:
        body = self.rfile.read(int(self.headers["content-length"]))
        if self.headers.get("content-encoding") == "gzip":
            body = gzip.decompress(body)
        self.server.bodies.append((self.path, body))
        self.send_response(self.server.status)
        self.send_header("content-length", "0")
        self.end_headers()

    def log_message(self, format: str, *args: Any) -> None:
        return


@contextmanager
def receiving(status: int = 200) -> Iterator[Receiver]:
    """A receiver that answers with a status."""
    server = Receiver(status)
    thread = threading.Thread(target=server.serve_forever, daemon=True)
    thread.start()
    try:
        yield server
    finally:
        server.shutdown()
        thread.join()
        server.server_close()


def values(attributes: Any) -> dict[str, Any]:
    """Attributes of a span or a data point as plain values."""
    return {one.key: getattr(one.value, one.value.WhichOneof("value")) for one in attributes}
