"""Changing a file of a suite, a pack or a run, and putting it back."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any


def flipped(data: bytes) -> bytes:
    """One changed byte, in the middle."""
    return bytes([*data[: len(data) // 2], data[len(data) // 2] ^ 1, *data[len(data) // 2 + 1 :]])


def edited(change: Callable[[Any], None]) -> Callable[[bytes], bytes]:
    """A change of a JSON document that stays one."""

    def apply(data: bytes) -> bytes:
        value = json.loads(data)
        change(value)
        return (json.dumps(value, indent=1, ensure_ascii=False) + "\n").encode()

    return apply


@contextmanager
def changed(path: Path, change: Callable[[bytes], bytes]) -> Iterator[None]:
    """A file with other bytes and its old time, put back at the end."""
    data, stat = path.read_bytes(), path.stat()
    assert change(data) != data
    path.write_bytes(change(data))
    os.utime(path, ns=(stat.st_atime_ns, stat.st_mtime_ns))
    try:
        yield
    finally:
        path.write_bytes(data)
        os.utime(path, ns=(stat.st_atime_ns, stat.st_mtime_ns))
