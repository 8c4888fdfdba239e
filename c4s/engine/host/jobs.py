"""The host's side of an engine process: the queue of its jobs, what they print, and how it ends.

One thread talks to the engine. A job's output comes through a pipe of its own, which is the engine's standard output
and error for as long as the job runs, whoever in the process writes to it. What has left the engine is kept here, where
agent code cannot reach it, so a job's log survives a crash, and no script can change what another printed.
"""

from __future__ import annotations

import array
import fcntl
import os
import selectors
import socket
import termios
import threading
import time
import traceback
from collections import OrderedDict, deque
from collections.abc import Callable, Mapping
from contextlib import suppress
from pathlib import Path
from typing import Any

import orjson

from c4s.bounds import BOUNDS
from c4s.engine import channel
from c4s.engine.bridge import OVER_TIME
from c4s.engine.host.job import EngineJob
from c4s.engine.host.joblog import JobLog
from c4s.errors import MachineShort, Unforeseen, shortage
from c4s.files import parse_bounded

ENGINE_LOG = "engine.log"
KEPT_JOBS = 512
KEPT_VALUES = 16
"""Jobs whose value can still be read; the values of older ones are dropped."""
MAX_PRINTED_BYTES = 1 << 30
"""What an engine and its jobs may print together."""
GRACE_S = 5.0
"""How long a job may take to end after its time is over, at most as long again (seconds)."""
_AGAIN_S = 0.5
"""Seconds between two requests to a job over its time to end: a script may catch the first ones."""
_SEND_S = 60.0
_CHUNK = 1 << 18
_TAIL_BYTES = 4000
_HEAD_BYTES = 1 << 20
"""Of a message, up to the value that a job returned: its number, and an error with its traceback."""


class EngineGone(Exception):
    """The engine has ended; the text says how."""


