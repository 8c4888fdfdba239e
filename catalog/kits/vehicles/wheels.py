"""The wheels of what drives on roads."""

from __future__ import annotations

from catalog.kits.maker import KitMaker


def tyres(m: KitMaker, wheels: tuple[float, ...], half: float, radius: float, thick: float = 20.0) -> None:
    """Pairs of wheels at places along X."""
    for x in wheels:
        m.b.body_box((radius, 2 * half, radius), (x, 0, 0))
        for side in (-1, 1):
            m.b.cylinder(
                "Rubber", radius, thick, (x, side * half - thick / 2, radius), (0, 0, 90), segments=16, body=None
            )
            m.b.cylinder(
                "SilverPaint",
                radius * 0.5,
                thick + 2,
                (x, side * half - thick / 2 - 1, radius),
                (0, 0, 90),
                segments=10,
                body=None,
            )
