"""The engine's main thread: runs one job after the other, and a tick between them.

Standard output and error, as Python's objects and as file descriptors 1 and 2, are the job's pipe while a job runs, and
the engine's own log between jobs.
"""

from __future__ import annotations

import ctypes
import os
import queue
import signal
import socket
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any, TextIO

from c4s.engine import channel
from c4s.engine.inside.jobs import JobAbandoned, JobRunner, describe

_TICK_S = 1 / 60
_AT_ONCE_S = 1e-6


class Worker(JobRunner):
    """Runs the jobs that come over ``connection`` on the thread that calls ``run_forever``; ``begin`` hears of each.

    ``version`` is what the host is told that the engine is.
    """

    OWN_FILES = JobRunner.OWN_FILES | {__file__, str(Path(__file__).with_name("main.py"))}

    def __init__(
        self,
        connection: socket.socket,
        tick: Callable[[float], None],
        begin: Callable[[dict[str, Any]], None],
        version: str,
    ) -> None:
        super().__init__(connection, begin)
        self._tick, self._version = tick, version
        self._own_output = os.dup(1)
        self._flush_c = ctypes.CDLL(None).fflush

    def run_forever(self) -> None:
        """Run jobs until the host says stop or is gone."""
        self.start(self._version)
        self._point_output(self._own_output)
        while True:
            try:
                order = self.orders.get(timeout=_TICK_S)
            except queue.Empty:
                self._guarded_tick()
                continue
            except JobAbandoned:
                continue
            if order is None:
                return
            self.run(*order)

    def wake(self) -> None:
        """A timer sends the signal: the sandbox lets no process send any."""
        signal.setitimer(signal.ITIMER_REAL, _AT_ONCE_S)

    def begin_output(self, descriptor: int) -> None:
        """To the job's pipe, whoever prints."""
        self._point_output(descriptor)
        channel.close(descriptor)

    def end_output(self) -> None:
        """To the engine's own log."""
        self._point_output(self._own_output)

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

    def _guarded_tick(self) -> None:
        """Run the tick callbacks of agent code: their errors go to the log and must not end the engine."""
        try:
            self._tick(_TICK_S)
        except BaseException as error:
            print(describe(error, self.OWN_FILES), file=sys.stderr)


def _stream(descriptor: int) -> TextIO:
    return open(descriptor, "w", encoding="utf-8", errors="backslashreplace", buffering=1, closefd=False)
