"""The whole road on a small suite: run, verify, store, publish; stop and go on."""

from __future__ import annotations

import json
import os
import re
import shutil
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from c4s.home import runs_root
from c4s.records.plan import Plan
from c4s.verify.registry import GATE
from tests.run.conftest import Command, apart, environment
from warehouse.database import rows

CASES = ["text-flat-family"]
OFFLINE = {
    "DO_NOT_TRACK": "1",
    "PREFECT_SERVER_ANALYTICS_ENABLED": "false",
    "PREFECT_SERVER_EPHEMERAL_STARTUP_TIMEOUT_SECONDS": "120",
}
LADDER = ("noop", "vandal", "oracle", "planner", "random")


@pytest.fixture(scope="module")
def ran(home: Path) -> Path:
    """The home after all five baselines ran."""
    done = subprocess.run(
        [sys.executable, "-m", "c4s.cli", "run", "small", "--json"],
        env=environment(home),
        text=True,
        capture_output=True,
        timeout=290,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout)["ran"] == 15
    return home


def _scores(home: Path) -> dict[tuple[str, str], dict[str, object]]:
    return {
        (row["configuration"], row["case_id"]): row
        for row in rows(home / "warehouse", "SELECT * FROM case_scores WHERE suite = 'small'")
    }


def test_the_ladder_of_baselines(ran: Path) -> None:
    scores = _scores(ran)
    text = next(case for _, case in scores if case.startswith("text-"))
    repairs = sorted({case for _, case in scores} - {text})
    assert len(scores) == 15 and len(repairs) == 2
    for case in repairs:
        assert scores["oracle", case]["repair_f1"] == 1.0
        assert scores["noop", case]["score"] == 0.2
        assert scores["vandal", case]["score"] == 0.0
        assert scores["vandal", case]["status"] == "zero_invalid_candidate"
    assert scores["oracle", text]["status"] == "measured"
    assert scores["noop", text]["score"] == 0.0 and "minimum_actors" in str(scores["noop", text]["reason"])
    assert scores["planner", text]["score"] > scores["random", text]["score"]


def test_an_invalid_submission_is_retried_once_and_both_attempts_are_kept(ran: Path) -> None:
    found = rows(
        ran / "warehouse", "SELECT configuration, count(*) AS n FROM attempts WHERE suite = 'small' GROUP BY ALL"
    )
    counted = {row["configuration"]: row["n"] for row in found}
    assert counted["vandal"] == 6 and counted["oracle"] == 3
    assert (ran / "runs/small/vandal").is_dir()


def test_every_number_is_traced_to_files(ran: Path) -> None:
    from c4s.files import digest_file

    for row in rows(ran / "warehouse", "SELECT * FROM verdicts WHERE suite = 'small'"):
        trial = ran / "runs/small" / row["configuration"] / row["case_id"] / "r1"
        assert digest_file(trial / "verdicts" / f"{row['verifier']}.json") == row["verdict_sha256"]
        for name, wanted in json.loads(row["document"])["inputs"].items():
            if (trial / "evidence" / name).is_file():
                assert digest_file(trial / "evidence" / name) == wanted


def test_a_second_run_finds_everything_done_and_a_rebuild_gives_the_same(ran: Path, c4s: Command) -> None:
    before = {key: row["score"] for key, row in _scores(ran).items()}
    again = c4s("run", "small", "--json")
    assert again.returncode == 0 and json.loads(again.stdout)["ran"] == 0
    (ran / "warehouse/c4s.duckdb").unlink()
    assert c4s("report").returncode == 0
    assert {key: row["score"] for key, row in _scores(ran).items()} == before


def test_another_plan_under_the_same_name_is_refused(ran: Path, c4s: Command) -> None:
    refused = c4s("run", "small", "-a", "noop")
    assert refused.returncode == 2 and "another plan" in refused.stderr and refused.stderr.count("\n") == 1


def test_a_client_that_is_not_there_is_told_before_and_in_the_flow(home: Path, c4s: Command, tmp_path: Path) -> None:
    agent = tmp_path / "agent.yaml"
    agent.write_text("{name: absent, client: codex, model: some-model, options: {program: /nowhere/codex}}\n")
    refused = c4s("run", "small", "-a", str(agent), "--run-id", "absent")
    assert not (home / "runs" / "absent").exists()
    assert refused.returncode == 2 and len(refused.stderr.strip().splitlines()) == 1, refused.stderr
    assert "codex" in refused.stderr and "npm install" in refused.stderr
    flow = (
        "import asyncio; from flows.evaluate import evaluate; "
        f"asyncio.run(evaluate('small', [{str(agent)!r}], run_id='absent', cases={CASES!r}))"
    )
    failed = subprocess.run(
        [sys.executable, "-c", flow], env=environment(home), text=True, capture_output=True, timeout=200, check=False
    )
    told = [line for line in failed.stderr.splitlines() if line.startswith("c4s.errors.BadInput: ")]
    assert failed.returncode != 0 and told and "npm install" in told[0], failed.stderr
    assert not (home / "runs" / "absent").exists()


