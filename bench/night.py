"""A night of trials in made time: the program of a trial, the pools and their order are the real ones, only the stages
take as long as they are told to and the clock jumps to what happens next.

    python -m bench.night [--run RUN] [--agent-minutes 15] [--spread 0.6] [--trials 1330] [--slots 1 8 64]
                          [--processors 8] [--start-s 0]

``--run`` is a run folder: each made trial takes the recorded times of a trial of its setting (export, gate, pictures,
judge, verifiers, score, rows). Without it the times are those of ``RECORDED``. The agent's time is log-normal with this
median and spread (sigma), cut at ``LONGEST`` times the median, as a budget cuts it. ``--start-s`` is what starting a
trial's attempt costs beyond that, such as a flow run of its own.
"""

from __future__ import annotations

import argparse
import asyncio
import math
import random
import selectors
import sys
import tempfile
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypeVar, TypeVarTuple

from bench.orchestration import planned
from bench.row import Row
from c4s.files import read_json_lines
from c4s.protocol.settings import INDOOR_REPAIR, OUTDOOR_REPAIR, TEXT_TO_SCENE
from c4s.records.folder import RunFolder
from c4s.records.plan import Plan
from c4s.run.drive import run_trials
from c4s.run.headroom import Headroom
from c4s.run.limits import LIMITS, Limit, Stage
from c4s.run.plan import Trial, trials
from c4s.run.pool import Pool
from c4s.verify.navigation.verifier import NAVIGATION
from c4s.verify.paired.verifier import PAIRED
from c4s.verify.physics.verifier import PHYSICS
from c4s.verify.repair.verifier import REPAIR
from c4s.verify.semantic.verifier import DETAILED, OVERVIEW

TRIALS, SLOTS, PROCESSORS = 1_330, (1, 8, 64), 8
AGENT_MINUTES, SPREAD, LONGEST = 15.0, 0.6, 4.0
GOAL_BUSY = 0.98
Args = TypeVarTuple("Args")
Made = TypeVar("Made")
Times = Mapping[str, float]
"""Seconds by the name under which a stage is recorded, ``attempt`` and ``orchestration`` left out."""
_GATE = {"score": 0.02, "persist": 0.2, NAVIGATION.name: 0.5}
RECORDED: dict[str, list[Times]] = {
    TEXT_TO_SCENE: [_GATE | {"integrity": 1.5, "look": 0.2, "judge": 0.2, DETAILED.name: 0.05, OVERVIEW.name: 0.02}],
    INDOOR_REPAIR: [
        _GATE | {"integrity": 2.6, "look": 9.4, "judge": 0.5, PAIRED.name: 0.02, REPAIR.name: 0.2, PHYSICS.name: 1.9}
    ],
    OUTDOOR_REPAIR: [
        _GATE | {"integrity": 2.7, "look": 4.9, "judge": 0.5, PAIRED.name: 0.02, REPAIR.name: 0.3, PHYSICS.name: 2.3}
    ],
}
"""Medians of 16 trials of the starter suite, on two cores that others used too."""


@dataclass(frozen=True)
class NightResult:
    """What came of a night."""

    slots: int
    makespan_h: float
    busy: float
    """Mean engine slots in use, from the first stage to the start of the last attempt."""
    queued: float
    """Mean stages that wait for a processor in that time."""
    most_queued: int
    processors: float
    """Mean processors in use, of those that there are."""


class _Selector(selectors.DefaultSelector):
    """Waits for nothing: the clock of its loop goes on by as much as it was to wait."""

    now = 0.0

    def select(self, timeout: float | None = None) -> list[tuple[selectors.SelectorKey, int]]:
        if timeout is None:
            raise RuntimeError("every stage waits, and none is at work")
        self.now += max(0.0, timeout)
        return super().select(0)


class _Loop(asyncio.SelectorEventLoop):
    """A loop in made time."""

    def __init__(self) -> None:
        self._made = _Selector()
        super().__init__(self._made)

    def time(self) -> float:
        return self._made.now

    def run_in_executor(
        self, executor: Executor | None, func: Callable[[*Args], Made], *args: *Args
    ) -> asyncio.Future[Made]:
        """What would run in a thread takes no time."""
        done: asyncio.Future[Made] = self.create_future()
        try:
            done.set_result(func(*args))
        except Exception as error:
            done.set_exception(error)
        return done


class _Room(Headroom):
    """There is room in made time."""

    def look(self) -> bool:
        return True


class _Pool(Pool):
    """A pool whose attempts have no budget to read."""

    def limit(self, stage: Stage, trial: Trial, plan: Plan) -> Limit:
        return LIMITS[stage]


