"""The plan seen from above: footprints coloured by tier, X to the right and Y down as in Unreal's top view.

The axes tell centimetres, an arrow the way that an entry faces (its +X), and labels never lie on each other: the
largest entries are named first, and those without room for a name are counted.
"""

from __future__ import annotations

import io
import math
from collections.abc import Iterator, Sequence
from typing import Any

from PIL import Image, ImageDraw, ImageFont

SIZE_PX = 900
LEFT_PX, TOP_PX, RIGHT_PX, BOTTOM_PX = 70, 20, 20, 70
SMALLEST_REACH_CM = 500.0
STEPS_CM = tuple(lead * 10.0**power for power in range(2, 8) for lead in (1, 2, 5))
LARGEST_REACH_CM = 1.0e9
LONGEST_NAME = 40
MOST_STEPS = 5
"""Grid lines on each side of the middle."""
COLOURS = {0: (226, 231, 225), 1: (176, 120, 92), 2: (93, 138, 198), 3: (226, 162, 60)}
INK, AXIS, GRID, EDGE, ARROW = (20, 20, 20), (90, 90, 90), (232, 232, 232), (70, 70, 70), (160, 20, 30)
SHORTEST_ARROW_PX = 9.0
GAP_PX, INSET_PX, TEXT_PX = 2, 4, 20

Box = tuple[float, float, float, float]
Entry = dict[str, Any]


