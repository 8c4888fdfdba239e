"""Kills at random moments of a run, each followed by the same command: what is lost, repeated or left behind.

``python -m bench.moments [--count 50] [--seed 13]`` prints a row a moment and the totals, and ends with 1 where a row
fails. A moment is a share of the time that the undisturbed run takes; who is killed is drawn too: the command, one of
its worker processes, an engine, or all of them at once as when a machine loses its power.
"""

from __future__ import annotations

import argparse
import os
import random
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from pathlib import Path
from typing import Final

from bench.fault_table import CASE, WHO, Fault, Scene, below
from bench.faults import MISSED, FaultResult, contents, print_table, scene, small_suite, tried
from bench.waiting import until

COMMAND: Final = (
    sys.executable,
    "-m",
    "c4s.cli",
    "run",
    "small",
    "-a",
    "noop",
    "-a",
    "oracle",
    "-c",
    CASE,
    "--slots",
    "1",
)
VICTIMS: Final = ("the command", "a worker", "an engine", "all")


class LongerScene(Scene):
    """A scene whose command runs two agents."""

    def start(self, *command: str) -> subprocess.Popen[str]:
        return super().start(*(command or COMMAND))


def _chosen(process: int, victim: str, draw: random.Random) -> list[int]:
    """Whom to kill; nobody where there is none of the kind."""
    family = below(process)
    if victim == "the command":
        return [process]
    if victim == "all":
        return [process, *family]
    word = WHO["workers" if victim == "a worker" else "engine"]
    found = sorted(pid for pid, line in family.items() if word in line)
    return [draw.choice(found)] if found else []


def moments(count: int, seed: int, lasts_s: float) -> Iterator[Fault]:
    """So many kills, drawn from a seed, within the time that a run lasts."""
    draw = random.Random(seed)
    for number in range(count):
        share, victim, own = draw.random(), draw.choice(VICTIMS), random.Random(draw.random())
        yield Fault(f"{number + 1}: {victim} at {share:.1%}", False, _kill_at(share * lasts_s, victim, own))


def _kill_at(seconds: float, victim: str, draw: random.Random) -> Callable[[Scene], object]:
    """Kills at a moment, or as soon after it as there is one to kill."""

    def do(made: Scene) -> str:
        process = made.start()
        with suppress(subprocess.TimeoutExpired):
            process.wait(seconds)
        killed = until(lambda: [] if process.poll() is not None else _chosen(process.pid, victim, draw) or None)
        for one in killed:
            with suppress(ProcessLookupError):
                os.kill(one, signal.SIGKILL)
        process.communicate()
        return f"{process.returncode}" if killed else f"{MISSED} {process.returncode}"

    return do


def results(built: Path, count: int, seed: int) -> Iterator[FaultResult]:
    """Every moment's result, after an undisturbed run that tells how long one lasts."""
    with scene(built, None, LongerScene) as made:
        warm = made.run()
        if warm.returncode:
            raise SystemExit(f"the undisturbed run failed: {warm.stderr}")
    with scene(built, None, LongerScene) as made:
        started = time.monotonic()
        made.run()
        lasts_s, wanted = time.monotonic() - started, contents(made.home)
    print(f"an undisturbed run lasts {lasts_s:.1f} s and writes {len(wanted)} rows", file=sys.stderr)
    for fault in moments(count, seed, lasts_s):
        yield tried(fault, built, built, wanted, LongerScene)


def main(arguments: Sequence[str] | None = None) -> int:
    """Print the table; 1 where a row fails."""
    parser = argparse.ArgumentParser(prog="python -m bench.moments", description=__doc__)
    parser.add_argument("--count", type=int, default=50)
    parser.add_argument("--seed", type=int, default=13)
    given = parser.parse_args(arguments)
    found = []
    with small_suite() as built:
        for one in results(built, given.count, given.seed):
            print(one.fault, "holds" if one.holds else f"FAILS: {one}", file=sys.stderr, flush=True)
            found.append(one)
    print_table(found)
    return 0 if all(one.holds for one in found) else 1


if __name__ == "__main__":
    sys.exit(main())
