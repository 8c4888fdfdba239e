"""How far a run is, read from its folder, while processes work on it, end, and are killed."""

from __future__ import annotations

import io
import json
import subprocess
import sys
import time
from collections import Counter
from pathlib import Path
from typing import Any

import pytest
from rich.console import Console

from c4s.cli.run_view import drawn, line_of, view
from c4s.engine import EngineDied
from c4s.records.folder import RunFolder
from c4s.records.journal import Event
from c4s.records.plan import Configuration, Plan
from c4s.run.artifacts import links, rows
from c4s.run.guards import set_guards
from c4s.run.journal import Journal
from c4s.run.lease import holding
from c4s.run.limits import Stage
from c4s.run.overseer import Overseer
from c4s.run.plan import Trial, trials
from c4s.run.progress import Progress
from reports.status import write_status
from tests.run.test_guards import score, work
from tests.run.test_orchestration import planned
from tests.work import calls_in

ATTACK = "\x1b]0;owned\x07<script>alert(1)</script>[red]R[/red]"
WORKS = """
import sys
from pathlib import Path
from c4s.records.folder import RunFolder
from c4s.records.journal import Event
from c4s.run.journal import Journal, now
from c4s.run.lease import holding
with holding(Path(sys.argv[1])):
    journal = Journal(RunFolder(Path(sys.argv[1])))
    journal(Event(time=now(), event="begun", owner=journal.owner, slots={"engine": 4}))
    journal(Event(time=now(), event="started", trial="noop/case-0/r1", stage="attempt", attempt=1, kind="engine"))
    print("works", flush=True)
    sys.stdin.readline()
"""


def grown(root: Path, cases: int, repeats: int = 1, agents: tuple[str, ...] = ("noop", "planner")) -> Plan:
    """A plan on file."""
    plan, _ = planned(root, cases)
    chosen = [Configuration(name=name, client="noop") for name in agents]
    plan = plan.model_copy(update={"configurations": chosen, "repeats": repeats})
    plan.write(RunFolder(root).plan)
    set_guards(RunFolder(root))
    return plan


def test_counts_scores_and_troubles_of_a_run(tmp_path: Path) -> None:
    plan = grown(tmp_path, 6)
    made = list(trials(tmp_path, tmp_path, plan))

    def die_on_one(stage: Stage, trial: Trial, overseer: Overseer, seen: Counter[str]) -> None:
        if stage == "verify" and trial.case.case_id == "case-2":
            raise EngineDied(ATTACK, during="start", where="logs")

    work(made, plan, die_on_one)
    now = Progress(tmp_path).read()
    assert (now.planned, now.done, now.pending, now.waiting, now.state) == (12, 10, 2, 0, "idle")
    assert [(row.configuration, row.done, row.pending, row.mean_score) for row in now.standings] == [
        ("noop", 5, 1, 0.5),
        ("planner", 5, 1, 0.5),
    ]
    (trouble,) = now.troubles
    assert (trouble.error, trouble.trials) == ("EngineDied", 2) and Path(trouble.faults).is_file()
    assert rows(now)[0] == {"agent": "noop", "done": "5/6", "pending": 1, "score so far": 0.5, "cost in USD": None}
    assert links(RunFolder(tmp_path), tmp_path / "site/index.html")["status page"].startswith("file:///")
    page = tmp_path / "status.html"
    write_status(now, page, tmp_path / "site/index.html")
    assert "<script>" not in page.read_text() and "\x1b" not in page.read_text() and "10 / 12" in page.read_text()
    assert "5 pending" not in line_of(now) and "10 of 12 trials done, 2 pending" in line_of(now)
    shown = io.StringIO()
    Console(file=shown, width=120, force_terminal=False).print(view(now, 40))
    assert "\x1b" not in shown.getvalue() and "[red]R[/red]" in shown.getvalue() and "10/12" in shown.getvalue()


def test_what_a_killed_process_had_in_work_is_in_work_no_more(tmp_path: Path) -> None:
    grown(tmp_path, 2)
    with subprocess.Popen(
        [sys.executable, "-c", WORKS, str(tmp_path)], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    ) as process:
        assert process.stdout and process.stdout.readline() == "works\n"
        progress = Progress(tmp_path)
        now = progress.read()
        assert now.state == "running" and [row.stage for row in now.running] == ["attempt"]
        assert [(slot.kind, slot.busy, slot.count) for slot in now.slots] == [("engine", 1, 4)] and now.waiting == 3
        process.kill()
    for look in (progress, Progress(tmp_path)):
        now = look.read()
        assert (now.state, now.running, now.waiting, now.slots) == ("idle", [], 4, [])


