"""A scene in four pictures with the names of its things on them: what an author chooses from."""

from __future__ import annotations

import tempfile
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw, ImageFont

from c4s.engine import DEFAULT_ENGINE
from c4s.evidence import open_level
from c4s.files import write_bytes
from c4s.packs.pictures import png_bytes
from c4s.records.captures import Captures
from c4s.records.folder import EvidenceFolder
from c4s.records.level import Level
from c4s.render.masks import mask_name
from c4s.semantics.sight import overview_plan

Box = tuple[float, float, float, float]
LEAST_SHARE = 8e-4
"""Of a picture's pixels: smaller things are not named on it."""


def write_scene_sheet(level: Level, packs: Sequence[Path], out: Path) -> Path:
    """Draw the four overview views of a level, two by two, with the names of what they show; returns ``out``.

    Raises ``MachineryFault`` when the engine cannot open or draw the level.
    """
    with tempfile.TemporaryDirectory(prefix="c4s-sheet-") as folder:
        document, evidence = Path(folder) / "scene.level.json", EvidenceFolder(Path(folder) / "looked")
        level.write(document)
        with open_level(engine=DEFAULT_ENGINE, packs=packs, level=document) as clean:
            clean.export(evidence.root)
            clean.look(evidence.root, overview_plan)
        views = Captures.read(evidence.captures_index).views
        tiles = [_named(evidence.captures / view.file) for view in views]
    width, height = tiles[0].size
    sheet = Image.new("RGB", (2 * width, -(-len(tiles) // 2) * height))
    for number, tile in enumerate(tiles):
        sheet.paste(tile, (number % 2 * width, number // 2 * height))
    write_bytes(out, png_bytes(sheet))
    return out


def _named(picture: Path) -> Image.Image:
    """A picture with a name at the middle of each thing that it shows large enough."""
    shown = Image.open(picture).convert("RGB")
    pen, font = ImageDraw.Draw(shown), ImageFont.load_default(12)
    with np.load(picture.with_name(mask_name(picture.stem)), allow_pickle=False) as tables:
        mask, names = tables["actor"], [str(name) for name in tables["names"]]
    taken: list[Box] = []
    numbers, counts = np.unique(mask[mask >= 0], return_counts=True)
    for number in numbers[np.argsort(-counts)]:
        rows, columns = np.nonzero(mask == number)
        if len(rows) < LEAST_SHARE * mask.size:
            continue
        middle = (float(np.median(columns)), float(np.median(rows)))
        box = pen.textbbox(middle, names[number], font=font, anchor="mm")
        if any(_meet(box, other) for other in taken):
            continue
        taken.append(box)
        pen.rectangle((box[0] - 2, box[1] - 1, box[2] + 2, box[3] + 1), fill=(250, 250, 248))
        pen.text(middle, names[number], fill=(20, 22, 26), font=font, anchor="mm")
    return shown


def _meet(one: Box, other: Box) -> bool:
    return one[0] < other[2] and one[2] > other[0] and one[1] < other[3] and one[3] > other[1]
