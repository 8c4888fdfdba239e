"""The ground of a part of a map: a surface for each texture of its tiles, its slabs, and the water.

Heights are rounded to ``STEP_M``: ground that is as good as level is level, so what stands there stands on all of its
lower side.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from c4s.errors import BadInput
from c4s.records.pack import CollisionBody
from cases.importers.imported import Matrix, SceneAsset
from cases.zeroad.archive import Archive
from cases.zeroad.pmp import TILE_M, Terrain
from catalog.ingest.hulls import hull
from catalog.ingest.surface import SourcePart, Surface, texture_png

STEP_M, DEEP_CM = 0.5, 60.0
PATTERN_M, NEARER = 32.0, 1 / 3
"""Metres that a texture covers where it does not say, and by how much smaller it is laid: eyes here are near to it."""
FINE, UNEVEN = 4, 0.7
"""A tile is cut into so many parts a side, and its border wanders by such a share of a tile."""
SHADE = 0.6
"""Of the textures' colours: the game shows them as they are, and adds no light of a sky."""
PLAIN = (0.35, 0.33, 0.22)
WATER_COLOR, WATER_OPACITY = (0.03, 0.09, 0.11), 0.82


@dataclass(frozen=True)
class Square:
    """A square part of a map, in tiles: its first column (east) and row (north), and how many it is a side."""

    column: int
    row: int
    side: int

    @property
    def middle_m(self) -> tuple[float, float]:
        """East and north of its middle."""
        half = self.side / 2
        return (self.column + half) * TILE_M, (self.row + half) * TILE_M

    def holds(self, east_m: float, north_m: float) -> bool:
        """Whether a place is in it."""
        low, high = (self.column * TILE_M, self.row * TILE_M), self.side * TILE_M
        return 0 < east_m - low[0] < high and 0 < north_m - low[1] < high


