"""The order of a trial and the use of slots, with stages that wait for each other and never for a clock."""

from __future__ import annotations

import asyncio
from collections import Counter
from collections.abc import Callable, Coroutine
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from c4s.errors import MachineryFault
from c4s.protocol.settings import SETTINGS, Setting
from c4s.records.plan import Configuration, Plan, PlannedCase
from c4s.records.verdict import Verdict
from c4s.run.drive import run_trials
from c4s.run.faults import SceneFault
from c4s.run.limits import Limit, Stage
from c4s.run.plan import Trial, trials
from c4s.run.pool import Pool
from c4s.run.slots import Slots
from c4s.run.trial import run_trial
from c4s.verify.registry import is_judged, verifiers_of

STUCK_S = 60.0
"""A run that waits for something that never comes fails after so long; one that works does not take it."""
LIMITS: dict[Stage, Limit] = {
    "attempt": Limit("engine", 1.0),
    "integrity": Limit("engine", 1.0),
    "look": Limit("engine", 1.0),
    "judge": Limit("processor", 1.0),
    "verify": Limit("processor", 1.0),
    "control": Limit("engine", 1.0),
    "score": Limit("processor", 1.0),
    "persist": Limit("processor", 1.0),
}


class DummyPool(Pool):
    """Slots of a pool whose stages have no budget and run in no process."""

    def limit(self, stage: Stage, trial: Trial, plan: Plan) -> Limit:
        return LIMITS[stage]


def planned(root: Path, count: int, settings: tuple[Setting, ...] = SETTINGS) -> tuple[Plan, list[Trial]]:
    cases = [
        PlannedCase(
            case_id=f"case-{number}",
            alias=f"case-{number}",
            setting=settings[number % len(settings)],
            scene_id="made",
            agent_digest="",
            withheld_digest="",
        )
        for number in range(count)
    ]
    plan = Plan(
        run_id="made",
        suite_id="made",
        suite_digest="",
        configurations=[Configuration(name="noop", client="noop")],
        cases=cases,
        policy="",
        judge="rule",
        engine="headless",
        versions={},
    )
    return plan, list(trials(root, root, plan))


def finished(work: Coroutine[Any, Any, Any]) -> Any:
    async def bounded() -> Any:
        async with asyncio.timeout(STUCK_S):
            return await work

    return asyncio.run(bounded())


@pytest.mark.parametrize("slots", [1, 2, 4, 8, 16, 32, 64])
def test_every_slot_is_busy_while_there_is_work(tmp_path: Path, slots: int) -> None:
    plan, made = planned(tmp_path, 4 * slots)
    seen: Counter[str] = Counter()
    most = 0

    async def work() -> None:
        nonlocal most
        every_slot = asyncio.Barrier(slots)

        async with DummyPool(slots, processors=2) as pool:

            async def run(stage: Stage, trial: Trial, plan: Plan, *arguments: Any) -> Any:
                nonlocal most
                seen[stage] += 1
                most = max(most, pool.slots["engine"].taken)
                if stage == "attempt":
                    await every_slot.wait()
                return True

            assert await run_trials(made, plan, pool, run) == []

    finished(work())
    assert most == slots
    assert seen["attempt"] == seen["integrity"] == seen["look"] == seen["score"] == seen["persist"] == 4 * slots
    assert seen["judge"] == sum(is_judged(trial.case.setting) for trial in made)
    assert seen["verify"] == sum(len(verifiers_of(trial.case.setting)) for trial in made)


def test_a_slow_judge_holds_no_engine(tmp_path: Path) -> None:
    plan, made = planned(tmp_path, 6, ("text-to-scene",))
    attempted = asyncio.Semaphore(0)

    async def run(stage: Stage, trial: Trial, plan: Plan, *arguments: Any) -> Any:
        if stage == "attempt":
            attempted.release()
        if stage == "judge" and trial is made[0]:
            for _ in made:
                await attempted.acquire()
        return True

    async def work() -> None:
        async with DummyPool(1, processors=2) as pool:
            assert await run_trials(made, plan, pool, run) == []

    finished(work())


def test_the_earliest_trials_are_finished_first_and_few_are_begun(tmp_path: Path) -> None:
    plan, made = planned(tmp_path, 200)
    began, ended, ahead = [], [], []

    async def work() -> None:
        async with DummyPool(2, processors=2, requests=1) as pool:

            async def run(stage: Stage, trial: Trial, plan: Plan, *arguments: Any) -> Any:
                await asyncio.sleep(0)
                if stage == "attempt":
                    began.append(trial)
                if stage == "persist":
                    ended.append(trial)
                    ahead.append(len(began) - len(ended))
                return True

            assert await run_trials(made, plan, pool, run) == []
            assert max(ahead) <= pool.in_flight == 10

    finished(work())
    rank_of = {id(trial): rank for rank, trial in enumerate(made)}
    for told in (began, ended):
        ranks = [rank_of[id(trial)] for trial in told]
        assert sorted(ranks) == list(range(200))
        assert all(rank - place < 10 for place, rank in enumerate(ranks)), "one that is earlier was not even taken up"


def order_of(tmp_path: Path, setting: Setting, run: Callable[..., Any]) -> list[tuple[Any, ...]]:
    plan, (trial,) = planned(tmp_path, 1, (setting,))
    told: list[tuple[Any, ...]] = []

    async def do(stage: Stage, *arguments: Any) -> Any:
        told.append((stage, *arguments))
        value = await run(stage, *arguments)
        told.append((f"{stage} done", *arguments))
        return value

    finished(run_trial(trial, plan, do))
    return told


