"""Floods of connections and bent requests at the gateway and the meter: others are served as if nothing happened."""

from __future__ import annotations

import json
import socket
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import ExitStack
from dataclasses import dataclass

import httpx2
import pytest
from made_case import make_case
from prey import Prey

from c4s.loopback import DoorLimits
from c4s.meter.endpoints import ModelEndpoint
from c4s.meter.meter import Meter
from c4s.meter.metered import MeterRun
from c4s.meter.prices import PriceTable
from c4s.toolbox.client import GatewayClient
from c4s.toolbox.gateway import Gateway
from c4s.toolbox.gateway_run import Run
from tests.mcp_hello import HEADERS, INITIALIZE

QUICK = DoorLimits(connections=40, strangers=24, of_one=12, head_s=1, body_s=3)
FLOOD = 300


@dataclass
class Target:
    """A server under attack: its port, a path, a token of the attacker, and what tells that another run is served."""

    port: int
    path: str
    token: str
    innocent: Callable[[], bool]

    def connect(self) -> socket.socket:
        return socket.create_connection(("127.0.0.1", self.port), 10)

    def head(self, *lines: str, length: int | None = 2) -> bytes:
        """A request's head with the attacker's token."""
        told = [f"POST {self.path} HTTP/1.1", f"Host: 127.0.0.1:{self.port}", f"Authorization: Bearer {self.token}"]
        told += ["Content-Type: application/json", "Accept: application/json, text/event-stream", *lines]
        told += [f"Content-Length: {length}"] if length is not None else []
        return ("\r\n".join(told) + "\r\n\r\n").encode()

    def told(self, request: bytes) -> bytes:
        """The first of the answer to raw bytes; empty when the connection is closed without one."""
        with self.connect() as connection:
            try:
                connection.sendall(request)
                return connection.recv(4096)
            except (ConnectionResetError, BrokenPipeError):
                return b""


def closed(connection: socket.socket) -> bool:
    """Whether the server ends a connection, within ten seconds."""
    connection.settimeout(10)
    try:
        while connection.recv(1 << 16):
            continue
    except TimeoutError:
        return False
    except ConnectionResetError:
        pass
    return True


@pytest.fixture(scope="module")
def gateway(prey: Prey, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Target]:
    root = tmp_path_factory.mktemp("flooded")
    with Gateway(QUICK) as gateway:
        case, _ = make_case(root / "suite", prey.root / "packs/test-pack", calls=500)
        runs = [Run(f"room-{n}", prey.run.bench, case.budget, root / f"t{n}.jsonl", ["get_categories"]) for n in (1, 2)]
        first, second = (gateway.open_run(run) for run in runs)

        def innocent() -> bool:
            with GatewayClient(second) as client:
                return bool(client.call("get_categories").data)

        yield Target(gateway.port, "/mcp", first.token, innocent)


@pytest.fixture(scope="module")
def meter(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Target]:
    root = tmp_path_factory.mktemp("metered")
    nobody = ModelEndpoint(url="http://127.0.0.1:9", formats=["openai-chat"])
    with Meter(limits=QUICK) as meter:
        runs = [MeterRun(f"r{n}", nobody, "key", root / f"{n}.jsonl", prices=PriceTable([])) for n in (1, 2)]
        for run in runs:
            meter.open_run(run)

        def innocent() -> bool:
            """A request is taken, and fails at the endpoint that is not there."""
            told = httpx2.post(
                f"{meter.url}/v1/chat/completions",
                json={"model": "m", "messages": []},
                headers={"Authorization": f"Bearer {runs[1].token}"},
                trust_env=False,
            )
            return told.status_code == 502

        yield Target(meter.port, "/v1/chat/completions", runs[0].token, innocent)


@pytest.fixture(params=["gateway", "meter"])
def target(request: pytest.FixtureRequest) -> Target:
    found: Target = request.getfixturevalue(request.param)
    return found


def test_half_open_connections_take_nobodys_place(target: Target) -> None:
    with ExitStack() as stack:
        flood = [stack.enter_context(target.connect()) for _ in range(FLOOD)]
        for number, connection in enumerate(flood):
            with_head = (b"", b"POST / HTTP/1.1\r\n", b"\x16\x03\x01\x02\x00\x01", b"G")[number % 4]
            try:
                connection.sendall(with_head)
            except OSError:
                continue
        assert target.innocent()
        assert all(map(closed, flood))


def test_one_run_keeps_its_share_of_connections(target: Target) -> None:
    answers = []
    with ExitStack() as stack:
        for _ in range(QUICK.of_one + 5):
            connection = stack.enter_context(target.connect())
            connection.sendall(target.head("Expect: 100-continue"))
            answers.append(connection.recv(4096)[9:12])
        assert target.innocent()
    assert answers == [b"100"] * QUICK.of_one + [b"429"] * 5


