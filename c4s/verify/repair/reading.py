"""Loading scene snapshots fast: the parser accepts the NaN and Infinity tokens that exporters write."""

from __future__ import annotations

import gc
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from c4s.errors import BadInput
from c4s.files import digest_bytes, parse_json


@contextmanager
def without_cycle_search() -> Iterator[None]:
    """Millions of new containers and no garbage: searching for cycles meanwhile only costs time."""
    enabled = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if enabled:
            gc.enable()


def _read(path: Path) -> bytes:
    try:
        return path.read_bytes()
    except FileNotFoundError:
        raise BadInput("no such snapshot", where=str(path)) from None
    except OSError as error:
        raise BadInput(f"cannot read this snapshot: {error}", where=str(path)) from None


def _parse(data: bytes, path: Path) -> Any:
    try:
        return parse_json(data)
    except (ValueError, RecursionError) as error:
        raise BadInput(f"this snapshot is not valid JSON: {error}", where=str(path), todo="is it complete?") from None


def read_snapshots(paths: dict[str, Path]) -> tuple[dict[str, Any], dict[str, str]]:
    """The JSON values of named snapshots, and the SHA-256 of each file as ``<name>_snapshot``.

    Digests are made in a second thread while the first one parses. Raises ``BadInput`` with one clear line.
    """
    with ThreadPoolExecutor(max_workers=1) as hashing:
        data = {name: _read(path) for name, path in paths.items()}
        digests = {name: hashing.submit(digest_bytes, content) for name, content in data.items()}
        values = {name: _parse(content, paths[name]) for name, content in data.items()}
        return values, {f"{name}_snapshot": digest.result() for name, digest in digests.items()}
