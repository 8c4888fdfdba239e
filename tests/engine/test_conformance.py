"""Every engine that can be opened here does what c4s asks of engines; what is asked can be failed."""

from __future__ import annotations

import json
import subprocess
import sys
from contextlib import ExitStack
from pathlib import Path

import pytest

from c4s.engine import engine_kinds
from c4s.engine.conformance import Report, all_checks, run
from c4s.engine.conformance.check import Failed, need_facts
from c4s.engine.conformance.departures import DEPARTURES
from c4s.errors import BadInput, MachineryFault
from tests.standin import stand_in

FACTS = {"flag": True, "place": [1, 2.5, None], "parts": {"name": "A"}}


def command(*arguments: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-m", "c4s.cli", "engine", "conform", *arguments],
        text=True,
        capture_output=True,
        timeout=300,
        check=False,
    )


@pytest.fixture(scope="module", params=engine_kinds())
def report(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Report:
    """What came of an engine; one that this machine lacks is skipped with the reason."""
    with ExitStack() as stack:
        if request.param == "unreal-standin":
            stack.enter_context(stand_in(tmp_path_factory.mktemp("editor")))
        try:
            return run(request.param)
        except MachineryFault as fault:
            if request.param != "unreal":
                raise
            pytest.skip(f"{request.param}: {fault.line()}")


def test_an_engine_conforms(report: Report) -> None:
    assert [result for result in report.checks if result.status == "failed"] == []
    assert len(report.checks) == len(all_checks()) >= 25


def test_open_questions_are_put_on_record(report: Report) -> None:
    answers = {result.name: result for result in report.checks if result.group == "questions"}
    assert {result.status for result in answers.values()} == {"recorded"} and len(answers) >= 9
    assert json.loads(answers["how-large-a-new-navigation-volume-is"].detail)["extent"] == [100, 100, 100]
    opened = answers["whether-a-level-opens-from-a-tick"].detail
    assert ("Slate tick" in opened) if report.engine == "unreal-standin" else (json.loads(opened) == {"opened": True})


def test_names_are_unique_and_departures_are_of_checks() -> None:
    names = [check.name for check in all_checks()]
    assert len(set(names)) == len(names)
    for kind, departures in DEPARTURES.items():
        assert kind in engine_kinds() and set(departures) <= set(names)


@pytest.mark.parametrize(
    "found",
    [
        {},
        {**FACTS, "flag": 1},
        {**FACTS, "flag": None},
        {**FACTS, "place": [True, 2.5, None]},
        {**FACTS, "place": [1, 2.51, None]},
        {**FACTS, "place": [1, 2.5]},
        {**FACTS, "place": [1, float("nan"), None]},
        {**FACTS, "parts": {"name": "A", "more": 1}},
        {**FACTS, "parts": "A"},
    ],
)
def test_a_wrong_fact_fails(found: dict[str, object]) -> None:
    need_facts({**FACTS, "place": [1.0005, 2.5, None], "beside": 1}, FACTS)
    with pytest.raises(Failed):
        need_facts(found, FACTS)


def test_a_departure_that_has_ended_is_a_failure(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(DEPARTURES, "headless", {"scripts-share-a-namespace": "said so"})
    (result,) = run("headless", ["scripts-share-a-namespace"]).checks
    assert result.status == "failed" and "is none" in result.detail


def test_what_there_is_not_is_bad_input() -> None:
    with pytest.raises(BadInput, match="there is headless"):
        run("unity")
    with pytest.raises(BadInput, match="no-such-check"):
        run("headless", ["no-such-check"])
    done = command("--engine", "unity")
    assert done.returncode == 2 and done.stderr.count("\n") == 1 and "headless" in done.stderr


def test_the_command_tells_what_came_of_a_check_and_writes_it_down(tmp_path: Path) -> None:
    done = command("--only", "vectors-calculate", "--json", "--out", str(tmp_path / "table.json"))
    told = json.loads(done.stdout)
    assert done.returncode == 0 and told["engine"] == "headless" and told["failed"] == 0
    assert [(check["name"], check["status"]) for check in told["checks"]] == [("vectors-calculate", "passed")]
    assert json.loads((tmp_path / "table.json").read_text()) == told
    assert told["version"] == told["host"]["engine_version"] and "gpus" in told["host"]
    again = command("--only", "vectors-calculate", "--out", str(tmp_path / "table.json"))
    assert again.returncode == 2 and "--replace" in again.stderr
