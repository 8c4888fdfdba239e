"""``python -m bench.attacks``: every attack on the sandbox, tried in every sandbox of this machine, as a table.

An attack is Python that runs inside an engine as agent code does. One that is *refused* raises; the script fails with
that error, in a job log that it cannot change. One that *ends* the engine is the agent's failure, with the reason in
the attempt's outcome. Exit code 1 when any attack does what it set out to do.
"""

from __future__ import annotations

import json
import re
import sys
import tempfile
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from c4s.engine import EngineDied
from c4s.engine.confine.confinement import Backend, Limits
from c4s.engine.confine.sandbox import faults
from c4s.engine.headless.host.session import EngineSession

SECRET = "the withheld truth"
REFUSED = {
    "read the withheld truth": "open(TRUTH).read()",
    "list the withheld folder": "os.listdir(os.path.dirname(TRUTH))",
    "read the withheld truth from another folder": "open('../../' + os.path.relpath(TRUTH, ROOT)).read()",
    "open the withheld truth by its file handle": "fail(libc.syscall(304, -100, ctypes.create_string_buffer(128), 0))",
    "read /etc/passwd": "open('/etc/passwd').read()",
    "read /etc/shadow": "open('/etc/shadow').read()",
    "read another file of the user": "open(os.path.join(ROOT, 'notes.txt')).read()",
    "read the host's environment": "open(f'/proc/{HOST}/environ').read()",
    "read the host's memory": "open(f'/proc/{HOST}/mem', 'rb').read(1)",
    "read the memory of the first process": "open('/proc/1/mem', 'rb').read(1)",
    "leave through the root of a process": "os.listdir(f'/proc/{HOST}/root')",
    "leave through a working folder": "os.listdir('/proc/self/cwd/../../../../../etc')",
    "list the processes": "os.listdir('/proc')",
    "find a key in the environment": "next(k for k in os.environ if 'KEY' in k or 'TOKEN' in k or 'SECRET' in k)",
    "write beside the truth": "open(TRUTH + '.new', 'w').write('x')",
    "delete the truth": "os.unlink(TRUTH)",
    "move the truth here": "os.rename(TRUTH, 'stolen')",
    "overwrite the toolbox": "open(os.path.join(os.path.dirname(c4s.__file__), 'toolbox/client.py'), 'a').write('x')",
    "overwrite the editor scripts": "open(os.path.join(os.path.dirname(c4s.__file__), 'editor', 'snapshot.py'), 'a')",
    "plant a module beside numpy": "open(os.path.join(os.path.dirname(numpy.__file__), 'evil.py'), 'w')",
    "plant a program beside the interpreter": "open(os.path.join(os.path.dirname(sys.executable), 'evil'), 'w')",
    "overwrite the compiled kernels": "open(next(iter(glob.glob(KERNELS))), 'ab').write(b'x')",
    "write under /usr": "open('/usr/lib/evil', 'w')",
    "write under /tmp": "open('/tmp/evil', 'w')",
    "write into shared memory": "open('/dev/shm/evil', 'w')",
    "forge the job log": "open(os.path.join(LOGS, 'job-1.log'), 'w').write('all is well')",
    "forge the engine log": "open(os.path.join(LOGS, 'engine.log'), 'w').write('all is well')",
    "take back printed lines": "os.ftruncate(1, 0)",
    "read back and change printed lines": "os.lseek(1, 0, 0)",
    "forge the trajectory": "open(os.path.join(os.path.dirname(LOGS), 'trajectory.jsonl'), 'a').write('{}')",
    "symbolic link to the truth": "os.symlink(TRUTH, 'link')",
    "symbolic link in the submission": "os.symlink('/etc/passwd', os.path.join(CONTENT, 'link'))",
    "hard link to the truth": "os.link(TRUTH, 'link')",
    "hard link of its own file": "(open('own', 'w').close(), os.link('own', 'link'))",
    "named pipe in the submission": "os.mkfifo(os.path.join(CONTENT, 'pipe'))",
    "device": "os.mknod('sda', 0o60600, os.makedev(8, 0))",
    "socket file": "os.mknod('socket', 0o140600)",
    "file that runs as its owner": "os.close(os.open('root', os.O_CREAT | os.O_WRONLY, 0o4755))",
    "tcp": "socket.create_connection(('127.0.0.1', 22), 1)",
    "udp": "socket.socket(socket.AF_INET, socket.SOCK_DGRAM)",
    "ipv6": "socket.socket(socket.AF_INET6)",
    "raw socket": "socket.socket(socket.AF_INET, socket.SOCK_RAW, 1)",
    "unix socket": "socket.socket(socket.AF_UNIX).connect('/run/docker.sock')",
    "abstract unix socket": "socket.socket(socket.AF_UNIX).bind('\\0c4s')",
    "netlink": "socket.socket(socket.AF_NETLINK, socket.SOCK_RAW)",
    "vsock": "socket.socket(40, socket.SOCK_STREAM)",
    "socket pair": "socket.socketpair()",
    "name resolution": "socket.getaddrinfo('example.com', 80)",
    "fork": "os.fork()",
    "fork bomb": "[os.fork() for _ in range(1000)]",
    "fork by clone3": "fail(libc.syscall(435, ctypes.create_string_buffer(88), 88))",
    "double fork to outlive the run": "os.fork() or os.setsid() or os.fork()",
    "new session": "os.setsid()",
    "run a program": "subprocess.run(['/usr/bin/id'])",
    "run a shell": "subprocess.run('id', shell=True)",
    "become a program": "os.execv('/proc/self/exe', ['python'])",
    "multiprocessing": "multiprocessing.get_context('fork').Process(target=print).start()",
    "stay when the host dies": "fail(libc.prctl(1, 0, 0, 0, 0))",
    "be traceable again": "fail(libc.prctl(4, 1, 0, 0, 0))",
    "kill the host": "os.kill(HOST, 9)",
    "kill the parent": "os.kill(max(os.getppid(), 1), 9)",
    "kill everything": "os.kill(-1, 9)",
    "signal by file owner": "fcntl.fcntl(os.pipe()[0], 8, HOST)",
    "signal by process handle": "fail(libc.syscall(434, HOST, 0))",
    "queue a signal": "fail(libc.syscall(129, HOST, 9, ctypes.create_string_buffer(128)))",
    "trace the host": "fail(libc.ptrace(16, HOST, 0, 0))",
    "be traced": "fail(libc.ptrace(0, 0, 0, 0))",
    "read the host's memory by call": "fail(libc.syscall(310, HOST, 0, 0, 0, 0, 0))",
    "write the host's memory by call": "fail(libc.syscall(311, HOST, 0, 0, 0, 0, 0))",
    "user namespace": "fail(libc.unshare(0x10000000))",
    "mount namespace": "fail(libc.unshare(0x00020000))",
    "enter a namespace": "fail(libc.setns(0, 0))",
    "clone into a namespace": "fail(libc.syscall(56, 0x10000011, 0, 0, 0, 0))",
    "mount": "fail(libc.mount(b'x', b'/tmp', b'tmpfs', 0, 0))",
    "mount by the new calls": "fail(libc.syscall(430, b'tmpfs', 0))",
    "undo a mount": "fail(libc.umount2(b'/', 2))",
    "change the root": "os.chroot('.')",
    "io_uring": "fail(libc.syscall(425, 8, ctypes.create_string_buffer(120)))",
    "key ring": "fail(libc.syscall(250, 0, -3, 1))",
    "add a key": "fail(libc.syscall(248, b'user', b'x', b'y', 1, -3))",
    "bpf": "fail(libc.syscall(321, 0, ctypes.create_string_buffer(72), 72))",
    "performance counters": "fail(libc.syscall(298, ctypes.create_string_buffer(112), 0, -1, -1, 0))",
    "fault handler of user space": "fail(libc.syscall(323, 0))",
    "kernel module": "fail(libc.syscall(175, 0, 0, b''))",
    "kernel log": "fail(libc.syscall(103, 3, ctypes.create_string_buffer(9), 8))",
    "set the clock": "time.clock_settime(time.CLOCK_REALTIME, 0)",
    "become root": "os.setuid(0)",
    "32-bit call": "fail(libc.syscall(0x40000000 | 41, 2, 1, 0))",
    "type into the terminal": "fcntl.ioctl(0, 0x5412, b'x')",
    "shared memory segment": "fail(libc.shmget(1, 4096, 0o1600))",
    "memory that is no process's": "os.memfd_create('hoard')",
    "raise its own limit": "resource.setrlimit(resource.RLIMIT_FSIZE, (-1, -1))",
    "change the host's limit": "resource.prlimit(HOST, resource.RLIMIT_CPU, (1, 1))",
    "take the processor from others": "os.setpriority(os.PRIO_PROCESS, HOST, 19)",
    "allocate 64 GiB": "bytearray(64 << 30)",
    "write a file of 4 GiB": "open('big', 'wb').truncate(4 << 30)",
    "open 10,000 files": "[open('/dev/null') for _ in range(10000)]",
}
"""Each must raise. Names: ``TRUTH``, ``ROOT``, ``HOST`` (process), ``LOGS``, ``CONTENT``, ``KERNELS``, and
``fail``, which raises for a C call that returned an error."""
_SMALL = Limits(cpu_s=4, memory=700 << 20, threads=64, files=2000, disk=64 << 20)
_ON_SOCKETS = (
    "import os, socket, stat\nfor n in range(3, 1024):\n try:\n  if stat.S_ISSOCK(os.fstat(n).st_mode): {}\n"
    " except OSError: pass"
)
ENDED = {
    "fill the memory": ("b = bytearray(1 << 30)\nfor i in range(0, 1 << 30, 4096): b[i] = 1", "of memory"),
    "thread bomb": (
        "import threading\nthreading.stack_size(65536)\n"
        "while True: threading.Thread(target=threading.Event().wait, daemon=True).start()",
        "threads",
    ),
    "fill the disk": ("n = 0\nwhile True:\n open(f'big{n}', 'wb').write(bytes(16 << 20))\n n += 1", "files take"),
    "write a hundred thousand files": ("for n in range(100_000): open(f'f{n}', 'w')", "files"),
    "use the processor for ever": ("", "SIGKILL|SIGXCPU"),
    "print for ever": ("import os\nwhile True: os.write(1, b'x' * 65536)", "printed more"),
    "exit": ("import os; os._exit(0)", "exit code 0"),
    "crash": ("import ctypes; ctypes.string_at(1)", "SIGSEGV"),
    "cut the line to the host": (_ON_SOCKETS.format("socket.socket(fileno=os.dup(n)).shutdown(2)"), "exit code 1"),
    "speak nonsense to the host": (_ON_SOCKETS.format("os.write(n, b'\\xff' * 64)"), "message"),
}
"""Each goes on for ever afterwards, and must end its engine for the reason given (a pattern)."""
_SCRIPT = """
import ctypes, fcntl, glob, json, multiprocessing, os, resource, socket, subprocess, sys, time, warnings
import numpy
import c4s
warnings.simplefilter("ignore")  # Python 3.12 warns of forks beside threads, in the same log
libc = ctypes.CDLL(None, use_errno=True)
def fail(result):
    if result == -1: raise OSError(ctypes.get_errno(), os.strerror(ctypes.get_errno()))
for name, attack in ATTACKS.items():
    try:
        told = ["done", repr(eval(attack))[:80]]
    except BaseException as error:
        told = ["refused", f"{type(error).__name__}: {error}"]
    print(json.dumps([name, *told]))
"""


