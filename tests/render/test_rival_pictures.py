"""What rivals of our pictures are given, how many samples they are asked for, and what is said when there are none."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import pytest

from bench import rival_pictures
from bench.rival_pictures import COUNTS, by_material, fewest, rivals, shrunk, table
from c4s.geometry.transform import affine
from c4s.packs.meshes import Mesh
from c4s.render import Instance, SurfaceMaterial


def _triangle() -> Mesh:
    corners = np.array([[0, 0, 0], [100, 0, 0], [0, 100, 0]], np.float32)
    up = np.tile(np.array([0, 0, 1], np.float32), (3, 1))
    return Mesh(corners, np.array([[0, 1, 2]], np.int32), up, corners[:, :2] / 100, np.zeros(1, np.int32))


def test_triangles_are_placed_in_right_handed_metres_by_material() -> None:
    red, glass = SurfaceMaterial((1.0, 0.0, 0.0)), SurfaceMaterial(opacity=0.5)
    places = [
        Instance(0, affine((0, 200, 0), (0, 0, 0), (1, 1, 1)), (red,), 0),
        Instance(0, affine((0, 0, 300), (0, 0, 0), (2, 2, 2)), (red,), 1),
        Instance(0, affine((0, 0, 0), (0, 0, 0), (1, 1, 1)), (glass,), 2),
    ]
    ((material, arrays),) = by_material([_triangle()], places)
    assert material is red
    first, second = arrays["points"].reshape(2, 3, 3)
    assert np.allclose(first, [[0, -3, 0], [1, -2, 0], [0, -2, 0]])
    assert np.allclose(second, [[0, -2, 3], [2, 0, 3], [0, 0, 3]])
    assert np.allclose(arrays["normals"], [0, 0, 1])
    assert arrays["uvs"].tolist() == [[0, 1], [1, 0], [0, 0]] * 2
    for corners in (first, second):
        assert np.cross(corners[1] - corners[0], corners[2] - corners[0])[2] > 0


@pytest.mark.parametrize("enough", COUNTS)
def test_a_rival_takes_the_fewest_samples_that_are_enough(enough: int) -> None:
    rng = np.random.default_rng(1)
    reference = rng.uniform(0.1, 0.9, (32, 32, 3)).astype(np.float32)
    noise = rng.uniform(0, 0.5, reference.shape).astype(np.float32)
    asked: list[int] = []

    def take(samples: int) -> tuple[np.ndarray, float]:
        asked.append(samples)
        return (reference if samples >= enough else noise), samples * 0.5

    trial, picture = fewest("rival", 0.99, take, reference, float(reference.mean()))
    assert (trial.samples, trial.cpu_seconds, trial.enough) == (enough, enough * 0.5, True)
    assert len(asked) <= 4
    assert np.abs(picture.astype(int) - rival_pictures.developed(reference, 1.0)).max() <= 1


def test_a_rival_that_is_never_like_itself_is_told_with_its_most_samples() -> None:
    flat = np.full((32, 32, 3), 0.5, np.float32)
    noise = np.random.default_rng(2).uniform(0, 1, flat.shape).astype(np.float32)
    trial, _ = fewest("rival", 0.99, lambda samples: (noise, 1.0), flat, 0.5)
    assert (trial.samples, trial.enough) == (COUNTS[-1], False)
    assert "(less than ours)" in table([trial])


def test_a_finer_picture_is_averaged_in_linear_light() -> None:
    squares = np.zeros((4, 4, 3), np.uint8)
    squares[::2, ::2] = squares[1::2, 1::2] = 255
    assert np.allclose(shrunk(squares, 2), 0.5)


def test_no_rival_is_one_line_each(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    bare = tmp_path / "python"
    bare.write_text(f'#!/bin/sh\nexec {sys.executable} -S -I "$@"\n')
    bare.chmod(0o755)
    assert rivals(str(bare), None, tmp_path) == []
    assert capsys.readouterr().err.splitlines() == [
        f"{bare} has no package mitsuba: not compared (--mitsuba PYTHON)",
        "blender is not on the search path: not compared (--blender PROGRAM)",
    ]


def test_a_rival_that_is_there_is_started_with_the_scene(tmp_path: Path) -> None:
    found = rivals(None, sys.executable, tmp_path)
    names = [name for name, _ in found if name.startswith("cycles")]
    assert names == ["cycles plain", "cycles denoised"]
    assert found[-1][1] == [sys.executable, str(tmp_path / "in_blender.py"), "--", str(tmp_path), "denoised"]
    assert "CYCLES" in (tmp_path / "in_blender.py").read_text()
