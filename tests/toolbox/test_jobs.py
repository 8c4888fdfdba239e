"""Jobs of a run: limits that hold for each of them, the list, the queue, and how one is ended."""

from __future__ import annotations

import functools
import json
import re
from collections.abc import Callable
from pathlib import Path

import pytest
from made_case import make_case

from c4s.agents import base
from c4s.agents.base import AgentContext, AgentReport
from c4s.engine import open_engine
from c4s.engine.faults import EngineOverLimit
from c4s.records.plan import Configuration
from c4s.run.attempt import run_attempt
from c4s.toolbox.catalog import CaseCatalog
from c4s.toolbox.client import CallRefused, GatewayClient, RunStopped
from c4s.toolbox.gateway import Gateway
from c4s.toolbox.gateway_run import Run
from c4s.toolbox.workbench import MOST_QUEUED, JobLimits, Workbench

SHORT = JobLimits(script_s=3.0, tool_s=20.0, busy_wait_s=0.2)
LOOP = "while True: pass"
ENDLESS = {
    "a loop": LOOP,
    "a sleep": "import time\ntime.sleep(1e6)",
    "a loop that catches everything": "while True:\n try:\n  while True: pass\n except BaseException: pass",
    "a sleep on the way out": "import time\ntry:\n while True: pass\nfinally:\n time.sleep(1e6)",
    "a lock": "import threading\nlock = threading.Lock()\nlock.acquire()\nlock.acquire()",
    "a thread that is waited for": "import threading\nstop = threading.Event()\ndef spin():\n"
    " while not stop.is_set(): pass\nthread = threading.Thread(target=spin)\nthread.start()\nthread.join()",
}
LET_GO = "stop = globals().get('stop')\nif stop: stop.set()"
"""Ends what a script left behind: the engine is the next tests' too."""


@pytest.mark.parametrize("script", ENDLESS)
def test_an_endless_script_ends_at_its_limit_and_the_next_one_runs(open_run: Callable, script: str) -> None:
    client = open_run(limits=SHORT).client
    first = client.call("execute_python_script", script=ENDLESS[script]).data
    second = client.call("execute_python_script", script="print('next')").data
    assert second["status"] == "queued" and second["behind"] == [first["job_id"]]
    ended = client.call("read_job_log", job_id=first["job_id"], wait_s=60).data
    assert ended["status"] == "error" and "ran longer than 3 s" in ended["error"]
    assert client.call("read_job_log", wait_s=60).data["output"] == "next"
    assert client.call("get_actors_in_level").data["total"] == 6
    assert client.call("execute_python_script", script=LET_GO, execution_mode="sync").data["status"] == "done"


def test_a_thread_that_stays_behind_does_not_stop_the_tools(open_run: Callable) -> None:
    client = open_run(limits=SHORT).client
    script = (
        "import threading\nstop = threading.Event()\ndef spin():\n while not stop.is_set(): pass\n"
        "threading.Thread(target=spin).start()"
    )
    assert client.call("execute_python_script", script=script, execution_mode="sync").data["status"] == "done"
    assert client.call("get_actors_in_level").data["total"] == 6
    assert client.call("execute_python_script", script="stop.set()", execution_mode="sync").data["status"] == "done"


def test_jobs_are_listed_and_cancelled(open_run: Callable) -> None:
    client = open_run(limits=JobLimits(busy_wait_s=0.2)).client
    first, second, third = (
        client.call("execute_python_script", script=script).data["job_id"] for script in (LOOP, LOOP, "print('third')")
    )
    listed = client.call("read_job_log", action="list").data
    assert listed["running_or_queued"] == 3 and listed["jobs"][1:] == [
        {"job_id": second, "status": "queued"},
        {"job_id": third, "status": "queued"},
    ]
    with pytest.raises(CallRefused, match=rf"still busy: {first} .*action='cancel'"):
        client.call("get_actors_in_level")
    assert client.call("read_job_log", job_id=second, action="cancel").data["error"] == "abandoned"
    assert client.call("read_job_log", job_id=first, action="cancel", wait_s=60).data["status"] == "error"
    assert client.call("read_job_log", job_id=third, wait_s=60).data["output"] == "third"
    assert client.call("read_job_log", job_id=third, action="cancel").data["status"] == "done"
    listed = client.call("read_job_log", action="list").data
    assert [row["status"] for row in listed["jobs"]] == ["done", "error", "error"]
    assert client.call("get_actors_in_level").data["total"] == 6
    with pytest.raises(CallRefused, match=rf"no job 'job-x' in this run \(the last ones are .*{third}"):
        client.call("read_job_log", job_id="job-x", action="cancel")


