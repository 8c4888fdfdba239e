"""The command ``c4s``."""

from __future__ import annotations

import functools
from typing import Annotated, Any, ClassVar, NoReturn

import typer

from c4s.cli import boundary
from c4s.cli.lazy import LazyGroup
from c4s.proxies import spare_loopback


class _C4S(LazyGroup):
    table: ClassVar = {
        "demo": (
            "c4s.cli.demo:demo",
            "Build the starter suite, run the six baselines on it, print the leaderboard and the page's address.",
        ),
        "run": (
            "c4s.cli.run:run",
            "Run agents on a suite, verify what they save, store the outcomes, render the pages.",
        ),
        "watch": (
            "c4s.cli.watch:watch",
            "Show how far a run is, from its folder alone, until nobody works on it any more: here or elsewhere.",
        ),
        "runs": ("c4s.cli.runs_commands:app", "The runs that are here: list, pause, drain, go on, prune."),
        "agent": (
            "c4s.cli.agent:app",
            "Agent clients: which there are, one trial with live output, a recorded attempt again.",
        ),
        "serve": (
            "c4s.cli.serve:serve",
            "Open a case to an MCP client of your own, show its calls, and score what it saves.",
        ),
        "grade": (
            "c4s.cli.grade:grade",
            "Verify and score a saved scene, and print one JSON object of finite numbers.",
        ),
        "export": ("c4s.cli.exports:app", "What runs hold, in formats that other programs read."),
        "suite": ("c4s.cli.suite:app", "Suites: build, list, show, check, import."),
        "catalog": ("c4s.cli.catalog:app", "Asset packs: build, list, show, search."),
        "verify": ("c4s.cli.verify:app", "Verify saved scenes: repair, physics, support, navigation."),
        "score": (
            "c4s.cli.score:score",
            "What another policy would change in a run (stored files stay as they are), or scores of a batch of rows.",
        ),
        "judge": ("c4s.cli.judge:app", "Judges: how often they are right, how far their scores repeat."),
        "bundle": (
            "c4s.cli.bundle:app",
            "Published evidence bundles (code4scene.bundle.v1): score one, or pack a trial.",
        ),
        "release": (
            "c4s.cli.release:release",
            "Pack code, public cases, configurations, skill text, schemas, judge instructions and answers of studies.",
        ),
        "report": ("c4s.cli.report:report", "Rebuild the warehouse's views and render the pages from them."),
        "sql": ("c4s.cli.sql:sql", "Ask the warehouse in SQL."),
        "analyze": (
            "c4s.cli.analyze:analyze",
            "Answer a study's question from the warehouse, with intervals that say how they were made.",
        ),
        "human": (
            "c4s.cli.human:app",
            "A human study: annotators rank scenes of a run, weights are fitted, frozen and held against a holdout.",
        ),
        "engine": ("c4s.cli.engine:app", "Engines: levels as GLB files, and what every engine must do."),
        "up": (
            "c4s.cli.service:up",
            "Start what is missing: a Prefect server, the work pools, the deployments, and workers on this machine.",
        ),
        "down": ("c4s.cli.service:down", "End the server and the workers that `c4s up` started here."),
        "worker": ("c4s.cli.service:worker", "Take work of a pool on this machine until Ctrl-C."),
        "backup": (
            "c4s.cli.backups:backup",
            "Copy the home's runs, suites, packs, warehouse parts and human studies with their digests.",
        ),
        "restore": (
            "c4s.cli.backups:restore",
            "Copy a backup into the home: each file is held against its digest, and none that is there is overwritten.",
        ),
        "doctor": ("c4s.cli.doctor:doctor", "Say what this machine has and what is missing."),
    }


app = typer.Typer(
    name="c4s",
    cls=_C4S,
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
    help="Run coding agents on 3D scene cases, score the scenes they save, publish leaderboards.",
)


def _tell_versions(asked: bool) -> None:
    if asked:
        from c4s.cli.output import say
        from c4s.cli.versions import versions

        for line in versions().splitlines():
            say(line)
        raise typer.Exit


@app.callback()
def c4s(
    version: Annotated[
        bool,
        typer.Option(
            "--version", callback=_tell_versions, is_eager=True, help="Versions of c4s, its engine, its policies."
        ),
    ] = False,
) -> None:
    """Run coding agents on 3D scene cases, score the scenes they save, publish leaderboards."""


@functools.cache
def command() -> Any:
    """The tree of all commands, groups and options."""
    return typer.main.get_command(app)


def main() -> NoReturn:
    """Entry point: exit 0 done, 1 the answer is no, 2 bad usage or bad input, 3 the machinery failed."""
    spare_loopback()
    boundary.run(lambda: command()(prog_name="c4s", standalone_mode=False))
