"""The system-call filter of the engine process: classic BPF, built in plain Python, for x86-64 and AArch64.

The filter refuses what a scene script never needs: sockets of any kind, new processes and programs, signals to
others, tracing, namespaces, mounts, keys, kernel modules, shared memory, reserving space, being told of changes
to files, outliving the host. It is a list of refusals on top of a mount
namespace or Landlock, which already decide what the file system shows; threads stay allowed. Links and special files
are refused too: a host that copies a submission must never follow one to a file that the engine cannot see.
"""

from __future__ import annotations

import ctypes
import errno
import os
import platform
import struct
from collections.abc import Mapping, Sequence
from typing import NamedTuple

from c4s.engine.confine.call_numbers import AARCH64, COMMON, LAST_KNOWN, X86_64

_ALLOW, _KILL, _ERRNO = 0x7FFF0000, 0x80000000, 0x00050000
_LOAD, _EQUAL, _AT_LEAST, _HAS_BITS, _RETURN = 0x20, 0x15, 0x35, 0x45, 0x06
_NUMBER_OFFSET, _ARCH_OFFSET, _ARGUMENTS_OFFSET = 0, 4, 16
_CLONE_THREAD = 0x00010000
_X32_BIT = 0x40000000
_SET_SECCOMP, _FILTER_MODE = 22, 2

_METADATA = frozenset(
    {
        "chmod",
        "fchmod",
        "fchmodat",
        "fchmodat2",
        "chown",
        "fchown",
        "lchown",
        "fchownat",
        "utime",
        "utimes",
        "futimesat",
        "utimensat",
        "setxattr",
        "lsetxattr",
        "fsetxattr",
        "removexattr",
        "lremovexattr",
        "fremovexattr",
        "setxattrat",
        "removexattrat",
        "file_setattr",
    }
)
"""Changes of mode, owner, times and attributes do nothing and report success: Landlock does not govern them, and a
file that the engine leaves behind must not be hidden from the host or run with the host's rights."""
_UNKNOWN = frozenset({"clone3", "openat2"})
"""Calls whose arguments a filter cannot read: they are said not to exist, and libraries use the older ones."""
_UNSUPPORTED = frozenset({"fallocate"})
"""Said to be what the file system does not do: it takes space faster than any watch can look, and past the limit of a
file's size. C libraries write instead."""
_OWN_PROCESS_ONLY = frozenset({"prlimit64", "sched_setaffinity"})
_SETUID_BITS = 0o6000
_CREATES = {"open": 2, "creat": 1, "openat": 3}
"""Position of the mode of a new file among the arguments."""
_REFUSED_VALUES: dict[str, tuple[int, tuple[int, ...]]] = {
    "prctl": (0, (1, 4, 0x59616D61)),  # the signal at the host's death, being traced
    "fcntl": (1, (8, 10, 15)),  # F_SETOWN, F_SETSIG, F_SETOWN_EX: a signal to another process
}
"""Calls of which some values of one argument (its position, the values) are refused."""
_TERMINAL_SIZE, _TERMINAL_STATE, _NOT_BLOCKING, _UNREAD, _NOT_AT_EXEC, _AT_EXEC = (
    0x5413,
    0x5401,
    0x5421,
    0x541B,
    0x5451,
    0x5450,
)
_ALLOWED_VALUES: dict[str, tuple[int, tuple[int, ...]]] = {
    "ioctl": (1, (_TERMINAL_SIZE, _TERMINAL_STATE, _NOT_BLOCKING, _UNREAD, _NOT_AT_EXEC, _AT_EXEC))
}
"""Calls of which some values of one argument alone are allowed. The others of ``ioctl`` type into a terminal, reserve
space, change a file's flags, steer devices."""
_CLIENT_REFUSED = frozenset(
    {name for name in COMMON if name.startswith("io_uring")}
    | {"open_tree", "move_mount", "fsopen", "fsconfig", "fsmount", "mount_setattr", "open_tree_attr", "pidfd_getfd"}
    | {
        "mount",
        "umount2",
        "pivot_root",
        "chroot",
        "unshare",
        "setns",
        "swapon",
        "swapoff",
        "reboot",
        "acct",
        "quotactl",
    }
    | {
        "init_module",
        "finit_module",
        "delete_module",
        "kexec_load",
        "kexec_file_load",
        "bpf",
        "perf_event_open",
        "syslog",
    }
    | {"userfaultfd", "add_key", "request_key", "keyctl", "ptrace", "process_vm_readv", "process_vm_writev", "kcmp"}
    | {"name_to_handle_at", "open_by_handle_at", "fanotify_init", "settimeofday", "clock_settime", "clock_adjtime"}
    | {"adjtimex", "iopl", "ioperm", "modify_ldt", "vhangup", "lookup_dcookie", "quotactl_fd", "move_pages"}
)
"""What no agent client needs. It may open sockets (its network has nothing on it) and start programs."""
_CLIENT_IOCTLS = (0x40305828, 0x4030582A, 0x40305839, 0x5412, 0x541C)
"""Reserving space, typing into a terminal."""
_PLATFORMS = {"x86_64": (0xC000003E, X86_64), "aarch64": (0xC00000B7, AARCH64)}


