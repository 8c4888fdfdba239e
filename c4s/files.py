"""Reading and writing files: atomic writes, canonical JSON, digests, and readers that fail with one clear line."""

from __future__ import annotations

import errno
import hashlib
import io
import json
import os
import re
import shutil
import stat
import sys
import tempfile
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, BinaryIO

import orjson

from c4s.bounds import BOUNDS, Bound, long_number_in, values_in
from c4s.errors import BadInput
from c4s.garbage import put_off

_KINDS = {
    stat.S_IFDIR: "a folder",
    stat.S_IFIFO: "a pipe",
    stat.S_IFSOCK: "a socket",
    stat.S_IFCHR: "a device",
    stat.S_IFBLK: "a device",
}
_UNFINISHED = re.compile(r"\..+\.[a-z0-9_]{8}")
FULL_BYTES = 32 << 20
"""A disk with less room than this is full: nothing that an attempt or a stage leaves is sure to fit."""

MOST_WHOLE = 2**53 - 1
"""A larger whole number is not the same in every reader of JSON: seeds are at most this."""


def check_disk(folder: Path) -> None:
    """``OSError`` (``ENOSPC``) where the disk of a folder is full: what was not saved there is nobody's doing."""
    if shutil.disk_usage(folder).free < FULL_BYTES:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), str(folder))


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


def is_unfinished(name: str) -> bool:
    """Whether a name is one that ``write_bytes`` gives to a file, or ``beside`` to a folder, until it is whole."""
    return _UNFINISHED.fullmatch(name) is not None


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


def open_plain(path: Path, what: str = "file") -> io.BufferedReader:
    """Open a plain file for reading. ``BadInput`` for anything else, at once: a pipe or a device is not waited for."""
    try:
        handle = os.open(path, os.O_RDONLY | os.O_NONBLOCK | os.O_CLOEXEC)
    except FileNotFoundError:
        raise BadInput(f"no such {what}", where=str(path)) from None
    except (OSError, ValueError) as error:
        told = no_place(error) if isinstance(error, OSError) else str(error)
        raise BadInput(f"cannot read this {what}: {told}", where=str(path)) from None
    mode = os.fstat(handle).st_mode
    if not stat.S_ISREG(mode):
        os.close(handle)
        raise BadInput(f"this {what} is {_KINDS.get(stat.S_IFMT(mode), 'no plain file')}", where=str(path))
    return os.fdopen(handle, "rb")


def read_plain(path: Path, what: str = "file", bound: Bound = BOUNDS["document_bytes"]) -> bytes:
    """The bytes of a plain file; ``BadInput`` for anything else (``open_plain``), and for one larger than ``bound``."""
    with open_plain(path, what) as source:
        size = os.fstat(source.fileno()).st_size
        bound.hold(size, where=str(path))
        data = source.read(size)
    return data


def read_plain_text(path: Path, what: str = "file") -> str:
    """The text of a plain file in UTF-8, with or without a byte order mark; ``BadInput`` for anything else."""
    try:
        return read_plain(path, what).decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise BadInput(f"this {what} is not UTF-8 text: {error.reason}", where=str(path)) from None


def digest_file(path: Path) -> str:
    """SHA-256 (64 hex) of a plain file's content; ``BadInput`` for anything else."""
    with open_plain(path) as source:
        return hashlib.file_digest(source, "sha256").hexdigest()


def parse_bounded(data: bytes, bytes_bound: Bound, values_bound: Bound, *, plain: bool = False) -> Any:
    """Parse JSON that is measured before memory is taken for what it holds. ``ValueError`` tells what is too much.

    ``plain``: NaN and Infinity are refused.
    """
    fault = bytes_bound.fault(len(data)) or values_bound.fault(values_in(data))
    if fault is not None:
        raise ValueError(fault)
    if long_number_in(data):
        raise ValueError("a number has too many digits")
    try:
        with put_off():
            return orjson.loads(data) if plain else parse_json(data)
    except RecursionError:
        raise ValueError("it is nested too deeply") from None


def parse_json(data: bytes, *, plain: bool = False) -> Any:
    """Parse JSON; ``ValueError`` for what is none.

    The tokens NaN and Infinity, and halves of a surrogate pair, which other writers of scenes leave behind, are
    accepted, unless all has to be ``plain``: what can be written again.
    """
    with put_off():
        try:
            return orjson.loads(data)
        except orjson.JSONDecodeError:
            try:
                value = json.loads(data, parse_int=_integer)
                if plain:
                    canonical_json(value).encode()
            except UnicodeEncodeError:
                raise ValueError("a text in it is half a surrogate pair") from None
            except UnicodeDecodeError:
                raise ValueError("it is not UTF-8 text") from None
            except RecursionError:
                raise ValueError("it is nested too deep") from None
            except json.JSONDecodeError:
                raise
            except ValueError:
                raise ValueError("a number in it is too long, or is not finite") from None
            return value


