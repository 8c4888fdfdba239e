"""Where traces and sweeps hit: bodies, triangles, placements, and what has no length or is no number."""

from __future__ import annotations

import math
import re
from types import ModuleType
from typing import Any

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from query_scene import Scene, row


def test_simple_traces_meet_bodies_and_complex_ones_triangles(scene: Scene) -> None:
    table = scene.put("table")
    under = ((-300, 0, 50), (300, 0, 50))
    assert scene.line(*under) is None
    hit = scene.line(*under, triangles=True).to_dict()
    assert hit["distance"] == pytest.approx(200) and hit["face_index"] >= 0 and hit["element_index"] == -1
    leg = scene.line((-300, 40, 50), (300, 40, 50)).to_tuple()
    assert leg[0] and not leg[1] and leg[3] == pytest.approx(205) and leg[2] == pytest.approx(205 / 600)
    assert leg[9] is table and leg[10] is table.static_mesh_component and leg[14] == 2 and leg[15] == -1
    assert row(leg[7]) == (-1.0, 0.0, 0.0) and row(leg[16]) == (-300.0, 40.0, 50.0)
    assert scene.line((0, 0, 500), (0, 0, 0)).to_tuple()[5].z == pytest.approx(100)
    scene.put("bare", (1000, 0, 0))
    assert scene.line((1000, 0, 500), (1000, 0, -5)) is None
    assert scene.line((1000, 0, 500), (1000, 0, -5), triangles=True).to_tuple()[3] == pytest.approx(400)


def test_round_bodies_under_uneven_scale_follow_unreal(scene: Scene) -> None:
    """A sphere takes the smallest axis, a capsule the larger radial one and its own length axis."""
    scene.put("ball", scale=(2, 3, 1))
    assert scene.line((-500, 0, 50), (500, 0, 50)).to_tuple()[3] == pytest.approx(450)
    assert scene.line((0, 60, 500), (0, 60, -500)) is None
    scene.put("post", (1000, 0, 0), scale=(1, 3, 0.5))
    assert scene.line((0, 1000, 50), (2000, 1000, 50)) is None
    assert scene.line((500, 0, 50), (1500, 0, 50)).to_tuple()[3] == pytest.approx(500 - 50, abs=1e-6)
    assert scene.line((1000, 0, 500), (1000, 0, -500)).to_tuple()[3] == pytest.approx(400)
    scene.put("wedge", (2000, 0, 0), (0, 0, 0), (-1, 1, 2))
    hit = scene.line((2030, 0, 500), (2030, 0, -500)).to_dict()
    assert hit["impact_point"].z == pytest.approx(160) and hit["impact_normal"].x < 0


@settings(max_examples=60, deadline=None)
@given(
    turn=st.tuples(*[st.floats(-180, 180)] * 3),
    scale=st.tuples(*[st.sampled_from([-2.0, 0.3, 1.0, 4.0])] * 3),
    start=st.tuples(*[st.floats(-400, 400)] * 3),
    end=st.tuples(*[st.floats(-80, 80)] * 3),
)
def test_a_line_meets_a_placed_cube_where_its_own_frame_says(
    engine: ModuleType, turn: Any, scale: Any, start: Any, end: Any
) -> None:
    engine.EditorLoadingAndSavingUtils.new_blank_map(False)
    scene = Scene(engine)
    cube = scene.put("Cube", (10, 20, 30), turn, scale)
    frame = cube.get_actor_transform()
    a, b = (np.array(row(frame.inverse_transform_location(scene.vector(p)))) for p in (start, end))
    step = np.where(np.abs(b - a) < 1e-9, 1e-9, b - a)
    near, far = np.minimum((-50 - a) / step, (50 - a) / step).max(), np.maximum((-50 - a) / step, (50 - a) / step).min()
    inside = bool((np.abs(a) < 50).all())
    if min(abs(far - near), abs(near), abs(near - 1), abs(far), math.dist(start, end) - 1e-3) < 1e-6:
        return
    hits = [scene.line(start, end, triangles=triangles) for triangles in (False, True)]
    if inside:
        assert hits[0].to_tuple()[1] and hits[0].to_tuple()[2] == 0.0
        return
    if near > far or near < 0 or near > 1:
        assert hits == [None, None]
        return
    for hit in hits:
        assert hit.to_tuple()[2] == pytest.approx(near, abs=1e-6)
        normal = np.array(row(hit.to_tuple()[7]))
        assert np.linalg.norm(normal) == pytest.approx(1) and normal @ (np.array(end) - start) < 0


