"""Which process something belongs to, and whether that process is still there."""

from __future__ import annotations

import os
import platform
from pathlib import Path

from c4s.records.lease import Owner

_BOOT = Path("/proc/sys/kernel/random/boot_id")
_START_FIELD, _STATE_FIELD = 19, 0
"""Of ``/proc/<pid>/stat``, counted after the program's name."""


def this_process() -> Owner:
    """The process that asks."""
    return owner_of(os.getpid())


def owner_of(pid: int) -> Owner:
    """A process of this process's own numbering."""
    return Owner(
        host=platform.node(),
        boot_id=_BOOT.read_text().strip(),
        pid_namespace=_namespace(),
        pid=pid,
        started_ticks=_started(pid) or 0,
    )


def is_near(owner: Owner) -> bool:
    """Whether the owner's number is one of this process's own numbering, so that ``is_gone`` can tell."""
    return (owner.boot_id, owner.pid_namespace) == (_BOOT.read_text().strip(), _namespace())


def is_gone(owner: Owner) -> bool:
    """Whether a near owner has ended."""
    return _started(owner.pid) != owner.started_ticks


def _namespace() -> str:
    return str(Path("/proc/self/ns/pid").readlink())


def _started(pid: int) -> int | None:
    """When a process started; None where there is none that runs."""
    try:
        fields = Path("/proc", str(pid), "stat").read_text().rpartition(")")[2].split()
    except OSError:
        return None
    return None if fields[_STATE_FIELD] in "ZX" else int(fields[_START_FIELD])
