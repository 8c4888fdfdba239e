"""Parts that many buildings share: windows, doors, roofs, battlements."""

from __future__ import annotations

from catalog.kits.maker import KitMaker
from catalog.shapes.patches import Point3

BUILDINGS = "buildings"
"""The category of all that has a facade."""


def window(m: KitMaker, width: float, height: float, at: Point3, yaw: float = 0.0) -> None:
    """A framed window that looks to +Y of its frame; ``at`` is the middle of its sill on the wall's face."""
    trim = m.mat("trim")
    with m.b.moved(at, (0, yaw, 0)):
        m.b.box(trim, (width + 14, 5, height + 14), (0, 1.5, -7), body=None)
        m.b.box(m.mat("window"), (width, 7, height), (0, 2.0, 0), body=None)
        m.b.box(trim, (4, 9, height), (0, 2.0, 0), body=None)
        m.b.box(trim, (width, 9, 4), (0, 2.0, height * 0.55), body=None)
        m.b.box(trim, (width + 22, 14, 5), (0, 5, -9), body=None)


def shutters(m: KitMaker, width: float, height: float, at: Point3, yaw: float = 0.0) -> None:
    """A pair of shutters beside a window."""
    with m.b.moved(at, (0, yaw, 0)):
        for side in (-1, 1):
            m.b.box(m.mat("door"), (width / 2, 4, height + 6), (side * (width * 0.75 + 8), 2, -3), body=None)


def door(m: KitMaker, width: float, height: float, at: Point3, yaw: float = 0.0) -> None:
    """A closed door with a frame and a step."""
    with m.b.moved(at, (0, yaw, 0)):
        m.b.box(m.mat("trim"), (width + 24, 8, height + 14), (0, 2, 0), body=None)
        m.b.box(m.mat("door"), (width, 11, height), (0, 2, 0), body=None)
        for z in (0.1, 0.52):
            m.b.box(m.mat("trim"), (width * 0.6, 2, height * 0.36), (0, 8, height * z + 8), body=None)
        m.b.ellipsoid("Brass", (6, 6, 6), (width * 0.38, 10, height * 0.48), segments=8, body=None)
        m.b.box(m.mat("stone"), (width + 40, 30, 10), (0, 15, 0), body=None)


def gable_roof(m: KitMaker, width: float, depth: float, z: float, rise: float, material: str) -> None:
    """A gable roof whose ridge runs along X, with eaves all around."""
    m.b.gable(material, (depth + 70, width + 60, rise), (0, 0, z), (0, 90, 0))
    m.b.box(m.mat("trim"), (width + 66, 10, 14), (0, depth / 2 + 32, z - 6), body=None)
    m.b.box(m.mat("trim"), (width + 66, 10, 14), (0, -depth / 2 - 32, z - 6), body=None)


def hip_roof(m: KitMaker, width: float, depth: float, z: float, rise: float, material: str) -> None:
    """A hipped roof: four slopes."""
    from catalog.shapes.patches import hull

    x, y, r = width / 2 + 35, depth / 2 + 35, max(0.0, (width - depth) / 2)
    m.b.add(
        material,
        hull([(sx * x, sy * y, 0.0) for sx in (-1, 1) for sy in (-1, 1)] + [(-r, 0.0, rise), (r + 1, 0.0, rise)]),
        (0, 0, z),
    )
    m.b.box(m.mat("trim"), (width + 60, depth + 60, 12), (0, 0, z - 10), body=None)


def flat_roof(m: KitMaker, width: float, depth: float, z: float) -> None:
    """A flat roof behind a parapet."""
    m.b.box("DarkConcrete", (width, depth, 12), (0, 0, z), body="box")
    for side in (-1, 1):
        m.b.box(m.mat("trim"), (width + 16, 16, 45), (0, side * depth / 2, z), body=None)
        m.b.box(m.mat("trim"), (16, depth + 16, 45), (side * width / 2, 0, z), body=None)


def chimney(m: KitMaker, at: Point3, height: float) -> None:
    """A chimney stack with pots."""
    m.b.box("RedBrick" if not m.style.old else m.mat("stone"), (60, 60, height), at, body=None)
    for x in (-14, 14):
        m.b.cylinder("Terracotta", 9, 30, (at[0] + x, at[1], at[2] + height), segments=8, body=None)


def battlements(m: KitMaker, material: str, width: float, depth: float, z: float, thick: float = 40.0) -> None:
    """Merlons along the edge of a rectangle."""
    for length, other, turn in ((width, depth, False), (depth, width, True)):
        count = max(2, int(length // 120))
        for side in (-1, 1):
            for i in range(count):
                along, across = (i - (count - 1) / 2) * length / count, side * (other - thick) / 2
                size: Point3 = (thick, 60, 70) if turn else (60, thick, 70)
                m.b.box(material, size, (across, along, z) if turn else (along, across, z), body=None)


def facade(
    m: KitMaker, width: float, depth: float, storeys: int, floor: float, *, base: float = 0.0, doors: bool = True
) -> None:
    """Rows of windows on all four faces, and a door in front."""
    w, h = m.pick(80.0, 95.0, 110.0), m.pick(120.0, 135.0, 150.0)
    shut = m.style.old and m.chance(0.5)
    for yaw, length, reach in ((0, width, depth), (180, width, depth), (90, depth, width), (-90, depth, width)):
        count = max(1, int(length // m.opt("bay", 230)))
        with m.b.moved((0, 0, 0), (0, yaw, 0)):
            for level in range(storeys):
                for i in range(count):
                    x = (i - (count - 1) / 2) * length / count
                    if doors and level == 0 and yaw == 0 and i == count // 2:
                        door(m, 105, 215, (x, reach / 2, base))
                        continue
                    at = (x, reach / 2, base + level * floor + 95)
                    window(m, w, h, at)
                    if shut and yaw == 0:
                        shutters(m, w, h, at)


def timbers(m: KitMaker, width: float, depth: float, storeys: int, floor: float) -> None:
    """Beams of a timber frame on all faces."""
    beam = m.mat("trim")
    for yaw, length, reach in ((0, width, depth), (180, width, depth), (90, depth, width), (-90, depth, width)):
        with m.b.moved((0, 0, 0), (0, yaw, 0)):
            for level in range(storeys + 1):
                m.b.box(
                    beam, (length + 8, 6, 20), (0, reach / 2 + 1, min(level * floor, storeys * floor - 20)), body=None
                )
            count = max(2, int(length // 180))
            for i in range(count + 1):
                x = (i / count - 0.5) * (length - 14)
                m.b.box(beam, (16, 6, storeys * floor), (x, reach / 2 + 1, 0), body=None)
