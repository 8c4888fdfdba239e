"""A run of thousands of trials on this machine: what drives them, not what works in them.

    python -m bench.scale [--cases 190] [--configurations 14] [--repeats 3] [--stages instant|prefect|noop] [--start]

Each configuration is tried on every case through the same path as ``c4s run``: plan, checks, lease, schedule, worker
processes, rows, database, pages. ``instant``: the stages return at once with what the warehouse reads of them (the
default); ``prefect``: they do so as Prefect tasks of one flow, on an ephemeral server; ``noop``: nothing is replaced,
the agent ``noop`` works in real engines. ``--start`` ends at the start of the first attempt. The memory is of the
process that drives, and of all its processes together, sampled once a second.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from statistics import median

from bench.orchestration import QUIET
from bench.row import Row

STAGES = ("instant", "prefect", "noop")
GOAL_S, GOAL_START_S, GOAL_GROWTH = 0.3, 60.0, 1.15
SAMPLED_S = 1.0
_TASK = """id: made-{number}
kind: scene_generation
inputs:
  prompt: "Yard {number}.\\n\\n=== ASSET PALETTE ===\\n\\n- box | Box | props | 1x1x1 m | /Game/P/SM_Box.SM_Box\\n"
  init_map: /Game/Blank
  size_m: 200
  budget:
    tool_calls: 10
    wall_minutes: 5
"""


@dataclass(frozen=True)
class ScaleResult:
    """What a run took."""

    trials: int
    start_s: float
    """From the command to the start of the first attempt."""
    start_cpu_s: float
    """Processor time until then, imports included: other work on the machine does not count."""
    run_s: float
    """From there to the last row stored."""
    end_s: float
    """From there to the end: database and pages."""
    pending: int
    orchestration_s: float
    """A trial, as recorded with it: what was spent beside its stages."""
    stages_s: float
    """A trial, all its stages."""
    driver_mb: tuple[float, float]
    """Resident memory of the process that drives: median of the second and of the last tenth of the run of trials."""
    ending_mb: float
    """The same at most, after the last row: the database and the pages are made then."""
    most_mb: float
    """Of all processes together, at most."""
    answers_s: float
    """The leaderboard, asked for afterwards."""
    failures: str = ""


def made_suite(home: Path, count: int) -> None:
    """Build the suite ``made`` of so many small cases in a home."""
    tasks = home / "tasks"
    for number in range(count):
        (tasks / f"made-{number}").mkdir(parents=True)
        (tasks / f"made-{number}" / "task.yaml").write_text(_TASK.format(number=number))
    command = [sys.executable, "-m", "c4s.cli", "suite", "import", "code4scene", str(tasks), "--id", "made"]
    subprocess.run(command, env={**os.environ, "C4S_HOME": str(home)}, check=True, stdout=subprocess.DEVNULL)


def measured(cases: int, configurations: int, repeats: int, stages: str, *, start_only: bool = False) -> ScaleResult:
    """Make a suite, run it, and say what it took."""
    with tempfile.TemporaryDirectory() as folder:
        home = Path(folder)
        made_suite(home, cases)
        names = []
        for number in range(configurations):
            names.append(home / f"agent-{number}.yaml")
            names[-1].write_text(f"name: agent-{number}\nclient: noop\n")
        asked = [str(repeats), stages, str(int(start_only)), *map(str, names)]
        process = subprocess.Popen(
            [sys.executable, "-m", "bench.scale_run", str(home), *asked],
            env={**os.environ, **QUIET, "C4S_HOME": str(home), "PREFECT_HOME": str(home / "prefect")},
            stdout=subprocess.PIPE,
            text=True,
        )
        samples: list[tuple[float, float, float]] = []
        ended = threading.Event()
        watching = threading.Thread(target=_sample, args=(process.pid, samples, ended))
        watching.start()
        told, _ = process.communicate()
        ended.set()
        watching.join()
        if process.returncode:
            raise RuntimeError(f"the run ended with {process.returncode}")
        made = json.loads(told.splitlines()[-1])
        ended_s = max((at for at, _, _ in samples), default=0.0)
        last_s, first_s = ended_s - made["end_s"], ended_s - made["end_s"] - made["run_s"]
        own = [mb for at, mb, _ in samples if first_s <= at <= last_s] or [0.0]
        tenth = max(1, len(own) // 10)
        return ScaleResult(
            **made,
            driver_mb=(median(own[tenth : 2 * tenth] or own), median(own[-tenth:])),
            ending_mb=max((mb for at, mb, _ in samples if at > last_s), default=0.0),
            most_mb=max((whole for _, _, whole in samples), default=0.0),
        )


def _sample(process: int, samples: list[tuple[float, float, float]], ended: threading.Event) -> None:
    """The time (s), and resident memory (MB) of a process, and of it with all that it started, until the end."""
    started = time.perf_counter()
    while not ended.wait(SAMPLED_S):
        memory, parents = _resident()
        tree = {process}
        while grown := {child for child, parent in parents.items() if parent in tree} - tree:
            tree |= grown
        if process in memory:
            whole = sum(memory.get(one, 0.0) for one in tree)
            samples.append((time.perf_counter() - started, memory[process], whole))


def _resident() -> tuple[dict[int, float], dict[int, int]]:
    """Resident memory (MB) and parent of every process."""
    memory, parents = {}, {}
    for place in Path("/proc").glob("[0-9]*"):
        try:
            told = dict(line.split(":", 1) for line in (place / "status").read_text().splitlines() if ":" in line)
        except OSError:
            continue
        if "VmRSS" in told:
            memory[int(place.name)] = int(told["VmRSS"].split()[0]) / 1024
            parents[int(place.name)] = int(told["PPid"])
    return memory, parents


def rows(cases: int = 30, configurations: int = 14, repeats: int = 1) -> list[Row]:
    """A smaller run with instant stages."""
    made = measured(cases, configurations, repeats, "instant")
    return [
        Row(f"start of {made.trials:,} trials", made.start_s, f"{GOAL_START_S:g} s", made.start_s < GOAL_START_S),
        Row(
            f"orchestration of one of {made.trials:,} trials",
            made.orchestration_s,
            f"{GOAL_S} s",
            made.orchestration_s < GOAL_S and not made.pending,
        ),
        Row(
            f"memory of {made.trials:,} trials, last tenth to second",
            made.driver_mb[1] / made.driver_mb[0],
            f"{GOAL_GROWTH}",
            made.driver_mb[1] < GOAL_GROWTH * made.driver_mb[0],
            "times",
        ),
    ]


def main(arguments: Sequence[str] | None = None) -> int:
    """Run and print; 1 where trials are pending."""
    parser = argparse.ArgumentParser(prog="python -m bench.scale", description=__doc__.splitlines()[0])
    parser.add_argument("--cases", type=int, default=190)
    parser.add_argument("--configurations", type=int, default=14)
    parser.add_argument("--repeats", type=int, default=3)
    parser.add_argument("--stages", choices=STAGES, default="instant")
    parser.add_argument("--start", action="store_true", help="end at the start of the first attempt")
    given = parser.parse_args(arguments)
    made = measured(given.cases, given.configurations, given.repeats, given.stages, start_only=given.start)
    print(json.dumps(asdict(made), indent=1))
    return 1 if made.pending and not given.start else 0


if __name__ == "__main__":
    started = time.perf_counter()
    code = main()
    print(f"{time.perf_counter() - started:.0f} s in all", file=sys.stderr)
    sys.exit(code)
