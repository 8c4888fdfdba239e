"""The filter as the kernel would run it, for both processors: an interpreter of the BPF that it consists of."""

from __future__ import annotations

import errno
import struct

import pytest

from c4s.engine.confine.seccomp import filter_program

ALLOW, KILL, ERRNO = 0x7FFF0000, 0x80000000, 0x00050000
ARCH = {"x86_64": 0xC000003E, "aarch64": 0xC00000B7}
CALLS = {
    "x86_64": {
        "read": 0,
        "openat": 257,
        "mmap": 9,
        "socket": 41,
        "connect": 42,
        "execve": 59,
        "clone": 56,
        "clone3": 435,
        "chmod": 90,
        "symlink": 88,
        "prlimit64": 302,
        "kill": 62,
        "accept4": 288,
        "recvmsg": 47,
        "prctl": 157,
        "fcntl": 72,
        "openat2": 437,
        "memfd_create": 319,
    },
    "aarch64": {
        "read": 63,
        "openat": 56,
        "mmap": 222,
        "socket": 198,
        "connect": 203,
        "execve": 221,
        "clone": 220,
        "clone3": 435,
        "chmod": 53,
        "symlink": 36,
        "prlimit64": 261,
        "kill": 129,
        "accept4": 242,
        "recvmsg": 212,
        "prctl": 167,
        "fcntl": 25,
        "openat2": 437,
        "memfd_create": 279,
    },
}


def run(program: bytes, number: int, arch: int, *arguments: int) -> int:
    """The filter's verdict on a system call."""
    data = struct.pack("<IIQ6Q", number, arch, 0, *(*arguments, 0, 0, 0, 0, 0, 0)[:6])
    steps = [struct.unpack_from("HBBI", program, offset) for offset in range(0, len(program), 8)]
    register, position = 0, 0
    while True:
        code, if_true, if_false, value = steps[position]
        position += 1
        if code == 0x20:
            register = struct.unpack_from("<I", data, value)[0]
        elif code == 0x06:
            return int(value)
        else:
            hit = {0x15: register == value, 0x35: register >= value, 0x45: bool(register & value)}[code]
            position += if_true if hit else if_false


@pytest.mark.parametrize("machine", ["x86_64", "aarch64"])
def test_verdicts(machine: str) -> None:
    program = filter_program(machine)
    arch, calls = ARCH[machine], CALLS[machine]
    for name in ("read", "openat", "mmap", "recvmsg"):
        assert run(program, calls[name], arch) == ALLOW, name
    for name in ("socket", "connect", "execve", "symlink", "kill", "accept4", "memfd_create"):
        assert run(program, calls[name], arch) == ERRNO | errno.EPERM, name
    assert run(program, calls["clone3"], arch) == ERRNO | errno.ENOSYS
    assert run(program, calls["clone"], arch, 0x3D0F00) == ALLOW, "a thread"
    assert run(program, calls["clone"], arch, 0x1200011) == ERRNO | errno.EPERM, "a process"
    assert run(program, calls["prlimit64"], arch, 0) == ALLOW
    assert run(program, calls["prlimit64"], arch, 1) == ERRNO | errno.EPERM
    assert run(program, calls["chmod"], arch) == ERRNO, "does nothing and reports success"
    assert run(program, calls["openat2"], arch) == ERRNO | errno.ENOSYS
    assert run(program, calls["prctl"], arch, 1, 0) == ERRNO | errno.EPERM, "the signal at the host's death"
    assert run(program, calls["prctl"], arch, 15) == ALLOW, "a thread's name"
    for command, verdict in ((8, False), (10, False), (15, False), (1, True), (4, True), (1031, True)):
        assert run(program, calls["fcntl"], arch, 3, command) == (ALLOW if verdict else ERRNO | errno.EPERM), command
    assert run(program, calls["openat"], arch, 0, 0, 0o101, 0o644) == ALLOW
    assert run(program, calls["openat"], arch, 0, 0, 0o101, 0o4755) == ERRNO | errno.EPERM, "a set-user-id file"
    assert run(program, calls["openat"], arch, 0, 0, 0o101, 0o2755) == ERRNO | errno.EPERM, "a set-group-id file"


def test_foreign_and_x32_calls_are_refused() -> None:
    program = filter_program("x86_64")
    assert run(program, 0, 0x40000003) == KILL, "a 32-bit call"
    assert run(program, 0x40000000 | 41, ARCH["x86_64"]) == ERRNO | errno.EPERM
