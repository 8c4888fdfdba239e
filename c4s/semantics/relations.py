"""Relations of things to things, by their world boxes. All lengths in cm; plan means x and y.

Each relation says of every subject whether it stands in it to the references (to any of them, itself aside), with as
much room as is given: with ``STRICT`` it surely does, and what does not even with ``LOOSE`` surely does not. What lies
between has to be seen. The thresholds are written in ``docs/rule-judge.md``.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from typing import Final, TypeAlias

import numpy as np
from numpy.typing import NDArray

from c4s.semantics.between import between_any
from c4s.semantics.boxes import Boxes, Flags, holds_to_any
from c4s.semantics.distributions import NEAR_CM, ROW_SHARE, plan_centres, row_share
from c4s.semantics.hull import in_ring, in_ring_of_others
from c4s.semantics.inventory import Array, Thing

Test: TypeAlias = Callable[[Sequence[Thing], Sequence[Thing], float], Flags]
"""Of subjects, references and room."""

STRICT, LOOSE = 1.0, 3.0
CONTACT_CM = 10.0
ASIDE_CM = 25.0
"""How far beside a reference its plan still counts, for each further unit of room."""
AROUND_CM = 100.0
"""How far beside a box it still holds what is inside, for each further unit of room."""
SUNK_SHARE = 0.4
"""How deep what stands on something flat may be sunk into it (a boat in water)."""
STRIP_SHARE = 0.5
"""How much less things of a strip spread across it than along it."""
SLIM_SHARE = 0.2
"""A reference is flat, or a wall, when it is this much thinner than the subject or than it is high."""


def _over(subject: Boxes, least: Boxes, most: Boxes, room: float) -> Flags:
    aside = (room - 1) * ASIDE_CM
    centre = subject.centre[:, :2]
    return np.asarray(np.all((centre >= least.low[:, :2] - aside) & (centre <= most.high[:, :2] + aside), axis=1))


def _is_on(subject: Boxes, least: Boxes, most: Boxes, room: float) -> Flags:
    contact = CONTACT_CM * room
    sunk = np.where(least.height <= SLIM_SHARE * subject.height, SUNK_SHARE * subject.height, 0.0)
    deepest = np.maximum(0.5 * most.height, sunk) + contact
    stands = (
        _over(subject, least, most, room)
        & (subject.low[:, 2] - least.high[:, 2] >= -deepest)
        & (subject.low[:, 2] - most.high[:, 2] <= contact)
        & (subject.high[:, 2] > least.high[:, 2])
    )
    return np.asarray(stands | _hangs_on(subject, least, most, room))


def _hangs_on(subject: Boxes, least: Boxes, most: Boxes, room: float) -> Flags:
    """Touches a wall that is higher than it; with room, any side of anything, clear of its foot."""
    wall = (least.thickness <= SLIM_SHARE * most.height) & (subject.height <= most.height)
    if room > STRICT:
        wall |= subject.low[:, 2] >= least.low[:, 2] + CONTACT_CM * room
    return np.asarray(wall & (np.linalg.norm(_gaps(subject, least, most), axis=1) <= CONTACT_CM * room))


def _overlaps_in_plan(subject: Boxes, least: Boxes, most: Boxes, room: float) -> Flags:
    aside = (room - 1) * ASIDE_CM
    return np.asarray(
        np.all(
            (least.low[:, :2] - aside <= subject.high[:, :2]) & (subject.low[:, :2] <= most.high[:, :2] + aside), axis=1
        )
    )


def _is_above(subject: Boxes, least: Boxes, most: Boxes, room: float) -> Flags:
    rises = subject.high[:, 2] if room > STRICT else subject.low[:, 2] + CONTACT_CM
    return np.asarray(_overlaps_in_plan(subject, least, most, room) & (rises >= least.high[:, 2]))


def _is_below(subject: Boxes, least: Boxes, most: Boxes, room: float) -> Flags:
    return (
        _overlaps_in_plan(subject, least, most, room)
        & ((subject.low[:, 2] < most.low[:, 2] + CONTACT_CM) | (room > STRICT))
        & (subject.centre[:, 2] < most.high[:, 2])
    )


def _is_across(subject: Boxes, least: Boxes, most: Boxes, room: float) -> Flags:
    met = _overlaps_in_plan(subject, least, most, room)
    if room > STRICT:
        return np.asarray(met & (subject.high[:, 2] >= least.high[:, 2] - CONTACT_CM))
    low = subject.low[:, :2] <= most.low[:, :2] + CONTACT_CM
    high = subject.high[:, :2] >= least.high[:, :2] - CONTACT_CM
    return np.asarray(met & (subject.high[:, 2] > least.high[:, 2]) & (low & high).any(axis=1))


def _is_in_box(subject: Boxes, least: Boxes, most: Boxes, room: float) -> Flags:
    aside = (room - 1) * AROUND_CM
    centre = subject.centre
    return np.asarray(np.all((centre >= least.low - aside) & (centre <= most.high + aside), axis=1))


def _goes_into(subject: Boxes, least: Boxes, most: Boxes) -> Flags:
    """Whether a reference is large enough to hold the subject, wherever they stand; nothing goes into a tile."""
    broad = (subject.thickness <= most.thickness) & (subject.plan_size <= most.plan_size)
    return np.asarray(broad & (most.height > SLIM_SHARE * subject.height))


def _gaps(subject: Boxes, least: Boxes, most: Boxes) -> Array:
    """Distances along each axis (cm), 0 where the boxes overlap."""
    return np.maximum(np.maximum(least.low - subject.high, subject.low - most.high), 0.0)


def _is_near(subject: Boxes, least: Boxes, most: Boxes, room: float) -> Flags:
    gaps = _gaps(subject, least, most)
    limit = room * np.maximum(NEAR_CM, 0.5 * np.maximum(subject.plan_size, most.plan_size))
    return np.asarray(np.hypot(gaps[:, 0], gaps[:, 1]) <= limit)


def _is_against(subject: Boxes, least: Boxes, most: Boxes, room: float) -> Flags:
    return np.asarray(np.linalg.norm(_gaps(subject, least, most), axis=1) <= 3 * CONTACT_CM * room)


def _carries(reference: Boxes, least: Boxes, most: Boxes, room: float) -> Flags:
    """Whether a subject within these bounds may stand on the reference, as ``_is_on`` has it, walls aside."""
    contact, aside = CONTACT_CM * room, (room - 1) * ASIDE_CM
    sunk = np.where(reference.height <= SLIM_SHARE * most.height, SUNK_SHARE * most.height, 0.0)
    deepest = np.maximum(0.5 * reference.height, sunk) + contact
    low, high = least.centre[:, :2], most.centre[:, :2]
    return np.asarray(
        np.all((high >= reference.low[:, :2] - aside) & (low <= reference.high[:, :2] + aside), axis=1)
        & (most.low[:, 2] - reference.high[:, 2] >= -deepest)
        & (least.low[:, 2] - reference.high[:, 2] <= contact)
        & (most.high[:, 2] > reference.high[:, 2])
    )


def on(subjects: Sequence[Thing], references: Sequence[Thing], room: float = STRICT) -> Flags:
    """Its bottom is at a reference's top (10 cm, or inside the upper half, or sunk into something flat) and its centre
    is over it; or it touches a wall that is higher than it, with room the side of anything above its foot."""
    return holds_to_any(subjects, references, partial(_is_on, room=room))


def above(subjects: Sequence[Thing], references: Sequence[Thing], room: float = STRICT) -> Flags:
    """Its bottom is at least at a reference's top (10 cm slack) and their plans overlap; with room, its top is, as that
    of a bridge or a parasol which stands beside or in what it spans."""
    return holds_to_any(subjects, references, partial(_is_above, room=room))


def below(subjects: Sequence[Thing], references: Sequence[Thing], room: float = STRICT) -> Flags:
    """Its centre is under a reference's top, it reaches the reference's plan, and it starts lower (10 cm); with room,
    anywhere under that top."""
    return holds_to_any(subjects, references, partial(_is_below, room=room))


def across(subjects: Sequence[Thing], references: Sequence[Thing], room: float = STRICT) -> Flags:
    """It reaches from one side of a reference's plan to the other (10 cm) and rises above it; with room, it
    reaches it."""
    return holds_to_any(subjects, references, partial(_is_across, room=room))


def inside(subjects: Sequence[Thing], references: Sequence[Thing], room: float = STRICT) -> Flags:
    """Its centre lies in a reference's box, or in plan within the ring that at least three references form. What would
    go into one of them (a flower and pots) is not surely in their ring."""
    places = plan_centres(references)
    ringed = in_ring(plan_centres(subjects), places) if len(places) >= 3 else np.zeros(len(subjects), dtype=bool)
    among = _numbers(subjects, references)
    if (among >= 0).any():
        others = in_ring_of_others(places) if len(places) > 3 else np.zeros(len(places), dtype=bool)
        ringed[among >= 0] = others[among[among >= 0]]
    if room <= STRICT:
        ringed &= ~holds_to_any(subjects, references, _goes_into)
    return ringed | holds_to_any(subjects, references, partial(_is_in_box, room=room))


def near(subjects: Sequence[Thing], references: Sequence[Thing], room: float = STRICT) -> Flags:
    """Within 3 m of a reference, or within half the larger one's size."""
    return holds_to_any(subjects, references, partial(_is_near, room=room))


