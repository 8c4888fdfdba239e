"""What a job prints: every byte of it, whoever in the engine writes it, and however the engine ends."""

from __future__ import annotations

import os
import signal
from pathlib import Path

import pytest

from c4s.engine import EngineDied
from c4s.engine.bridge import SocketBridge
from c4s.engine.headless.host.session import EngineSession

STUCK = "import re\nprint('begun')\nre.match(r'(a+)+b', 'a' * 64)"
"""Holds the interpreter's lock for longer than anyone waits."""

HANG_UP = (
    "import os, socket, stat\nfor n in range(3, 1024):\n try:\n  if stat.S_ISSOCK(os.fstat(n).st_mode): "
    "socket.socket(fileno=os.dup(n)).shutdown(2)\n except OSError: pass"
)
"""Cuts the engine's line to its host."""


def printed(engine: EngineSession, script: str) -> list[str]:
    """The lines of a script that ends well."""
    reply = engine.execute(script, timeout_s=60)
    assert reply["status"] == "ok", reply
    lines: list[str] = reply["result"]["python_logs"]
    return lines


def test_writers_below_python_are_in_the_log_in_order(shared_engine: EngineSession) -> None:
    script = (
        "import ctypes, os, sys\nprint('python')\nos.write(1, b'descriptor 1\\n')\n"
        "os.write(2, b'descriptor 2\\n')\nlibc = ctypes.CDLL(None)\nlibc.puts(b'C library')\nlibc.fflush(None)\n"
        "print('error', file=sys.stderr)\nlibc.puts(b'left in the buffer of C')"
    )
    assert printed(shared_engine, script) == [
        "python",
        "descriptor 1",
        "descriptor 2",
        "C library",
        "error",
        "left in the buffer of C",
    ]


def test_threads_lose_no_line(shared_engine: EngineSession) -> None:
    lines = printed(
        shared_engine,
        "from threading import Thread\n"
        "ts = [Thread(target=lambda n=n: [print(f'{n} {i}\\n', end='') for i in range(2000)])"
        " for n in range(8)]\nfor t in ts: t.start()\nfor t in ts: t.join()",
    )
    assert sorted(lines) == sorted(f"{n} {i}" for n in range(8) for i in range(2000))


def test_a_burst_of_ten_megabytes_and_a_line_of_ten_megabytes(shared_engine: EngineSession) -> None:
    lines = printed(shared_engine, "import os\nfor i in range(100): os.write(1, (b'%06d' % i) * 16384 + b'\\n')")
    assert [(line[:6], len(line)) for line in lines] == [(f"{i:06d}", 6 * 16384) for i in range(100)]
    assert printed(shared_engine, "print('x' * 10_000_000 + 'é')\nprint('end')") == ["x" * 10_000_000 + "é", "end"]


def test_closed_and_replaced_output_is_whole_again_for_the_next_job(shared_engine: EngineSession) -> None:
    shared_engine.execute("import os, sys\nsys.stdout.close(); sys.stderr = None; os.close(1); os.close(2)")
    assert printed(shared_engine, "print('here')") == ["here"]


@pytest.mark.parametrize(
    ("end", "name"),
    [
        ("import os; os._exit(7)", "exit code 7"),
        ("import ctypes; ctypes.string_at(1)", "SIGSEGV"),
        ("import os; os.abort()", "SIG(ABRT|SEGV)"),
        (HANG_UP, "exit code 1"),
    ],
)
def test_what_was_printed_before_a_crash_is_kept_and_told(engine: EngineSession, end: str, name: str) -> None:
    script = f"for i in range(9000): print('line', i)\nprint('last words', end='', flush=True)\n{end}\nwhile True: pass"
    bridge = SocketBridge(Path(str(engine.bridge.address)))
    with pytest.raises(EngineDied, match=name) as caught:
        engine.execute(script)
    assert caught.value.during == "execute_python_script"
    assert bridge.request("editor_status")["state"] == "dead"
    reply = bridge.request("read_job_log", {"job_id": "job-1"})
    assert reply["status"] == "error" and reply["fault"] == "EngineDied"
    assert reply["result"]["python_logs"][:9000] == [f"line {i}" for i in range(9000)]
    assert reply["result"]["python_logs"][9000].startswith("last words")
    assert (engine.logs / "job-1.log").read_bytes().count(b"\n") >= 9000


def test_busy_is_told_from_dead_while_the_interpreter_is_held(engine: EngineSession) -> None:
    assert engine.request("editor_status")["state"] == "idle"
    reply = engine.request("execute_python_script", {"script": STUCK, "wait_s": 1})
    assert reply["status"] == "running" and reply["result"]["python_logs"] == ["begun"]
    status = engine.request("editor_status", timeout_s=5)
    assert status["state"] == "busy" and status["job_id"] == reply["job_id"] and status["running_s"] > 0
    assert engine.request("abandon_job", {"job_id": reply["job_id"]}, timeout_s=5)["status"] == "ok"
    bridge = SocketBridge(Path(str(engine.bridge.address)))
    os.kill(engine.pid, signal.SIGKILL)
    assert bridge.request("read_job_log", {"job_id": reply["job_id"], "wait_s": 20})["engine_ended"]
    assert bridge.request("editor_status")["state"] == "dead"
    assert bridge.request("execute_python_script", {"script": "1"})["fault"] == "EngineDied"


def test_a_waiting_job_is_abandoned_at_once(engine: EngineSession) -> None:
    engine.request("execute_python_script", {"script": STUCK, "wait_s": 0})
    waiting = engine.request("execute_python_script", {"script": "print(1)", "wait_s": 0})
    assert engine.request("editor_status")["waiting"] >= 1
    engine.request("abandon_job", {"job_id": waiting["job_id"]})
    ended = engine.request("read_job_log", {"job_id": waiting["job_id"]})
    assert (ended["status"], ended["error"], ended["result"]["python_logs"]) == ("error", "abandoned", [])


def test_values_that_are_no_json_are_errors_of_their_call(shared_engine: EngineSession) -> None:
    shared_engine.execute(
        "import c4s.editor.capture as c\nc.odd = lambda v: {'nan': float('nan'), 'set': {1}, "
        "'huge': 10 ** 400, 'text': 'a\\ud800b\\n'}[v]"
    )
    assert shared_engine.call("capture.odd", v="text") == "a?b\n"
    for kind in ("nan", "set", "huge"):
        reply = shared_engine.request("call_function", {"function": "capture.odd", "params": {"v": kind}})
        assert reply["status"] == "error" and reply["fault"] in ("ValueError", "TypeError")
    assert printed(shared_engine, "print('up')") == ["up"]
