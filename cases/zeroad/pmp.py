"""PMP, the terrain of a map of 0 A.D.: heights at the corners of tiles of four metres, and the texture of each tile."""

from __future__ import annotations

import struct
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from c4s.errors import BadInput
from cases.importers.imported import Matrix

MAGIC, PATCH, TILE_M, UNITS_A_METRE = b"PSMP", 16, 4.0, 92.0
VERSIONS = range(5, 8)
TILE = np.dtype([("texture", "<u2"), ("second", "<u2"), ("priority", "<u4")])


@dataclass(frozen=True)
class Terrain:
    """Heights (metres) by row (to the north) and column (to the east), names of textures, and which each tile has."""

    heights_m: Matrix
    textures: list[str]
    tiles: NDArray[np.int64]


def read_pmp(data: bytes, where: str) -> Terrain:
    """A terrain of the bytes of its file; ``BadInput`` where they are none."""
    try:
        magic, version, _, patches = struct.unpack_from("<4s3I", data)
        if magic != MAGIC or version not in VERSIONS:
            raise ValueError("another format or version")
        side = patches * PATCH + 1
        heights = np.frombuffer(data, "<u2", side * side, 16).reshape(side, side) / UNITS_A_METRE
        at = 16 + 2 * side * side
        (count,), at = struct.unpack_from("<I", data, at), at + 4
        textures = []
        for _ in range(count):
            (length,) = struct.unpack_from("<I", data, at)
            textures.append(data[at + 4 : at + 4 + length].decode("utf-8"))
            at += 4 + length
        rows = np.frombuffer(data, TILE, patches * patches * PATCH * PATCH, at)["texture"]
        blocks = rows.reshape(patches, patches, PATCH, PATCH).astype(np.int64)
        tiles = blocks.transpose(0, 2, 1, 3).reshape(patches * PATCH, patches * PATCH)
        if tiles.size and int(tiles.max()) >= count:
            raise ValueError("a tile of a texture that is not named")
    except (struct.error, ValueError, UnicodeDecodeError) as error:
        raise BadInput(f"this PMP cannot be read: {error}", where=where) from None
    return Terrain(heights, textures, tiles)
