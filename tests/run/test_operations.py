"""A real run as its operator sees it: progress, status page, notices, logs, telemetry, signals, pruning, backups."""

from __future__ import annotations

import json
import os
import shutil
import signal
import subprocess
import sys
import threading
from collections import Counter
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest

from c4s.files import digest_bytes
from c4s.folders import remove_tree
from c4s.records.folder import RunFolder
from c4s.records.progress import Snapshot
from c4s.run.lease import Held, take
from c4s.run.notify import Notifier
from c4s.run.store import FolderLeases
from tests.run.conftest import apart, command_in, environment
from tests.run.receivers import Receiver, receiving, values

SECRET = "t0ken-of-the-hook"
TOLD = {"C4S_LOG": "json", "OTEL_METRIC_EXPORT_INTERVAL": "300"}
AGENTS = ("-a", "noop", "-a", "planner", "-c", "text-flat-family")


@dataclass(frozen=True)
class Ran:
    """A run of two trials with all that watches it."""

    home: Path
    done: subprocess.CompletedProcess[str]
    hook: Receiver
    collector: Receiver

    @property
    def folder(self) -> RunFolder:
        return RunFolder(self.home / "runs/seen")


@pytest.fixture(scope="module")
def ran(home: Path, tmp_path_factory: pytest.TempPathFactory) -> Any:
    own = apart(tmp_path_factory.mktemp("seen") / "home", home)
    with receiving() as hook, receiving() as collector:
        done = subprocess.run(
            [
                *(sys.executable, "-m", "c4s.cli", "run", "small", *AGENTS, "--run-id", "seen", "--json"),
                *("--notify", f"{hook.url}/hook?key={SECRET}", "--deadline", "4h", "--spend", "3"),
            ],
            env={**environment(own), **TOLD, "OTEL_EXPORTER_OTLP_ENDPOINT": collector.url},
            text=True,
            capture_output=True,
            timeout=280,
            check=False,
        )
        assert done.returncode == 0, done.stderr
        yield Ran(own, done, hook, collector)


def logged(text: str) -> list[dict[str, Any]]:
    return [json.loads(line) for line in text.splitlines()]


def test_logs_are_json_lines_with_trial_ids(ran: Ran) -> None:
    (path,) = ran.folder.logs.glob("*.jsonl")
    lines = logged(path.read_text())
    assert {"time", "level", "host", "pid", "run", "message"} <= set.intersection(*(set(line) for line in lines))
    of_trials = [line for line in lines if "trial" in line]
    assert len({line["trial_id"] for line in of_trials}) == 2
    assert {line["stage"] for line in of_trials if line["event"] == "ended"} >= {
        "attempt",
        "integrity",
        "score",
        "persist",
    }
    assert [line["score"] for line in of_trials if line["event"] == "done" and line["trial"].startswith("noop/")] == [
        0.0
    ]
    assert path.read_text().isascii()


def test_with_json_logs_standard_error_holds_nothing_else(ran: Ran) -> None:
    lines = logged(ran.done.stderr)
    assert "over" in [line.get("event") for line in lines]
    assert [line["message"].strip() for line in lines if "of 2 trials" in line["message"]][-1] == "2 of 2 trials done"
    assert len(lines) >= 20 and json.loads(ran.done.stdout)["ran"] == 2


def test_one_notice_tells_the_end_and_no_log_tells_the_secret(ran: Ran) -> None:
    (notice,) = ran.hook.notices()
    assert (notice["event"], notice["run"], notice["done"], notice["planned"]) == ("ended", "seen", 2, 2)
    assert notice["state"] == "done" and "2 of 2 trials done" in notice["text"]
    assert SECRET not in ran.done.stderr + ran.done.stdout
    for path in ran.folder.root.rglob("*"):
        assert not path.is_file() or SECRET.encode() not in path.read_bytes(), path


