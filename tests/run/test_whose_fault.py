"""Whose fault a failure is: the table of ``c4s.errors``, a test a row, and what comes of it in a trial."""

from __future__ import annotations

import asyncio
import errno
import os
import pickle
from collections.abc import Callable
from pathlib import Path
from typing import Any, get_args

import pytest

from c4s.engine import EngineCallError, EngineDied
from c4s.engine.answers import WrongAnswer
from c4s.engine.bridge import BridgeFault
from c4s.engine.faults import EngineOverLimit
from c4s.errors import (
    MOST_REPEATS,
    ROWS,
    TABLE,
    AgentFault,
    BadInput,
    MachineryFault,
    MachineShort,
    OverLimit,
    Place,
    Unforeseen,
    Whose,
    row_of,
    shortage,
)
from c4s.evidence import SceneUnreadable
from c4s.records.attempt import AttemptOutcome
from c4s.run import repeats
from c4s.run.faults import SceneFault, may_be_the_scenes, of_machinery, whose
from c4s.run.limits import Limit, Stage
from c4s.run.plan import Trial
from c4s.run.pool import Pool
from c4s.run.processes import WorkerDied
from c4s.run.trial import run_trial
from tests.run.jobs import fail_to_be_read, fill_the_disk, note_and_raise
from tests.run.test_orchestration import finished, planned

OF_SCENE = Limit("engine", 60.0, of_scene=True)
EXAMPLES: dict[str, BaseException] = {
    **{name: OSError(getattr(errno, name), "") for name in ROWS if name.startswith("E") and name.isupper()},
    "BadInput": BadInput("no such file"),
    "SceneUnreadable": SceneUnreadable("it names no world", code="unloadable"),
    "AgentFault": AgentFault("no idea"),
    "MachineryFault": MachineryFault("the gateway did not start"),
    "OverLimit": OverLimit("it took longer than 600 s"),
    "EngineOverLimit": EngineOverLimit("too large", during="call", where="logs"),
    "EngineDied": EngineDied("SIGSEGV", during="call", where="logs"),
    "BridgeFault": BridgeFault("no answer"),
    "WrongAnswer": WrongAnswer("a list"),
    "EngineCallError": EngineCallError("ValueError: no", function="a.b", kind="ValueError"),
    "WorkerDied": WorkerDied("SIGKILL"),
    "MemoryError": MemoryError(),
    "Unforeseen": Unforeseen("KeyError: 'a'"),
    "Exception": KeyError("a"),
}
"""An error of every row."""
OUTCOMES: dict[str, tuple[Whose, Whose, Whose, Whose]] = {
    "ENOSPC": ("machinery", "machinery", "machinery", "machinery"),
    "EDQUOT": ("machinery", "machinery", "machinery", "machinery"),
    "EIO": ("machinery", "machinery", "machinery", "machinery"),
    "EROFS": ("machinery", "machinery", "machinery", "machinery"),
    "ENFILE": ("machinery", "machinery", "machinery", "machinery"),
    "EMFILE": ("doubt", "doubt", "machinery", "machinery"),
    "ENOBUFS": ("doubt", "doubt", "machinery", "machinery"),
    "ENOMEM": ("doubt", "doubt", "machinery", "machinery"),
    "BadInput": ("input", "input", "input", "input"),
    "SceneUnreadable": ("input", "input", "scene", "input"),
    "AgentFault": ("agent", "agent", "agent", "agent"),
    "MachineryFault": ("machinery", "machinery", "machinery", "machinery"),
    "OverLimit": ("doubt", "doubt", "scene", "machinery"),
    "EngineOverLimit": ("doubt", "agent", "scene", "machinery"),
    "EngineDied": ("doubt", "agent", "scene", "machinery"),
    "BridgeFault": ("doubt", "agent", "scene", "machinery"),
    "WrongAnswer": ("doubt", "agent", "scene", "machinery"),
    "EngineCallError": ("doubt", "agent", "scene", "machinery"),
    "WorkerDied": ("doubt", "doubt", "scene", "machinery"),
    "MemoryError": ("doubt", "doubt", "scene", "machinery"),
    "Unforeseen": ("doubt", "doubt", "machinery", "machinery"),
    "Exception": ("doubt", "doubt", "machinery", "machinery"),
}


@pytest.mark.parametrize("failure", [row.failure for row in TABLE])
def test_every_row_decides(failure: str) -> None:
    error = EXAMPLES[failure]
    assert tuple(whose(error, place) for place in get_args(Place)) == OUTCOMES[failure]
    assert row_of(pickle.loads(pickle.dumps(error))) is ROWS[failure], "the same on the other side of a process"


