"""Collision that a mesh's own surface tells: solids stay solid, rooms stay empty, nothing is filled that is free."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from scipy.spatial import ConvexHull

from catalog.ingest.automatic import automatic
from catalog.ingest.hulls import bodies, hull
from catalog.ingest.merging import HARD_LIMIT
from catalog.ingest.panels import THICK_CM


@pytest.fixture(autouse=True)
def home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("C4S_HOME", str(tmp_path / "home"))


def made(mesh: trimesh.Trimesh) -> list[Any]:
    """Corners of the bodies, as a pack would hold them."""
    found = automatic(np.asarray(mesh.vertices, float), np.asarray(mesh.faces, np.int64))
    return [np.array(hull(points).vertices) for points in found.bodies]


def box(size: Any, at: Any = (0, 0, 0), *, inward: bool = False, without: Any = None) -> trimesh.Trimesh:
    """A box around ``at``; ``without``: the direction of a face that is missing."""
    mesh = trimesh.creation.box(extents=size)
    keep = np.ones(12, bool) if without is None else np.asarray(mesh.face_normals) @ without < 0.9
    faces = np.asarray(mesh.faces)[keep]
    return trimesh.Trimesh(np.asarray(mesh.vertices) + at, faces[:, ::-1] if inward else faces, process=False)


def joined(*meshes: trimesh.Trimesh) -> trimesh.Trimesh:
    return trimesh.util.concatenate(meshes)


def depth(found: list[Any], points: Any) -> Any:
    """How deep (cm) each point lies in the bodies; negative: how far outside the nearest, along a face's normal."""
    planes = [ConvexHull(one).equations for one in found]
    return np.max([-(points @ rows[:, :3].T + rows[:, 3]).max(axis=1) for rows in planes], axis=0)


ROOM = (700, 700, 300)
INSIDE = np.array([[0.0, 0, 0], [300, 300, -100], [-340, 0, 0], [0, 0, -140]])


@pytest.mark.parametrize(
    "room",
    [
        box(ROOM, inward=True),
        box(ROOM, inward=True, without=(0, 0, 1)),
        box(ROOM, without=(0, 0, 1)),
        joined(box((740, 740, 340)), box(ROOM, inward=True)),
    ],
    ids=["seen from within", "without a ceiling", "an open box", "walls of 20 cm"],
)
def test_a_room_is_free_inside_and_its_walls_are_where_they_were(room: trimesh.Trimesh) -> None:
    found = made(room)
    assert (depth(found, INSIDE) < 1).all()
    walls = np.array([[350.0, 0, 0], [-350, 10, 20], [0, 350, 0], [0, -350, 0], [0, 0, -150]])
    assert (depth(found, walls) > -0.05).all()
    assert 5 <= len(found) <= 24


def test_what_is_missing_below_is_no_opening_and_what_is_missing_above_is() -> None:
    middle = np.zeros((1, 3))
    assert len(made(box((60, 60, 60), without=(0, 0, -1)))) == 1
    assert depth(made(box((60, 60, 60), without=(0, 0, -1))), middle) > 29
    assert depth(made(box((60, 60, 60), without=(0, 0, 1))), middle) < 0
    canopy = joined(box((300, 300, 60), (0, 0, 270), without=(0, 0, -1)), box((10, 10, 240), (0, 0, 120)))
    assert depth(made(canopy), np.array([[100.0, 0, 250]])) < 0


def table(height: float = 72) -> trimesh.Trimesh:
    """A table top on four legs, each a piece of its own."""
    legs = [box((6, 6, height - 2), (x, y, height / 2 - 1)) for x in (-60, 60) for y in (-30, 30)]
    return joined(box((130, 70, 4), (0, 0, height)), *legs)


def test_what_stands_under_a_table_is_free_and_its_top_is_not() -> None:
    found = made(table())
    assert depth(found, np.array([[0.0, 0, 35], [40, 0, 60]])).max() < 0
    assert depth(found, np.array([[0.0, 0, 72]])) > 1.5


def test_a_frame_of_one_piece_is_cut_and_a_second_time_taken_from_the_cache(tmp_path: Path) -> None:
    frame = trimesh.creation.annulus(r_min=60, r_max=75, height=20)
    mesh = np.asarray(frame.vertices, float), np.asarray(frame.faces, np.int64)
    first = automatic(*mesh, tmp_path)
    assert first.parts and 4 <= len(first.bodies) <= 32
    assert depth(first.bodies, np.zeros((1, 3))) < -30
    kept = {path: path.stat().st_mtime_ns for path in tmp_path.iterdir()}
    assert len(kept) == 1
    assert [one.tolist() for one in automatic(*mesh, tmp_path).bodies] == [one.tolist() for one in first.bodies]
    assert {path: path.stat().st_mtime_ns for path in tmp_path.iterdir()} == kept


