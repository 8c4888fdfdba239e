"""Programs that take more of the machine than a client may: each is stopped, with all that it started."""

from __future__ import annotations

import os
import re
import sys
import time
from dataclasses import replace
from pathlib import Path

import pytest

from c4s.agents.clients import confined
from c4s.agents.clients.limits import ClientLimits
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
    "much on the disk": ("for n in range(6): open(f'/home/agent/f{n}', 'wb').write(b'x' * (20 << 20))" + WAIT, "MiB"),
}


@pytest.mark.parametrize("attack", ATTACKS)
def test_a_client_that_passes_a_limit_is_ended_with_all_it_started(tmp_path: Path, attack: str) -> None:
    script, reason = ATTACKS[attack]
    mark = f"mark-{time.monotonic_ns()}"
    memory = SMALL.memory if "memory" in reason else 4 << 30  # what forks share counts for each
    with pytest.raises(AgentFault, match=f"the client was ended: .*{reason}"):
        run(tmp_path, f"'{mark}'\n{script}", replace(SMALL, memory=memory))
    while marked(mark):
        os.sched_yield()


@pytest.mark.parametrize(
    ("script", "error"),
    [
        ("bytearray(2 << 30)", "MemoryError"),
        ("open('/home/agent/big', 'wb').write(b'x' * (40 << 20))", "OSError|File size limit"),
        ("open('/tmp/big', 'wb').write(b'x' * (20 << 20))", "No space left"),
        ("open('/dev/shm/big', 'wb').write(b'x' * (20 << 20))", "No space left"),
        ("open('/dev/big', 'wb')", "Read-only"),
        ("held = [open('/dev/null') for _ in range(300)]", "Too many open files"),
        ("import resource as r\nr.setrlimit(r.RLIMIT_DATA, (8 << 30, 8 << 30))", "ValueError|PermissionError"),
    ],
)
def test_what_the_kernel_refuses_one_process(tmp_path: Path, script: str, error: str) -> None:
    status, told = run(tmp_path, script, replace(SMALL, cpu_s=60))
    assert status != 0 and re.search(error, told), told


def test_what_keeps_the_limits_is_left_alone(tmp_path: Path) -> None:
    script = "import os\nfor _ in range(20):\n if os.fork() == 0: os._exit(0)\nprint(len(bytearray(50 << 20)))"
    assert run(tmp_path, script) == (0, f"{50 << 20}\n")
