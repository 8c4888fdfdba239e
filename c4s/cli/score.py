"""``c4s score``: scores of a batch of rows."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from c4s.cli.batches import write_rows
from c4s.score.batch import score_batch


def score(batch: Annotated[Path, typer.Option("--batch", help="JSON lines (optionally gzip), one row each")]) -> None:
    """Case scores and aggregates of a batch of rows, one JSON line each."""
    write_rows(batch, score_batch)
