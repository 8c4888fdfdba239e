"""Looking through files for what private cases hold: in texts, tables, archives and pictures, escaped or not."""

from __future__ import annotations

import base64
import binascii
import gzip
import hashlib
import io
import re
import zipfile
import zlib
from collections.abc import Collection, Iterator
from dataclasses import dataclass
from pathlib import Path

import pyarrow as pa
import pyarrow.parquet as pq

from c4s.errors import MachineryFault
from warehouse.release.secrets import CORE, Secrets
from warehouse.release.words import found_in, strings_of

_PICTURE = re.compile(rb"\xff\xd8\xff|\x89PNG\r\n")
_BASE64 = re.compile(rb"[A-Za-z0-9+/_-]{64,}={0,2}")
_DEEPEST = 4
"""Files in files."""
_DATABASE = b"DUCK"
_CLOSED = (b"\xfd7zXZ\0", b"\x28\xb5\x2f\xfd", b"7z\xbc\xaf\x27\x1c", b"SQLite format 3\0")
_BZIP = re.compile(rb"BZh[1-9]1AY&SY")
"""What files begin with that cannot be looked through."""
_UNREADABLE = "unreadable"
_TABLE, _ARCHIVE, _GZIP = b"PAR1", b"PK\x03\x04", b"\x1f\x8b\x08"
_DAMAGED = (OSError, EOFError, RuntimeError, NotImplementedError, zipfile.BadZipFile, zlib.error, pa.ArrowException)
"""What opening a damaged or locked file raises."""
SHOWN = 3


@dataclass(frozen=True)
class Leak:
    """Something of a private case that stands in a file."""

    file: str
    """Path below the folder that was looked through; of a file in an archive, both."""
    kind: str
    """What it is: ``case``, ``prompt``, ``picture``, ... Not the thing itself: what is told of a leak is no leak."""


def leaks_in(folder: Path, secrets: Secrets, known: Collection[str] = ()) -> list[Leak]:
    """Every kind of secret in every file of a folder, their names included; each once a file.

    Files whose paths below the folder are ``known`` were looked through for the same before.

    Texts are compared by their words (``words.py``): case, punctuation, markup and the escapes of HTML, JSON and
    addresses make no difference. Parquet files are read, archives opened, base64 decoded. A picture is found by its
    bytes, alone or inside of another file; one that was drawn or compressed anew is not. A database, an archive of
    another kind or more than ``_DEEPEST`` deep, and a damaged file cannot be looked through, and are told.
    """
    found: set[Leak] = set()
    for path in sorted(folder.rglob("*")):
        name = str(path.relative_to(folder))
        if path.is_file() and name not in known:
            found |= {Leak(name, kind) for kind in kinds_in(name.encode() + b"\n", secrets, _DEEPEST)}
            found |= {Leak(name, kind) for kind in kinds_in(path.read_bytes(), secrets)}
    return sorted(found, key=lambda leak: (leak.file, leak.kind))


def refuse_leaks(folder: Path, secrets: Secrets, known: Collection[str] = ()) -> None:
    """``MachineryFault`` where a folder that is to be published tells of a private case (``leaks_in``)."""
    if not secrets:
        return
    if found := leaks_in(folder, secrets, known):
        told = ", ".join(f"{leak.kind} in {leak.file}" for leak in found[:SHOWN])
        raise MachineryFault(
            f"this would publish what private cases hold: {told}" + (" and more" if len(found) > SHOWN else ""),
            where=folder.name,
            todo="nothing was written; what private and public cases share by intent has to be of a public case too",
        )


def kinds_in(data: bytes, secrets: Secrets, depth: int = 0) -> set[str]:
    """Kinds of secrets in a file's bytes. ``depth``: how many files it lies in already."""
    found = _in_pictures(data, secrets)
    if data[8:12] == _DATABASE:
        return found | {"database"}
    if data.startswith(_CLOSED) or _BZIP.match(data):
        return found | {_UNREADABLE}
    if depth < _DEEPEST:
        try:
            for inner in _inside(data):
                found |= kinds_in(inner, secrets, depth + 1)
        except _DAMAGED:
            found.add(_UNREADABLE)
    elif data.startswith((_TABLE, _ARCHIVE, _GZIP)):
        found.add(_UNREADABLE)
    for text in _texts(data):
        found |= _in_text(text, secrets)
    return found


def _in_text(text: str, secrets: Secrets) -> set[str]:
    found = found_in(text, secrets.pieces, secrets.beginnings, secrets.joined)
    return {secrets.pieces[piece] for piece in found}


def _texts(data: bytes) -> Iterator[str]:
    yield data.decode("utf-8", errors="replace")
    if b"\0" in data[:4096]:
        yield data.decode("utf-16-le", errors="replace")


def _in_pictures(data: bytes, secrets: Secrets) -> set[str]:
    if not secrets.pictures:
        return set()
    if hashlib.sha256(data).hexdigest() in secrets.pictures:
        return {"picture"}
    for start in _PICTURE.finditer(data):
        if data[start.start() + CORE.start : start.start() + CORE.stop] in secrets.cores:
            return {"picture"}
    return set()


def _inside(data: bytes) -> Iterator[bytes]:
    """What a file holds in another form: columns, members of an archive, base64."""
    if data.startswith(_TABLE):
        yield from _of_table(data)
    elif data.startswith(_ARCHIVE):
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            for name in archive.namelist():
                yield name.encode()
                yield archive.read(name)
    elif data.startswith(_GZIP):
        yield gzip.decompress(data)
    else:
        for run in _BASE64.findall(data):
            others = b"-_" if b"-" in run or b"_" in run else None
            try:
                inner = base64.b64decode(run + b"=" * (-len(run) % 4), altchars=others)
            except (binascii.Error, ValueError):
                continue
            yield inner
        if data.startswith(b"\x89PNG"):
            yield from _of_png(data)


def _of_table(data: bytes) -> Iterator[bytes]:
    file = pq.ParquetFile(io.BytesIO(data))
    schema = file.schema_arrow
    yield "\n".join(schema.names).encode()
    for name, value in (schema.metadata or {}).items():
        yield name + b"\n" + value
    for batch in file.iter_batches():
        for column in batch.columns:
            if pa.types.is_binary(column.type) or pa.types.is_large_binary(column.type):
                yield from (value for value in column.to_pylist() if value is not None)
            elif not pa.types.is_primitive(column.type):
                distinct = set(strings_of(column.to_pylist()))
                yield "\n|\n".join(sorted(distinct)).encode()


def _of_png(data: bytes) -> Iterator[bytes]:
    """The compressed texts of a PNG file."""
    for chunk in re.finditer(rb"(?:zTXt|iTXt)", data):
        body = data[chunk.end() : chunk.end() + int.from_bytes(data[chunk.start() - 4 : chunk.start()], "big")]
        for place in (one.start() for one in re.finditer(rb"\x78[\x01\x5e\x9c\xda]", body)):
            try:
                yield zlib.decompress(body[place:])
            except zlib.error:
                continue
