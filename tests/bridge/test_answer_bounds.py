"""Answers of an engine that are huge, deep, slow or no text: refused in bounded time and memory, in one line."""

from __future__ import annotations

import re
import socket
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from c4s.bounds import BOUNDS
from c4s.engine.bridge import BridgeFault, SocketBridge
from c4s.engine.faults import EngineCallError
from c4s.engine.headless.host.session import EngineSession

sys.path.insert(0, str(Path(__file__).parents[1] / "robustness"))
from limited import cost

ANSWERS = {
    "empty lists": ("b'{\"a\":[' + b'[],' * (16 << 20) + b'0]}'", "values, more than 8,000,000 values"),
    "empty records": ("b'{\"a\":[' + b'{},' * (16 << 20) + b'0]}'", "values, more than 8,000,000 values"),
    "newlines before it": ("b' ' * (97 << 20) + b'{}'", "97 MiB, more than 96 MiB"),
    "a long number": ("b'{\"a\":' + b'9' * (90 << 20) + b'}'", "too many digits"),
    "deep lists": ("b'[' * (7 << 20)", "nested too deep|not valid|recursion|expect"),
    "deep records": ("b'{\"a\":' * (4 << 20)", "nested too deep|not valid|recursion|expect"),
    "no object": ("b'[1]'", "not an object"),
    "no text": ("b'{\"a\":\"' + b'\\xff' * (10 << 20) + b'\"}'", "utf|UTF|surrogate"),
    "not a number": ("b'{\"a\":[' + b'1,' * (7 << 20) + b'NaN]}'", "^dict$"),
}


@pytest.mark.parametrize("name", ANSWERS)
def test_a_wrong_answer_costs_little(name: str) -> None:
    made, answer = ANSWERS[name]
    script = f"""
from c4s.engine.bridge import decode
data = {made}
def work():
    try:
        return type(decode(data)).__name__
    except ValueError as error:
        return str(error)[:300]
told(work)
"""
    found = cost(script, memory_mib=3072, cpu_s=30)
    assert re.search(answer, found.answer), found
    assert found.memory_mib < 1500


@contextmanager
def answering(folder: Path, answer: bytes, *, again: bool = False) -> Iterator[SocketBridge]:
    """A bridge whose other side answers every request with these bytes, or with one of them after the other."""
    place = folder / "s"
    with socket.socket(socket.AF_UNIX) as listener:
        listener.bind(str(place))
        listener.listen()

        def serve() -> None:
            connection, _ = listener.accept()
            with connection:
                connection.recv(1 << 16)
                try:
                    while again:
                        connection.send(answer)
                    connection.sendall(answer)
                except OSError:
                    return

        server = threading.Thread(target=serve, daemon=True)
        server.start()
        yield SocketBridge(place)
        server.join()


@pytest.mark.parametrize(
    ("kind", "bound"), [("editor_status", "small_answer_bytes"), ("call_function", "answer_bytes")]
)
def test_an_answer_without_end_is_cut_off_at_the_bound_of_its_kind(tmp_path: Path, kind: str, bound: str) -> None:
    with (
        answering(tmp_path, b" " * (1 << 20), again=True) as bridge,
        pytest.raises(BridgeFault, match=f"more than {BOUNDS[bound].most >> 20} MiB"),
    ):
        bridge.request(kind)


def test_an_answer_in_drops_ends_with_the_time_of_the_whole_request(tmp_path: Path) -> None:
    with answering(tmp_path, b" ", again=True) as bridge, pytest.raises(BridgeFault, match=r"no answer .* in 0.3 s"):
        bridge.request("editor_status", timeout_s=0.3)


def test_a_value_beyond_the_bounds_fails_its_call_and_the_engine_goes_on(tmp_path: Path) -> None:
    with EngineSession.start(packs=[], content=tmp_path / "content", scratch=tmp_path / "scratch") as engine:
        for value, answer in (
            ("'x' * (100 << 20)", "100 MiB, more than 96 MiB"),
            ("[[]] * 5_000_000", "values, more than 8,000,000"),
        ):
            engine.execute(f"from c4s.editor import snapshot\nsnapshot.huge = lambda: {value}")
            with pytest.raises(EngineCallError, match=answer):
                engine.call("snapshot.huge")
        told = engine.execute("raise ValueError('x' * (3 << 20))")["error"]
        assert len(told) <= 100_000 and engine.call("snapshot.export_snapshot")["actor_count"] == 0
