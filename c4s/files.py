"""Reading and writing files: atomic writes, canonical JSON, digests, and readers that fail with one clear line."""

from __future__ import annotations

import hashlib
import json
import os
import tempfile
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

import orjson

from c4s.errors import BadInput
from c4s.garbage import put_off


def write_bytes(path: Path, data: bytes) -> None:
    """Write a file so that a reader sees the old content or the new, never a part: temporary name, sync, rename."""
    path.parent.mkdir(parents=True, exist_ok=True)
    handle, name = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name}.")
    try:
        with os.fdopen(handle, "wb") as out:
            out.write(data)
            out.flush()
            os.fsync(out.fileno())
        Path(name).chmod(0o644)
        Path(name).replace(path)
    except BaseException:
        Path(name).unlink(missing_ok=True)
        raise


def write_text(path: Path, text: str) -> None:
    """Write UTF-8 text atomically."""
    write_bytes(path, text.encode())


def json_text(value: Any, *, indent: int | None = 1) -> str:
    """JSON as it is written to files; NaN and infinities are refused (``ValueError``)."""
    return json.dumps(value, indent=indent, ensure_ascii=False, allow_nan=False) + "\n"


def write_json(path: Path, value: Any, *, indent: int | None = 1) -> None:
    """Write JSON atomically; NaN and infinities are refused (``ValueError``)."""
    write_text(path, json_text(value, indent=indent))


def canonical_json(value: Any) -> str:
    """JSON with sorted keys and no blanks: the form that is digested."""
    return json.dumps(value, sort_keys=True, separators=(",", ":"), ensure_ascii=False, allow_nan=False)


def digest(value: Any) -> str:
    """SHA-256 (64 hex) of a value's canonical JSON."""
    return hashlib.sha256(canonical_json(value).encode()).hexdigest()


def digest_bytes(data: bytes) -> str:
    """SHA-256 (64 hex) of bytes."""
    return hashlib.sha256(data).hexdigest()


def digest_file(path: Path) -> str:
    """SHA-256 (64 hex) of a file's content."""
    with path.open("rb") as source:
        return hashlib.file_digest(source, "sha256").hexdigest()


def parse_json(data: bytes) -> Any:
    """Parse JSON. The tokens NaN and Infinity, which some exporters write, are accepted; else ``ValueError``."""
    with put_off():
        try:
            return orjson.loads(data)
        except orjson.JSONDecodeError:
            return json.loads(data)


def read_json(path: Path, *, what: str = "file") -> Any:
    """Read a JSON file. Raises ``BadInput`` when it is missing, truncated or not JSON."""
    return _read_json(path, what)[0]


def read_written_json(path: Path, *, what: str = "file", todo: str = "") -> Any:
    """Read a file that ``write_json`` wrote; ``BadInput`` also when its bytes are not those that it writes."""
    value, data = _read_json(path, what)
    if json_text(value).encode() != data:
        raise BadInput("the file has changed since it was written", where=str(path), todo=todo)
    return value


def _read_json(path: Path, what: str) -> tuple[Any, bytes]:
    try:
        data = path.read_bytes()
    except FileNotFoundError:
        raise BadInput(f"no such {what}", where=str(path)) from None
    except OSError as error:
        raise BadInput(f"cannot read this {what}: {error}", where=str(path)) from None
    try:
        return parse_json(data), data
    except (ValueError, RecursionError) as error:
        raise BadInput(f"this {what} is not valid JSON: {error}", where=str(path), todo="is it complete?") from None


def append_json_line(path: Path, value: Any) -> None:
    """Append one JSON line (a trajectory or usage record)."""
    path.parent.mkdir(parents=True, exist_ok=True)
    with path.open("a", encoding="utf-8") as out:
        out.write(canonical_json(value) + "\n")


def json_lines(lines: Iterable[str]) -> Iterator[Any]:
    """Parse JSON lines, skipping blank ones."""
    return (json.loads(line) for line in lines if line.strip())
