"""Attempts of the baselines on a real engine: what is saved, what is recorded, what cannot be done."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from made_case import make_case, mesh_actor

from c4s.agents import base
from c4s.agents.base import AgentContext, AgentReport
from c4s.engine.confine.sandbox import backend
from c4s.errors import AgentFault, BadInput
from c4s.files import json_lines
from c4s.records.attempt import AttemptOutcome
from c4s.records.level import Level
from c4s.records.plan import Configuration
from c4s.run.attempt import last_saved, run_attempt


def attempt(
    tmp_path: Path,
    pack: Path,
    client: str,
    *,
    withheld: Path | None = None,
    options: dict | None = None,
    number: int = 1,
    **case_options: Any,
) -> tuple[AttemptOutcome, Path]:
    case, agent_folder = make_case(tmp_path / "suite", pack, **case_options)
    folder = tmp_path / "run" / f"attempt-{number}"
    return run_attempt(
        case,
        agent_folder,
        Configuration(name=client, client=client, options=options or {}),
        number,
        folder,
        [pack],
        withheld,
    ), folder


def saved_labels(folder: Path, outcome: AttemptOutcome) -> list[str]:
    assert outcome.submission is not None
    level = Level.read(folder / "submission" / f"{outcome.submission[1:]}.level.json")
    return [actor.label for actor in level.actors]


def use(monkeypatch: pytest.MonkeyPatch, agent: type) -> None:
    """Make an agent class of this file known as the client ``local``."""
    monkeypatch.setitem(base.CLIENTS, "local", f"{agent.__module__}:{agent.__name__}")


def test_noop_saves_the_start_scene_and_is_not_run_twice(tmp_path: Path, pack: Path) -> None:
    outcome, folder = attempt(tmp_path, pack, "noop")
    assert outcome.ended_by == "finished" and outcome.submission == "/Game/SavedScenes/submission"
    assert saved_labels(folder, outcome) == ["Floor", "Table", "Box", "Sofa", "Twin", "Twin"]
    assert outcome.tool_calls == 1 and len(outcome.submission_sha256 or "") == 64
    manifest = json.loads((folder / "manifest.json").read_text())
    assert "test-pack" in manifest["packs"]
    assert manifest["engine"] == "headless" and manifest["engine_version"]
    assert manifest["sandbox"] == AttemptOutcome.read(folder / "outcome.json").sandbox == backend()
    assert manifest["client_sandbox"] == ""
    before = (folder / "outcome.json").stat().st_mtime_ns
    assert attempt(tmp_path, pack, "noop")[0] == outcome
    assert (folder / "outcome.json").stat().st_mtime_ns == before


def test_the_remains_of_a_cut_off_attempt_are_kept(tmp_path: Path, pack: Path) -> None:
    (tmp_path / "run/attempt-1").mkdir(parents=True)
    (tmp_path / "run/attempt-1/trajectory.jsonl").write_text("{}\n")
    outcome, folder = attempt(tmp_path, pack, "noop", setting="text-to-scene")
    assert saved_labels(folder, outcome) == []
    assert (tmp_path / "run/attempt-1.interrupted-1/trajectory.jsonl").read_text() == "{}\n"


def test_vandal_leaves_nothing(tmp_path: Path, pack: Path) -> None:
    outcome, folder = attempt(tmp_path, pack, "vandal")
    assert saved_labels(folder, outcome) == []


@pytest.mark.parametrize("setting", ["text-to-scene", "image-to-scene/indoor"])
def test_random_is_repeatable(tmp_path: Path, pack: Path, setting: str) -> None:
    levels = []
    for place in ("a", "b"):
        outcome, folder = attempt(tmp_path / place, pack, "random", setting=setting, options={"count": 5})
        level = Level.read(folder / "submission" / f"{(outcome.submission or '')[1:]}.level.json")
        levels.append([(actor.label, actor.transform) for actor in level.actors])
    assert levels[0] == levels[1]
    assert len(levels[0]) == 5 if setting == "text-to-scene" else levels[0]


def test_oracle_submits_the_truth_and_nobody_else_gets_it(tmp_path: Path, pack: Path) -> None:
    withheld = tmp_path / "suite/withheld/room"
    truth = Level(
        package="/Game/Test/Maps/Room",
        actors=[mesh_actor(1, "Floor", "floor_tile", (0, 0, -10)), mesh_actor(9, "Lost", "sofa", (0, 120, 0))],
    )
    truth.write(withheld / "truth.level.json")
    outcome, folder = attempt(tmp_path, pack, "oracle", withheld=withheld)
    assert outcome.ended_by == "finished" and saved_labels(folder, outcome) == ["Floor", "Lost"]
    with pytest.raises(BadInput, match="only for it"):
        attempt(tmp_path / "other", pack, "noop", withheld=withheld)
    with pytest.raises(BadInput, match="oracle"):
        attempt(tmp_path / "other", pack, "oracle")


class Greedy:
    def run(self, context: AgentContext) -> AgentReport:
        with context.connect() as tools:
            tools.call("save_scene_as", name="early")
            while True:
                tools.call("get_categories")


class Breaks:
    def run(self, context: AgentContext) -> AgentReport:
        raise AgentFault("no idea")


class Kills:
    def run(self, context: AgentContext) -> AgentReport:
        with context.connect() as tools:
            tools.call("save_scene_as", name="early")
            tools.call("execute_python_script", script="import os\nos._exit(3)", execution_mode="sync")
        return AgentReport()


class Sleeps:
    def run(self, context: AgentContext) -> AgentReport:
        with context.connect() as tools:
            tools.call("execute_python_script", script="import time\ntime.sleep(3600)", execution_mode="sync")
        return AgentReport()


def test_a_spent_call_budget_keeps_what_was_saved(tmp_path: Path, pack: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    use(monkeypatch, Greedy)
    outcome, folder = attempt(tmp_path, pack, "local", calls=4)
    assert (outcome.ended_by, outcome.tool_calls, outcome.submission) == ("call_budget", 4, "/Game/SavedScenes/early")
    with (folder / "trajectory.jsonl").open() as lines:
        assert [line["event"] for line in json_lines(lines)] == ["started", "call"] * 4 + ["refused"]


def test_the_wall_budget_ends_an_attempt(tmp_path: Path, pack: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    use(monkeypatch, Sleeps)
    outcome, _ = attempt(tmp_path, pack, "local", minutes=1 / 30)
    assert (outcome.ended_by, outcome.submission) == ("wall_budget", None)


def test_an_agent_that_fails_is_an_outcome(tmp_path: Path, pack: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    use(monkeypatch, Breaks)
    outcome, _ = attempt(tmp_path, pack, "local")
    assert (outcome.ended_by, outcome.message, outcome.submission) == ("agent_error", "no idea", None)


def test_agent_code_that_kills_the_engine_is_the_agents_doing(
    tmp_path: Path, pack: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    use(monkeypatch, Kills)
    outcome, _ = attempt(tmp_path, pack, "local")
    assert outcome.ended_by == "agent_error" and "broke the engine" in outcome.message
    assert outcome.submission == "/Game/SavedScenes/early"


def test_a_forged_list_of_saves_names_no_submission(tmp_path: Path) -> None:
    level = tmp_path / "Game/SavedScenes/real.level.json"
    level.parent.mkdir(parents=True)
    level.write_text("{}")
    (tmp_path.parent / "outside.level.json").write_text("{}")
    (tmp_path / "Game/SavedScenes/linked.level.json").symlink_to(tmp_path.parent / "outside.level.json")
    saves = tmp_path / "saves.jsonl"
    saves.write_text(
        '{"package": "/Game/SavedScenes/real"}\n{"package": "/Game/../../outside"}\nnonsense\n'
        '{"package": "/Game/SavedScenes/linked"}\n{"package": "/Game/SavedScenes/missing"}\n[]\n'
    )
    assert last_saved(tmp_path, ".level.json") == "/Game/SavedScenes/real"
    saves.unlink()
    assert last_saved(tmp_path, ".level.json") is None
    saves.symlink_to(level)
    assert last_saved(tmp_path, ".level.json") is None