def test_a_trace_a_trial_with_a_span_a_stage(ran: Ran) -> None:
    spans = ran.collector.spans()
    trials = {span.trace_id: span for span in spans if span.name.startswith("trial ")}
    assert len(trials) == 2 and len({span.trace_id for span in spans}) == 2
    planner = next(span for span in trials.values() if values(span.attributes)["c4s.configuration"] == "planner")
    told = values(planner.attributes)
    assert told["c4s.status"] == "measured" and 0 < told["c4s.score"] < 1 and len(told["c4s.trial_id"]) == 16
    stages = [span for span in spans if span.parent_span_id == planner.span_id]
    names = Counter(span.name for span in stages)
    assert names["attempt"] == names["score"] == names["persist"] == 1 and names["verify physics"] == 1
    for span in stages:
        assert planner.start_time_unix_nano <= span.start_time_unix_nano <= span.end_time_unix_nano
        assert span.end_time_unix_nano <= planner.end_time_unix_nano


def test_metrics_tell_slots_queue_spend_and_trials(ran: Ran) -> None:
    metrics = ran.collector.metrics()
    assert set(metrics) == {"c4s.slots.busy", "c4s.slots.count", "c4s.queue", "c4s.spend", "c4s.trials"}
    trials = {values(p.attributes)["outcome"]: p.as_int for p in metrics["c4s.trials"].sum.data_points}
    assert trials == {"measured": 1, "zero_invalid_candidate": 1}


def test_watching_a_run_that_is_done(ran: Ran) -> None:
    c4s = command_in(ran.home)
    now = Snapshot.parse(json.loads(c4s("watch", "seen", "--json").stdout))
    assert (now.state, now.done, now.planned, now.waiting, now.running) == ("done", 2, 2, 0, [])
    standing = {row.configuration: row for row in now.standings}
    assert standing["noop"].mean_score == 0.0 and standing["planner"].done == 1
    assert now.deadline is not None and now.spend_limit_usd == 3.0
    assert c4s("watch", "seen").stdout == "seen: 2 of 2 trials done\n"


def test_the_status_page_in_a_browser(ran: Ran) -> None:
    from playwright.sync_api import sync_playwright

    chromium = shutil.which("chromium") or shutil.which("google-chrome")
    if chromium is None:
        pytest.skip("no Chromium on this machine")
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=chromium, args=["--no-sandbox"])
        page = browser.new_page(viewport={"width": 1200, "height": 900})
        page.goto(ran.folder.status_page.as_uri())
        assert page.title() == "2/2 seen · c4s" and page.locator("meta[http-equiv=refresh]").count() == 0
        assert "done" in page.locator("h1 .tag").inner_text()
        assert page.locator(".track .done").evaluate("e => e.offsetWidth / e.parentElement.offsetWidth") == 1
        assert page.locator("tbody tr").count() == 2
        assert page.evaluate("document.documentElement.scrollWidth <= window.innerWidth")
        page.get_by_role("link", name="leaderboard").click()
        assert "Leaderboard" in page.locator("h1").first.inner_text()
        browser.close()


def test_what_can_be_dropped_is_told_and_only_what_is_named_goes(ran: Ran) -> None:
    c4s, attempt = command_in(ran.home), next(ran.folder.root.glob("planner/*/r1")) / "attempt-1"
    (attempt.with_name("attempt-1.interrupted-1") / "agent").mkdir(parents=True)
    (attempt.with_name("attempt-1.interrupted-1") / "agent/log").write_text("x" * 5000)
    told = json.loads(c4s("runs", "prune", "--json").stdout)
    sizes = {row["part"]: row["bytes"] for row in told["rows"]}
    assert not told["dropped"] and sizes["interrupted"] == 5000 and sizes["run"] > sizes["scratch"] > 0
    assert c4s("runs", "prune", "--drop", "scratch").returncode == 2 and (attempt / "scratch").is_dir()
    assert json.loads(c4s("runs", "prune", "seen", "--older", "1h", "--drop", "scratch", "--json").stdout)["rows"] == []
    assert json.loads(c4s("runs", "prune", "seen", "--keep", "1", "--drop", "scratch", "--json").stdout)["rows"] == []
    dropped = c4s("runs", "prune", "seen", "--drop", "scratch", "--drop", "interrupted", "--drop", "pictures", "--json")
    assert {row["part"] for row in json.loads(dropped.stdout)["rows"]} == {"scratch", "interrupted", "pictures"}
    assert not (attempt / "scratch").exists() and not attempt.with_name("attempt-1.interrupted-1").exists()


