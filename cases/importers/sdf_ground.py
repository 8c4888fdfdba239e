"""Ground of SDF: heightmaps and roads as surfaces with bodies that carry what stands on them. Metres, Z up.

A body of the ground is a slab under a piece of the surface that is as good as flat; a heightmap is cut into such
pieces, the fewer the flatter it is, so that what is seen and what carries agree to ``FLAT_CM``, or as near as
``MOST_SLABS`` allow.
"""

from __future__ import annotations

from pathlib import Path
from xml.etree.ElementTree import Element

import numpy as np
from numpy.typing import NDArray
from PIL import UnidentifiedImageError

from c4s.errors import BadInput
from c4s.packs.pictures import open_picture
from c4s.records.pack import HullBody
from cases.importers.sdf_frames import Matrix, numbers
from catalog.ingest.hulls import hull
from catalog.ingest.surface import SourcePart, Surface

MOST_SAMPLES = 257
"""A heightmap is read at most this many times a side."""
FLAT_CM, MOST_SLABS = 1.0, 2048
SLAB_CM = 4.0
"""How thick a road is: what overlaps another road sinks no deeper than the penetration rule bears."""
EARTH_CM = 50.0
"""How thick the ground under a heightmap is at its least."""
MITRE = 2.0
"""A corner of a road reaches out at most this many times its half width."""
PIXEL_SCALE_TAG = 33550
"""GeoTIFF's ModelPixelScale: the size of a pixel."""


def heights(element: Element, file: Path) -> tuple[Matrix, Matrix, Matrix]:
    """Heights (rows from the far side, +Y, to the near one), size and offset of a heightmap; metres.

    The brightest pixel of a picture stands ``size`` z high, black at nothing (Gazebo's reading). A TIFF of floating
    numbers (a DEM) has heights in metres above its lowest, and its own size where none is written.
    """
    try:
        picture = open_picture(file, where=str(file))
        picture.load()
        floating = picture.mode == "F"
        scale = getattr(picture, "tag_v2", {}).get(PIXEL_SCALE_TAG)
        levels = np.asarray(picture if picture.mode in ("F", "I", "I;16", "L") else picture.convert("L"), float)
    except (UnidentifiedImageError, OSError, ValueError, SyntaxError) as error:
        raise BadInput(f"this heightmap cannot be read: {error}", where=str(file)) from None
    if levels.ndim != 2 or min(levels.shape) < 2:
        raise BadInput("a heightmap needs at least 2 x 2 pixels", where=str(file))
    offset = np.asarray(numbers(element.findtext("pos"), 3))
    written = element.findtext("size")
    if floating:
        levels = np.where(np.isfinite(levels) & (np.abs(levels) < 1e5), levels, np.nan)
        if np.isnan(levels).all():
            raise BadInput("a heightmap without heights", where=str(file))
        levels = np.nan_to_num(levels - np.nanmin(levels))
        if not (written or "").split():
            if scale is None or min(scale[:2]) < 0.01:
                raise BadInput("this heightmap does not tell its size in metres", where=str(file))
            across = [scale[0] * (levels.shape[1] - 1), scale[1] * (levels.shape[0] - 1)]
            return _sampled(levels), np.array([*across, float(levels.max())]), offset
    size = np.asarray(numbers(written, 3, 1.0))
    if min(size[:2]) <= 0:
        raise BadInput("a heightmap is scaled to nothing", where=str(file))
    return _sampled(levels / max(float(levels.max()), 1e-12) * size[2]), size, offset


def _sampled(levels: Matrix) -> Matrix:
    """At most ``MOST_SAMPLES`` values a side, the four edges among them."""
    rows, columns = (
        np.unique(np.round(np.linspace(0, count - 1, min(count, MOST_SAMPLES))).astype(int)) for count in levels.shape
    )
    kept: Matrix = levels[np.ix_(rows, columns)]
    return kept


def terrain(levels: Matrix, size: Matrix, offset: Matrix, surface: Surface, repeat_m: float) -> SourcePart:
    """A heightmap as a part in cm and Unreal's axes; its texture repeats every ``repeat_m`` metres (0: once)."""
    points = _grid(levels, size, offset)
    rows, columns = levels.shape
    corner = np.arange(rows * columns).reshape(rows, columns)
    a, b, c, d = corner[:-1, :-1].ravel(), corner[:-1, 1:].ravel(), corner[1:, 1:].ravel(), corner[1:, :-1].ravel()
    faces = np.concatenate([np.stack([d, c, b], axis=1), np.stack([d, b, a], axis=1)])
    place = (points[:, :2] - points[:, :2].min(axis=0)) / (repeat_m or size[:2])
    return _shown("terrain", points, faces, np.column_stack([place[:, 0], -place[:, 1]]), surface)


def terrain_slabs(levels: Matrix, size: Matrix, offset: Matrix, matrix: Matrix) -> list[HullBody]:
    """The bodies of a heightmap under ``matrix``; cm and Unreal's axes."""
    points = _grid(levels, size, offset).reshape(*levels.shape, 3) * [100, -100, 100]
    bottom = float(points[:, :, 2].min()) - EARTH_CM
    flat = FLAT_CM
    while len(pieces := _flat_pieces(points, flat, MOST_SLABS)) > MOST_SLABS:
        flat *= 2
    return [_slab(piece, bottom, matrix) for piece in pieces]


