"""Jobs for worker processes that go wrong, in a module that takes no time to import."""

from __future__ import annotations

import errno
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import NoReturn

from c4s.engine.bridge import BridgeFault
from c4s.errors import BadInput


def note_process(path: Path, then: str) -> None:
    """Write down which process ran this; then go wrong."""
    with path.open("a") as told:
        told.write(f"{os.getpid()}\n")
    held = []
    while then == "loop":
        pass
    while then == "grow":
        held.append(bytearray(b"1" * (16 << 20)))
    if then == "die":
        os.kill(os.getpid(), signal.SIGKILL)
    if then == "leave":
        sys.exit(7)
    if then == "unlock":
        raise ValueError("an error of no kind")


def child_that_stays(path: Path) -> None:
    """Start a child in a session of its own, as an engine is, and do not end."""
    child = subprocess.Popen([sys.executable, "-c", "import time; time.sleep(600)"], start_new_session=True)
    path.write_text(str(child.pid))
    child.wait()


def refuse() -> NoReturn:
    raise BadInput("not this", where="here", todo="that")


def engine_that_grows(folder: Path) -> None:
    """An engine that takes more memory than it may have."""
    from c4s.engine.confine.confinement import Limits
    from c4s.engine.headless.host.session import EngineSession

    with EngineSession.start(
        packs=[], content=folder / "content", scratch=folder / "scratch", limits=Limits(memory=512 << 20)
    ) as engine:
        with (folder / "pids").open("a") as told:
            told.write(f"{os.getpid()}\n")
        engine.execute("import time\nheld = bytearray(b'1' * (600 << 20))\ntime.sleep(60)")


def sweep_temporary() -> str:
    """Remove this process's temporary folder, as a cleaner of old files does; returns its path."""
    folder = tempfile.gettempdir()
    shutil.rmtree(folder)
    return folder


def make_temporary() -> str:
    """Use the temporary folder; returns its path."""
    with tempfile.TemporaryDirectory() as made:
        return str(Path(made).parent)


def child_without_parent(path: Path) -> None:
    """Leave a process behind whose parent has ended, and do not end."""
    told = subprocess.run(
        ["setsid", "sh", "-c", "sleep 600 >/dev/null 2>&1 & echo $!"], capture_output=True, check=True
    )
    path.write_text(told.stdout.decode())
    while True:
        pass


def note_and_raise(path: Path, error: BaseException) -> NoReturn:
    """Write down which process ran this; then raise."""
    with path.open("a") as told:
        told.write(f"{os.getpid()}\n")
    raise error


def fill_the_disk(path: Path) -> NoReturn:
    """Find the disk full behind another error, as a bridge does."""
    try:
        note_and_raise(path, OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), str(path)))
    except OSError as full:
        raise BridgeFault("cannot reach the engine") from full


class _ReadHere:
    """Is read by any process but one."""

    def __init__(self, parent: int) -> None:
        self.parent = parent

    def __reduce__(self) -> tuple[object, ...]:
        return _read, (self.parent,)


def _read(parent: int) -> _ReadHere:
    if os.getpid() == parent:
        raise RuntimeError("not here")
    return _ReadHere(parent)


class _Unreadable(Exception):
    """An error that holds such a thing."""


def fail_to_be_read(parent: int, returned: bool) -> _ReadHere:
    """Return or raise what this process can read again, and its parent cannot."""
    if returned:
        return _ReadHere(parent)
    raise _Unreadable(_ReadHere(parent))


def take_state() -> tuple[list[str], float]:
    """What jobs of other processes left in this module, and a number by chance; leave something."""
    found = list(_LEFT)
    _LEFT.append("a job was here")
    return found, random.random()


def open_files() -> list[str]:
    """What this process has open."""
    return [str(link.readlink()) for link in Path("/proc/self/fd").iterdir() if link.is_symlink()]


_LEFT: list[str] = []
