"""``c4s judge check``: a judge on claims whose truth is known."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from c4s.cli.output import check_new_file, print_json, print_table, say
from c4s.cli.progress import bars, step_line
from c4s.judge.names import DEFAULT_JUDGE, judge_configuration
from c4s.numbers import half_up

if TYPE_CHECKING:
    from c4s.judge.check.report import CheckCost, CheckReport, JudgeScore, Rates, TwoRounds


def check(
    judge: Annotated[str, typer.Option("--judge", help="name of a judge, or the YAML file of a model judge")] = (
        DEFAULT_JUDGE
    ),
    scene: Annotated[list[str] | None, typer.Option("--scene", help="only this scene; may be given again")] = None,
    probes: Annotated[bool, typer.Option("--probes/--no-probes", help="views, order and planted texts too")] = True,
    out: Annotated[Path | None, typer.Option("--out", help="file to write the report to")] = None,
    json_output: Annotated[bool, typer.Option("--json")] = False,
) -> None:
    """Score a judge on claims whose truth is known (docs/judge.md). The first check renders the scenes."""
    configuration = judge_configuration(judge)
    if out is not None:
        check_new_file(out)
    from cases.judge_check.running import check_judge

    with bars() as progress:
        task = progress.add_task(f"checking {configuration.name}", total=None)

        def step(what: str, done: int, total: int) -> None:
            progress.update(task, description=f"{what:40.40}", completed=done, total=total)
            step_line(what)

        report = check_judge(configuration, scene or (), with_probes=probes, step=step)
    if out is not None:
        report.write(out)
    if json_output:
        print_json(report.plain())
        return
    _tell(report)


def _tell(report: CheckReport) -> None:
    own = report.judges[report.judge]
    claims, scenes = own.all.claims, report.scenes
    print_table(
        ["judge", "accuracy", "95 %", "coverage", "right of decided", "false accepts", "false rejects", "both right"],
        [[name, *_whole(found)] for name, found in report.judges.items()],
        title=f"{claims} claims of known truth in {scenes} scene{'s' if scenes > 1 else ''}",
    )
    print_table(
        ["claims", "n", "accuracy", "95 %", "coverage", "right of decided", "false accepts", "false rejects"],
        [[name.replace("_", " "), row.claims, *_rates(row)] for name, row in own.kinds.items()],
        title=f"{report.judge} by kind",
    )
    print_table(
        ["settled by", "n", "accuracy", "95 %", "coverage", "right of decided", "false accepts", "false rejects"],
        [[name, row.claims, *_rates(row)] for name, row in own.stages.items()],
        title=f"{report.judge} by stage",
    )
    _curve(report.judge, own)
    for what, found, turned in (
        ("from one side and from another", report.views, "turned round"),
        ("in another order", report.order, "turned round"),
        ("with planted texts", report.planted, "turned to yes"),
    ):
        if found is not None:
            say(_agreement(what, found, turned))
    say(_cost("all claims", report.cost))
    say(_cost("further rounds", report.further))
    say(f"judge {report.judge_version}, claims {report.claims_sha256[:12]}")


def _cost(what: str, cost: CheckCost) -> str:
    money = "unknown" if cost.cost_usd is None else f"{cost.cost_usd:.4f} USD"
    return (
        f"cost of {what}: {cost.requests} requests, {cost.input_tokens} + {cost.output_tokens} tokens, {money}, "
        f"{cost.seconds:.1f} s ({cost.reused} judgements reused)"
    )


def _whole(found: JudgeScore) -> Sequence[str | float | None]:
    return [*_rates(found.all), f"{found.pairs_right}/{found.pairs}"]


def _rates(row: Rates) -> list[str | float | None]:
    return [
        row.accuracy,
        f"{row.low:.2f}-{row.high:.2f}",
        row.decided / row.claims if row.claims else None,
        row.accuracy_decided,
        f"{row.false_accepts}/{row.claims - row.hold}",
        f"{row.false_rejects}/{row.hold}",
    ]


def _curve(judge: str, own: JudgeScore) -> None:
    rows = [[point.confidence, point.coverage, point.risk] for point in own.curve]
    print_table(["confidence from", "coverage", "risk"], rows, title=f"{judge}: risk against coverage")


def _agreement(what: str, found: TwoRounds, turned: str) -> str:
    share = half_up(found.same / found.claims, 3) if found.claims else "–"
    return f"{what}: {found.claims} claims, same answer {share}, {found.turned} {turned}"
