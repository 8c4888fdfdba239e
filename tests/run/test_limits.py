"""Worker processes that die, do not end, or grow: what that costs, and what is put on record."""

from __future__ import annotations

import asyncio
import json
import os
import signal
import subprocess
import sys
from collections.abc import Callable, Coroutine
from pathlib import Path
from typing import Any

import pytest

from bench.waiting import until
from c4s.errors import BadInput, MachineryFault, OverLimit
from c4s.run.faults import SceneFault
from c4s.run.limits import LIMITS, Limit
from c4s.run.pool import Pool
from c4s.run.processes import WorkerDied, _family
from tests.run.conftest import apart, environment, trial_in
from tests.run.jobs import (
    child_that_stays,
    child_without_parent,
    engine_that_grows,
    make_temporary,
    note_process,
    refuse,
    sweep_temporary,
)
from warehouse.database import rows

ROOT = Path(__file__).parents[2]
SOON = Limit("processor", 3.0)
OF_SCENE = Limit("engine", 3.0, of_scene=True)
SMALL = Limit("engine", 120.0, of_scene=True, memory_bytes=512 << 20)
LONG = Limit("processor", 120.0)


def in_pool(work: Callable[[Pool], Coroutine[Any, Any, Any]]) -> Any:
    async def held() -> Any:
        async with Pool(2) as pool:
            return await work(pool)

    return asyncio.run(held())


def gone(process: int) -> bool:
    """Whether a process has ended."""
    try:
        return Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[0] == "Z"
    except (FileNotFoundError, ProcessLookupError):
        return True


def wait_until_gone(processes: list[int]) -> None:
    """A process that never ends is ended by the test's own limit."""
    until(lambda: all(map(gone, processes)))


def test_a_worker_that_dies_costs_its_own_job_only(tmp_path: Path) -> None:
    async def work(pool: Pool) -> None:
        others = [pool.run(LONG, pow, number, 2) for number in range(6)]
        done = await asyncio.gather(
            pool.run(LONG, note_process, tmp_path / "pid", "die"), *others, return_exceptions=True
        )
        assert isinstance(done[0], WorkerDied) and "SIGKILL" in done[0].what and done[0].exit_code == 3
        assert [value for value, _ in done[1:]] == [number**2 for number in range(6)]

    in_pool(work)


@pytest.mark.parametrize("job", [child_that_stays, child_without_parent])
def test_a_stage_over_its_time_is_ended_with_its_children(tmp_path: Path, job: Callable[[Path], None]) -> None:
    async def work(pool: Pool) -> None:
        with pytest.raises(OverLimit, match="longer than 3 s") as raised:
            await pool.run(SOON, job, tmp_path / "child")
        assert raised.value.exit_code == 3 and not isinstance(raised.value, SceneFault)
        assert (await pool.run(LONG, pow, 3, 2))[0] == 9

    in_pool(work)
    wait_until_gone([int((tmp_path / "child").read_text())])


@pytest.mark.parametrize(
    ("limit", "how", "reason"), [(OF_SCENE, "loop", "longer than 3 s"), (SMALL, "grow", "512 MiB")]
)
def test_what_the_scene_causes_is_an_outcome_after_a_second_fresh_worker(
    tmp_path: Path, limit: Limit, how: str, reason: str
) -> None:
    async def work(pool: Pool) -> None:
        await asyncio.gather(*(pool.run(LONG, pow, number, 2) for number in range(3)))
        idle = {process.pid for process in pool._idle}
        with pytest.raises(SceneFault, match=reason):
            await pool.run(limit, note_process, tmp_path / "pids", how)
        first, second = map(int, (tmp_path / "pids").read_text().split())
        assert first in idle and second not in idle

    in_pool(work)


def test_an_engine_over_its_limits_is_an_outcome_too(tmp_path: Path) -> None:
    async def work(pool: Pool) -> None:
        with pytest.raises(SceneFault, match="more than 512 MiB of memory"):
            await pool.run(Limit("engine", 120.0, of_scene=True), engine_that_grows, tmp_path)
        assert len(set((tmp_path / "pids").read_text().split())) == 2
        with pytest.raises(OverLimit) as raised:
            await pool.run(LONG, engine_that_grows, tmp_path)
        assert not isinstance(raised.value, SceneFault) and raised.value.exit_code == 3

    in_pool(work)


@pytest.mark.parametrize(
    ("how", "kind", "told"), [("leave", MachineryFault, "SystemExit: 7"), ("unlock", ValueError, "kind")]
)
def test_what_a_stage_raises_comes_back_with_where_it_was_raised(
    tmp_path: Path, how: str, kind: type[Exception], told: str
) -> None:
    async def work(pool: Pool) -> None:
        with pytest.raises(kind, match=told) as raised:
            await pool.run(LONG, note_process, tmp_path / "pid", how)
        assert "in note_process" in raised.value.__notes__[0]
        with pytest.raises(MachineryFault, match="cannot leave its process"):
            await pool.run(LONG, open, os.devnull)
        with pytest.raises(BadInput):
            await pool.run(LONG, refuse)

    in_pool(work)