def test_a_run_has_so_many_jobs_at_a_time(open_run: Callable) -> None:
    client = open_run().client
    jobs = [client.call("execute_python_script", script=LOOP).data["job_id"] for _ in range(MOST_QUEUED)]
    with pytest.raises(CallRefused, match="8 scripts are running or queued"):
        client.call("execute_python_script", script="1")
    for job in reversed(jobs):
        client.call("read_job_log", job_id=job, action="cancel", wait_s=60)
    assert client.call("execute_python_script", script="print(1)", execution_mode="sync").data["output"] == "1"


class Wedger:
    """Saves the scene, runs the script of its configuration and another one, and looks at the level."""

    def run(self, context: AgentContext) -> AgentReport:
        with context.connect() as tools:
            tools.call("save_scene_as", name="early")
            for script in (context.configuration.options["script"], LOOP):
                tools.call("execute_python_script", script=script)
            for _ in range(20):
                try:
                    tools.call("read_job_log", action="list")
                    tools.call("get_actors_in_level")
                except (CallRefused, RunStopped):
                    continue
        return AgentReport()


WEDGES = {
    "a loop": (LOOP, "finished", ""),
    "a loop inside C": ("sum(range(10 ** 12))", "agent_error", "could not be ended"),
    "a tool that never ends": (
        "from c4s.editor import scene_tools\nscene_tools.list_actors = lambda **k: sum(range(10 ** 12))",
        "agent_error",
        "no result in|could not be ended",
    ),
}


@pytest.mark.parametrize("wedge", WEDGES)
def test_what_an_endless_script_causes_is_the_agents_outcome(
    tmp_path: Path, pack: Path, monkeypatch: pytest.MonkeyPatch, wedge: str
) -> None:
    script, ended_by, reason = WEDGES[wedge]
    monkeypatch.setitem(base.CLIENTS, "wedger", f"{__name__}:Wedger")
    limits = JobLimits(script_s=1.0, tool_s=1.0, busy_wait_s=5.0)
    monkeypatch.setattr("c4s.run.attempt.Workbench", functools.partial(Workbench, limits=limits))
    case, agent_folder = make_case(tmp_path / "suite", pack)
    configuration = Configuration(name="wedger", client="wedger", options={"script": script})
    outcome = run_attempt(case, agent_folder, configuration, 1, tmp_path / "attempt-1", [pack], None)
    assert outcome.submission == "/Game/SavedScenes/early"
    assert outcome.ended_by == ended_by and re.search(reason, outcome.message), outcome.message


def test_a_limit_that_ends_the_engine_is_told_to_the_agent(tmp_path: Path, pack: Path) -> None:
    case, agent_folder = make_case(tmp_path / "own", pack)
    with (
        open_engine(
            "headless",
            packs=[pack],
            content=tmp_path / "content",
            scratch=tmp_path / "scratch",
            levels=[agent_folder / "start.level.json"],
            start_map=case.start_map,
        ) as engine,
        Gateway() as gateway,
    ):
        bench = Workbench(case, agent_folder, CaseCatalog.load(case, [pack]), engine, tmp_path / "scratch", SHORT)
        run = Run("own", bench, case.budget, tmp_path / "trajectory.jsonl")
        with GatewayClient(gateway.open_run(run)) as client:
            client.call("execute_python_script", script="sum(range(10 ** 12))")
            answer = client.answer("read_job_log", {"wait_s": 60})
            assert answer.is_error and "ran longer than 3 s and could not be ended" in answer.content[0].text
            with pytest.raises(RunStopped):
                client.call("get_categories")
        assert isinstance(run.fault, EngineOverLimit) and run.end_reason == "fault"
        assert json.loads((tmp_path / "trajectory.jsonl").read_text().splitlines()[-1])["event"] == "refused"
