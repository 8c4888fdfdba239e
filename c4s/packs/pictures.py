"""Pictures of packs, folders and scenes, within their bound: a few kilobytes can hold gigabytes of one colour."""

from __future__ import annotations

import io
from pathlib import Path
from typing import BinaryIO

from PIL import Image

from c4s.bounds import BOUNDS
from c4s.errors import BadInput


def open_picture(source: Path | BinaryIO, *, where: str) -> Image.Image:
    """A picture whose pixels are not read yet.

    Raises ``BadInput`` for more of them than the bound, and Pillow's own errors for what is no picture.
    """
    try:
        picture = Image.open(source)
    except Image.DecompressionBombError:
        limit = BOUNDS["picture_pixels"]
        raise BadInput(f"{limit.what} has more than {limit.told()}", where=where) from None
    BOUNDS["picture_pixels"].hold(picture.width * picture.height, where=where)
    return picture


def png_bytes(picture: Image.Image) -> bytes:
    """A picture as a PNG file; the same picture, the same bytes."""
    out = io.BytesIO()
    picture.save(out, format="PNG", compress_level=6)
    return out.getvalue()
