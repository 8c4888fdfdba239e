"""Attacks by an agent in a whole attempt: each is the agent's failure or its lost call, never the machinery's."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import pytest

from c4s.agents import base
from c4s.agents.base import AgentContext, AgentReport
from c4s.errors import BadInput
from c4s.evidence import export_and_look
from c4s.records.attempt import AttemptOutcome
from c4s.records.plan import Configuration
from c4s.run.attempt import run_attempt

sys.path.insert(0, str(Path(__file__).parents[1] / "toolbox"))


@pytest.fixture(scope="module")
def pack(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The small pack of the toolbox tests."""
    from made_case import make_pack

    folder: Path = make_pack(tmp_path_factory.mktemp("packs"))
    return folder


class Attacker:
    """Saves the scene, then runs the script of its configuration."""

    def run(self, context: AgentContext) -> AgentReport:
        with context.connect() as tools:
            tools.call("save_scene_as", name="early")
            tools.call("execute_python_script", script=context.configuration.options["script"], execution_mode="sync")
        return AgentReport()


def attacked(tmp_path: Path, pack: Path, monkeypatch: pytest.MonkeyPatch, script: str) -> tuple[AttemptOutcome, Path]:
    """The outcome of an attempt whose agent runs a script, and its folder."""
    from made_case import make_case

    monkeypatch.setitem(base.CLIENTS, "attacker", f"{__name__}:Attacker")
    case, agent_folder = make_case(tmp_path / "suite", pack)
    folder = tmp_path / "attempt-1"
    configuration = Configuration(name="attacker", client="attacker", options={"script": script})
    return run_attempt(case, agent_folder, configuration, 1, folder, [pack], None), folder


ENDINGS = {
    "threads": (
        "import threading\nthreading.stack_size(65536)\nwhile True: threading.Thread(target=threading.Event()"
        ".wait, daemon=True).start()",
        "threads",
    ),
    "crash": ("import ctypes\nctypes.string_at(1)", "SIGSEGV"),
    "nonsense": (
        "import os, stat\nfor n in range(3, 1024):\n try:\n  if stat.S_ISSOCK(os.fstat(n).st_mode): "
        "os.write(n, b'\\xff' * 64)\n except OSError: pass\nwhile True: pass",
        "a message of",
    ),
}


@pytest.mark.parametrize("ending", ENDINGS)
def test_what_ends_the_engine_is_the_agents_failure(
    tmp_path: Path, pack: Path, monkeypatch: pytest.MonkeyPatch, ending: str
) -> None:
    script, reason = ENDINGS[ending]
    outcome, _ = attacked(tmp_path, pack, monkeypatch, script)
    assert outcome.ended_by == "agent_error" and reason in outcome.message
    assert outcome.submission == "/Game/SavedScenes/early", "what was saved before counts"


def test_what_is_refused_is_a_failed_call_in_the_record(
    tmp_path: Path, pack: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    outcome, folder = attacked(tmp_path, pack, monkeypatch, "import socket\nsocket.socket()")
    last = json.loads((folder / "trajectory.jsonl").read_text().splitlines()[-1])
    assert outcome.ended_by == "finished" and outcome.submission == "/Game/SavedScenes/early"
    assert "PermissionError" in last["result"] and json.loads(last["result"])["result"]["status"] == "error"


@pytest.mark.parametrize(
    ("script", "reason"),
    [
        ("import os\nos.chdir(CONTENT)\nfor _ in range(60): os.mkdir('d'); os.chdir('d')", "nested"),
        ("import os\nopen(os.path.join(CONTENT.encode(), b'\\xff\\n.level.json'), 'w')", "is no text"),
    ],
)
def test_what_cannot_be_read_is_no_submission(
    tmp_path: Path, pack: Path, monkeypatch: pytest.MonkeyPatch, script: str, reason: str
) -> None:
    where = f"CONTENT = {str(tmp_path / 'attempt-1' / 'submission')!r}\n"
    outcome, _ = attacked(tmp_path, pack, monkeypatch, where + script)
    assert (outcome.ended_by, outcome.submission) == ("agent_error", None) and reason in outcome.message


@pytest.mark.parametrize(
    "script",
    [
        "open(LEVEL, 'w').write('[' * 100000)",
        "open(LEVEL, 'wb').truncate(100 << 20)",
        "import json\nd = json.load(open(LEVEL))\nd['actors'][0]['parent'] = d['actors'][1]['name']\n"
        "d['actors'][1]['parent'] = d['actors'][0]['name']\njson.dump(d, open(LEVEL, 'w'))",
    ],
)
def test_a_level_that_breaks_its_reader_is_an_invalid_submission(
    tmp_path: Path, pack: Path, monkeypatch: pytest.MonkeyPatch, script: str
) -> None:
    level = tmp_path / "attempt-1" / "submission" / "Game" / "SavedScenes" / "early.level.json"
    outcome, folder = attacked(tmp_path, pack, monkeypatch, f"LEVEL = {str(level)!r}\n{script}")
    assert outcome.ended_by == "finished" and outcome.submission is not None
    with pytest.raises(BadInput):
        export_and_look(
            engine="headless",
            packs=[pack],
            submission_content=folder / "submission",
            package=outcome.submission,
            out=tmp_path / "evidence",
        )
