"""``c4s suite export-harbor``: folders as Harbor has them, in which an agent's side holds nothing of the truth.

``make test-clients`` lets Harbor itself load and run them.
"""

from __future__ import annotations

import json
import tomllib
from pathlib import Path

import pytest

from c4s.packs.suite_check import check_case
from c4s.records.suite import SuiteFolder
from tests.run.conftest import Command


@pytest.fixture
def tasks(c4s: Command, home: Path, tmp_path: Path) -> Path:
    """The suite as task folders."""
    done = c4s("suite", "export-harbor", "small", "--out", str(tmp_path / "tasks"), "--image", "there/c4s:1", "--json")
    assert done.returncode == 0, done.stderr
    assert len(json.loads(done.stdout)["tasks"]) == 3
    return tmp_path / "tasks"


def test_each_case_is_a_task_with_limits_a_tool_server_and_a_separate_verifier(
    tasks: Path, home: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("C4S_HOME", str(home))
    suite = SuiteFolder(home / "suites/small")
    for case in suite.suite().cases:
        folder, budget = tasks / case.alias, suite.agent_case(case.alias).budget
        told = tomllib.loads((folder / "task.toml").read_text())
        assert (told["schema_version"], told["task"]["name"]) == ("1.4", f"c4s/small-{case.alias}")
        assert told["agent"]["timeout_sec"] >= 60 * budget.wall_minutes
        assert told["verifier"]["environment_mode"] == "separate" and told["artifacts"] == ["/c4s/attempt"]
        assert told["environment"]["docker_image"] == "there/c4s:1"
        assert "docker_image" not in told["verifier"]["environment"]
        (server,) = told["environment"]["mcp_servers"]
        assert (server["transport"], server["command"]) == ("stdio", "c4s") and "/c4s/case" in server["args"]
        assert suite.agent_case(case.alias).prompt.strip() in (folder / "instruction.md").read_text()
        for script in ("tests/test.sh", "solution/solve.sh"):
            assert (folder / script).stat().st_mode & 0o111, script
        one = SuiteFolder(folder / "tests/suite")
        check_case(one, one.case(case.case_id))


def test_what_an_agent_is_given_tells_nothing_of_the_case(tasks: Path, home: Path) -> None:
    suite = SuiteFolder(home / "suites/small")
    for case in suite.suite().cases:
        folder, withheld = tasks / case.alias, suite.withheld_case(case.case_id)
        given = [path for path in (folder / "environment").rglob("*") if path.is_file()]
        assert {path.relative_to(folder / "environment/case") for path in given} == {
            path.relative_to(suite.agent(case.alias)) for path in suite.agent(case.alias).rglob("*") if path.is_file()
        }
        texts = [path.read_text() for path in (*given, folder / "instruction.md") if path.suffix in (".json", ".md")]
        for word in (case.case_id, withheld.title, "withheld"):
            assert not any(word in text for text in texts), word


def test_a_folder_that_is_not_new_is_left_as_it_is(c4s: Command, tasks: Path) -> None:
    before = sorted(tasks.rglob("*"))
    done = c4s("suite", "export-harbor", "small", "--out", str(tasks))
    assert done.returncode == 2 and sorted(tasks.rglob("*")) == before
