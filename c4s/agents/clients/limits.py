"""How much of the machine a client may use, and the watch over it.

The kernel keeps what it can for one process (``inside.py`` sets it); the sum over a client and all that it starts is
watched from outside. Address space is not limited: Node and other runtimes reserve far more than they use.
"""

from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path

from c4s.engine.confine.confinement import Limits
from c4s.engine.confine.watch import hidden_bytes, overfull, tree

_PAGE = os.sysconf("SC_PAGE_SIZE")
_TICKS = os.sysconf("SC_CLK_TCK")
LOOKS_A_DISK_LOOK = 10
"""Looks at memory, threads and CPU for one at the files, of which there can be many."""


@dataclass(frozen=True)
class ClientLimits:
    """Limits of a client with all that it starts. Sizes in bytes, CPU time in seconds.

    The kernel enforces those of one process: ``data`` (writable memory of its own), ``file_size``, ``open_files`` and
    ``cpu_s``; where the host does not run as root it also stops at twice the ``threads``, whatever happens between two
    looks. ``temporary`` bounds each file system in memory that the client may write to.
    """

    memory: int = 6 << 30
    threads: int = 1024
    cpu_s: int = 2 * 3600
    files: int = 100_000
    disk: int = 4 << 30
    data: int = 8 << 30
    file_size: int = 1 << 30
    open_files: int = 4096
    temporary: int = 1 << 30


class ClientWatch:
    """Looks at a client's process, with all below it, and at its HOME."""

    def __init__(self, process: int, home: Path, limits: ClientLimits) -> None:
        self._process, self._home, self._limits, self._looks = process, home, limits, 0

    def breach(self) -> str | None:
        """The first limit that is passed, as text; None while all are kept."""
        limits = self._limits
        memory = threads = ticks = hidden = 0
        self._looks += 1
        disk_look = self._looks % LOOKS_A_DISK_LOOK == 0
        for folder in tree(self._process, limits.threads):
            try:
                memory += int((folder / "statm").read_text().split()[1]) * _PAGE
                fields = (folder / "stat").read_text().rpartition(")")[2].split()
            except (FileNotFoundError, ProcessLookupError):
                continue  # it has just ended
            ticks += sum(map(int, fields[11:15]))
            threads += int(fields[17])
            hidden += hidden_bytes(folder) if disk_look else 0
        if memory > limits.memory:
            return f"it used more than {limits.memory >> 20} MiB of memory"
        if threads > limits.threads:
            return f"it started more than {limits.threads} processes and threads"
        if ticks > limits.cpu_s * _TICKS:
            return f"it used more than {limits.cpu_s} s of CPU time"
        if disk_look:
            return overfull([self._home], Limits(files=limits.files, disk=limits.disk), hidden)
        return None