def test_a_run_of_which_somebody_has_a_trial_is_left_alone(ran: Ran, tmp_path: Path) -> None:
    c4s, folder = command_in(ran.home), ran.folder.trial("planner", "held", 1)
    held = take(FolderLeases(folder.leases), "trial")
    assert isinstance(held, Held)
    try:
        told = json.loads(c4s("backup", str(tmp_path / "copy"), "--only", "runs", "--json").stdout)
        assert told["left_out"] == ["seen"]
        refused = c4s("runs", "prune", "seen", "--drop", "run")
        assert refused.returncode == 2 and "on the trial planner/held/r1 works on this run" in refused.stderr
        assert ran.folder.plan.is_file()
        assert "seen" not in {row["run"] for row in json.loads(c4s("runs", "prune", "--json").stdout)["rows"]}
    finally:
        held.give_back()
        remove_tree(folder.root.parent, inside=ran.folder.root)


def test_a_whole_run_goes_at_once_and_whoever_waits_for_it_begins_in_a_folder_of_their_own(tmp_path: Path) -> None:
    run = RunFolder(tmp_path / "runs/gone")
    for number in range(20):
        for name in range(100):
            path = run.trial("noop", f"case-{number}", 1).root / f"f{name}"
            path.parent.mkdir(parents=True, exist_ok=True)
            path.touch()
    run.plan.write_text("{}")
    first = take(FolderLeases(run.leases), "run")
    assert isinstance(first, Held)
    c4s = command_in(tmp_path)
    refused = c4s("runs", "prune", "gone", "--drop", "run")
    assert refused.returncode == 2 and "works on this run" in refused.stderr and run.plan.is_file()
    first.give_back()
    seen: list[bool] = []

    def wait_and_take() -> None:
        while run.plan.is_file() or not isinstance(held := take(FolderLeases(run.leases), "run"), Held):
            continue
        seen.append(any(path != run.leases for path in run.root.iterdir()))
        held.check()
        run.plan.write_text("anew")

    waiter = threading.Thread(target=wait_and_take, daemon=True)
    waiter.start()
    assert c4s("runs", "prune", "gone", "--drop", "run").returncode == 0
    waiter.join(60)
    assert seen == [False] and run.plan.read_text() == "anew"
    assert [path.name for path in run.root.parent.iterdir()] == ["gone"]


def test_a_backup_of_what_was_pruned_comes_back_whole_and_a_changed_file_is_refused(ran: Ran, tmp_path: Path) -> None:
    c4s, copy = command_in(ran.home), tmp_path / "copy"
    first = json.loads(c4s("backup", str(copy), "--only", "runs", "--only", "warehouse", "--json").stdout)
    assert first["files"] >= first["copied"] > 20
    kept = ran.folder.plan.read_bytes()
    (one,) = copy.glob(f"files/*/{digest_bytes(kept)}")
    one.unlink()
    (copy / "backup.json").unlink()
    again = json.loads(c4s("backup", str(copy), "--only", "runs", "--only", "warehouse", "--json").stdout)
    assert (again["copied"], again["files"]) == (1, first["files"]), "it went on where it was cut off"

    other = apart(tmp_path / "home", ran.home)
    one.write_bytes(kept.replace(b"small", b"smell"))
    refused = c4s("restore", str(copy), home=other)
    assert refused.returncode == 2 and "changed since it was kept: runs/seen/plan.json" in refused.stderr
    assert not (other / "runs/seen/plan.json").exists()
    one.write_bytes(kept)
    back = json.loads(c4s("restore", str(copy), "--json", home=other).stdout)
    assert 0 < back["copied"] < back["files"], "it went on too"
    reused = json.loads(c4s("run", "small", *AGENTS, "--run-id", "seen", "--json", home=other).stdout)
    assert reused["ran"] == 0 and reused["reused"] == {"seen": 2}, "nothing that was dropped was needed"
    (other / "runs/seen/plan.json").write_text("{}")
    refused = c4s("restore", str(copy), home=other)
    assert refused.returncode == 2 and "holds another file" in refused.stderr


