"""Behind a proxy: what lies elsewhere is asked through it, servers on this machine never are."""

from __future__ import annotations

import json
import os
import random
import subprocess
import sys
import threading
from collections.abc import Iterator
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

import pytest

from c4s.chat.client import ChatClient
from c4s.chat.replicas import Address
from c4s.proxies import LOOPBACK

COMPLETION = {
    "model": "m",
    "choices": [{"message": {"role": "assistant", "content": "hello"}, "finish_reason": "stop"}],
    "usage": {"prompt_tokens": 1, "completion_tokens": 1},
}
PROXIES = ("http_proxy", "https_proxy", "all_proxy", "no_proxy")


class _Answering(ThreadingHTTPServer):
    """A server that takes any request, also one to a proxy, and remembers what was asked for."""

    def __init__(self) -> None:
        super().__init__(("127.0.0.1", 0), _Handler)
        self.asked: list[str] = []
        self.url = f"http://127.0.0.1:{self.server_port}"


class _Handler(BaseHTTPRequestHandler):
    server: _Answering

    def do_GET(self) -> None:
        self.server.asked.append(self.path)
        self.rfile.read(int(self.headers.get("content-length", 0)))
        body = json.dumps(COMPLETION if "completions" in self.path else []).encode()
        self.send_response(200)
        self.send_header("content-type", "application/json")
        self.send_header("content-length", str(len(body)))
        self.end_headers()
        self.wfile.write(body)

    def do_POST(self) -> None:
        self.do_GET()

    def log_message(self, format: str, *arguments: object) -> None:
        """Nothing."""


def _answering() -> Iterator[_Answering]:
    with _Answering() as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield server
        server.shutdown()


proxy = pytest.fixture(name="proxy")(_answering)
server = pytest.fixture(name="server")(_answering)


@pytest.fixture(autouse=True)
def _no_proxy_of_this_machine(monkeypatch: pytest.MonkeyPatch) -> None:
    """None are set, and those that a test or c4s sets are gone after it."""
    for name in PROXIES:
        monkeypatch.setenv(name, "")
        monkeypatch.delenv(name)
        monkeypatch.setenv(name.upper(), "")
        monkeypatch.delenv(name.upper())


def _doctor(home: Path, **variables: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-m", "c4s.cli", "doctor", "--json"],
        env={**os.environ, "C4S_HOME": str(home), **variables},
        capture_output=True,
        text=True,
        timeout=200,
        check=False,
    )


def test_a_server_on_this_machine_is_not_asked_through_it(
    tmp_path: Path, proxy: _Answering, server: _Answering
) -> None:
    done = _doctor(tmp_path, HTTP_PROXY=proxy.url, PREFECT_API_URL=f"{server.url}/api")
    row = next(row for row in json.loads(done.stdout) if row["what"] == "Prefect server")
    assert row["found"] and server.asked and not proxy.asked, (row, done.stderr)


def test_one_that_does_not_speak_http_is_named_in_a_line(tmp_path: Path) -> None:
    done = _doctor(tmp_path, ALL_PROXY="socks5h://me:secret@10.1.1.1:1080", PREFECT_API_URL="http://127.0.0.1:9/api")
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr == "c4s: ALL_PROXY: proxies of 'socks5h' are not spoken (name an http:// one, or unset it)\n"


def _ask(url: str) -> str:
    client = ChatClient([Address(url)], wait=lambda s: True, jitter=random.Random(0), note=lambda record: None)
    try:
        return str(client.ask({"model": "m", "messages": []}).message["content"])
    finally:
        client.close()


def test_a_model_elsewhere_is_asked_through_it_and_one_on_this_machine_is_not(
    monkeypatch: pytest.MonkeyPatch, proxy: _Answering, server: _Answering
) -> None:
    monkeypatch.setenv("HTTP_PROXY", proxy.url)
    monkeypatch.setenv("NO_PROXY", "intranet.example")
    assert _ask("http://models.example/v1") == _ask(f"{server.url}/v1") == "hello"
    assert [len(server.asked), [path.split("/v1")[0] for path in proxy.asked]] == [1, ["http://models.example"]]
    assert os.environ["NO_PROXY"] == os.environ["no_proxy"] == ",".join(("intranet.example", *LOOPBACK))
