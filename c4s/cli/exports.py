"""``c4s export``: what runs hold, in formats that other programs read."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from c4s.cli.output import print_json, say
from c4s.cli.runs import run_folder
from c4s.cli.suites import built_suite
from c4s.errors import BadInput
from c4s.folders import beside, check_new, put_folder
from c4s.records.folder import RunFolder
from c4s.records.plan import Plan
from c4s.records.suite import SuiteFolder

app = typer.Typer(help="What runs hold, in formats that other programs read.", no_args_is_help=True)


@app.callback()
def group() -> None:
    """A group, also while it has one command."""


@app.command()
def atif(
    run: Annotated[str, typer.Argument(help="run id or run folder")],
    out: Annotated[Path, typer.Option(help="new folder: one an attempt, with trajectory.json and pictures")],
    json_output: Annotated[bool, typer.Option("--json")] = False,
) -> None:
    """Write every attempt of a run as a trajectory in ATIF v1.8, as Harbor's viewer and others read it."""
    from c4s.harness.atif import DOCUMENT, write_atif
    from c4s.run.plan import trials

    root = run_folder(run)
    plan = Plan.read(RunFolder(root).plan)
    suite = SuiteFolder(built_suite(plan.suite_id))
    check_new(out)
    written: list[str] = []
    with beside(out) as scratch:
        made = scratch / "made"
        made.mkdir()
        for trial in trials(root, suite.root, plan):
            prompt = suite.agent_case(trial.case.alias).prompt
            for attempt in trial.folder.attempts():
                name = f"{trial.configuration.name}.{trial.case.alias}.r{trial.repeat}.{attempt.root.name}"
                write_atif(attempt, made / name, session=trial.name, configuration=trial.configuration, prompt=prompt)
                written.append(name)
        if not written:
            raise BadInput("no attempt of this run has ended", where=str(root), todo="run it first")
        put_folder(made, out, marker=DOCUMENT)
    if json_output:
        print_json({"folder": str(out), "trajectories": written})
    else:
        say(f"{out}: {len(written)} trajectories of {plan.run_id}")
