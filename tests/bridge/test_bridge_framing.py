"""The bridge's messages on real sockets: split, oversized, non-ASCII, late, missing and nonsensical replies."""

from __future__ import annotations

import json
import socket
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from c4s.engine.bridge import BridgeFault, SocketBridge, decode, encode, read_line
from c4s.errors import MachineryFault

VALUES = st.recursive(
    st.none()
    | st.booleans()
    | st.integers(-(2**63), 2**64 - 1)
    | st.floats(allow_nan=False, allow_infinity=False)
    | st.text(st.characters(codec="utf-16", exclude_categories=())),
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(st.text(), inner, max_size=4),
)


@contextmanager
def peer(address: Path | tuple[str, int], answer: Callable[[socket.socket], None]) -> Iterator[SocketBridge]:
    """A bridge to a server that reads one request and then does ``answer`` with the connection."""
    family = socket.AF_UNIX if isinstance(address, Path) else socket.AF_INET
    with socket.socket(family) as listener:
        listener.bind(str(address) if isinstance(address, Path) else address)
        listener.listen()

        def serve() -> None:
            connection, _ = listener.accept()
            with connection:
                read_line(connection, 1 << 20, time.monotonic() + 10)
                answer(connection)

        thread = threading.Thread(target=serve)
        thread.start()
        yield SocketBridge(address if isinstance(address, Path) else listener.getsockname())
        thread.join()


@given(st.dictionaries(st.text(), VALUES, max_size=5), st.lists(st.integers(1, 40), min_size=1, max_size=30))
@settings(max_examples=60, deadline=None)
def test_a_message_survives_any_split(message: dict[str, object], sizes: list[int]) -> None:
    near, far = socket.socketpair()
    data = encode(message)
    with near, far:
        position = 0
        for size in sizes:
            far.sendall(data[position : position + size])
            position += size
        far.sendall(data[position:])
        assert decode(read_line(near, 1 << 20, time.monotonic() + 10)) == message


def test_a_raw_utf8_reply_is_understood(tmp_path: Path) -> None:
    def answer(connection: socket.socket) -> None:
        data = json.dumps({"status": "ok", "name": "Stühle 椅子"}, ensure_ascii=False).encode()
        for byte in data:
            connection.sendall(bytes([byte]))

    with peer(tmp_path / "s", answer) as bridge:
        assert bridge.request("editor_status")["name"] == "Stühle 椅子"


def test_a_tcp_editor_is_reached() -> None:
    with peer(("127.0.0.1", 0), lambda connection: connection.sendall(b'{"status": "ok"}\n')) as bridge:
        assert bridge.request("editor_status") == {"status": "ok"}


@pytest.mark.parametrize(
    ("reply", "complaint"),
    [
        (b"", "without an answer"),
        (b"[1]\n", "not an object"),
        (b'{"status": "o', "no message"),
        (b"\xff\xfe{}\n", "no message"),
        (b"[" * 100000 + b"\n", "no message"),
    ],
)
def test_a_broken_reply_is_a_fault_of_the_machinery(tmp_path: Path, reply: bytes, complaint: str) -> None:
    with (
        peer(tmp_path / "s", lambda connection: connection.sendall(reply)) as bridge,
        pytest.raises(BridgeFault, match=complaint),
    ):
        bridge.request("editor_status")


def test_a_late_reply_is_a_timeout_and_not_a_hang(tmp_path: Path) -> None:
    given_up = threading.Event()
    with peer(tmp_path / "s", lambda connection: (given_up.wait(10), None)[1]) as bridge:
        with pytest.raises(BridgeFault, match=r"no answer to editor_status in 0\.1 s"):
            bridge.request("editor_status", timeout_s=0.1)
        given_up.set()


def test_an_oversized_message_is_refused_before_it_is_read_to_its_end() -> None:
    near, far = socket.socketpair()
    with near, far:
        sender = threading.Thread(target=far.sendall, args=(b"x" * 50_000,))
        sender.start()
        with pytest.raises(ValueError, match="more than"):
            read_line(near, 10_000, time.monotonic() + 10)
        sender.join()


def test_no_engine_at_the_address(tmp_path: Path) -> None:
    with pytest.raises(BridgeFault, match="cannot reach the engine"):
        SocketBridge(tmp_path / "nobody").request("editor_status")


def test_a_socket_path_that_the_kernel_would_cut_is_refused(tmp_path: Path) -> None:
    with pytest.raises(MachineryFault, match="103 bytes"):
        SocketBridge(tmp_path / ("x" * 110))


def test_not_a_number_never_leaves() -> None:
    with pytest.raises(ValueError, match="JSON"):
        encode({"value": float("nan")})
