"""Rails with what runs on them."""

from __future__ import annotations

from collections.abc import Sequence

from cases.open190.layout import StagedPlace


def rails(
    p: StagedPlace,
    x0: float,
    x1: float,
    y: float,
    trains: Sequence[str] = (),
    *,
    start: float = 400.0,
    gap: float = 40.0,
) -> None:
    """A track along X with vehicles coupled on it."""
    piece = p.one("track", length=1000.0)
    count = round((x1 - x0) / 1000)
    for i in range(count):
        p.put(piece, x0 + (i + 0.5) * (x1 - x0) / count, y, 0.8, scale=(round((x1 - x0) / count / 1000, 4), 1.0, 1.0))
    x = x0 + start
    for name in trains:
        thing = p.thing(name)
        if x + thing.width > x1:
            break
        p.relate("in_row", p.put(name, x + thing.width / 2, y, 4.8 if not p.tops_only else 4.6))
        x += thing.width + gap
