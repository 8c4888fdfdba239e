"""The command ``c4s``."""

from __future__ import annotations

import functools
from typing import Any, NoReturn

import typer

from c4s.cli import (
    agent,
    analyze,
    backups,
    boundary,
    bundle,
    catalog,
    demo,
    doctor,
    engine,
    exports,
    grade,
    human,
    judge,
    release,
    report,
    run,
    runs_commands,
    score,
    serve,
    service,
    sql,
    suite,
    verify,
    watch,
)

app = typer.Typer(
    name="c4s",
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
    help="Run coding agents on 3D scene cases, score the scenes they save, publish leaderboards.",
)
app.command("demo")(demo.demo)
app.command("run")(run.run)
app.command("watch")(watch.watch)
app.add_typer(runs_commands.app, name="runs")
app.command("backup")(backups.backup)
app.command("restore")(backups.restore)
app.add_typer(agent.app, name="agent")
app.command("serve")(serve.serve)
app.command("grade")(grade.grade)
app.add_typer(verify.app, name="verify")
app.add_typer(judge.app, name="judge")
app.add_typer(human.app, name="human")
app.command("score")(score.score)
app.add_typer(bundle.app, name="bundle")
app.add_typer(exports.app, name="export")
app.add_typer(suite.app, name="suite")
app.add_typer(catalog.app, name="catalog")
app.add_typer(engine.app, name="engine")
app.command("release")(release.release)
app.command("report")(report.report)
app.command("sql")(sql.sql)
app.command("analyze")(analyze.analyze)
app.command("up")(service.up)
app.command("down")(service.down)
app.command("worker")(service.worker)
app.command("doctor")(doctor.doctor)


@functools.cache
def command() -> Any:
    """The tree of all commands, groups and options."""
    return typer.main.get_command(app)


def main() -> NoReturn:
    """Entry point: exit 0 done, 1 the answer is no, 2 bad usage or bad input, 3 the machinery failed."""
    boundary.run(lambda: command()(prog_name="c4s", standalone_mode=False))
