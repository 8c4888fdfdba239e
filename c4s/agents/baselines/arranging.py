"""Where blocks go to each other: near those that they are said to be near, else to the nearest free spot."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence

from c4s.agents.baselines.blocks import Block, grouped, joined, settle
from c4s.agents.baselines.reading import Link, Mention

FURTHER = (0.0, 1.0, 2.0, 4.0, 7.0, 11.0)
ASIDE = (0.0, 0.3, -0.3, 0.6, -0.6, 0.9, -0.9)
RINGS, RAYS = 70, 16

Places = Iterator[tuple[float, float]]


def arrange(blocks: Mapping[Mention, Block], links: Sequence[Link], gap: float, reach: float) -> Block:
    """Move the blocks to places where none overlaps another and join them.

    Copies that find no place together stand apart; what finds none at all is left out.
    """
    links = [link for link in links if link.thing in blocks and link.other in blocks]
    placed: dict[Mention, Block] = {}
    spots: list[tuple[Mention, Block]] = []
    pending = list(blocks)
    while pending:
        waiting = {link.thing for link in links if link.other in pending}
        named = next((one for one in pending if one not in waiting), pending[0])
        pending.remove(named)
        block = blocks[named]
        apart: list[Block] = []
        for part in [block, *(grouped(unit.pieces) for unit in block.units)]:
            taken = [other.grown(_gap(named, one, gap)).rect for one, other in spots]
            if any(settle(part, places, taken, reach) for places in _wishes(named, part, placed, links, gap)):
                spots.append((named, part))
                apart.append(part)
                if part is block:
                    break
        if apart:
            placed[named] = joined(apart)
    return joined(placed.values()).move_to(0.0, 0.0)


def _gap(one: Mention, other: Mention, gap: float) -> float:
    return 0.0 if one.is_strip and other.is_strip else gap


def _wishes(
    named: Mention, block: Block, placed: Mapping[Mention, Block], links: Sequence[Link], gap: float
) -> Iterator[Places]:
    if not placed:
        yield iter([(0.0, 0.0)])
    partners = [link.other for link in links if link.thing is named]
    partners += [link.thing for link in links if link.other is named]
    for partner in partners:
        if partner in placed:
            yield _near(block, placed[partner], _gap(named, partner, gap))
    yield _spiral(joined(placed.values()).centre, min(1.0, gap))
    yield _spiral((0.0, 0.0), min(1.0, gap))


def _near(block: Block, other: Block, gap: float) -> Places:
    x, y = other.centre
    over, across = (other.width + block.width) / 2, (other.depth + block.depth) / 2
    for extra in FURTHER:
        out = gap + extra + 0.01
        for share in ASIDE:
            yield x + share * over, y + across + out
            yield x + share * over, y - across - out
            yield x + over + out, y + share * across
            yield x - over - out, y + share * across


def _spiral(middle: tuple[float, float], step: float) -> Places:
    for ring in range(RINGS):
        radius = step * ring * (1 + ring / 20)
        for ray in range(RAYS if ring else 1):
            angle = 2 * math.pi * (ray + 0.5 * (ring % 2)) / RAYS
            yield middle[0] + radius * math.cos(angle), middle[1] + radius * math.sin(angle)
