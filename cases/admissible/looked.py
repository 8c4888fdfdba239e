"""A pair of pictures from one reference camera, of the original and of the start scene, with who each pixel shows."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from c4s.render import Picture
from c4s.render.masks import mask_name

Colours = NDArray[np.uint8]
Mask = NDArray[np.int64]

FULL = 1280 * 720
"""Pixels of the picture in which sizes are told, whatever the size of a view."""
SEEN_STEP = 12
"""Two colours that differ by this much in one of their three channels (of 255) can be told apart."""

LEAST_DEPTH_CM, DEPTH_STEP = 1.0, 0.003
"""Two depths that differ by both, the second as a share of the nearer one, are of two shapes."""


@dataclass(frozen=True)
class Seen:
    """(H, W, 3) colours, (H, W) rows of ``names`` (-1 where nothing is shown), (H, W) depth in cm."""

    colours: Colours
    mask: Mask
    depth_cm: NDArray[np.float32]
    names: list[str]

    def where(self, name: str) -> NDArray[np.bool_]:
        """Where an actor is seen."""
        if name not in self.names:
            return np.zeros(self.mask.shape, dtype=bool)
        found: NDArray[np.bool_] = self.mask == self.names.index(name)
        return found


@dataclass(frozen=True)
class Looked:
    """What one reference camera sees of the original and of the start scene."""

    view: str
    truth: Seen
    start: Seen

    @cached_property
    def _per_pixel(self) -> float:
        """How many pixels of a picture of 1280 x 720 one of these stands for."""
        return FULL / self.start.mask.size

    @cached_property
    def _differs(self) -> NDArray[np.bool_]:
        apart = np.abs(self.truth.colours.astype(np.int16) - self.start.colours.astype(np.int16)).max(axis=2)
        found: NDArray[np.bool_] = apart >= SEEN_STEP
        return found

    def pixels(self, name: str, *, start: bool = False) -> int:
        """Pixels of a 1280 x 720 picture that show an actor in the original, or in the start scene."""
        return round(float((self.start if start else self.truth).where(name).sum()) * self._per_pixel)

    def displaced(self, was: str, now: str) -> tuple[float, int]:
        """Share of the pixels that show an actor before or after that show it only once; and how many those are."""
        before, after = self.truth.where(was), self.start.where(now)
        count, once = int((before | after).sum()), int((before ^ after).sum())
        return (once / count if count else 0.0), round(once * self._per_pixel)

    def reshaped(self, was: str, now: str) -> tuple[float, int]:
        """As ``displaced``, of pixels that show it only once or at another depth: none of what is round and turned."""
        before, after = self.truth.where(was), self.start.where(now)
        count = int((before | after).sum())
        both = before & after
        first, second = self.truth.depth_cm[both], self.start.depth_cm[both]
        apart = np.abs(first - second) > np.maximum(LEAST_DEPTH_CM, DEPTH_STEP * np.minimum(first, second))
        other = int((before ^ after).sum() + apart.sum())
        return (other / count if count else 0.0), round(other * self._per_pixel)

    def changed(self, was: str, now: str) -> tuple[float, int]:
        """Share of an actor's own pixels, before and after together, that look different; and how many those are."""
        own = self.truth.where(was) | self.start.where(now)
        count = int(own.sum())
        different = int((own & self._differs).sum())
        return (different / count if count else 0.0), round(different * self._per_pixel)


def looked_at(view: str, truth: Path, start: Path) -> Looked:
    """Read a pair of pictures of one shape and the masks beside them, at the size of the smaller one."""
    sizes = []
    for picture in (truth, start):
        with Image.open(picture) as opened:
            sizes.append(opened.size)
    size = min(sizes)
    return Looked(view, _read(truth, size), _read(start, size))


def _read(picture: Path, size: tuple[int, int]) -> Seen:
    with Image.open(picture) as opened:
        colours = np.asarray(opened.convert("RGB").resize(size, Image.Resampling.BOX), dtype=np.uint8)
    with np.load(picture.with_name(mask_name(picture.stem)), allow_pickle=False) as tables:
        actor, depth = tables["actor"].astype(np.int64), tables["depth_cm"]
        names = [str(name) for name in tables["names"]]
    width, height = size
    rows = (np.arange(height) + 0.5) * actor.shape[0] / height
    columns = (np.arange(width) + 0.5) * actor.shape[1] / width
    chosen = (rows.astype(int)[:, None], columns.astype(int)[None, :])
    return Seen(colours, actor[chosen], depth[chosen], names)


def seen_by(picture: Picture, names: Sequence[str]) -> Seen:
    """What a picture shows of actors, ``names`` being those that its mask counts."""
    return Seen(picture.rgb, picture.actor.astype(np.int64), picture.depth_cm.astype(np.float32), list(names))


class Glanced(Looked):
    """What a reference camera sees without light: what looks different is told by shape alone."""

    def changed(self, was: str, now: str) -> tuple[float, int]:
        """As ``reshaped``."""
        return self.reshaped(was, now)
