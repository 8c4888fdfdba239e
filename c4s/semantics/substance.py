"""Which of the placed things count: those of a believable size, in a place of their own, that something holds up.

A judge that counts whatever is placed can be had with heaps, dust and ghosts. So what is none of a scene is set aside,
with its reason, before anything is counted or related:

================== ==================================================================================================
``out_of_size``    less than 0.3 or more than 3.3 times its catalog's size (the geometric mean of its scale); what is
                   flat, such as a tile, may be as large as it likes
``no_collision``   its collision is switched off although its asset has one, and it stands within another thing or
                   in the air
``at_one_place``   another of its kind fills at least 0.8 of the box that both need
``swallowed``      at least two other things of like size hold more than half of it each; what one actor shows of
                   one asset, such as instances, is one here
``unconnected``    no chain of touching things (30 cm) leads from it to the ground (the world's plane, a landscape, a
                   floor under half of the scene): it hangs free, or lies under the ground. Lamps and what else
                   may hang or fly by nature count
================== ==================================================================================================

All is measured on world boxes, in a time nearly proportional to the number of things.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Final, Literal, get_args

import numpy as np

from c4s.protocol.words import word_set
from c4s.semantics.boxes import Boxes, Flags, Rows, holds_to_any
from c4s.semantics.inventory import Array, Box, Thing

Reason = Literal["out_of_size", "no_collision", "at_one_place", "swallowed", "unconnected"]
REASONS: Final[tuple[Reason, ...]] = get_args(Reason)
LEAST_SCALE, MOST_SCALE = 0.3, 3.3
FLAT_SHARE = 0.06
"""A thing is flat when its smallest side is at most this share of its next."""
SAME_PLACE = 0.8
SWALLOWED = 0.5
LIKE_SIZE = 8.0
"""A thing is swallowed by what has up to 8 times its volume; what is much larger is a room or a yard."""
TOUCH_CM = 30.0
ROUNDS = 200
"""Links of the longest chain that is followed from the ground."""
HUNG = word_set("""
    lamp light chandelier lantern pendant fan banner flag pennant sign bunting garland curtain cloud bird gull
    balloon kite airship plane moon sun star""")
"""What may hang or fly where nothing is seen to hold it, by the nouns of its asset's name."""
LEVEL_CM = 50.0
"""What starts this close to the ground's level stands on it."""
FLOOR_SHARE = 0.5
HOLDERS = 2
"""A thing is swallowed by this many others at least: a pedestal under a desk, or a door in its wall, is in one."""


@dataclass(frozen=True)
class Substance:
    """Things that count, in their order, and the others by why they do not."""

    counted: list[Thing]
    aside: Mapping[Reason, list[Thing]] = field(default_factory=dict)

    @property
    def share(self) -> float:
        """Share of the placed things that count; 0 in an empty scene."""
        left_out = sum(map(len, self.aside.values()))
        return len(self.counted) / (len(self.counted) + left_out) if self.counted else 0.0


def substance(things: Sequence[Thing], ground: Sequence[Box] = ()) -> Substance:
    """Set aside what does not count, reason by reason in the order of the table.

    Args:
        things: what is placed.
        ground: boxes (low, high) of landscapes, cm. The world's plane at height 0 is ground always.
    """
    aside: dict[Reason, list[Thing]] = {}
    left = list(things)
    connected = dict(zip(map(id, left), _connected(left, ground), strict=True))
    crowded = dict(zip(map(id, left), _swallowed(left), strict=True))
    for reason in REASONS:
        match reason:
            case "out_of_size":
                out = [_out_of_size(thing) for thing in left]
            case "no_collision":
                out = [thing.collision is False and (crowded[id(thing)] or not connected[id(thing)]) for thing in left]
            case "at_one_place":
                out = _repeated(left).tolist()
            case "swallowed":
                out = _swallowed(left).tolist()
            case "unconnected":
                hung = np.array([bool(HUNG & set(thing.kind.noun)) for thing in left], dtype=bool)
                out = (~_connected(left, ground) & ~hung).tolist()
        if any(out):
            aside[reason] = [thing for thing, odd in zip(left, out, strict=True) if odd]
            left = [thing for thing, odd in zip(left, out, strict=True) if not odd]
    return Substance(left, aside)


def _true_sides(thing: Thing) -> Sequence[float]:
    """Sides (m) of the thing's asset as the catalog has it, in rising order; empty where it does not say."""
    sides = (thing.kind.facts or {}).get("size_m") or ()
    return sorted(map(float, sides)) if len(sides) == 3 else ()


def _is_flat(thing: Thing) -> bool:
    sides = _true_sides(thing)
    return bool(sides) and sides[0] <= FLAT_SHARE * sides[1]


def _out_of_size(thing: Thing) -> bool:
    if not _true_sides(thing):
        return False
    scale = float(np.cbrt(np.abs(np.prod(thing.scale))))
    return scale < LEAST_SCALE or (scale > MOST_SCALE and not _is_flat(thing))


def _repeated(things: Sequence[Thing]) -> Flags:
    """Whether an earlier thing of the same kind stands at the same place; the first one counts."""
    repeated = np.zeros(len(things), dtype=bool)
    for rows in _by_kind(things):
        alike = [things[row] for row in rows]
        found = holds_to_any(alike, alike, _same_place)
        kept: list[Thing] = []
        for row, doubtful in zip(rows, found.tolist(), strict=True):
            if doubtful and kept and holds_to_any([things[row]], kept, _same_place)[0]:
                repeated[row] = True
            elif doubtful:
                kept.append(things[row])
    return repeated


