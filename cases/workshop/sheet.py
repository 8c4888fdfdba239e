"""Contact sheets: all cases of a suite, and a scene with the names of its things, each one picture."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from PIL import Image, ImageDraw, ImageFont

from c4s.files import write_bytes
from c4s.packs.pictures import open_picture, png_bytes
from c4s.protocol.settings import is_construction
from c4s.records.suite import SuiteFolder

SHEET = "sheet.png"
TILE = (384, 216)
"""Width and height of a picture of a sheet, in pixels."""
MOST_PIXELS = 60_000_000
"""Of one sheet; a suite with more goes on in a second one."""
_LINE, _EDGE = 20, 8
_INK, _PAPER = (20, 22, 26), (250, 250, 248)


@dataclass(frozen=True)
class SheetRow:
    """Pictures beside each other under a line of text."""

    title: str
    pictures: Sequence[Path]


def suite_rows(suite: SuiteFolder) -> list[SheetRow]:
    """A row a case: of a repair each reference view and the start scene from there, of a text the overviews."""
    rows = []
    for case in suite.suite().cases:
        withheld = suite.withheld_case(case.case_id)
        views = suite.withheld(case.case_id) / "views"
        truth = sorted((views / "truth").glob("*.png"))
        if is_construction(case.setting):
            rows.append(SheetRow(f"{case.case_id}  {withheld.title}", truth))
            continue
        pairs = [picture for view in truth for picture in (view, views / "start" / view.name)]
        told = " ".join(withheld.operations)
        rows.append(SheetRow(f"{case.case_id}  {withheld.title}  [{told}]  original | start", pairs))
    return rows


def write_sheets(rows: Sequence[SheetRow], out: Path) -> list[Path]:
    """Write the rows as ``out``, or as ``<out>-2.png`` and so on where they are many; returns the files."""
    columns = max((len(row.pictures) for row in rows), default=1)
    width = _EDGE + columns * (TILE[0] + _EDGE)
    height = TILE[1] + _LINE + _EDGE
    most = max(1, MOST_PIXELS // (width * height))
    files = []
    for start in range(0, max(1, len(rows)), most):
        part = rows[start : start + most]
        file = out if start == 0 else out.with_name(f"{out.stem}-{start // most + 1}{out.suffix}")
        write_bytes(file, png_bytes(_drawn(part, width, height)))
        files.append(file)
    return files


def _drawn(rows: Sequence[SheetRow], width: int, height: int) -> Image.Image:
    sheet = Image.new("RGB", (width, _EDGE + max(1, len(rows)) * height), _PAPER)
    pen, font = ImageDraw.Draw(sheet), ImageFont.load_default(13)
    for number, row in enumerate(rows):
        top = _EDGE + number * height
        pen.text((_EDGE, top), row.title[: width // 7], fill=_INK, font=font)
        for column, picture in enumerate(row.pictures):
            shown = open_picture(picture, where=str(picture)).convert("RGB")
            shown.thumbnail(TILE, Image.Resampling.BOX)
            sheet.paste(shown, (_EDGE + column * (TILE[0] + _EDGE), top + _LINE))
    return sheet
