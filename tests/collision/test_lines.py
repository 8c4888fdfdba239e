"""Many lines at once against what the engine finds for each line alone."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from c4s.collision.lines import TriangleSet, meet_shape
from c4s.collision.mesh_body import MeshBody
from c4s.collision.shape_cache import SHAPES
from c4s.engine.headless.queries.solids import ray_body
from c4s.engine.headless.queries.triangles import first_on_segment

SEEDS = st.integers(0, 2**32 - 1)


@settings(max_examples=60, deadline=None)
@given(SEEDS, st.sampled_from(["any", "down", "flat", "short"]))
def test_triangles_are_met_as_one_by_one(seed: int, kind: str) -> None:
    rng = np.random.default_rng(seed)
    corners = rng.normal(size=(60, 1, 3)) * 50 + rng.normal(size=(60, 3, 3)) * 20
    start, step = rng.normal(size=(40, 3)) * 60, rng.normal(size=(40, 3)) * 80
    if kind == "down":
        start[:, 2], step = 200.0, np.tile([0.0, 0.0, -5000.0], (40, 1))
    if kind == "flat":
        corners[..., 2] = np.round(corners[..., 2], -1)[:, :1]
        step[:, 2] = 0.0
    if kind == "short":
        step *= 0.05
    found = TriangleSet(corners).meet(start, step)
    for k in range(len(start)):
        alone = first_on_segment(corners, start[k], step[k])
        assert found.fraction[k] == pytest.approx(np.inf if alone is None else alone[0], abs=1e-9)
        if alone is not None:
            a, b, c = corners[alone[1]]
            across = np.cross(b - a, c - a)
            cosine = across @ found.normal[k] / np.linalg.norm(across) / np.linalg.norm(found.normal[k])
            assert abs(cosine) == pytest.approx(1.0)


@settings(max_examples=60, deadline=None)
@given(SEEDS, st.sampled_from(["box", "sphere", "capsule", "hull"]))
def test_bodies_are_met_as_one_by_one(seed: int, kind: str) -> None:
    rng = np.random.default_rng(seed)
    size = rng.uniform(5, 40, 3).tolist()
    vertices = (rng.normal(size=(12, 3)) * 25).astype(np.float64).tobytes() if kind == "hull" else b""
    shape = SHAPES.shape(MeshBody(kind, size=(size[0], size[1], size[2]), vertices=vertices), (1.0, 1.0, 1.0))
    assert shape is not None
    body = shape.place(np.eye(3), np.zeros(3))
    start, step = rng.normal(size=(60, 3)) * 50, rng.normal(size=(60, 3)) * 80
    local, way = (start - body.translation) @ body.rotation, step @ body.rotation
    found = meet_shape(body.form, local, way)
    for k in range(len(start)):
        length = float(np.linalg.norm(step[k]))
        alone = ray_body(body, start[k], step[k] / length, length)
        assert found.fraction[k] == pytest.approx(np.inf if alone is None else alone.distance / length, abs=1e-9)
        assert bool(found.inside[k]) == (alone is not None and alone.inside)
        if alone is not None and not alone.inside:
            normal = body.rotation @ found.normal[k]
            assert normal @ alone.normal / np.linalg.norm(normal) == pytest.approx(1.0)


def test_a_flat_hull_is_met_from_both_sides_and_has_no_inside() -> None:
    square = np.array([[-10, -10, 3], [10, -10, 3], [10, 10, 3], [-10, 10, 3]], dtype=np.float64)
    shape = SHAPES.shape(MeshBody("hull", vertices=square.tobytes()), (1.0, 1.0, 1.0))
    assert shape is not None
    body = shape.place(np.eye(3), np.zeros(3))
    start = np.array([[0.0, 0.0, 8.0], [0.0, 0.0, -2.0], [30.0, 0.0, 8.0]])
    step = np.array([[0.0, 0.0, -10.0], [0.0, 0.0, 10.0], [0.0, 0.0, -10.0]])
    found = meet_shape(body.form, (start - body.translation) @ body.rotation, step @ body.rotation)
    assert found.fraction.tolist() == pytest.approx([0.5, 0.5, np.inf])
    assert not found.inside.any()
