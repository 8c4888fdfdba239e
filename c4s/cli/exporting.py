"""``c4s suite export-harbor``: a suite as task folders of Harbor."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from c4s.cli.output import print_json, say
from c4s.cli.suites import built_suite
from c4s.records.suite import SuiteFolder


def export_harbor(
    suite: Annotated[str, typer.Argument(help="id of a built suite")],
    out: Annotated[Path, typer.Option(help="new folder: a task folder a case")],
    case: Annotated[list[str] | None, typer.Option("--case", "-c", help="case ids (default: all)")] = None,
    image: Annotated[str, typer.Option(help="image that deploy/harbor/Dockerfile makes")] = "c4s-harbor",
    json_output: Annotated[bool, typer.Option("--json")] = False,
) -> None:
    """Write a suite as Harbor task folders, each with a separate verifier and a solution.

    They hold the withheld truth, in `tests/` and `solution/`, as Harbor wants it: keep them from agents.
    """
    from c4s.harness.harbor import export_harbor as write

    made = write(SuiteFolder(built_suite(suite)), out, cases=case or (), image=image)
    if json_output:
        print_json({"suite": suite, "folder": str(out), "tasks": [folder.name for folder in made]})
    else:
        say(f"{out}: {len(made)} tasks of {suite}; try them with `harbor run -p {out} -a oracle`")
