"""Small procedural textures with fixed seeds. Every function gives an sRGB picture (H, W, 3) that repeats."""

from __future__ import annotations

import io
from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray
from PIL import Image

Pixels = NDArray[np.uint8]
Texture = Callable[[], Pixels]
Rgb = tuple[int, int, int]
SIZE = 128


def png(pixels: Pixels) -> bytes:
    """PNG bytes of a picture."""
    out = io.BytesIO()
    Image.fromarray(pixels).save(out, format="PNG", optimize=False)
    return out.getvalue()


def _noise(rng: np.random.Generator, rows: int, columns: int, size: int = SIZE) -> NDArray[np.float64]:
    """Smooth periodic noise in [-1, 1] with ``rows`` x ``columns`` cells."""
    grid = rng.uniform(-1, 1, (rows, columns))
    y, x = np.arange(size) * rows / size, np.arange(size) * columns / size
    fy, fx = y % 1, x % 1
    fy, fx = fy * fy * (3 - 2 * fy), fx * fx * (3 - 2 * fx)
    y0, x0 = y.astype(int) % rows, x.astype(int) % columns
    y1, x1 = (y0 + 1) % rows, (x0 + 1) % columns
    top = grid[np.ix_(y0, x0)] * (1 - fx) + grid[np.ix_(y0, x1)] * fx
    bottom = grid[np.ix_(y1, x0)] * (1 - fx) + grid[np.ix_(y1, x1)] * fx
    mixed: NDArray[np.float64] = top * (1 - fy[:, None]) + bottom * fy[:, None]
    return mixed


def _tinted(color: Rgb, shade: NDArray[np.float64]) -> Pixels:
    """A colour times ``1 + shade`` a pixel."""
    return np.clip(np.array(color) * (1 + shade[..., None]) + 0.5, 0, 255).astype(np.uint8)


def wood(color: Rgb, seed: int, *, strength: float = 0.14) -> Texture:
    """Wood grain along u."""

    def make() -> Pixels:
        rng = np.random.default_rng(seed)
        grain = _noise(rng, 32, 2) + 0.6 * _noise(rng, 64, 4) + 0.3 * rng.uniform(-1, 1, (SIZE, 1))
        return _tinted(color, strength * grain / 1.4)

    return make


def planks(color: Rgb, seed: int, *, rows: int = 6) -> Texture:
    """Floor boards along u with dark joints."""

    def make() -> Pixels:
        rng = np.random.default_rng(seed)
        shade = 0.10 * _noise(rng, 64, 3) + 0.05 * _noise(rng, 128, 8)
        height = SIZE / rows
        for row in range(rows):
            a, b = round(row * height), round((row + 1) * height)
            cut = int(rng.integers(10, SIZE - 10))
            shade[a:b, :cut] += rng.uniform(-0.09, 0.09)
            shade[a:b, cut:] += rng.uniform(-0.09, 0.09)
            shade[a:b, cut] -= 0.25
            shade[a] -= 0.25
        return _tinted(color, shade)

    return make


def bricks(color: Rgb, mortar: Rgb, seed: int, *, rows: int = 8, columns: int = 4) -> Texture:
    """Running-bond masonry."""

    def make() -> Pixels:
        rng = np.random.default_rng(seed)
        picture = np.empty((SIZE, SIZE, 3))
        picture[:] = mortar
        height, width = SIZE // rows, SIZE // columns
        for row in range(rows):
            for column in range(columns):
                tone = np.array(color) * (1 + rng.uniform(-0.15, 0.15))
                start = column * width + (row % 2) * width // 2
                across = np.arange(start + 1, start + width - 1) % SIZE
                picture[row * height + 1 : (row + 1) * height - 1, across] = tone
        picture *= 1 + 0.06 * rng.uniform(-1, 1, (SIZE, SIZE, 1))
        return np.clip(picture, 0, 255).astype(np.uint8)

    return make


def tiles(
    color: Rgb, joint: Rgb, seed: int, *, count: int = 4, variation: float = 0.03, second: Rgb | None = None
) -> Texture:
    """Square tiles, in two colours like a chessboard when ``second`` is given."""

    def make() -> Pixels:
        rng = np.random.default_rng(seed)
        picture = np.empty((SIZE, SIZE, 3))
        picture[:] = joint
        side = SIZE // count
        for row in range(count):
            for column in range(count):
                base = second if second is not None and (row + column) % 2 else color
                tone = np.array(base) * (1 + rng.uniform(-variation, variation))
                picture[row * side + 1 : (row + 1) * side - 1, column * side + 1 : (column + 1) * side - 1] = tone
        picture *= 1 + 0.02 * rng.uniform(-1, 1, (SIZE, SIZE, 1))
        return np.clip(picture, 0, 255).astype(np.uint8)

    return make