def _by_kind(things: Sequence[Thing]) -> Iterable[list[int]]:
    rows: dict[int, list[int]] = {}
    for row, thing in enumerate(things):
        rows.setdefault(id(thing.kind), []).append(row)
    return rows.values()


def _overlap(subject: Boxes, least: Boxes, most: Boxes) -> Array:
    """Volume (cm³) that two boxes share, at most."""
    low, high = np.maximum(least.low, subject.low), np.minimum(most.high, subject.high)
    return np.asarray(np.prod(np.maximum(high - low, 0.0), axis=1))


def _same_place(subject: Boxes, least: Boxes, most: Boxes) -> Flags:
    """Whether two boxes fill most of the box around both, side by side."""
    both = np.maximum(_joint_sides(subject, least, most), 1e-9)
    common = np.maximum(np.minimum(most.high, subject.high) - np.maximum(least.low, subject.low), 0.0)
    thin = both < 1.0
    share = np.where(thin, 1.0, common / both)
    return np.asarray(np.prod(share, axis=1) >= SAME_PLACE)


def _joint_sides(subject: Boxes, least: Boxes, most: Boxes) -> Array:
    """Sides (cm) of the box around both, at least."""
    return np.asarray(np.maximum(least.high, subject.high) - np.minimum(most.low, subject.low))


def _is_swallowed(subject: Boxes, least: Boxes, most: Boxes) -> Flags:
    """Whether a box of another owner, of like size, holds most of the subject's."""
    return np.asarray(
        (most.volume >= subject.volume)
        & (least.volume <= LIKE_SIZE * subject.volume)
        & ((least.owner < subject.owner) | (most.owner > subject.owner))
        & (_overlap(subject, least, most) > SWALLOWED * subject.volume)
    )


def _swallowed(things: Sequence[Thing]) -> Flags:
    """Whether at least two others of like size hold most of each thing."""
    found = holds_to_any(things, things, _is_swallowed)
    boxes = Boxes.of(things)
    for row in np.flatnonzero(found).tolist():
        one = Boxes(np.broadcast_to(boxes.table[row], boxes.table.shape))
        holders = boxes.owner[_is_swallowed(one, boxes, boxes)]
        found[row] = len(np.unique(holders)) >= HOLDERS
    return found


def _touches(subject: Boxes, least: Boxes, most: Boxes) -> Flags:
    gaps = np.maximum(np.maximum(least.low - subject.high, subject.low - most.high), 0.0)
    return np.asarray((gaps <= TOUCH_CM).all(axis=1))


def _connected(things: Sequence[Thing], ground: Sequence[Box]) -> Flags:
    """Whether a chain of touching things leads from each thing to the ground."""
    if not things:
        return np.zeros(0, dtype=bool)
    bears = np.array([thing.collision is not False for thing in things])
    found = _grounded(things, ground, bears)
    reached = np.flatnonzero(found & bears)
    for _ in range(ROUNDS):
        open_ = np.flatnonzero(~found)
        if not len(reached) or not len(open_):
            break
        near = holds_to_any(_some(things, open_), _some(things, reached), _touches)
        found[open_[near]] = True
        reached = open_[near & bears[open_]]
    return found


def _some(things: Sequence[Thing], rows: Rows) -> list[Thing]:
    return [things[row] for row in rows.tolist()]


def _grounded(things: Sequence[Thing], ground: Sequence[Box], bears: Flags) -> Flags:
    """Whether each thing stands on the ground: the world's plane, a landscape, or a floor of its own height."""
    low, high = (np.array([getattr(thing, side) for thing in things]) for side in ("low", "high"))
    found = np.zeros(len(things), dtype=bool)
    for least, most in [(0.0, 0.0), *((box[0][2], box[1][2]) for box in ground)]:
        found |= (low[:, 2] <= most + LEVEL_CM) & (low[:, 2] >= least - LEVEL_CM)
        found |= (low[:, 2] <= least) & (high[:, 2] >= most)
    floor = _floor(low, high, bears)
    if floor is not None:
        found |= np.abs(low[:, 2] - floor) <= LEVEL_CM
    return found


def is_flat_lying(thing: Thing) -> bool:
    """Whether a thing lies flat: a tile, a rug, a slab."""
    size = thing.high - thing.low
    return bool(size[2] <= FLAT_SHARE * min(size[0], size[1]))


def _floor(low: Array, high: Array, bears: Flags) -> float | None:
    """Height (cm) of a floor: of flat things that together cover half of the plan of all things, or more."""
    size = high - low
    flat = bears & (size[:, 2] <= FLAT_SHARE * size[:, :2].min(axis=1))
    if not flat.any():
        return None
    heights, areas = high[flat, 2], size[flat, :2].prod(axis=1)
    order = np.argsort(heights)
    heights, areas = heights[order], areas[order]
    sums = np.concatenate([[0.0], np.cumsum(areas)])
    covered = sums[np.searchsorted(heights, heights + LEVEL_CM, side="right")] - sums[:-1]
    most = int(np.argmax(covered))
    span = high[:, :2].max(axis=0) - low[:, :2].min(axis=0)
    return float(heights[most]) if covered[most] >= FLOOR_SHARE * span.prod() else None