@settings(max_examples=60, deadline=None)
@given(
    st.sampled_from(["Cube", "Sphere", "Cone", "table", "post", "wedge"]),
    st.tuples(*[st.floats(-180, 180)] * 3),
    st.sampled_from(["ball", "box", "capsule"]),
    st.tuples(*[st.floats(-300, 300)] * 3),
    st.tuples(*[st.floats(-300, 300)] * 3),
)
@example("table", (0.0, 0.0, 97.0), "capsule", (109.0, 0.0, 9.0), (0.0, 0.0, 0.0))
def test_a_sweep_stops_where_the_shape_would_begin_to_overlap(
    engine: ModuleType, asset: str, turn: Any, kind: str, start: Any, end: Any
) -> None:
    engine.EditorLoadingAndSavingUtils.new_blank_map(False)
    scene = Scene(engine)
    scene.put(asset, (0, 0, 0), turn, (1.5, 1.0, 0.7))
    sweep = {
        "ball": lambda: scene.ball(start, end, 30),
        "box": lambda: scene.box(start, end, (20, 40, 10), 25.0),
        "capsule": lambda: scene.capsule(start, end, 20, 60),
    }[kind]

    def overlaps(place: Any) -> bool:
        library, none = scene.library, (None, [])
        at = scene.vector(place)
        found = {
            "ball": lambda: library.sphere_overlap_actors(scene.world, at, 30.0, scene.statics, *none),
            "box": lambda: library.box_overlap_actors_with_orientation(
                scene.world, at, scene.vector((20, 40, 10)), engine.Rotator(yaw=25.0), scene.statics, *none
            ),
            "capsule": lambda: library.capsule_overlap_actors(scene.world, at, 20.0, 60.0, scene.statics, *none),
        }
        return found[kind]() is not None

    hit, a, step = sweep(), np.array(start), np.array(end) - start
    length = float(np.linalg.norm(step))
    if hit is None:
        assert not any(overlaps(a + f * step) for f in np.linspace(0.02, 0.98, 9))
        return
    fields = hit.to_dict()
    if fields["initial_overlap"]:
        assert fields["time"] == 0.0 and overlaps(start)
        depth = float(re.search(r"PenetrationDepth=([\d.]+)", hit.export_text()).group(1))  # type: ignore[union-attr]
        assert depth > 0
        if asset != "table":  # of several bodies: what frees a shape from one may push it into another
            assert not overlaps(a + (depth + 0.02) * np.array(row(fields["normal"])))
        return
    assert not any(overlaps(a + f * fields["time"] * step) for f in (0.0, 0.3, 0.7)) or fields["distance"] < 0.1
    approach = -float(np.array(row(fields["normal"])) @ step) / length
    assert approach > 0
    if approach > 0.3 and fields["distance"] + 0.1 < length:
        assert overlaps(a + (fields["distance"] + 0.1) / length * step)
    assert fields["location"].distance(scene.vector(start)) == pytest.approx(fields["distance"], abs=1e-6)


def test_sweeps_against_triangles_agree_with_those_against_an_equal_body(scene: Scene) -> None:
    scene.put("Cube", (0, 0, 50), (10, 30, 5), (1, 2, 0.5))
    for moved in (
        lambda t: scene.ball((-300, 20, 60), (300, 10, 40), 25, triangles=t),
        lambda t: scene.box((10, 5, 400), (0, 0, -400), (30, 10, 20), 15.0, triangles=t),
        lambda t: scene.capsule((-300, 20, 60), (300, 10, 40), 10, 80, triangles=t),
    ):
        simple, full = moved(False).to_dict(), moved(True).to_dict()
        assert full["distance"] == pytest.approx(simple["distance"], abs=2e-3)
        assert np.array(row(full["impact_normal"])) @ row(simple["impact_normal"]) == pytest.approx(1, abs=1e-6)
        assert full["face_index"] >= 0


def test_starts_inside_lengths_of_zero_and_numbers_that_are_none(scene: Scene, capsys: Any) -> None:
    cube = scene.put("Cube", (0, 0, 50))
    inside = scene.line((0, 0, 50), (500, 0, 50)).to_dict()
    assert inside["initial_overlap"] and inside["distance"] == 0 and row(inside["normal"]) == (-1.0, 0.0, 0.0)
    assert row(inside["impact_point"]) == row(inside["location"]) == (0.0, 0.0, 50.0)
    assert scene.line((0, 0, 50), (500, 0, 50), triangles=True).to_tuple()[3] == pytest.approx(50)
    assert scene.line((0, 0, 50), (0, 0, 50)) is None
    hit = scene.ball((0, 0, 110), (0, 0, 110), 30)
    assert hit.to_tuple()[1] and "PenetrationDepth=20.0000" in hit.export_text()
    assert row(hit.to_tuple()[6]) == pytest.approx((0, 0, 1)) and hit.to_tuple()[2] == 0
    assert scene.ball((0, 0, 130), (0, 0, 130), 30) is None
    assert scene.ball((0, 0, 130.0005), (300, 0, 130.0005), 30) is None
    assert scene.ball((0, 0, 500), (0, 0, 0), 0.0).to_tuple()[3] == pytest.approx(400)
    for bad in (math.nan, math.inf, 1e200):
        assert scene.line((0, 0, bad), (0, 0, 0)) is None and scene.ball((0, 0, 500), (0, 0, 0), bad) is None
        assert (
            scene.library.sphere_overlap_actors(scene.world, scene.vector((bad, 0, 0)), 10.0, scene.statics, None, [])
            is None
        )
    assert capsys.readouterr().out.count("not finite") == 9
    assert (
        scene.library.line_trace_single(
            None,
            scene.vector((0, 0, 500)),
            scene.vector((0, 0, 0)),
            scene.unreal.TraceTypeQuery.TRACE_TYPE_QUERY1,
            False,
            [],
            *scene.tail,
        )
        is None
    )
    assert "null object" in capsys.readouterr().out
    cube.set_actor_scale3d(scene.vector((1, 1, 0)))
    assert scene.line((0, 0, 500), (0, 0, -500)).to_tuple()[5].z == pytest.approx(50)
    assert scene.line((0, 0, 500), (0, 0, -500), triangles=True).to_tuple()[5].z == pytest.approx(50)