def fabric(color: Rgb, seed: int) -> Texture:
    """A woven cloth."""

    def make() -> Pixels:
        rng = np.random.default_rng(seed)
        y, x = np.mgrid[0:SIZE, 0:SIZE]
        weave = 0.07 * np.where((x // 2 + y // 2) % 2, 1, -1) + 0.05 * rng.uniform(-1, 1, (SIZE, SIZE))
        return _tinted(color, weave + 0.04 * _noise(rng, 6, 6))

    return make


def mottled(color: Rgb, seed: int, *, strength: float = 0.06, fine: float = 0.03, cells: int = 8) -> Texture:
    """Plaster, concrete, carpet, soil, grass or leaves, by strength and fineness."""

    def make() -> Pixels:
        rng = np.random.default_rng(seed)
        return _tinted(
            color,
            strength * _noise(rng, cells, cells)
            + 0.5 * strength * _noise(rng, 4 * cells, 4 * cells)
            + fine * rng.uniform(-1, 1, (SIZE, SIZE)),
        )

    return make


def stripes(colors: Sequence[Rgb], seed: int, *, upright: bool = False) -> Texture:
    """Stripes of equal width."""

    def make() -> Pixels:
        rng = np.random.default_rng(seed)
        index = np.arange(SIZE) * len(colors) // SIZE
        line = np.array(colors, dtype=float)[index]
        picture = np.broadcast_to(line[None] if upright else line[:, None], (SIZE, SIZE, 3))
        return np.clip(picture * (1 + 0.05 * rng.uniform(-1, 1, (SIZE, SIZE, 1))), 0, 255).astype(np.uint8)

    return make


def carpet(field: Rgb, border: Rgb, accent: Rgb, seed: int) -> Texture:
    """A rug with a border and diamonds."""

    def make() -> Pixels:
        rng = np.random.default_rng(seed)
        y, x = np.mgrid[0:SIZE, 0:SIZE]
        edge = np.minimum(np.minimum(x, SIZE - 1 - x), np.minimum(y, SIZE - 1 - y))
        picture = np.empty((SIZE, SIZE, 3))
        picture[:] = field
        diamond = np.abs((x % 32) - 16) + np.abs((y % 32) - 16)
        picture[(diamond > 8) & (diamond < 12)] = accent
        picture[edge < 14] = border
        picture[(edge >= 5) & (edge < 8)] = accent
        return np.clip(picture * (1 + 0.08 * rng.uniform(-1, 1, (SIZE, SIZE, 1))), 0, 255).astype(np.uint8)

    return make


def screen(
    seed: int, *, background: Rgb = (24, 34, 58), bars: Sequence[Rgb] = ((90, 160, 230), (230, 180, 80))
) -> Texture:
    """A monitor picture: a title bar, a side bar and lines of writing."""

    def make() -> Pixels:
        rng = np.random.default_rng(seed)
        picture = np.empty((SIZE, SIZE, 3), np.uint8)
        picture[:] = background
        picture[:8] = bars[0]
        picture[8:, :22] = (np.array(background) * 1.5).clip(0, 255)
        for row in range(14, SIZE - 6, 7):
            start = 28 + 6 * int(rng.integers(0, 4))
            length = int(rng.integers(15, 70))
            picture[row : row + 3, start : min(start + length, SIZE - 4)] = bars[int(rng.integers(len(bars)))]
        return picture

    return make


def painting(seed: int, *, sky: Rgb = (150, 190, 225), hills: Sequence[Rgb] = ((80, 120, 90), (60, 90, 70))) -> Texture:
    """A landscape for a picture frame."""

    def make() -> Pixels:
        rng = np.random.default_rng(seed)
        y = np.linspace(0, 1, SIZE)[:, None, None]
        picture = np.broadcast_to(np.array(sky) * (1.1 - 0.4 * y), (SIZE, SIZE, 3)).copy()
        sun = (np.mgrid[0:SIZE, 0:SIZE][0] - 30) ** 2 + (np.mgrid[0:SIZE, 0:SIZE][1] - 88) ** 2 < 150
        picture[sun] = (250, 235, 180)
        for level, color in enumerate(hills):
            phase, waves = rng.uniform(0, 6), rng.uniform(1, 2.5)
            ridge = 60 + 22 * level + 12 * np.sin(np.linspace(0, 2 * np.pi * waves, SIZE) + phase)
            picture[np.arange(SIZE)[:, None] > ridge[None]] = color
        return np.clip(picture, 0, 255).astype(np.uint8)

    return make
