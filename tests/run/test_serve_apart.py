"""``c4s serve --stdio`` and ``--out``, on the agent's side of a case alone, and ``c4s grade`` of what they leave."""

from __future__ import annotations

import json
import os
import shutil
import sys
from pathlib import Path
from typing import Any

import anyio
import pytest
from mcp import Client, StdioServerParameters

from c4s.files import json_lines
from c4s.records.attempt import AttemptOutcome
from c4s.records.folder import AttemptFolder
from c4s.records.suite import SuiteFolder
from tests.run.conftest import Command, apart
from tests.run.test_serve import served

CASE = "text-flat-family"
Calls = list[tuple[str, dict[str, Any]]]


def repair_of(home: Path) -> str:
    """The first repair of the suite."""
    return next(case.case_id for case in SuiteFolder(home / "suites/small").suite().cases if case.case_id != CASE)


def by_stdio(home: Path, case: str, out: Path, calls: Calls, *options: str) -> list[dict[str, Any]]:
    """Answers to the calls of a client that starts the command as its tool server."""
    server = StdioServerParameters(
        command=sys.executable,
        args=["-m", "c4s.cli", "serve", case, "--suite", "small", "--stdio", "--out", str(out), *options],
        env={**os.environ, "C4S_HOME": str(home)},
    )

    async def work() -> list[dict[str, Any]]:
        async with Client(server) as client:
            assert len((await client.list_tools()).tools) == 25
            answers = [await client.call_tool(name, arguments) for name, arguments in calls]
            return [json.loads(answer.content[0].text) for answer in answers]

    return anyio.run(work)


@pytest.fixture(scope="module")
def bare(home: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A home with packs and nothing of a suite."""
    there = apart(tmp_path_factory.mktemp("bare") / "home", home)
    (there / "suites").unlink()
    return there


@pytest.fixture(scope="module")
def saved(home: Path, bare: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """An attempt at a repair that saves what it finds, where only the agent's folder of the case is."""
    root = tmp_path_factory.mktemp("attempts")
    suite = SuiteFolder(home / "suites/small")
    folder = root / "case"
    shutil.copytree(suite.agent(suite.case(repair_of(home)).alias), folder)
    answers = by_stdio(bare, str(folder), root / "saved", [("save_scene_as", {"name": "mine"})], "--harness", "tester")
    assert "error" not in answers[0]
    return root / "saved"


def test_a_scripted_save_over_stdio_scores_what_noop_scores(
    c4s: Command, home: Path, saved: Path, tmp_path: Path
) -> None:
    outcome = AttemptOutcome.read(AttemptFolder(saved).outcome)
    assert (outcome.ended_by, outcome.tool_calls, outcome.client) == ("finished", 1, "outside")
    done = c4s(
        "grade", str(saved), "--case", repair_of(home), "--suite", "small", "--out", str(tmp_path / "reward.json")
    )
    assert done.returncode == 0, done.stderr
    found = json.loads(done.stdout)
    assert json.loads((tmp_path / "reward.json").read_text()) == found
    assert (found["reward"], found["valid"]) == (pytest.approx(0.2), 1.0)
    assert all(isinstance(value, float) for value in found.values()) and {"repair_f1", "physics"} <= set(found)


def test_no_saved_scene_and_a_hostile_folder_are_a_reward_of_zero(
    c4s: Command, home: Path, saved: Path, tmp_path: Path
) -> None:
    (tmp_path / "empty").mkdir()
    shutil.copytree(saved, tmp_path / "linked")
    level = next(AttemptFolder(tmp_path / "linked").submission.rglob("*.json"))
    level.unlink()
    level.symlink_to(home / "suites/small/suite.json")
    for folder in ("empty", "linked"):
        done = c4s("grade", str(tmp_path / folder), "--case", repair_of(home), "--suite", "small")
        assert done.returncode == 0, done.stderr
        found = json.loads(done.stdout)
        assert (found["reward"], found["valid"]) == (0.0, 0.0)


def test_an_attempt_is_not_overwritten_unless_nothing_was_done_in_it(home: Path, saved: Path, tmp_path: Path) -> None:
    before = (saved / "outcome.json").read_bytes()
    with pytest.raises(Exception):  # noqa: B017 - what a client raises whose server is gone is the SDK's affair
        by_stdio(home, CASE, saved, [])
    assert (saved / "outcome.json").read_bytes() == before
    by_stdio(home, CASE, tmp_path / "probed", [])
    assert by_stdio(home, CASE, tmp_path / "probed", [("get_categories", {})])[0]["result"]
    assert AttemptOutcome.read(AttemptFolder(tmp_path / "probed").outcome).tool_calls == 1


def test_a_client_without_headers_connects_by_the_address_alone(home: Path, tmp_path: Path) -> None:
    with served(home, "--out", str(tmp_path / "kept"), "--after-save", "0", "--json") as process:
        told = json.loads(process.stdout.readline())

        async def work() -> str:
            async with Client(told["url_with_token"]) as client:
                await client.list_tools()
                answer = await client.call_tool("save_scene_as", {"name": "mine"})
                return answer.content[0].text

        assert "error" not in json.loads(anyio.run(work))
        out, err = process.communicate(timeout=120)
    assert process.returncode == 0, err
    assert json.loads(out)["submission"].endswith("/mine")
    with AttemptFolder(tmp_path / "kept").trajectory.open() as lines:
        assert [line["outcome"] for line in json_lines(lines)] == ["unfinished", "ok"]
