"""A run without room pauses, says what is short and where, and goes on by itself; what failed meanwhile is repeated."""

from __future__ import annotations

import asyncio
import os
import resource
import signal
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

import pytest

from bench.fault_table import below
from bench.waiting import until
from c4s.run.headroom import Floors, Headroom, places, shortages
from tests.run.conftest import apart, environment, trial_in
from warehouse.database import rows

DISK_MIB = 400
CASE = "indoor-flat-01-mirrored-bath"


@pytest.fixture
def disk() -> Iterator[Path]:
    """A disk of its own, small."""
    folder = Path(tempfile.mkdtemp(prefix="d-"))
    done = subprocess.run(
        ["mount", "-t", "tmpfs", "-o", f"size={DISK_MIB}m", "c4s-test", folder], capture_output=True, check=False
    )
    if done.returncode:
        folder.rmdir()
        pytest.skip(f"nothing can be mounted here: {done.stderr.decode().strip()}")
    yield folder
    subprocess.run(["umount", "-l", folder], check=True)
    folder.rmdir()


def filled(disk: Path, mib: int) -> Path:
    """A file of a size, or as large as the disk allows."""
    path = disk / "filler"
    with path.open("wb", buffering=0) as out, suppress(OSError):
        for _ in range(256 * mib):
            out.write(bytes(4096))
    return path


def noop_run(home: Path) -> subprocess.Popen[str]:
    """A run of one trial in a home."""
    return subprocess.Popen(
        [sys.executable, "-m", "c4s.cli", "run", "small", "-a", "noop", "-c", CASE],
        env=environment(home),
        text=True,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
    )


def on_a_full_disk(home: Path, disk: Path) -> tuple[Path, Path, subprocess.Popen[str], Iterator[str]]:
    """A home on a disk, the file that fills the disk, a run that begins there, and the lines that it tells."""
    own = apart(disk / "home", home)
    filler = filled(disk, DISK_MIB - 100)
    run = noop_run(own)
    assert run.stderr
    return own, filler, run, (line for line in run.stderr if "c4s: " in line)


def test_a_full_disk_is_nobodys_zero(home: Path, disk: Path) -> None:
    own, filler, run, told = on_a_full_disk(home, disk)
    attempt = trial_in(own, "small", "noop", CASE).attempt(1)
    line = next(told)
    assert "paused: " in line and f"{own} has " in line and "MiB of disk left and a run needs 256" in line
    assert not attempt.root.exists(), "nothing was started"
    filler.unlink()
    assert "there is room again: going on" in next(told)
    until(attempt.manifest.exists, run)
    filler = filled(disk, DISK_MIB)
    assert "paused: " in next(told)
    until(lambda: not any("c4s.engine" in command for command in below(run.pid).values()))
    filler.unlink()
    assert run.stderr
    rest = run.stderr.read()
    assert run.wait() == 0, rest
    (row,) = rows(own / "warehouse", "SELECT * FROM outcomes")
    assert (row["status"], row["score"]) == ("measured", 0.2)


@pytest.mark.parametrize("when", ["before anything", "after the attempt"])
def test_a_run_that_waits_for_room_ends_when_asked(home: Path, disk: Path, when: str) -> None:
    own, filler, run, told = on_a_full_disk(home, disk)
    attempt = trial_in(own, "small", "noop", CASE).attempt(1)
    assert "paused: " in next(told)
    if when == "after the attempt":
        filler.unlink()
        assert "there is room again: going on" in next(told)
        until(attempt.manifest.exists, run)
        filler = filled(disk, DISK_MIB)
        assert "paused: " in next(told)
    run.send_signal(signal.SIGINT)
    assert run.stderr
    rest = run.stderr.read()
    assert run.wait() not in (0, -signal.SIGINT) and "Traceback" not in rest, rest
    assert attempt.root.exists() == (when == "after the attempt")
    filler.unlink()
    again = noop_run(own)
    assert again.stderr
    rest = again.stderr.read()
    assert again.wait() == 0, rest
    (row,) = rows(own / "warehouse", "SELECT * FROM outcomes")
    assert (row["status"], row["score"]) == ("measured", 0.2)


@pytest.mark.parametrize(
    ("floors", "told"),
    [
        (Floors(disk_bytes=1 << 60), "MiB of disk left and a run needs"),
        (Floors(disk_files=1 << 60), "has room for "),
        (Floors(descriptors=1 << 30), f"process {os.getpid()} may open "),
        (Floors(memory_bytes=1 << 60), "MiB of memory left and a run needs"),
    ],
    ids=["disk", "files", "descriptors", "memory"],
)
def test_each_shortage_is_told_once_with_where_it_is(floors: Floors, told: str) -> None:
    lines: list[str] = []
    watch = Headroom(floors, lines.append)
    assert not watch.look() and not watch.look() and watch.times_short == 2
    assert len(lines) == 1 and told in lines[0] and lines[0].startswith("paused: ")
    assert list(shortages(places(), Floors(0, 0, 0, 0))) == []


def test_a_run_that_waits_for_descriptors_goes_on_when_there_are_some() -> None:
    free = resource.getrlimit(resource.RLIMIT_NOFILE)[0] - len(os.listdir("/proc/self/fd"))  # noqa: PTH208
    lines: list[str] = []
    pipes: list[int] = []
    watch = Headroom(Floors(0, 0, free - 20, 0), lines.append)

    async def waiting() -> None:
        pipes.extend(handle for _ in range(30) for handle in os.pipe())
        asyncio.get_running_loop().call_soon(lambda: [os.close(handle) for handle in pipes])
        await watch.room()

    asyncio.run(waiting())
    assert [line.split(":")[0] for line in lines] == ["paused", "there is room again"]


def test_a_pool_lets_its_workers_open_as_many_files_as_the_system_allows(home: Path, tmp_path: Path) -> None:
    code = (
        "import asyncio, resource; from c4s.run.pool import Pool\n"
        "async def go():\n"
        "    async with Pool(1) as pool:\n"
        "        limit = pool._limits['score']\n"
        "        print((await pool.run(limit, resource.getrlimit, resource.RLIMIT_NOFILE))[0][0])\n"
        "asyncio.run(go())"
    )
    hard = resource.getrlimit(resource.RLIMIT_NOFILE)[1]
    few = min(1024, hard)
    done = subprocess.run(
        ["sh", "-c", f'ulimit -S -n {few}; exec "$0" -c "$1"', sys.executable, code],
        env=environment(tmp_path),
        capture_output=True,
        text=True,
        check=True,
    )
    assert int(done.stdout) == (1 << 16 if hard == resource.RLIM_INFINITY else min(hard, 1 << 16))
