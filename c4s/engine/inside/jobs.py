"""How a job is run beside agent code, in any engine: what hears the host, what runs, and what is told of it.

Standard library and the bounds only, since a real editor's Python has nothing else.
"""

from __future__ import annotations

import builtins
import ctypes
import importlib
import json
import linecache
import os
import queue
import signal
import socket
import threading
import traceback
from abc import ABC, abstractmethod
from collections.abc import Callable
from types import FrameType
from typing import Any, ClassVar

from c4s.bounds import BOUNDS, values_in
from c4s.engine import channel

WAKE = signal.SIGALRM
"""Interrupts a system call that a job waits in."""
_LONGEST_ERROR = 100_000
"""Characters at the end of an error that are told."""

Order = tuple[dict[str, Any], int]
"""A job, and the descriptor that it prints to."""


class JobAbandoned(BaseException):
    """Raised inside a job that the host has given up on."""


class JobRunner(ABC):
    """Runs the jobs that come over ``connection``, each to its end, on the thread that calls ``run``."""

    OWN_FILES: ClassVar[frozenset[str]] = frozenset({__file__})
    """Files whose frames no traceback shows."""

    def __init__(self, connection: socket.socket, begin: Callable[[dict[str, Any]], None] = lambda order: None) -> None:
        """``begin`` hears of each job."""
        self._connection, self._begin = connection, begin
        self.orders: queue.SimpleQueue[Order | None] = queue.SimpleQueue()
        """What the host wants: jobs, and None to stop."""
        self._namespace: dict[str, Any] = {"__name__": "__main__", "__builtins__": builtins, "__doc__": None}
        self._thread = threading.get_ident()
        self._running = 0

    def start(self, version: str) -> None:
        """Hear the host from now on, and tell it that this engine serves; jobs run on the thread that calls this."""
        self._thread = threading.get_ident()
        signal.signal(WAKE, _awake)
        threading.Thread(target=self._listen, name="host", daemon=True).start()
        channel.send(self._connection, json_line({"ready": True, "version": version}))

    def _listen(self) -> None:
        signal.pthread_sigmask(signal.SIG_BLOCK, {WAKE})
        while True:
            try:
                payload, output = channel.receive(self._connection)
            except (EOFError, OSError):
                os._exit(1)
            message = json.loads(payload)
            if "abandon" in message:
                self._interrupt(message["abandon"])
            else:
                self.orders.put(None if output is None else (message, output))

    def _interrupt(self, number: int) -> None:
        if self._running == number:
            ctypes.pythonapi.PyThreadState_SetAsyncExc(ctypes.c_ulong(self._thread), ctypes.py_object(JobAbandoned))
            self.wake()

    @abstractmethod
    def wake(self) -> None:
        """Send ``WAKE`` to the thread that runs jobs."""

    @abstractmethod
    def begin_output(self, descriptor: int) -> None:
        """Let all that is printed from now on go to a job's descriptor; close it."""

    @abstractmethod
    def end_output(self) -> None:
        """Let what is printed go where it went before the job."""

    def run(self, order: dict[str, Any], output: int) -> None:
        """Run one job and send its result, whatever it does."""
        result: dict[str, Any] = {"job": order["job"]}
        value = b"null"
        self.begin_output(output)
        self._forget_interruption()
        self._begin(order)
        try:
            self._running = order["job"]
            try:
                value = self._work(order)
            finally:
                self._running = 0
        except BaseException as error:
            result |= {"error": describe(error, self.OWN_FILES)[-_LONGEST_ERROR:], "fault": type(error).__name__}
        self._forget_interruption()
        self.end_output()
        channel.send(self._connection, json_line(result) + b"\n" + value)

    def _work(self, order: dict[str, Any]) -> bytes:
        if "script" in order:
            run_script(order["script"], self._namespace, f"<script {order['name']}>")
            return b"null"
        module, _, name = order["function"].partition(".")
        value = json_line(getattr(importlib.import_module(f"c4s.editor.{module}"), name)(**order["params"]))
        fault = BOUNDS["answer_bytes"].fault(len(value)) or BOUNDS["answer_values"].fault(values_in(value))
        if fault is not None:
            raise ValueError(fault)
        return value

    def _forget_interruption(self) -> None:
        """Take back an interruption that arrived when its job had already ended."""
        ctypes.pythonapi.PyThreadState_SetAsyncExc(ctypes.c_ulong(self._thread), None)


def _awake(_: int, __: FrameType | None) -> None:
    """End a wait of the job (a sleep, a lock): what was sent to its thread is raised when this returns."""


def json_line(value: Any) -> bytes:
    """One line of JSON. ``ValueError`` for NaN and infinities; what is no text in UTF-8 becomes a question mark."""
    return json.dumps(value, allow_nan=False, ensure_ascii=False, separators=(",", ":")).encode("utf-8", "replace")


def run_script(script: str, namespace: dict[str, Any], name: str) -> None:
    """Run a script in ``namespace``; its lines show in tracebacks. ``sys.exit()`` without a failure is a normal end."""
    linecache.cache[name] = (len(script), None, script.splitlines(keepends=True), name)
    try:
        exec(compile(script, name, "exec"), namespace)
    except SystemExit as ended:
        if ended.code not in (None, 0):
            raise


def describe(error: BaseException, own_files: frozenset[str]) -> str:
    """An error as people read it: the traceback without the frames of the engine's own job machinery."""
    if isinstance(error, JobAbandoned):
        return "abandoned"
    shown = traceback.TracebackException.from_exception(error)
    shown.stack = traceback.StackSummary.from_list([frame for frame in shown.stack if frame.filename not in own_files])
    return "".join(shown.format()).rstrip()
