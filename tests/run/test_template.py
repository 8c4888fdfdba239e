"""Workers are forked from a template: what they take over from it, what not, and what its end costs."""

from __future__ import annotations

import asyncio
import os
import resource
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from bench.waiting import until
from c4s.run import template
from c4s.run.limits import Limit
from c4s.run.pool import Pool
from c4s.run.processes import WorkerDied
from tests.run.jobs import note_process, open_files, take_state

LONG = Limit("processor", 120.0)


def test_a_template_has_one_thread_when_it_has_forked_and_workers_die_with_it(tmp_path: Path) -> None:
    async def work() -> None:
        async with Pool(2) as pool:
            first, _ = await pool.run(LONG, os.getpid)
            old = pool._template
            assert old is not None and len(os.listdir(f"/proc/{old.process.pid}/task")) == 1  # noqa: PTH208
            job = asyncio.ensure_future(pool.run(LONG, note_process, tmp_path / "pid", "loop"))
            while not (tmp_path / "pid").exists():
                await asyncio.sleep(0)
            old.process.kill()
            with pytest.raises(WorkerDied, match="SIGKILL"):
                await job
            second, _ = await pool.run(LONG, os.getpid)
            assert second != first and pool._template is not old

    asyncio.run(work())


def test_workers_share_no_state_no_chance_and_no_open_file() -> None:
    async def work() -> None:
        async with Pool(2) as pool:
            states = await asyncio.gather(*(pool.run(LONG, take_state) for _ in range(3)))
            assert [left for (left, _), _ in states] == [[]] * 3
            assert len({chance for (_, chance), _ in states}) == len(pool._all) == 3
            files = await asyncio.gather(*(pool.run(LONG, open_files) for _ in range(3)))
            assert [sum(name.startswith("socket:") for name in found) for found, _ in files] == [1] * 3
            assert not any("pidfd" in name for found, _ in files for name in found)

    asyncio.run(work())


def test_a_worker_works_where_and_under_what_its_operator_does(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    async def work() -> None:
        async with Pool(2) as pool:
            await asyncio.gather(pool.run(LONG, note_process, tmp_path / "pid", "die"), return_exceptions=True)
            monkeypatch.setenv("C4S_HOME", str(tmp_path))
            monkeypatch.chdir(tmp_path)
            assert (await pool.run(LONG, os.getenv, "C4S_HOME"))[0] == str(tmp_path)
            assert (await pool.run(LONG, Path.cwd))[0] == tmp_path
            assert (await pool.run(LONG, os.getpgrp))[0] == os.getpgrp()
            limits = await pool.run(LONG, resource.getrlimit, resource.RLIMIT_NOFILE)
            assert limits[0] == resource.getrlimit(resource.RLIMIT_NOFILE)
            assert (await pool.run(LONG, signal.getsignal, signal.SIGINT))[0] == signal.SIG_IGN

    asyncio.run(work())


def test_a_template_loads_nothing_that_starts_threads_of_its_own() -> None:
    heavy = ("duckdb", "numba", "pandas", "pyarrow", "scipy")
    code = f"import sys; [__import__(n) for n in {template.LOADED}]; print(*(n for n in {heavy} if n in sys.modules))"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=120, check=True)
    assert done.stdout.split() == []


def test_a_template_ends_where_nobody_holds_its_control() -> None:
    async def work() -> int:
        async with Pool(1) as pool:
            await pool.run(LONG, os.getpid)
            assert pool._template is not None
            pool._template._orders.close()
            return until(pool._template.process.poll, pool._template.process) or 0

    assert asyncio.run(work()) == 0