def _grid(levels: Matrix, size: Matrix, offset: Matrix) -> Matrix:
    rows, columns = levels.shape
    y, x = np.meshgrid(np.linspace(size[1] / 2, -size[1] / 2, rows), np.linspace(-size[0] / 2, size[0] / 2, columns))
    return np.stack([x.T, y.T, levels], axis=2).reshape(-1, 3) + offset


def _flat_pieces(points: Matrix, flat_cm: float, most: int) -> list[Matrix]:
    """Corners (4 x 3) of pieces that are flat to ``flat_cm``; a single cell that is not is two triangles (3 x 3)."""
    found: list[Matrix] = []
    waiting = [(0, points.shape[0] - 1, 0, points.shape[1] - 1)]
    while waiting and len(found) <= most:
        top, bottom, left, right = waiting.pop()
        block = points[top : bottom + 1, left : right + 1]
        corners = block[[0, 0, -1, -1], [0, -1, -1, 0]]
        if _bent(block, corners) <= flat_cm:
            found.append(corners)
        elif bottom - top <= 1 and right - left <= 1:
            found += [corners[[3, 2, 1]], corners[[3, 1, 0]]]
        else:
            middle, centre = (top + bottom) // 2, (left + right) // 2
            rows = [(top, middle), (middle, bottom)] if bottom - top > 1 else [(top, bottom)]
            columns = [(left, centre), (centre, right)] if right - left > 1 else [(left, right)]
            waiting += [(*row, *column) for row in rows for column in columns]
    return found


def _bent(block: Matrix, corners: Matrix) -> float:
    """How far the heights of a block lie from the plane through its corners."""
    flat = block.reshape(-1, 3)
    fit = np.linalg.lstsq(np.column_stack([corners[:, :2], np.ones(4)]), corners[:, 2], rcond=None)[0]
    away = np.abs(np.column_stack([flat[:, :2], np.ones(len(flat))]) @ fit - flat[:, 2])
    return float(away.max())


def _slab(corners: Matrix, bottom: float, matrix: Matrix) -> HullBody:
    low = corners.copy()
    low[:, 2] = bottom
    return hull(np.concatenate([corners, low]) @ matrix[:3, :3].T + matrix[:3, 3])


def road(element: Element, surface: Surface) -> tuple[NDArray[np.float64], SourcePart, list[HullBody]]:
    """A road: its middle (metres, SDF's axes), and its surface and bodies about it (cm, Unreal's axes).

    ``BadInput`` for one of fewer than two places or without a width.
    """
    points = np.array([numbers(point.text, 3) for point in element.findall("point")]).reshape(-1, 3)
    width = numbers(element.findtext("width"), 1, 1.0)[0]
    if len(points) > 1:
        points = points[np.append(True, np.linalg.norm(np.diff(points[:, :2], axis=0), axis=1) > 1e-6)]
    if len(points) < 2 or width <= 0:
        raise BadInput("a road needs two places and a width")
    middle = (points.min(axis=0) + points.max(axis=0)) / 2
    points = points - middle
    left, right = points + _sides(points) * width / 2, points - _sides(points) * width / 2
    along = np.append(0, np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))) / width
    shown = np.stack([left, right], axis=1).reshape(-1, 3)
    start = np.arange(len(points) - 1) * 2
    faces = np.concatenate(
        [np.stack([start, start + 1, start + 3], axis=1), np.stack([start, start + 3, start + 2], axis=1)]
    )
    uvs = np.stack([np.tile([0.0, 1.0], len(points)), np.repeat(along, 2)], axis=1)
    in_cm = shown * [100, -100, 100]
    slabs = [
        hull(np.concatenate([quad, quad - [0, 0, SLAB_CM]]))
        for quad in (in_cm[2 * number : 2 * number + 4] for number in range(len(points) - 1))
    ]
    return middle, _shown("road", shown, faces, uvs, surface), slabs


def _sides(points: Matrix) -> Matrix:
    """To the left of a path at each of its places, longer in a corner so that the width stays."""
    steps = np.diff(points[:, :2], axis=0)
    steps /= np.linalg.norm(steps, axis=1, keepdims=True)
    left = np.column_stack([-steps[:, 1], steps[:, 0]])
    before, after = np.concatenate([left[:1], left]), np.concatenate([left, left[-1:]])
    mean = before + after
    length = np.linalg.norm(mean, axis=1, keepdims=True)
    mean = np.where(length > 1e-6, mean / np.maximum(length, 1e-6), after)
    mean /= np.maximum(np.einsum("ij,ij->i", mean, after), 1 / MITRE)[:, None]
    return np.column_stack([mean, np.zeros(len(points))])


def _shown(node: str, points: Matrix, faces: NDArray[np.int64], uvs: Matrix, surface: Surface) -> SourcePart:
    """A part whose triangles and smooth normals look up."""
    placed = points * [100, -100, 100]
    corners = placed[faces]
    flat = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    down = flat[:, 2] < 0
    flat, faces = np.where(down[:, None], -flat, flat), np.where(down[:, None], faces[:, ::-1], faces)
    normals = np.zeros_like(placed)
    for corner in range(3):
        np.add.at(normals, faces[:, corner], flat)
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-12)
    return SourcePart(node, surface, placed, faces, normals, uvs)
