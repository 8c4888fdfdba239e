"""``c4s worker``: the processes that take a pool's work on this machine, watched by one.

An engine slot is a process of its own that takes one flow run at a time, with a GPU of its own where there are any. The
watching process ends with its terminal; what a worker leaves behind when it dies is ended, and the worker started anew.
"""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from types import FrameType
from typing import Final

from c4s.folders import remove_tree
from c4s.run.leftovers import owned_folder, sweep
from flows.family import TEMPORARY, WORKER, adopt
from flows.service.settings import environment

_LOOK_S: Final = 0.5
_END_S: Final = 20.0
"""How long workers may take to end what they do."""
_MOST_PAUSE_S: Final = 60.0
_GPUS: Final = Path("/proc/driver/nvidia/gpus")
_PROGRAM: Final = (
    "import asyncio, os, sys; from flows.family import die_with; die_with(int(sys.argv[1]))\n"
    "os.environ['C4S_WORKER'] = str(os.getpid())\n"
    "from flows.service.taking import taker\n"
    "asyncio.run(taker(sys.argv[2], sys.argv[3], int(sys.argv[4])).start())\n"
)


class _Stopped(Exception):
    """The worker was asked to end."""


def supervise(pool: str, slots: int, url: str, tell: Callable[[str], None]) -> None:
    """Take a pool's work until this process is asked to end (SIGTERM, SIGINT); then end all that was started."""
    adopt()
    signal.signal(signal.SIGTERM, _stop)
    signal.signal(signal.SIGINT, _stop)
    own = [1] * slots if pool == "engines" else [slots]
    sweep()
    scratch = owned_folder()
    started: dict[int, tuple[subprocess.Popen[bytes], float]] = {}
    pauses = dict.fromkeys(range(len(own)), 0.0)
    try:
        for number, limit in enumerate(own):
            started[number] = (_start(pool, number, limit, url, scratch), time.monotonic())
        tell(f"{slots} slot{'s' if slots > 1 else ''} of the pool {pool!r} wait for work from {url}")
        while True:
            time.sleep(_LOOK_S)
            for number, (process, since) in list(started.items()):
                if process.poll() is None:
                    continue
                _end_orphans({other.pid for other, _ in started.values()})
                lived = time.monotonic() - since
                pauses[number] = 0.0 if lived > _MOST_PAUSE_S else min(_MOST_PAUSE_S, 2 * pauses[number] + 1.0)
                tell(f"a worker of {pool!r} ended with {process.returncode}; started anew in {pauses[number]:.0f} s")
                time.sleep(pauses[number])
                started[number] = (_start(pool, number, own[number], url, scratch), time.monotonic())
    except _Stopped:
        tell(f"the workers of {pool!r} are ended")
    finally:
        _end([process for process, _ in started.values()])
        remove_tree(scratch, inside=scratch.parent, at_best=True)
        sweep()


def _start(pool: str, number: int, limit: int, url: str, scratch: Path) -> subprocess.Popen[bytes]:
    name = f"{pool}-{os.uname().nodename}-{os.getpid()}-{number}"
    made = environment(url) | {"TMPDIR": str(scratch), TEMPORARY: tempfile.gettempdir()}
    made.pop(WORKER, None)
    gpus = len(list(_GPUS.iterdir())) if _GPUS.is_dir() else 0
    if pool == "engines" and gpus:
        made.setdefault("CUDA_VISIBLE_DEVICES", str(number % gpus))
    return subprocess.Popen(
        [sys.executable, "-c", _PROGRAM, str(os.getpid()), pool, name, str(limit)],
        env=made,
        cwd="/",
        stdin=subprocess.DEVNULL,
        start_new_session=True,
    )


def _stop(number: int, frame: FrameType | None) -> None:
    signal.signal(signal.SIGTERM, signal.SIG_IGN)
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    raise _Stopped


def _end(workers: list[subprocess.Popen[bytes]]) -> None:
    """End the workers, what they run, and what that left behind."""
    for worker in workers:
        with suppress(ProcessLookupError):
            worker.kill()
    for worker in workers:
        worker.wait(_END_S)
    deadline = time.monotonic() + _END_S
    while _end_orphans(set()) and time.monotonic() < deadline:
        time.sleep(_LOOK_S / 10)


def _end_orphans(workers: set[int]) -> int:
    """End children of this process that are no workers: what a worker that died left behind. How many there were."""
    found = 0
    for task in Path("/proc/self/task").iterdir():
        for child in map(int, (task / "children").read_text().split()):
            if child in workers:
                continue
            found += 1
            with suppress(ProcessLookupError):
                os.kill(child, signal.SIGKILL)
            with suppress(ChildProcessError):
                os.waitpid(child, os.WNOHANG)
    return found
