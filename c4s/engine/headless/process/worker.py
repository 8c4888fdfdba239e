"""The engine's main thread: runs one job after the other, and a tick between them.

Standard output and error, as Python's objects and as file descriptors 1 and 2, are the job's pipe while a job runs, and
the engine's own log between jobs.
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
import sys
import threading
import traceback
from collections.abc import Callable
from pathlib import Path
from types import FrameType
from typing import Any, TextIO

from c4s.bounds import BOUNDS, values_in
from c4s.engine.headless import channel

_TICK_S = 1 / 60
_WAKE, _AT_ONCE_S = signal.SIGALRM, 1e-6
"""Interrupts a system call that a job waits in. A timer sends it: the sandbox lets no process send signals."""
_LONGEST_ERROR = 100_000
"""Characters at the end of an error that are told."""
_OWN_FILES = frozenset({__file__, str(Path(__file__).with_name("main.py"))})

Order = tuple[dict[str, Any], int]


class JobAbandoned(BaseException):
    """Raised inside a job that the host has given up on."""


class Worker:
    """Runs the jobs that come over ``connection`` on the thread that calls ``run_forever``; ``begin`` hears of each.

    ``version`` is what the host is told that the engine is.
    """

    def __init__(
        self,
        connection: socket.socket,
        tick: Callable[[float], None],
        begin: Callable[[dict[str, Any]], None],
        version: str,
    ) -> None:
        self._connection, self._tick, self._begin, self._version = connection, tick, begin, version
        self._orders: queue.SimpleQueue[Order | None] = queue.SimpleQueue()
        self._namespace: dict[str, Any] = {"__name__": "__main__", "__builtins__": builtins, "__doc__": None}
        self._thread = threading.get_ident()
        self._running = 0
        self._own_output = os.dup(1)
        self._flush_c = ctypes.CDLL(None).fflush

    def run_forever(self) -> None:
        """Run jobs until the host says stop or is gone."""
        self._thread = threading.get_ident()
        signal.signal(_WAKE, self._wake)
        threading.Thread(target=self._listen, name="host", daemon=True).start()
        channel.send(self._connection, _json({"ready": True, "version": self._version}))
        self._point_output(self._own_output)
        while True:
            try:
                order = self._orders.get(timeout=_TICK_S)
            except queue.Empty:
                self._guarded_tick()
                continue
            except JobAbandoned:
                continue
            if order is None:
                return
            self._run(*order)

    def _listen(self) -> None:
        signal.pthread_sigmask(signal.SIG_BLOCK, {_WAKE})
        while True:
            try:
                payload, output = channel.receive(self._connection)
            except (EOFError, OSError):
                os._exit(1)
            message = json.loads(payload)
            if "abandon" in message:
                self._interrupt(message["abandon"])
            else:
                self._orders.put(None if output is None else (message, output))

    def _interrupt(self, number: int) -> None:
        if self._running == number:
            ctypes.pythonapi.PyThreadState_SetAsyncExc(ctypes.c_ulong(self._thread), ctypes.py_object(JobAbandoned))
            signal.setitimer(signal.ITIMER_REAL, _AT_ONCE_S)

    def _wake(self, _: int, __: FrameType | None) -> None:
        """End a wait of the job (a sleep, a lock): what was sent to its thread is raised when this returns."""

    def _run(self, order: dict[str, Any], output: int) -> None:
        """Run one job and send its result, whatever it does."""
        result: dict[str, Any] = {"job": order["job"]}
        value = b"null"
        self._point_output(output)
        channel.close(output)
        self._forget_interruption()
        self._begin(order)
        try:
            self._running = order["job"]
            try:
                value = self._work(order)
            finally:
                self._running = 0
        except BaseException as error:
            result |= {"error": describe(error)[-_LONGEST_ERROR:], "fault": type(error).__name__}
        self._forget_interruption()
        self._point_output(self._own_output)
        channel.send(self._connection, _json(result) + b"\n" + value)

    def _work(self, order: dict[str, Any]) -> bytes:
        if "script" in order:
            run_script(order["script"], self._namespace, f"<script {order['name']}>")
            return b"null"
        module, _, name = order["function"].partition(".")
        value = _json(getattr(importlib.import_module(f"c4s.editor.{module}"), name)(**order["params"]))
        fault = BOUNDS["answer_bytes"].fault(len(value)) or BOUNDS["answer_values"].fault(values_in(value))
        if fault is not None:
            raise ValueError(fault)
        return value

    def _point_output(self, descriptor: int) -> None:
        """Make a descriptor the standard output and error, behind all that was printed so far."""
        for stream in (sys.stdout, sys.stderr):
            try:
                stream.flush()
            except Exception as error:  # a script may have closed it or put anything in its place
                os.write(self._own_output, f"output lost: {error!r}\n".encode("utf-8", "replace"))
        self._flush_c(None)
        os.dup2(descriptor, 1)
        os.dup2(descriptor, 2)
        sys.stdout, sys.stderr = _stream(1), _stream(2)

    def _forget_interruption(self) -> None:
        """Take back an interruption that arrived when its job had already ended."""
        ctypes.pythonapi.PyThreadState_SetAsyncExc(ctypes.c_ulong(self._thread), None)

    def _guarded_tick(self) -> None:
        """Run the tick callbacks of agent code: their errors go to the log and must not end the engine."""
        try:
            self._tick(_TICK_S)
        except BaseException as error:
            print(describe(error), file=sys.stderr)


def _json(value: Any) -> bytes:
    """One line of JSON. ``ValueError`` for NaN and infinities; what is no text in UTF-8 becomes a question mark."""
    return json.dumps(value, allow_nan=False, ensure_ascii=False, separators=(",", ":")).encode("utf-8", "replace")


def _stream(descriptor: int) -> TextIO:
    return open(descriptor, "w", encoding="utf-8", errors="backslashreplace", buffering=1, closefd=False)


def run_script(script: str, namespace: dict[str, Any], name: str) -> None:
    """Run a script in ``namespace``; its lines show in tracebacks. ``sys.exit()`` without a failure is a normal end."""
    linecache.cache[name] = (len(script), None, script.splitlines(keepends=True), name)
    try:
        exec(compile(script, name, "exec"), namespace)
    except SystemExit as ended:
        if ended.code not in (None, 0):
            raise


def describe(error: BaseException) -> str:
    """An error as people read it: the traceback without the frames of the engine's own job machinery."""
    if isinstance(error, JobAbandoned):
        return "abandoned"
    shown = traceback.TracebackException.from_exception(error)
    shown.stack = traceback.StackSummary.from_list([frame for frame in shown.stack if frame.filename not in _OWN_FILES])
    return "".join(shown.format()).rstrip()
