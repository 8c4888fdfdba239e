"""The spatial relations of many things at once, against their definitions read one pair at a time.

Where a length that is no whole number meets its limit exactly, rounding decides; such scenes are not drawn.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from c4s.semantics.distributions import nearest
from c4s.semantics.inventory import Thing
from c4s.semantics.kinds import ThingKind
from c4s.semantics.relations import LOOSE, RELATIONS, STRICT, taken

KIND = ThingKind("/Game/P/SM_X.SM_X", None)
PLACE = st.integers(-12, 12).map(lambda n: n * 50)
HALF = st.sampled_from([5, 10, 25, 50, 150, 600])
BOX = st.tuples(st.tuples(PLACE, PLACE, st.integers(0, 6).map(lambda n: n * 25)), st.tuples(HALF, HALF, HALF))
SCENE = st.lists(BOX, min_size=1, max_size=14)


def thing(box: Any, actor: str = "a") -> Thing:
    centre, half = (np.array(part, dtype=float) for part in box)
    return Thing(actor, KIND, centre - half, centre + half, np.ones(3), ())


def gaps(a: Thing, b: Thing) -> list[float]:
    return [max(float(b.low[k] - a.high[k]), float(a.low[k] - b.high[k]), 0.0) for k in range(3)]


def near(a: Thing, b: Thing, room: float = STRICT) -> bool:
    size = max(float(t.high[k] - t.low[k]) for t in (a, b) for k in (0, 1))
    return math.hypot(*gaps(a, b)[:2]) <= room * max(300.0, size / 2)


def apart_by(a: Thing, b: Thing, most: float) -> bool:
    return math.hypot(*gaps(a, b)) <= most


def on(a: Thing, b: Thing, room: float) -> bool:
    mine, height = a.high[2] - a.low[2], b.high[2] - b.low[2]
    if min(b.high[k] - b.low[k] for k in (0, 1)) <= 0.2 * height and mine <= height and apart_by(a, b, 10 * room):
        return True
    if room > STRICT and a.low[2] >= b.low[2] + 10 * room and apart_by(a, b, 10 * room):
        return True
    step, side = a.low[2] - b.high[2], 25 * (room - 1)
    depth = max(height / 2, 0.4 * mine if height <= 0.2 * mine else 0.0) + 10 * room
    over = all(b.low[k] - side <= a.centre[k] <= b.high[k] + side for k in (0, 1))
    return bool(over and -depth <= step <= 10 * room and a.high[2] > b.high[2])


def in_box(a: Thing, b: Thing, room: float) -> bool:
    side = 100 * (room - 1)
    return all(b.low[k] - side <= a.centre[k] <= b.high[k] + side for k in range(3))


def meets(a: Thing, b: Thing, room: float) -> bool:
    return max(gaps(a, b)[:2]) <= 25 * (room - 1)


def above(a: Thing, b: Thing, room: float) -> bool:
    return meets(a, b, room) and bool(a.low[2] >= b.high[2] - 10 if room == STRICT else a.high[2] >= b.high[2])


def below(a: Thing, b: Thing, room: float) -> bool:
    lower = room > STRICT or a.low[2] < b.low[2] + 10
    return meets(a, b, room) and bool(lower and a.centre[2] < b.high[2])


def across(a: Thing, b: Thing, room: float) -> bool:
    if room > STRICT:
        return meets(a, b, room) and bool(a.high[2] >= b.high[2] - 10)
    spans = any(a.low[k] <= b.low[k] + 10 and a.high[k] >= b.high[k] - 10 for k in (0, 1))
    return meets(a, b, room) and bool(spans and a.high[2] > b.high[2])


def goes_into(a: Thing, b: Thing) -> bool:
    (thin, long), (thick, longer) = (sorted((t.high - t.low)[:2]) for t in (a, b))
    return bool(thin <= thick and long <= longer and b.high[2] - b.low[2] > 0.2 * (a.high[2] - a.low[2]))


def inside(a: Thing, others: Sequence[Thing], room: float) -> bool:
    ringed = room > STRICT or not any(goes_into(a, other) for other in others)
    return any(in_box(a, other, room) for other in others) or (ringed and in_ring(a, others))


def point(a: Thing) -> tuple[int, int]:
    return int(a.centre[0]), int(a.centre[1])


def cross(o: tuple[int, int], a: tuple[int, int], b: tuple[int, int]) -> int:
    return (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0])


def in_ring(a: Thing, others: Sequence[Thing]) -> bool:
    """In some triangle of the others' centres (Caratheodory), the others not all on one line."""
    p, places = point(a), [point(o) for o in others]
    triples = [t for t in itertools.combinations(places, 3) if cross(*t)]
    return any(
        len({cross(u, v, p) > 0 for u, v in ((x, y), (y, z), (z, x)) if cross(u, v, p)}) <= 1 for x, y, z in triples
    )


