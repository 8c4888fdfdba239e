"""``c4s human``: a study in which people rank generated scenes, and weights that are fitted to what they prefer."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from c4s.cli import asking
from c4s.cli.output import print_json, print_table, say
from c4s.cli.progress import bars, step_line
from c4s.cli.runs import run_folder
from c4s.errors import unknown
from c4s.files import MOST_WHOLE
from c4s.home import human_root, suites_root
from c4s.names import place_in
from c4s.protocol.criteria import CRITERIA, PRIMARY, SPLIT_SEED, CriterionName
from c4s.records.human import Labels

if TYPE_CHECKING:
    from c4s.human import OpenStudy
    from c4s.records.analysis import Findings
    from c4s.stats.human import Progress

app = typer.Typer(
    help="A human study: annotators rank scenes of a run, weights are fitted, frozen and held against a holdout.",
    no_args_is_help=True,
)
app.command("serve")(asking.serve)
app.command("review")(asking.review)
StudyName = Annotated[str, typer.Argument(metavar="STUDY", help="name of the study")]
Json = Annotated[bool, typer.Option("--json", help="the result as JSON")]
LABELS: tuple[Labels, ...] = ("individual", "consensus")


@app.command("design")
def design(
    run: Annotated[str, typer.Argument(help="run id or run folder whose scenes are shown")],
    study: StudyName,
    annotator: Annotated[list[str] | None, typer.Option(help="pseudonym of an annotator; seven, repeatable")] = None,
    agent: Annotated[list[str] | None, typer.Option("--agent", "-a", help="configuration; seven, repeatable")] = None,
    case: Annotated[list[str] | None, typer.Option("--case", "-c", help="only this case; repeatable")] = None,
    criterion: Annotated[
        list[str] | None, typer.Option(help="diagnostic criterion to ask for as well, or `all`; repeatable")
    ] = None,
    seed: Annotated[int, typer.Option(min=0, max=MOST_WHOLE, help="of who ranks what, and of the split")] = SPLIT_SEED,
    json_output: Json = False,
) -> None:
    """Make a study from a run: prompts x seven configurations, seven triplets a prompt, three annotators a triplet.

    What an annotator gets names no agent and no score.
    """
    from c4s.human import design_study

    place = place_in(human_root(), study, "study")
    people = annotator or [f"annotator-{number}" for number in range(1, 8)]
    with _progress() as told:
        made, left_out = design_study(
            run_folder(run),
            suites_root(),
            place,
            agents=agent or [],
            cases=case or [],
            annotators=people,
            criteria=_criteria(criterion or []),
            seed=seed,
            told=told,
        )
    if json_output:
        print_json({**made.plain(), "left_out": left_out})
        return
    say(
        f"{len(made.prompts)} prompts x {len(made.configurations)} configurations, {len(made.tasks)} triplets, "
        f"{made.expected([one.case_id for one in made.prompts])} rankings by each of {len(made.criteria)} criteria"
    )
    say(f"development: {', '.join(made.development)}")
    say(f"holdout: {', '.join(made.holdout)}")
    for line in left_out:
        say(f"left out: {line}")
    say(f"{place}: `c4s human serve {study}` asks the annotators in a browser on this machine")


@app.command("intake")
def intake(
    study: StudyName,
    file: Annotated[
        Path | None, typer.Argument(help="rankings as JSON lines (default: what `c4s human serve` collected)")
    ] = None,
    json_output: Json = False,
) -> None:
    """Take in strict rankings that the design asked for: all lines of a file, or none and exit 1.

    A file holds JSON lines: study, annotator, task, criterion, and order, the candidates with the best first.
    """
    from c4s.human import take

    opened = _study(study)
    found = take(opened, file or opened.folder.answers)
    if json_output:
        print_json(
            {
                "taken": found.taken,
                "there": found.there,
                "missing": found.missing,
                "faults": [{"line": one.line, "fault": one.fault} for one in found.faults],
            }
        )
    else:
        for one in found.faults:
            say(f"line {one.line}: {one.fault}")
        left = ", ".join(f"{part} {count}" for part, count in found.missing.items())
        kept = f"{found.taken} taken, {found.there} there already" if not found.faults else "nothing was taken"
        say(f"{kept}; still missing: {left}")
    if found.faults:
        raise typer.Exit(1)


@app.command("agreement")
def agreement(
    study: StudyName,
    criterion: Annotated[str, typer.Option(help="what was asked")] = PRIMARY,
    json_output: Json = False,
) -> None:
    """How far annotators agree with each other; who clicks at random stands out. No score enters."""
    from c4s.human import agreement as agreement_of

    (asked,) = _criteria([criterion])
    opened = _study(study)
    with _progress() as told:
        found = agreement_of(opened, asked, told)
    if json_output:
        print_json(found.plain())
    else:
        _show(found)


@app.command("fit")
def fit(
    study: StudyName,
    labels: Annotated[str | None, typer.Option(help="`individual` or `consensus` (default: both)")] = None,
    json_output: Json = False,
) -> None:
    """Fit the weights of a text-to-scene score to the development prompts and freeze them. The holdout stays closed."""
    from c4s.human import fit_study

    if labels is not None and labels not in LABELS:
        raise unknown("kind of label", labels, LABELS)
    opened = _study(study)
    with _progress() as told:
        frozen = [fit_study(opened, one, told) for one in LABELS if labels in (None, one)]
    if json_output:
        print_json([{"sha256": one.sha256(), **one.plain()} for one in frozen])
        return
    for one in frozen:
        say(
            f"{one.labels}: agreement {one.agreement:.4f} on {len(one.saw)} development prompts, adopted weights "
            f"{one.comparison_agreement:.4f}; {sum(one.looked_at.values()):,} policies looked at"
        )
        rows = [
            [block, ", ".join(f"{part} {weight:.2f}" for part, weight in weights.items())]
            for block, weights in one.weights.plain().items()
        ]
        print_table(["block", "weights"], rows)
        say(f"frozen: {opened.folder.fit(one.labels)}")


@app.command("evaluate")
def evaluate(study: StudyName, json_output: Json = False) -> None:
    """Open the holdout and hold the adopted and all frozen weights against people. Nothing can be fitted afterwards."""
    from c4s.human import evaluate as evaluate_study

    opened = _study(study)
    with _progress() as told:
        made = evaluate_study(opened, told)
    if json_output:
        print_json(made.plain())
    else:
        _show(made.findings)
        say(f"{opened.folder.evaluation}")


def _study(name: str) -> OpenStudy:
    from c4s.human import study_named

    return study_named(human_root(), name)


def _criteria(names: list[str]) -> list[CriterionName]:
    if "all" in names:
        return list(CRITERIA)
    for name in names:
        if name not in CRITERIA:
            raise unknown("criterion", name, CRITERIA)
    return [name for name in CRITERIA if name in names]


@contextmanager
def _progress() -> Iterator[Progress]:
    """Bars on a terminal, a line a step elsewhere."""
    with bars() as shown:
        tasks = {}

        def told(what: str, done: int, of: int) -> None:
            if what not in tasks:
                tasks[what] = shown.add_task(what, total=of)
                step_line(what)
            shown.update(tasks[what], completed=done)

        yield told


def _show(found: Findings) -> None:
    from warehouse.analyses.tables import printed

    for table in found.tables:
        rows = [[printed(row.get(column.name), column) for column in table.columns] for row in table.rows]
        print_table([column.title for column in table.columns], rows, title=table.title)
        say("")
    for made in found.intervals:
        clusters = ", ".join(f"{name} {count} prompts" for name, count in made.clusters.items())
        say(f"Intervals, {clusters}: {made.level:.0%}, {made.method}, {made.draws:,} draws, seed {made.seed}.")
        say(made.proviso)
    for note in found.notes:
        say(note)
