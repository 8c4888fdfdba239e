"""What pixels say of an actor's colour, and that damaged pictures and masks are refused by name."""

from __future__ import annotations

import io
import json
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from c4s.errors import BadInput
from c4s.judge.paired.measures import mask_of
from c4s.judge.rule.pixels import ActorColors
from c4s.records.evidence import Evidence

SIDE = 100
RED, DARK_GLASS, GREY, WHITE = (170, 20, 15), (25, 35, 70), (120, 120, 120), (240, 240, 240)
Paint = dict[tuple[int, int, int], int]
"""Colours with the percent of the actor's pixels that have them."""


def evidence(root: Path, paint: Paint, mask_side: int = SIDE) -> Evidence:
    """One view that a car fills."""
    folder = root / "captures"
    folder.mkdir(parents=True)
    rows = np.concatenate([np.tile(np.array(color, dtype=np.uint8), (percent, 1)) for color, percent in paint.items()])
    Image.fromarray(np.repeat(rows[:, None], SIDE, axis=1)).save(folder / "view.png", "PNG")
    owners, depth = np.zeros((mask_side, mask_side), dtype=np.int32), np.full((mask_side, mask_side), 500.0)
    np.savez_compressed(folder / "view.npz", actor=owners, depth_cm=depth, names=np.array(["Car"]))
    view = {"name": "view", "file": "view.png", "actors": "view.npz", "visible": {"Car": SIDE * SIDE}}
    (folder / "captures.json").write_text(json.dumps({"views": [view]}))
    return Evidence(setting="text-to-scene", prompt="A car.", files={"captures": folder / "captures.json"})


@pytest.mark.parametrize(
    ("paint", "words", "shown"),
    [
        ({RED: 60, DARK_GLASS: 40}, "red", True),
        ({RED: 60, DARK_GLASS: 40}, "blue", None),
        ({DARK_GLASS: 60, RED: 40}, "blue", True),
        ({WHITE: 70, RED: 30}, "red", None),
        ({WHITE: 70, RED: 30}, "white", True),
        ({RED: 35, GREY: 15, DARK_GLASS: 20, WHITE: 15, (150, 140, 20): 15}, "red", True),
        ({RED: 98, DARK_GLASS: 2}, "blue", False),
        ({RED: 60, DARK_GLASS: 40}, "red or blue", None),
    ],
)
def test_a_colour_is_that_of_most_pixels(tmp_path: Path, paint: Paint, words: str, shown: bool | None) -> None:
    assert ActorColors(evidence(tmp_path, paint)).shows("Car", words) is shown


def test_what_no_picture_shows_has_no_colour(tmp_path: Path) -> None:
    assert ActorColors(evidence(tmp_path, {RED: 100})).shows("Cart", "red") is None


@pytest.mark.parametrize("part", ["view.png", "view.npz"])
def test_damaged_pictures_and_masks_are_bad_input(tmp_path: Path, part: str) -> None:
    given = evidence(tmp_path, {RED: 60, DARK_GLASS: 40})
    whole = (tmp_path / "captures" / part).read_bytes()
    for cut in range(0, len(whole) // 2, max(1, len(whole) // 40)):
        (tmp_path / "captures" / part).write_bytes(whole[:cut])
        with pytest.raises(BadInput, match=r"picture|actor mask"):
            ActorColors(given).shows("Car", "red")


def test_a_mask_with_a_changed_byte_is_read_or_is_bad_input() -> None:
    written = io.BytesIO()
    rng = np.random.default_rng(0)
    np.savez_compressed(written, actor=rng.integers(0, 9, (64, 64)), depth_cm=rng.random((64, 64)))
    whole, refused = written.getvalue(), 0
    for place in range(0, len(whole), 97):
        changed = bytearray(whole)
        changed[place] ^= 16
        try:
            mask_of(bytes(changed), "mask")
        except BadInput:
            refused += 1
    assert refused


def test_a_mask_of_another_size_is_bad_input(tmp_path: Path) -> None:
    with pytest.raises(BadInput, match="one size"):
        ActorColors(evidence(tmp_path, {RED: 100}, mask_side=50)).shows("Car", "red")
