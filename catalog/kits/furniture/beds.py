"""Beds and cots."""

from __future__ import annotations

from catalog.kits.furniture.frames import BEDS
from catalog.kits.maker import KitMaker, camel, family, word


@family("cot")
def cot(m: KitMaker) -> None:
    """A bed: double, single, bunk, of a hospital, a cot of straw."""
    kind = m.opt(
        "kind",
        m.pick("DoubleBed", "SingleBed", "BunkBed", "HospitalBed")
        if not m.style.old
        else m.pick("DoubleBed", "SingleBed", "StrawBed", "CanopyBed"),
    )
    wood, cloth = m.mat("wood"), m.mat("cloth")
    w = 165.0 if kind in ("DoubleBed", "CanopyBed") else 95.0
    frame = m.mat("metal") if kind == "HospitalBed" else wood
    m.say(
        kind,
        BEDS,
        f"{word(frame).capitalize()} {word(kind)} with {word(cloth)} cover, {w:.0f} x 205 cm.",
        camel(cloth),
        camel(frame),
        tags="bed sleep bedroom",
    )
    b = m.b
    levels = (0, 100) if kind == "BunkBed" else (22,) if kind == "HospitalBed" else (0,)
    for z in levels:
        b.box(frame, (w, 200, 14), (0, 0, z + 20))
        b.box("Linen", (w - 6, 194, 16), (0, 0, z + 34), bevel=3)
        b.box(cloth if kind != "StrawBed" else "Burlap", (w - 1, 136, 11), (0, 28, z + 44), bevel=3)
        for x in (-0.24, 0.24) if w > 120 else (0,):
            b.box("Linen", (w * 0.4 if w > 120 else 60, 40, 12), (x * w, -74, z + 50), bevel=4)
    high = {"BunkBed": 170, "CanopyBed": 210}.get(kind, 50)
    for x in (-1, 1):
        b.box(frame, (6, 6, high), (x * (w - 6) / 2, 97, 0))
        b.box(frame, (6, 6, max(high, 95)), (x * (w - 6) / 2, -97, 0))
    b.box(frame, (w, 4, 40), (0, -99, 44))
    b.box(frame, (w, 4, 22), (0, 99, 30))
    if kind == "CanopyBed":
        b.box(cloth, (w, 205, 8), (0, 0, 206))
        b.box(cloth, (w, 3, 40), (0, 101, 168), body=None)
    if kind == "BunkBed":
        for i in range(5):
            b.box(frame, (34, 3, 4), (w / 2 - 20, 102, 30 + 26 * i), body=None)
    if kind == "HospitalBed":
        for x in (-1, 1):
            b.box("SilverPaint", (3, 120, 4), (x * w / 2, 10, 90), body=None)
            b.box("SilverPaint", (3, 120, 4), (x * w / 2, 10, 76), body=None)
