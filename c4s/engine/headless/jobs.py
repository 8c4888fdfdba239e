"""The engine's main thread as a queue of jobs: each runs there, one after the other, with its output kept whole."""

from __future__ import annotations

import ctypes
import io
import linecache
import queue
import sys
import threading
import traceback
from collections import OrderedDict
from collections.abc import Callable
from pathlib import Path
from typing import Any, BinaryIO, TextIO

KEPT_JOBS = 512
MAX_LOG_BYTES = 4 << 20
_TICK_S = 1 / 60
_OWN_FILES = frozenset({__file__, str(Path(__file__).with_name("server.py"))})


class JobAbandoned(BaseException):
    """Raised inside a job that the host has given up on."""


class JobLog:
    """The printed output of a job: a file, so that no line is lost however much is printed, or how the engine ends."""

    def __init__(self, path: Path) -> None:
        path.parent.mkdir(parents=True, exist_ok=True)
        self.path = path
        self._file: BinaryIO | None = None
        self._lock = threading.Lock()

    def write(self, text: str) -> None:
        """Append text."""
        with self._lock:
            if self._file is None:
                self._file = self.path.open("ab")
            self._file.write(text.encode("utf-8", "backslashreplace"))
            if "\n" in text:
                self._file.flush()

    def close(self) -> None:
        """Let go of the file; writing opens it again."""
        with self._lock:
            if self._file is not None:
                self._file.close()
                self._file = None

    def read(self, offset: int, *, complete: bool) -> dict[str, Any]:
        """Lines from byte ``offset``: at most 4 MiB, whole lines only unless the log is ``complete``.

        ``next_offset`` is where to read on; ``more`` says that there is more to read now.
        """
        with self._lock:
            if self._file is not None:
                self._file.flush()
        if not self.path.is_file():
            return {"python_logs": [], "next_offset": offset, "more": False}
        with self.path.open("rb") as file:
            size = file.seek(0, io.SEEK_END)
            file.seek(offset)
            data = file.read(MAX_LOG_BYTES)
        last = offset + len(data) >= size
        if not (complete and last):
            end = data.rfind(b"\n") + 1
            data = data[:end] if end or last else data
        text = data.decode("utf-8", "replace")
        lines = text.removesuffix("\n").split("\n") if text else []
        return {"python_logs": lines, "next_offset": offset + len(data), "more": not last}


class Job:
    """One piece of work for the main thread."""

    def __init__(self, number: int, work: Callable[[], Any], log: JobLog) -> None:
        self.id = f"job-{number}"
        self.work = work
        self.log = log
        self.done = threading.Event()
        self.value: Any = None
        self.error: str | None = None
        self.fault: str | None = None
        """Class name of the exception behind ``error``."""
        self.abandoned = False

    def reply(self, offset: int = 0) -> dict[str, Any]:
        """The state of the job as a bridge reply."""
        finished = self.done.is_set()
        reply: dict[str, Any] = {"status": "running", "job_id": self.id,
                                 "result": self.log.read(offset, complete=finished)}
        if finished:
            reply["status"] = "ok" if self.error is None else "error"
            if self.error is None:
                reply["value"] = self.value
            else:
                reply |= {"error": self.error, "fault": self.fault}
        return reply


class _Output(io.TextIOBase):
    """Standard output and error of the process: goes to the running job, else to the engine's own log."""

    encoding = "utf-8"

    def __init__(self, runner: JobRunner, own: TextIO) -> None:
        self._runner, self._own = runner, own

    def write(self, text: str) -> int:
        job = self._runner.running
        if job is None:
            self._own.write(text)
            self._own.flush()
        else:
            job.log.write(text)
        return len(text)

    def flush(self) -> None:
        self._own.flush()

    def writable(self) -> bool:
        return True



class JobRunner:
    """Runs jobs on the thread that calls ``run_forever``, and a tick between them."""

    def __init__(self, folder: Path, tick: Callable[[float], None]) -> None:
        self._folder, self._tick = folder, tick
        self._waiting: queue.SimpleQueue[Job | None] = queue.SimpleQueue()
        self._jobs: OrderedDict[str, Job] = OrderedDict()
        self._lock = threading.Lock()
        self._count = 0
        self._thread = threading.get_ident()
        self.running: Job | None = None

    def submit(self, work: Callable[[], Any]) -> Job:
        """Queue work for the main thread."""
        with self._lock:
            self._count += 1
            job = Job(self._count, work, JobLog(self._folder / f"job-{self._count}.log"))
            self._jobs[job.id] = job
            while len(self._jobs) > KEPT_JOBS and next(iter(self._jobs.values())).done.is_set():
                self._jobs.popitem(last=False)
        self._waiting.put(job)
        return job

    def job(self, job_id: str) -> Job | None:
        """A job by its id, if it is still known."""
        with self._lock:
            return self._jobs.get(job_id)

    def waiting(self) -> int:
        """How many jobs wait behind the running one."""
        return self._waiting.qsize()

    def abandon(self, job: Job) -> None:
        """Ask a job to end: at its next Python instruction when it runs, at once when it waits. Best effort."""
        job.abandoned = True
        if self.running is job:
            ctypes.pythonapi.PyThreadState_SetAsyncExc(ctypes.c_ulong(self._thread), ctypes.py_object(JobAbandoned))

    def stop(self) -> None:
        """End ``run_forever`` behind the jobs that are queued now."""
        self._waiting.put(None)

    def run_forever(self) -> None:
        """Run jobs until ``stop``."""
        self._thread = threading.get_ident()
        sys.stdout, sys.stderr = _Output(self, sys.stdout), _Output(self, sys.stderr)
        while True:
            try:
                job = self._waiting.get(timeout=_TICK_S)
            except queue.Empty:
                self._guarded(lambda: self._tick(_TICK_S))
                continue
            if job is None:
                return
            try:
                self._run(job)
            except JobAbandoned:
                job.error = job.error or "abandoned"
            finally:
                job.log.close()
                job.done.set()

    def _run(self, job: Job) -> None:
        self._forget_interruption()
        self.running = job
        try:
            if job.abandoned:
                raise JobAbandoned
            job.value = job.work()
        except BaseException as error:
            job.error, job.fault = _describe(error), type(error).__name__
        finally:
            self.running = None
            self._forget_interruption()

    def _forget_interruption(self) -> None:
        """Take back an interruption that arrived when its job had already ended."""
        ctypes.pythonapi.PyThreadState_SetAsyncExc(ctypes.c_ulong(self._thread), None)

    def _guarded(self, work: Callable[[], None]) -> None:
        """Run a tick callback of agent code: its error goes to the log and must not end the engine."""
        try:
            work()
        except BaseException as error:
            sys.stderr.write(_describe(error) + "\n")


def run_script(script: str, namespace: dict[str, Any], name: str) -> None:
    """Run a script in ``namespace``; its lines show in tracebacks. ``sys.exit()`` without a failure is a normal end."""
    linecache.cache[name] = (len(script), None, script.splitlines(keepends=True), name)
    try:
        exec(compile(script, name, "exec"), namespace)
    except SystemExit as ended:
        if ended.code not in (None, 0):
            raise


def _describe(error: BaseException) -> str:
    """An error as people read it: the traceback without the frames of the engine's own job machinery."""
    if isinstance(error, JobAbandoned):
        return "abandoned"
    shown = traceback.TracebackException.from_exception(error)
    shown.stack = traceback.StackSummary.from_list([frame for frame in shown.stack if frame.filename not in _OWN_FILES])
    return "".join(shown.format()).rstrip()