@dataclass(frozen=True)
class AttackResult:
    """What became of an attack in a sandbox."""

    attack: str
    backend: Backend
    failed: bool
    """Whether the attack failed, as it must."""
    told: str


def refused(backend: Backend, root: Path) -> Iterator[AttackResult]:
    """Try the attacks of ``REFUSED`` in one engine whose case lies under ``root``."""
    truth = root / "withheld" / "case" / "truth.level.json"
    truth.parent.mkdir(parents=True)
    truth.write_text(SECRET)
    (root / "notes.txt").write_text(SECRET)
    scratch, content = root / "agent" / "scratch", root / "agent" / "content"
    with EngineSession.start(packs=[], content=content, scratch=scratch, use=backend) as engine:
        names = {
            "TRUTH": str(truth),
            "ROOT": str(root),
            "HOST": _host(engine),
            "LOGS": str(engine.logs),
            "CONTENT": str(content),
            "KERNELS": f"{scratch}/kernels/*/*/*.nb?",
            "ATTACKS": REFUSED,
        }
        reply = engine.execute("\n".join(f"{name} = {value!r}" for name, value in names.items()) + _SCRIPT, 120)
    for line in reply["result"]["python_logs"]:
        name, outcome, told = json.loads(line)
        yield AttackResult(name, backend, outcome == "refused" and SECRET not in told, told)
    if reply["status"] != "ok":
        yield AttackResult("the script of attacks", backend, False, str(reply.get("error")))
    if truth.read_text() != SECRET or len(list(truth.parent.iterdir())) != 1:
        yield AttackResult("the withheld folder afterwards", backend, False, "changed")


