"""In scenes that people made nearly nothing penetrates that its triangles do not."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import trimesh

from bench.mesh_truth import penetrates, welded
from bench.penetration import PenetrationRow, of_file
from tests.shared import SHARED

SCENES = SHARED / "assets/scenes"
MOST_FALSE = 0.02
here = pytest.mark.skipif(not SCENES.is_dir(), reason="the shared sample scenes are not here")


@here
@pytest.mark.parametrize(
    ("file", "actors", "said"),
    [("osrf-servicesim-office/worlds/example.world", 290, 30), ("kenney-city-builder-sample/instances.csv", 120, 0)],
    ids=["office", "city"],
)
def test_few_actors_of_a_scene_penetrate_falsely(
    file: str, actors: int, said: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("C4S_HOME", str(tmp_path))
    found: PenetrationRow = of_file(SCENES / file, "auto", misses=True)
    assert found.actors >= actors and found.said >= said
    assert found.rate <= MOST_FALSE, found.pairs
    assert found.missed is not None and found.missed <= 2


def _box(size: tuple[float, float, float], at: tuple[float, float, float] = (0, 0, 0)) -> trimesh.Trimesh:
    return trimesh.creation.box(extents=size, transform=trimesh.transformations.translation_matrix(at))


@pytest.mark.parametrize(
    ("other", "deep"),
    [
        (_box((20, 20, 20), (55, 0, 0)), True),
        (_box((20, 20, 20), (56, 0, 0)), False),
        (_box((20, 20, 20), (60, 0, 0)), False),
        (_box((20, 20, 20)), True),
        (_box((4, 200, 4)), True),
        (_box((20, 20, 20), (90, 0, 0)), False),
    ],
    ids=["5.1 cm", "4 cm", "flush", "within", "a rod right through", "apart"],
)
def test_the_ground_truth_knows_boxes(other: trimesh.Trimesh, deep: bool) -> None:
    crate = _box((100.2, 100.2, 100.2))
    one, two = (welded(np.asarray(mesh.vertices), np.asarray(mesh.faces, np.int64)) for mesh in (crate, other))
    assert penetrates(one, two, 5.0) is penetrates(two, one, 5.0) is deep


def test_an_open_box_holds_a_thing_and_a_closed_one_swallows_it() -> None:
    closed = _box((100, 100, 100))
    open_faces = np.asarray(closed.faces)[np.asarray(closed.face_normals)[:, 2] < 0.9]
    thing = welded(*(np.asarray(a) for a in (_box((20, 20, 20)).vertices, _box((20, 20, 20)).faces)))
    assert penetrates(welded(np.asarray(closed.vertices), np.asarray(closed.faces, np.int64)), thing, 5.0)
    assert not penetrates(welded(np.asarray(closed.vertices), open_faces.astype(np.int64)), thing, 5.0)