@pytest.mark.parametrize("setting", SETTINGS)
def test_what_needs_no_pictures_does_not_wait_for_them_and_the_rest_does(tmp_path: Path, setting: Setting) -> None:
    free = [verifier.name for verifier in verifiers_of(setting) if not verifier.needs & {"captures", "judgements"}]
    judged = [verifier.name for verifier in verifiers_of(setting) if "judgements" in verifier.needs]
    verified = asyncio.Semaphore(0)

    async def run(stage: Stage, *arguments: Any) -> Any:
        if stage == "look":
            for _ in free:
                await verified.acquire()
        if stage == "verify" and arguments[0] in free:
            verified.release()
        return True

    told = order_of(tmp_path, setting, run)
    assert told[:4] == [("attempt", 1), ("attempt done", 1), ("integrity", 1), ("integrity done", 1)]
    assert told[-4:] == [("score",), ("score done",), ("persist",), ("persist done",)]
    for name in free:
        assert told.index(("verify done", name)) < told.index(("look done",))
    for name in judged:
        assert told.index(("look done",)) < told.index(("judge",)) < told.index(("judge done",))
        assert told.index(("judge done",)) < told.index(("verify", name))
    assert (("judge",) in told) == bool(judged)


def test_an_invalid_submission_is_tried_once_more_and_never_verified(tmp_path: Path) -> None:
    async def never_valid(stage: Stage, *arguments: Any) -> Any:
        return stage != "integrity"

    told = order_of(tmp_path, "text-to-scene", never_valid)
    begun = [entry for entry in told if not entry[0].endswith("done")]
    assert begun == [("attempt", 1), ("integrity", 1), ("attempt", 2), ("integrity", 2), ("score",), ("persist",)]


def test_a_fault_costs_its_trial_after_what_runs_beside_it_has_ended(tmp_path: Path) -> None:
    plan, made = planned(tmp_path, 3, ("text-to-scene",))
    told: list[tuple[Any, ...]] = []
    looked = asyncio.Event()

    async def run(stage: Stage, trial: Trial, plan: Plan, *arguments: Any) -> Any:
        if trial is made[1] and stage == "look":
            looked.set()
            raise MachineryFault("no picture", where="here")
        if trial is made[1] and stage == "verify":
            await looked.wait()
        told.append((trial.case.case_id, stage, *arguments))
        return True

    async def work() -> Any:
        async with DummyPool(2, processors=2) as pool:
            return await run_trials(made, plan, pool, run)

    (pending,) = finished(work())
    assert pending.trial is made[1] and pending.reason == "here: no picture"
    free = {verifier.name for verifier in verifiers_of("text-to-scene") if "judgements" not in verifier.needs}
    assert {entry[2] for entry in told if entry[:2] == ("case-1", "verify")} == free, "what runs beside it is finished"
    assert {entry[1] for entry in told if entry[0] == "case-1"} == {"attempt", "integrity", "verify"}
    assert all((f"case-{number}", "persist") in told for number in (0, 2))


def test_what_a_scene_too_large_for_the_judge_costs_is_the_judged_verdicts(tmp_path: Path) -> None:
    async def run(stage: Stage, *arguments: Any) -> Any:
        if stage == "judge":
            raise SceneFault("it took longer than 900 s", code="resource_limit", where="judge of it")
        return True

    told = order_of(tmp_path, "text-to-scene", run)
    _, (trial,) = planned(tmp_path, 1, ("text-to-scene",))
    judged = {verifier.name for verifier in verifiers_of("text-to-scene") if "judgements" in verifier.needs}
    verdicts = {name: Verdict.read(path) for name, path in trial.folder.verdicts.items()}
    assert verdicts.keys() == judged and judged.isdisjoint({entry[1] for entry in told if entry[0] == "verify"})
    assert {verdict.status for verdict in verdicts.values()} == {"not_evaluated"}
    assert {verdict.reason for verdict in verdicts.values()} == {
        "resource_limit: judge of it: it took longer than 900 s"
    }
    assert told[-1] == ("persist done",)


@given(count=st.integers(1, 4), jobs=st.lists(st.tuples(st.integers(0, 3), st.booleans()), max_size=12))
def test_no_slot_is_lost_or_lent_twice_whoever_gives_up(count: int, jobs: list[tuple[int, bool]]) -> None:
    async def work() -> None:
        slots, inside, go = Slots(count), 0, asyncio.Event()

        async def job(rank: int) -> None:
            nonlocal inside
            async with slots.slot(rank):
                inside += 1
                assert inside <= count
                await go.wait()
                inside -= 1

        made = [asyncio.create_task(job(rank)) for rank, _ in jobs]
        await asyncio.sleep(0)
        assert slots.taken == inside == min(count, len(jobs))
        waiting = [task for task, (_, gives_up) in zip(made, jobs, strict=True) if gives_up][count:]
        go.set()
        for task in waiting:
            task.cancel()
        ended = await asyncio.gather(*made, return_exceptions=True)
        assert all(error is None or isinstance(error, asyncio.CancelledError) for error in ended)
        assert slots.taken == 0

    finished(work())
