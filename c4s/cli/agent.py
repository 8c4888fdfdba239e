"""``c4s agent``: the clients, one trial to look at, and a recorded attempt played again."""

from __future__ import annotations

import asyncio
import os
import tempfile
import webbrowser
from pathlib import Path
from typing import Annotated, Any

import typer

from c4s.agents.base import CLIENTS, ModelClient, agent_of
from c4s.cli.evaluation import built_suite
from c4s.cli.live import follow
from c4s.cli.output import console, print_json, print_table
from c4s.engine import DEFAULT_ENGINE, engine_kinds
from c4s.errors import BadInput, C4SError
from c4s.files import read_json
from c4s.home import home
from c4s.judge.registry import DEFAULT_JUDGE, JUDGES
from c4s.protocol.baselines import ORACLE
from c4s.protocol.rules import DEFAULT_POLICY
from c4s.records.attempt import AttemptOutcome
from c4s.records.folder import AttemptFolder, RunFolder
from c4s.records.plan import Configuration, Plan
from c4s.records.score import TrialScore
from c4s.records.suite import SuiteFolder
from c4s.run.choices import check_ready
from c4s.run.configurations import configuration
from c4s.run.drive import in_slots, stage_functions
from c4s.run.limits import Stage
from c4s.run.plan import Trial, make_plan, open_run, trials
from c4s.run.pool import Pool
from c4s.run.trial import run_trial

app = typer.Typer(
    help="Agent clients: which there are, one trial with live output, a recorded attempt again.", no_args_is_help=True
)


@app.command("list")
def list_clients(json_output: Annotated[bool, typer.Option("--json")] = False) -> None:
    """The agent clients, and whether each can be started here."""
    rows = []
    for name in CLIENTS:
        agent = agent_of(Configuration(name=name, client=name))
        uses_model, problem = isinstance(agent, ModelClient), ""
        if isinstance(agent, ModelClient):
            try:
                agent.ready(Configuration(name=name, client=name))
            except C4SError as error:
                problem = error.line()
        rows.append({"client": name, "model": uses_model, "ready": not problem, "problem": problem})
    if json_output:
        print_json(rows)
        return
    print_table(
        ("client", "uses a model", "ready", ""),
        [(row["client"], row["model"], row["ready"], row["problem"]) for row in rows],
    )


def _new_folder(root: Path, stem: str) -> Path:
    """The first free ``<stem>-<n>``, made."""
    root.mkdir(parents=True, exist_ok=True)
    number = 1
    while True:
        try:
            (root / f"{stem}-{number}").mkdir()
        except FileExistsError:
            number += 1
            continue
        return root / f"{stem}-{number}"


