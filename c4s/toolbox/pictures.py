"""Pictures on their way to an agent: read from where agent code can write, and kept within a size."""

from __future__ import annotations

import io
import os
import stat
from pathlib import Path

from PIL import Image

from c4s.errors import shortage
from c4s.toolbox.refusal import ToolRefused

MOST_IMAGE_BYTES = 2_000_000
"""Some clients recompress larger pictures."""
MOST_PICTURE_BYTES = 64 << 20
PNG_SIGNATURE = b"\x89PNG\r\n\x1a\n"


def read_picture(path: Path, folder: Path) -> bytes:
    """A PNG that the engine wrote. Agent code writes to the same folder: links, pipes and other files are refused."""
    try:
        if not path.resolve().is_relative_to(folder.resolve()):
            raise ToolRefused("the engine wrote the picture outside the run's folder")
        handle = os.open(path, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK)
    except (OSError, ValueError) as error:
        if shortage(error) is not None:
            raise
        raise ToolRefused(f"the picture cannot be read: {error}") from None
    if not stat.S_ISREG(os.fstat(handle).st_mode):
        os.close(handle)
        raise ToolRefused("the picture is not a plain file")
    with os.fdopen(handle, "rb") as source:
        png = source.read(MOST_PICTURE_BYTES)
    if not png.startswith(PNG_SIGNATURE):
        raise ToolRefused("the picture is not a PNG")
    return png


def within_limit(png: bytes) -> bytes:
    """The picture, halved until it is within ``MOST_IMAGE_BYTES``."""
    while len(png) > MOST_IMAGE_BYTES:
        try:
            with Image.open(io.BytesIO(png), formats=["PNG"]) as image:
                buffer = io.BytesIO()
                image.resize((image.width // 2, image.height // 2), Image.Resampling.LANCZOS).save(buffer, "PNG")
        except (OSError, ValueError, SyntaxError, Image.DecompressionBombError) as error:
            raise ToolRefused(f"the picture is not a PNG that can be read: {type(error).__name__}") from error
        png = buffer.getvalue()
    return png
