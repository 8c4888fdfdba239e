"""Landlock through ``ctypes``: what a process may read and write, enforced by the kernel without privileges.

ABI numbers and access bits: ``linux/landlock.h``. Landlock does not govern ``stat`` (names and sizes of files stay
visible), nor changes of mode, owner and times; the system-call filter turns those into no-ops.
"""

from __future__ import annotations

import ctypes
import os
import stat
import struct
from collections.abc import Iterable
from pathlib import Path

REQUIRED_ABI = 4
_CREATE, _ADD, _RESTRICT = 444, 445, 446
_EXECUTE, _WRITE_FILE, _READ_FILE, _READ_DIR = 1 << 0, 1 << 1, 1 << 2, 1 << 3
_MAKE_CHAR, _MAKE_SOCK, _MAKE_FIFO, _MAKE_BLOCK = 1 << 6, 1 << 9, 1 << 10, 1 << 11
_REFER, _TRUNCATE, _IOCTL_DEV = 1 << 13, 1 << 14, 1 << 15
_FILE_RIGHTS = _EXECUTE | _WRITE_FILE | _READ_FILE | _TRUNCATE | _IOCTL_DEV
_NET_TCP = 0b11
_SCOPE_ALL = 0b11
_PATH_RULE = 1
DEVICES = ("/dev/null", "/dev/zero", "/dev/urandom", "/dev/random")


def abi() -> int:
    """The kernel's Landlock ABI; 0 when there is none."""
    return max(0, int(ctypes.CDLL(None, use_errno=True).syscall(_CREATE, None, 0, 1)))


def restrict(
    read_only: Iterable[Path],
    read_write: Iterable[Path],
    *,
    programs: Iterable[Path] = (),
    devices: Iterable[Path] = (),
) -> None:
    """Restrict this thread, and all that it starts, to these paths. Needs ``no_new_privs``. ``OSError`` on refusal.

    What lies in ``programs`` may be executed too, in ``devices`` driven. A path that does not exist grants nothing.
    """
    version = abi()
    handled = (1 << 13) - 1
    for bit, since in ((_REFER, 2), (_TRUNCATE, 3), (_IOCTL_DEV, 5)):
        handled |= bit if version >= since else 0
    words = [handled, _NET_TCP] + ([_SCOPE_ALL] if version >= 6 else [])
    attributes = struct.pack(f"{len(words)}Q", *words)
    ruleset = _call(_CREATE, attributes, len(attributes), 0)
    writable = handled & ~(_EXECUTE | _MAKE_CHAR | _MAKE_SOCK | _MAKE_FIFO | _MAKE_BLOCK | _IOCTL_DEV)
    rules = [(path, _READ_FILE | _READ_DIR) for path in read_only] + [(path, writable) for path in read_write]
    rules += [(Path(device), _READ_FILE | _WRITE_FILE) for device in DEVICES]
    rules += [(path, _READ_FILE | _READ_DIR | _EXECUTE) for path in programs]
    rules += [(path, _READ_FILE | _READ_DIR | _WRITE_FILE | _IOCTL_DEV) for path in devices]
    for path, rights in rules:
        if path.exists():
            _allow(ruleset, path, rights & handled)
    _call(_RESTRICT, ruleset, 0)
    os.close(ruleset)


def _allow(ruleset: int, path: Path, rights: int) -> None:
    handle = os.open(path, os.O_PATH | os.O_CLOEXEC)
    try:
        if not stat.S_ISDIR(os.fstat(handle).st_mode):
            rights &= _FILE_RIGHTS
        _call(_ADD, ruleset, _PATH_RULE, struct.pack("=Qi", rights, handle), 0)
    finally:
        os.close(handle)


def _call(number: int, *arguments: int | bytes) -> int:
    result = ctypes.CDLL(None, use_errno=True).syscall(number, *arguments)
    if result < 0:
        raise OSError(ctypes.get_errno(), f"landlock: {os.strerror(ctypes.get_errno())}")
    return int(result)
