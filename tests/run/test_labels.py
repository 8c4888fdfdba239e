"""A label is a promise: what a plan may name, and what happens where a file was made under another name."""

from __future__ import annotations

import asyncio
import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from c4s.engine import engine_kinds
from c4s.errors import BadInput, MachineryFault
from c4s.files import digest, read_json, write_json
from c4s.judge.names import DEFAULT_JUDGE, JUDGE_NAMES
from c4s.protocol.rules import DEFAULT_POLICY
from c4s.records.evidence_digests import SEEN, note_digests
from c4s.records.plan import Configuration, Plan
from c4s.records.suite import SuiteFolder
from c4s.run import stages
from c4s.run.plan import Trial, make_plan, trials
from c4s.score.policies import POLICIES
from tests.run.conftest import apart, command_in, trial_in
from tests.run.handed_on import baselines_home, hand_on

TEXT, REPAIR = "text-flat-family", "indoor-flat-01-mirrored-bath"
RUN = ("run", "small", "-a", "planner", "-c", TEXT, "--run-id", "labels")
WRONG = {"engine": "unity", "judge": "gpt-9-vlm", "policy": "my-weights"}


def choices(label: str) -> list[str]:
    return {"engine": list(engine_kinds()), "judge": list(JUDGE_NAMES), "policy": list(POLICIES)}[label]


