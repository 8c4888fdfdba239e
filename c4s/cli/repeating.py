"""``c4s judge repeat``: how far the scores of a run's model judge repeat on the stored evidence."""

from __future__ import annotations

from typing import Annotated

import typer

from c4s.cli.output import print_json, print_table, say
from c4s.cli.runs import run_folder
from c4s.errors import BadInput
from c4s.files import write_text
from c4s.home import suites_root
from c4s.numbers import half_up
from c4s.records.folder import RunFolder
from c4s.records.plan import Plan
from c4s.records.repeatability import Repeatability
from c4s.records.suite import SuiteFolder
from c4s.stderr import tell


def repeat(
    run: Annotated[str, typer.Argument(help="run id or run folder, judged by a model")],
    repeats: Annotated[int, typer.Option(help="how often, 2 to 20")] = 3,
    agent: Annotated[list[str] | None, typer.Option("--agent", "-a", help="only this agent; repeatable")] = None,
    case: Annotated[list[str] | None, typer.Option("--case", "-c", help="only this case; repeatable")] = None,
    json_output: Annotated[bool, typer.Option("--json", help="the findings as JSON")] = False,
) -> None:
    """Ask a run's judge its stored requests of Detailed Alignment several times over, beside the run's record.

    The same command goes on where it was cut off.
    """
    from c4s.run.lease import holding
    from c4s.run.repeatability import repeatability
    from c4s.run.repeating import JudgedScene, repeat_all, study_of
    from reports.deviations import deviations_svg

    root = run_folder(run)
    plan = Plan.read(RunFolder(root).plan)
    suite = SuiteFolder(suites_root() / plan.suite_id)
    if suite.suite().sha256() != plan.suite_digest:
        raise BadInput("this is not the suite of the run", where=str(suite.root), todo="build the suite that it was")

    def told(done: int, planned: int, scene: JudgedScene, number: int) -> None:
        tell(f"  {done} of {planned}: repeat {number} of {scene.trial.name}")

    with holding(root):
        study = study_of(root, suite.root, plan, repeats, agent or [], case or [])
        if there := study.size() - len(study.left()):
            tell(f"  {there} of {study.size()} are there already")
        repeat_all(study, told)
        found = repeatability(study)
        found.write(study.folder.record)
        write_text(study.folder.picture, deviations_svg(found))
    if json_output:
        print_json(found.plain())
    else:
        _show(found)
        say(f"{study.folder.record} and {study.folder.picture.name}")


def _show(found: Repeatability) -> None:
    scenes = "1 scene" if len(found.scenes) == 1 else f"{len(found.scenes)} scenes"
    say(
        f"{found.repeats} repeats of {scenes} of run {found.run_id} by {found.judge}: "
        f"{found.requests_per_repeat} requests a repeat, {found.asked_again} asked again, {found.fallbacks} fallbacks"
    )
    print_table(
        ["rank", "configuration", *(f"repeat {number + 1}" for number in range(found.repeats)), "mean", "SD"],
        [
            [row.rank, row.configuration, *(f"{mean:.4f}" for mean in (*row.means, row.mean, row.sd))]
            for row in found.configurations
        ],
        title="Detailed Alignment, means over the scenes",
    )
    for pair in found.agreements:
        tau = "none" if pair.tau_b is None else half_up(pair.tau_b, 3)
        say(f"repeats {pair.repeats[0]} and {pair.repeats[1]}: tau-b {tau}")
    bands = ", ".join(f"{first} to {last}" for first, last in found.ranks.bands) or "none"
    say(f"ranks that keep their order from the first on: {found.ranks.leading}; reversals in ranks: {bands}")
    say(f"cohort: {found.cohort}")
