"""The state of one run behind its tools: the case, its catalog, the engine, and what the run has made so far."""

from __future__ import annotations

import errno
import threading
import time
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

from c4s.engine import Calls, EngineCallError
from c4s.engine.answers import JobReply, WrongAnswer, ask, ask_job
from c4s.files import check_disk
from c4s.protocol.settings import is_construction
from c4s.records.snapshot_faults import export_fault
from c4s.records.suite import AgentCase
from c4s.toolbox.catalog import CaseCatalog
from c4s.toolbox.measured import MeasuredScene
from c4s.toolbox.refusal import ToolRefused

ENGINE_TIMEOUT_S = 60.0
MOST_QUEUED = 8
"""Scripts that may run or wait at a time."""
JOBS_LISTED = 20


READING = frozenset({"actor_ids", "current_level", "find_actors", "inspect_environment", "list_actors"})
"""Functions of ``c4s.editor.scene_tools`` that change nothing."""


@dataclass(frozen=True)
class JobLimits:
    """How long the jobs of a run may take (seconds, once they have begun), and how long others wait for them."""

    script_s: float = 300.0
    """One script: the kin's editor call limit."""
    tool_s: float = 300.0
    """One tool's work in the editor."""
    busy_wait_s: float = 30.0
    """How long a tool that needs the scene waits for running scripts before it refuses."""


JobState = Literal["queued", "running", "done", "error"]
FULL = f"[Errno {errno.ENOSPC}]"
REFUSAL = "c4s.editor.conversions.SceneRefused: "


@dataclass
class ScriptJob:
    """A script that was given to the editor."""

    id: str
    state: JobState = "queued"

    @property
    def finished(self) -> bool:
        """Whether it has ended, well or not."""
        return self.state in ("done", "error")

    @property
    def log_path(self) -> str:
        """The name that the agent is given for the job's log."""
        return f"jobs/{self.id}.log"


