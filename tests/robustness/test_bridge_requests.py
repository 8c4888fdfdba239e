"""Wrong, cut off and oversized requests, and clients that misbehave: a clear answer, and the engine stays up."""

from __future__ import annotations

import json
import socket
import threading
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from odd import wrong

from c4s.engine.bridge import MAX_REQUEST_BYTES
from c4s.engine.headless.host.session import EngineSession

REQUESTS: list[dict[str, Any]] = [
    {"type": "execute_python_script", "params": {"script": "print(1)", "wait_s": 0.01}},
    {"type": "read_job_log", "params": {"job_id": "job-1", "wait_s": 0.01, "offset": 0}},
    {"type": "abandon_job", "params": {"job_id": "job-1"}},
    {"type": "editor_status", "params": {}},
    {
        "type": "call_function",
        "params": {"function": "scene_tools.find_actors", "params": {"pattern": "x"}, "wait_s": 0.01},
    },
    {"type": "take_screenshot_batch", "params": {"shots": []}},
    {"type": "begin_rendering"},
]


@pytest.fixture(scope="module")
def engine(tmp_path_factory: pytest.TempPathFactory) -> Iterator[EngineSession]:
    """One engine for all: it must survive them."""
    root = tmp_path_factory.mktemp("robust")
    with EngineSession.start(packs=[], content=root / "content", scratch=root / "scratch") as session:
        yield session


def exchange(engine: EngineSession, data: bytes) -> dict[str, Any]:
    """Send bytes as they are; the reply."""
    with socket.socket(socket.AF_UNIX) as connection:
        connection.connect(str(engine.bridge.address))
        connection.settimeout(60)
        connection.sendall(data)
        connection.shutdown(socket.SHUT_WR)
        reply: dict[str, Any] = json.loads(connection.makefile("rb").read())
        return reply


@given(st.sampled_from(REQUESTS).flatmap(wrong))
@settings(max_examples=200, deadline=None)
def test_a_wrong_request_is_answered(engine: EngineSession, data: bytes) -> None:
    reply = exchange(engine, data)
    assert reply["status"] in ("ok", "success", "partial", "running", "error")
    if reply["status"] == "error":
        assert reply["error"]
    assert engine.alive


def test_the_engine_is_up_after_all(engine: EngineSession) -> None:
    assert engine.execute("print('up')", timeout_s=30)["result"]["python_logs"] == ["up"]


def test_an_oversized_request_is_refused_before_its_end(engine: EngineSession) -> None:
    reply = exchange(engine, b'{"type": "' + b"x" * (MAX_REQUEST_BYTES + (1 << 20)))
    assert reply["fault"] == "BadRequest" and "more than 64 MiB" in reply["error"]


@pytest.mark.parametrize("value", ["-1", "1e400", "NaN", "null", '"1"', "[]", "true", "1e10"])
@pytest.mark.parametrize("name", ["wait_s", "offset"])
def test_numbers_that_are_none(engine: EngineSession, name: str, value: str) -> None:
    job = engine.execute("print(1)")["job_id"]
    request = f'{{"type": "read_job_log", "params": {{"job_id": "{job}", "{name}": {value}}}}}\n'
    reply = exchange(engine, request.encode())
    assert reply["fault"] == "BadRequest" and reply["error"]


@pytest.mark.parametrize(
    ("field", "value", "complaint"),
    [
        ("camera_location", [1, 2], "three numbers"),
        ("camera_location", ["x", 0, 0], "three numbers"),
        ("camera_rotation", [0, 0, 1e300], "three numbers"),
        ("width", 0, "above 0"),
        ("height", "9", "above 0"),
        ("field_of_view", -3, "above 0"),
        ("exposure_bias_ev", "x", "a number"),
        ("filepath", 5, "a string"),
    ],
)
def test_a_wrong_shot_is_refused_in_one_line(engine: EngineSession, field: str, value: object, complaint: str) -> None:
    shot = {"width": 16, "height": 16, "camera_location": [0, 0, 0], "camera_rotation": [0, 0, 0]} | {field: value}
    for kind, params in (("take_screenshot", shot), ("take_screenshot_batch", {"shots": [shot]})):
        reply = engine.request(kind, params)
        assert reply["fault"] == "BadRequest" and field in reply["error"] and complaint in reply["error"]
        assert "\n" not in reply["error"]


def test_half_open_clients_do_not_shut_others_out(engine: EngineSession) -> None:
    clients = []
    try:
        for number in range(40):
            client = socket.socket(socket.AF_UNIX)
            client.connect(str(engine.bridge.address))
            client.sendall(b'{"type": "edi'[: number % 13])
            clients.append(client)
        assert engine.request("editor_status", timeout_s=5)["state"] in ("idle", "busy")
        clients[20].shutdown(socket.SHUT_WR)
        assert json.loads(clients[20].makefile("rb").read())["fault"] == "BadRequest"
    finally:
        for client in clients:
            client.close()


def test_clients_at_once_get_their_own_answers_from_one_queue(engine: EngineSession) -> None:
    engine.execute("order = []")
    answers: dict[int, list[str]] = {}

    def ask(number: int) -> None:
        reply = engine.execute(f"order.append({number})\nfor _ in range(50): print({number})")
        answers[number] = reply["result"]["python_logs"]

    threads = [threading.Thread(target=ask, args=(number,)) for number in range(12)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert answers == {number: [str(number)] * 50 for number in range(12)}
    assert engine.execute("print(sorted(order) == list(range(12)))")["result"]["python_logs"] == ["True"]


def test_what_agents_write_is_no_submission(tmp_path: Path) -> None:
    from c4s.engine.content import content_fault

    (tmp_path / "Game").mkdir()
    (tmp_path / "Game" / "fine.level.json").write_text("{}")
    assert content_fault(tmp_path) is None
    deep = tmp_path / "Game"
    for _ in range(40):
        deep = deep / "d"
    deep.mkdir(parents=True)
    assert "nested" in (content_fault(tmp_path) or "")
    (tmp_path / "Game" / "d").rename(tmp_path / "Game" / "line\nbreak")
    assert "is no text" in (content_fault(tmp_path) or "")
    assert "cannot be read" in (content_fault(tmp_path / "none") or "")
