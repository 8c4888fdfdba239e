"""Slots for editors on one machine: each has a number, a GPU, and no process that an earlier editor left."""

from __future__ import annotations

import fcntl
import os
import signal
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import TextIO

from c4s.errors import MachineryFault
from c4s.home import cache_root

GPUS = "C4S_UNREAL_GPUS"
"""Environment variable: GPUs of this machine, ``0,1``; the slots take them in turn. Default: CUDA_VISIBLE_DEVICES."""
CUDA = "CUDA_VISIBLE_DEVICES"
MARK = "C4S_UNREAL_SLOT"
"""Environment variable of every process that an editor's slot started: the slot's lock file."""
MOST = 64


@dataclass
class EditorSlot:
    """A slot that is held, by this process alone, until it is given back."""

    number: int
    gpu: str
    """The GPU's number; empty where none was named."""
    mark: str
    _lock: TextIO

    def sweep(self) -> int:
        """Kill what runs under this slot's mark and is not ours to wait for; how many were found."""
        return sum(_end(process, self.mark) for process in Path("/proc").iterdir() if process.name.isdigit())

    def give_back(self) -> None:
        """Let another have it."""
        self._lock.close()


def take_slot() -> EditorSlot:
    """The first slot that is free, swept. ``MachineryFault`` when all are held."""
    folder = cache_root() / "unreal" / "slots"
    folder.mkdir(parents=True, exist_ok=True)
    gpus = [gpu.strip() for gpu in (os.environ.get(GPUS) or os.environ.get(CUDA, "")).split(",") if gpu.strip()]
    for number in range(MOST):
        path = folder / f"{number}.lock"
        lock = path.open("a", encoding="utf-8")
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            lock.close()
            continue
        slot = EditorSlot(number, gpus[number % len(gpus)] if gpus else "", str(path.resolve()), lock)
        slot.sweep()
        return slot
    raise MachineryFault(f"{MOST} editors run here already", where=str(folder), todo="run fewer slots")


def _end(process: Path, mark: str) -> bool:
    """Kill a process that has the mark in its environment."""
    try:
        marked = f"{MARK}={mark}\0".encode() in (process / "environ").read_bytes() + b"\0"
    except OSError:
        return False  # it has just ended, or is another user's
    if marked:
        with suppress(ProcessLookupError):
            os.kill(int(process.name), signal.SIGKILL)
    return marked
