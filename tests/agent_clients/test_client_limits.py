"""Programs that take more of the machine than a client may: each is stopped, with all that it started."""

from __future__ import annotations

import re
import socket
import sys
import threading
import time
from dataclasses import replace
from pathlib import Path

import pytest

from bench.waiting import until
from c4s.agents.clients import confined, inside
from c4s.agents.clients.limits import ClientLimits
from c4s.engine.confine import leftovers
from c4s.engine.confine.confinement import Limits
from c4s.engine.confine.sandbox import faults
from c4s.errors import AgentFault

pytestmark = pytest.mark.skipif(faults()["bubblewrap"] is not None, reason=f"no bubblewrap: {faults()['bubblewrap']}")
SMALL = ClientLimits(
    memory=250 << 20,
    threads=60,
    cpu_s=2,
    files=300,
    disk=60 << 20,
    data=1 << 30,
    file_size=30 << 20,
    open_files=200,
    temporary=16 << 20,
)
WAIT = "\nimport time\ntime.sleep(3600)"


def run(tmp_path: Path, script: str, limits: ClientLimits = SMALL) -> tuple[int, str]:
    """Run a Python script as a client: its status and its output."""
    home = tmp_path / "home"
    home.mkdir()
    python = Path(sys.executable).resolve()
    runtime = () if python.is_relative_to("/usr") else (python.parents[1],)
    status = confined.run(
        confined.Command([str(python), "-c", script], {}, runtime), home, tmp_path / "out", limits=limits
    )
    return status, (tmp_path / "out.stdout").read_text() + (tmp_path / "out.stderr").read_text()


def marked(mark: str) -> list[str]:
    """Processes of this machine whose command line holds a text."""
    found = []
    for folder in Path("/proc").glob("[0-9]*"):
        try:
            if mark.encode() in (folder / "cmdline").read_bytes():
                found.append(folder.name)
        except OSError:
            continue
    return found


ATTACKS = {
    "one process takes memory": ("held = [bytearray(8 << 20) for _ in range(100)]" + WAIT, "MiB of memory"),
    "many processes take memory": (
        "import os\nfor _ in range(6):\n if os.fork() == 0:\n  held = b'x' * (60 << 20)\n  break" + WAIT,
        "MiB of memory",
    ),
    "a fork bomb": ("import os\nwhile True:\n try: os.fork()\n except OSError: pass", "processes and threads"),
    "children that were let go": (
        "import os\nfor _ in range(100):\n if os.fork() == 0:\n  os.setsid()\n  if os.fork(): os._exit(0)\n  break"
        + WAIT,
        "processes and threads",
    ),
    "threads that start processes": (
        "import subprocess, threading\ndef go():\n while True: subprocess.Popen(['sleep', '3600'])\n"
        "for _ in range(8): threading.Thread(target=go).start()" + WAIT,
        "processes and threads",
    ),
    "processes that compute": (
        "import os\nos.fork(); os.fork()\nend = __import__('time').time() + 3600\n"
        "while __import__('time').time() < end: pass",
        "CPU time",
    ),
    "many files": ("for n in range(1000): open(f'/home/agent/f{n}', 'w')" + WAIT, "files"),
    "much on the disk without a name": (
        "import os\nheld = []\nfor n in range(6):\n held.append(open('f', 'wb', 0)); os.unlink('f')"
        "\n held[-1].write(b'x' * (20 << 20))" + WAIT,
        "MiB",
    ),
    "much on the disk": ("for n in range(6): open(f'/home/agent/f{n}', 'wb').write(b'x' * (20 << 20))" + WAIT, "MiB"),
}


@pytest.mark.parametrize("attack", ATTACKS)
def test_a_client_that_passes_a_limit_is_ended_with_all_it_started(tmp_path: Path, attack: str) -> None:
    script, reason = ATTACKS[attack]
    mark = f"mark-{time.monotonic_ns()}"
    memory = SMALL.memory if "memory" in reason else 4 << 30  # what forks share counts for each
    with pytest.raises(AgentFault, match=f"the client was ended: .*{reason}"):
        run(tmp_path, f"'{mark}'\n{script}", replace(SMALL, memory=memory))
    until(lambda: not marked(mark))


