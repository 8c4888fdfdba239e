"""A run has one holder at a time, told by real processes."""

from __future__ import annotations

import os
import shutil
import signal
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from pytest import MonkeyPatch

from bench.waiting import until
from c4s.records.folder import RunFolder
from c4s.records.lease import Lease
from c4s.run import lease
from c4s.run.lease import LeaseLost, RunHeld, holding
from c4s.run.store import FolderLeases
from tests.run.conftest import Command, apart, environment, trial_in

HOLD = """
import sys
from pathlib import Path
from c4s.errors import C4SError
from c4s.run.lease import holding
print("ready", flush=True)
sys.stdin.readline()
try:
    with holding(Path(sys.argv[1])):
        print("held", flush=True)
        sys.stdin.readline()
except C4SError as error:
    print(error.exit_code, error.line(), flush=True)
"""
Holder = Callable[[], subprocess.Popen[str]]


@pytest.fixture
def run(tmp_path: Path) -> Path:
    """A run folder with a plan, so that it stays."""
    folder = tmp_path / "run"
    folder.mkdir()
    RunFolder(folder).plan.write_text("{}")
    return folder


@pytest.fixture
def other(run: Path) -> Iterator[Holder]:
    """Starts processes that take the lease at a line and give it back at the next."""
    made: list[subprocess.Popen[str]] = []

    def start() -> subprocess.Popen[str]:
        made.append(
            subprocess.Popen(
                [sys.executable, "-c", HOLD, str(run)], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
            )
        )
        assert made[-1].stdout and made[-1].stdout.readline() == "ready\n"
        return made[-1]

    yield start
    for process in made:
        process.kill()
        process.communicate()


def told(process: subprocess.Popen[str], line: str = "\n") -> str:
    """What a process says after a line."""
    assert process.stdin and process.stdout
    process.stdin.write(line)
    process.stdin.flush()
    return process.stdout.readline().strip()


def changed_lease(run: Path, **update: Any) -> Path:
    """The lease in force with another owner."""
    path = max(RunFolder(run).leases.glob("*.json"))
    found = Lease.read(path)
    found.model_copy(update={"owner": found.owner.model_copy(update=update)}).write(path)
    return path


def test_the_second_is_told_who_holds_the_run_and_enters_once_it_is_given_back(run: Path, other: Holder) -> None:
    first = other()
    assert told(first) == "held"
    with pytest.raises(RunHeld) as refused, holding(run):
        pass
    line = refused.value.line()
    assert refused.value.exit_code == 2 and f"process {first.pid} on {os.uname().nodename}, since 20" in line
    assert str(run) in line and "--wait" in line and "stop that process" in line
    first.communicate("\n")
    with holding(run) as held:
        held.check()


def test_of_many_at_once_one_holds_and_each_other_is_told(run: Path, other: Holder) -> None:
    dead = other()
    assert told(dead) == "held"
    dead.kill()
    dead.wait()
    processes = [other() for _ in range(6)]
    for process in processes:
        assert process.stdin
        process.stdin.write("\n")
        process.stdin.flush()
    said = [process.stdout.readline().strip() for process in processes if process.stdout]
    holder = processes[said.index("held")]
    assert sorted(line[:4] for line in said) == ["2 " + str(run)[:2]] * 5 + ["held"]
    assert all(f"process {holder.pid} on" in line for line in said if line != "held")


def test_a_holder_that_was_killed_is_replaced_at_once(run: Path, other: Holder) -> None:
    first = other()
    assert told(first) == "held"
    first.send_signal(signal.SIGKILL)
    first.wait()
    with holding(run) as held:
        held.check()
    assert len(list(RunFolder(run).leases.iterdir())) == 1


def test_another_process_of_the_same_number_is_not_the_holder(run: Path, other: Holder) -> None:
    first = other()
    assert told(first) == "held"
    changed_lease(run, started_ticks=1)
    with holding(run):
        pass


def test_a_holder_elsewhere_keeps_the_run_until_its_signs_of_life_end(run: Path, monkeypatch: MonkeyPatch) -> None:
    monkeypatch.setattr(lease, "BEAT_S", 0.04)
    with holding(run):
        pass
    path = changed_lease(run, boot_id="another", host="far", pid=1)
    path.write_text(path.read_text().replace('"given_back": true', '"given_back": false'))
    with pytest.raises(RunHeld, match=r"process 1 on far, .*free 60 s after its last sign of life"), holding(run):
        pass
    record = path.stat()
    os.utime(path, ns=(record.st_atime_ns, record.st_mtime_ns - 61_000_000_000))
    with holding(run) as held:
        held.check()