class Workbench:
    """What the tools of one run share. Engine calls are serial in the engine itself."""

    def __init__(
        self,
        case: AgentCase,
        agent_folder: Path,
        catalog: CaseCatalog,
        engine: Calls,
        scratch: Path,
        limits: JobLimits | None = None,
    ) -> None:
        self.case, self.agent_folder, self.catalog, self.engine, self.scratch = (
            case,
            agent_folder,
            catalog,
            engine,
            scratch,
        )
        self.limits = limits or JobLimits()
        self.solved: dict[str, Any] | None = None
        """The last solution of the planner."""
        self.jobs: dict[str, ScriptJob] = {}
        self.levels: set[str] = {case.start_map}
        """Packages of the start level and of the levels that this run has saved."""
        self._pictures = 0
        self.ran_script = False
        """Whether agent code has run inside the engine."""
        self._start: MeasuredScene | None = None
        self._starting = threading.Lock()
        self._measured: tuple[int | None, MeasuredScene] | None = None
        """The last measured scene, and which state of the level it was."""
        self.given: list[str] = ask(engine, "scene_tools.actor_ids")
        """Ids of the actors that the start level had: everything else was spawned by the run."""

    def next_picture(self) -> int:
        """A number for a picture without a name."""
        self._pictures += 1
        return self._pictures

    def scene(self, function: str, **params: Any) -> Any:
        """Call a function of ``c4s.editor.scene_tools``; what it raises becomes a refusal with its message."""
        if function not in READING:
            self._kept_start()
        return self._call(f"scene_tools.{function}", **params)

    def measured(self) -> MeasuredScene:
        """The scene as it is now. The same object while the engine knows that nothing has changed."""
        self._kept_start()
        known = self._measured
        told = self._call("snapshot.export_if_changed", known=known[0] if known is not None else None)
        if told["snapshot"] is None:
            if known is None:
                raise WrongAnswer("no snapshot", where="snapshot.export_if_changed")
            return known[1]
        if self.ran_script and (fault := export_fault(told["snapshot"])):
            raise ToolRefused(f"the scene cannot be measured: {fault}", todo="mend those actors")
        scene = MeasuredScene(self.case.setting, told["snapshot"], self._kept_start())
        self._measured = told["revision"], scene
        return scene

    def _kept_start(self) -> MeasuredScene | None:
        """The level as it was given, in a repair: exported before the first tool or script that may change it."""
        if is_construction(self.case.setting):
            return None
        with self._starting:
            if self._start is None:
                told = ask(self.engine, "snapshot.export_snapshot", timeout_s=self.limits.tool_s)
                self._start = MeasuredScene(self.case.setting, told)
            return self._start

    def _call(self, function: str, **params: Any) -> Any:
        self.wait_for_editor()
        try:
            return ask(self.engine, function, timeout_s=self.limits.tool_s, **params)
        except EngineCallError as error:
            self.blame_disk(error.detail)
            raise ToolRefused(error.what.removeprefix(f"{error.kind}: ").removeprefix(REFUSAL)) from error

    def unfinished(self) -> list[ScriptJob]:
        """The scripts that run or wait, as it is now."""
        for job in self.jobs.values():
            if not job.finished:
                self.read_job(job)
        return [job for job in self.jobs.values() if not job.finished]

    def wait_for_editor(self) -> None:
        """Wait for the scripts. Refused while one runs on: the editor does one thing at a time."""
        until = time.monotonic() + self.limits.busy_wait_s
        for job in [job for job in self.jobs.values() if not job.finished]:
            if self.read_job(job, wait_s=max(0.0, until - time.monotonic())).running:
                raise ToolRefused(
                    f"the editor is still busy: {job.id} is {job.state}",
                    todo=f"wait for it with read_job_log(wait_s=...), or end it with read_job_log(job_id={job.id!r}, "
                    "action='cancel')",
                )

    def start_job(self, script: str, *, wait_s: float) -> ScriptJob:
        """Run a script in the editor's Python; it goes on in the background after ``wait_s``."""
        waiting = self.unfinished()
        if len(waiting) >= MOST_QUEUED:
            raise ToolRefused(
                f"{len(waiting)} scripts are running or queued", todo="wait for them, or cancel them with read_job_log"
            )
        self._kept_start()
        self.ran_script = True
        reply = ask_job(
            self.engine,
            "execute_python_script",
            {"script": script, "wait_s": wait_s, "limit_s": self.limits.script_s, "max_bytes": 0},
            timeout_s=wait_s + ENGINE_TIMEOUT_S,
        )
        if isinstance(reply, str):
            raise ToolRefused(reply)
        job = ScriptJob(reply.job_id)
        self.jobs[job.id] = job
        _note(job, reply)
        return job

    def read_job(
        self, job: ScriptJob, *, wait_s: float = 0.0, offset: int | None = None, max_bytes: int = 0
    ) -> JobReply:
        """The state of a job, with ``max_bytes`` of its output from ``offset`` on, else of its end."""
        asked = {"job_id": job.id, "wait_s": wait_s, "max_bytes": max_bytes}
        reply = ask_job(
            self.engine,
            "read_job_log",
            asked if offset is None else asked | {"offset": offset},
            timeout_s=wait_s + ENGINE_TIMEOUT_S,
        )
        if isinstance(reply, str):
            raise ToolRefused(reply)
        _note(job, reply)
        if reply.failed:
            self.blame_disk(reply.error or "")
        return reply

    def cancel_job(self, job: ScriptJob) -> None:
        """Ask a job to end: at once when it waits, at its next Python instruction when it runs."""
        self.engine.request("abandon_job", {"job_id": job.id})

    def blame_disk(self, told: str) -> None:
        """``OSError`` where what the engine tells is that the disk is full, and it is: nobody's doing."""
        if FULL in told:
            check_disk(self.scratch)


def _note(job: ScriptJob, reply: JobReply) -> None:
    job.state = ("queued" if reply.queued else "running") if reply.running else "error" if reply.failed else "done"
