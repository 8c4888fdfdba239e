"""``c4s watch``: a run as it goes, wherever it runs."""

from __future__ import annotations

import time
from typing import Annotated

import typer

from c4s.cli.output import print_json, progress_console, say
from c4s.cli.run_view import INTERVAL_S, drawn, line_of
from c4s.cli.runs import run_folder
from c4s.home import suites_root
from c4s.records.folder import RunFolder
from c4s.records.plan import Plan
from c4s.run.progress import Progress


def watch(
    run: Annotated[str, typer.Argument(help="id of a run, or its folder")],
    json_output: Annotated[bool, typer.Option("--json", help="one snapshot as JSON, and no watching")] = False,
) -> None:
    """Show how far a run is, from its folder alone, until nobody works on it any more: here or elsewhere.

    Ctrl-C ends the watching, not the run. Where there is no terminal, a line is printed as trials end.
    """
    folder = run_folder(run)
    progress = Progress(folder, suites_root() / Plan.read(RunFolder(folder).plan).suite_id)
    now = progress.read()
    if json_output:
        print_json(now.plain())
        return
    if now.going:
        try:
            with drawn(progress):
                while progress.read().going:
                    time.sleep(INTERVAL_S)
        except KeyboardInterrupt:
            say("the run goes on")
            return
    now = progress.read()
    if not now.going or not progress_console.is_terminal:
        say(f"{now.run_id}: {line_of(now)}")
    for row in now.troubles:
        say(f"{row.trials} pending with {row.error}: {row.line} ({row.faults})")
