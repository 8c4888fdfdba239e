"""Loading scene snapshots fast: the parser accepts the NaN and Infinity tokens that exporters write."""

from __future__ import annotations

import gc
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from pydantic_core import from_json

from c4s.errors import BadInput


@contextmanager
def _without_cycle_search() -> Iterator[None]:
    """Millions of new containers and no garbage: searching for cycles meanwhile only costs time."""
    enabled = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if enabled:
            gc.enable()


def read_snapshot(path: Path) -> tuple[Any, bytes]:
    """A snapshot's JSON value and the bytes it was read from. Raises ``BadInput`` with one clear line."""
    try:
        data = path.read_bytes()
    except FileNotFoundError:
        raise BadInput("no such snapshot", where=str(path)) from None
    except OSError as error:
        raise BadInput(f"cannot read this snapshot: {error}", where=str(path)) from None
    try:
        with _without_cycle_search():
            return from_json(data, allow_inf_nan=True), data
    except ValueError as error:
        raise BadInput(f"this snapshot is not valid JSON: {error}", where=str(path), todo="is it complete?") from None