@pytest.fixture(scope="module")
def own(home: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A home where nothing else runs."""
    return apart(tmp_path_factory.mktemp("labels") / "home", home)


@pytest.fixture(scope="module")
def trial(own: Path, tmp_path_factory: pytest.TempPathFactory) -> tuple[Trial, Plan]:
    """A trial of the text case that was run and scored, and its plan."""
    hand_on(baselines_home(tmp_path_factory), own, ["planner"], [TEXT], "labels")
    plan = Plan.read(own / "runs/labels/plan.json")
    return next(trials(own / "runs/labels", own / "suites/small", plan)), plan


@pytest.mark.parametrize("label", WRONG)
def test_a_label_that_nothing_obeys_is_refused_with_the_choices(own: Path, label: str) -> None:
    for command in (
        ("run", "small", "-a", "noop", "-c", REPAIR, "--run-id", "refused"),
        ("agent", "try", "noop", "--suite", "small", "-c", REPAIR),
    ):
        done = command_in(own)(*command, f"--{label}", WRONG[label])
        assert done.returncode == 2 and done.stderr.count("\n") == 1, done.stderr
        assert WRONG[label] in done.stderr and all(choice in done.stderr for choice in choices(label))
    assert not (own / "runs/refused").exists() and not (own / "tries").exists()


@pytest.mark.parametrize("label", WRONG)
def test_the_flow_refuses_it_too(own: Path, monkeypatch: pytest.MonkeyPatch, label: str) -> None:
    from flows.evaluate import evaluate

    monkeypatch.setenv("C4S_HOME", str(own))
    refused: Any = evaluate.fn("small", ["noop"], run_id="refused", cases=[REPAIR], **{label: WRONG[label]})
    with pytest.raises(BadInput, match=WRONG[label]):
        asyncio.run(refused)
    assert not (own / "runs/refused").exists()


@pytest.mark.parametrize(
    ("given", "told"),
    [
        ({"most_faults": 0}, "most_faults: Input should be greater than or equal to 1"),
        ({"repeats": 0}, "repeats: Input should be greater than or equal to 1"),
        ({"repeats": 1001}, "repeats: Input should be less than or equal to 1000"),
        ({"slots": 0}, "slots: Input should be greater than or equal to 1"),
    ],
)
def test_the_flow_refuses_a_count_that_the_command_refuses(
    own: Path, monkeypatch: pytest.MonkeyPatch, given: dict[str, int], told: str
) -> None:
    from flows.evaluate import evaluate

    monkeypatch.setenv("C4S_HOME", str(own))
    refused: Any = evaluate.fn("small", ["noop"], run_id="refused", cases=[REPAIR], **given)
    with pytest.raises(BadInput, match=told):
        asyncio.run(refused)
    (option, value), *_ = given.items()
    done = command_in(own)("run", "small", "-a", "noop", f"--{option.replace('_', '-')}", str(value))
    assert done.returncode == 2 and told.partition(": ")[2] in done.stderr, done.stderr
    assert not (own / "runs/refused").exists() and not (own / "runs/small").exists()


@pytest.mark.parametrize(
    ("configurations", "told"),
    [
        ([Configuration(name="a", client="noop"), Configuration(name="a", client="random")], "2 configurations .* 'a'"),
        ([Configuration(name="a", client="absent")], "unknown agent client 'absent'"),
        ([Configuration(name="a", client="api")], "names no model"),
        ([Configuration(name="a", client="api", model="m", options={"endpoint": "nowhere"})], "'nowhere'"),
        ([Configuration(name="a", client="api", model="m", options={"endpoint": "anthropic"})], "speaks openai-chat"),
        ([Configuration(name="a", client="api", model="m", options={"side_models": "n"})], "side_models"),
    ],
)
def test_a_configuration_that_cannot_be_obeyed_is_refused(
    own: Path, configurations: list[Configuration], told: str
) -> None:
    with pytest.raises(BadInput, match=told):
        make_plan(
            SuiteFolder(own / "suites/small"),
            configurations,
            run_id="refused",
            policy=DEFAULT_POLICY,
            judge=DEFAULT_JUDGE,
            engine="headless",
        )


def _first(folder: Path, pattern: str) -> Path:
    return sorted(folder.glob(pattern))[0]


def _set(*keys: str, to: str) -> Callable[[dict[str, Any]], None]:
    def change(value: dict[str, Any]) -> None:
        for key in keys[:-1]:
            value = value[key]
        value[keys[-1]] = to

    return change


@pytest.mark.parametrize(
    ("pattern", "change"),
    [
        ("attempt-1/manifest.json", _set("engine", to="unreal")),
        ("evidence/snapshot.json", _set("c4s", "engine", to="unreal")),
        ("evidence/snapshot.json", lambda value: value.pop("c4s")),
        ("evidence/captures/captures.json", _set("engine", to="unreal")),
        ("judgements/*.json", _set("judge", to="gpt-9-vlm")),
        ("judgements/*.json", _set("judge_version", to="0.1.0+000000000000")),
        ("verdicts/overview.json", _set("measurements", "judge", to="gpt-9-vlm")),
        ("verdicts/detailed.json", _set("measurements", "judge_version", to="0.1.0+000000000000")),
        ("verdicts/physics.json", _set("verifier", to="overview")),
        ("score.json", _set("engine", to="unreal")),
        ("score.json", _set("judge", to="gpt-9-vlm")),
        ("score.json", _set("policy", to="repair-only")),
        ("score.json", _set("configuration", to="oracle")),
    ],
)
def test_a_file_made_under_another_label_is_a_fault_and_no_score(
    trial: tuple[Trial, Plan], pattern: str, change: Callable[[dict[str, Any]], None]
) -> None:
    path = _first(trial[0].folder.root, pattern)
    before = path.read_bytes()
    value = read_json(path)
    change(value)
    if value.pop("sha256", None):
        value["sha256"] = digest(value)
    write_json(path, value)
    try:
        with pytest.raises(MachineryFault, match="and the plan's is") as raised:
            stages.score(*trial)
        assert raised.value.where == str(path)
    finally:
        path.write_bytes(before)
    assert stages.score(*trial).status == "measured"


def test_it_ends_the_command_as_a_machinery_fault_and_stores_nothing(own: Path, trial: tuple[Trial, Plan]) -> None:
    evidence = trial[0].folder.evidence
    captures, before = evidence.captures_index, evidence.captures_index.read_bytes()
    captures.write_text(json.dumps(json.loads(before) | {"engine": "unreal"}))
    note_digests(evidence, SEEN, evidence.captures.iterdir())
    trial[0].folder.score.unlink()
    for part in (own / "warehouse").rglob("*.parquet"):
        part.unlink()
    done = command_in(own)(*RUN)
    assert done.returncode == 3 and "made under engine 'unreal'" in done.stderr, done.stderr
    assert not trial[0].folder.score.exists()
    captures.write_bytes(before)
    note_digests(evidence, SEEN, evidence.captures.iterdir())
    assert command_in(own)(*RUN).returncode == 0 and trial[0].folder.score.is_file()


def test_a_run_under_another_policy_is_scored_by_it(own: Path) -> None:
    done = command_in(own)("run", "small", "-a", "noop", "-c", REPAIR, "--run-id", "f1", "--policy", "repair-only")
    assert done.returncode == 0, done.stderr
    score = read_json(trial_in(own, "f1", "noop", REPAIR).score)
    assert (score["policy"], score["score"], score["components"]["physics"]) == ("repair-only", 0.0, 1.0)
