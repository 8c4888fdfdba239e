"""A recorded trajectory played again gives the same submission, byte by byte."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from made_case import make_case

from c4s.agents import base
from c4s.agents.base import AgentContext, AgentReport
from c4s.errors import BadInput
from c4s.records.attempt import AttemptOutcome
from c4s.records.plan import Configuration
from c4s.run.attempt import run_attempt
from c4s.toolbox.client import CallRefused

SCRIPT = """
import random
import unreal
actors = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)
mesh = unreal.load_asset("/Game/Test/SM_crate")
for n in range(5):
    placed = actors.spawn_actor_from_object(mesh, unreal.Vector(random.uniform(0, 400), 100 * n, 0))
    placed.set_actor_label(f"Crate {n}")
for label in {"Twin", "Sofa", "Box"}:
    print(label)
"""


class Builder:
    """Uses tools that succeed, tools that fail, and Python that draws lots."""

    def run(self, context: AgentContext) -> AgentReport:
        with context.connect() as tools:
            tools.call("spawn_actor", name="A", static_mesh="/Game/Test/SM_crate", location=[0, 0, 0])
            with pytest.raises(CallRefused):
                tools.call("delete_actor", name="nobody")
            job = tools.call("execute_python_script", script=SCRIPT).data["job_id"]
            tools.call("read_job_log", job_id=job, wait_s=30)
            tools.call("take_screenshot")
            tools.call("save_scene_as", name="mine")
        return AgentReport()


def _attempt(folder: Path, case: Any, agent_folder: Path, pack: Path, client: str, **options: Any) -> AttemptOutcome:
    return run_attempt(
        case, agent_folder, Configuration(name=client, client=client, options=options), 1, folder, [pack], None
    )


def test_a_replay_saves_the_same_bytes(tmp_path: Path, pack: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(base.CLIENTS, "local", f"{__name__}:Builder")
    case, agent_folder = make_case(tmp_path / "suite", pack)
    first = _attempt(tmp_path / "first", case, agent_folder, pack, "local")
    assert first.submission == "/Game/SavedScenes/mine" and first.tool_calls == 6
    trajectory = tmp_path / "first" / "trajectory.jsonl"
    again = _attempt(tmp_path / "again", case, agent_folder, pack, "replay", trajectory=str(trajectory))
    assert again.submission == first.submission and again.submission_sha256 == first.submission_sha256
    assert (again.tool_calls, again.message) == (6, "6 calls")
    pictures = [
        image["sha256"]
        for line in trajectory.read_text().split("\n")
        if line
        for image in json.loads(line).get("images") or []
    ]
    assert len(pictures) == 1
    for run in ("first", "again"):
        assert (tmp_path / run / "images" / f"{pictures[0]}.png").is_file()


def test_a_replay_tells_what_was_answered_otherwise(tmp_path: Path, pack: Path) -> None:
    case, agent_folder = make_case(tmp_path / "suite", pack)
    lines = [
        {
            "event": "call",
            "counted": True,
            "call": 2,
            "tool": "delete_actor",
            "arguments": {"name": "nobody"},
            "outcome": "ok",
        },
        {"event": "refused", "counted": False, "tool": "spawn_actor", "arguments": {}, "outcome": "refused"},
        {
            "event": "call",
            "counted": True,
            "call": 1,
            "tool": "save_scene_as",
            "arguments": {"name": "x"},
            "outcome": "ok",
        },
        {
            "event": "call",
            "counted": True,
            "call": 3,
            "tool": "save_scene_as",
            "arguments": {"name": "y"},
            "outcome": "ended",
        },
    ]
    trajectory = tmp_path / "t.jsonl"
    trajectory.write_text("".join(json.dumps(line) + "\n" for line in lines))
    outcome = _attempt(tmp_path / "again", case, agent_folder, pack, "replay", trajectory=str(trajectory))
    assert outcome.message == "2 calls; answered otherwise: call 2 (delete_actor)"
    assert outcome.submission == "/Game/SavedScenes/x"


@pytest.mark.parametrize("options", [{}, {"trajectory": "absent.jsonl"}])
def test_a_replay_without_a_trajectory_is_bad_input(tmp_path: Path, pack: Path, options: dict[str, str]) -> None:
    case, agent_folder = make_case(tmp_path / "suite", pack)
    with pytest.raises(BadInput):
        _attempt(tmp_path / "again", case, agent_folder, pack, "replay", **options)