def test_a_holder_here_that_is_stopped_is_replaced_when_its_signs_of_life_end(
    run: Path, other: Holder, monkeypatch: MonkeyPatch
) -> None:
    monkeypatch.setattr(lease, "BEAT_S", 0.04)
    first = other()
    assert told(first) == "held"
    first.send_signal(signal.SIGSTOP)
    with pytest.raises(RunHeld), holding(run):
        pass
    path = max(RunFolder(run).leases.glob("*.json"))
    record = path.stat()
    os.utime(path, ns=(record.st_atime_ns, record.st_mtime_ns - 61_000_000_000))
    with holding(run) as held:
        held.check()
    first.send_signal(signal.SIGCONT)


def test_a_clock_that_jumps_takes_no_lease_from_a_holder_elsewhere_that_lives(
    run: Path, monkeypatch: MonkeyPatch
) -> None:
    monkeypatch.setattr(lease, "BEAT_S", 0.04)
    with holding(run) as mine:
        path = changed_lease(run, boot_id="another", host="far", pid=1)
        record = path.stat()
        os.utime(path, ns=(record.st_atime_ns, record.st_mtime_ns - 3_600_000_000_000))
        beat = FolderLeases.sign

        def alive(place: FolderLeases, number: int) -> float | None:
            before = beat(place, number)
            mine.beat()
            return before

        monkeypatch.setattr(FolderLeases, "sign", alive)
        with pytest.raises(RunHeld, match="process 1 on far"), holding(run):
            pass


def test_a_lease_that_is_no_record_holds_nothing(run: Path) -> None:
    with holding(run):
        max(RunFolder(run).leases.iterdir()).write_text("{")
        with holding(run) as held:
            held.check()


def test_a_holder_finds_out_that_the_run_is_no_longer_its_own(run: Path) -> None:
    with holding(run) as held:
        path = changed_lease(run, started_ticks=1)
        with holding(run) as later:
            with pytest.raises(LeaseLost, match=rf"taken over by process {os.getpid()} on"):
                held.check()
            later.check()
        with pytest.raises(LeaseLost):
            held.check()
        assert not path.exists()
    with holding(run) as held:
        shutil.rmtree(RunFolder(run).leases)
        with pytest.raises(LeaseLost, match="the lease was removed"):
            held.check()


def test_a_run_that_was_refused_before_it_was_planned_leaves_no_folder(tmp_path: Path) -> None:
    with holding(tmp_path / "new"):
        assert (tmp_path / "new").is_dir()
    assert not (tmp_path / "new").exists()


def test_two_operators_of_one_plan(home: Path, tmp_path: Path, c4s: Command) -> None:
    own = apart(tmp_path / "home", home)
    command = ["run", "small", "-a", "noop", "-c", "text-flat-family"]
    folder = RunFolder(own / "runs/small")

    def begun(reached: Callable[[int], bool]) -> subprocess.Popen[str]:
        process = subprocess.Popen(
            [sys.executable, "-m", "c4s.cli", *command],
            env=environment(own),
            text=True,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
        )
        until(lambda: reached(process.pid), process)
        return process

    attempts = trial_in(own, "small", "noop", "text-flat-family").root

    def holds(pid: int) -> bool:
        leases = sorted(folder.leases.glob("[0-9]*"))
        return bool(leases) and Lease.read(leases[-1]).owner.pid == pid

    first = begun(lambda pid: (attempts / "attempt-1").exists())
    shutil.rmtree(folder.leases)
    _, said = first.communicate(timeout=120)
    assert first.returncode == 3 and "no longer held here: the lease was removed" in said, said
    assert not (attempts / "score.json").exists()

    first = begun(holds)
    second = c4s(*command, home=own)
    assert second.returncode == 2 and second.stderr.count("\n") == 1, second.stderr
    assert f"process {first.pid} on" in second.stderr and "works on this run" in second.stderr
    third = c4s(*command, "--wait", home=own)
    assert first.wait() == 0, first.communicate()
    assert third.returncode == 0 and "0 trials run" in third.stdout and "waiting for process" in third.stderr
    names = {path.name for path in attempts.glob("attempt-*")}
    assert names - {"attempt-1.interrupted-1"} == {"attempt-1", "attempt-2"}
    first.communicate()
