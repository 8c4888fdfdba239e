"""The rows of one trial of a table that the database does not hold, without looking at the parts of others."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from warehouse.damage import read_part
from warehouse.parquet import is_whole, part_path


def trial_part(root: Path, table: str, *, suite: str, configuration: str, trial_id: str) -> list[dict[str, Any]]:
    """The rows, without the columns of their partition; none where none were written.

    ``BadInput`` for a part that cannot be read.
    """
    path = part_path(root, table, suite, configuration, trial_id)
    return read_part(table, path).to_pylist() if is_whole(path) else []
