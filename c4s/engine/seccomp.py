"""The system-call filter of the engine process: classic BPF, built in plain Python, for x86-64 and AArch64.

The filter refuses what a scene script never needs: sockets of any kind, new processes and programs, signals to
others, tracing, namespaces, mounts, keys, kernel modules, shared memory. It is a list of refusals on top of a mount
namespace or Landlock, which already decide what the file system shows; threads stay allowed. Links and special files
are refused too: a host that copies a submission must never follow one to a file that the engine cannot see.
System-call numbers: the kernel's ``syscall_64.tbl`` and ``asm-generic/unistd.h``.
"""

from __future__ import annotations

import ctypes
import errno
import os
import platform
import struct
from typing import NamedTuple

_ALLOW, _KILL, _ERRNO = 0x7FFF0000, 0x80000000, 0x00050000
_LOAD, _EQUAL, _AT_LEAST, _HAS_BITS, _RETURN = 0x20, 0x15, 0x35, 0x45, 0x06
_NUMBER_OFFSET, _ARCH_OFFSET, _ARG0_OFFSET = 0, 4, 16
_CLONE_THREAD = 0x00010000
_X32_BIT = 0x40000000
_SET_SECCOMP, _FILTER_MODE = 22, 2

_COMMON = {
    "clone3": 435, "pidfd_send_signal": 424, "io_uring_setup": 425, "io_uring_enter": 426, "io_uring_register": 427,
    "open_tree": 428, "move_mount": 429, "fsopen": 430, "fsconfig": 431, "fsmount": 432, "pidfd_open": 434,
    "pidfd_getfd": 438, "process_madvise": 440, "mount_setattr": 442, "fchmodat2": 452, "setxattrat": 463,
    "removexattrat": 466, "file_setattr": 469,
}
_X86_64 = _COMMON | {
    "socket": 41, "connect": 42, "bind": 49, "listen": 50, "socketpair": 53, "clone": 56, "fork": 57, "vfork": 58,
    "execve": 59, "execveat": 322, "kill": 62, "tkill": 200, "tgkill": 234, "rt_sigqueueinfo": 129,
    "rt_tgsigqueueinfo": 297, "ptrace": 101, "setpgid": 109, "setsid": 112, "pivot_root": 155, "chroot": 161,
    "mount": 165, "umount2": 166, "swapon": 167, "reboot": 169, "init_module": 175, "finit_module": 313,
    "kexec_load": 246,
    "add_key": 248, "request_key": 249, "keyctl": 250, "unshare": 272, "setns": 308, "perf_event_open": 298,
    "name_to_handle_at": 303, "open_by_handle_at": 304, "process_vm_readv": 310, "process_vm_writev": 311, "kcmp": 312,
    "bpf": 321, "userfaultfd": 323, "shmget": 29, "shmat": 30, "semget": 64, "msgget": 68, "mq_open": 240,
    "link": 86, "linkat": 265, "symlink": 88, "symlinkat": 266, "mknod": 133, "mknodat": 259,
    "setpriority": 141, "sched_setparam": 142, "sched_setscheduler": 144, "sched_setattr": 314,
    "sched_setaffinity": 203, "prlimit64": 302,
    "chmod": 90, "fchmod": 91, "fchmodat": 268, "chown": 92, "fchown": 93, "lchown": 94, "fchownat": 260, "utime": 132,
    "utimes": 235, "futimesat": 261, "utimensat": 280, "setxattr": 188, "lsetxattr": 189, "fsetxattr": 190,
    "removexattr": 197, "lremovexattr": 198, "fremovexattr": 199,
}
_AARCH64 = _COMMON | {
    "socket": 198, "socketpair": 199, "bind": 200, "listen": 201, "connect": 203, "clone": 220, "execve": 221,
    "execveat": 281, "kill": 129, "tkill": 130, "tgkill": 131, "rt_sigqueueinfo": 138, "rt_tgsigqueueinfo": 240,
    "ptrace": 117, "setpgid": 154, "setsid": 157, "pivot_root": 41, "chroot": 51, "mount": 40, "umount2": 39,
    "swapon": 224, "reboot": 142, "init_module": 105, "finit_module": 273, "kexec_load": 104,
    "add_key": 217, "request_key": 218,
    "keyctl": 219, "unshare": 97, "setns": 268, "perf_event_open": 241, "name_to_handle_at": 264,
    "open_by_handle_at": 265, "process_vm_readv": 270, "process_vm_writev": 271, "kcmp": 272, "bpf": 280,
    "userfaultfd": 282, "shmget": 194, "shmat": 196, "semget": 190, "msgget": 186, "mq_open": 180,
    "linkat": 37, "symlinkat": 36, "mknodat": 33, "setpriority": 140,
    "sched_setparam": 118, "sched_setscheduler": 119, "sched_setattr": 274, "sched_setaffinity": 122, "prlimit64": 261,
    "fchmod": 52, "fchmodat": 53, "fchownat": 54, "fchown": 55, "utimensat": 88, "setxattr": 5, "lsetxattr": 6,
    "fsetxattr": 7, "removexattr": 14, "lremovexattr": 15, "fremovexattr": 16,
}
_METADATA = frozenset({
    "chmod", "fchmod", "fchmodat", "fchmodat2", "chown", "fchown", "lchown", "fchownat", "utime", "utimes", "futimesat",
    "utimensat", "setxattr", "lsetxattr", "fsetxattr", "removexattr", "lremovexattr", "fremovexattr", "setxattrat",
    "removexattrat", "file_setattr",
})
"""Calls that Landlock does not govern. Without a mount namespace they do nothing and report success."""
_OWN_PROCESS_ONLY = frozenset({"prlimit64", "sched_setaffinity"})
_PLATFORMS = {"x86_64": (0xC000003E, _X86_64), "aarch64": (0xC00000B7, _AARCH64)}


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