@pytest.mark.parametrize(
    ("script", "error"),
    [
        ("bytearray(2 << 30)", "MemoryError"),
        ("open('/home/agent/big', 'wb').write(b'x' * (40 << 20))", "OSError|File size limit"),
        ("open('/tmp/big', 'wb').write(b'x' * (20 << 20))", "No space left"),
        ("open('/dev/shm/big', 'wb').write(b'x' * (20 << 20))", "No space left"),
        ("open('/dev/big', 'wb')", "Read-only"),
        ("held = [open('/dev/null') for _ in range(300)]", "Too many open files"),
        (
            "import ctypes as c, os\nfallocate = c.CDLL(None, use_errno=True).fallocate\n"
            "fallocate(os.open('r', 66), 1, c.c_long(), c.c_long(2 << 40))"
            "\nraise OSError(c.get_errno(), 'x')",
            "Errno 95",
        ),
        ("import fcntl, os\nfcntl.ioctl(os.open('r', 66), 0x40305828, bytes(48))", "Operation not permitted"),
        (
            "import ctypes as c\nc.CDLL(None, use_errno=True).syscall(425, 8, bytes(120))\n"
            "raise OSError(c.get_errno(), 'x')",
            "Errno 1]",
        ),
        ("import resource as r\nr.setrlimit(r.RLIMIT_DATA, (8 << 30, 8 << 30))", "ValueError|PermissionError"),
    ],
)
def test_what_the_kernel_refuses_one_process(tmp_path: Path, script: str, error: str) -> None:
    status, told = run(tmp_path, script, replace(SMALL, cpu_s=60))
    assert status != 0 and re.search(error, told), told


def test_what_a_client_leaves_in_its_home_is_bounded(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(leftovers, "KEPT", Limits(files=50))
    assert run(tmp_path, "for n in range(60): open(f'f{n}', 'w')")[0] == 0
    assert list((tmp_path / "home").iterdir()) == []
    assert "50 files" in (tmp_path / "home.trimmed.json").read_text()


def test_a_flood_through_a_door_costs_the_host_few_connections(tmp_path: Path) -> None:
    """The server sees no more than the door carries; what it closes is closed, though the client keeps its end."""
    most = 0
    held: list[socket.socket] = []
    with socket.create_server(("127.0.0.1", 0), backlog=256) as listener:
        port = listener.getsockname()[1]

        def serve() -> None:
            nonlocal most
            while True:
                connection = listener.accept()[0]
                held.append(connection)
                most = max(most, len(held))
                if connection.recv(4) == b"free":
                    while held:
                        held.pop().close()
                    return

        script = f"""
import socket
def there():
    return socket.create_connection(('127.0.0.1', {port}))
first = [there() for _ in range(300)]
alive = []
for one in first[:10]:
    one.sendall(b'ping'); alive.append(one)
first[10].sendall(b'free')
while first[10].recv(1): pass
print(sum(not one.recv(1) for one in alive))
"""
        thread = threading.Thread(target=serve)
        thread.start()
        home = tmp_path / "home"
        home.mkdir()
        python = Path(sys.executable).resolve()
        runtime = () if python.is_relative_to("/usr") else (python.parents[1],)
        command = confined.Command([str(python), "-c", script], {}, runtime)
        status = confined.run(command, home, tmp_path / "out", servers=[f"http://127.0.0.1:{port}"])
        thread.join()
    told = (tmp_path / "out.stdout").read_text() + (tmp_path / "out.stderr").read_text()
    assert (status, told) == (0, "10\n") and 11 <= most <= inside.MOST_CARRIED


def test_what_keeps_the_limits_is_left_alone(tmp_path: Path) -> None:
    script = "import os\nfor _ in range(20):\n if os.fork() == 0: os._exit(0)\nprint(len(bytearray(50 << 20)))"
    assert run(tmp_path, script) == (0, f"{50 << 20}\n")