def test_a_trial_that_is_done_again_counts_once_and_one_between_stages_waits_when_nobody_works(tmp_path: Path) -> None:
    grown(tmp_path, 2, agents=("noop",))
    journal = Journal(RunFolder(tmp_path))
    journal(Event(time=time.time(), event="begun", owner=journal.owner, slots={"engine": 1}))
    for score_then in (0.2, 0.8):
        told: dict[str, Any] = {"trial": "noop/case-0/r1", "stage": "score", "kind": "processor"}
        journal(Event(time=time.time(), event="started", **told))
        journal(Event(time=time.time(), event="ended", seconds=0.1, **told))
        journal(Event(time=time.time(), event="done", trial="noop/case-0/r1", score=score_then))
    told = {"trial": "noop/case-1/r1", "stage": "attempt", "attempt": 1, "kind": "engine"}
    journal(Event(time=time.time(), event="started", **told))
    journal(Event(time=time.time(), event="ended", seconds=1.0, **told))
    journal.close()
    progress = Progress(tmp_path)
    with holding(tmp_path):
        now = progress.read()
        assert (now.done, now.waiting, now.standings[0].mean_score) == (1, 0, 0.8)
    assert progress.read().waiting == 1


def test_trials_of_a_run_without_a_journal_are_found_once(tmp_path: Path) -> None:
    plan = grown(tmp_path, 4)
    made = list(trials(tmp_path, tmp_path, plan))
    work(made, plan)
    for path in RunFolder(tmp_path).journals.iterdir():
        path.unlink()
    for trial in made[:5]:
        score(trial, 0.25).write(trial.folder.score)
    now = Progress(tmp_path).read()
    assert now.done == 5 and now.standings[0].mean_score == 0.25


def _night(root: Path, count: int) -> Plan:
    """A run in work with so many trials done, as its journal tells."""
    agents = tuple(f"agent-{number}" for number in range(14))
    plan = grown(root, count // len(agents), agents=agents)
    journal = Journal(RunFolder(root))
    journal(Event(time=time.time(), event="begun", owner=journal.owner, slots={"engine": 8, "processor": 2}))
    for trial in trials(root, root, plan):
        name = f"{trial.configuration.name}/{trial.case.alias}/r1"
        told: dict[str, Any] = {"trial": name, "stage": "attempt", "attempt": 1, "kind": "engine"}
        if trial.case.case_id == "case-0":
            journal(Event(time=time.time(), event="started", **told))
            continue
        journal(Event(time=time.time(), event="started", **told))
        journal(Event(time=time.time(), event="ended", seconds=80.0, cost_usd=0.5, **told))
        journal(Event(time=time.time(), event="done", trial=name, score=0.5, status="measured"))
    journal.close()
    return plan


def test_a_look_at_a_large_run_costs_no_more_than_one_at_a_small_run(tmp_path: Path) -> None:
    cost = []
    for name, count in (("small", 140), ("large", 7980)):
        root = tmp_path / name
        root.mkdir()
        _night(root, count)
        with holding(root):
            progress = Progress(root)
            progress.read()
            cost.append(sum(calls_in(progress.read).values()))
            now = progress.read()
        assert now.done + len(now.running) == now.planned == count and len(now.running) == 14
        assert now.standings[0].cost_usd == 0.5 * now.standings[0].done
    assert cost[1] < 1.2 * cost[0], cost


def test_the_estimate_is_the_work_that_is_left_over_the_slots(tmp_path: Path) -> None:
    plan = grown(tmp_path, 10, agents=("noop",))
    journal = Journal(RunFolder(tmp_path))
    journal(Event(time=time.time(), event="begun", owner=journal.owner, slots={"engine": 2, "processor": 2}))
    for trial in list(trials(tmp_path, tmp_path, plan))[:4]:
        name = f"noop/{trial.case.alias}/r1"
        for kind, stage, seconds in (("engine", "attempt", 100.0), ("processor", "verify", 10.0)):
            told: dict[str, Any] = {"trial": name, "stage": stage, "kind": kind}
            journal(Event(time=time.time(), event="started", **told))
            journal(Event(time=time.time(), event="ended", seconds=seconds, **told))
        journal(Event(time=time.time(), event="done", trial=name, score=0.5))
    with holding(tmp_path):
        assert Progress(tmp_path).read().left_s == 300.0, "six trials of 100 s on two engines"
    journal.close()


def test_a_snapshot_is_plain_json(tmp_path: Path) -> None:
    grown(tmp_path, 2)
    assert json.loads(json.dumps(Progress(tmp_path).read().plain()))["planned"] == 4


def test_a_terminal_is_drawn_on_and_anything_else_gets_lines(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    plan = grown(tmp_path, 3)
    work(list(trials(tmp_path, tmp_path, plan)), plan)
    screen = io.StringIO()
    with drawn(Progress(tmp_path), Console(file=screen, force_terminal=True, width=100, height=30)):
        pass
    assert "6/6 trials" in screen.getvalue() and "score so far" in screen.getvalue()
    with drawn(Progress(tmp_path), Console(file=screen, force_terminal=False)):
        pass
    assert capsys.readouterr().err == "  6 of 6 trials done\n"
