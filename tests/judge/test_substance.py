"""What counts as a thing of a scene, and what is set aside."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from c4s.semantics.inventory import Thing
from c4s.semantics.kinds import ThingKind
from c4s.semantics.substance import REASONS, substance


def kind(name: str = "Crate", size_m: tuple[float, float, float] = (1.0, 1.0, 1.0)) -> ThingKind:
    return ThingKind(f"/Game/P/SM_{name}", {"name": name, "size_m": list(size_m)})


CRATE, BARREL, TILE, LAMP = kind(), kind("Barrel"), kind("Floor tile", (4.0, 4.0, 0.04)), kind("Pendant lamp")


def thing(
    centre: tuple[float, float, float],
    half: float | tuple[float, float, float] = 50.0,
    of: ThingKind = CRATE,
    actor: str = "",
    scale: float = 1.0,
    collision: bool | None = True,
) -> Thing:
    place, reach = np.array(centre, dtype=float), np.broadcast_to(np.array(half, dtype=float), 3)
    return Thing(actor or repr(centre), of, place - reach, place + reach, np.full(3, scale), (), collision)


def aside(*things: Thing, **given: Any) -> dict[str, list[Thing]]:
    found = substance(things, **given)
    assert sorted(map(id, [*found.counted, *(t for row in found.aside.values() for t in row)])) == sorted(
        map(id, things)
    )
    return {str(reason): rows for reason, rows in found.aside.items()}


@pytest.mark.parametrize(
    ("scale", "of", "kept"),
    [(0.05, CRATE, False), (0.5, CRATE, True), (3.0, CRATE, True), (9.0, CRATE, False), (9.0, TILE, True)],
)
def test_what_is_far_from_its_true_size_is_set_aside_unless_it_is_flat(scale: float, of: ThingKind, kept: bool) -> None:
    one = thing((0, 0, 50 * scale), 50 * scale, of, scale=scale)
    assert aside(one) == ({} if kept else {"out_of_size": [one]})


def test_of_coincident_copies_one_counts() -> None:
    copies = [thing((float(n), 0, 50), actor=f"a{n}") for n in range(3)]
    beside = thing((150, 0, 50))
    other = thing((0, 0, 50), of=BARREL, actor="other")
    assert aside(*copies, beside, other)["at_one_place"] == copies[1:]


def test_what_two_others_hold_is_swallowed_and_what_one_holds_is_not() -> None:
    pedestal, desk = thing((0, 0, 30), 30, BARREL), thing((0, 0, 50), (60, 60, 50), kind("Desk"))
    assert aside(pedestal, desk) == {}
    heap = [thing((n * 8.0, n * 5.0, 50), of=kind(f"K{n}"), actor=f"h{n}") for n in range(6)]
    assert len(aside(*heap)["swallowed"]) >= 4


def test_a_heap_of_many_assets_in_one_actor_is_a_heap_and_one_of_its_instances_is_none() -> None:
    heap = [thing((n * 8.0, n * 5.0, 50), of=kind(f"K{n}"), actor="all") for n in range(6)]
    assert len(aside(*heap)["swallowed"]) >= 4
    field = [thing((n * 30.0, 0, 50), of=kind("Wheat"), actor="all") for n in range(6)]
    assert aside(*field) == {}


def test_ghosts_do_not_count_nor_carry() -> None:
    ghost = thing((0, 0, 500), collision=False)
    over = thing((0, 0, 600))
    assert aside(ghost, over) == {"no_collision": [ghost], "unconnected": [over]}
    honest = thing((0, 0, 50), collision=False)
    assert aside(honest) == {}, "a thing on the ground that nothing overlaps may have its collision off"


def test_a_chain_of_touching_things_holds_up_what_stands_on_it() -> None:
    tower = [thing((0, 0, 50 + 100 * n), of=kind(f"K{n}")) for n in range(8)]
    assert aside(*tower) == {}
    assert aside(*tower[:3], *tower[4:]) == {"unconnected": tower[4:]}


def test_lamps_hang_free_and_crates_do_not() -> None:
    crate = thing((0, 0, 700))
    assert aside(thing((0, 0, 300), of=LAMP), crate) == {"unconnected": [crate]}


def test_a_floor_of_its_own_height_carries_only_where_it_is_the_scene_s_floor() -> None:
    high = [thing((x * 400.0, 0, 1052)) for x in range(10)]
    floor = [thing((x * 400.0, 0, 1000), (200, 200, 2), TILE) for x in range(10)]
    assert aside(*high, *floor) == {}
    assert set(aside(*high, floor[0])) == {"unconnected"}


@pytest.mark.parametrize("height", [-30_000.0, 1_000.0])
def test_what_lies_buried_or_is_lifted_is_unconnected_and_a_landscape_connects(height: float) -> None:
    things = [thing((x * 400.0, 0, height)) for x in range(5)]
    assert aside(*things) == {"unconnected": things}
    land = (np.array([-1e5, -1e5, height - 60]), np.array([1e5, 1e5, height - 40]))
    assert aside(*things, ground=[land]) == {}


@given(
    st.lists(st.tuples(*(st.sampled_from([-9000.0, -60.0, 0.0, 50.0, 90.0, 4000.0]) for _ in range(3))), max_size=12)
)
def test_every_thing_counts_or_has_one_reason(places: list[tuple[float, float, float]]) -> None:
    things = [thing(place, actor=f"a{n}") for n, place in enumerate(places)]
    found = substance(things)
    assert set(found.aside) <= set(REASONS)
    assert len(found.counted) + sum(map(len, found.aside.values())) == len(things)
    assert substance(things[::-1]).share == pytest.approx(found.share)