def lies_between(a: Thing, others: Sequence[Thing]) -> bool:
    x, y = point(a)
    half = [int(a.high[k] - a.low[k]) // 2 for k in (0, 1)]
    marks = [(x, y), (x + half[0], y), (x - half[0], y), (x, y + half[1]), (x, y - half[1])]
    return sum(marks_between(mark, others) for mark in marks) > 0


def marks_between(p: tuple[int, int], others: Sequence[Thing]) -> bool:
    for one, other in itertools.combinations([point(o) for o in others], 2):
        length2 = (other[0] - one[0]) ** 2 + (other[1] - one[1]) ** 2
        if length2:
            foot = (other[0] - one[0]) * (p[0] - one[0]) + (other[1] - one[1]) * (p[1] - one[1])
            share, aside2 = Fraction(foot, length2), Fraction(cross(one, other, p) ** 2, length2)
            assume(share not in (Fraction(1, 10), Fraction(9, 10)) and aside2 != Fraction(length2, 16))
            if Fraction(1, 10) <= share <= Fraction(9, 10) and aside2 <= Fraction(length2, 16):
                return True
    return False


def along(a: Thing, others: Sequence[Thing], room: float) -> bool:
    if room > STRICT:
        return any(near(a, other, room) for other in others)
    for other in others:
        short, longer = sorted(float(other.high[k] - other.low[k]) for k in (0, 1))
        if longer >= 2 * short and near(a, other):
            return True
    if len(others) < 3 or not any(near(a, other) for other in others):
        return False
    across, way = np.linalg.eigvalsh(np.cov(np.array([point(other) for other in others], dtype=float).T))
    assume(all(abs(across - share**2 * way) > 1e-9 * way for share in (0.15, 0.5)) or way <= 0)
    sizes = [other.high - other.low for other in others]
    strip = all(size[2] <= 0.2 * min(size[0], size[1]) for size in sizes) and across <= 0.25 * way
    return bool(way > 0 and (across <= 0.15**2 * way or strip))


Definition = Callable[[Thing, Sequence[Thing], float], bool]


def any_of(holds: Callable[[Thing, Thing, float], bool]) -> Definition:
    return lambda a, others, room: any(holds(a, other, room) for other in others)


def any_near(a: Thing, others: Sequence[Thing], room: float) -> bool:
    return any(near(a, other, room) for other in others)


DEFINITIONS: dict[str, Definition] = {
    "on": any_of(on),
    "above": any_of(above),
    "below": any_of(below),
    "across": any_of(across),
    "near": any_near,
    "against": any_of(lambda a, b, room: apart_by(a, b, 30 * room)),
    "apart": lambda a, others, room: (
        not any(near(a, other) if room == STRICT else apart_by(a, other, 30) for other in others)
    ),
    "inside": inside,
    "between": lambda a, others, room: lies_between(a, others) if room == STRICT else any_near(a, others, room),
    "along": along,
}


@pytest.mark.parametrize("room", [STRICT, LOOSE])
@pytest.mark.parametrize("name", sorted(RELATIONS))
@given(boxes=SCENE, data=st.data())
def test_a_relation_of_many_is_its_definition_of_each(
    name: str, room: float, boxes: list[Any], data: st.DataObject
) -> None:
    things = [thing(box, f"a{number}") for number, box in enumerate(boxes)]
    references = data.draw(st.lists(st.sampled_from(things), min_size=1, unique_by=id))
    own = name != "between" and data.draw(st.booleans())
    subjects = things if own else [t for t in things if t not in references]
    found = RELATIONS[name](subjects, references, room).tolist()
    assert found == [DEFINITIONS[name](t, [r for r in references if r is not t], room) for t in subjects]


@pytest.mark.parametrize("name", ["on", "near", "against"])
@given(boxes=SCENE, data=st.data())
def test_a_reference_is_taken_when_a_subject_stands_in_the_relation_to_it(
    name: str, boxes: list[Any], data: st.DataObject
) -> None:
    things = [thing(box, f"a{number}") for number, box in enumerate(boxes)]
    references = data.draw(st.lists(st.sampled_from(things), min_size=1, unique_by=id))
    subjects = [t for t in things if t not in references]
    found = taken(name, subjects, references)
    assert found is not None
    walls = name == "on" and any(min(r.high[:2] - r.low[:2]) <= 0.2 * (r.high[2] - r.low[2]) for r in references)
    if not walls:
        assert found.tolist() == [any(DEFINITIONS[name](t, [r], STRICT) for t in subjects) for r in references]


@given(st.lists(st.tuples(PLACE, PLACE), min_size=2, max_size=20))
def test_the_nearest_is_the_nearest_of_all(places: list[tuple[int, int]]) -> None:
    wanted = [min(math.dist(p, q) for j, q in enumerate(places) if j != i) for i, p in enumerate(places)]
    assert nearest(np.array(places, dtype=float)).tolist() == pytest.approx(wanted, rel=1e-12)