@app.command("try")
def try_agent(
    name: Annotated[str, typer.Argument(help="configuration: a baseline, or a YAML file")],
    case: Annotated[str, typer.Option("--case", "-c", help="case id")],
    suite: Annotated[str, typer.Option(help="id of a built suite")] = "starter",
    policy: Annotated[str, typer.Option(help="id of a score policy that ships")] = DEFAULT_POLICY,
    judge: Annotated[str, typer.Option(help=", ".join(JUDGES))] = DEFAULT_JUDGE,
    engine: Annotated[str, typer.Option(help=", ".join(engine_kinds()))] = DEFAULT_ENGINE,
    open_page: Annotated[
        bool, typer.Option("--open/--no-open", help="open the case page at the end, where there is a desktop")
    ] = True,
    json_output: Annotated[bool, typer.Option("--json")] = False,
) -> None:
    """Run one trial and watch it: every call, the budget left, the cost, the pictures; then its case page.

    A try has a folder of its own under ``tries/`` and is on no leaderboard.
    """
    chosen, suite_folder = configuration(name), built_suite(suite)
    plan = make_plan(
        SuiteFolder(suite_folder), [chosen], run_id="try", policy=policy, judge=judge, engine=engine, cases=[case]
    )
    check_ready(plan.configurations)
    root = _new_folder(home() / "tries", f"{chosen.name}-{case}")
    plan = open_run(root / "run", plan)
    trial = next(iter(trials(root / "run", suite_folder, plan)))
    if not json_output:
        console.print(f"{chosen.name} on {case}, in {root}", style="dim", soft_wrap=True, highlight=False)
    score = asyncio.run(_watched(trial, plan, quiet=json_output))
    page = _publish(root, suite_folder, plan, case)
    if json_output:
        print_json(score.plain() | {"folder": str(root), "page": page.as_uri()})
    else:
        _print_score(trial, score)
        print(page.as_uri())
    if open_page and not json_output and (os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY")):
        webbrowser.open(page.as_uri())


async def _watched(trial: Trial, plan: Plan, *, quiet: bool) -> TrialScore:
    """The trial in worker processes; unless quiet, each attempt is followed while it runs."""
    inside = stage_functions()

    async def run(stage: Stage, trial: Trial, plan: Plan, *arguments: Any) -> Any:
        if quiet or stage != "attempt":
            return await inside(stage, trial, plan, *arguments)
        with follow(console, trial.folder.attempt(*arguments).root):
            outcome = await inside(stage, trial, plan, *arguments)
        console.print(_ending(outcome), soft_wrap=True, highlight=False)
        return outcome

    async with Pool() as pool:
        return await run_trial(trial, plan, in_slots(pool, run, trial, plan))


def _ending(outcome: AttemptOutcome) -> str:
    tokens = "" if outcome.input_tokens is None else f", {outcome.input_tokens} in and {outcome.output_tokens} out"
    cost = "" if outcome.cost_usd is None else f", ${outcome.cost_usd:.4f}"
    saved = f"saved {outcome.submission}" if outcome.submission else "nothing was saved"
    message = f": {outcome.message}" if outcome.message else ""
    return (
        f"attempt {outcome.attempt}: {outcome.ended_by}{message}; {outcome.tool_calls} calls in "
        f"{outcome.wall_s:.1f} s{tokens}{cost}; {saved}"
    )


def _publish(root: Path, suite: Path, plan: Plan, case: str) -> Path:
    from reports.site import build_site
    from reports.text import slug
    from warehouse.database import rebuild
    from warehouse.ingest import rebuild_from_run

    rebuild_from_run(root / "run", suite, root / "warehouse")
    rebuild(root / "warehouse")
    build_site(root / "warehouse", root / "site")
    return root / "site" / "cases" / f"{slug(plan.suite_id)}--{slug(case)}.html"


def _print_score(trial: Trial, score: TrialScore) -> None:
    parts: list[tuple[str, Any]] = [("score", score.score), ("status", score.status)]
    parts += [(name, value) for name, value in score.components.items() if value is not None]
    if score.reason:
        parts.append(("reason", score.reason))
    print_table(("", trial.name), parts)


@app.command("replay")
def replay(
    attempt: Annotated[Path, typer.Argument(help="folder of a finished attempt in a run")],
    json_output: Annotated[bool, typer.Option("--json")] = False,
) -> None:
    """Send the calls of a recorded attempt again and compare what is saved, byte by byte. Exit 1 when it differs."""
    from c4s.run.attempt import run_attempt
    from c4s.run.stages import inputs

    recorded = AttemptOutcome.read(AttemptFolder(attempt).outcome)
    trial = _trial_of(attempt)
    if trial.configuration.client == ORACLE:
        raise BadInput("the oracle reads the truth, which a replay is not given", where=str(attempt))
    given = inputs(trial)
    with tempfile.TemporaryDirectory(prefix="c4s-replay-") as folder:
        again = run_attempt(
            given.case,
            given.agent_folder,
            Configuration(
                name="replay",
                client="replay",
                options={"trajectory": str(AttemptFolder(attempt.absolute()).trajectory)},
            ),
            recorded.attempt,
            Path(folder) / "attempt",
            given.packs,
            None,
            engine=str(read_json(AttemptFolder(attempt).manifest, what="attempt manifest")["engine"]),
        )
    equal = (again.submission, again.submission_sha256) == (recorded.submission, recorded.submission_sha256)
    if json_output:
        print_json(
            {
                "equal": equal,
                "recorded_sha256": recorded.submission_sha256,
                "replayed_sha256": again.submission_sha256,
                "tool_calls": again.tool_calls,
                "message": again.message,
            }
        )
    else:
        print(f"{again.message}; the submission is {'equal, byte by byte' if equal else 'another one'}")
    if not equal:
        raise typer.Exit(1)


def _trial_of(attempt: Path) -> Trial:
    """The trial that an attempt's folder belongs to: ``<run>/<agent>/<case>/r<k>/attempt-<n>``."""
    folder = attempt.absolute()
    run = folder.parents[3] if len(folder.parents) > 3 else folder
    if not RunFolder(run).plan.is_file():
        raise BadInput("not an attempt of a run", where=str(attempt), todo="give <run>/<agent>/<case>/r<k>/attempt-<n>")
    plan = Plan.read(RunFolder(run).plan)
    suite = built_suite(plan.suite_id)
    return next(trial for trial in trials(run, suite, plan) if trial.folder.root == folder.parent)