class JobBoard:
    """The jobs of one engine process, on the host.

    Args:
        connection: the host's end of the channel.
        output: the read end of the pipe that the engine's own output goes to between jobs.
        folder: where the logs lie; no engine sees it.
        end: waits for the process (no longer than a moment, not at all when told True), kills it if it still runs,
            and says how it ended.
        log: the engine's own, where it has begun already.
    """

    def __init__(
        self,
        connection: socket.socket,
        output: int,
        folder: Path,
        end: Callable[[bool], str],
        log: JobLog | None = None,
    ) -> None:
        self._connection, self._output, self._folder, self._end = connection, output, folder, end
        self.log = log or JobLog(folder / ENGINE_LOG)
        """What the engine prints outside of jobs."""
        self.ready = threading.Event()
        """Set when the engine serves, refuses, or has ended."""
        self.refusal: dict[str, str] | None = None
        """The bad input for which the engine did not start."""
        self.version = ""
        """What the engine calls its version, told when it is ready."""
        self._reason: str | None = None
        """Why somebody else ended the engine."""
        self.fault: MachineShort | Unforeseen | None = None
        """Why the host ended the engine for its own sake: it was short of something, or did not foresee something."""
        self.gone: str | None = None
        """How the engine ended; None while it runs."""
        self.running: EngineJob | None = None
        self._waiting: deque[EngineJob] = deque()
        self._jobs: OrderedDict[str, EngineJob] = OrderedDict()
        self._lock = threading.Lock()
        self._failure: OSError | None = None
        self._count, self._stopping, self._printing = 0, False, -1
        self._printed = 0
        """Bytes that finished jobs have printed."""
        self._incoming = channel.Incoming()
        self._sending = threading.Lock()
        connection.settimeout(_SEND_S)
        self._wake_end, self._wake = os.pipe()
        self._thread = threading.Thread(target=self._work, name="engine-jobs", daemon=True)
        self._thread.start()

    def submit(self, request: Mapping[str, Any], limit_s: float | None = None) -> EngineJob:
        """Queue work for the engine. One that runs longer than ``limit_s`` is ended, if need be with the engine."""
        with self._lock:
            self._count += 1
            job = EngineJob(self._count, request, JobLog(self._folder / f"job-{self._count}.log"), limit_s)
            self._jobs[job.id] = job
            while len(self._jobs) > KEPT_JOBS and next(iter(self._jobs.values())).done.is_set():
                self._jobs.popitem(last=False)
            for old in list(self._jobs.values())[-KEPT_VALUES - 8 : -KEPT_VALUES]:
                old.value = None
            if self.gone is None:
                self._waiting.append(job)
                os.write(self._wake, b"j")
                return job
        self._finish(job, self.gone, "EngineDied", ended=True)
        return job

    def job(self, job_id: str) -> EngineJob | None:
        """A job by its id, if it is still known."""
        with self._lock:
            return self._jobs.get(job_id)

    def status(self) -> dict[str, Any]:
        """Whether the engine is idle, busy or dead; answered without asking it, so it holds for one that hangs."""
        with self._lock:
            running, gone = self.running, self.gone
            state = "dead" if gone is not None else "busy" if running is not None or self._waiting else "idle"
            told: dict[str, Any] = {
                "state": state,
                "busy": state == "busy",
                "job_id": running.id if running else None,
                "waiting": len(self._waiting),
            }
        if running is not None and running.started is not None:
            told["running_s"] = round(time.monotonic() - running.started, 3)
        if gone is not None:
            told["error"] = gone
        return told

    def abandon(self, job: EngineJob) -> None:
        """Ask a job to end: at its next Python instruction when it runs, at once when it waits. Best effort."""
        with self._lock:
            job.abandoned = True
            running, waiting = self.running is job and self.gone is None, job in self._waiting
            if waiting:
                self._waiting.remove(job)
        if running:
            with suppress(OSError):  # an engine that is ending finishes the job by that
                self._send({"abandon": job.number})
        if waiting:
            self._finish(job, "abandoned", "JobAbandoned")

    def _send(self, message: Mapping[str, Any], descriptor: int | None = None) -> None:
        with self._sending:
            channel.send(self._connection, orjson.dumps(message), descriptor)

    def stop(self) -> None:
        """Tell the engine to end behind the jobs that are queued now."""
        with self._lock:
            if self.gone is None:
                self._stopping = True
                os.write(self._wake, b"s")

    @property
    def over_limit(self) -> bool:
        """Whether the engine was ended for a limit that it passed."""
        return self._reason is not None

    def end(self, reason: str) -> None:
        """Note why the engine is being ended for a limit that it passed; whoever says so ends it."""
        with self._lock:
            if self.gone is None and self._reason is None:
                self._reason = reason
                os.write(self._wake, b"e")

    def fail(self, error: OSError) -> None:
        """End the engine: the host cannot serve it any more."""
        with self._lock:
            if self.gone is None:
                self._failure = error
                os.write(self._wake, b"f")

    def join(self, most_s: float) -> None:
        """Wait until the engine has ended and all that it printed is kept. One that has not ended in time is cut off:
        nobody is left to be killed, or it has cut itself off from its host, and it ends by that."""
        self._thread.join(most_s)
        if self._thread.is_alive():
            with suppress(OSError):
                self._connection.shutdown(socket.SHUT_RDWR)
            self._thread.join()

    def _work(self) -> None:
        try:
            with selectors.DefaultSelector() as selector:
                for source in (self._wake_end, self._output, self._connection):
                    selector.register(source, selectors.EVENT_READ)
                self._serve(selector)
        except (EngineGone, ValueError, OSError) as why:
            reason, self.fault = self._reason or str(why), shortage(why)
        except Exception as error:
            reason = f"the host cannot go on with it: {type(error).__name__}: {error}"
            self.fault = Unforeseen(reason, where=str(self._folder))
            self.fault.add_note("".join(traceback.format_exception(error)))
        self._bury(reason)

    def _serve(self, selector: selectors.BaseSelector) -> None:
        """Until the engine is gone: start jobs, keep what they print, take their results."""
        while True:
            ready = {key.fd for key, _ in selector.select(self._left_s())}
            self._hold_to_time()
            if self._reason is not None:
                raise EngineGone(self._reason)
            if self._wake_end in ready:
                os.read(self._wake_end, _CHUNK)
            if self._failure is not None:
                raise self._failure
            if self._output in ready and not _pour(self._output, self.log):
                selector.unregister(self._output)
            if self._printing in ready and self.running is not None and not _pour(self._printing, self.running.log):
                selector.unregister(self._printing)
            for log in (self.log, *([self.running.log] if self.running else [])):
                if log.size > BOUNDS["log_bytes"].most:
                    raise EngineGone(f"it printed more than {BOUNDS['log_bytes'].told()}")
            if self.log.size + self._printed + (self.running.log.size if self.running else 0) > MAX_PRINTED_BYTES:
                raise EngineGone(f"it printed more than {MAX_PRINTED_BYTES >> 20} MiB in all")
            if self._connection.fileno() in ready:
                data = self._connection.recv(_CHUNK)
                if not data:
                    raise EngineGone("")
                for message in self._incoming.feed(data):
                    self._take(message, selector)
            if self.running is None and self.ready.is_set():
                self._start_next(selector)

    def _left_s(self) -> float | None:
        """Seconds until the running job must be looked at; None for one without an end."""
        job = self.running
        if job is None or job.started is None or job.limit_s is None:
            return None
        due = job.started + job.limit_s if job.asked_to_end is None else job.asked_to_end + _AGAIN_S
        return max(0.0, due - time.monotonic())

    def _hold_to_time(self) -> None:
        """Ask a job over its time to end, again and again; end the engine where it does not."""
        job, now = self.running, time.monotonic()
        if job is None or job.started is None or job.limit_s is None or now < job.started + job.limit_s:
            return
        if now > job.started + job.limit_s + min(GRACE_S, job.limit_s):
            self._reason = f"{job.id} ran longer than {job.limit_s:g} s and could not be ended"
            raise EngineGone(self._reason)
        if job.asked_to_end is None or now >= job.asked_to_end + _AGAIN_S:
            job.asked_to_end = now
            self.abandon(job)

    def _take(self, message: bytes, selector: selectors.BaseSelector) -> None:
        """A message of the engine: that it serves, that it refuses its input, or the result of the running job."""
        head, _, value = message.partition(b"\n")
        fields, job = _object(head), self.running
        if not self.ready.is_set():
            self.refusal, self.version = fields.get("refused"), str(fields.get("version", ""))
            self.ready.set()
        elif job is not None and fields.get("job") == job.number:
            error, fault = _text(fields, "error"), _text(fields, "fault")
            if fault == "JobAbandoned" and job.asked_to_end is not None:
                error, fault = f"ended: it ran longer than {job.limit_s:g} s", OVER_TIME
            _pour(self._printing, job.log, _available(self._printing))
            if self._printing in selector.get_map():
                selector.unregister(self._printing)
            channel.close(self._printing)
            self._printing = -1
            with self._lock:
                self.running = None
            self._finish(job, error, fault, value)

    def _start_next(self, selector: selectors.BaseSelector) -> None:
        with self._lock:
            if not self._waiting:
                if self._stopping:
                    self._stopping = False
                    self._send({"stop": True})
                return
            job = self.running = self._waiting.popleft()
        job.started = time.monotonic()
        self._printing, writing = os.pipe()
        try:
            selector.register(self._printing, selectors.EVENT_READ)
            self._send({"job": job.number, **job.request}, writing)
        finally:
            channel.close(writing)

    def _finish(
        self, job: EngineJob, error: str | None, fault: str | None, value: bytes = b"", *, ended: bool = False
    ) -> None:
        job.error, job.fault = error, fault
        if error is None:
            try:
                parse_bounded(value, BOUNDS["answer_bytes"], BOUNDS["answer_values"], plain=True)
                job.value = value
            except ValueError as wrong:
                job.error, job.fault = f"the value that it returned is not JSON: {wrong}", "ValueError"
        job.ended = ended
        job.log.close()
        self._printed += job.log.size
        job.done.set()

    def _bury(self, reason: str) -> None:
        """The engine has ended, or must: take what it still printed, and give every job its answer."""
        how = self._end(bool(reason))
        running = self.running
        try:
            if self._printing >= 0 and running is not None:
                _pour(self._printing, running.log, _available(self._printing))
            _pour(self._output, self.log, _available(self._output))
        except OSError as error:
            self.fault = self.fault or shortage(error)
        if self._printing >= 0:
            channel.close(self._printing)
        tails = [log.tail(_TAIL_BYTES) for log in ([running.log] if running else []) + [self.log]]
        with self._lock:
            self.gone = " ".join(
                part for part in (f"the engine ended with {how}", f"({reason})" if reason else "", *tails) if part
            )
            left = ([running] if running else []) + list(self._waiting)
            self.running = None
            self._waiting.clear()
        for job in left:
            self._finish(job, self.gone, "EngineDied", ended=True)
        self.ready.set()
        self.log.close()
        channel.close(self._output, self._wake_end, self._wake)
        self._connection.close()


def _text(fields: Mapping[str, Any], name: str) -> str | None:
    """A text of a message, or None. ``ValueError`` for anything else."""
    found = fields.get(name)
    if found is not None and not isinstance(found, str):
        raise ValueError(f"the {name} of a message is no text")
    return found


def _object(message: bytes) -> dict[str, Any]:
    """A message as its fields. ``ValueError`` when it is none."""
    if len(message) > _HEAD_BYTES:
        raise ValueError("the head of a message is too long")
    value = orjson.loads(message)
    if not isinstance(value, dict):
        raise ValueError("the engine sent what is no message")
    return value


def _available(descriptor: int) -> int:
    """Bytes that a pipe holds now."""
    amount = array.array("i", [0])
    fcntl.ioctl(descriptor, termios.FIONREAD, amount)
    return amount[0]


def _pour(descriptor: int, log: JobLog, amount: int | None = None) -> bool:
    """Move what a pipe holds (one reading, or ``amount`` bytes) into a log. False at the pipe's end."""
    left = _CHUNK if amount is None else amount
    while left:
        data = os.read(descriptor, min(left, _CHUNK))
        if not data:
            return False
        log.write(data)
        left = 0 if amount is None else left - len(data)
    return True
