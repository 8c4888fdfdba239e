"""The start script of an editor: it opens the level, lets the editor tick, then runs the host's jobs between ticks.

A thread hears the host, the tick callback runs what it heard: ``unreal`` may be used on the editor's own thread alone.
An idle editor holds Python's lock, so each tick waits a moment for the queue, which lets that thread have it.
"""

from __future__ import annotations

import gc
import json
import os
import queue
import signal
import socket
import sys
import threading
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any, TextIO

import unreal

from c4s.editor.capture import frame_level
from c4s.editor.facts import Reader
from c4s.editor.host import Pictures, register
from c4s.editor.levels import make_level
from c4s.engine import channel
from c4s.engine.inside.jobs import WAKE, JobAbandoned, JobRunner, json_line
from c4s.engine.unreal.boot.guard import guard_levels

_LISTEN_S = 0.002
"""How long an idle tick waits for the thread that hears the host."""
_LOGS = {"log": "", "log_warning": "Warning: ", "log_error": "Error: "}


class EditorHost:
    """What this side offers to the editor's scripts: what the packs say of their meshes."""

    pictures: Pictures | None = None

    def __init__(self, kind: str, facts: dict[str, Any]) -> None:
        self.kind, self.mesh_facts = kind, facts

    def reader(self) -> Reader:
        """Reads through ``unreal``."""
        return Reader()

    def revision(self) -> int | None:
        """Unknown."""
        return None


class TickRunner(JobRunner):
    """Runs jobs in the editor's ticks."""

    OWN_FILES = JobRunner.OWN_FILES | {__file__}

    def __init__(self, connection: socket.socket, job: dict[str, Any]) -> None:
        super().__init__(connection)
        self._ticks, self._since = int(job["warm_ticks"]), time.monotonic() + float(job["warm_s"])
        self._handle: Any = None
        self._served = False
        self._streams: tuple[TextIO, TextIO] | None = None
        for name, mark in _LOGS.items():
            setattr(unreal, name, self._told(getattr(unreal, name), mark))

    def begin(self) -> None:
        """Let the editor tick; once it is warm, serve."""
        self._handle = unreal.register_slate_post_tick_callback(self._tick)

    def _tick(self, _: float) -> None:
        if not self._served:
            self._ticks -= 1
            if self._ticks > 0 or time.monotonic() < self._since:
                return
            self._served = True
            self.start(str(unreal.SystemLibrary.get_engine_version()))
        try:
            order = self.orders.get(timeout=_LISTEN_S)
        except (queue.Empty, JobAbandoned):
            return
        if order is None:
            self._leave()
        else:
            self.run(*order)

    def _leave(self) -> None:
        """End the editor; nothing of its objects may be held by then."""
        unreal.unregister_slate_post_tick_callback(self._handle)
        self._namespace.clear()
        gc.collect()
        unreal.SystemLibrary.quit_editor()

    def wake(self) -> None:
        """Only the thread that runs jobs is woken: the editor has many."""
        signal.pthread_kill(self._thread, WAKE)

    def begin_output(self, descriptor: int) -> None:
        """Python's output goes to the job; the editor's own log stays on the editor's."""
        stream = os.fdopen(descriptor, "w", encoding="utf-8", errors="backslashreplace", buffering=1)
        self._streams = (sys.stdout, sys.stderr)
        sys.stdout = sys.stderr = stream

    def end_output(self) -> None:
        """Python's output goes to the editor's log again."""
        if self._streams is None:
            return
        mine, (sys.stdout, sys.stderr), self._streams = sys.stdout, self._streams, None
        try:
            mine.close()
        except Exception as error:  # a script may have closed it or put anything in its place
            unreal.log_warning(f"output lost: {error!r}")

    def _told(self, log: Callable[[Any], None], mark: str) -> Callable[[Any], None]:
        """A function of the editor's log that tells the job too."""

        def told(arg: Any) -> None:
            log(arg)
            if self._streams is not None and threading.get_ident() == self._thread:
                print(f"{mark}{arg}")

        return told


def main(job_file: str) -> None:
    """Entry point: ``job_file`` is what ``c4s.engine.unreal.host.project`` wrote."""
    job = json.loads(Path(job_file).read_text(encoding="utf-8"))
    connection = socket.socket(socket.AF_UNIX)
    connection.connect(job["channel"])
    register(EditorHost(job["kind"], json.loads(Path(job["facts"]).read_text(encoding="utf-8"))))
    try:
        _open(job)
    except Exception as error:  # whatever it is, the level that was asked for is not open
        refused = {"what": f"the level cannot be opened: {error}", "where": str(job["start_map"] or ""), "todo": ""}
        channel.send(connection, json_line({"refused": refused}))
        unreal.SystemLibrary.quit_editor()
        return
    guard_levels()
    TickRunner(connection, job).begin()


def _open(job: dict[str, Any]) -> None:
    """Make the levels of the documents, then open the start map, or an empty level."""
    maps = unreal.EditorLoadingAndSavingUtils
    for path in job["levels"]:
        make_level(json.loads(Path(path).read_text(encoding="utf-8")))
    if job["start_map"] is None:
        maps.new_blank_map(False)
    elif maps.load_map(job["start_map"]) is None:
        raise ValueError("the editor did not open it")
    frame_level()