def recorded(run: Path) -> dict[str, list[Times]]:
    """The stage times of a run's trials, by setting."""
    found: dict[str, list[Times]] = {}
    for trial in trials(run, run, Plan.read(RunFolder(run).plan)):
        times: dict[str, float] = {}
        if not trial.folder.score.is_file():
            continue
        for line in read_json_lines(trial.folder.stages):
            name = line["stage"].removesuffix("-1")
            if not name.startswith(("attempt", "orchestration", "integrity-")):
                times[name] = times.get(name, 0.0) + line["seconds"]
        found.setdefault(trial.case.setting, []).append(times)
    return found


def _agent_s(rng: random.Random, minutes: float, spread: float) -> float:
    return 60.0 * min(rng.lognormvariate(math.log(minutes), spread), LONGEST * minutes)


def night(
    slots: int,
    times: Mapping[str, Sequence[Times]],
    *,
    count: int = TRIALS,
    minutes: float = AGENT_MINUTES,
    spread: float = SPREAD,
    processors: int = PROCESSORS,
    start_s: float = 0.0,
    seed: int = 1,
) -> NightResult:
    """Run a night of trials in made time."""
    rng = random.Random(seed)
    with tempfile.TemporaryDirectory() as folder:
        plan, made = planned(Path(folder), count)
        known = [one for several in times.values() for one in several]
        takes = {trial.name: rng.choice(times.get(trial.case.setting) or known) for trial in made}
        agents = {trial.name: start_s + _agent_s(rng, minutes, spread) for trial in made}
        loop = _Loop()
        began = most = 0
        seen = began_last = 0.0
        area = [0.0, 0.0, 0.0]

        async def whole() -> None:
            async with _Pool(slots, processors=processors, headroom=_Room()) as pool:
                engines, own = pool.slots["engine"], pool.slots["processor"]

                def note() -> None:
                    nonlocal seen, most
                    most = max(most, own.waiting)
                    if began < len(made):
                        for place, amount in enumerate((engines.taken, own.waiting, own.taken)):
                            area[place] += amount * (loop.time() - seen)
                        seen = loop.time()

                async def run(stage: Stage, trial: Trial, plan: Plan, *arguments: Any) -> bool:
                    nonlocal began, began_last
                    note()
                    if stage == "attempt":
                        began += 1
                        began_last = loop.time()
                    await asyncio.sleep(_lasts_s(stage, arguments, takes[trial.name], agents[trial.name]))
                    note()
                    return True

                await run_trials(made, plan, pool, run)

        try:
            loop.run_until_complete(whole())
            ended = loop.time()
        finally:
            loop.close()
    busy, queued, used = (amount / (began_last or 1.0) for amount in area)
    return NightResult(slots, ended / 3600, busy, queued, most, used)


def _lasts_s(stage: Stage, arguments: Sequence[Any], times: Times, agent_s: float) -> float:
    """How long a stage takes. The engine of the gate takes the pictures too."""
    if stage == "attempt":
        return agent_s
    if stage == "integrity":
        return times.get("integrity", 0.0) + times.get("look", 0.0)
    if stage == "look":
        return 0.0
    return times.get(arguments[0] if stage == "verify" else stage, 0.0)


def rows() -> list[Row]:
    """Busy slots of a night of 1,330 trials."""
    made = []
    for slots in SLOTS:
        found = night(slots, RECORDED)
        name = f"night of {TRIALS:,} trials, busy of {slots} slots"
        made.append(Row(name, found.busy, f"{GOAL_BUSY:.0%}", found.busy >= GOAL_BUSY * slots, "slots"))
    return made


def main(arguments: Sequence[str] | None = None) -> int:
    """Print a table."""
    parser = argparse.ArgumentParser(prog="python -m bench.night", description=__doc__.splitlines()[0])
    parser.add_argument("--run", type=Path, help="a run folder with recorded stage times")
    parser.add_argument("--agent-minutes", type=float, default=AGENT_MINUTES, help="median of an attempt")
    parser.add_argument("--spread", type=float, default=SPREAD, help="sigma of its logarithm")
    parser.add_argument("--trials", type=int, default=TRIALS)
    parser.add_argument("--slots", type=int, nargs="+", default=SLOTS)
    parser.add_argument("--processors", type=int, default=PROCESSORS)
    parser.add_argument("--start-s", type=float, default=0.0, help="what starting an attempt costs beyond it")
    given = parser.parse_args(arguments)
    times = recorded(given.run) if given.run else RECORDED
    print("slots  makespan  busy slots  stages waiting (mean, most)  processors busy")
    for slots in given.slots:
        found = night(
            slots,
            times,
            count=given.trials,
            minutes=given.agent_minutes,
            spread=given.spread,
            processors=given.processors,
            start_s=given.start_s,
        )
        print(
            f"{slots:5}  {found.makespan_h:6.1f} h  {found.busy:7.2f} ({found.busy / slots:4.0%})  "
            f"{found.queued:12.2f} {found.most_queued:6}  {found.processors:19.2f} of {given.processors}"
        )
    return 0


if __name__ == "__main__":
    sys.exit(main())
