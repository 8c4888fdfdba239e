"""The files of a picture: a PNG that any reader opens, and depths rounded to what a mask keeps."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from c4s.render import Picture
from c4s.render.masks import write_mask
from c4s.render.png import write_png


@pytest.mark.parametrize("size", [(1, 1), (1, 7), (5, 1), (33, 20)])
def test_a_png_is_read_back_as_it_was(tmp_path: Path, size: tuple[int, int]) -> None:
    rgb = np.random.default_rng(1).integers(0, 256, (*size, 3), dtype=np.uint8)
    write_png(tmp_path / "a.png", rgb)
    with Image.open(tmp_path / "a.png") as picture:
        assert (picture.format, picture.mode) == ("PNG", "RGB")
        assert (np.asarray(picture) == rgb).all()


def test_a_mask_keeps_every_actor_and_sixteen_bits_of_each_depth(tmp_path: Path) -> None:
    depth = np.random.default_rng(2).uniform(1.0, 1e5, (40, 30)).astype(np.float32)
    depth[0, 0], depth[0, 1] = np.inf, 0.0
    actor = np.arange(-1, 1199, dtype=np.int32).reshape(40, 30)
    write_mask(tmp_path / "a.actors.npz", Picture(np.zeros((40, 30, 3), np.uint8), actor, depth), ["a"], ["A"])
    with np.load(tmp_path / "a.actors.npz") as kept:
        assert kept["depth_cm"].dtype == np.float32
        assert (kept["actor"] == actor).all()
        assert kept["depth_cm"][0, 0] == np.inf
        assert kept["depth_cm"] == pytest.approx(depth, rel=2.0**-17)
        assert not (kept["depth_cm"].view(np.uint32) & 127).any()