def test_no_score_is_made_of_what_the_machine_is_short_of() -> None:
    for name in OUTCOMES:
        if not (name.startswith("E") and name.isupper()):
            continue
        fault = BridgeFault("cannot reach the engine")
        fault.__cause__ = OSError(getattr(errno, name), "", "/somewhere")
        short = shortage(fault)
        assert short is not None and (short.name, short.where) == (name, "/somewhere")
        for place in get_args(Place):
            assert whose(fault, place) == whose(short, place) == ROWS[name].whose(place) != "agent"
        assert isinstance(of_machinery(fault, where="here"), MachineShort) and not may_be_the_scenes(fault)
    assert shortage(OSError(errno.ENOENT, "")) is None and shortage(KeyError()) is None


def test_an_error_that_is_its_own_cause_is_told() -> None:
    first, second = EngineDied("SIGKILL", during="call", where="logs"), KeyError()
    first.__cause__ = first
    assert shortage(first) is None and row_of(first) is ROWS["EngineDied"]
    first.__cause__, second.__cause__ = second, first
    assert shortage(second) is None


def in_pool(limit: Limit, function: Callable[..., Any], *arguments: Any) -> Any:
    async def held() -> Any:
        async with Pool(1) as pool:
            return await pool.run(limit, function, *arguments)

    return asyncio.run(held())


@pytest.mark.parametrize(
    ("failure", "code"),
    [
        ("SceneUnreadable", "unloadable"),
        ("OverLimit", "resource_limit"),
        ("EngineOverLimit", "resource_limit"),
        ("EngineDied", "crash"),
        ("BridgeFault", "crash"),
        ("EngineCallError", "crash"),
    ],
)
def test_what_fails_twice_on_a_scene_is_called_by_its_code(tmp_path: Path, failure: str, code: str) -> None:
    with pytest.raises(SceneFault) as raised:
        in_pool(OF_SCENE, note_and_raise, tmp_path / "pids", EXAMPLES[failure])
    assert raised.value.code == code
    assert len(set((tmp_path / "pids").read_text().split())) == 2, "the second time in a fresh worker"


def test_a_bug_fails_again_and_says_so(tmp_path: Path) -> None:
    with pytest.raises(Unforeseen, match=r"KeyError.*a fresh worker did the same.*faults.jsonl") as raised:
        in_pool(OF_SCENE, note_and_raise, tmp_path / "pids", KeyError("a"))
    assert "in note_and_raise" in raised.value.__notes__[0] and raised.value.exit_code == 3


@pytest.mark.parametrize("limit", [OF_SCENE, Limit("processor", 60.0)])
def test_a_full_disk_in_a_stage_is_the_machines_and_is_not_tried_again(tmp_path: Path, limit: Limit) -> None:
    with pytest.raises(MachineShort, match=r"the disk is full.*make room") as raised:
        in_pool(limit, fill_the_disk, tmp_path / "pids")
    assert (raised.value.name, len((tmp_path / "pids").read_text().split())) == ("ENOSPC", 1)


def test_an_answer_that_the_parent_cannot_read_is_a_fault_and_its_worker_goes_on() -> None:
    async def work() -> None:
        async with Pool(1) as pool:
            for returned in (True, False):
                with pytest.raises(MachineryFault, match="cannot be read: RuntimeError"):
                    await pool.run(Limit("processor", 60.0), fail_to_be_read, os.getpid(), returned)
            assert (await pool.run(Limit("processor", 60.0), pow, 3, 2))[0] == 9

    asyncio.run(work())


def trial_of(tmp_path: Path) -> tuple[Any, Trial]:
    plan, (trial,) = planned(tmp_path, 1, ("text-to-scene",))
    return plan, trial


def driven(tmp_path: Path, stages: dict[Stage, Callable[..., Any]]) -> tuple[Trial, list[Stage], Exception | None]:
    """Run a trial whose stages are functions: what was done, and what left it pending."""
    plan, trial = trial_of(tmp_path)
    done: list[Stage] = []

    async def do(stage: Stage, *arguments: Any) -> Any:
        done.append(stage)
        return stages.get(stage, lambda *_: True)(*arguments)

    async def work() -> Exception | None:
        try:
            await run_trial(trial, plan, do)
        except Exception as error:
            return error
        return None

    return trial, done, finished(work())


def raising(error: Exception) -> Callable[..., Any]:
    def stage(*_: Any) -> Any:
        raise error

    return stage


def test_a_scene_is_blamed_only_where_the_control_passes(tmp_path: Path) -> None:
    broken = raising(SceneFault("it names no world", code="unloadable"))
    trial, done, error = driven(tmp_path / "a", {"integrity": broken})
    assert error is None and done.count("control") == 2 and done[-1] == "persist"
    assert not trial.folder.faults.exists()

    fails = raising(MachineryFault("integrity fails on the case's own start level too: no room"))
    trial, done, error = driven(tmp_path / "b", {"integrity": broken, "control": fails})
    assert isinstance(error, MachineryFault) and "start level too" in error.what
    assert not trial.folder.attempt(1).integrity.exists() and "score" not in done
    (record,) = repeats.faults(trial.folder)
    assert (record.stage, record.whose, record.counted) == ("control", "machinery", False)


CALL = '{"event": "call", "counted": true, "call": 1, "tool": "get_categories", "outcome": "ok", "arguments": {}}\n'


