"""The walkable space against answers that are known: doors, ramps, stairs, bridges, storeys, limits."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from c4s.collision import scene_bodies
from c4s.navigation import NavigationSettings, SpaceMesh, SpaceTooLarge, WalkableSpace, build_space
from c4s.navigation.solids import navigation_bounds
from tests.navigation.scenes import RAMP, actor, floor, scene

SETTINGS = NavigationSettings()


def space(*actors: dict[str, Any], reverse: bool = False) -> WalkableSpace:
    bodies = scene_bodies(scene(*actors))
    return build_space(bodies.bodies[::-1] if reverse else bodies.bodies, navigation_bounds(bodies), SETTINGS)


def linked(made: WalkableSpace, a: tuple[float, float, float], b: tuple[float, float, float]) -> bool:
    """Whether a way leads from one place to another; both must be walkable."""
    one, two = SpaceMesh(made).components(np.array([a, b], dtype=float))
    assert one >= 0 and two >= 0
    return bool(one == two)


def walls_with_a_door(width: float) -> list[dict[str, Any]]:
    half = width / 2
    return [
        floor(),
        actor("Wall A", (-10, -1000, 0), (10, -half, 300)),
        actor("Wall B", (-10, half, 0), (10, 1000, 300)),
    ]


def test_a_plate_is_walkable_but_for_the_bodys_radius_at_its_edge() -> None:
    made = space(floor(2000, 1000))
    assert made.area_m2 == pytest.approx(19 * 9, rel=0.03)
    low, high = made.bounds_cm() or pytest.fail("nothing to walk on")
    assert np.allclose(low[:2], [-950, -450], atol=12.5) and np.allclose(high[:2], [950, 450], atol=12.5)
    assert len(made.sizes) == 1


@pytest.mark.parametrize(("width", "passes"), [(90.0, False), (100.0, False), (130.0, True), (200.0, True)])
def test_a_door_lets_a_body_through_that_is_narrower(width: float, passes: bool) -> None:
    assert linked(space(*walls_with_a_door(width)), (-500, 0, 0), (500, 0, 0)) is passes


@pytest.mark.parametrize(("height", "passes"), [(150.0, False), (175.0, False), (190.0, True)])
def test_a_lintel_stops_a_body_that_is_higher(height: float, passes: bool) -> None:
    made = space(*walls_with_a_door(200), actor("Lintel", (-10, -100, height), (10, 100, 300)))
    assert linked(made, (-500, 0, 0), (500, 0, 0)) is passes


@pytest.mark.parametrize(("degrees", "passes"), [(20, True), (30, True), (34, True), (37, False), (45, False)])
def test_a_ramp_is_climbed_up_to_the_slope(degrees: float, passes: bool) -> None:
    rise = 600 * math.tan(math.radians(degrees))
    made = space(
        floor(),
        actor("Ramp", (0, -200, 0), (600, 200, rise), mesh=RAMP),
        actor("Deck", (600, -200, 0), (1000, 200, rise)),
    )
    assert linked(made, (-500, 0, 0), (800, 0, rise)) is passes


@pytest.mark.parametrize(("step", "passes"), [(20.0, True), (35.0, True), (41.0, False), (60.0, False)])
def test_stairs_are_climbed_up_to_the_step(step: float, passes: bool) -> None:
    stairs = [actor(f"Step {n}", (n * 60, -200, 0), (1000, 200, (n + 1) * step)) for n in range(5)]
    made = space(floor(), *stairs)
    assert linked(made, (-500, 0, 0), (800, 0, 5 * step)) is passes


def test_a_bridge_is_walked_over_and_under() -> None:
    made = space(
        floor(3000, 3000),
        actor("Ramp up", (-900, -150, 0), (-300, 150, 300), mesh=RAMP),
        actor("Bridge", (-300, -150, 280), (300, 150, 300)),
        actor("Ramp down", (900, -150, 0), (1500, 150, 300), mesh=RAMP, yaw=180.0),
    )
    column = made.column_of(np.zeros((1, 2)))[0]
    spans = np.arange(made.first[column], made.first[column + 1])
    heights = made.origin_cm[2] + made.floor[spans] * SETTINGS.cell_height_cm
    assert [round(float(z)) for z in heights] == [0, 300]
    assert linked(made, (0, 0, 0), (0, 0, 300))


def test_a_storey_without_stairs_is_a_component_of_its_own() -> None:
    made = space(floor(), actor("Upper floor", (-1000, -1000, 280), (1000, 1000, 300)))
    assert not linked(made, (0, 0, 0), (0, 0, 300))
    assert len(made.sizes) == 2


def test_nobody_walks_inside_a_solid_and_no_small_island_is_ground() -> None:
    made = space(
        floor(), actor("Hall", (-500, -500, 0), (500, 500, 400)), actor("Crate", (700, 700, 0), (800, 800, 60))
    )
    assert SpaceMesh(made).components(np.array([[0, 0, 0], [0, 0, 400], [750, 750, 60.0]])).tolist() == [-1, 1, -1]


def test_what_is_far_from_everything_walkable_has_no_cell() -> None:
    mesh = SpaceMesh(space(floor()))
    assert mesh.components(np.array([[5000.0, 0, 0], [0, 0, 500.0]])).tolist() == [-1, -1]
    assert mesh.route(np.array([0.0, 0, 0]), np.array([5000.0, 0, 0])) is None


def test_an_empty_scene_has_nothing_to_walk_on() -> None:
    made = space()
    assert made.bounds_cm() is None and made.area_m2 == 0
    assert len(SpaceMesh(made).lattice(25, 100)) == 0


def test_a_backdrop_does_not_widen_the_bounds_but_is_walked_on() -> None:
    made = space(floor(40_000, 40_000), *[actor(f"Crate {n}", (n * 300, 0, 0), (n * 300 + 50, 50, 50)) for n in (0, 1)])
    low, high = made.bounds_cm() or pytest.fail("nothing to walk on")
    assert (high - low)[:2].max() < 1000
    assert made.area_m2 > 15


def test_what_is_too_large_is_refused_before_memory_is_taken() -> None:
    towers = [actor(f"Tower {n}", (n * 15_000, 0, 0), (n * 15_000 + 100, 100, 100)) for n in (0, 1000)]
    with pytest.raises(SpaceTooLarge, match="the navigation bounds are 1500"):
        space(floor(), *towers, actor("Far", (0, 1e7, 0), (100, 1e7 + 100, 100)))
    with pytest.raises(SpaceTooLarge):
        space(floor(), actor("High", (0, 0, 1e11), (100, 100, 1e11 + 100)))


def test_routes_are_straight_where_they_can_be_and_keep_the_bodys_clearance() -> None:
    wall = actor("Wall", (-10, -600, 0), (10, 1000, 300))
    mesh = SpaceMesh(space(floor(), wall))
    start, goal = np.array([-500.0, 500, 0]), np.array([500.0, 500, 0])
    route = mesh.route(start, goal)
    assert route is not None and len(route) <= 6
    length = float(np.linalg.norm(np.diff(route, axis=0), axis=1).sum())
    around = np.linalg.norm(np.array([-60, -650]) - start[:2]) * 2 + 120
    assert length == pytest.approx(around, rel=0.02)
    steps = np.concatenate([np.linspace(a, b, 50) for a, b in pairwise(route)])
    gap = np.hypot(np.maximum(np.abs(steps[:, 0]) - 10, 0), np.maximum(-600 - steps[:, 1], 0))
    assert gap.min() >= SETTINGS.radius_cm - 1
    assert mesh.distances(start, goal[None])[0] == pytest.approx(length, rel=0.09)
    assert mesh.distances(start, goal[None])[0] >= length - 2 * SETTINGS.cell_cm


boxes = st.tuples(
    st.integers(-900, 900), st.integers(-900, 900), st.integers(0, 300), st.integers(10, 400), st.integers(10, 400),
    st.integers(5, 300), st.integers(-180, 180),
)  # fmt: skip


@settings(max_examples=40, deadline=None)
@given(st.lists(boxes, max_size=12))
def test_the_order_of_bodies_and_a_shift_by_whole_cells_change_nothing(placed: list[tuple[int, ...]]) -> None:
    def made(shift: float = 0.0, *, reverse: bool = False) -> WalkableSpace:
        things = [
            actor(f"B{n}", (x + shift, y, z), (x + shift + w, y + d, z + h), yaw=yaw)
            for n, (x, y, z, w, d, h, yaw) in enumerate(placed)
        ]
        ground = actor("Floor", (-1000 + shift, -1000, -20), (1000 + shift, 1000, 0))
        return space(ground, *things, reverse=reverse)

    one, two, moved = made(), made(reverse=True), made(800.0)
    for part in ("first", "floor", "links", "region", "sizes"):
        assert np.array_equal(getattr(one, part), getattr(two, part))
    assert one.sizes.tolist() == moved.sizes.tolist()


@settings(max_examples=40, deadline=None)
@given(st.lists(boxes, max_size=12))
def test_links_lead_both_ways_and_regions_do_not_touch(placed: list[tuple[int, ...]]) -> None:
    made = space(
        floor(),
        *[actor(f"B{n}", (x, y, z), (x + w, y + d, z + h), yaw=a) for n, (x, y, z, w, d, h, a) in enumerate(placed)],
    )
    for side in range(4):
        spans = np.flatnonzero(made.links[:, side] >= 0)
        other = made.links[spans, side]
        assert np.array_equal(made.links[other, (side + 2) % 4], spans)
        inside = (made.region[spans] >= 0) & (made.region[other] >= 0)
        assert np.array_equal(made.region[spans][inside], made.region[other][inside])
    counted = np.bincount(made.region[made.region >= 0], minlength=len(made.sizes))
    assert counted.tolist() == made.sizes.tolist() and all(size >= SETTINGS.least_cells for size in made.sizes)