def against(subjects: Sequence[Thing], references: Sequence[Thing], room: float = STRICT) -> Flags:
    """Its box is within 30 cm of a reference's box."""
    return holds_to_any(subjects, references, partial(_is_against, room=room))


def apart(subjects: Sequence[Thing], references: Sequence[Thing], room: float = STRICT) -> Flags:
    """Further than near from every reference; with room, not against any."""
    return ~(near(subjects, references) if room <= STRICT else against(subjects, references))


def along(subjects: Sequence[Thing], references: Sequence[Thing], room: float = STRICT) -> Flags:
    """Beside (within near of) a reference that is at least twice as long as wide, or a row of three and more, or a
    strip of flat ones; with room, beside any reference."""
    if room > STRICT:
        return near(subjects, references, room)
    sides = np.array([np.sort((other.high - other.low)[:2]) for other in references]).reshape(-1, 2)
    long = [other for other, (short, longer) in zip(references, sides, strict=True) if longer >= 2 * short]
    found = near(subjects, long)
    places, bent = plan_centres(references), ~_flat(references)
    rowed = np.full(len(subjects), _is_row(places, ROW_SHARE) or (not bent.any() and _is_row(places, STRIP_SHARE)))
    among = _numbers(subjects, references)
    if (among >= 0).any():
        strip = (bent.sum() - bent == 0) & _row_of_others(places, STRIP_SHARE)
        rowed[among >= 0] = (_row_of_others(places, ROW_SHARE) | strip)[among[among >= 0]]
    return found | rowed & near(subjects, references)