class _Plan:
    """A picture with a scale in centimetres."""

    def __init__(self, reach_cm: float) -> None:
        self.step = next((step for step in STEPS_CM if reach_cm <= MOST_STEPS * step), STEPS_CM[-1])
        self.reach = self.step * math.ceil(reach_cm / self.step)
        self.side = SIZE_PX - LEFT_PX - RIGHT_PX
        self.image = Image.new("RGB", (SIZE_PX, TOP_PX + self.side + BOTTOM_PX), "white")
        self.draw = ImageDraw.Draw(self.image)
        self.font = ImageFont.load_default(12)
        self.taken: list[Box] = []
        """Where text lies."""

    def at(self, x: float, y: float) -> tuple[float, float]:
        """The pixel of a place on the ground (cm)."""
        scale = self.side / (2 * self.reach)
        return LEFT_PX + (x + self.reach) * scale, TOP_PX + (y + self.reach) * scale

    def axes(self) -> None:
        """A grid with the coordinates of its lines."""
        lines = round(self.reach / self.step)
        for number in range(-lines, lines + 1):
            value = number * self.step
            (x, y), colour = self.at(value, value), AXIS if number == 0 else GRID
            self.draw.line([(x, TOP_PX), (x, TOP_PX + self.side)], fill=colour)
            self.draw.line([(LEFT_PX, y), (LEFT_PX + self.side, y)], fill=colour)
            self.draw.text((x, TOP_PX + self.side + 5), f"{value:.0f}", fill=AXIS, font=self.font, anchor="ma")
            self.draw.text((LEFT_PX - 5, y), f"{value:.0f}", fill=AXIS, font=self.font, anchor="rm")

    def box(self, entry: Entry) -> Box:
        """A footprint in pixels: left, top, right, bottom."""
        x0, y0, x1, y1 = entry["footprint_cm"]
        return *self.at(x0, y0), *self.at(x1, y1)

    def footprint(self, entry: Entry) -> None:
        """Fill a footprint with the colour of its tier."""
        self.draw.rectangle(self.box(entry), fill=COLOURS[entry["tier"]], outline=EDGE)

    def arrow(self, entry: Entry) -> None:
        """An arrow from the middle of a footprint to its edge, the way that it faces."""
        left, top, right, bottom = self.box(entry)
        x, y, width, height = (left + right) / 2, (top + bottom) / 2, right - left, bottom - top
        yaw_deg = entry["rotation"][1]
        along, across = math.cos(math.radians(yaw_deg)), math.sin(math.radians(yaw_deg))
        edge = min(width / 2 / max(abs(along), 1e-9), height / 2 / max(abs(across), 1e-9))
        length = max(edge, SHORTEST_ARROW_PX)
        tip = (x + along * length, y + across * length)
        self.draw.line([(x, y), tip], fill=ARROW, width=2)
        head = min(7.0, length / 2)
        wings = [
            (tip[0] - head * math.cos(turn), tip[1] - head * math.sin(turn))
            for turn in (math.radians(yaw_deg) + 0.5, math.radians(yaw_deg) - 0.5)
        ]
        self.draw.polygon([tip, *wings], fill=ARROW)

    def label(self, entry: Entry) -> bool:
        """Write an entry's name in or beside its footprint; False where no place is free."""
        name = " ".join(str(entry["name"]).split())[:LONGEST_NAME]
        for x, y, anchor in self._places(entry, name):
            box = self.draw.textbbox((x, y), name, font=self.font, anchor=anchor)
            if self._free(box):
                self.draw.text(
                    (x, y), name, fill=INK, font=self.font, anchor=anchor, stroke_width=2, stroke_fill="white"
                )
                self.taken.append(box)
                return True
        return False

    def _places(self, entry: Entry, name: str) -> Iterator[tuple[float, float, str]]:
        """Inside where it fits, else around."""
        left, top, right, bottom = self.box(entry)
        x, y = (left + right) / 2, (top + bottom) / 2
        if self.draw.textlength(name, font=self.font) < right - left - 2 * INSET_PX and bottom - top > TEXT_PX:
            yield left + INSET_PX, top + INSET_PX, "lt"
            yield left + INSET_PX, bottom - INSET_PX, "lb"
        yield x, top - GAP_PX, "mb"
        yield x, bottom + GAP_PX, "mt"
        yield right + GAP_PX, y, "lm"
        yield left - GAP_PX, y, "rm"
        yield x, y, "mm"

    def _free(self, box: Box) -> bool:
        inside = box[0] >= LEFT_PX and box[2] <= LEFT_PX + self.side and box[1] >= 0 and box[3] <= TOP_PX + self.side
        return inside and not any(
            box[0] <= other[2] + GAP_PX
            and other[0] <= box[2] + GAP_PX
            and box[1] <= other[3] + GAP_PX
            and other[1] <= box[3] + GAP_PX
            for other in self.taken
        )

    def caption(self, told: str) -> None:
        """The line below the picture."""
        place = (LEFT_PX, TOP_PX + self.side + BOTTOM_PX - 18)
        self.draw.text(place, told, fill=AXIS, font=self.font, anchor="lm")

    def png(self) -> bytes:
        """The picture as a file."""
        buffer = io.BytesIO()
        self.image.save(buffer, "PNG")
        return buffer.getvalue()


def render_plan(solved: dict[str, Any]) -> bytes:
    """PNG of a solved plan: axes in cm, footprints with their facing, and as many names as fit, the largest first.

    ``ValueError`` for a plan of more than 10,000 km.
    """
    entries: Sequence[Entry] = solved.get("entries", [])
    sides = [abs(side) for entry in entries for side in entry["footprint_cm"]]
    if not all(side <= LARGEST_REACH_CM for side in sides):
        raise ValueError("the plan is too large to be drawn")
    plan = _Plan(max([SMALLEST_REACH_CM, *sides]))
    for entry in entries:
        if not entry["tier"]:
            plan.footprint(entry)
    plan.axes()
    things = sorted((entry for entry in entries if entry["tier"]), key=_area_cm2, reverse=True)
    for draw in (plan.footprint, plan.arrow):
        for entry in things:
            draw(entry)
    unnamed = sum(not plan.label(entry) for entry in things)
    missing = f"; {unnamed} without room for a name" if unnamed else ""
    plan.caption(f"X right, Y down, in cm; grid {plan.step:.0f} cm; arrows face +X; {len(entries)} entries{missing}")
    return plan.png()


def _area_cm2(entry: Entry) -> float:
    x0, y0, x1, y1 = entry["footprint_cm"]
    area: float = (x1 - x0) * (y1 - y0)
    return area