def test_temporary_files_of_an_ended_worker_are_removed(tmp_path: Path) -> None:
    async def work(pool: Pool) -> Path:
        folder, _ = await pool.run(LONG, os.getenv, "TMPDIR")
        assert folder is not None and Path(folder).is_dir()
        return Path(folder)

    assert not in_pool(work).exists()


def test_every_stage_has_a_limit_and_those_that_read_the_scene_alone_are_the_agents() -> None:
    assert {stage for stage, limit in LIMITS.items() if limit.of_scene} == {"integrity", "look", "judge", "verify"}
    assert all(limit.seconds > 0 and limit.memory_bytes > 0 for limit in LIMITS.values())


def _command(home: Path, broken: str, *arguments: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-c", "from tests.run.broken import main; main()", *arguments],
        env=environment(home) | {"BROKEN": broken},
        cwd=ROOT,
        text=True,
        capture_output=True,
        timeout=290,
        check=False,
    )


@pytest.mark.timeout(900)
def test_stages_that_the_scene_breaks_are_outcomes_and_a_dead_worker_is_a_pending_trial(
    home: Path, tmp_path: Path
) -> None:
    here = apart(tmp_path / "home", home)
    run = ("run", "small", "-a", "oracle", "-a", "noop", "--slots", "2", "--json")
    broken = "look:oracle:text:grows,integrity:oracle:indoor-flat-01:grows,verify:oracle:indoor-flat-02:loops"
    done = _command(here, f"{broken},score:noop:indoor-flat-01:dies", *run)
    assert done.returncode == 3, done.stderr
    (line,) = [line for line in done.stderr.splitlines() if line.startswith("c4s: ")]
    assert "1 of 6 trials are pending" in line and "score of noop/indoor-flat-01" in line and "SIGKILL" in line

    scores = {
        row["case_id"].split("-")[1] + row["case_id"].split("-")[2]: row
        for row in rows(here / "warehouse", "SELECT * FROM case_scores WHERE configuration = 'oracle'")
    }
    text, first, second = scores["flatfamily"], scores["flat01"], scores["flat02"]
    assert first["status"] == "zero_invalid_candidate" and "resource_limit" in str(first["reason"])
    assert second["status"] == "measured_with_missing_zero" and second["score"] == 0.0
    assert text["status"] == "measured_with_missing_zero" and text["overview"] == 0.0 and text["detailed"] > 0.0

    of_text, of_first, of_second = (trial_in(here, "small", "oracle", row["case_id"]) for row in (text, first, second))
    captures = of_text.evidence.captures_index
    assert json.loads(captures.read_text())["views"] == [] and "MiB" in json.loads(captures.read_text())["not_taken"]
    verdicts = [json.loads(path.read_text()) for path in of_second.root.glob("verdicts/*.json")]
    late = [verdict for verdict in verdicts if verdict["status"] == "not_evaluated"]
    assert {verdict["verifier"] for verdict in late} >= {"paired"} and len(late) == 4
    assert all("longer than 12 s" in verdict["reason"] for verdict in late)
    assert len(list(of_first.root.glob("attempt-?/integrity.json"))) == 2

    again = _command(here, "", *run)
    assert again.returncode == 0 and json.loads(again.stdout)["ran"] == 1, again.stderr


def test_a_run_that_is_killed_leaves_no_process(home: Path, tmp_path: Path) -> None:
    here = apart(tmp_path / "home", home)
    two = ("-c", "text-flat-family", "-c", "indoor-flat-01-mirrored-bath")
    command = [sys.executable, "-m", "c4s.cli", "run", "small", "-a", "noop", *two, "--slots", "2"]
    process = subprocess.Popen(
        command, env=environment(here), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True
    )
    until(lambda: any((here / "runs").rglob("trajectory.jsonl")), process)
    family = until(lambda: found if len(found := _family(process.pid)) >= 4 else None, process)
    os.kill(process.pid, signal.SIGKILL)
    process.wait()
    wait_until_gone(family[1:])
    done = subprocess.run(command, env=environment(here), capture_output=True, text=True, timeout=280, check=False)
    assert done.returncode == 0, done.stderr


def test_a_worker_whose_temporary_folder_was_cleaned_away_goes_on() -> None:
    async def work(pool: Pool) -> None:
        swept = (await pool.run(LONG, sweep_temporary))[0]
        assert not Path(swept).exists()
        assert (await pool.run(LONG, make_temporary))[0] == swept

    in_pool(work)
