"""A real engine process behind its real socket: scripts, jobs, calls, pictures, and every way that it can end."""

from __future__ import annotations

import json
import os
import shutil
import signal
import socket
import subprocess
import sys
import threading
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from bench.waiting import until
from c4s.engine import EngineCallError, EngineDied
from c4s.engine.faults import EngineOverLimit
from c4s.engine.headless.host.session import EngineSession
from c4s.errors import BadInput, MachineryFault


def lines(reply: dict[str, object]) -> list[str]:
    """Printed lines of a reply."""
    result = reply["result"]
    assert isinstance(result, dict)
    return list(result["python_logs"])


def test_scripts_share_one_namespace_and_print_whole_lines(shared_engine: EngineSession) -> None:
    assert shared_engine.request("execute_python_script", {"script": "x = 'Stühle 椅子'"})["status"] == "ok"
    reply = shared_engine.execute("import sys\nprint(x)\nprint('to stderr', file=sys.stderr)\nprint('no end', end='')")
    assert reply["status"] == "ok"
    assert lines(reply) == ["Stühle 椅子", "to stderr", "no end"]


def test_no_line_is_lost_however_many_there_are(shared_engine: EngineSession) -> None:
    reply = shared_engine.execute("for i in range(100000): print('line', i, 'x' * 40)")
    assert reply["status"] == "ok"
    assert lines(reply) == [f"line {i} {'x' * 40}" for i in range(100000)]


def test_an_error_shows_the_script_and_not_the_engine(shared_engine: EngineSession) -> None:
    reply = shared_engine.execute("print('before')\ndef f():\n    return 1 / 0\nf()")
    assert reply["status"] == "error" and reply["fault"] == "ZeroDivisionError"
    assert lines(reply) == ["before"]
    assert "return 1 / 0" in reply["error"] and "server.py" not in reply["error"] and "jobs.py" not in reply["error"]
    assert shared_engine.execute("import sys; sys.exit()")["status"] == "ok"
    assert shared_engine.execute("import sys; sys.exit('no')")["status"] == "error"
    assert shared_engine.execute("def :")["fault"] == "SyntaxError"


def test_a_long_script_becomes_a_job_that_can_be_watched_and_abandoned(shared_engine: EngineSession) -> None:
    script = "print('begun')\nwhile True: pass"
    reply = shared_engine.request("execute_python_script", {"script": script, "wait_s": 0.2})
    assert reply["status"] == "running" and lines(reply) == ["begun"]
    status = shared_engine.request("editor_status")
    assert status["busy"] and status["job_id"] == reply["job_id"]
    queued = shared_engine.request("execute_python_script", {"script": "print('next')", "wait_s": 0})
    assert queued["status"] == "running"
    assert shared_engine.request("abandon_job", {"job_id": reply["job_id"]})["status"] == "ok"
    ended = shared_engine.request("read_job_log", {"job_id": reply["job_id"], "wait_s": 10})
    assert ended["status"] == "error" and ended["error"] == "abandoned" and lines(ended) == ["begun"]
    assert lines(shared_engine.request("read_job_log", {"job_id": queued["job_id"], "wait_s": 10})) == ["next"]


def test_a_script_that_outlasts_its_time_is_abandoned(shared_engine: EngineSession) -> None:
    assert shared_engine.execute("while True: pass", timeout_s=0.3)["status"] == "running"
    assert shared_engine.execute("print('alive')", timeout_s=10)["result"]["python_logs"] == ["alive"]


@pytest.mark.parametrize(
    "message",
    [
        b"",
        b"\n",
        b"no json\n",
        b"[]\n",
        b'{"type": "unknown"}\n',
        b'{"type": 3}\n',
        b"[" * 50000 + b"\n",
        b"\xff\n",
        b'{"type": "execute_python_script", "params": {"script": 3}}\n',
        b'{"type": "execute_python_script", "params": [1]}\n',
        b'{"type": "execute_python_script", "params": {"script": "1", "wait_s": NaN}}\n',
        b'{"type": "read_job_log", "params": {"job_id": "job-99"}}\n',
        b'{"type": "take_screenshot_batch"}\n',
        b'{"type": "call_function", "params": {"function": "os.path.join"}}\n',
    ],
)
def test_nonsense_is_answered_with_an_error(shared_engine: EngineSession, message: bytes) -> None:
    address = shared_engine.bridge.address
    with socket.socket(socket.AF_UNIX) as connection:
        connection.connect(str(address))
        connection.sendall(message)
        connection.shutdown(socket.SHUT_WR)
        reply = json.loads(connection.makefile("rb").read())
    assert reply["status"] == "error" and reply["fault"] == "BadRequest"
    assert shared_engine.execute("print(1)")["status"] == "ok"


