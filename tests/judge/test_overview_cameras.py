"""The overview cameras: four for any scene, clear of every box, and not to be drawn away by what is no scene."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from c4s.protocol.rules import OVERVIEW_VIEWS
from c4s.semantics.sight import overview_plan
from c4s.semantics.sight.clearance import HOLLOW_CM
from tests.judge.looking import actor, scene, unhidden

ORDINARY = st.tuples(
    st.tuples(*[st.floats(-3000, 3000)] * 3), st.tuples(st.floats(2, 900), st.floats(2, 900), st.floats(2, 900))
)
NUMBER = st.one_of(st.floats(-1.7e308, 1.7e308), st.sampled_from([math.nan, math.inf, -math.inf]))
EXTENT = st.one_of(st.floats(0, 1e300), st.floats(0, 6000), st.just(math.nan))
ANYTHING = st.tuples(st.tuples(NUMBER, NUMBER, NUMBER), st.tuples(EXTENT, EXTENT, EXTENT))


def planned(snapshot: dict[str, Any]) -> list[dict[str, Any]]:
    return [dict(camera) for camera in overview_plan(snapshot, unhidden(snapshot)).cameras]


def boxes_to_scene(boxes: Any) -> dict[str, Any]:
    return scene([actor(f"Box{number % 3}_{number}", *box) for number, box in enumerate(boxes)])


def objects(names: Iterable[str]) -> set[str]:
    """Those that are no ground."""
    return {name for name in names if "Tile" not in name}


def yard(**more: Any) -> list[dict[str, Any]]:
    """A floor of tiles, a row of houses, and things before them."""
    found = [actor(f"Tile_{x}_{y}", (x * 400, y * 400, -2), (200, 200, 2)) for x in range(-4, 5) for y in range(-3, 4)]
    found += [actor(f"House_{n}", (n * 700 - 1400, 1000, 300), (300, 300, 300)) for n in range(5)]
    found += [actor(f"Bench_{n}", (n * 300 - 1500, -300, 45), (90, 26, 45)) for n in range(11)]
    return [*found, actor("Well_1", (0, 200, 80), (80, 80, 80), **more)]


@given(st.lists(ORDINARY, max_size=12))
@settings(deadline=None, max_examples=60)
def test_no_camera_is_in_a_box_unless_it_is_a_room_around_the_scene(boxes: Any) -> None:
    cameras = planned(boxes_to_scene(boxes))
    assert [camera["name"] for camera in cameras] == [f"overview-{n}" for n in range(1, OVERVIEW_VIEWS + 1)]
    for camera in cameras:
        for origin, extent in boxes:
            held = np.all(np.abs(np.subtract(camera["location_cm"], origin)) < extent)
            assert not held or 2 * min(extent) >= HOLLOW_CM


@given(st.lists(ANYTHING, max_size=20))
@settings(deadline=None, max_examples=60)
def test_any_scene_has_four_finite_cameras_and_always_the_same(boxes: Any) -> None:
    cameras = planned(boxes_to_scene(boxes))
    assert len(cameras) == OVERVIEW_VIEWS
    assert all(math.isfinite(v) for camera in cameras for v in (*camera["location_cm"], *camera["rotation_deg"]))
    assert planned(boxes_to_scene(boxes)) == cameras


def test_an_empty_scene_is_framed() -> None:
    cameras = planned(scene([]))
    assert len({tuple(camera["location_cm"]) for camera in cameras}) == OVERVIEW_VIEWS
    for camera in cameras:
        assert 1000 < np.linalg.norm(camera["location_cm"]) < 6000 and camera["location_cm"][2] > 300


def test_every_object_is_whole_in_the_first_view() -> None:
    snapshot = scene(yard())
    first = planned(snapshot)[0]
    (glimpse,) = unhidden(snapshot)([first])
    assert objects(glimpse["visible"]) == objects(row["name"] for row in snapshot["actors"])
    assert not objects(glimpse["edge"]), "the ground may run out of the picture"


@pytest.mark.parametrize(
    "junk",
    [
        [actor(f"Far_{n}", (4e6 + 1000 * n, -9e5 * n, 50), (50, 50, 50)) for n in range(12)],
        [actor(f"High_{n}", (100 * n, 0, 8e7), (5000, 5000, 5000)) for n in range(20)],
        [actor(f"Deep_{n}", (30 * n, 0, -3000), (20, 20, 20)) for n in range(40)],
        [actor("Sky_1", (0, 0, 0), (9e6, 9e6, 9e6))],
        [actor("Shell_1", (0, 0, 0), (60000, 60000, 60000))],
        [actor(f"Gone_{n}", (20000 + n, 0, 100), (900, 900, 900), hidden=True) for n in range(30)],
        [actor(f"Same_{n}", (0, 200, 80), (10, 10, 10)) for n in range(500)],
        [actor("Odd_1", (math.nan, 0, 0), (1, 1, 1)), actor("Odd_2", (0, 0, 0), (math.inf, 1, 1))],
        [actor("Speck_1", (9000, 0, 0), (0.1, 0.1, 0.1))],
    ],
    ids=["far", "high", "deep", "sky", "shell", "hidden", "copies", "not finite", "speck"],
)
def test_junk_does_not_draw_the_cameras_away(junk: list[dict[str, Any]]) -> None:
    honest = scene(yard())
    shown = unhidden(honest)
    cameras = planned(scene([*yard(), *junk]))
    assert set.union(*[objects(glimpse["visible"]) for glimpse in shown(cameras)]) == objects(
        row["name"] for row in honest["actors"]
    )
    assert all(np.abs(camera["location_cm"]).max() < 12000 and camera["location_cm"][2] > 0 for camera in cameras)


def test_what_is_buried_without_a_floor_is_not_looked_for_below_the_ground() -> None:
    down = [actor(f"House_{n}", (n * 700, 0, -30000), (300, 300, 300)) for n in range(9)]
    assert planned(scene(down)) == planned(scene([]))
    floor = actor("Tile_1", (2800, 0, -30302), (5000, 5000, 2))
    assert all(camera["location_cm"][2] < -20000 for camera in planned(scene([*down, floor]))), "a floor is a ground"


def test_a_plate_as_large_as_the_scene_does_not_move_the_cameras() -> None:
    plate = actor("Plate_1", (0, 0, -5), (6500, 6500, 5))
    cameras = planned(scene([*yard(), plate]))
    assert all(np.abs(camera["location_cm"]).max() < 6000 for camera in cameras)