def test_the_flow_runs_each_stage_as_a_task_and_gives_the_same_scores(ran: Path, tmp_path: Path) -> None:
    own = apart(tmp_path / "home", ran)
    flow = "import asyncio; from flows.evaluate import evaluate; asyncio.run(evaluate('small', ['oracle'], slots=2))"
    done = subprocess.run(
        [sys.executable, "-c", flow],
        env=environment(own) | {"PREFECT_HOME": str(tmp_path / "prefect"), **OFFLINE},
        text=True,
        capture_output=True,
        timeout=280,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    wanted = {key: row["score"] for key, row in _scores(ran).items() if key[0] == "oracle"}
    assert {key: row["score"] for key, row in _scores(own).items()} == wanted
    for case in {case for _, case in wanted}:
        seen = set(re.findall(rf"Task run '([\w-]+)-oracle/{case}/r1' - Finished in state Completed", done.stderr))
        verdicts = {path.stem for path in (own / "runs/small/oracle" / case / "r1/verdicts").glob("*.json")}
        assert {"attempt-1", "integrity-1", "look", "score", "persist", *(verdicts - {GATE})} <= seen
        assert ("judge" in seen) == case.startswith("text-")


def test_the_pages_show_what_happened(ran: Path) -> None:
    index = (ran / "site/index.html").read_text()
    assert all(name in index for name in LADDER) and "not ranked" in index
    for page in (ran / "site").rglob("*.html"):
        text = page.read_text()
        for link in [part.split('"')[0] for part in text.split('src="')[1:]]:
            assert (page.parent / link).resolve().is_file(), f"{page.name}: {link}"
    case = next((ran / "site/cases").glob("*flat*01*"))
    assert "start" in case.read_text() and "truth" in case.read_text() and ">TP<" in case.read_text()


def test_the_pages_in_a_browser(ran: Path) -> None:
    from playwright.sync_api import sync_playwright

    chromium = shutil.which("chromium") or shutil.which("google-chrome")
    if chromium is None:
        pytest.skip("no Chromium on this machine")
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=chromium, args=["--no-sandbox"])
        page = browser.new_page(viewport={"width": 1440, "height": 900})
        faults: list[str] = []
        page.on("pageerror", lambda error: faults.append(str(error)))
        page.on("requestfailed", lambda request: faults.append(request.url))
        page.goto((ran / "site/index.html").as_uri())
        ranks = page.locator("tbody").first.locator("tr td:first-child").all_inner_texts()
        assert ranks == ["–"] * len(LADDER), "without outdoor cases nobody has an overall score, so nobody a rank"
        page.get_by_role("link", name="indoor-flat-01-mirrored-bath").click()
        pictures = page.locator("figure img")
        assert pictures.count() >= 8
        for index in range(pictures.count()):
            pictures.nth(index).scroll_into_view_if_needed()
            pictures.nth(index).evaluate("image => image.decode()")
            assert pictures.nth(index).evaluate("image => image.naturalWidth") > 300
        assert page.evaluate("document.documentElement.scrollWidth <= window.innerWidth")
        page.get_by_role("link", name="oracle").first.click()
        assert "not ranked" in page.locator("h1").inner_text()
        browser.close()
    assert not faults


def test_a_killed_run_goes_on_and_equals_an_undisturbed_one(ran: Path, tmp_path: Path) -> None:
    home = tmp_path / "home"
    for part in ("packs", "suites"):
        shutil.copytree(ran / part, home / part)
    command = [sys.executable, "-m", "c4s.cli", "run", "small", "-a", "noop", "-a", "oracle"]
    process = subprocess.Popen(
        command, env=environment(home), stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, start_new_session=True
    )
    first = home / "runs/small/noop"
    while not any(first.rglob("outcome.json")):
        assert process.poll() is None, "the run ended before it could be killed"
        os.sched_yield()
    os.killpg(process.pid, signal.SIGKILL)
    process.wait()
    done = subprocess.run(command, env=environment(home), capture_output=True, text=True, timeout=280, check=False)
    assert done.returncode == 0, done.stderr
    wanted = {key: row["score"] for key, row in _scores(ran).items() if key[0] in ("noop", "oracle")}
    assert {key: row["score"] for key, row in _scores(home).items()} == wanted


def test_the_plan_holds_nothing_volatile(ran: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("C4S_HOME", str(ran))
    plan = Plan.read(runs_root() / "small/plan.json")
    assert str(ran) not in plan.model_dump_json()
    assert plan.judge == "rule" and plan.engine == "headless" and plan.versions["prefect"] == "3.8.8"
