"""The plan seen from above: footprints coloured by tier, X to the right and Y down as in Unreal's top view."""

from __future__ import annotations

import io
from typing import Any

from PIL import Image, ImageDraw, ImageFont

SIZE_PX = 900
MARGIN_PX = 40
COLOURS = {0: (226, 231, 225), 1: (176, 120, 92), 2: (93, 138, 198), 3: (226, 162, 60)}


def render_plan(solved: dict[str, Any]) -> bytes:
    """PNG of a solved plan, ``SIZE_PX`` square, with a 10 m grid and the names of the largest entries."""
    entries = solved.get("entries", [])
    reach = max([1000.0, *(abs(side) for entry in entries for side in entry["footprint_cm"])])
    factor = (SIZE_PX / 2 - MARGIN_PX) / reach
    image = Image.new("RGB", (SIZE_PX, SIZE_PX), "white")
    draw = ImageDraw.Draw(image)
    font = ImageFont.load_default(12)

    def at(x: float, y: float) -> tuple[float, float]:
        return SIZE_PX / 2 + x * factor, SIZE_PX / 2 + y * factor

    for line in range(-int(reach // 1000), int(reach // 1000) + 1):
        draw.line([at(line * 1000, -reach), at(line * 1000, reach)], fill=(240, 240, 240))
        draw.line([at(-reach, line * 1000), at(reach, line * 1000)], fill=(240, 240, 240))
    for entry in sorted(entries, key=lambda found: (found["tier"], found["name"])):
        x0, y0, x1, y1 = entry["footprint_cm"]
        draw.rectangle([at(x0, y0), at(x1, y1)], fill=COLOURS[entry["tier"]], outline=(70, 70, 70))
    large = sorted(
        entries,
        key=lambda e: (e["footprint_cm"][0] - e["footprint_cm"][2]) * (e["footprint_cm"][3] - e["footprint_cm"][1]),
    )
    for entry in [found for found in large if found["tier"]][:40]:
        x0, y0, x1, y1 = entry["footprint_cm"]
        draw.text(at((x0 + x1) / 2, (y0 + y1) / 2), entry["name"], fill=(20, 20, 20), font=font, anchor="mm")
    draw.text(
        (MARGIN_PX, SIZE_PX - MARGIN_PX / 2),
        f"{2 * reach / 100:.0f} m across, {len(entries)} entries; X right, Y down",
        fill=(90, 90, 90),
        font=font,
        anchor="lm",
    )
    buffer = io.BytesIO()
    image.save(buffer, "PNG")
    return buffer.getvalue()
