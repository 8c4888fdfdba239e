"""An attempt whose process is killed while a tool works: what is on record, and what comes after."""

from __future__ import annotations

import multiprocessing
from pathlib import Path
from typing import Any

from made_case import make_case

from c4s.agents import base
from c4s.agents.base import AgentContext, AgentReport
from c4s.agents.replay import recorded_calls
from c4s.files import read_json
from c4s.records.plan import Configuration
from c4s.run.attempt import run_attempt
from c4s.trajectory import analyse

ENDLESS = "import time\ntime.sleep(600)"


class Waits:
    """Looks, then starts a script that does not end."""

    def run(self, context: AgentContext) -> AgentReport:
        with context.connect() as tools:
            tools.call("get_categories")
            tools.call("execute_python_script", script=ENDLESS, execution_mode="sync")
        return AgentReport()


def _attempt(client: str, suite: Path, pack: Path, folder: Path) -> Any:
    base.CLIENTS["waits"] = f"{__name__}:Waits"
    case, agent_folder = make_case(suite, pack)
    return run_attempt(case, agent_folder, Configuration(name="local", client=client), 1, folder, [pack], None)


def test_a_killed_process_leaves_an_unfinished_call_and_is_run_again(tmp_path: Path, pack: Path) -> None:
    folder, trajectory = tmp_path / "attempt-1", tmp_path / "attempt-1/trajectory.jsonl"
    child = multiprocessing.get_context("spawn").Process(target=_attempt, args=("waits", tmp_path, pack, folder))
    child.start()
    while child.is_alive() and not (trajectory.is_file() and trajectory.read_text().count("started") == 2):
        child.join(0.05)
    child.kill()
    child.join()
    found = analyse(trajectory)
    assert (found.calls, found.unfinished, found.python) == (2, 1, 1)
    assert [tool for tool, _, _ in recorded_calls(trajectory)] == ["get_categories"]
    assert not (folder / "outcome.json").exists()
    assert _attempt("noop", tmp_path, pack, folder).ended_by == "finished"
    assert analyse(tmp_path / "attempt-1.interrupted-1/trajectory.jsonl") == found
    assert read_json(folder / "outcome.json")["tool_calls"] == 1
