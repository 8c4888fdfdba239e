"""An editor as a process: it starts, is waited for, goes wrong, ends, and leaves nothing behind."""

from __future__ import annotations

import json
import os
import signal
import socket
import subprocess
import sys
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import ExitStack
from pathlib import Path

import pytest
from typer.testing import CliRunner

from bench.waiting import until
from c4s.cli.main import app
from c4s.engine import EngineDied, open_engine
from c4s.engine.confine.sandbox import faults
from c4s.engine.faults import EngineOverLimit
from c4s.engine.unreal.host.session import EditorSession
from c4s.engine.unreal.host.slots import MARK
from c4s.errors import BadInput, MachineryFault
from tests.standin import behaving

KIND, WAIT_S = "unreal-standin", 20.0
NEVER_ENDS = """
import time
while True:
    try:
        time.sleep(60)
    except BaseException:
        time.sleep(0.01)
"""
LEAVE_A_CHILD = """
import subprocess
child = subprocess.Popen(["/usr/bin/setsid", "/usr/bin/sleep", "600"])
print("child", child.pid)
"""


def start(root: Path) -> EditorSession:
    return EditorSession.start(KIND, packs=[], content=root / "content", scratch=root / "scratch")


def marked() -> list[int]:
    """Processes of editors' slots that run on this machine, of this test process alone."""
    mine = f"{MARK}={os.environ['C4S_HOME']}".encode()
    found = []
    for process in Path("/proc").glob("[0-9]*"):
        try:
            if mine in (process / "environ").read_bytes():
                found.append(int(process.name))
        except OSError:
            continue
    return found


def none_left() -> bool:
    return until(lambda: not marked())


@pytest.fixture(autouse=True)
def home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, editor: Path) -> Iterator[Path]:
    """A home of its own: its slots are no other test's, and none of its processes stays."""
    monkeypatch.setenv("C4S_HOME", str(tmp_path / "home"))
    yield tmp_path / "home"
    assert none_left()


def test_an_editor_says_what_it_is_and_logs_as_an_editor(session: EditorSession) -> None:
    assert (session.kind, session.version) == ("unreal-standin", "5.6.0-standin")
    assert session.request("editor_status")["engine"] == "unreal-standin"
    reply = session.execute("import unreal\nprint('printed')\nunreal.log_warning('logged')")
    assert reply["result"]["python_logs"] == ["printed", "Warning: logged"]
    session.close()
    log = (session.logs / "engine.log").read_text()
    assert "LogInit: Build: 5.6.0-standin" in log and "LogPython: Warning: logged" in log and "printed" not in log


def test_a_slow_start_is_waited_for(editor: Path, tmp_path: Path) -> None:
    with behaving(editor, start_s=3.0, workers=1), start(tmp_path) as session:
        assert session.alive


