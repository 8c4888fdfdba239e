"""``c4s bundle``: published evidence bundles, packed from a run or scored."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from c4s.cli.output import print_json, print_table, say
from c4s.cli.runs import run_folder
from c4s.cli.suites import built_suite
from c4s.errors import BadInput, unknown
from c4s.records.folder import RunFolder
from c4s.records.plan import Plan
from c4s.records.suite import SuiteFolder

app = typer.Typer(
    help="Published evidence bundles (code4scene.bundle.v1): score one, or pack a trial.", no_args_is_help=True
)
Json = Annotated[bool, typer.Option("--json")]


@app.command()
def score(
    folder: Annotated[Path, typer.Argument(help="folder with bundle.json")],
    minimum_actors: Annotated[int, typer.Option(min=0, help="of the case")] = 1,
    json_output: Json = False,
) -> None:
    """The case score of a bundle, from the evidence in it."""
    from c4s.bundle import read_bundle, score_bundle

    found = score_bundle(read_bundle(folder), minimum_actors=minimum_actors)
    if json_output:
        print_json(
            {
                "score": found.score.plain(),
                "verdicts": {name: verdict.plain() for name, verdict in found.verdicts.items()},
            }
        )
        return
    say(
        f"{found.score.case_id} ({found.score.setting}), {found.score.configuration}: {found.score.status}"
        + (f", {found.score.reason}" if found.score.reason else "")
    )
    print_table(
        ["component", "value"],
        [["score", found.score.score], *([name, value] for name, value in found.score.components.items())],
    )


@app.command()
def pack(
    run: Annotated[str, typer.Argument(help="run id or run folder")],
    configuration: Annotated[str, typer.Argument(help="agent configuration")],
    case: Annotated[str, typer.Argument(help="case id")],
    out: Annotated[Path, typer.Argument(help="new folder")],
    repeat: Annotated[int, typer.Option(min=1, help="counts from 1")] = 1,
    suite: Annotated[Path | None, typer.Option(help="suite folder (default: the run's suite)")] = None,
    json_output: Json = False,
) -> None:
    """Pack a trial of a run as a bundle. The bundle of a repair holds the withheld truth: keep it from agents."""
    from c4s.bundle import pack_trial

    root = run_folder(run)
    plan = Plan.read(RunFolder(root).plan)
    configurations, cases = [one.name for one in plan.configurations], {one.case_id: one for one in plan.cases}
    if configuration not in configurations:
        raise unknown("configuration", configuration, configurations, where=str(root))
    if case not in cases:
        raise unknown("case", case, cases, where=str(root))
    if repeat > plan.repeats:
        raise BadInput(f"the run has {plan.repeats} repeats of each case", where=f"--repeat {repeat}")
    folder = suite if suite is not None else built_suite(plan.suite_id)
    withheld = SuiteFolder(folder).withheld(case)
    if not withheld.is_dir():
        raise BadInput("the suite has no such folder", where=str(withheld), todo="give --suite FOLDER")
    trial = RunFolder(root).trial(configuration, cases[case].alias, repeat)
    if not trial.score.is_file():
        raise BadInput("the trial has no score yet", where=str(trial.root), todo="finish the run first")
    manifest = pack_trial(trial, out, withheld=withheld)
    if json_output:
        print_json({"bundle": str(out), "files": manifest.files})
    else:
        say(f"{out}: {len(manifest.files)} files of {configuration} on {case}")