def _flat(things: Sequence[Thing]) -> Flags:
    """Whether each thing is flat, as the tiles of a road or a promenade are."""
    size = np.array([thing.high - thing.low for thing in things]).reshape(-1, 3)
    return np.asarray(size[:, 2] <= SLIM_SHARE * size[:, :2].min(axis=1))


def _is_row(points: Array, share: float) -> bool:
    return len(points) >= 3 and row_share(points) <= share


def between(subjects: Sequence[Thing], references: Sequence[Thing], room: float = STRICT) -> Flags:
    """Its plan centre, or the middle of a side of its plan, is near the middle part of a line between two references (a
    quarter of its length aside); with room, it is near a reference. Of a reference only the centre is asked."""
    if room > STRICT:
        return near(subjects, references, room)
    places = plan_centres(references)
    found = between_any(plan_centres(subjects), places)
    half = np.array([(thing.high - thing.low)[:2] / 2 for thing in subjects]).reshape(-1, 2)
    half[_numbers(subjects, references) >= 0] = 0.0
    for side in ((1, 0), (-1, 0), (0, 1), (0, -1)):
        found |= between_any(plan_centres(subjects) + half * side, places)
    return found


def _numbers(subjects: Sequence[Thing], references: Sequence[Thing]) -> NDArray[np.int64]:
    """Each subject's own place among the references, -1 where it is none."""
    place = {id(thing): number for number, thing in enumerate(references)}
    return np.array([place.get(id(thing), -1) for thing in subjects], dtype=np.int64)


def _row_of_others(points: Array, share: float) -> Flags:
    """Whether the other points (at least three) lie on a line, for each of the points; by moments less one point."""
    n = len(points)
    if n < 4:
        return np.zeros(n, dtype=bool)
    offsets = points - points.mean(axis=0)
    full = offsets.T @ offsets
    rest = full - n / (n - 1) * offsets[:, :, None] * offsets[:, None, :]
    half_sum, half_gap = (rest[:, 0, 0] + rest[:, 1, 1]) / 2, (rest[:, 0, 0] - rest[:, 1, 1]) / 2
    bend = np.hypot(half_gap, rest[:, 0, 1])
    across, along_ = np.maximum(half_sum - bend, 0.0), half_sum + bend
    held = np.where(along_ > 0, across <= share**2 * along_, False)
    for lone in np.flatnonzero(2 * half_sum < 1e-6 * np.trace(full)):
        held[lone] = row_share(np.delete(points, lone, axis=0)) <= share
    return held


RELATIONS: Final[dict[str, Test]] = {
    "on": on,
    "above": above,
    "below": below,
    "across": across,
    "inside": inside,
    "near": near,
    "against": against,
    "apart": apart,
    "along": along,
    "between": between,
}

_TAKEN = {"on": _carries, "near": _is_near, "against": _is_against}


def taken(relation: str, subjects: Sequence[Thing], references: Sequence[Thing]) -> Flags | None:
    """Whether each reference has a subject in the relation to it; None for a relation of which nobody asks that."""
    holds = _TAKEN.get(relation)
    return None if holds is None else holds_to_any(references, subjects, partial(holds, room=STRICT))
