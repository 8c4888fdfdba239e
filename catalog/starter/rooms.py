"""Walls, floors, doors and windows, shared by the indoor packs. Wall modules are 12 cm thick and 270 cm high; their
pivot is the middle of the bottom, their length runs along X."""

from __future__ import annotations

from catalog.shapes import Builder, Kit

THICK, HIGH = 12.0, 270.0


def wall(b: Builder, material: str, length: float, height: float = HIGH) -> None:
    """A plain wall with skirting on both faces."""
    b.box(material, (length, THICK, height))
    for side in (-1, 1):
        b.box("SkirtingWhite", (length, 1.2, 8), (0, side * (THICK / 2 + 0.6), 0), body=None)


def opening(b: Builder, material: str, length: float, low: float, width: float, height: float) -> None:
    """A wall with a rectangular opening in its middle: ``low`` is the sill (0 for a door)."""
    side = (length - width) / 2
    for sx in (-1, 1):
        with b.moved((sx * (length - side) / 2, 0, 0)):
            wall(b, material, side)
    b.box(material, (width, THICK, HIGH - low - height), (0, 0, low + height))
    if low > 0:
        b.box(material, (width, THICK, low))
        for face in (-1, 1):
            b.box("SkirtingWhite", (width, 1.2, 8), (0, face * (THICK / 2 + 0.6), 0), body=None)


def frame(
    b: Builder,
    material: str,
    width: float,
    height: float,
    low: float,
    *,
    bar: float = 6.0,
    depth: float = THICK + 3,
    sill: bool = True,
) -> None:
    """A frame inside an opening."""
    for sx in (-1, 1):
        b.box(material, (bar, depth, height), (sx * (width - bar) / 2, 0, low), body=None)
    b.box(material, (width - 2 * bar, depth, bar), (0, 0, low + height - bar), body=None)
    if sill:
        b.box(material, (width - 2 * bar, depth, bar), (0, 0, low), body=None)


def window(b: Builder, material: str, length: float, width: float, height: float, low: float) -> None:
    """A wall with a glazed window of two wings."""
    opening(b, material, length, low, width, height)
    frame(b, "SkirtingWhite", width, height, low)
    b.box("SkirtingWhite", (6, 6, height - 12), (0, 0, low + 6), body=None)
    b.box("Glass", (width - 12, 1.5, height - 12), (0, 0, low + 6))
    b.box("SkirtingWhite", (width + 10, 10, 3), (0, THICK / 2 + 3, low - 3), bevel=0.5, body=None)


def door_leaf(b: Builder, material: str, handle: str, width: float = 88.0, height: float = 203.0) -> None:
    """A door with two panels and handles on both faces; hinges at -X."""
    b.box(material, (width, 4, height))
    for face in (-1, 1):
        for low, high in ((14, 88), (100, 190)):
            b.box(material, (width - 26, 1.2, high - low), (0, face * 2.4, low), bevel=0.5, body=None)
        b.cylinder(handle, 2.4, 2, (width / 2 - 8, face * 2, 103), (0, 0, 90 * face), segments=12, body=None)
        b.box(handle, (13, 1.6, 1.8), (width / 2 - 13, face * 4.8, 102), bevel=0.4, body=None)


def tile(b: Builder, material: str, side: float = 200.0, thick: float = 2.0) -> None:
    """A square floor tile, top at ``thick``."""
    b.box(material, (side, side, thick))


def shell(kit: Kit, wall_material: str, prefix: str) -> None:
    """The wall modules of a pack."""

    @kit.asset(f"{prefix}Wall300", "architecture", "Plain wall module, 3 m long, with skirting.", "wall module")
    def _wall300(b: Builder) -> None:
        wall(b, wall_material, 300)

    @kit.asset(f"{prefix}Wall100", "architecture", "Plain wall module, 1 m long, with skirting.", "wall module short")
    def _wall100(b: Builder) -> None:
        wall(b, wall_material, 100)

    @kit.asset(
        f"{prefix}WallWindow300",
        "architecture",
        "Wall module with a large two-wing window, 3 m long.",
        "wall window module glass",
    )
    def _window(b: Builder) -> None:
        window(b, wall_material, 300, 200, 140, 90)

    @kit.asset(
        f"{prefix}WallDoorway200",
        "architecture",
        "Wall module with a framed doorway (90 cm clear), 2 m long.",
        "wall door opening module",
    )
    def _doorway(b: Builder) -> None:
        opening(b, wall_material, 200, 0, 104, 212)
        frame(b, "SkirtingWhite", 104, 212, 0, bar=7, sill=False)