def test_a_request_in_pieces_and_a_client_that_leaves(shared_engine: EngineSession) -> None:
    address = str(shared_engine.bridge.address)
    with socket.socket(socket.AF_UNIX) as leaver:
        leaver.connect(address)
        leaver.sendall(b'{"type": "execute_python_script", "params": {"script": "left = 1"}}\n')
    while shared_engine.execute("print('left' in globals())")["result"]["python_logs"] != ["True"]:
        continue
    with socket.socket(socket.AF_UNIX) as connection:
        connection.connect(address)
        for byte in b'{"type": "execute_python_script", "params": {"script": "print(left + 1)"}}\n':
            connection.sendall(bytes([byte]))
        assert json.loads(connection.makefile("rb").read())["result"]["python_logs"] == ["2"]


def test_calls_return_values_apart_from_what_is_printed(shared_engine: EngineSession) -> None:
    records = shared_engine.call("capture.capture_views", cameras=[], folder="unused")
    assert records == []
    with pytest.raises(EngineCallError, match="mode must be one of") as caught:
        shared_engine.call("capture.capture_views", cameras=[], folder="unused", mode="x-ray")
    assert caught.value.kind == "ValueError" and "Traceback" in caught.value.detail
    with pytest.raises(EngineCallError, match="no_such"):
        shared_engine.call("capture.no_such")


@pytest.mark.parametrize("script", ["import os; os._exit(7)", "import ctypes; ctypes.string_at(1)"])
def test_an_engine_that_ends_is_a_fault_at_once(engine: EngineSession, script: str) -> None:
    with pytest.raises(EngineDied, match="engine ended") as caught:
        engine.execute(script)
    assert caught.value.during == "execute_python_script" and isinstance(caught.value, MachineryFault)
    with pytest.raises(EngineDied):
        engine.request("editor_status")
    assert not engine.alive


def test_kill_during_a_job_and_between_requests(engine: EngineSession) -> None:
    killer = threading.Timer(0.3, os.kill, (engine.pid, signal.SIGKILL))
    killer.start()
    with pytest.raises(EngineDied, match="SIGKILL"):
        engine.execute("while True: pass")
    killer.join()


def processes_of(folder: Path) -> list[int]:
    """Processes that were started with this folder in their arguments."""
    found = []
    for place in Path("/proc").glob("[0-9]*/cmdline"):
        try:
            arguments = place.read_bytes()
        except (FileNotFoundError, ProcessLookupError):
            continue
        if f'"scratch": "{folder}"'.encode() in arguments:
            found.append(int(place.parent.name))
    return found


@pytest.mark.parametrize("clinging", ["", "import ctypes; ctypes.CDLL(None).prctl(1, 0, 0, 0, 0)\n"])
def test_the_engine_dies_with_its_host(tmp_path: Path, backend: str, clinging: str) -> None:
    host = subprocess.Popen(
        [
            sys.executable,
            "-c",
            "import sys; from pathlib import Path; from c4s.engine.headless.host.session import EngineSession\n"
            f"root = Path({str(tmp_path)!r})\n"
            f"s = EngineSession.start(packs=[], content=root / 'c', scratch=root / 's', use={backend!r})\n"
            f'script = {clinging!r} + \'import re\\nprint(1)\\nre.match(r"(a+)+b", "a" * 64)\'\n'
            "s.request('execute_python_script', {'script': script, 'wait_s': 0.3})\n"
            "print(s.bridge.address, flush=True); sys.stdin.read()",
        ],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
    )
    assert host.stdout is not None
    assert host.stdout.readline().strip()
    assert processes_of(tmp_path / "s")
    host.kill()
    host.wait()
    until(lambda: not processes_of(tmp_path / "s"))


LOOSE = """#!{python}
import subprocess, sys
sys.exit(subprocess.call(["{bwrap}", *(word for word in sys.argv[1:] if word != "--die-with-parent")], close_fds=False))
"""
"""A bubblewrap whose engine does not die with it, as one that is killed before it has asked for that."""