def started(process: subprocess.Popen[str], run: RunFolder) -> None:
    """Wait until an attempt of a run is in work."""
    while process.poll() is None:
        if any('"started"' in path.read_text() for path in run.journals.glob("*.jsonl")):
            return
        with_timeout(process)
    pytest.fail(f"the run ended: {process.stderr.read() if process.stderr else ''}")


def with_timeout(process: subprocess.Popen[str]) -> None:
    try:
        process.wait(0.05)
    except subprocess.TimeoutExpired:
        return


def test_ctrl_c_lets_what_is_in_work_end_a_command_is_told_and_the_same_command_goes_on(
    home: Path, tmp_path: Path
) -> None:
    own, told = apart(tmp_path / "home", home), tmp_path / "told"
    hook = f"{sys.executable} -c \"import sys; open('{told}', 'a').write(sys.stdin.read() + chr(10))\""
    command = [sys.executable, "-m", "c4s.cli", "run", "small", "-a", "noop", "--slots", "1"]
    process = subprocess.Popen(
        [*command, "--notify", hook],
        env=environment(own),
        text=True,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        start_new_session=True,
    )
    run = RunFolder(own / "runs/small")
    started(process, run)
    running = Snapshot.parse(json.loads(command_in(own)("watch", "small", "--json").stdout))
    os.killpg(process.pid, signal.SIGINT)
    _, errors = process.communicate(timeout=120)
    assert process.returncode == 1, errors
    assert running.state == "running" and running.planned == 3 and running.holder
    assert "Ctrl-C asked it to end" in errors and "trials left" in errors.splitlines()[-1]
    assert "run the same command again" in errors.splitlines()[-1]
    notices = [json.loads(line) for line in told.read_text().splitlines()]
    assert [notice["event"] for notice in notices] == ["stopping", "ended"] and notices[1]["state"] == "stopped"
    assert len(list(run.root.glob("noop/*/r1/score.json"))) < 3 and not list(run.root.glob("noop/*/*/*.interrupted-*"))
    again = subprocess.run(command, env=environment(own), text=True, capture_output=True, timeout=200, check=False)
    assert again.returncode == 0, again.stderr
    assert len(list(run.root.glob("noop/*/r1/score.json"))) == 3
    assert not list(run.root.glob("noop/*/*/*.interrupted-*")), "no attempt was cut off or repeated"


@pytest.mark.parametrize("how", ["500", "gone", "command", "loop"])
def test_a_notice_that_nobody_takes_is_told_without_the_secret(how: str) -> None:
    lines: list[str] = []
    with receiving(status=500) as hook:
        target = {
            "500": f"{hook.url}/{SECRET}",
            "gone": f"http://127.0.0.1:9/{SECRET}",
            "command": f"{sys.executable} -c 'import sys; sys.exit(3)' {SECRET}",
            "loop": f"http://user:{SECRET}@127.0.0.1:9/",
        }[how]
        to = Notifier(target, lines.append)
        to.send({"event": "ended"})
        to.wait()
    (line,) = lines
    assert "was not taken" in line and "not affected" in line and SECRET not in line
    assert {"500": "answered 500", "gone": "ConnectError", "command": "ended with 3", "loop": ""}[how] in line
