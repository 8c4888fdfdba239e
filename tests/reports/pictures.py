"""Pictures of pages that are kept, and how far one may be from what it was."""

from __future__ import annotations

import io
import os
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

import numpy as np
from PIL import Image

if TYPE_CHECKING:
    from playwright.sync_api import Page

FOLDER: Final = Path(__file__).parent / "pictures"
WIDTH: Final = 400
"""Pixels of a kept picture: what it shows can be told, its letters cannot."""
COLOURS: Final = 32
CELLS: Final = 64
"""Cells of a row that are compared, each by its mean colour: letters are drawn differently on every machine, and other
letters of the same text leave a cell as it was."""
FAR: Final = 10
"""Of 255: a cell that differs by more in any colour is another one."""
MOST_OTHERS: Final = 0.04
"""Share of cells that may be others. Another font makes 1 % of them so; a table that is gone, a head that is gone or
text in another colour makes 10 % and more."""
DECODED: Final = """() => Promise.all([...document.images]
    .filter((image) => image.checkVisibility() && image.getBoundingClientRect().top < innerHeight)
    .map((image) => image.decode()))"""
"""Waits for the pictures in the window: those that are loaded lazily are not part of the page's load."""
KEEP: Final = "C4S_KEEP_PICTURES"
"""Set it to write pictures anew; look at them before they are kept."""


def assert_as_kept(page: Page, name: str) -> None:
    """The window of a page looks as in ``pictures/<name>.png``."""
    page.evaluate(DECODED)
    seen = Image.open(io.BytesIO(page.screenshot())).convert("RGB")
    seen = seen.resize((WIDTH, round(seen.height * WIDTH / seen.width)), Image.Resampling.BOX)
    path = FOLDER / f"{name}.png"
    if os.environ.get(KEEP):
        path.parent.mkdir(exist_ok=True)
        seen.quantize(COLOURS).save(path, optimize=True)
    kept, now = (_cells(one.convert("RGB")) for one in (Image.open(path), seen.quantize(COLOURS)))
    assert now.shape == kept.shape, f"{name}: {now.shape} instead of {kept.shape}"
    others = float((np.abs(now - kept).max(axis=2) > FAR).mean())
    assert others <= MOST_OTHERS, f"{name}: {others:.1%} of it is other ({KEEP}=1 keeps it as it is now)"


def _cells(picture: Image.Image) -> np.ndarray[Any, np.dtype[np.int16]]:
    size = (CELLS, round(picture.height * CELLS / picture.width))
    return np.asarray(picture.resize(size, Image.Resampling.BOX), dtype=np.int16)
