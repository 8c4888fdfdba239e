"""A worker process as its operator sees it: forked, given a job, watched, and ended with all its children."""

from __future__ import annotations

import asyncio
import os
import pickle
import select
import signal
import socket
import time
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from c4s.errors import MachineryFault, OverLimit
from c4s.folders import remove_tree
from c4s.run.forking import Template
from c4s.run.leftovers import owned_folder
from c4s.run.worker import HEADER

POLL_S = 0.25
START_TIMEOUT_S = 120.0
_END_S = 2.0
_PAGE = os.sysconf("SC_PAGE_SIZE")


class WorkerDied(MachineryFault):
    """A worker process ended in the middle of its job."""


@dataclass(eq=False)
class Process:
    """A worker process with the channel to it and a temporary folder of its own. One job at a time."""

    template: Template
    pid: int
    handle: int
    """An open file of the process, by which it is known whatever else gets its number."""
    reader: asyncio.StreamReader
    writer: asyncio.StreamWriter
    folder: Path

    @classmethod
    async def start(cls, template: Template) -> Process:
        """Have one forked and wait until it serves. It dies with the template."""
        near, far = socket.socketpair()
        folder = owned_folder()
        reader, writer = await asyncio.open_connection(sock=near)
        try:
            with far:
                template.fork(far)
            _write(writer, pickle.dumps(({**os.environ, "TMPDIR": str(folder)}, str(Path.cwd()))))
            async with asyncio.timeout(START_TIMEOUT_S):
                pid = pickle.loads(await _message(reader))
            if isinstance(pid, OSError):
                raise pid
            return cls(template, pid, os.pidfd_open(pid), reader, writer, folder)
        except BaseException as error:
            writer.close()
            remove_tree(folder, inside=folder.parent, at_best=True)
            if isinstance(error, asyncio.IncompleteReadError | ConnectionError | ProcessLookupError | TimeoutError):
                raise MachineryFault("a worker process did not start", todo="read what it printed") from None
            raise

    @property
    def alive(self) -> bool:
        """Whether the process runs."""
        return self.handle >= 0 and not _is_over(self.handle, 0)

    async def run(self, function: Callable[..., Any], arguments: tuple[Any, ...], seconds: float, memory: int) -> Any:
        """What the function returns, and the seconds that it took; what it raises is raised.

        The process is ended where it goes over its time or memory (bytes): ``OverLimit``. ``WorkerDied`` where it ends
        by itself.
        """
        job = pickle.dumps((pickle.dumps(function), pickle.dumps(arguments)))
        try:
            _write(self.writer, job)
            answer = await self._answer(seconds, memory)
        except (asyncio.IncompleteReadError, ConnectionError):
            raise WorkerDied(
                f"a worker process died ({await self._how()})", todo="run the same command again"
            ) from None
        except BaseException:
            self.end()
            raise
        returned, value, took = _read(answer)
        if not returned:
            raise value
        return value, took

    async def _answer(self, seconds: float, memory: int) -> bytes:
        reading = asyncio.ensure_future(_message(self.reader))
        deadline = time.monotonic() + seconds
        try:
            while not reading.done():
                await asyncio.wait((reading,), timeout=max(0.0, min(POLL_S, deadline - time.monotonic())))
                if reading.done():
                    break
                if time.monotonic() >= deadline:
                    raise OverLimit(f"it took longer than {seconds:g} s")
                if self._resident() > memory:
                    raise OverLimit(f"it used more than {memory >> 20} MiB of memory")
            return reading.result()
        finally:
            reading.cancel()

    def _resident(self) -> int:
        """Resident memory in bytes; none for a process that has just ended."""
        try:
            return int(Path("/proc", str(self.pid), "statm").read_text().split()[1]) * _PAGE
        except (OSError, IndexError):
            return 0

    async def _how(self) -> str:
        """How it ended; one that has only let go of its channel is ended."""
        deadline = time.monotonic() + _END_S
        while self.alive and time.monotonic() < deadline:
            await asyncio.sleep(0.01)
        self.end()
        while (code := self.template.exit_code(self.pid)) is None and time.monotonic() < deadline:
            await asyncio.sleep(0.01)
        if code is None:
            return "nobody was told how"
        return signal.Signals(-code).name if code < 0 else f"exit code {code}"

    def end(self) -> None:
        """End the process and all below it, and remove its temporary folder."""
        if self.handle < 0:
            return
        family = _family(self.pid) if self.alive else []
        with suppress(ProcessLookupError):
            signal.pidfd_send_signal(self.handle, signal.SIGKILL)
        for member in family[1:]:
            with suppress(ProcessLookupError):
                os.kill(member, signal.SIGKILL)
        _is_over(self.handle, None)
        os.close(self.handle)
        self.handle = -1
        self.writer.close()
        remove_tree(self.folder, inside=self.folder.parent, at_best=True)


def _is_over(handle: int, wait_ms: int | None) -> bool:
    """Whether a process has ended, once so long was waited for it."""
    waiting = select.poll()
    waiting.register(handle, select.POLLIN)
    return bool(waiting.poll(wait_ms))


def _write(writer: asyncio.StreamWriter, message: bytes) -> None:
    writer.write(HEADER.pack(len(message)) + message)


async def _message(reader: asyncio.StreamReader) -> bytes:
    header = await reader.readexactly(HEADER.size)
    return await reader.readexactly(HEADER.unpack(header)[0])


def _read(answer: bytes) -> Any:
    """A worker's answer. Reading it runs code of the classes in it, and any of that may fail: ``MachineryFault``."""
    try:
        return pickle.loads(answer)
    except Exception as error:
        raise MachineryFault(
            f"what a stage returned or raised cannot be read: {type(error).__name__}: {error}",
            todo="its class does not cross a process border: mend that first",
        ) from error


def _family(process: int) -> list[int]:
    """A process and all below it, parents first."""
    found = [process]
    for member in found:
        with suppress(OSError):
            for task in Path("/proc", str(member), "task").iterdir():
                found += [int(child) for child in (task / "children").read_text().split()]
    return found
