"""The overview cameras: clear of every box by the rule's own words, and planned at once for any finite scene."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from c4s.evidence.cameras import CLEARANCE_CM, overview_cameras
from c4s.protocol.rules import OVERVIEW_VIEWS

ORDINARY = st.tuples(
    st.tuples(*[st.floats(-3000, 3000)] * 3), st.tuples(st.floats(2, 3000), st.floats(2, 3000), st.floats(2, 9000))
)
NUMBER = st.floats(-1.7e308, 1.7e308)
EXTENT = st.one_of(st.floats(0, 1e300), st.floats(0, 6000))
FINITE = st.tuples(st.tuples(NUMBER, NUMBER, NUMBER), st.tuples(EXTENT, EXTENT, EXTENT))


def scene(boxes: Any) -> dict[str, Any]:
    return {
        "actors": [
            {"bounds": {"origin_cm": list(origin), "extent_cm": list(extent)}, "component_asset_paths": ["x"]}
            for origin, extent in boxes
        ]
    }


def stepped(boxes: Any) -> list[float]:
    """The cameras' heights by the rule's own words: a metre a step while a standing box holds the eye."""
    found = np.array(boxes)
    standing = found[found[:, 1, 2] > 0.03 * found[:, 1, :2].max(axis=1)]
    found = standing if len(standing) else found
    low, high = (np.quantile(found[:, 0] + side * found[:, 1], q, axis=0) for side, q in ((-1, 0.02), (1, 0.98)))
    half = np.maximum((high - low) / 2, 100.0)
    distance = float(np.hypot(half[0], half[1])) / math.tan(math.radians(30)) * 0.86
    heights = []
    for camera, elevation in zip(overview_cameras(scene(boxes)), (24, 42, 24, 42), strict=True):
        eye = np.array([*camera["location_cm"][:2], low[2] + distance * math.sin(math.radians(elevation))])
        while np.any(np.all(np.abs(found[:, 0] - eye) < found[:, 1] + CLEARANCE_CM, axis=1)):
            eye[2] += CLEARANCE_CM
        heights.append(float(eye[2]))
    return heights


@given(st.lists(ORDINARY, min_size=1, max_size=12))
def test_a_camera_is_lifted_step_by_step_until_no_box_holds_it(boxes: Any) -> None:
    assert [camera["location_cm"][2] for camera in overview_cameras(scene(boxes))] == stepped(boxes)


@given(st.lists(FINITE, max_size=20))
def test_every_finite_scene_has_four_finite_cameras(boxes: Any) -> None:
    cameras = overview_cameras(scene(boxes))
    assert len(cameras) == OVERVIEW_VIEWS
    assert all(math.isfinite(v) for camera in cameras for v in (*camera["location_cm"], *camera["target_cm"]))


@pytest.mark.parametrize("height", [1e5, 1e9, 1e300])
def test_a_cube_of_any_height_is_left_at_its_top(height: float) -> None:
    tower = ((0.0, 0.0, 0.0), (5000.0, 5000.0, height))
    bench = ((0.0, 0.0, 50.0), (60.0, 30.0, 50.0))
    for camera in overview_cameras(scene([bench] * 200 + [tower])):
        eye = camera["location_cm"][2]
        assert eye >= min(height, 8.8e12) + CLEARANCE_CM
        assert eye - CLEARANCE_CM < min(height, 8.8e12) + CLEARANCE_CM


def test_a_tower_of_many_boxes_is_climbed_by_whole_steps() -> None:
    benches = [((0.0, 0.0, 50.0), (60.0, 30.0, 50.0))] * 400
    tower = [((0.0, 0.0, 200.0 * level), (900.0, 900.0, 60.0)) for level in range(8)]
    heights = [camera["location_cm"][2] for camera in overview_cameras(scene(benches + tower))]
    assert heights == stepped(benches + tower)
    assert all(height >= 1400 + 60 + CLEARANCE_CM for height in heights)
