"""Pictures of pages that are kept, and how far one may be from what it was."""

from __future__ import annotations

import io
import os
from pathlib import Path
from typing import TYPE_CHECKING, Final

import numpy as np
from PIL import Image

if TYPE_CHECKING:
    from playwright.sync_api import Page

FOLDER: Final = Path(__file__).parent / "pictures"
WIDTH: Final = 400
"""Pixels of a kept picture: what it shows can be told, its letters cannot."""
COLOURS: Final = 32
FAR: Final = 40
"""Of 255: a pixel that differs by more in any colour is another one."""
MOST_OTHERS: Final = 0.06
"""Share of pixels that may be others: letters are drawn differently on every machine."""
KEEP: Final = "C4S_KEEP_PICTURES"
"""Set it to write pictures anew; look at them before they are kept."""


def assert_as_kept(page: Page, name: str) -> None:
    """The window of a page looks as in ``pictures/<name>.png``."""
    seen = Image.open(io.BytesIO(page.screenshot())).convert("RGB")
    seen = seen.resize((WIDTH, round(seen.height * WIDTH / seen.width)), Image.Resampling.BOX)
    path = FOLDER / f"{name}.png"
    if os.environ.get(KEEP):
        path.parent.mkdir(exist_ok=True)
        seen.quantize(COLOURS).save(path, optimize=True)
    kept = np.asarray(Image.open(path).convert("RGB"), dtype=np.int16)
    now = np.asarray(seen.quantize(COLOURS).convert("RGB"), dtype=np.int16)
    assert now.shape == kept.shape, f"{name}: {now.shape} instead of {kept.shape}"
    others = float((np.abs(now - kept).max(axis=2) > FAR).mean())
    assert others <= MOST_OTHERS, f"{name}: {others:.1%} of the pixels are others ({KEEP}=1 keeps it as it is now)"
