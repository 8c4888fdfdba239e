"""One real editor: started on a project of its own, watched, and ended with all that it started."""

from __future__ import annotations

import os
import select
import signal
import socket
import struct
import subprocess
import tempfile
import threading
import time
from collections.abc import Mapping
from contextlib import ExitStack, suppress
from pathlib import Path
from typing import Any, NamedTuple, Unpack

from c4s.engine.confine.confinement import Backend
from c4s.engine.confine.sandbox import Mounts
from c4s.engine.faults import EngineDied
from c4s.engine.host.joblog import JobLog
from c4s.engine.host.jobs import ENGINE_LOG
from c4s.engine.host.places import session_places
from c4s.engine.host.session import SOCKET, Session
from c4s.engine.inputs import EngineInputs
from c4s.engine.unreal.host import launch
from c4s.engine.unreal.host.crash import crash_report
from c4s.engine.unreal.host.harvest import Harvest
from c4s.engine.unreal.host.installation import find_installation
from c4s.engine.unreal.host.project import Project, make_project
from c4s.engine.unreal.host.slots import EditorSlot, take_slot
from c4s.errors import BadInput, MachineryFault
from c4s.folders import remove_tree
from c4s.home import cache_root

START = "C4S_UNREAL_START_S"
"""Environment variable: how long an editor may take until it serves (seconds); the first start compiles shaders."""
WARM = "C4S_UNREAL_WARM_S"
"""Environment variable: how long an editor ticks before it serves (seconds): pictures taken earlier are black."""
START_S, WARM_S = 300.0, 20.0
TICKS_A_SECOND = 20
"""Ticks that must have passed, for each second of warming up."""
_CHANNEL = "editor.sock"
_CHUNK = 1 << 18
_TAIL_BYTES = 4000
_END_S, _LOOK_S = 10.0, 0.25
_CREDENTIALS = struct.Struct("3i")


class Begun(NamedTuple):
    """An editor whose start script has connected."""

    process: subprocess.Popen[bytes]
    slot: EditorSlot
    life: int
    """The descriptor that its keeper lives by."""
    project: Project
    connection: socket.socket
    output: int
    mounts: Mounts
    sockets: Path
    log: JobLog


class EditorSession(Session):
    """One editor process with the keeper that ends what it starts."""

    def __init__(self, kind: str, begun: Begun, harvest: Harvest, bridge: socket.socket, sandbox: Backend) -> None:
        self.kind = kind
        self._slot, self._life, self._project, self._harvest = begun.slot, begun.life, begun.project, harvest
        self._letting_go = threading.Lock()
        super().__init__(
            begun.process,
            bridge,
            begun.connection,
            begun.output,
            begun.mounts,
            (begun.sockets, begun.log.path.parent),
            launch.LIMITS,
            sandbox,
            begun.log,
        )

    @classmethod
    def start(
        cls, kind: str, *, warming: bool = False, start_s: float | None = None, **given: Unpack[EngineInputs]
    ) -> EditorSession:
        """Start an editor and wait until it serves; see ``c4s.engine.open_engine``.

        It works in a project below ``scratch`` that holds copies of what lies in ``content``. The packages that it
        saves are copied out into ``content`` after each request, unless that is read-only; the rest is left behind.
        ``warming``: what it compiles is kept for all later editors; for one that runs no agent code. ``start_s``: how
        long it may take, in place of the environment's.
        """
        at = session_places(given)
        editor, sandbox = find_installation(kind), launch.choose()
        cache = derived_data(kind)
        for folder in (at.content, at.scratch, at.logs, cache):
            folder.mkdir(parents=True, exist_ok=True)
        warm_s = _seconds(WARM, WARM_S)
        with ExitStack() as undo:
            slot = take_slot()
            undo.callback(slot.give_back)
            sockets = Path(tempfile.mkdtemp(prefix="c4s-"))
            undo.callback(remove_tree, sockets, inside=sockets.parent)
            meeting = sockets / "meeting"
            meeting.mkdir()
            project = make_project(
                at.scratch / "project",
                editor,
                packs=at.packs,
                content=at.content,
                levels=at.levels,
                start_map=at.start_map,
                offered=at.offered,
                cache=cache,
                cache_read_only=not warming,
                job={
                    "kind": kind,
                    "channel": str(meeting / _CHANNEL),
                    "warm_s": warm_s,
                    "warm_ticks": int(warm_s * TICKS_A_SECOND),
                },
            )
            bridge, channel = (undo.enter_context(socket.socket(socket.AF_UNIX)) for _ in range(2))
            for listener, path in ((bridge, sockets / SOCKET), (channel, meeting / _CHANNEL)):
                listener.bind(str(path))
                listener.listen(64)
            output, writing = os.pipe()
            undo.callback(os.close, output)
            held, life = os.pipe()
            undo.callback(os.close, life)
            paths = Mounts(
                (editor.root, *at.packs, *launch.readable(), *(() if warming else (cache,))),
                (at.scratch, meeting, *((cache,) if warming else ())),
                at.scratch,
            )
            try:
                process = launch.start(
                    launch.command_line(editor, project, slot),
                    launch.environment(project, slot),
                    paths,
                    life=held,
                    output=writing,
                    use=sandbox,
                )
            finally:
                os.close(held)
                os.close(writing)
            undo.callback(_end_keeper, process, slot)
            until = time.monotonic() + (start_s or _seconds(START, START_S))
            log = JobLog(at.logs / ENGINE_LOG)
            near = _meet(channel, output, process, log, until, project)
            undo.pop_all()
        channel.close()
        begun = Begun(process, slot, life, project, near, output, paths, sockets, log)
        session = cls(kind, begun, Harvest(project, None if at.content_read_only else at.content), bridge, sandbox)
        try:
            session._wait_until_ready(max(0.0, until - time.monotonic()))
        except BaseException:
            session.kill()
            raise
        session._harvest.begin()
        return session

    def request(self, kind: str, params: Mapping[str, Any] | None = None, timeout_s: float = 300.0) -> dict[str, Any]:
        """One bridge request; what it saved lies in the content folder when it is answered."""
        try:
            return super().request(kind, params, timeout_s)
        finally:
            if kind != "editor_status":
                self._harvest.gather()

    def kill(self) -> None:
        """End the editor and all that it started at once, and give its slot back; its logs and packages are kept."""
        super().kill()
        self._slot.sweep()
        self._harvest.gather()
        self._harvest.close()
        self._project.clear_derived()
        self._slot.give_back()

    def _end_group(self) -> None:
        """Let the keeper end the editor with all that it started; where it does not, end both."""
        with self._letting_go:
            if self._life >= 0:
                os.close(self._life)
                self._life = -1
        _end_keeper(self._process, self._slot)

    def _end(self, at_once: bool) -> str:
        told = crash_report(self._project.crashes)
        return f"{super()._end(at_once)}{f', {told}' if told else ''}"