def test_an_editor_that_hangs_at_its_start_is_a_fault_in_time(
    editor: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("C4S_UNREAL_START_S", "3")
    with behaving(editor, hang_at_start=True, workers=2), pytest.raises(MachineryFault, match="START_S") as told:
        start(tmp_path)
    assert "Waiting for shaders" in told.value.what and not isinstance(told.value, EngineDied)


def test_an_editor_that_crashes_at_its_start_is_told_with_its_report(editor: Path, tmp_path: Path) -> None:
    with behaving(editor, crash_at_start=True), pytest.raises(EngineDied, match="the GPU is gone") as told:
        start(tmp_path)
    assert told.value.during == "start" and "Frame0" in told.value.what


def test_a_crash_in_a_job_is_the_end_of_the_engine_with_its_report(session: EditorSession, tmp_path: Path) -> None:
    script = "import os, signal, time\nprint('last words')\nos.kill(os.getpid(), signal.SIGSEGV)\ntime.sleep(9)"
    with pytest.raises(EngineDied, match="crash report crashinfo-C4SProject") as told:
        session.execute(script)
    assert "last words" in told.value.lines and "SIGSEGV" in told.value.what and not session.alive
    with start(tmp_path / "again") as again:
        assert again.execute("print('next')")["result"]["python_logs"] == ["next"]


def test_a_level_is_not_opened_from_a_tick_and_the_editor_lives(session: EditorSession) -> None:
    reply = session.execute("import unreal\nunreal.EditorLoadingAndSavingUtils.new_blank_map(False)")
    assert reply["fault"] == "LevelsStay" and session.alive
    with pytest.raises(EngineDied, match="Slate tick"):
        session.execute("unreal.EditorLoadingAndSavingUtils._real.new_blank_map(False)")


def test_a_script_that_ends_its_editor_is_told(session: EditorSession) -> None:
    with pytest.raises(EngineDied, match="exit code 3"):
        session.execute("import os\nos._exit(3)")


def test_an_editor_that_hangs_in_a_job_is_ended_in_time(session: EditorSession) -> None:
    reply = session.execute(NEVER_ENDS, timeout_s=1.0)
    with pytest.raises(EngineOverLimit, match="could not be ended"):
        session.request("read_job_log", {"job_id": reply["job_id"], "wait_s": WAIT_S})
    assert not session.alive


def test_a_script_that_does_not_end_is_ended(session: EditorSession) -> None:
    reply = session.execute("import time\nwhile True:\n    time.sleep(60)", timeout_s=1.0)
    assert reply["status"] in ("running", "error")
    assert session.execute("print('next')")["result"]["python_logs"] == ["next"]


@pytest.mark.parametrize("sandbox", ["bubblewrap", "landlock", "none"])
def test_what_a_script_leaves_running_ends_with_the_editor(
    sandbox: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    fault = {**faults(), "none": None}[sandbox]  # type: ignore[dict-item]
    if fault is not None:
        pytest.skip(f"{sandbox}: {fault}")
    monkeypatch.setenv("C4S_SANDBOX", sandbox)
    with start(tmp_path) as session:
        assert session.sandbox == sandbox
        assert session.execute(LEAVE_A_CHILD)["status"] == "ok"
        assert len(marked()) >= 3
    assert none_left()


@pytest.mark.parametrize("sandbox", ["bubblewrap", "landlock"])
def test_what_is_not_its_own_is_out_of_an_editors_reach(
    sandbox: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    if faults()[sandbox] is not None:  # type: ignore[index]
        pytest.skip(f"{sandbox}: {faults()[sandbox]}")  # type: ignore[index]
    monkeypatch.setenv("C4S_SANDBOX", sandbox)
    monkeypatch.setenv("A_KEY", "of the host")
    (tmp_path / "secret").write_text("the truth")
    with socket.create_server(("127.0.0.1", 0)) as server, start(tmp_path) as session:
        for attempt in (
            f"print(open({str(tmp_path / 'secret')!r}).read())",
            f"print(open('/proc/{os.getpid()}/environ').read())",
            f"import socket\nprint(socket.create_connection(('127.0.0.1', {server.getsockname()[1]}), 2))",
        ):
            reply = session.execute(attempt)
            assert reply["status"] == "error", attempt
            assert not {"the truth", "of the host"} & set(str(reply).split("'"))
        session.execute(f"open({str(tmp_path / 'home' / 'new')!r}, 'w')")
        assert not (tmp_path / "home" / "new").exists()
        told = session.execute("import os\nprint(sorted(os.environ))")["result"]["python_logs"]
    assert "A_KEY" not in str(told) and "PYTHONPATH" not in str(told)
    with pytest.raises(MachineryFault, match="withheld"):
        start(tmp_path / "withheld")


def test_an_editor_dies_with_its_host(tmp_path: Path, editor: Path) -> None:
    code = (
        "import sys, time; from pathlib import Path; from c4s.engine import open_engine\n"
        "e = open_engine('unreal-standin', packs=[], content=Path(sys.argv[1], 'c'), scratch=Path(sys.argv[1], 's'))\n"
        "print('up', flush=True); time.sleep(600)"
    )
    host = subprocess.Popen([sys.executable, "-c", code, str(tmp_path)], stdout=subprocess.PIPE, text=True)
    assert host.stdout is not None and host.stdout.readline() == "up\n"
    os.kill(host.pid, signal.SIGKILL)
    host.wait()
    host.stdout.close()
    assert none_left()


def test_what_an_earlier_host_left_is_swept_when_a_slot_is_taken(home: Path, tmp_path: Path) -> None:
    mark = str(home / "cache/unreal/slots/0.lock")
    orphan = subprocess.Popen(["/usr/bin/sleep", "600"], env={MARK: mark})
    with start(tmp_path):
        assert orphan.wait(WAIT_S) == -signal.SIGKILL


def test_four_slots_run_side_by_side_each_on_its_own(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("C4S_UNREAL_GPUS", "0,1")
    tell = "import os, unreal\nprint(os.environ['CUDA_VISIBLE_DEVICES'], unreal.Paths.project_dir())"
    with ExitStack() as open_ones, ThreadPoolExecutor(4) as pool:
        sessions = list(pool.map(lambda n: open_ones.enter_context(start(tmp_path / f"slot-{n}")), range(4)))
        told = [one.execute(tell)["result"]["python_logs"][0].split() for one in sessions]
        assert sorted(gpu for gpu, _ in told) == ["0", "0", "1", "1"]
        assert len({folder for _, folder in told}) == 4
        assert len({str(one.bridge.address) for one in sessions}) == 4
        sessions[0].kill()
        assert [one.execute("print('lives')")["result"]["python_logs"] for one in sessions[1:]] == [["lives"]] * 3
        with start(tmp_path / "after") as after:
            assert after.execute(tell)["status"] == "ok"


def test_a_path_that_an_editor_cannot_be_told_is_bad_input(tmp_path: Path) -> None:
    with pytest.raises(BadInput, match="blank"):
        start(tmp_path / "a b")


def test_a_wrong_limit_is_bad_input(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("C4S_UNREAL_WARM_S", "soon")
    with pytest.raises(BadInput, match="C4S_UNREAL_WARM_S"):
        start(tmp_path)


def test_a_project_has_its_pinned_version_plugins_and_settings(session: EditorSession, tmp_path: Path) -> None:
    project = tmp_path / "scratch" / "project"
    told = json.loads((project / "C4SProject.uproject").read_text())
    assert told["EngineAssociation"] == "5.6"
    assert {one["Name"] for one in told["Plugins"]} == {"PythonScriptPlugin", "EditorScriptingUtilities"}
    settings = (project / "Config/DefaultEngine.ini").read_text()
    assert "bSendUsageData=False" in settings and "RecastNavMesh" in settings
    assert "Shared=(Type=FileSystem, ReadOnly=true" in settings
    with pytest.raises(BadInput, match="/Game/No/Map"):
        open_engine(KIND, packs=[], content=tmp_path / "c", scratch=tmp_path / "s", start_map="/Game/No/Map")


def test_a_stand_in_is_never_taken_for_an_editor(tmp_path: Path) -> None:
    with pytest.raises(MachineryFault, match="of the engine unreal-standin"):
        open_engine("unreal", packs=[], content=tmp_path / "c", scratch=tmp_path / "s")


def test_an_editor_of_another_version_and_none_at_all_are_refused_in_one_line(
    editor: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("C4S_UNREAL_VERSION", "5.8")
    with pytest.raises(MachineryFault, match=r"is 5\.6\.0-standin, and c4s is pinned to 5\.8") as wrong:
        start(tmp_path)
    monkeypatch.setenv("C4S_UNREAL_EDITOR", str(tmp_path / "nowhere"))
    with pytest.raises(MachineryFault, match="this is no Unreal Editor"):
        start(tmp_path)
    monkeypatch.delenv("C4S_UNREAL_EDITOR")
    with pytest.raises(MachineryFault, match=r"docs/unreal\.md") as none:
        start(tmp_path)
    assert "\n" not in wrong.value.line() + none.value.line()


def test_doctor_tells_what_there_is_of_an_editor(editor: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def rows() -> dict[str, dict[str, object]]:
        return {row["what"]: row for row in json.loads(CliRunner().invoke(app, ["doctor", "--json"]).stdout)}

    told = rows()
    assert told["Unreal Editor"]["found"] and told["editor plugins"]["found"]
    assert f"5.6.0-standin in {editor}, engine unreal-standin" in str(told["Unreal Editor"]["text"])
    monkeypatch.setenv("C4S_UNREAL_VERSION", "5.8")
    assert not rows()["Unreal Editor"]["found"]
    monkeypatch.setenv("C4S_UNREAL_EDITOR", str(editor / "nowhere"))
    missing = rows()
    assert "this is no Unreal Editor" in str(missing["Unreal Editor"]["text"]) and "editor plugins" not in missing