def _host(engine: EngineSession) -> int:
    """The process that started the engine."""
    return int(Path(f"/proc/{engine.pid}/stat").read_text().rpartition(")")[2].split()[1])


def ended(attack: str, backend: Backend, root: Path) -> AttackResult:
    """Try an attack of ``ENDED`` in an engine of its own, with small limits."""
    script, _ = ENDED[attack]
    with EngineSession.start(
        packs=[], content=root / "content", scratch=root / "scratch", use=backend, limits=_SMALL
    ) as engine:
        try:
            reply = engine.execute(f"{script}\nwhile True: pass", 60)
        except EngineDied as death:
            return AttackResult(attack, backend, True, death.what)
    return AttackResult(attack, backend, False, str(reply.get("error") or reply["status"]))


def results() -> Iterator[AttackResult]:
    """Every attack in every sandbox of this machine."""
    for backend, fault in faults().items():
        if fault is not None:
            continue
        with tempfile.TemporaryDirectory(prefix="c4s-attacks-") as folder:
            yield from refused(backend, Path(folder) / "refused")
            for number, attack in enumerate(ENDED):
                yield ended(attack, backend, Path(folder) / str(number))


def main() -> int:
    """Print the table: an attack a row, a sandbox a column."""
    found = list(results())
    columns = list(dict.fromkeys(result.backend for result in found))
    print(f"| attack | {' | '.join(columns)} |\n|---|{'---|' * len(columns)}")
    for attack in dict.fromkeys(result.attack for result in found):
        cells = {r.backend: ("" if r.failed else "**SUCCEEDED** ") + _short(r) for r in found if r.attack == attack}
        print(f"| {attack} | {' | '.join(cells.get(column, '') for column in columns)} |")
    for backend, fault in faults().items():
        if fault is not None:
            print(f"\nNot tried: {backend} ({fault})")
    return 0 if all(result.failed for result in found) else 1


def _short(result: AttackResult) -> str:
    """The outcome in a few words, without the paths of this run."""
    told = " ".join(result.told.split())
    if told.startswith("the engine ended with"):
        reason = re.search(r"\((its? [^)]*|[^)]*message[^)]*|[^)]*JSON[^)]*)\)", told)
        return (
            "ended: "
            + (reason[1] if reason else told.split()[4] if "SIG" in told.split()[4] else " ".join(told.split()[4:7]))[
                :60
            ]
        )
    return told.partition(": '/")[0][:70].replace("|", "/")


if __name__ == "__main__":
    sys.exit(main())
