"""What agent code may not do, tried for real in every sandbox that this machine has."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from c4s.engine import sandbox
from c4s.engine.confine import Backend, Limits
from c4s.engine.session import EngineSession
from c4s.errors import BadInput, MachineryFault

SECRET = "the withheld truth"
ATTACKS = {
    "read /etc/passwd": "open('/etc/passwd').read()",
    "read /etc/shadow": "open('/etc/shadow').read()",
    "read the truth": "open(TRUTH).read()",
    "list the withheld folder": "os.listdir(os.path.dirname(TRUTH))",
    "list the root's home": "os.listdir('/root/.ssh')",
    "read the host's environment": "open(f'/proc/{os.getppid()}/environ').read()",
    "read a process": "open('/proc/1/mem', 'rb').read(1)",
    "write beside the truth": "open(TRUTH + '.new', 'w').write('x')",
    "write into the library": "open(c4s.__file__, 'a').write('x')",
    "write into site-packages": "open(os.path.join(os.path.dirname(numpy.__file__), 'evil.py'), 'w')",
    "write into the pack's place": "open('/usr/lib/evil', 'w')",
    "symbolic link to the truth": "os.symlink(TRUTH, 'link')",
    "hard link to the truth": "os.link(TRUTH, 'link')",
    "named pipe": "os.mkfifo('pipe')",
    "tcp": "socket.create_connection(('127.0.0.1', 22), 1)",
    "udp": "socket.socket(socket.AF_INET, socket.SOCK_DGRAM)",
    "unix socket": "socket.socket(socket.AF_UNIX)",
    "netlink": "socket.socket(socket.AF_NETLINK, socket.SOCK_RAW)",
    "socket pair": "socket.socketpair()",
    "fork": "os.fork()",
    "run a program": "subprocess.run(['/usr/bin/id'])",
    "become a program": "os.execv('/proc/self/exe', ['python'])",
    "kill the host": "os.kill(max(os.getppid(), 1), 9)",
    "kill everything": "os.kill(-1, 9)",
    "trace": "fail(libc.ptrace(16, 1, 0, 0))",
    "user namespace": "fail(libc.unshare(0x10000000))",
    "mount": "fail(libc.mount(b'x', b'/tmp', b'tmpfs', 0, 0))",
    "chroot": "os.chroot('.')",
    "io_uring": "fail(libc.syscall(425, 8, ctypes.create_string_buffer(120)))",
    "shared memory": "fail(libc.shmget(1, 4096, 0o1600))",
    "raise a limit": "resource.setrlimit(resource.RLIMIT_FSIZE, (resource.RLIM_INFINITY, resource.RLIM_INFINITY))",
    "a limit of another process": "resource.prlimit(max(os.getppid(), 2), resource.RLIMIT_CPU, (1, 1))",
    "too much memory": "bytearray(64 << 30)",
    "too large a file": "open('big', 'wb').truncate(4 << 30)",
}
SCRIPT = """
import ctypes, json, os, resource, socket, subprocess
import numpy
import c4s
libc = ctypes.CDLL(None, use_errno=True)
def fail(result):
    if result != 0: raise OSError(ctypes.get_errno(), "refused")
for name, attack in ATTACKS.items():
    try:
        print(json.dumps([name, "done", repr(eval(attack))[:80]]))
    except BaseException as error:
        print(json.dumps([name, "refused", repr(error)]))
"""


def test_attacks_are_refused(tmp_path: Path, backend: Backend) -> None:
    truth = tmp_path / "withheld" / "case" / "truth.level.json"
    truth.parent.mkdir(parents=True)
    truth.write_text(SECRET)
    with EngineSession.start(packs=[], content=tmp_path / "agent" / "content", scratch=tmp_path / "agent" / "scratch",
                             use=backend) as engine:
        reply = engine.execute(f"TRUTH, ATTACKS = {str(truth)!r}, {ATTACKS!r}\n{SCRIPT}", timeout_s=60)
    assert reply["status"] == "ok", reply
    outcomes = [json.loads(line) for line in reply["result"]["python_logs"]]
    assert {name for name, _, _ in outcomes} == set(ATTACKS)
    assert [outcome for outcome in outcomes if outcome[1] != "refused"] == []
    assert SECRET not in json.dumps(reply)
    assert [path.name for path in truth.parent.iterdir()] == ["truth.level.json"] and truth.read_text() == SECRET


def test_the_file_system_outside_cannot_be_altered_in_any_way(tmp_path: Path, backend: Backend) -> None:
    outside = tmp_path / "outside.txt"
    outside.write_text("as it was")
    outside.chmod(0o640)
    before = outside.stat()
    with EngineSession.start(packs=[], content=tmp_path / "content", scratch=tmp_path / "scratch",
                             use=backend) as engine:
        reply = engine.execute(f"""
