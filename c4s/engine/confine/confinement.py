"""What the engine process does to itself before it runs anything else: limits, privileges, Landlock, system calls.

The host (``c4s.engine.confine.sandbox``) starts the process in an empty environment, under bubblewrap or bare; this
module closes the rest from inside, in one thread, before any agent code. It imports the standard library and two parts
of its own only.
"""

from __future__ import annotations

import ctypes
import os
import resource
import signal
import struct
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

from c4s.engine.confine import landlock, seccomp

Backend = Literal["bubblewrap", "landlock", "none"]
"""``none`` keeps the limits, and dies with the host; it hides nothing."""
_SET_PDEATHSIG, _CAPBSET_DROP, _SET_NO_NEW_PRIVS = 1, 24, 38
_CAP_AMBIENT, _CAP_AMBIENT_CLEAR_ALL = 47, 4
_CAPSET = {"x86_64": 126, "aarch64": 91}
_CAPABILITY_VERSION_3 = 0x20080522
_LAST_CAPABILITY = 63
_NO_CORE = 1
"""A limit of one byte: no core is written, and, unlike with 0, none is piped into a program of the system either."""


@dataclass(frozen=True)
class Limits:
    """Limits of one engine process. Sizes in bytes, CPU time in seconds over all its threads.

    The kernel enforces the first four; ``c4s.engine.confine.watch`` ends an engine that passes one of the others:
    resident memory, threads, number and size of its files (in all folders that it may write to, and without a name),
    and what it writes to the disk in its whole life.
    """

    address_space: int = 8 << 30
    cpu_s: int = 8 * 3600
    file_size: int = 256 << 20
    open_files: int = 256
    memory: int = 6 << 30
    threads: int = 256
    files: int = 20_000
    disk: int = 2 << 30
    written: int = 32 << 30


@dataclass(frozen=True)
class Confinement:
    """How the process confines itself: the backend that it runs under, what it may read and write, its limits."""

    backend: Backend
    parent: int
    read_only: tuple[str, ...]
    read_write: tuple[str, ...]
    limits: Limits

    @staticmethod
    def from_json(value: Mapping[str, Any]) -> Confinement:
        """From ``dataclasses.asdict`` read back from JSON."""
        return Confinement(
            value["backend"],
            value["parent"],
            tuple(value["read_only"]),
            tuple(value["read_write"]),
            Limits(**value["limits"]),
        )


def confine(rules: Confinement) -> None:
    """Confine this process for good. ``OSError`` when any part is refused: the caller must then end the process."""
    limits = rules.limits
    for name, value in (
        (resource.RLIMIT_AS, limits.address_space),
        (resource.RLIMIT_CPU, limits.cpu_s),
        (resource.RLIMIT_FSIZE, limits.file_size),
        (resource.RLIMIT_NOFILE, limits.open_files),
        (resource.RLIMIT_CORE, _NO_CORE),
    ):
        _limit(name, value)
    _prctl(_SET_NO_NEW_PRIVS, 1)
    if rules.backend != "bubblewrap":
        _die_with(rules.parent)
    if rules.backend == "none":
        return
    if rules.backend == "landlock":
        _drop_capabilities()
        landlock.restrict(map(Path, rules.read_only), map(Path, rules.read_write))
    seccomp.install(seccomp.filter_program())


def _limit(name: int, value: int) -> None:
    _, hard = resource.getrlimit(name)
    bound = value if hard == resource.RLIM_INFINITY else min(value, hard)
    resource.setrlimit(name, (bound, bound))


def _die_with(parent: int) -> None:
    """Be killed with the host thread that started this process; end at once when that has already died."""
    _prctl(_SET_PDEATHSIG, signal.SIGKILL)
    if os.getppid() != parent:
        raise OSError("the host process ended while the engine was starting")


def _drop_capabilities() -> None:
    """Give up every capability, so that a host that runs as root lends the engine nothing but its user id."""
    _prctl(_CAP_AMBIENT, _CAP_AMBIENT_CLEAR_ALL)
    libc = ctypes.CDLL(None, use_errno=True)
    for capability in range(_LAST_CAPABILITY + 1):
        libc.prctl(_CAPBSET_DROP, capability, 0, 0, 0)
    header, nothing = struct.pack("Ii", _CAPABILITY_VERSION_3, 0), bytes(24)
    if libc.syscall(_CAPSET[os.uname().machine], header, nothing):
        raise OSError(ctypes.get_errno(), "cannot drop capabilities")


def _prctl(option: int, value: int) -> None:
    libc = ctypes.CDLL(None, use_errno=True)
    if libc.prctl(option, value, 0, 0, 0):
        raise OSError(ctypes.get_errno(), f"prctl {option}: {os.strerror(ctypes.get_errno())}")
