"""PNG files of pictures, at half the time of the usual writer: one filter for all rows, found by no search.

Each byte is told by its difference from the pixel to the left, which suits rendered pictures; the bytes are a few per
cent more than those of a filter chosen by row.
"""

from __future__ import annotations

import struct
import zlib
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

_SIGNATURE = b"\x89PNG\r\n\x1a\n"
_EIGHT_BIT_RGB = bytes([8, 2, 0, 0, 0])
_LEFT = 1
"""The filter type of a row."""
_LEVEL = 1
_CHANNELS = 3


def write_png(path: Path, rgb: NDArray[np.uint8]) -> None:
    """Write an (H, W, 3) picture."""
    height, width = rgb.shape[:2]
    rows = np.empty((height, 1 + width * _CHANNELS), dtype=np.uint8)
    flat = rgb.reshape(height, -1)
    rows[:, 0], rows[:, 1 : 1 + _CHANNELS] = _LEFT, flat[:, :_CHANNELS]
    np.subtract(flat[:, _CHANNELS:], flat[:, :-_CHANNELS], out=rows[:, 1 + _CHANNELS :])
    path.write_bytes(
        _SIGNATURE
        + _chunk(b"IHDR", struct.pack(">II", width, height) + _EIGHT_BIT_RGB)
        + _chunk(b"IDAT", zlib.compress(rows.tobytes(), _LEVEL))
        + _chunk(b"IEND", b"")
    )


def _chunk(name: bytes, data: bytes) -> bytes:
    return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))