import os
for attack in ('os.chmod(P, 0o777)', 'os.utime(P, (1, 1))', 'os.chown(P, 1, 1)', 'os.unlink(P)', 'os.truncate(P, 0)',
               'os.rename(P, "stolen")', 'os.setxattr(P, "user.x", b"1")', 'open(P, "w")'):
    try: eval(attack, {{'os': os, 'P': {str(outside)!r}}})
    except OSError: pass
open('mine', 'w').write('kept'); os.chmod('mine', 0o600); os.rename('mine', 'renamed')
print(open('renamed').read())""")
    assert reply["result"]["python_logs"] == ["kept"]
    after = outside.stat()
    assert outside.read_text() == "as it was"
    assert (after.st_mode, after.st_mtime_ns, after.st_uid) == (before.st_mode, before.st_mtime_ns, before.st_uid)


def test_threads_and_numbers_work_inside(tmp_path: Path, backend: Backend) -> None:
    with EngineSession.start(packs=[], content=tmp_path / "content", scratch=tmp_path / "scratch",
                             use=backend) as engine:
        reply = engine.execute("from concurrent.futures import ThreadPoolExecutor\nimport numpy as np, tempfile\n"
                               "print(sum(ThreadPoolExecutor(8).map(lambda n: n * n, range(10))), np.eye(3).trace())\n"
                               "with tempfile.TemporaryFile() as f: print(f.write(b'abc'))")
    assert reply["result"]["python_logs"] == ["285 3.0", "3"]


def test_processor_time_is_limited(tmp_path: Path, backend: Backend) -> None:
    with (EngineSession.start(packs=[], content=tmp_path / "c", scratch=tmp_path / "s", use=backend,
                              limits=Limits(cpu_s=4)) as engine, pytest.raises(MachineryFault, match="engine ended")):
        engine.execute("while True: pass", timeout_s=30)


def test_without_a_sandbox_nothing_starts(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sandbox, "faults", lambda: {"bubblewrap": "not installed", "landlock": "no Landlock"})
    with pytest.raises(MachineryFault, match=r"bubblewrap: not installed; landlock: no Landlock \(install bubblewrap"
                                             r".*C4S_SANDBOX=none"):
        EngineSession.start(packs=[], content=tmp_path / "c", scratch=tmp_path / "s")
    assert not (tmp_path / "s.logs" / "engine.log").exists()


@pytest.mark.parametrize("name", ["bubblewrap", "landlock"])
def test_a_sandbox_is_chosen_and_its_lack_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str) -> None:
    monkeypatch.setattr(sandbox, "faults", lambda: {"bubblewrap": None, "landlock": None} | {name: "broken"})
    other = {"bubblewrap": "landlock", "landlock": "bubblewrap"}[name]
    assert sandbox.backend() == other
    monkeypatch.setenv("C4S_SANDBOX", other)
    assert sandbox.backend() == other
    monkeypatch.setenv("C4S_SANDBOX", name)
    with pytest.raises(MachineryFault, match=f"{name}: broken"):
        EngineSession.start(packs=[], content=tmp_path / "c", scratch=tmp_path / "s")
    monkeypatch.setenv("C4S_SANDBOX", "wishful")
    with pytest.raises(BadInput, match="no sandbox is called 'wishful'"):
        sandbox.backend()


def test_the_risk_can_be_accepted_and_the_limits_stay(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sandbox, "faults", lambda: {"bubblewrap": "no", "landlock": "no"})
    monkeypatch.setenv("C4S_SANDBOX", "none")
    (tmp_path / "seen.txt").write_text("open")
    with EngineSession.start(packs=[], content=tmp_path / "c", scratch=tmp_path / "s") as engine:
        reply = engine.execute(f"print(open({str(tmp_path / 'seen.txt')!r}).read())")
        assert reply["result"]["python_logs"] == ["open"]
        assert engine.execute("bytearray(64 << 30)")["fault"] == "MemoryError"


def test_the_submission_cannot_be_changed_by_the_evaluator_engine(tmp_path: Path, backend: Backend) -> None:
    content = tmp_path / "content"
    content.mkdir()
    (content / "kept.json").write_text("{}")
    with EngineSession.start(packs=[], content=content, scratch=tmp_path / "s", use=backend,
                             content_read_only=True) as engine:
        reply = engine.execute(f"open({str(content / 'kept.json')!r}, 'w')")
    assert reply["status"] == "error" and [path.name for path in content.iterdir()] == ["kept.json"]