@pytest.mark.parametrize("begun", ["head", "drop by drop", "body", "chunk"])
def test_a_request_that_never_ends_is_ended(target: Target, begun: str) -> None:
    sent = {
        "head": b"POST / HTTP/1.1\r\nHost: 127.0.0.1\r\nX: ",
        "drop by drop": b"P",
        "body": target.head(length=100) + b"{",
        "chunk": target.head("Transfer-Encoding: chunked", length=None) + b"5\r\n{",
    }[begun]
    with target.connect() as connection:
        connection.sendall(sent)
        if begun == "drop by drop":
            for drop in b"OST / HTTP/1.1\r\n":
                try:
                    connection.sendall(bytes([drop]))
                except OSError:
                    break
        assert closed(connection)
    assert target.innocent()


def test_bent_requests_get_an_answer_or_none_and_harm_nobody(target: Target) -> None:
    bent = {
        "TLS": b"\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03" + bytes(300),
        "HTTP/2": b"PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n" + bytes(9),
        "no HTTP": b"\x00" * 100,
        "a head without end": b"GET / HTTP/1.1\r\nX: " + b"x" * (200 << 10),
        "many headers": b"GET / HTTP/1.1\r\n" + b"X: y\r\n" * 30_000,
        "two lengths": target.head("Content-Length: 3") + b"{}",
        "length and chunks": target.head("Transfer-Encoding: chunked") + b"0\r\n\r\n",
        "no length that is a number": target.head("Content-Length: -1", length=None) + b"{}",
        "two hosts": target.head("Host: evil.example") + b"{}",
        "another host": target.head().replace(b"Host: 127.0.0.1", b"Host: evil.example", 1) + b"{}",
        "a host that looks right": target.head().replace(b"127.0.0.1:", b"127.0.0.1.evil.example:", 1) + b"{}",
        "no host": b"GET / HTTP/1.0\r\n\r\n",
        "a page from elsewhere": target.head("Origin: https://evil.example") + b"{}",
        "a file's page": target.head("Origin: null") + b"{}",
    }
    for name, request in bent.items():
        answer = target.told(request)
        assert not answer or answer[9:10] == b"4", (name, answer)
    for name in ("two hosts", "another host", "a host that looks right", "no host", "a page from elsewhere"):
        assert target.told(bent[name])[9:12] in (b"403", b"400"), name
    assert target.innocent()


@pytest.mark.parametrize(
    "body",
    [
        b"[" * 200_000,
        b'{"a":' * 100_000,
        b'{"jsonrpc": "2.0", "id": 1, "method": "tools/call", "params": ' + b"[" * 900 + b"]" * 900 + b"}",
        b'{"model": "m", "stream": true, "messages": ' + b"[" * 900 + b"]" * 900 + b"}",
        b'{"model": "\\ud800", "messages": []}',
        b'{"jsonrpc": "2.0", "id": "\\ud800", "method": "tools/call", "params": {"name": "\\ud800"}}',
        b'{"model": 1e999999, "id": NaN, "messages": 7}',
        b'{"a": ' + b"9" * 5000 + b"}",
        b"\xff\xfe{\x00}\x00",
        b"",
        b"null",
    ],
)
def test_bent_bodies_are_refused_and_harm_nobody(target: Target, body: bytes) -> None:
    answer = target.told(target.head("mcp-session-id: none", length=len(body)) + body)
    assert answer[9:10] == b"4" or answer[9:12] == b"502", answer
    assert target.innocent()


def test_an_upgrade_and_many_requests_in_one_go_are_answered_in_order(target: Target) -> None:
    upgrade = target.head("Upgrade: websocket", "Connection: Upgrade", "Sec-WebSocket-Version: 13") + b"{}"
    assert target.told(upgrade)[9:10] in (b"4", b"5")
    with target.connect() as connection:
        connection.sendall((target.head() + b"{}") * 200)
        connection.settimeout(5)
        assert connection.recv(9) == b"HTTP/1.1 "
    assert target.innocent()


def test_a_flood_of_whole_requests_does_not_stop_another_run(gateway: Target) -> None:
    body = json.dumps(INITIALIZE).encode()
    headers = {**HEADERS, "Authorization": f"Bearer {gateway.token}"}

    def knock(_: int) -> int:
        with httpx2.Client(trust_env=False) as http:
            try:
                return http.post(f"http://127.0.0.1:{gateway.port}/mcp", content=body, headers=headers).status_code
            except httpx2.TransportError:
                return 0

    with ThreadPoolExecutor(16) as pool:
        told = pool.map(knock, range(40))
        assert gateway.innocent()
        assert set(told) <= {0, 200, 429}
