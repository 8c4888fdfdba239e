"""Contact sheets: ``python -m cases.open190.sheet SCENES_FOLDER SHEET.png [scene ...]`` joins the views of scenes."""

from __future__ import annotations

import sys
from pathlib import Path

from PIL import Image, ImageDraw

WIDTH, HEIGHT, COLUMNS = 640, 360, 3


def sheet(folder: Path, out: Path, names: list[str]) -> int:
    """Draw a row of views for each built scene; returns how many scenes there are."""
    found = [
        scene for scene in sorted(folder.iterdir()) if (scene / "views").is_dir() and (not names or scene.name in names)
    ]
    picture = Image.new("RGB", (COLUMNS * WIDTH, len(found) * (HEIGHT + 18)), "white")
    pen = ImageDraw.Draw(picture)
    for row, scene in enumerate(found):
        top = row * (HEIGHT + 18)
        for column, file in enumerate(sorted((scene / "views").glob("*.png"))[:COLUMNS]):
            picture.paste(Image.open(file).convert("RGB").resize((WIDTH, HEIGHT)), (column * WIDTH, top))
        pen.text((4, top + HEIGHT + 2), scene.name, fill="black")
    picture.save(out)
    return len(found)


if __name__ == "__main__":
    print(sheet(Path(sys.argv[1]), Path(sys.argv[2]), sys.argv[3:]))
