"""An engine process and the bridge to it, for as long as the host needs it; backends start the process."""

from __future__ import annotations

import os
import signal
import socket
import subprocess
import threading
import time
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from itertools import islice
from pathlib import Path
from types import TracebackType
from typing import Any, Self

from c4s.engine.bridge import FAILED, OVER_TIME, BridgeFault, SocketBridge
from c4s.engine.confine import leftovers
from c4s.engine.confine.confinement import Backend, Limits
from c4s.engine.confine.sandbox import Mounts
from c4s.engine.confine.watch import Watch, tree
from c4s.engine.faults import EngineCallError, EngineDied, EngineOverLimit
from c4s.engine.host.joblog import JobLog
from c4s.engine.host.jobs import JobBoard
from c4s.engine.host.server import BridgeServer
from c4s.errors import BadInput, MachineryFault, shortage
from c4s.folders import remove_tree

WATCH_S = 0.25
"""Seconds between two looks at what an engine uses."""
STOP_TIMEOUT_S = 5.0
MOST_INNER = 16
"""Processes below the one that was started, when the engine serves and no agent code has run: one or two."""
SOCKET = "bridge.sock"
_POLL_S = 10.0
_LATER_S = 1.0
"""The engine holds a job to its time a little later than who waits for it."""


class Session:
    """One engine process. Use it as a context manager, or call ``close``."""

    kind: str

    def __init__(
        self,
        process: subprocess.Popen[bytes],
        listener: socket.socket,
        connection: socket.socket,
        output: int,
        paths: Mounts,
        folders: tuple[Path, Path],
        limits: Limits,
        sandbox: Backend,
        log: JobLog | None = None,
    ) -> None:
        """``folders``: of the sockets, and of the logs; ``log``: the engine's own, where it has begun already."""
        self.sandbox = sandbox
        """What confines the process."""
        self._process, self._socket_folder, self.logs = process, *folders
        """``logs`` holds ``engine.log`` and ``job-<n>.log``; the engine cannot reach it."""
        self.bridge = SocketBridge(self._socket_folder / SOCKET)
        self._scratch = paths.work
        self._board = JobBoard(connection, output, self.logs, self._end, log)
        self._server = BridgeServer(listener, self._board, paths.work, self.kind)
        self._inner: list[int] = []
        """What runs below the process that confines the engine: it is ended with it even where that was killed."""
        self._watch, self._closed = Watch(process.pid, paths.read_write, limits), threading.Event()
        self._watching = threading.Thread(target=self._look, name="engine-watch", daemon=True)
        self._watching.start()

    def _look(self) -> None:
        """Watch the process, whatever else waits for it, and end it when it passes a limit."""
        while not self._closed.wait(WATCH_S) and self.alive:
            try:
                reason = self._watch.breach()
            except OSError as error:
                if shortage(error) is not None:
                    self._board.fail(error)
                    self._end_group()
                    return
                reason = f"it cannot be watched: {error.strerror}"
            if reason is not None:
                self._board.end(reason)
                self._end_group()
                return

    def _wait_until_ready(self, most_s: float) -> None:
        """``BadInput`` for what the engine refuses, ``MachineryFault`` where it ends or is not ready in time."""
        deadline = time.monotonic() + most_s
        while not self._board.ready.wait(WATCH_S):
            if not self.alive:
                self._end_orphans()
            if time.monotonic() >= deadline:
                raise MachineryFault(f"the engine did not start in {most_s:g} s", where=str(self.logs))
        refusal = self._board.refusal
        if refusal is not None:
            raise BadInput(refusal["what"], where=refusal["where"], todo=refusal["todo"])
        if self._board.gone is not None:
            raise self._dead(self._board.gone, "start")
        self._inner = list(_opened_below(self._process.pid))
        if not self.alive:
            raise self._dead(f"what confines it ended with {_exit_text(self._process.wait())}", "start")

    @property
    def version(self) -> str:
        """The version that the engine called itself when it was ready, before any job ran in it."""
        return self._board.version

    @property
    def pid(self) -> int:
        """Process id of the engine (of bubblewrap, where that runs it: it dies with it and the engine with it)."""
        return self._process.pid

    @property
    def alive(self) -> bool:
        """Whether the process runs."""
        return self._process.poll() is None

    def request(self, kind: str, params: Mapping[str, Any] | None = None, timeout_s: float = 300.0) -> dict[str, Any]:
        """One bridge request; its reply whatever its status. ``EngineDied`` when the process has ended."""
        try:
            reply = self.bridge.request(kind, params, timeout_s=timeout_s)
        except BridgeFault as fault:
            if self._board.gone is None and self._board.fault is None:
                raise
            raise self._dead(self._board.gone or "", kind) from fault
        if reply.get("engine_ended") or reply.get("state") == "dead":
            raise self._dead(str(reply["error"]), kind, reply.get("result", {}).get("python_logs", ()))
        return reply

    def _dead(self, what: str, during: str, lines: Sequence[str] = ()) -> MachineryFault:
        """What the end of the engine is: the host's own fault, where that ended it."""
        if self._board.fault is not None:
            return self._board.fault
        kind = EngineOverLimit if self._board.over_limit else EngineDied
        return kind(what, during=during, where=str(self.logs), lines=lines)

    def execute(self, script: str, timeout_s: float = 600.0) -> dict[str, Any]:
        """Run a script to its end and return the final reply with all its lines under ``result.python_logs``.

        A script that is still running after ``timeout_s`` is abandoned, and its last reply says ``running``.
        """
        return self._run("execute_python_script", {"script": script}, timeout_s)

    def call(self, function: str, /, *, timeout_s: float = 600.0, **params: Any) -> Any:
        """Run ``c4s.editor.<module>.<function>(**params)`` in the engine and return its value.

        Raises ``EngineCallError`` when the function raised, ``BridgeFault`` when it took longer than ``timeout_s`` once
        it had begun.
        """
        reply = self._run("call_function", {"function": function, "params": params}, timeout_s)
        if reply["status"] == "running" or reply.get("fault") == OVER_TIME:
            raise BridgeFault(f"no result in {timeout_s:g} s", where=function)
        if reply["status"] in FAILED:
            raise EngineCallError(str(reply.get("error")), function=function, kind=str(reply.get("fault")))
        return reply.get("value")

    def _run(self, kind: str, params: Mapping[str, Any], timeout_s: float) -> dict[str, Any]:
        deadline = time.monotonic() + timeout_s
        asked = {"wait_s": min(_POLL_S, timeout_s), "limit_s": timeout_s + _LATER_S}
        reply = self.request(kind, {**params, **asked}, timeout_s + _POLL_S)
        lines: list[str] = []
        while "job_id" in reply:
            page = reply["result"]
            lines += page["python_logs"]
            if reply.get("queued"):
                deadline = time.monotonic() + timeout_s
            late = time.monotonic() >= deadline
            if not page["more"] and (reply["status"] != "running" or late):
                break
            wait_s = 0.0 if page["more"] or late else min(_POLL_S, deadline - time.monotonic())
            reply = self.request(
                "read_job_log", {"job_id": reply["job_id"], "offset": page["next_offset"], "wait_s": max(0.0, wait_s)}
            )
        if reply.get("status") == "running":
            self.request("abandon_job", {"job_id": reply["job_id"]})
        if "result" in reply:
            reply["result"]["python_logs"] = lines
        return reply

    def close(self) -> None:
        """Ask the engine to end, and end it if it does not, or is busy."""
        if self.alive and self._board.status()["state"] == "idle":
            self._board.stop()
            with suppress(subprocess.TimeoutExpired):
                self._process.wait(STOP_TIMEOUT_S)
        self.kill()

    def kill(self) -> None:
        """End the process at once and remove its socket.

        What it printed is kept; what it left in ``scratch`` is, unless that is too much (``leftovers.KEPT``).
        """
        self._closed.set()
        self._end_group()
        self._process.wait()
        for process in self._inner:
            with suppress(ProcessLookupError):
                signal.pidfd_send_signal(process, signal.SIGKILL)
            os.close(process)
        self._inner.clear()
        self._board.join(STOP_TIMEOUT_S)
        self._server.close()
        self._watching.join()
        remove_tree(self._socket_folder, inside=self._socket_folder.parent, at_best=True)
        leftovers.trim(self._scratch, self.logs / "trimmed.json")

    def _end_group(self) -> None:
        """Kill the process and what it started; it may have ended just now, and another thread may have seen that."""
        if self.alive:
            with suppress(ProcessLookupError):
                os.killpg(self._process.pid, signal.SIGKILL)

    def _end_orphans(self) -> None:
        """Kill what is left of the group of a process that has just ended: one that waits for it holds the
        connection. A group that has members keeps its number."""
        with suppress(ProcessLookupError):
            os.killpg(self._process.pid, signal.SIGKILL)

    def _end(self, at_once: bool) -> str:
        """Wait for the process a moment, end it if it does not, and say how it ended."""
        try:
            code = self._process.wait(0.0 if at_once else STOP_TIMEOUT_S)
        except subprocess.TimeoutExpired:
            self._end_group()
            code = self._process.wait()
        return _exit_text(code)

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()


def _opened_below(process: int) -> Iterator[int]:
    """Handles of the processes below one."""
    for folder in islice(tree(process, MOST_INNER), 1, None):
        with suppress(ProcessLookupError):
            yield os.pidfd_open(int(folder.name))


def _exit_text(code: int) -> str:
    number = -code if code < 0 else code - 128
    if number in list(signal.Signals):
        return signal.Signals(number).name
    return f"signal {number}" if code < 0 else f"exit code {code}"
