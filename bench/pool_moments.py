"""Kills at random moments of a run on work pools, each followed by `c4s up` and the same deployment run.

``python -m bench.pool_moments [--count 8] [--seed 13] [--database URL]`` prints a row a moment and the totals, and ends
with 1 where a row fails. Killed or cut off are, in turn: the coordinator's flow run, a trial's flow run, all workers of
the pool engines with the process that watches them, the server, and the network between the server and everybody (the
server stands still for 20 s).
"""

from __future__ import annotations

import argparse
import json
import os
import random
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Iterator, Sequence
from contextlib import suppress
from pathlib import Path
from typing import Any, Final

import httpx

from bench.fault_table import CASE, Scene
from bench.faults import MISSED, FaultResult, contents, orphans, print_table, scene, small_suite
from bench.waiting import until
from c4s.files import read_json
from c4s.run.lease import in_force
from c4s.run.store import FolderLeases

AGENTS: Final = ["noop", "random", "oracle"]
VICTIMS: Final = ("the coordinator", "a trial's flow run", "the engines' workers", "the server", "the network")
CUT_S: Final = 20.0
MOST_RUNS: Final = 4
LIMIT_S: Final = 900.0
_PARAMETERS: Final = {"suite": "small", "agents": AGENTS, "cases": [CASE], "workers": "pools"}
OVER: Final = "over"
_OVER: Final = ("COMPLETED", "FAILED", "CRASHED", "CANCELLED")


class Pools:
    """A service in a scene's home."""

    def __init__(self, made: Scene, database: str | None) -> None:
        with socket.socket() as probe:
            probe.bind(("127.0.0.1", 0))
            self._port = str(probe.getsockname()[1])
        self._made, self._database = made, database
        self.url = f"http://127.0.0.1:{self._port}/api"
        made.settings |= {"PREFECT_HOME": str(made.home / "prefect"), "PREFECT_API_URL": self.url}

    def up(self) -> None:
        """Start what is missing."""
        slots = ["--engines", "1", "--verifiers", "1", "--judges", "0", "--port", self._port]
        self._run("c4s.cli", "up", *slots, *(["--database", self._database] if self._database else []))

    def down(self) -> None:
        """End all of it."""
        self._run("c4s.cli", "down")

    def start(self) -> str:
        """Start the deployment; the flow run's id."""
        given = [f"--param={name}={json.dumps(value)}" for name, value in _PARAMETERS.items()]
        told = self._run("prefect", "deployment", "run", "evaluate/pools", *given)
        return next(line.split()[-1] for line in told.splitlines() if "UUID" in line)

    def state(self, flow_run: str) -> str:
        """The type of a flow run's state; empty where the server does not say."""
        try:
            return str(httpx.get(f"{self.url}/flow_runs/{flow_run}", timeout=5.0).json()["state_type"])
        except (httpx.HTTPError, KeyError, ValueError):
            return ""

    def ended(self, flow_run: str) -> str:
        """How a flow run ends."""
        deadline = time.monotonic() + LIMIT_S
        while (state := self.state(flow_run)) not in _OVER:
            if time.monotonic() > deadline:
                return "NEVER"
            time.sleep(1.0)
        return state

    def hit(self, victim: str) -> bool:
        """Kill it, or cut it off; False where it is not there at the moment."""
        record: dict[str, Any] = read_json(self._made.home / "service.json")
        if victim == "the network":
            pid = int(record["server"]["pid"])
            os.kill(pid, signal.SIGSTOP)
            time.sleep(CUT_S)
            os.kill(pid, signal.SIGCONT)
            return True
        if victim == "the server":
            found = [int(record["server"]["pid"])]
        elif victim == "the engines' workers":
            found = [int(record["workers"]["engines"]["pid"])]
        else:
            run = self._made.folder.root
            places = [run / "lease"] if victim == "the coordinator" else sorted(run.glob("*/*/r1/lease"))
            held = [lease.owner.pid for place in places if (lease := in_force(FolderLeases(place)))]
            found = held[:1]
        for pid in found:
            with suppress(ProcessLookupError):
                os.kill(pid, signal.SIGKILL)
        return bool(found)

    def _run(self, *command: str) -> str:
        done = subprocess.run(
            [sys.executable, "-m", *command],
            env=self._made.settings,
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            check=False,
        )
        if done.returncode:
            raise SystemExit(f"{' '.join(command)} ended with {done.returncode}: {done.stderr[-2000:]}")
        return done.stdout


def _one(
    built: Path, victim: str | None, seconds: float, wanted: Sequence[str], name: str, database: str | None
) -> Any:
    """A run on pools with a kill in it; without a victim how long it took, and its rows."""
    with scene(built, None) as made:
        pools = Pools(made, database)
        pools.up()
        started, ends = time.monotonic(), []
        try:
            flow_run = pools.start()
            if victim is not None:
                time.sleep(max(0.0, seconds - (time.monotonic() - started)))
                if until(lambda: OVER if pools.state(flow_run) in _OVER else pools.hit(victim)) == OVER:
                    ends.append(MISSED)
                pools.up()
            ends.append(pools.ended(flow_run))
            while ends[-1] != "COMPLETED" and len(ends) < MOST_RUNS:
                ends.append(pools.ended(pools.start()))
            lasted, found = time.monotonic() - started, contents(made.home)
        finally:
            pools.down()
        if victim is None:
            return lasted, found
        repeated = len(list((made.home / "runs").glob("*/*/*/r*/attempt-?.interrupted-*")))
        stay, left = len(orphans(made.mark)), len(list(made.temporary.iterdir()))
        code = "0" if ends[-1] == "COMPLETED" else "3"
        told = f"{' '.join(ends).lower()} {code}"
        return FaultResult(name, len(set(found) ^ set(wanted)), repeated, stay, left, told)


def results(built: Path, count: int, seed: int, database: str | None) -> Iterator[FaultResult]:
    """Every moment's result, after an undisturbed run."""
    lasts_s, wanted = _one(built, None, 0.0, (), "", database)
    print(f"an undisturbed run lasts {lasts_s:.1f} s and writes {len(wanted)} rows", file=sys.stderr)
    draw = random.Random(seed)
    for number in range(count):
        share, victim = draw.random(), VICTIMS[number % len(VICTIMS)]
        name = f"{number + 1}: {victim} at {share:.1%}"
        yield _one(built, victim, share * lasts_s, wanted, name, database)


def main(arguments: Sequence[str] | None = None) -> int:
    """Print the table; 1 where a row fails."""
    parser = argparse.ArgumentParser(prog="python -m bench.pool_moments", description=__doc__)
    parser.add_argument("--count", type=int, default=8)
    parser.add_argument("--seed", type=int, default=13)
    parser.add_argument("--database", help="PostgreSQL URL for the server (default: SQLite)")
    given = parser.parse_args(arguments)
    found = []
    with small_suite() as built:
        for one in results(built, given.count, given.seed, given.database):
            print(one.fault, "holds" if one.holds else f"FAILS: {one}", file=sys.stderr, flush=True)
            found.append(one)
    print_table(found)
    return 0 if all(one.holds for one in found) else 1


if __name__ == "__main__":
    sys.exit(main())