class MapGround:
    """The ground of a square of a terrain; ``zero_m`` is its commonest height, and nothing in the scene."""

    def __init__(self, terrain: Terrain, square: Square, water_m: float) -> None:
        rows, columns = terrain.tiles.shape
        if not (square.column >= 0 and square.row >= 0 and square.side > 0) or (
            square.column + square.side > columns or square.row + square.side > rows
        ):
            raise BadInput(f"the square does not lie on this map of {columns} x {rows} tiles")
        cut = np.s_[square.row : square.row + square.side + 1, square.column : square.column + square.side + 1]
        self.square, self.terrain = square, terrain
        steps = np.round(terrain.heights_m[cut] / STEP_M)
        found, counts = np.unique(steps[steps * STEP_M > water_m], return_counts=True)
        zero = found[np.argmax(counts)] if found.size else steps.flat[0]
        self.zero_m = float(zero) * STEP_M
        self.heights = (steps - zero) * STEP_M
        self.water = water_m - self.zero_m
        self.tiles = terrain.tiles[square.row : square.row + square.side, square.column : square.column + square.side]

    def height(self, east_m: float, north_m: float) -> float:
        """Height (metres above zero) of the ground at a place of the map."""
        x, y = east_m / TILE_M - self.square.column, north_m / TILE_M - self.square.row
        i, j = (min(max(int(value), 0), self.square.side - 1) for value in (y, x))
        v, u = y - i, x - j
        a, b, c, d = self.heights[i, j], self.heights[i, j + 1], self.heights[i + 1, j + 1], self.heights[i + 1, j]
        return float(a + (b - a) * u + (c - b) * v if u >= v else a + (d - a) * v + (c - d) * u)

    def level_under(self, low: Matrix, high: Matrix) -> bool:
        """Whether the ground is level under a box of the map (east and north, metres)."""
        j0, i0 = np.floor(low / TILE_M).astype(int) - (self.square.column, self.square.row)
        j1, i1 = np.ceil(high / TILE_M).astype(int) - (self.square.column, self.square.row)
        if min(i0, j0) < 0 or max(i1, j1) > self.square.side:
            return False
        return float(np.ptp(self.heights[i0 : i1 + 1, j0 : j1 + 1])) == 0.0

    def asset(self, archive: Archive) -> SceneAsset:
        """What is seen of it and what carries; about the middle of the square."""
        points = self._fine()
        count = self.square.side * FINE + 1
        corner = np.arange(count * count).reshape(count, count)
        a, b, c, d = corner[:-1, :-1].ravel(), corner[:-1, 1:].ravel(), corner[1:, 1:].ravel(), corner[1:, :-1].ravel()
        faces = np.concatenate([np.stack([a, c, b], axis=1), np.stack([a, d, c], axis=1)])
        edges = np.cross(points[faces[:, 1]] - points[faces[:, 0]], points[faces[:, 2]] - points[faces[:, 0]])
        faces = np.where(edges[:, 2:] < 0, faces[:, ::-1], faces)
        edges = np.where(edges[:, 2:] < 0, -edges, edges)
        normals = np.zeros_like(points)
        for number in range(3):
            np.add.at(normals, faces[:, number], edges)
        normals /= np.linalg.norm(normals, axis=1, keepdims=True)
        shown = np.tile(self._shown().ravel(), 2)
        parts = []
        for texture in np.unique(shown):
            surface, metres = _surface(archive, self.terrain.textures[texture])
            used, own = np.unique(faces[shown == texture], return_inverse=True)
            uvs = points[used][:, [1, 0]] * [1, -1] / (100 * metres)
            parts.append(SourcePart("ground", surface, points[used], own.reshape(-1, 3), normals[used], uvs))
        return SceneAsset("ground", parts, self._slabs(), ground=True)

    def water_asset(self) -> SceneAsset | None:
        """The face of the water; None where none of it is over the ground."""
        if self.water <= float(self.heights.min()):
            return None
        half = self.square.side * TILE_M * 50
        corners = np.array([[-half, -half, 0], [half, -half, 0], [half, half, 0], [-half, half, 0]], dtype=float)
        corners[:, 2] = 100 * self.water
        surface = Surface("water", WATER_COLOR, roughness=0.08, opacity=WATER_OPACITY, alpha="blend")
        up, faces = np.tile([0.0, 0.0, 1.0], (4, 1)), np.array([[0, 1, 2], [0, 2, 3]])
        return SceneAsset("water", [SourcePart("water", surface, corners, faces, up, np.zeros((4, 2)))], ground=True)

    def _points(self) -> Matrix:
        """Corners of tiles in cm and Unreal's axes: X to the north, Y to the east."""
        steps = (np.arange(self.square.side + 1) - self.square.side / 2) * TILE_M
        north, east = np.meshgrid(steps, steps, indexing="ij")
        return 100 * np.stack([north, east, self.heights], axis=2)

    def _fine(self) -> Matrix:
        """Corners of parts of tiles, on the triangles of the tiles."""
        side = self.square.side
        steps = np.arange(side * FINE + 1) / FINE
        tile = np.minimum(steps.astype(int), side - 1)
        i, j = np.meshgrid(tile, tile, indexing="ij")
        v, u = np.meshgrid(steps - tile, steps - tile, indexing="ij")
        a, b, c, d = (self.heights[i + up, j + right] for up, right in ((0, 0), (0, 1), (1, 1), (1, 0)))
        heights = np.where(u >= v, a + (b - a) * u + (c - b) * v, a + (d - a) * v + (c - d) * u)
        north, east = np.meshgrid(*((steps - side / 2) * TILE_M,) * 2, indexing="ij")
        found: Matrix = 100 * np.stack([north, east, heights], axis=2).reshape(-1, 3)
        return found

    def _shown(self) -> NDArray[np.int64]:
        """The texture of each part of a tile: near a border now this one, now that one."""
        chance, numbers = np.random.default_rng(0), np.unique(self.tiles)
        side, count = self.square.side, self.square.side * FINE
        weights = []
        for number in numbers:
            share = (self.tiles == number) + UNEVEN * (chance.random((side, side)) - 0.5)
            picture = Image.fromarray(share.astype(np.float32)).resize((count, count), Image.Resampling.BICUBIC)
            weights.append(np.asarray(picture) + 0.3 * UNEVEN * chance.random((count, count)))
        found: NDArray[np.int64] = numbers[np.argmax(weights, axis=0)]
        return found

    def _slabs(self) -> list[CollisionBody]:
        """Level rectangles as large as they come, and the halves of the tiles that slope."""
        points, bottom = self._points(), 100 * float(self.heights.min()) - DEEP_CM
        side = self.square.side
        corners = np.stack([self.heights[i : i + side, j : j + side] for i, j in ((0, 0), (0, 1), (1, 1), (1, 0))])
        level = np.ptp(corners, axis=0) == 0
        left, found = level.copy(), []
        for i, j in np.argwhere(~level):
            quad = points[[i, i, i + 1, i + 1], [j, j + 1, j + 1, j]]
            found += [quad[[0, 1, 2]], quad[[0, 2, 3]]]
        for i in range(side):
            for j in range(side):
                if not left[i, j]:
                    continue
                like = left & (corners[0] == corners[0][i, j])
                wide = next((k for k in range(j, side) if not like[i, k]), side)
                tall = next((k for k in range(i, side) if not like[k, j:wide].all()), side)
                left[i:tall, j:wide] = False
                found.append(points[[i, i, tall, tall], [j, wide, wide, j]])
        return [hull(np.concatenate([top, top * [1, 1, 0] + [0, 0, bottom]])) for top in found]


def _surface(archive: Archive, name: str) -> tuple[Surface, float]:
    """What a texture of terrain looks like, and the metres that its picture covers."""
    told = next((one for one in archive.terrains if one.rpartition("/")[2] == f"{name}.xml"), None)
    if told is None:
        return Surface(name, PLAIN, roughness=1.0), PATTERN_M
    root = archive.xml(told)
    file = next((one.get("file") for one in root.iterfind("textures/texture") if one.get("name") == "baseTex"), None)
    if file is None:
        return Surface(name, PLAIN, roughness=1.0), PATTERN_M
    sized = root.find("props")
    metres = float(sized.get("size") or PATTERN_M) if sized is not None else PATTERN_M
    picture = texture_png(archive.picture(f"terrain/{file}").convert("RGB"))
    return Surface(name, (SHADE, SHADE, SHADE), roughness=1.0, texture=picture), metres * NEARER
