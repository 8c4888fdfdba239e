"""Waterfronts."""

from __future__ import annotations

from collections.abc import Sequence

from cases.open190.layout import Assets, StagedPlace


def waterfront(
    p: StagedPlace,
    x0: float,
    x1: float,
    y: float,
    *,
    deep: float = 3000.0,
    boats: Sequence[str],
    jetties: int = 3,
    gear: Assets = (),
    wood: str = "Planks",
    far: Assets = (),
) -> None:
    """Water to +Y of a shore line, with jetties and boats moored along them."""
    p.ground((x0, y, x1, y + deep), family="water")
    deck_piece = p.one("jetty", length=900.0, wide=260.0, high=60.0, wood=wood)
    for k in range(jetties):
        jx = x0 + (k + 0.5) * (x1 - x0) / jetties
        for part in range(2):
            deck = p.put(deck_piece, jx, y + 330 + 902 * part, yaw=90)
            if gear:
                p.on(deck, gear, 4)
        for side in (-1, 1):
            reach = 170.0
            for part in range(3):
                name = p.choose(boats)
                thing = p.thing(name)
                item = p.put(name, jx + side * (reach + thing.depth / 2), y + 250 + 780 * part, yaw=90 + p.uni(-4, 4))
                p.relate("along", item, None)
    if far:
        for _ in range(6):
            p.put(
                far, p.uni(x0 + 700, x1 - 700), p.uni(y + deep * 0.7, y + deep - 700), yaw=p.uni(-180, 180), margin=100
            )