def _integer(text: str) -> int:
    """An integer that can be made a real number."""
    value = int(text)
    if abs(value) > sys.float_info.max:
        raise ValueError("a number in it is too long")
    return value


def no_place(error: OSError) -> str:
    """Why a file or folder cannot be used, in the system's words without its number."""
    return (error.strerror or str(error)).lower()


def read_yaml(path: Path, *, what: str = "file") -> Any:
    """Read a YAML file of plain data, as JSON has it. ``BadInput`` when it is missing, or is none."""
    from c4s.plain_yaml import parse_yaml

    text = read_plain_text(path, what)
    try:
        return parse_yaml(text)
    except (ValueError, RecursionError) as error:
        told = "it is nested too deep" if isinstance(error, RecursionError) else " ".join(str(error).split())
        raise BadInput(f"this {what} is not valid YAML: {told}", where=str(path)) from None


def read_json_lines(path: Path, *, what: str = "file", cut: bool = False) -> list[dict[str, Any]]:
    """Read a file of JSON objects, one a line, blank lines skipped. ``BadInput`` names the line that is none.

    ``cut``: what follows the last line's end was cut off by a killed process; it is left out where it is not whole.
    """
    found = []
    lines = read_plain(path, what).split(b"\n")
    for number, line in enumerate(lines, start=1):
        if not line.strip():
            continue
        try:
            value = parse_json(line, plain=True)
        except ValueError as error:
            if cut and number == len(lines):
                break
            raise BadInput(f"line {number} of this {what} is not JSON: {error}", where=str(path)) from None
        if not isinstance(value, dict):
            raise BadInput(f"line {number} of this {what} is no JSON object", where=str(path))
        found.append(value)
    return found


def read_json(path: Path, *, what: str = "file", bound: Bound = BOUNDS["document_bytes"], plain: bool = False) -> Any:
    """Read a JSON file. Raises ``BadInput`` when it is missing, truncated, not JSON, or larger than ``bound``.

    ``plain``: see ``parse_json``.
    """
    return _read_json(path, what, bound, plain)[0]


def read_written_json(path: Path, *, what: str = "file", todo: str = "") -> Any:
    """Read a file that ``write_json`` wrote; ``BadInput`` also when its bytes are not those that it writes."""
    value, data = _read_json(path, what, BOUNDS["document_bytes"], True)
    if json_text(value).encode() != data:
        raise BadInput("the file has changed since it was written", where=str(path), todo=todo)
    return value


def _read_json(path: Path, what: str, bound: Bound, plain: bool) -> tuple[Any, bytes]:
    data = read_plain(path, what, bound)
    try:
        return parse_json(data, plain=plain), data
    except ValueError as error:
        raise BadInput(f"this {what} is not valid JSON: {error}", where=str(path), todo="is it complete?") from None


def whole_characters(value: Any) -> Any:
    """A value of JSON with ``?`` for every half of a surrogate pair in it: what UTF-8 can hold.

    ``ValueError`` for NaN and infinities, ``RecursionError`` for what is nested too deep.
    """
    return json.loads(json.dumps(value, ensure_ascii=False, allow_nan=False).encode(errors="replace"))


@contextmanager
def opened_folder(folder: Path) -> Iterator[Path]:
    """The folder under a path of this process that stays its own, even when another folder takes its name."""
    number = os.open(folder, os.O_RDONLY | os.O_DIRECTORY)
    try:
        yield Path(f"/proc/self/fd/{number}")
    finally:
        os.close(number)


def append_json_line(path: Path, value: Any) -> None:
    """Append one JSON line (a trajectory or usage record); half a surrogate pair in it becomes ``?``."""
    path.parent.mkdir(parents=True, exist_ok=True)
    with path.open("ab+") as lines:
        add_line(lines, canonical_json(value).encode(errors="replace"))


def add_line(lines: BinaryIO, text: bytes) -> None:
    """Add a line at the end of a file that is open to be read and appended to.

    It is a line of its own also after one that a crash or a full disk cut short.
    """
    cut = False
    if lines.seek(0, os.SEEK_END) > 0:
        lines.seek(-1, os.SEEK_END)
        cut = lines.read(1) != b"\n"
    lines.write((b"\n" if cut else b"") + text + b"\n")


def json_lines(lines: Iterable[str]) -> Iterator[Any]:
    """Parse JSON lines, skipping blank ones."""
    return (json.loads(line) for line in lines if line.strip())
