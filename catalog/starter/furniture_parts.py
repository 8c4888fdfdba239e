"""Parts that many pieces of furniture share."""

from __future__ import annotations

import math

from catalog.shapes import Builder
from catalog.shapes.patches import Point3

BOOKS = ("BookRed", "BookBlue", "BookGreen", "BookOchre", "Paper")


def legs(
    b: Builder, material: str, span: tuple[float, float], height: float, thick: float = 4.0, *, round_: bool = False
) -> None:
    """Four legs at the corners of ``span`` (outer width and depth)."""
    for sx in (-1, 1):
        for sy in (-1, 1):
            at = (sx * (span[0] - thick) / 2, sy * (span[1] - thick) / 2, 0.0)
            if round_:
                b.cylinder(material, thick / 2 * 0.7, height, at, top=thick / 2, segments=10, body="box")
            else:
                b.box(material, (thick, thick, height), at)


def fronts(
    b: Builder,
    material: str,
    handle: str,
    width: float,
    face_y: float,
    bottom: float,
    height: float,
    rows: int,
    columns: int = 1,
    *,
    upright: bool = False,
) -> None:
    """Drawer or door fronts on the plane ``y = face_y`` with handles, without bodies of their own."""
    w, h = width / columns, height / rows
    for row in range(rows):
        for column in range(columns):
            x = (column + 0.5) * w - width / 2
            b.box(material, (w - 1.0, 1.6, h - 1.0), (x, face_y + 0.8, bottom + row * h + 0.5), bevel=0.3, body=None)
            if upright:
                side = (1 if column % 2 == 0 else -1) * (w / 2 - 4)
                b.box(
                    handle, (1.2, 2.0, min(18, h * 0.4)), (x + side, face_y + 2.6, bottom + (row + 0.45) * h), body=None
                )
            else:
                b.box(handle, (min(14, w * 0.4), 2.0, 1.2), (x, face_y + 2.6, bottom + (row + 0.72) * h), body=None)


def books(b: Builder, width: float, at: Point3, seed: int = 0, tall: float = 26.0) -> None:
    """A row of upright books from -width/2 to width/2, spines to +Y; one body for the row."""
    x, number = -width / 2, seed
    while x < width / 2 - 2:
        number += 1
        thick = min(2.2 + (number * 7 % 5) * 0.7, width / 2 - x)
        height = tall * (0.72 + (number * 5 % 7) * 0.045)
        depth = 15 + (number * 3 % 4) * 1.2
        b.box(
            BOOKS[number * 3 % len(BOOKS)],
            (thick - 0.15, depth, height),
            (at[0] + x + thick / 2, at[1] + depth / 2 - 9, at[2]),
            body=None,
        )
        x += thick
    b.body_box((width, 18, tall * 0.9), at)


def pot(b: Builder, material: str, radius: float, height: float) -> None:
    """A plant pot filled with soil, standing at the origin."""
    rim = [(radius, height), (radius * 0.88, height), (radius * 0.84, height * 0.9)]
    b.lathe(material, [(0, 0), (radius * 0.72, 0), *rim], smooth=False)
    b.cylinder("Soil", radius * 0.85, 1.0, (0, 0, height * 0.88), body=None)


def leaf(b: Builder, material: str, length: float, width: float, at: Point3, yaw: float, pitch: float) -> None:
    """A pointed leaf that grows from ``at`` in direction ``yaw`` and bends over."""
    with b.moved(at, (pitch, yaw, 0)):
        droop = length * 0.22
        points: list[Point3] = [
            (0, 0, 0),
            (length * 0.5, -width / 2, droop * 0.4),
            (length, 0, -droop * 0.5),
            (length * 0.5, width / 2, droop * 0.4),
        ]
        middle = (length * 0.52, 0.0, droop * 0.15)
        for p, q in zip(points, points[1:] + points[:1], strict=True):
            b.quad(material, [p, q, middle, middle], fit=False)


def crown(b: Builder, count: int, length: float, width: float, at: Point3, *, pitch: float = 35.0) -> None:
    """Leaves around a point, in a spiral."""
    for i in range(count):
        leaf(
            b,
            "Leaf" if i % 3 else "LeafLight",
            length * (0.75 + 0.25 * math.sin(i * 2.4) ** 2),
            width,
            at,
            i * 137.5,
            pitch + 28 * math.cos(i * 1.7),
        )


def knob_ring(b: Builder, material: str, radius: float, thick: float, at: Point3, *, segments: int = 20) -> None:
    """A ring in the XY plane."""
    b.tube(
        material,
        [
            (at[0] + radius * math.cos(a), at[1] + radius * math.sin(a), at[2])
            for a in [2 * math.pi * i / segments for i in range(segments + 1)]
        ],
        thick,
        segments=6,
    )


def lamp_shade(b: Builder, low: float, high: float, height: float, at: Point3) -> None:
    """An open cone shade with a bulb inside."""
    b.lathe("LampShade", [(low, 0), (high, height)], at, smooth=False)
    b.ellipsoid("Bulb", (6, 6, 8), (at[0], at[1], at[2] + height * 0.3), segments=10, body=None)
