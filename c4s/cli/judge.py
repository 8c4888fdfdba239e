"""``c4s judge``: what a judge is worth."""

from __future__ import annotations

import typer

from c4s.cli import checking, repeating

app = typer.Typer(help="Judges: how often they are right, how far their scores repeat.", no_args_is_help=True)
app.command("check")(checking.check)
app.command("repeat")(repeating.repeat)
