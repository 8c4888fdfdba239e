"""A flow that was killed leaves no server behind, and what it left in the temporary folder goes with the next run."""

from __future__ import annotations

import os
import select
import shutil
import signal
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

import pytest

from bench.waiting import until
from tests.run.conftest import apart, environment, trial_in
from tests.run.test_evaluate import CASES, OFFLINE
from warehouse.database import rows

FLOW = f"import asyncio; from flows.evaluate import evaluate; asyncio.run(evaluate('small', ['noop'], cases={CASES!r}))"
GONE_MS = 60_000
"""How long the machine may take to end a process that ends by itself."""


@pytest.fixture
def temporary() -> Iterator[Path]:
    """A temporary folder with a short path: sockets lie in it."""
    folder = Path(tempfile.mkdtemp(prefix="k-"))
    yield folder
    shutil.rmtree(folder)


def family(process: int) -> dict[int, str]:
    """The processes below one, with their command lines."""
    found: dict[int, str] = {}
    waiting = [process]
    for parent in waiting:
        for task in Path(f"/proc/{parent}/task").iterdir():
            for child in map(int, (task / "children").read_text().split()):
                found[child] = Path(f"/proc/{child}/cmdline").read_bytes().replace(b"\0", b" ").decode()
                waiting.append(child)
    return found


def has_ended(handle: int) -> bool:
    """Whether a process ends in the time that a machine may take."""
    waiting = select.poll()
    waiting.register(handle, select.POLLIN)
    return bool(waiting.poll(GONE_MS))


def test_a_killed_flow_leaves_nothing(home: Path, tmp_path: Path, temporary: Path) -> None:
    own = apart(tmp_path / "home", home)
    settings = environment(own) | {"PREFECT_HOME": str(tmp_path / "prefect"), "TMPDIR": str(temporary), **OFFLINE}
    attempt = trial_in(own, "small", "noop", CASES[0]).attempt(1)
    flow = subprocess.Popen([sys.executable, "-c", FLOW], env=settings, stderr=subprocess.DEVNULL)
    until(attempt.scratch.exists, flow)
    below = family(flow.pid)
    assert any("uvicorn" in command for command in below.values()) and len(below) >= 3, below
    handles = [os.pidfd_open(process) for process in below]
    left = list(temporary.glob("c4s-w-*"))
    flow.send_signal(signal.SIGKILL)
    flow.wait()
    assert left and all(map(has_ended, handles)), below
    assert all(folder.is_dir() for folder in left), "nobody could remove it"
    again = subprocess.run(
        [sys.executable, "-m", "c4s.cli", "run", "small", "-a", "noop", "-c", CASES[0]], env=settings, check=False
    )
    assert again.returncode == 0 and not list(temporary.glob("c4s-w-*"))
    assert len(rows(own / "warehouse", "SELECT * FROM outcomes")) == 1
