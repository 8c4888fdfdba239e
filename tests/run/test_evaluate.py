"""The whole road on a small suite: run, verify, store, publish; stop and go on."""

from __future__ import annotations

import asyncio
import json
import os
import re
import shutil
import signal
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from bench.waiting import until
from c4s.errors import BadInput
from c4s.files import digest_file
from c4s.home import runs_root
from c4s.judge.rule.version import rule_version
from c4s.protocol.rules import GATE
from c4s.records.pack import Pack
from c4s.records.plan import Plan
from c4s.records.version import code_version
from c4s.verify.registry import DECIDE
from tests.run.conftest import Command, apart, command_in, environment, trial_in
from tests.run.handed_on import baselines_home, copy_of
from warehouse.database import rows

CASES = ["text-flat-family"]
OFFLINE = {
    "DO_NOT_TRACK": "1",
    "PREFECT_SERVER_ANALYTICS_ENABLED": "false",
    "PREFECT_SERVER_EPHEMERAL_STARTUP_TIMEOUT_SECONDS": "120",
}
LADDER = ("noop", "vandal", "oracle", "planner", "random", "blind")
SAVING = tuple(name for name in LADDER if name != "vandal")
"""Who leaves a scene that has a picture."""


@pytest.fixture(scope="module")
def ran(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The home after all six baselines ran."""
    return copy_of(baselines_home(tmp_path_factory), tmp_path_factory.mktemp("evaluated") / "home")


@pytest.fixture
def c4s(ran: Path) -> Command:
    """Run the command line in that home."""
    return command_in(ran)


def _scores(home: Path) -> dict[tuple[str, str], dict[str, object]]:
    return {
        (row["configuration"], row["case_id"]): row
        for row in rows(home / "warehouse", "SELECT * FROM case_scores WHERE suite = 'small'")
    }


def test_the_ladder_of_baselines(ran: Path) -> None:
    scores = _scores(ran)
    text = next(case for _, case in scores if case.startswith("text-"))
    repairs = sorted({case for _, case in scores} - {text})
    assert len(scores) == 18 and len(repairs) == 2
    for case in repairs:
        assert scores["oracle", case]["repair_f1"] == 1.0
        assert scores["noop", case]["score"] == 0.2
        assert scores["vandal", case]["score"] == 0.0
        assert scores["vandal", case]["status"] == "zero_invalid_candidate"
        assert scores["vandal", case]["reason_code"] == "minimum_actors"
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


def test_every_trial_has_one_recorded_run_valid_or_not(ran: Path) -> None:
    store = ran / "warehouse"
    found = rows(store, "SELECT trial_id, configuration, attempt, recorded, valid FROM attempts ORDER BY attempt")
    recorded = {row["trial_id"]: row for row in found if row["recorded"]}
    assert len(recorded) == sum(row["recorded"] for row in found) == 18
    for row in recorded.values():
        own = [other for other in found if other["trial_id"] == row["trial_id"]]
        assert row["attempt"] == next((other["attempt"] for other in own if other["valid"]), own[-1]["attempt"])
    assert [row["attempt"] for row in recorded.values() if row["configuration"] == "vandal"] == [2, 2, 2]
    usage = rows(store, "SELECT configuration, sum(runs) AS runs FROM tool_usage GROUP BY ALL")
    assert {row["configuration"]: row["runs"] for row in usage} == dict.fromkeys(LADDER, 3)
    called = {row["configuration"] for row in rows(store, "SELECT * FROM python_operations")}
    assert "vandal" in called, "its scripts ran, though nothing that it saved was valid"
    for row in rows(store, "SELECT * FROM outcomes"):
        own = rows(store, f"SELECT * FROM attempts WHERE recorded AND trial_id = '{row['trial_id']}'")[0]
        assert (row["tool_calls"], row["attempt_wall_s"]) == (own["tool_calls"], own["wall_s"])
        assert (row["retained_attempt"] is None) == (not own["valid"])


def test_each_attempt_tells_its_engine_and_time(ran: Path) -> None:
    found = rows(ran / "warehouse", "SELECT * FROM attempts")
    assert {row["engine_version"] for row in found} == {"5.6.0-c4s.headless+5.8-names"}
    assert all(row["wall_s"] > 0 for row in found)
    assert all(row["client_version"].rpartition(" ")[0] == row["configuration"] for row in found)


def test_components_stand_beside_every_verdict(ran: Path) -> None:
    store = ran / "warehouse"
    found: dict[tuple[str, str], dict[str, float]] = {}
    for row in rows(store, "SELECT * FROM components"):
        found.setdefault((row["trial_id"], row["verifier"]), {})[row["name"]] = row["value"]
    verdicts = rows(store, "SELECT * FROM verdicts")
    verdicts = [row for row in verdicts if row["score"] is not None]
    assert {(row["trial_id"], row["verifier"]) for row in verdicts} <= set(found)
    for row in verdicts:
        assert found[row["trial_id"], row["verifier"]].get("score") == row["score"]
    texts = rows(store, "SELECT * FROM outcomes WHERE setting = 'text-to-scene'")
    for row in texts:
        semantic = found[row["trial_id"], "semantic"]["score"]
        assert round(0.8 * semantic + 0.2 * row["physics"], 4) == pytest.approx(row["score"], abs=1e-4)
    repairs = rows(store, "SELECT * FROM outcomes WHERE setting <> 'text-to-scene' AND retained_attempt IS NOT NULL")
    for row in repairs:
        own = found[row["trial_id"], "repair"]
        assert (own["f1"], own["precision"], own["recall"]) == (
            row["repair_f1"],
            row["repair_precision"],
            row["repair_recall"],
        )
        assert own["profiles.strict.f1"] <= own["f1"] <= own["profiles.relaxed.f1"]
        leaves = found[row["trial_id"], "physics"]
        assert round(0.5 * leaves["floating"] + 0.5 * leaves["solid_penetration"], 4) == row["physics"]
    asked = {row["configuration"]: row for row in rows(store, "SELECT * FROM semantic_scores")}
    assert set(asked) == set(LADDER) and asked["noop"]["semantic"] == 0.0 == asked["noop"]["detailed"]
    assert asked["oracle"]["content_quantity"] > asked["vandal"]["semantic"]
    means = rows(store, "SELECT * FROM component_means WHERE configuration = 'oracle' AND name = 'f1'")
    assert [(row["measured"], row["outcomes"], row["mean_value"]) for row in means] == [(2, 2, 1.0)]


def test_another_machine_goes_on_with_a_run(ran: Path, c4s: Command) -> None:
    path = ran / "runs/small/plan.json"
    plan, kept = Plan.read(path), path.read_bytes()
    assert plan.host is not None and plan.host.cores >= 1 and plan.host.engine_version == "5.6.0-c4s.headless+5.8-names"
    elsewhere = plan.model_copy(update={"host": plan.host.model_copy(update={"processor": "another", "cores": 999})})
    try:
        elsewhere.write(path)
        again = c4s("run", "small", "--json")
        assert again.returncode == 0 and json.loads(again.stdout)["ran"] == 0, again.stderr
        assert Plan.read(path) == elsewhere
    finally:
        path.write_bytes(kept)


def test_every_number_is_traced_to_files(ran: Path) -> None:
    case = ran / "suites/small/withheld"
    folders = {"candidate_snapshot": "evidence/snapshot.json", "dependencies": "evidence/dependencies.json"}
    folders |= {"judgements": "judgements/rule.json", "captures": "evidence/captures/captures.json"}
    folders |= {name: f"evidence/{name}.json" for name in ("contacts", "support", "navigation")}
    folders |= {"evidence_listing": "evidence/digests/export.json"}
    withheld = {"input_snapshot": "input.snapshot.json", "truth_snapshot": "truth.snapshot.json"}
    withheld |= {"requirements": "requirements.bundle.json", "binding": "binding.json"}
    traced: dict[str, set[str]] = {}

    def check(trial: Path, case_id: str, document: dict[str, Any], maker: str) -> None:
        for name, digest in document["inputs"].items():
            if name.startswith("pack "):
                assert Pack.read(ran / "packs" / name.removeprefix("pack ") / "pack.json").sha256() == digest
                continue
            if name.startswith("captures/"):
                assert digest_file(trial / "evidence" / name) == digest
                traced.setdefault(maker, set()).add("pictures and masks")
                continue
            root, names = (trial, folders) if name in folders else (case / case_id, withheld)
            assert digest_file(root / names[name]) == digest
            traced.setdefault(maker, set()).add(name)

    for row in rows(ran / "warehouse", "SELECT * FROM verdicts WHERE suite = 'small' AND status <> 'invalid'"):
        trial = trial_in(ran, "small", row["configuration"], row["case_id"]).root
        assert digest_file(trial / "verdicts" / f"{row['verifier']}.json") == row["verdict_sha256"]
        document = json.loads(row["document"])
        assert document["made_by"] == code_version(*DECIDE)
        check(trial, row["case_id"], document, row["verifier"])
        said = trial / "judgements/rule.json"
        if said.is_file():
            check(trial, row["case_id"], json.loads(said.read_text()), "rule judge")
            assert json.loads(said.read_text())["judge_version"] == rule_version()
    assert traced == {
        "integrity": {"candidate_snapshot", "dependencies", "evidence_listing"},
        "repair": {"candidate_snapshot", "input_snapshot", "truth_snapshot"},
        "detailed": {"requirements", "judgements"},
        "overview": {"judgements"},
        "paired": {"judgements"},
        "navigation": {"candidate_snapshot", "navigation"},
        "physics": {"candidate_snapshot", "input_snapshot", "contacts", "support"},
        "rule judge": {"candidate_snapshot", "captures", "pictures and masks", "requirements", "binding"},
    }


def test_a_second_run_finds_everything_done_and_a_rebuild_gives_the_same(ran: Path, c4s: Command) -> None:
    before = {key: row["score"] for key, row in _scores(ran).items()}
    again = c4s("run", "small", "--json")
    assert again.returncode == 0 and json.loads(again.stdout)["ran"] == 0
    (ran / "warehouse/c4s.duckdb").unlink()
    assert c4s("report").returncode == 0
    assert {key: row["score"] for key, row in _scores(ran).items()} == before


def test_another_judgement_under_the_same_name_is_refused(ran: Path, c4s: Command) -> None:
    refused = c4s("run", "small", "-a", "noop", "--policy", "repair-only")
    assert refused.returncode == 2 and "another policy" in refused.stderr and refused.stderr.count("\n") == 1


def test_a_part_of_what_is_done_is_reused_and_another_run_id_tells_who_holds_it(ran: Path, c4s: Command) -> None:
    plan = (ran / "runs/small/plan.json").read_bytes()
    part = c4s("run", "small", "-a", "noop", "-a", "planner")
    assert part.returncode == 0 and "0 trials run" in part.stdout and "6 trials are done and reused" in part.stdout
    assert (ran / "runs/small/plan.json").read_bytes() == plan
    other = c4s("run", "small", "-a", "noop", "--run-id", "other")
    assert other.returncode == 0 and "3 trials are done and reused from run 'small'" in other.stdout
    assert (ran / "runs/other/plan.json").is_file() and not (ran / "runs/other/noop").exists()
    listed = {row["run"]: row for row in json.loads(c4s("runs", "list", "--json").stdout)}
    assert (listed["other"]["state"], listed["other"]["done"], listed["other"]["planned"]) == ("done", 3, 3)


def test_a_client_that_is_not_there_is_told_before_and_in_the_flow(
    ran: Path, c4s: Command, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from flows.evaluate import evaluate

    agent = tmp_path / "agent.yaml"
    agent.write_text("{name: absent, client: codex, model: some-model, options: {program: /nowhere/codex}}\n")
    told = c4s("run", "small", "-a", str(agent), "--run-id", "absent")
    assert not (ran / "runs" / "absent").exists()
    assert told.returncode == 2 and len(told.stderr.strip().splitlines()) == 1, told.stderr
    assert "codex" in told.stderr and "npm install" in told.stderr
    monkeypatch.setenv("C4S_HOME", str(ran))
    refused: Any = evaluate.fn("small", [str(agent)], run_id="absent", cases=CASES)
    with pytest.raises(BadInput, match="npm install"):
        asyncio.run(refused)
    assert not (ran / "runs" / "absent").exists()


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
        verdicts = {path.stem for path in (trial_in(own, "small", "oracle", case).root / "verdicts").glob("*.json")}
        assert {"attempt-1", "integrity-1", "look", "score", "persist", *(verdicts - {GATE})} <= seen
        assert "judge" in seen


def test_the_pages_show_what_happened(ran: Path) -> None:
    index = (ran / "site/index.html").read_text()
    assert all(name in index for name in LADDER) and "not ranked" in index
    for page in (ran / "site").rglob("*.html"):
        text = page.read_text()
        for link in [part.split('"')[0] for part in text.split('src="')[1:]]:
            assert (page.parent / link).resolve().is_file(), f"{page.name}: {link}"
    case = next((ran / "site/cases").glob("*flat*01*")).read_text()
    assert all(f'alt="{row}, view-01"' in case for row in ("reference", "Start", "Truth", *SAVING))
    for name in SAVING:
        trial = next((ran / "site/trials").glob(f"*flat-01*--{name}--*")).read_text()
        assert ("TP 1 · FP 0 · FN 0" in trial) == (name == "oracle")


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
        ranks = page.locator("table.standings td.rank").all_inner_texts()
        assert ranks == ["–"] * len(LADDER), "without outdoor cases nobody has an overall score, so nobody a rank"
        page.get_by_role("link", name="Cases", exact=True).click()
        page.get_by_role("link", name="indoor-flat-01-mirrored-bath").click()
        page.wait_for_url("**/cases/*indoor-flat-01*")
        pictures = page.locator("#renders img")
        assert pictures.count() >= 2 * (2 + len(SAVING))
        for index in range(pictures.count()):
            pictures.nth(index).scroll_into_view_if_needed()
            pictures.nth(index).evaluate("image => image.decode()")
            assert pictures.nth(index).evaluate("image => image.naturalWidth") > 300
        assert page.evaluate("document.documentElement.scrollWidth <= window.innerWidth")
        page.get_by_role("link", name="oracle").first.click()
        page.wait_for_url("**/trials/*oracle*")
        assert page.locator("h1").inner_text() == "oracle on indoor-flat-01-mirrored-bath"
        assert "not ranked" in page.locator("p.verdict").inner_text()
        browser.close()
    assert not faults


def test_a_killed_run_goes_on_and_equals_an_undisturbed_one(ran: Path, tmp_path: Path) -> None:
    home = tmp_path / "home"
    for part in ("packs", "suites"):
        shutil.copytree(ran / part, home / part)
    (home / "cache").symlink_to(ran / "cache")
    command = [sys.executable, "-m", "c4s.cli", "run", "small", "-a", "noop", "-a", "oracle"]
    process = subprocess.Popen(
        command, env=environment(home), stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, start_new_session=True
    )
    first = home / "runs/small/noop"
    until(lambda: any(first.rglob("outcome.json")), process)
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
