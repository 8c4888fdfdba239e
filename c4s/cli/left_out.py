"""Commands that show many things: what can be read is shown, and the rest is told at the end, with exit 2."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import TypeVar

from c4s.errors import BadInput
from c4s.records.base import Record

R = TypeVar("R", bound=Record)


def readable(kind: type[R], paths: Iterable[Path]) -> tuple[list[R], list[BadInput]]:
    """The records of files, and what is wrong with those that are none."""
    found: list[R] = []
    left_out: list[BadInput] = []
    for path in paths:
        try:
            found.append(kind.read(path))
        except BadInput as error:
            left_out.append(error)
    return found, left_out


def refuse_left_out(left_out: Sequence[BadInput]) -> None:
    """``BadInput`` of the first that was left out and the number of the others, if there is any."""
    if left_out:
        more = f"; {len(left_out) - 1} more" if len(left_out) > 1 else ""
        raise BadInput(left_out[0].line() + more)
