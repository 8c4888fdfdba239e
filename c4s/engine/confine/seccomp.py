"""The system-call filter of the engine process: classic BPF, built in plain Python, for x86-64 and AArch64.

The filter refuses what a scene script never needs: sockets of any kind, new processes and programs, signals to
others, tracing, namespaces, mounts, keys, kernel modules, shared memory, outliving
the host. It is a list of refusals on top of a mount
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
from collections.abc import Sequence
from typing import NamedTuple

_ALLOW, _KILL, _ERRNO = 0x7FFF0000, 0x80000000, 0x00050000
_LOAD, _EQUAL, _AT_LEAST, _HAS_BITS, _RETURN = 0x20, 0x15, 0x35, 0x45, 0x06
_NUMBER_OFFSET, _ARCH_OFFSET, _ARGUMENTS_OFFSET = 0, 4, 16
_CLONE_THREAD = 0x00010000
_X32_BIT = 0x40000000
_SET_SECCOMP, _FILTER_MODE = 22, 2

_COMMON = {
    "clone3": 435,
    "pidfd_send_signal": 424,
    "io_uring_setup": 425,
    "io_uring_enter": 426,
    "io_uring_register": 427,
    "open_tree": 428,
    "move_mount": 429,
    "fsopen": 430,
    "fsconfig": 431,
    "fsmount": 432,
    "pidfd_open": 434,
    "pidfd_getfd": 438,
    "process_madvise": 440,
    "mount_setattr": 442,
    "fchmodat2": 452,
    "setxattrat": 463,
    "removexattrat": 466,
    "file_setattr": 469,
    "openat2": 437,
    "memfd_secret": 447,
    "quotactl_fd": 443,
    "map_shadow_stack": 453,
    "open_tree_attr": 467,
}
_X86_64 = _COMMON | {
    "socket": 41,
    "connect": 42,
    "accept": 43,
    "accept4": 288,
    "bind": 49,
    "listen": 50,
    "socketpair": 53,
    "clone": 56,
    "fork": 57,
    "vfork": 58,
    "execve": 59,
    "execveat": 322,
    "kill": 62,
    "tkill": 200,
    "tgkill": 234,
    "rt_sigqueueinfo": 129,
    "rt_tgsigqueueinfo": 297,
    "ptrace": 101,
    "setpgid": 109,
    "setsid": 112,
    "pivot_root": 155,
    "chroot": 161,
    "mount": 165,
    "umount2": 166,
    "swapon": 167,
    "reboot": 169,
    "init_module": 175,
    "finit_module": 313,
    "kexec_load": 246,
    "add_key": 248,
    "request_key": 249,
    "keyctl": 250,
    "unshare": 272,
    "setns": 308,
    "perf_event_open": 298,
    "name_to_handle_at": 303,
    "open_by_handle_at": 304,
    "process_vm_readv": 310,
    "process_vm_writev": 311,
    "kcmp": 312,
    "bpf": 321,
    "userfaultfd": 323,
    "shmget": 29,
    "shmat": 30,
    "semget": 64,
    "msgget": 68,
    "mq_open": 240,
    "link": 86,
    "linkat": 265,
    "symlink": 88,
    "symlinkat": 266,
    "mknod": 133,
    "mknodat": 259,
    "setpriority": 141,
    "sched_setparam": 142,
    "sched_setscheduler": 144,
    "sched_setattr": 314,
    "sched_setaffinity": 203,
    "prlimit64": 302,
    "chmod": 90,
    "fchmod": 91,
    "fchmodat": 268,
    "chown": 92,
    "fchown": 93,
    "lchown": 94,
    "fchownat": 260,
    "utime": 132,
    "utimes": 235,
    "futimesat": 261,
    "utimensat": 280,
    "setxattr": 188,
    "lsetxattr": 189,
    "fsetxattr": 190,
    "removexattr": 197,
    "lremovexattr": 198,
    "fremovexattr": 199,
    "memfd_create": 319,
    "fcntl": 72,
    "ioctl": 16,
    "prctl": 157,
    "open": 2,
    "creat": 85,
    "openat": 257,
    "acct": 163,
    "settimeofday": 164,
    "clock_settime": 227,
    "clock_adjtime": 305,
    "adjtimex": 159,
    "sethostname": 170,
    "setdomainname": 171,
    "iopl": 172,
    "ioperm": 173,
    "delete_module": 176,
    "quotactl": 179,
    "swapoff": 168,
    "syslog": 103,
    "vhangup": 153,
    "kexec_file_load": 320,
    "fanotify_init": 300,
    "move_pages": 279,
    "migrate_pages": 256,
    "modify_ldt": 154,
    "personality": 135,
    "mq_unlink": 241,
    "msgsnd": 69,
    "semop": 65,
    "shmctl": 31,
    "ioprio_set": 251,
    "setuid": 105,
    "setgid": 106,
    "setreuid": 113,
    "setregid": 114,
    "setgroups": 116,
    "setresuid": 117,
    "setresgid": 119,
    "setfsuid": 122,
    "setfsgid": 123,
    "capset": 126,
    "lookup_dcookie": 212,
}
_AARCH64 = _COMMON | {
    "socket": 198,
    "socketpair": 199,
    "bind": 200,
    "listen": 201,
    "accept": 202,
    "accept4": 242,
    "connect": 203,
    "clone": 220,
    "execve": 221,
    "execveat": 281,
    "kill": 129,
    "tkill": 130,
    "tgkill": 131,
    "rt_sigqueueinfo": 138,
    "rt_tgsigqueueinfo": 240,
    "ptrace": 117,
    "setpgid": 154,
    "setsid": 157,
    "pivot_root": 41,
    "chroot": 51,
    "mount": 40,
    "umount2": 39,
    "swapon": 224,
    "reboot": 142,
    "init_module": 105,
    "finit_module": 273,
    "kexec_load": 104,
    "add_key": 217,
    "request_key": 218,
    "keyctl": 219,
    "unshare": 97,
    "setns": 268,
    "perf_event_open": 241,
    "name_to_handle_at": 264,
    "open_by_handle_at": 265,
    "process_vm_readv": 270,
    "process_vm_writev": 271,
    "kcmp": 272,
    "bpf": 280,
    "userfaultfd": 282,
    "shmget": 194,
    "shmat": 196,
    "semget": 190,
    "msgget": 186,
    "mq_open": 180,
    "linkat": 37,
    "symlinkat": 36,
    "mknodat": 33,
    "setpriority": 140,
    "sched_setparam": 118,
    "sched_setscheduler": 119,
    "sched_setattr": 274,
    "sched_setaffinity": 122,
    "prlimit64": 261,
    "fchmod": 52,
    "fchmodat": 53,
    "fchownat": 54,
    "fchown": 55,
    "utimensat": 88,
    "setxattr": 5,
    "lsetxattr": 6,
    "fsetxattr": 7,
    "removexattr": 14,
    "lremovexattr": 15,
    "fremovexattr": 16,
    "memfd_create": 279,
    "fcntl": 25,
    "ioctl": 29,
    "prctl": 167,
    "openat": 56,
    "acct": 89,
    "settimeofday": 170,
    "clock_settime": 112,
    "clock_adjtime": 266,
    "adjtimex": 171,
    "sethostname": 161,
    "setdomainname": 162,
    "delete_module": 106,
    "quotactl": 60,
    "swapoff": 225,
    "syslog": 116,
    "vhangup": 58,
    "kexec_file_load": 294,
    "fanotify_init": 262,
    "move_pages": 239,
    "migrate_pages": 238,
    "personality": 92,
    "mq_unlink": 181,
    "msgsnd": 189,
    "semop": 193,
    "shmctl": 195,
    "ioprio_set": 30,
    "setuid": 146,
    "setgid": 144,
    "setreuid": 145,
    "setregid": 143,
    "setgroups": 159,
    "setresuid": 147,
    "setresgid": 149,
    "setfsuid": 151,
    "setfsgid": 152,
    "capset": 91,
    "lookup_dcookie": 18,
}
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
_OWN_PROCESS_ONLY = frozenset({"prlimit64", "sched_setaffinity"})
_SETUID_BITS = 0o6000
_CREATES = {"open": 2, "creat": 1, "openat": 3}
"""Position of the mode of a new file among the arguments."""
_REFUSED_VALUES = {
    "prctl": (0, (1, 4, 0x59616D61)),  # the signal at the host's death, being traced
    "fcntl": (1, (8, 10, 15)),  # F_SETOWN, F_SETSIG, F_SETOWN_EX: a signal to another process
    "ioctl": (1, (0x8901, 0x8902, 0x5410, 0x5412, 0x541C)),  # the same for sockets, and typing into a terminal
}
"""Calls of which some values of one argument (its position, the values) are refused."""
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


def filter_program(machine: str | None = None) -> bytes:
    """The filter as ``struct sock_filter`` records."""
    arch, numbers = _PLATFORMS[machine or platform.machine()]
    refused = _Step(_RETURN, 0, 0, _ERRNO | errno.EPERM)
    steps = [
        _Step(_LOAD, 0, 0, _ARCH_OFFSET),
        _Step(_EQUAL, 1, 0, arch),
        _Step(_RETURN, 0, 0, _KILL),
        _Step(_LOAD, 0, 0, _NUMBER_OFFSET),
    ]
    if numbers is _X86_64:
        steps += [_Step(_AT_LEAST, 0, 1, _X32_BIT), refused]
    for name, number in sorted(numbers.items()):
        if name in _METADATA:
            steps += [_Step(_EQUAL, 0, 1, number), _Step(_RETURN, 0, 0, _ERRNO)]
        elif name == "clone":
            steps += _argument(number, 0, [(_HAS_BITS, _CLONE_THREAD)], allowed=True)
        elif name in _OWN_PROCESS_ONLY:
            steps += _argument(number, 0, [(_EQUAL, 0)], allowed=True)
        elif name in _CREATES:
            steps += _argument(number, _CREATES[name], [(_HAS_BITS, _SETUID_BITS)], allowed=False)
        elif name in _REFUSED_VALUES:
            position, values = _REFUSED_VALUES[name]
            steps += _argument(number, position, [(_EQUAL, value) for value in values], allowed=False)
        else:
            answer = errno.ENOSYS if name in _UNKNOWN else errno.EPERM
            steps += [_Step(_EQUAL, 0, 1, number), _Step(_RETURN, 0, 0, _ERRNO | answer)]
    steps.append(_Step(_RETURN, 0, 0, _ALLOW))
    return b"".join(struct.pack("HBBI", *step) for step in steps)


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