class _Program(ctypes.Structure):
    _fields_ = (("length", ctypes.c_ushort), ("filter", ctypes.c_void_p))


class _Step(NamedTuple):
    code: int
    if_true: int
    if_false: int
    value: int


def supported() -> bool:
    """Whether the filter is known for this processor."""
    return platform.machine() in _PLATFORMS


def filter_program(machine: str | None = None) -> bytes:
    """The filter as ``struct sock_filter`` records."""
    arch, numbers = _PLATFORMS[machine or platform.machine()]
    steps = _opening(arch, numbers)
    for name, number in sorted(numbers.items()):
        if name in _METADATA:
            steps += [_Step(_EQUAL, 0, 1, number), _Step(_RETURN, 0, 0, _ERRNO)]
        elif name == "clone":
            steps += _argument(number, 0, [(_HAS_BITS, _CLONE_THREAD)], allowed=True)
        elif name in _OWN_PROCESS_ONLY:
            steps += _argument(number, 0, [(_EQUAL, 0)], allowed=True)
        elif name in _CREATES:
            steps += _argument(number, _CREATES[name], [(_HAS_BITS, _SETUID_BITS)], allowed=False)
        elif name in _ALLOWED_VALUES:
            position, values = _ALLOWED_VALUES[name]
            steps += _argument(number, position, [(_EQUAL, value) for value in values], allowed=True)
        elif name in _REFUSED_VALUES:
            position, values = _REFUSED_VALUES[name]
            steps += _argument(number, position, [(_EQUAL, value) for value in values], allowed=False)
        else:
            answer = errno.ENOSYS if name in _UNKNOWN else errno.EOPNOTSUPP if name in _UNSUPPORTED else errno.EPERM
            steps += [_Step(_EQUAL, 0, 1, number), _Step(_RETURN, 0, 0, _ERRNO | answer)]
    return _closed(steps)


def client_program(machine: str | None = None) -> bytes:
    """The filter of an agent client's processes, which bubblewrap installs, as ``struct sock_filter`` records."""
    arch, numbers = _PLATFORMS[machine or platform.machine()]
    steps = _opening(arch, numbers)
    for name, number in sorted(numbers.items()):
        if name in _CLIENT_REFUSED:
            steps += [_Step(_EQUAL, 0, 1, number), _Step(_RETURN, 0, 0, _ERRNO | errno.EPERM)]
        elif name in _UNSUPPORTED:
            steps += [_Step(_EQUAL, 0, 1, number), _Step(_RETURN, 0, 0, _ERRNO | errno.EOPNOTSUPP)]
        elif name == "ioctl":
            steps += _argument(number, 1, [(_EQUAL, value) for value in _CLIENT_IOCTLS], allowed=False)
    return _closed(steps)


def _opening(arch: int, numbers: Mapping[str, int]) -> list[_Step]:
    """The steps that refuse calls of other processors, of the x32 kind, and newer than the list; then the number."""
    steps = [
        _Step(_LOAD, 0, 0, _ARCH_OFFSET),
        _Step(_EQUAL, 1, 0, arch),
        _Step(_RETURN, 0, 0, _KILL),
        _Step(_LOAD, 0, 0, _NUMBER_OFFSET),
    ]
    if numbers is X86_64:
        steps += [_Step(_AT_LEAST, 0, 1, _X32_BIT), _Step(_RETURN, 0, 0, _ERRNO | errno.EPERM)]
    return [*steps, _Step(_AT_LEAST, 0, 1, LAST_KNOWN + 1), _Step(_RETURN, 0, 0, _ERRNO | errno.ENOSYS)]


def _closed(steps: Sequence[_Step]) -> bytes:
    """The program: what no step has decided is allowed."""
    return b"".join(struct.pack("HBBI", *step) for step in (*steps, _Step(_RETURN, 0, 0, _ALLOW)))


def _argument(number: int, position: int, tests: Sequence[tuple[int, int]], *, allowed: bool) -> list[_Step]:
    """The steps for a call that is allowed (or refused) exactly if an argument passes one of the tests."""
    verdicts = [_Step(_RETURN, 0, 0, _ERRNO | errno.EPERM), _Step(_RETURN, 0, 0, _ALLOW)]
    hit, missed = (verdicts[1], verdicts[0]) if allowed else (verdicts[0], verdicts[1])
    found = [_Step(test, len(tests) - index, 0, value) for index, (test, value) in enumerate(tests)]
    body = [_Step(_LOAD, 0, 0, _ARGUMENTS_OFFSET + 8 * position), *found, missed, hit]
    return [_Step(_EQUAL, 0, len(body), number), *body]


def install(program: bytes) -> None:
    """Put the calling thread, and all that it starts, under the filter. ``OSError`` when the kernel refuses."""
    libc = ctypes.CDLL(None, use_errno=True)
    buffer = ctypes.create_string_buffer(program, len(program))
    header = _Program(len(program) // 8, ctypes.addressof(buffer))
    if libc.prctl(_SET_SECCOMP, _FILTER_MODE, ctypes.byref(header), 0, 0):
        raise OSError(ctypes.get_errno(), "seccomp: " + os.strerror(ctypes.get_errno()))
