"""``c4s grade``: the score of a scene that was saved elsewhere, as numbers."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from c4s.cli.output import print_json
from c4s.cli.suites import built_suite
from c4s.engine import DEFAULT_ENGINE, engine_kinds
from c4s.folders import check_out
from c4s.judge.names import DEFAULT_JUDGE, JUDGE_NAMES
from c4s.names import checked_name
from c4s.protocol.rules import DEFAULT_POLICY


def grade(
    submission: Annotated[
        Path, typer.Argument(help="folder of an attempt as `c4s serve --out` leaves it, or the submission in it")
    ],
    case: Annotated[str, typer.Option("--case", "-c", help="case id")],
    suite: Annotated[str, typer.Option(help="id of a built suite, withheld tree included")] = "starter",
    out: Annotated[Path | None, typer.Option(help="file that the JSON is written to as well")] = None,
    replace: Annotated[bool, typer.Option("--replace", help="overwrite a file of JSON that is there")] = False,
    harness: Annotated[str, typer.Option(help="program that drove the agent, for the record")] = "",
    policy: Annotated[str, typer.Option(help="id of a score policy that ships")] = DEFAULT_POLICY,
    judge: Annotated[str, typer.Option(help=f"{', '.join(JUDGE_NAMES)}, or a judge's YAML file")] = DEFAULT_JUDGE,
    engine: Annotated[str, typer.Option(help=", ".join(engine_kinds()))] = DEFAULT_ENGINE,
) -> None:
    """Verify and score a saved scene, and print one JSON object of finite numbers.

    `reward` is the case score, `valid` tells with 1 or 0 whether the scene passed the integrity gate, and each
    component that was evaluated stands under its name. No saved scene is a reward of 0. The evidence and verdicts
    behind the numbers lie in a folder of their own under ``tries/``.
    """
    driver = checked_name(harness, "harness") if harness else None
    if out is not None:
        check_out(out, replace=replace, magic=b"{")
    suite_folder = built_suite(suite)
    from c4s.agents.outside import OUTSIDE
    from c4s.files import write_json
    from c4s.folders import numbered_folder
    from c4s.home import home
    from c4s.records.plan import Configuration
    from c4s.records.suite import SuiteFolder
    from c4s.run.grading import grade as graded
    from c4s.run.grading import numbers

    alias = SuiteFolder(suite_folder).case(case).alias
    score = graded(
        suite_folder,
        case,
        submission,
        lambda: numbered_folder(home() / "tries", f"grade-{alias}") / "run",
        configuration=Configuration(name=OUTSIDE, client=OUTSIDE, harness=driver),
        policy=policy,
        judge=judge,
        engine=engine,
    )
    found = numbers(score)
    if out is not None:
        write_json(out, found)
    print_json(found)
