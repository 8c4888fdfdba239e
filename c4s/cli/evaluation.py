"""Running the evaluate flow in this process: quiet Prefect, visible progress, nothing started when all is done."""

from __future__ import annotations

import os
import time
from collections.abc import Sequence
from dataclasses import dataclass

from c4s.agents.base import ModelClient, agent_of
from c4s.cli.progress import watch
from c4s.errors import BadInput
from c4s.home import home, runs_root, site_root, suites_root, warehouse_root
from c4s.protocol.rules import DEFAULT_POLICY
from c4s.records.suite import SuiteFolder
from c4s.run.check import check_kept
from c4s.run.configurations import BASELINES, configuration
from c4s.run.plan import make_plan, open_run, trial_id, trials

QUIET = {
    "DO_NOT_TRACK": "1",
    "PREFECT_SERVER_ANALYTICS_ENABLED": "false",
    "PREFECT_LOGGING_LEVEL": "CRITICAL",
    "PREFECT_SERVER_LOGGING_LEVEL": "CRITICAL",
    "PREFECT_LOGGING_TO_API_ENABLED": "false",
    "PREFECT_SERVER_EPHEMERAL_STARTUP_TIMEOUT_SECONDS": "120",
    "PREFECT_CLI_PROMPT": "false",
    **{
        f"PREFECT_SERVER_SERVICES_{name}_ENABLED": "false"
        for name in (
            "CANCELLATION_CLEANUP",
            "EVENT_PERSISTER",
            "FOREMAN",
            "LATE_RUNS",
            "PAUSE_EXPIRATIONS",
            "REPOSSESSOR",
            "SCHEDULER",
            "TASK_RUN_RECORDER",
            "TRIGGERS",
        )
    },
}
"""Prefect as a run in one process needs it: its server lives as long as the run, so it schedules nothing, and nobody
asks it for the task runs that it would write down."""


@dataclass(frozen=True)
class Evaluation:
    """What came of an evaluation."""

    page: str
    ran: int
    skipped: int
    seconds: float


def evaluate_here(
    suite: str, agents: Sequence[str], *, run_id: str | None, cases: Sequence[str], repeats: int, slots: int | None
) -> Evaluation:
    """Evaluate in this process. Raises ``BadInput`` before anything is started where the request cannot be met."""
    started = time.perf_counter()
    folder, run = suites_root() / suite, runs_root() / (run_id or suite)
    if not (folder / "suite.json").is_file():
        built = sorted(path.parent.name for path in suites_root().glob("*/suite.json"))
        raise BadInput(
            f"unknown suite {suite!r}",
            where=str(suites_root()),
            todo=f"built here: {', '.join(built)}" if built else "build one with `c4s suite build starter`",
        )
    from c4s.run.stages import inputs
    from warehouse.ingest import is_stored
    from warehouse.parquet import part_path

    names = list(agents or BASELINES)
    plan = make_plan(
        SuiteFolder(folder),
        [configuration(name) for name in names],
        run_id=run.name,
        policy=DEFAULT_POLICY,
        judge="rule",
        engine="headless",
        repeats=repeats,
        cases=cases,
    )
    scheduled = list(trials(run, folder, plan))
    for trial in {trial.case.case_id: trial for trial in scheduled}.values():
        inputs(trial)
    missing = [trial for trial in scheduled if not is_stored(trial, plan, warehouse_root())]
    for trial in missing:
        check_kept(trial)
    if missing:
        for chosen in plan.configurations:
            agent = agent_of(chosen)
            if isinstance(agent, ModelClient):
                agent.ready(chosen)
    open_run(run, plan)
    page = site_root() / "index.html"
    if not missing and page.is_file():
        return Evaluation(page.as_uri(), 0, len(scheduled), time.perf_counter() - started)
    for name, value in {**QUIET, "PREFECT_HOME": str(home() / "prefect")}.items():
        os.environ.setdefault(name, value)
    from flows.evaluate import evaluate

    stored = [
        part_path(warehouse_root(), "outcomes", plan.suite_id, trial.configuration.name, trial_id(plan, trial))
        for trial in scheduled
    ]
    with watch(scheduled, {path for path in stored if path.is_file()}, stored):
        address = evaluate(suite=suite, agents=names, run_id=run.name, cases=list(cases), repeats=repeats, slots=slots)
    return Evaluation(address, len(missing), len(scheduled) - len(missing), time.perf_counter() - started)
