"""Pictures as people get them: the pixels and nothing else that a file can say."""

from __future__ import annotations

import zlib
from collections.abc import Iterator
from typing import Final

from c4s.errors import BadInput

_SIGNATURE: Final = b"\x89PNG\r\n\x1a\n"
_PIXELS: Final = (b"IHDR", b"PLTE", b"tRNS", b"IDAT", b"IEND")
"""What a PNG needs to be shown; texts, times, EXIF, colour profiles and private chunks are none of it."""
_FRAME: Final = 12
"""Bytes of a chunk beside its data: length, name, checksum."""


def bare_png(data: bytes) -> bytes:
    """A PNG with its pixels alone; what follows its end is cut off. ``BadInput`` for anything else."""
    if not data.startswith(_SIGNATURE):
        raise BadInput("this picture is no PNG")
    kept = [chunk for name, chunk in _chunks(data) if name in _PIXELS]
    return _SIGNATURE + b"".join(kept)


def _chunks(data: bytes) -> Iterator[tuple[bytes, bytes]]:
    at, name = len(_SIGNATURE), b""
    while name != b"IEND":
        end = at + _FRAME + int.from_bytes(data[at : at + 4], "big")
        name, chunk = data[at + 4 : at + 8], data[at:end]
        if end > len(data) or zlib.crc32(chunk[4:-4]) != int.from_bytes(chunk[-4:], "big"):
            raise BadInput("this PNG is damaged")
        yield name, chunk
        at = end