def derived_data(kind: str) -> Path:
    """The folder of derived data that all editors of this machine's version read."""
    return cache_root() / "unreal" / f"derived-{find_installation(kind).version}"


def _seconds(name: str, default: float) -> float:
    """A number of seconds of the environment."""
    try:
        told = float(os.environ.get(name) or default)
    except ValueError:
        told = -1.0
    if not 0 <= told < 1e6:
        raise BadInput(f"{os.environ[name]!a} is no number of seconds", where=name, todo="0 or more")
    return told


def _meet(
    channel: socket.socket, output: int, keeper: subprocess.Popen[bytes], log: JobLog, until: float, project: Project
) -> socket.socket:
    """Wait until the start script has connected; what the editor prints until then goes into the log.

    ``EngineDied`` when the editor ends first, ``MachineryFault`` when it is not there in time.
    """
    reading = [channel.fileno(), output]
    while True:
        ready, _, _ = select.select(reading, [], [], max(0.0, min(until - time.monotonic(), _LOOK_S)))
        if output in ready:
            data = os.read(output, _CHUNK)
            log.write(data)
            if not data:
                reading.remove(output)
        if channel.fileno() in ready:
            near, _ = channel.accept()
            credentials = near.getsockopt(socket.SOL_SOCKET, socket.SO_PEERCRED, _CREDENTIALS.size)
            if _CREDENTIALS.unpack(credentials)[1] == os.getuid():
                return near
            near.close()
        if keeper.poll() is not None and output not in reading:
            log.close()
            told = f"the editor ended with code {keeper.returncode} before it served"
            parts = (told, crash_report(project.crashes), log.tail(_TAIL_BYTES))
            raise EngineDied(" ".join(part for part in parts if part), during="start", where=str(log.path))
        if time.monotonic() >= until:
            log.close()
            raise MachineryFault(
                f"the editor did not run its start script in time; its log ends: {log.tail(_TAIL_BYTES)}",
                where=str(log.path),
                todo=f"{START} says how long it may take",
            )


def _end_keeper(keeper: subprocess.Popen[bytes], slot: EditorSlot) -> None:
    """Wait for a keeper that was let go of; one that does not end is killed with all that its slot started."""
    try:
        keeper.send_signal(signal.SIGTERM)
        keeper.wait(_END_S)
    except subprocess.TimeoutExpired:
        with suppress(ProcessLookupError):
            os.killpg(keeper.pid, signal.SIGKILL)
        slot.sweep()