def filter_program(*, ignore_metadata: bool, machine: str | None = None) -> bytes:
    """The filter as ``struct sock_filter`` records.

    ``ignore_metadata``: changes of mode, owner, times and attributes become no-ops that report success, for hosts where
    no read-only mount protects files from them.
    """
    arch, numbers = _PLATFORMS[machine or platform.machine()]
    steps = [_Step(_LOAD, 0, 0, _ARCH_OFFSET), _Step(_EQUAL, 1, 0, arch), _Step(_RETURN, 0, 0, _KILL),
             _Step(_LOAD, 0, 0, _NUMBER_OFFSET)]
    if numbers is _X86_64:
        steps += [_Step(_AT_LEAST, 0, 1, _X32_BIT), _Step(_RETURN, 0, 0, _ERRNO | errno.EPERM)]
    for name, number in sorted(numbers.items()):
        if name in _METADATA:
            if ignore_metadata:
                steps += [_Step(_EQUAL, 0, 1, number), _Step(_RETURN, 0, 0, _ERRNO)]
        elif name == "clone":
            steps += _first_argument(number, _HAS_BITS, _CLONE_THREAD)
        elif name in _OWN_PROCESS_ONLY:
            steps += _first_argument(number, _EQUAL, 0)
        else:
            answer = errno.ENOSYS if name == "clone3" else errno.EPERM
            steps += [_Step(_EQUAL, 0, 1, number), _Step(_RETURN, 0, 0, _ERRNO | answer)]
    steps.append(_Step(_RETURN, 0, 0, _ALLOW))
    return b"".join(struct.pack("HBBI", *step) for step in steps)


def _first_argument(number: int, test: int, value: int) -> list[_Step]:
    """Allow a call only if its first argument passes ``test``."""
    return [_Step(_EQUAL, 0, 4, number), _Step(_LOAD, 0, 0, _ARG0_OFFSET), _Step(test, 0, 1, value),
            _Step(_RETURN, 0, 0, _ALLOW), _Step(_RETURN, 0, 0, _ERRNO | errno.EPERM)]


def install(program: bytes) -> None:
    """Put the calling thread, and all that it starts, under the filter. ``OSError`` when the kernel refuses."""
    libc = ctypes.CDLL(None, use_errno=True)
    buffer = ctypes.create_string_buffer(program, len(program))
    header = _Program(len(program) // 8, ctypes.addressof(buffer))
    if libc.prctl(_SET_SECCOMP, _FILTER_MODE, ctypes.byref(header), 0, 0):
        raise OSError(ctypes.get_errno(), "seccomp: " + os.strerror(ctypes.get_errno()))