def test_a_piece_that_cannot_be_cut_becomes_panels_and_is_named(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    frame = trimesh.creation.annulus(r_min=60, r_max=75, height=20)
    monkeypatch.setattr(sys, "executable", "/bin/false")
    found = automatic(np.asarray(frame.vertices, float), np.asarray(frame.faces, np.int64), tmp_path)
    assert found.parts and len(found.bodies) > 3 and "could not be cut" in found.notes[0]
    assert depth(found.bodies, np.array([[0.0, 0, 0], [30, 0, 9.8]])).max() < -5
    assert not list(tmp_path.iterdir())


def test_a_panel_lies_behind_the_side_that_its_triangles_face() -> None:
    floor = trimesh.Trimesh([[0, 0, 0], [400, 0, 0], [400, 300, 0], [0, 300, 0]], [[0, 1, 2], [0, 2, 3]], process=False)
    (panel,) = made(floor)
    assert panel[:, 2].max() == 0 and panel[:, 2].min() == pytest.approx(-THICK_CM)
    both = trimesh.Trimesh(floor.vertices, [*floor.faces, *np.asarray(floor.faces)[:, ::-1]], process=False)
    (panel,) = made(both)
    assert (panel[:, 2].min(), panel[:, 2].max()) == pytest.approx((-THICK_CM / 2, THICK_CM / 2))


def test_a_wall_with_a_door_leaves_the_door_open() -> None:
    from shapely import box as rectangle
    from shapely import constrained_delaunay_triangles

    outline = rectangle(0, 0, 500, 300) - rectangle(200, 0, 290, 210)
    triangles = [np.array(one.exterior.coords)[:3] for one in constrained_delaunay_triangles(outline).geoms]
    corners = np.concatenate(triangles)
    wall = trimesh.Trimesh(
        np.column_stack([corners[:, 0], np.zeros(len(corners)), corners[:, 1]]),
        np.arange(len(corners)).reshape(-1, 3),
        process=False,
    )
    found = made(wall)
    assert len(found) <= 5
    assert depth(found, np.array([[245.0, 0, 100]])) < -1
    assert (depth(found, np.array([[100.0, 0, 100], [245, 0, 250], [400, 0, 20]])) > -0.5).all()


def test_pieces_beyond_the_limit_are_merged_with_their_neighbours_and_never_with_all() -> None:
    chance = np.random.default_rng(2)
    crates = [box((4, 4, 4), at) for at in chance.uniform(-2000, 2000, (HARD_LIMIT + 700, 3))]
    mesh = joined(*crates)
    found = [
        np.array(one.vertices) for one in bodies([("", np.asarray(mesh.vertices), np.asarray(mesh.faces))], "piece")
    ]
    assert len(found) <= HARD_LIMIT + 700
    assert max(np.ptp(one, axis=0).max() for one in found) < 1200


HOSTILE: dict[str, trimesh.Trimesh] = {
    "a triangle": trimesh.Trimesh([[0, 0, 0], [100, 0, 0], [0, 100, 0]], [[0, 1, 2]], process=False),
    "no area": trimesh.Trimesh([[0, 0, 0], [100, 0, 0], [200, 0, 0]], [[0, 1, 2]], process=False),
    "a needle": box((0.001, 0.001, 500)),
    "inside out": box((30, 30, 30), inward=True),
    "three faces at an edge": trimesh.Trimesh(
        [[0, 0, 0], [0, 0, 50], [50, 0, 0], [0, 50, 0], [-50, -50, 0]], [[0, 1, 2], [0, 1, 3], [0, 1, 4]], process=False
    ),
    "crossing itself": joined(box((50, 50, 50)), box((50, 50, 50), (20, 20, 20))),
    "touching": joined(box((50, 50, 50)), box((50, 50, 50), (50, 0, 0))),
    "a face thrice": trimesh.Trimesh(
        [[0, 0, 0], [100, 0, 0], [0, 100, 0]], [[0, 1, 2], [0, 1, 2], [2, 1, 0]], process=False
    ),
}


@pytest.mark.parametrize("name", HOSTILE)
def test_odd_meshes_have_bodies_near_them(name: str) -> None:
    mesh = HOSTILE[name]
    found = made(mesh)
    corners = np.concatenate(found)
    assert found and np.isfinite(corners).all()
    assert (corners.min(axis=0) >= np.asarray(mesh.vertices).min(axis=0) - 1).all()
    assert (corners.max(axis=0) <= np.asarray(mesh.vertices).max(axis=0) + 1).all()
    assert [one.tolist() for one in made(mesh)] == [one.tolist() for one in found]


@settings(max_examples=40, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(
    st.lists(st.tuples(*[st.floats(-150, 150)] * 3, *[st.floats(10, 120)] * 3), min_size=1, max_size=6),
    st.floats(0, 360),
)
def test_bodies_hold_every_corner_of_watertight_pieces_and_little_else(
    crates: list[tuple[float, ...]], turn: float
) -> None:
    mesh = joined(*[box(row[3:], row[:3]) for row in crates])
    mesh.apply_transform(trimesh.transformations.rotation_matrix(np.radians(turn), [0.2, 0.3, 1]))
    found = made(mesh)
    assert (depth(found, np.asarray(mesh.vertices)) > -1).all()
    # each merge may fill GAP_CM on average over its surface, and crates that overlap count twice in the sum
    held = sum(float(ConvexHull(one).volume) for one in found)
    own = float(np.prod([row[3:] for row in crates], axis=1).sum())
    assert held <= 1.6 * own


@settings(max_examples=40, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(st.tuples(*[st.floats(120, 900)] * 3), st.tuples(*[st.floats(0.05, 0.95)] * 3), st.floats(0, 360), st.booleans())
def test_what_is_put_in_an_open_box_meets_nothing_but_its_walls(
    size: tuple[float, float, float], where: tuple[float, float, float], turn: float, inward: bool
) -> None:
    mesh = box(size, inward=inward, without=(0, 0, 1))
    half, thing = np.array(size) / 2, 15.0
    middle = -half + thing + 2 + np.array(where) * (2 * half - 2 * thing - 4)
    cube = middle + thing * np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])
    matrix = trimesh.transformations.rotation_matrix(np.radians(turn), [0, 0, 1])
    mesh.apply_transform(matrix)
    assert (depth(made(mesh), trimesh.transformations.transform_points(cube, matrix)) < 0).all()