def test_an_engine_whose_confinement_was_killed_ends_with_its_session(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    outer = tmp_path / "bin/bwrap"
    outer.parent.mkdir()
    outer.write_text(LOOSE.format(python=sys.executable, bwrap=shutil.which("bwrap")))
    outer.chmod(0o755)
    monkeypatch.setenv("PATH", f"{outer.parent}:{os.environ['PATH']}")
    engine = EngineSession.start(packs=[], content=tmp_path / "c", scratch=tmp_path / "s", use="bubblewrap")
    os.kill(engine.pid, signal.SIGKILL)
    until(lambda: not engine.alive)
    engine.close()
    until(lambda: not processes_of(tmp_path / "s"))


def test_a_start_whose_confinement_is_killed_ends_and_leaves_nothing(tmp_path: Path) -> None:
    def kill() -> None:
        os.kill(min(until(lambda: processes_of(tmp_path / "s") or None)), signal.SIGKILL)

    killer = threading.Thread(target=kill)
    killer.start()
    with pytest.raises(EngineDied):
        EngineSession.start(packs=[], content=tmp_path / "c", scratch=tmp_path / "s", use="bubblewrap")
    killer.join()
    until(lambda: not processes_of(tmp_path / "s"))


WAITED_FOR = """#!{python}
import os, signal, sys
if "c4s.engine.headless.process.main" not in " ".join(sys.argv):
    os.execv("{bwrap}", ["bwrap", *sys.argv[1:]])
if os.fork():
    os.kill(os.getpid(), signal.SIGKILL)
while True:
    signal.pause()
"""
"""A bubblewrap that is killed when its inner process, which holds the connection, waits for it."""


def test_what_waits_for_a_killed_confinement_ends_with_it(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    outer = tmp_path / "bin/bwrap"
    outer.parent.mkdir()
    outer.write_text(WAITED_FOR.format(python=sys.executable, bwrap=shutil.which("bwrap")))
    outer.chmod(0o755)
    monkeypatch.setenv("PATH", f"{outer.parent}:{os.environ['PATH']}")
    with pytest.raises(EngineDied, match="SIGKILL"):
        EngineSession.start(packs=[], content=tmp_path / "c", scratch=tmp_path / "s", use="bubblewrap")
    until(lambda: not processes_of(tmp_path / "s"))


def test_an_engine_outlives_the_thread_that_started_it(tmp_path: Path, backend: str) -> None:
    made: list[EngineSession] = []

    def start() -> None:
        made.append(EngineSession.start(packs=[], content=tmp_path / "c", scratch=tmp_path / "s", use=backend))  # type: ignore[arg-type]

    thread = threading.Thread(target=start)
    thread.start()
    thread.join()
    with made[0] as engine:
        assert engine.execute("print('here')")["status"] == "ok"


def test_close_ends_the_process_and_removes_the_socket(tmp_path: Path) -> None:
    engine = EngineSession.start(packs=[], content=tmp_path / "c", scratch=tmp_path / "s")
    engine.close()
    assert not engine.alive and not Path(str(engine.bridge.address)).parent.exists()
    engine.close()


def test_a_close_is_not_held_up_by_a_script(tmp_path: Path) -> None:
    engine = EngineSession.start(packs=[], content=tmp_path / "c", scratch=tmp_path / "s")
    engine.request(
        "execute_python_script", {"script": "while True:\n try: pass\n except BaseException: pass", "wait_s": 0}
    )
    engine.kill()
    assert not engine.alive


def test_bad_input_is_told_as_such(tmp_path: Path, level: Path) -> None:
    with pytest.raises(BadInput, match="no asset pack"):
        EngineSession.start(packs=[tmp_path], content=tmp_path / "c", scratch=tmp_path / "s")
    with pytest.raises(BadInput, match="no such level file"):
        EngineSession.start(packs=[], content=tmp_path / "c", scratch=tmp_path / "s", levels=[tmp_path / "none"])
    level.write_text('{"schema_version": "c4s.level.v1", "pack')
    with pytest.raises(BadInput):
        EngineSession.start(
            packs=[], content=tmp_path / "c", scratch=tmp_path / "s", levels=[level], start_map="/Game/Start/Room"
        )


def test_withheld_files_are_never_mounted(tmp_path: Path, level: Path) -> None:
    hidden = tmp_path / "withheld" / "case" / "truth.level.json"
    hidden.parent.mkdir(parents=True)
    hidden.write_bytes(level.read_bytes())
    with pytest.raises(MachineryFault, match="withheld"):
        EngineSession.start(packs=[], content=tmp_path / "c", scratch=tmp_path / "s", levels=[hidden])


def test_screenshots_show_the_level_and_name_its_actors(tmp_path: Path, level: Path) -> None:
    with EngineSession.start(
        packs=[], content=tmp_path / "c", scratch=tmp_path / "s", levels=[level], start_map="/Game/Start/Room"
    ) as engine:
        shot = {
            "width": 160,
            "height": 90,
            "camera_location": [-400, 0, 100],
            "camera_rotation": [0, 0, 0],
            "field_of_view": 60,
        }
        reply = engine.request("take_screenshot", {**shot, "filepath": "one.png"}, timeout_s=120)
        assert reply["status"] == "ok" and reply["filename"] == "one.png"
        with Image.open(reply["filepath"]) as picture:
            assert picture.size == (160, 90) and np.asarray(picture).std() > 5
        plain = engine.request("take_screenshot", {"camera_location": [-400, 0, 100]}, timeout_s=120)
        with Image.open(plain["filepath"]) as picture:
            assert picture.size == (1920, 1080), "as the published bridge"
        unmoved = engine.request("take_screenshot", {"width": 160, "height": 90})
        assert set(unmoved["visible"]) == {f"StaticMeshActor_{number}" for number in range(3)}, "the viewport sees all"
        batch = engine.request(
            "take_screenshot_batch",
            {
                "shots": [
                    {**shot, "filepath": f"b{i}.png", "mode": mode} for i, mode in enumerate(["lit", "base_color"])
                ]
            },
        )
        assert batch["status"] == "success" and len(batch["results"]) == 2 and batch["missing"] == []
        assert engine.request("take_screenshot_batch", {"shots": [shot] * 17})["fault"] == "BadRequest"
        assert engine.request("take_screenshot", {**shot, "filepath": "/etc/evil.png"})["status"] == "error"
        views = engine.call(
            "capture.capture_views",
            folder=str(tmp_path / "s" / "views"),
            cameras=[
                {
                    "name": "side",
                    "location_cm": [-400, 0, 100],
                    "target_cm": [0, 0, 50],
                    "fov_deg": 60,
                    "width": 160,
                    "height": 90,
                }
            ],
        )
    assert set(views[0]["visible"]) >= {"StaticMeshActor_0", "StaticMeshActor_1"}
    mask = np.load(tmp_path / "s" / "views" / "side.actors.npz")
    centre = mask["actor"][45, 80]
    assert mask["labels"][centre] == "Box" and mask["names"][centre] == "StaticMeshActor_1"
    assert mask["depth_cm"][45, 80] == pytest.approx(353, abs=8)
    assert mask["actor"][0, 0] == -1 and np.isinf(mask["depth_cm"][0, 0])


def test_a_job_is_held_to_its_time_and_says_whether_it_has_begun(shared_engine: EngineSession) -> None:
    script = {"script": "while True: pass", "wait_s": 0}
    first = shared_engine.request("execute_python_script", {**script, "limit_s": 0.5})
    second = shared_engine.request("execute_python_script", {**script, "limit_s": 0.5})
    assert second["queued"] and second["status"] == "running"
    for job in (first, second):
        ended = shared_engine.request("read_job_log", {"job_id": job["job_id"], "wait_s": 60})
        assert (ended["status"], ended["fault"]) == ("error", "JobOverTime") and "longer than 0.5 s" in ended["error"]
    assert "queued" not in ended and lines(shared_engine.execute("print('alive')")) == ["alive"]


def test_a_job_that_cannot_be_ended_ends_with_its_engine(engine: EngineSession) -> None:
    engine.request("execute_python_script", {"script": "sum(range(10 ** 12))", "wait_s": 0, "limit_s": 0.5})
    with pytest.raises(EngineOverLimit, match=r"job-1 ran longer than 0.5 s and could not be ended"):
        engine.request("execute_python_script", {"script": "print(1)", "wait_s": 60})


def test_a_part_of_an_output_is_as_long_as_was_asked(shared_engine: EngineSession) -> None:
    reply = shared_engine.execute("print('x' * 3_000_000)\nprint('end')")
    asked = {"job_id": reply["job_id"], "max_bytes": 6}
    last = shared_engine.request("read_job_log", asked)["result"]
    assert (last["python_logs"], last["log_bytes"]) == (["x", "end"], 3_000_005)
    assert (last["offset"], last["next_offset"], last["more"]) == (2_999_999, 3_000_005, False)
    first = shared_engine.request("read_job_log", asked | {"offset": 0})["result"]
    assert (first["python_logs"], first["next_offset"], first["more"]) == (["x" * 6], 6, True)
    assert shared_engine.request("read_job_log", asked | {"max_bytes": 0})["result"]["python_logs"] == []
