"""The state of one run behind its tools: the case, its catalog, the engine, and what the run has made so far."""

from __future__ import annotations

import time
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from c4s.engine import Calls, EngineCallError
from c4s.records.suite import AgentCase
from c4s.toolbox.catalog import CaseCatalog
from c4s.toolbox.measured import MeasuredScene
from c4s.toolbox.refusal import ToolRefused

ENGINE_TIMEOUT_S = 60.0
BUSY_WAIT_S = 30.0
"""How long a tool that needs the scene waits for a running job before it refuses (seconds)."""
JOB_LIMIT_S = 300.0
"""Longest run of one script (seconds); the kin's editor call limit."""
REFUSAL = "c4s.editor.scene_tools.SceneRefused: "


@dataclass
class ScriptJob:
    """A script that was given to the editor. ``started`` is a ``time.monotonic()`` value."""

    id: str
    started: float
    finished: bool = False

    @property
    def log_path(self) -> str:
        """The name that the agent is given for the job's log."""
        return f"jobs/{self.id}.log"


class Workbench:
    """What the tools of one run share. Engine calls are serial in the engine itself."""

    def __init__(self, case: AgentCase, agent_folder: Path, catalog: CaseCatalog, engine: Calls, scratch: Path) -> None:
        self.case, self.agent_folder, self.catalog, self.engine, self.scratch = (
            case,
            agent_folder,
            catalog,
            engine,
            scratch,
        )
        self.solved: dict[str, Any] | None = None
        """The last solution of the planner."""
        self.jobs: dict[str, ScriptJob] = {}
        self.levels: set[str] = {case.start_map}
        """Packages of the start level and of the levels that this run has saved."""
        self._pictures = 0
        self.ran_script = False
        """Whether agent code has run inside the engine."""
        self._measured: tuple[int | None, MeasuredScene] | None = None
        """The last measured scene, and which state of the level it was."""
        self.given: list[str] = list(engine.call("scene_tools.actor_ids"))
        """Ids of the actors that the start level had: everything else was spawned by the run."""

    def next_picture(self) -> int:
        """A number for a picture without a name."""
        self._pictures += 1
        return self._pictures

    def scene(self, function: str, **params: Any) -> Any:
        """Call a function of ``c4s.editor.scene_tools``; what it raises becomes a refusal with its message."""
        return self._call(f"scene_tools.{function}", **params)

    def measured(self) -> MeasuredScene:
        """The scene as it is now. The same object while the engine knows that nothing has changed."""
        known = self._measured
        told = self._call("snapshot.export_if_changed", known=known[0] if known is not None else None)
        if told["snapshot"] is None and known is not None:
            return known[1]
        self._measured = told["revision"], MeasuredScene(self.case.setting, told["snapshot"])
        return self._measured[1]

    def _call(self, function: str, **params: Any) -> Any:
        self.wait_for_editor()
        try:
            return self.engine.call(function, **params)
        except EngineCallError as error:
            raise ToolRefused(error.what.removeprefix(f"{error.kind}: ").removeprefix(REFUSAL)) from error

    def wait_for_editor(self) -> None:
        """Wait for the last job. Refused while it runs on: the editor does one thing at a time."""
        for job in list(self.jobs.values())[-1:]:
            if not job.finished and self.read_job(job, wait_s=BUSY_WAIT_S)["status"] == "running":
                raise ToolRefused(f"the editor is still busy with {job.id}", todo="wait for it with read_job_log")

    def start_job(self, script: str, *, wait_s: float) -> ScriptJob:
        """Run a script in the editor's Python; it goes on in the background after ``wait_s``."""
        self.ran_script = True
        reply = self.engine.request(
            "execute_python_script", {"script": script, "wait_s": wait_s}, timeout_s=wait_s + ENGINE_TIMEOUT_S
        )
        if "job_id" not in reply:
            raise ToolRefused(str(reply.get("error", "the editor did not take the script")))
        job = ScriptJob(str(reply["job_id"]), time.monotonic())
        self.jobs[job.id] = job
        job.finished = reply["status"] != "running"
        return job

    def read_job(self, job: ScriptJob, *, wait_s: float = 0.0, offset: int = 0) -> dict[str, Any]:
        """The state of a job. One that runs longer than ``JOB_LIMIT_S`` is abandoned."""
        reply = self.engine.request(
            "read_job_log", {"job_id": job.id, "wait_s": wait_s, "offset": offset}, timeout_s=wait_s + ENGINE_TIMEOUT_S
        )
        job.finished = reply["status"] != "running"
        if not job.finished and time.monotonic() - job.started > JOB_LIMIT_S:
            self.engine.request("abandon_job", {"job_id": job.id})
        return reply
