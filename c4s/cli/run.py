"""``c4s run``: agents on a suite."""

from __future__ import annotations

from typing import Annotated

import typer

from c4s.cli.board import leaderboard, print_leaderboard
from c4s.cli.output import print_json, say
from c4s.cli.suites import built_suite
from c4s.engine import DEFAULT_ENGINE, engine_kinds
from c4s.judge.names import DEFAULT_JUDGE, JUDGE_NAMES
from c4s.names import checked_name
from c4s.protocol.rules import DEFAULT_POLICY
from c4s.run.bounds import MOST_FAULTS, MOST_REPEATS, MOST_SLOTS, MOST_TOKENS, amount, moment


def run(
    suite: Annotated[str, typer.Argument(help="id of a built suite")],
    agent: Annotated[
        list[str] | None,
        typer.Option(
            "--agent",
            "-a",
            help="configuration name or YAML file; repeatable (default: the six baselines, "
            "without those that cannot work on the suite)",
        ),
    ] = None,
    case: Annotated[list[str] | None, typer.Option("--case", "-c", help="only this case; repeatable")] = None,
    run_id: Annotated[str | None, typer.Option(help="folder name of the run (default: the suite's id)")] = None,
    repeats: Annotated[int, typer.Option(min=1, max=MOST_REPEATS, help="repeats of each case")] = 1,
    policy: Annotated[str, typer.Option(help="id of a score policy that ships")] = DEFAULT_POLICY,
    judge: Annotated[str, typer.Option(help=f"{', '.join(JUDGE_NAMES)}, or a judge's YAML file")] = DEFAULT_JUDGE,
    engine: Annotated[str, typer.Option(help=", ".join(engine_kinds()))] = DEFAULT_ENGINE,
    slots: Annotated[
        int | None, typer.Option(min=1, max=MOST_SLOTS, help="engines at once (default: one a core)")
    ] = None,
    wait: Annotated[
        bool, typer.Option("--wait", help="where somebody else works on the run, wait for them (else: exit 2)")
    ] = False,
    deadline: Annotated[
        str | None, typer.Option(help="no attempt starts after it: 8h, 1h30m, 07:30, 2026-11-24T07:30")
    ] = None,
    spend: Annotated[
        float | None,
        typer.Option(min=0, help="US dollars that the whole run may spend (default: C4S_SPENDING_LIMIT_USD)"),
    ] = None,
    judge_spend: Annotated[
        float | None,
        typer.Option(min=0, help="US dollars that the whole run may spend on its judge (default: no limit)"),
    ] = None,
    judge_tokens: Annotated[
        int | None, typer.Option(min=0, max=MOST_TOKENS, help="tokens that the whole run's judge may use")
    ] = None,
    accept_faults: Annotated[
        bool,
        typer.Option(
            "--accept-faults", help="a claim that the judge's endpoint fails on for good is an error, worth 0"
        ),
    ] = False,
    most_faults: Annotated[
        int, typer.Option(min=1, max=MOST_FAULTS, help="stop when so many trials in a row fail for one cause")
    ] = 20,
    notify: Annotated[
        str | None,
        typer.Option(help="address or command that is told when a guard stops the run and how it ends: C4S_NOTIFY"),
    ] = None,
    json_output: Annotated[bool, typer.Option("--json")] = False,
) -> None:
    """Run agents on a suite, verify what they save, store the outcomes, render the pages.

    The same command again goes on where a run stopped. A run grows: other agents, cases or repeats under the same
    run id are added to its plan, and what is done is reused.

    The first Ctrl-C (or SIGTERM) starts no attempt any more and lets what is in work end; the second ends it at once.
    Exit 1 where that, a deadline, the spending limit or `c4s runs drain` stopped the run before it was done.
    """
    built_suite(suite)
    if run_id is not None:
        checked_name(run_id, "--run-id")
    from c4s.cli.evaluation import evaluate_here
    from c4s.run.oversight import RunBounds

    made = evaluate_here(
        suite,
        agent or (),
        run_id=run_id,
        cases=case or (),
        repeats=repeats,
        policy=policy,
        judge=judge,
        engine=engine,
        slots=slots,
        wait=wait,
        bounds=RunBounds(
            deadline=None if deadline is None else moment(deadline, "--deadline"),
            spend_usd=None if spend is None else amount(spend, "--spend"),
            judge_usd=None if judge_spend is None else amount(judge_spend, "--judge-spend"),
            judge_tokens=judge_tokens,
            accept_faults=accept_faults,
            most_faults=most_faults,
            notify=notify,
        ),
    )
    if json_output:
        print_json(
            {
                "page": made.page,
                "ran": made.ran,
                "reused": made.reused,
                "left_out": [row.plain() for row in made.left_out],
                "seconds": round(made.seconds, 2),
                "leaderboard": leaderboard(suite),
            }
        )
        return
    print_leaderboard(suite)
    say(made.line())
    say(made.page)
