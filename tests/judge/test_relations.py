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

from c4s.semantics.inventory import Thing
from c4s.semantics.kinds import ThingKind
from c4s.semantics.measures import RELATIONS, nearest

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


def near(a: Thing, b: Thing) -> bool:
    size = max(float(t.high[k] - t.low[k]) for t in (a, b) for k in (0, 1))
    return math.hypot(*gaps(a, b)[:2]) <= max(300.0, size / 2)


def on(a: Thing, b: Thing) -> bool:
    step, height = a.low[2] - b.high[2], b.high[2] - b.low[2]
    over = all(b.low[k] <= a.centre[k] <= b.high[k] for k in (0, 1))
    return bool(over and -height / 2 - 10 <= step <= 10 and a.high[2] > b.high[2])


def in_box(a: Thing, b: Thing) -> bool:
    return all(b.low[k] <= a.centre[k] <= b.high[k] for k in range(3))


def above(a: Thing, b: Thing) -> bool:
    return not any(gaps(a, b)[:2]) and bool(a.low[2] >= b.high[2] - 10)


def below(a: Thing, b: Thing) -> bool:
    return not any(gaps(a, b)[:2]) and bool(a.low[2] < b.low[2] + 10 and a.centre[2] < b.high[2])


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
    p = point(a)
    for one, other in itertools.combinations([point(o) for o in others], 2):
        length2 = (other[0] - one[0]) ** 2 + (other[1] - one[1]) ** 2
        if length2:
            foot = (other[0] - one[0]) * (p[0] - one[0]) + (other[1] - one[1]) * (p[1] - one[1])
            share, aside2 = Fraction(foot, length2), Fraction(cross(one, other, p) ** 2, length2)
            assume(share not in (Fraction(1, 10), Fraction(9, 10)) and aside2 != Fraction(length2, 16))
            if Fraction(1, 10) <= share <= Fraction(9, 10) and aside2 <= Fraction(length2, 16):
                return True
    return False


def along(a: Thing, others: Sequence[Thing]) -> bool:
    for other in others:
        short, longer = sorted(float(other.high[k] - other.low[k]) for k in (0, 1))
        if longer >= 2 * short and near(a, other):
            return True
    if len(others) < 3 or not any(near(a, other) for other in others):
        return False
    places = np.array([point(other) for other in others], dtype=float)
    across, way = np.linalg.eigvalsh(np.cov(places.T))
    assume(abs(across - 0.15**2 * way) > 1e-9 * way or way <= 0)
    return bool(way > 0 and across <= 0.15**2 * way)


Definition = Callable[[Thing, Sequence[Thing]], bool]


def any_of(holds: Callable[[Thing, Thing], bool]) -> Definition:
    return lambda a, others: any(holds(a, other) for other in others)


DEFINITIONS: dict[str, Definition] = {
    "on": any_of(on),
    "above": any_of(above),
    "below": any_of(below),
    "near": any_of(near),
    "against": any_of(lambda a, b: math.hypot(*gaps(a, b)) <= 30),
    "apart": lambda a, others: not any(near(a, other) for other in others),
    "inside": lambda a, others: any(in_box(a, other) for other in others) or in_ring(a, others),
    "between": lies_between,
    "along": along,
}


@pytest.mark.parametrize("name", sorted(RELATIONS))
@given(boxes=SCENE, data=st.data())
def test_a_relation_of_many_is_its_definition_of_each(name: str, boxes: list[Any], data: st.DataObject) -> None:
    things = [thing(box, f"a{number}") for number, box in enumerate(boxes)]
    references = data.draw(st.lists(st.sampled_from(things), min_size=1, unique_by=id))
    subjects = things if data.draw(st.booleans()) else [t for t in things if t not in references]
    found = RELATIONS[name](subjects, references).tolist()
    assert found == [DEFINITIONS[name](t, [r for r in references if r is not t]) for t in subjects]


@given(st.lists(st.tuples(PLACE, PLACE), min_size=2, max_size=20))
def test_the_nearest_is_the_nearest_of_all(places: list[tuple[int, int]]) -> None:
    wanted = [min(math.dist(p, q) for j, q in enumerate(places) if j != i) for i, p in enumerate(places)]
    assert nearest(np.array(places, dtype=float)).tolist() == pytest.approx(wanted, rel=1e-12)