def acting(trial: Trial, error: Exception, number: int = 1) -> Callable[..., Any]:
    """An attempt whose agent calls a tool, and which then fails."""

    def attempt(which: int) -> bool:
        if which == number:
            folder = trial.folder.attempt(which)
            folder.root.mkdir(parents=True, exist_ok=True)
            folder.trajectory.write_text(CALL)
            raise error
        return True

    return attempt


@pytest.mark.parametrize("failure", ["WorkerDied", "Exception", "OverLimit", "EMFILE"])
def test_an_attempt_in_doubt_has_its_repeats_and_then_an_outcome(tmp_path: Path, failure: str) -> None:
    _, trial = trial_of(tmp_path)
    error = EXAMPLES[failure]
    assert isinstance(error, Exception)
    for _ in range(MOST_REPEATS):
        _, done, left = driven(tmp_path, {"attempt": acting(trial, error)})
        assert left is error and done == ["attempt"]
    _, done, left = driven(tmp_path, {"attempt": acting(trial, error), "integrity": lambda n: n == 2})
    assert left is None and done[:5] == ["attempt", "control", "integrity", "attempt", "integrity"]
    outcome = AttemptOutcome.read(trial.folder.attempt(1).outcome)
    assert (outcome.ended_by, outcome.submission, outcome.tool_calls) == ("repeats_spent", None, 1)
    assert outcome.message.startswith(f"{MOST_REPEATS + 1} runs failed")
    records = repeats.faults(trial.folder)
    assert [(one.attempt, one.whose, one.counted) for one in records] == [(1, "doubt", True)] * (MOST_REPEATS + 1)


@pytest.mark.parametrize("failure", ["ENOSPC", "MachineryFault", "BadInput"])
def test_what_the_agent_cannot_bring_about_is_repeated_without_end(tmp_path: Path, failure: str) -> None:
    _, trial = trial_of(tmp_path)
    error = EXAMPLES[failure]
    assert isinstance(error, Exception)
    for _ in range(3 * MOST_REPEATS):
        _, done, left = driven(tmp_path, {"attempt": acting(trial, error)})
        assert left is error and done == ["attempt"]
    assert not any(record.counted for record in repeats.faults(trial.folder))


def test_repeats_are_not_counted_where_the_agent_did_nothing_and_not_spent_where_the_control_fails(
    tmp_path: Path,
) -> None:
    _, trial = trial_of(tmp_path)
    died = WorkerDied("SIGKILL")
    for _ in range(2 * MOST_REPEATS):
        assert driven(tmp_path, {"attempt": raising(died)})[2] is died
    broken = raising(MachineryFault("attempt fails on the case's own start level too"))
    for count in range(2 * MOST_REPEATS):
        left = driven(tmp_path, {"attempt": acting(trial, died), "control": broken})[2]
        assert left is not None and (left is died) == (count < MOST_REPEATS)
    assert not trial.folder.attempt(1).outcome.exists()


def test_a_record_that_was_cut_off_is_left_out(tmp_path: Path) -> None:
    _, trial = trial_of(tmp_path)
    driven(tmp_path, {"attempt": raising(WorkerDied("SIGKILL"))})
    with trial.folder.faults.open("a") as lines:
        lines.write('{"time": 1.0, "sta')
    assert len(repeats.faults(trial.folder)) == 1


@pytest.mark.parametrize("torn", ['{"time": 1.0, "sta', '{"time": 1.0, "line": "caf\u00e9', "\0\0\0", "{}\n[]\n"])
def test_an_attempt_in_doubt_has_its_repeats_after_a_record_that_was_cut_off(tmp_path: Path, torn: str) -> None:
    _, trial = trial_of(tmp_path)
    died = WorkerDied("SIGKILL")
    for _ in range(MOST_REPEATS):
        assert driven(tmp_path, {"attempt": acting(trial, died)})[2] is died
        with trial.folder.faults.open("ab") as lines:
            lines.write(torn.encode().removesuffix(b"\xa9"))
    assert driven(tmp_path, {"attempt": acting(trial, died), "integrity": lambda n: n == 2})[2] is None
    assert AttemptOutcome.read(trial.folder.attempt(1).outcome).ended_by == "repeats_spent"
    assert [record.error for record in repeats.faults(trial.folder)] == ["WorkerDied"] * (MOST_REPEATS + 1)


def test_the_page_of_faults_is_the_table() -> None:
    page = (Path(__file__).parents[2] / "docs/faults.md").read_text()
    for row in TABLE:
        cells = (row.means, *(row.whose(place) for place in get_args(Place)), row.code or "")
        assert f"| `{row.failure}` | {' | '.join(cells)} |" in page


def test_every_row_is_an_error_that_there_is() -> None:
    for name, error in EXAMPLES.items():
        assert (
            name in (type(error).__name__, errno.errorcode.get(getattr(error, "errno", 0) or 0)) or name == "Exception"
        )
    assert EXAMPLES.keys() == ROWS.keys() == OUTCOMES.keys()
