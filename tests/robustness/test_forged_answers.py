"""Agent code shares its process with the engine and may forge what that answers: an outcome, never a pending trial."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

import pytest

from c4s.agents import base
from c4s.agents.base import AgentContext, AgentReport
from c4s.records.attempt import AttemptOutcome
from c4s.records.plan import Configuration
from c4s.run.attempt import run_attempt
from c4s.toolbox.client import CallRefused

sys.path.insert(0, str(Path(__file__).parents[1] / "toolbox"))
from made_case import make_case, make_pack

LIST, SHOT, MEASURE = ("get_actors_in_level", {}), ("take_screenshot", {"filename": "a"}), ("measure_scene", {})
SPAWN = ("build_tier", {"entries": [{"name": "New", "asset": "/Engine/BasicShapes/Cube", "location": [0, 0, 0]}]})
FOUND, SAVE, SKY = (
    ("find_actors_by_name", {"pattern": "x"}),
    ("save_scene_as", {"name": "late"}),
    ("setup_environment", {}),
)
GONE = ("delete_all_spawned", {})
ANSWER = "from c4s.editor import scene_tools as s\n"
ACTOR = (
    "{'label': 'a', 'name': 'a', 'class': 'c', 'location': [0.0] * 3, 'rotation': [0.0] * 3, 'scale': [1.0] * 3, "
    "'static_meshes': []}"
)
RAW = (
    "from c4s.engine import channel\nreal = channel.send\n"
    "def send(connection, payload, descriptor=None):\n    real(connection, FORGE(payload), descriptor)\n"
    "channel.send = send\n"
)
"""Replaces what the engine sends to the host, byte by byte."""
PICTURE = (
    "from c4s.editor import capture as c\nimport os, zlib, struct\n"
    "def forge(shots, folder):\n    os.makedirs(folder, exist_ok=True)\n    path = os.path.join(folder, 'a.png')\n"
    "    {}\n    return {{'status': 'success', 'results': [{{'filepath': path, 'filename': 'a'}}], 'missing': []}}\n"
    "c.take_screenshots = forge"
)
BOMB = (
    "chunk = lambda kind, data: struct.pack('>I', len(data)) + kind + data + struct.pack('>I', zlib.crc32(kind + data))"
    "; open(path, 'wb').write(b'\\x89PNG\\r\\n\\x1a\\n' "
    "+ chunk(b'IHDR', struct.pack('>IIBBBBB', 60000, 60000, 8, 0, 0, 0, 0)) "
    "+ chunk(b'IDAT', zlib.compress(bytes(3 << 20))) + os.urandom(3 << 20))"
)
AGENT, CALL = "agent_error", "finished"
FORGERIES: dict[str, tuple[str, tuple[str, dict[str, Any]], str]] = {
    "nothing": (ANSWER + "s.list_actors = lambda **k: None", LIST, AGENT),
    "an empty list": (ANSWER + "s.list_actors = lambda **k: []", LIST, AGENT),
    "a number": (ANSWER + "s.list_actors = lambda **k: 7", LIST, AGENT),
    "a missing key": (ANSWER + "s.list_actors = lambda **k: {'actors': []}", LIST, AGENT),
    "a key too many": (
        ANSWER + "s.list_actors = lambda **k: {'actors': [], 'total': 0, 'x': 'y' * (8 << 20)}",
        LIST,
        AGENT,
    ),
    "too many actors": (
        ANSWER + f"s.list_actors = lambda **k: {{'actors': [{ACTOR}] * 5000, 'total': 1}}",
        LIST,
        AGENT,
    ),
    "a negative count": (ANSWER + "s.list_actors = lambda **k: {'actors': [], 'total': -1}", LIST, AGENT),
    "a count in words": (ANSWER + "s.list_actors = lambda **k: {'actors': [], 'total': '3'}", LIST, AGENT),
    "actors in words": (ANSWER + "s.find_actors = lambda **k: {'actors': 'none', 'total': 0}", FOUND, AGENT),
    "a number in words": (
        ANSWER + f"s.find_actors = lambda **k: {{'actors': [{ACTOR} | {{'scale': ['1', 1, 1]}}], 'total': 1}}",
        FOUND,
        AGENT,
    ),
    "not a number": (
        ANSWER + f"s.list_actors = lambda **k: {{'actors': [{ACTOR} | {{'scale': [float('nan')] * 3}}], 'total': 1}}",
        LIST,
        CALL,
    ),
    "a name that is no text": (
        ANSWER + "s.list_actors = lambda **k: {'actors': [], 'total': 0, '\\ud800': 1}",
        LIST,
        AGENT,
    ),
    "a label of 8 MB": (
        ANSWER + f"s.list_actors = lambda **k: {{'actors': [{ACTOR} | {{'label': 'x' * (8 << 20)}}], 'total': 1}}",
        LIST,
        AGENT,
    ),
    "spawned nothing": (ANSWER + "s.spawn_many = lambda **k: {'spawned': [{}], 'failed': 3}", SPAWN, AGENT),
    "saved elsewhere": (ANSWER + "s.save_scene = lambda **k: {'package': '../../etc', 'actors': 1}", SAVE, AGENT),
    "saved a list": (ANSWER + "s.save_scene = lambda **k: ['/Game/A']", SAVE, AGENT),
    "an environment of numbers": (
        ANSWER + "s.inspect_environment = lambda **k: {'stands': {}, 'missing': [1]}",
        SKY,
        AGENT,
    ),
    "a level without a name": (ANSWER + "s.current_level = lambda: None", GONE, AGENT),
    "deleted a number": (ANSWER + "s.delete_all_but = lambda **k: 3", GONE, AGENT),
    "no snapshot": (
        "from c4s.editor import snapshot as s\ns.export_if_changed = lambda **k: {'revision': None, 'snapshot': None}",
        MEASURE,
        AGENT,
    ),
    "a snapshot of nothing": (
        "from c4s.editor import snapshot as s\ns.export_if_changed = lambda **k: {'revision': 'x', 'snapshot': {}}",
        MEASURE,
        AGENT,
    ),
    "a snapshot of odd actors": (
        "from c4s.editor import snapshot as s\nreal = s.export_snapshot\n"
        "def odd():\n    told = real()\n    told['actors'][0]['c4s']['components'] = {'a': 1}\n    return told\n"
        "s.export_if_changed = lambda **k: {'revision': None, 'snapshot': odd()}",
        MEASURE,
        CALL,
    ),
    "a snapshot of odd bodies": (
        "from c4s.editor import snapshot as s\nreal = s.export_snapshot\n"
        "def odd():\n    told = real()\n    for mesh in told['c4s']['meshes'].values():\n"
        "        mesh['collision'] = [{'kind': 'box', 'center': [1e308] * 3}]\n    return told\n"
        "s.export_if_changed = lambda **k: {'revision': None, 'snapshot': odd()}",
        MEASURE,
        CALL,
    ),
    "bytes that are no text": (RAW.replace("FORGE(payload)", "payload.replace(b'actors', b'\\xff\\xfe')"), LIST, CALL),
    "half a message": (RAW.replace("FORGE(payload)", "payload[: len(payload) // 2]"), LIST, AGENT),
    "not JSON": (RAW.replace("FORGE(payload)", "b'[[[[' + payload"), LIST, AGENT),
    "a list for a message": (RAW.replace("FORGE(payload)", "b'[1]\\n' + payload"), LIST, AGENT),
    "a job of another": (
        RAW.replace("FORGE(payload)", "payload.replace(b'\"job\":', b'\"job\": 1') if b'job' in payload else payload"),
        LIST,
        "wall_budget",
    ),
    "a job that never ends": (
        ANSWER + "import time\ns.list_actors = lambda **k: time.sleep(3600)",
        LIST,
        "wall_budget",
    ),
    "a fault in lists": (
        RAW.replace(
            "FORGE(payload)",
            'b\'{"job": %d, "error": [1, {}], "fault": {}}\\n\' % '
            "__import__('json').loads(payload.partition(b'\\n')[0])['job']",
        ),
        LIST,
        AGENT,
    ),
    "a forged full disk": (
        ANSWER + "def f(**k): raise OSError(28, 'No space left on device')\ns.list_actors = f",
        LIST,
        CALL,
    ),
    "a picture elsewhere": (PICTURE.format("path = '/etc/passwd'"), SHOT, CALL),
    "a link for a picture": (
        PICTURE.format("os.rename(path, path) if os.path.exists(path) else None; path = folder + '/../../../agent'"),
        SHOT,
        CALL,
    ),
    "a folder for a picture": (PICTURE.format("os.makedirs(path, exist_ok=True)"), SHOT, CALL),
    "a picture that is none": (PICTURE.format("open(path, 'wb').write(b'GIF89a' * 99)"), SHOT, CALL),
    "a picture without end": (PICTURE.format(BOMB), SHOT, CALL),
    "a picture with a name of NUL": (PICTURE.format("path = 'a\\0b'"), SHOT, CALL),
    "a picture of numbers": (
        "from c4s.editor import capture as c\n"
        "c.take_screenshots = lambda shots, folder: {'status': 'success', 'results': [7], 'missing': []}",
        SHOT,
        CALL,
    ),
    "a status that nobody knows": (
        "from c4s.editor import capture as c\n"
        "c.take_screenshots = lambda shots, folder: {'status': 'soon', 'results': [], 'missing': []}",
        SHOT,
        CALL,
    ),
    "an exit": (ANSWER + "import os\ns.list_actors = lambda **k: os._exit(0)", LIST, AGENT),
    "a crash": (ANSWER + "import ctypes\ns.list_actors = lambda **k: ctypes.string_at(1)", LIST, AGENT),
    "a closed line": (
        ANSWER + "import os, socket, stat\ndef shut(**k):\n    for n in range(3, 1024):\n        try:\n"
        "            if stat.S_ISSOCK(os.fstat(n).st_mode): os.close(n)\n        except OSError: pass\n"
        "s.list_actors = shut",
        LIST,
        AGENT,
    ),
}
"""What a script does in the engine, the tool that asks next, and how the attempt ends."""


class Forger:
    """Saves the scene, runs the script of its configuration, then asks."""

    def run(self, context: AgentContext) -> AgentReport:
        options = context.configuration.options
        with context.connect() as tools:
            tools.call("save_scene_as", name="early")
            tools.call("execute_python_script", script=options["script"], execution_mode="sync")
            try:
                tools.call(options["tool"], **options["arguments"])
            except CallRefused:
                return AgentReport(message="refused")
        return AgentReport(message="answered")


@pytest.fixture(scope="module")
def pack(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The small pack of the toolbox tests."""
    folder: Path = make_pack(tmp_path_factory.mktemp("packs"))
    return folder


@pytest.mark.parametrize("forgery", FORGERIES)
def test_a_forged_answer_is_the_agents_doing(
    tmp_path: Path, pack: Path, monkeypatch: pytest.MonkeyPatch, forgery: str
) -> None:
    script, (tool, arguments), ended_by = FORGERIES[forgery]
    monkeypatch.setitem(base.CLIENTS, "forger", f"{__name__}:Forger")
    minutes = 5.0 if ended_by != "wall_budget" else 1 / 20
    case, agent_folder = make_case(tmp_path / "suite", pack, minutes=minutes)
    options = {"script": script, "tool": tool, "arguments": arguments}
    configuration = Configuration(name="forger", client="forger", options=options)
    outcome = run_attempt(case, agent_folder, configuration, 1, tmp_path / "attempt-1", [pack], None)
    assert isinstance(outcome, AttemptOutcome)
    assert outcome.ended_by == ended_by, outcome.message
    assert outcome.submission == "/Game/SavedScenes/early", "what was saved before counts"
