"""OBJ files: a part for each object (or group) and material; normals by smoothing groups where none are written."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from c4s.bounds import BOUNDS
from c4s.errors import BadInput
from c4s.files import read_plain
from catalog.ingest.mtl import PLAIN, MtlLibraries
from catalog.ingest.obj_lines import ObjLines, read_lines
from catalog.ingest.polygons import triangulated
from catalog.ingest.surface import Surface, linear_of

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]


@dataclass(frozen=True)
class ObjPart:
    """Triangles of one piece and material in the file's axes and units; ``uvs`` with v down, ``colors`` linear."""

    piece: str
    surface: Surface
    points: Floats
    faces: Ints
    normals: Floats
    uvs: Floats
    colors: Floats | None


class ObjFile:
    """A parsed file and what is to be noted of it.

    Args:
        path: the file.
        root: the only folder whose files may be read.

    Raises:
        BadInput: no such file, or what ``read_lines`` raises.
    """

    def __init__(self, path: Path, root: Path) -> None:
        if not path.is_file():
            raise BadInput("no such mesh file", where=str(path))
        self.path = path
        self.lines = read_lines(read_plain(path, bound=BOUNDS["mesh_bytes"]), str(path))
        libraries = self.lines.libraries
        self.materials = MtlLibraries(path, root, libraries or ([f"{path.stem}.mtl"] if self.lines.materials else []))
        self.left_out = [f"{count} {word} are left out" for word, count in self.lines.left_out.items()]

    @property
    def notes(self) -> list[str]:
        """What is left out, and what material libraries lack."""
        return [*self.left_out, *self.materials.notes]

    def parts(self) -> Iterator[ObjPart]:
        """The parts in the order in which pieces, then materials, are named first."""
        lines = self.lines
        triangles, face = triangulated(lines.points[lines.corners[:, 0]], lines.sizes)
        if not len(triangles):
            return
        corners = lines.corners[triangles]
        normals, own_normal = _normals(lines, corners, face)
        group = lines.piece[face] * (len(lines.materials) + 1) + lines.material[face] + 1
        order = np.argsort(group, kind="stable")
        kinds, starts = np.unique(group[order], return_index=True)
        for kind, rows in zip(kinds.tolist(), np.split(order, starts[1:]), strict=True):
            piece, material = divmod(kind, len(lines.materials) + 1)
            yield self._part(lines.pieces[piece], material - 1, corners[rows], own_normal[rows], normals)

    def _part(self, piece: str, material: int, corners: Ints, own_normal: Ints, normals: Floats) -> ObjPart:
        lines = self.lines
        flat = corners.reshape(-1, 3)
        _, look = np.unique(flat[:, 1] * len(normals) + own_normal.reshape(-1), return_inverse=True)
        _, first, faces = np.unique(
            flat[:, 0] * (int(look.max()) + 1) + look.reshape(-1), return_index=True, return_inverse=True
        )
        used = flat[first]
        looks = self.materials.surface(lines.materials[material]) if material >= 0 else None
        surface = looks.surface if looks else PLAIN
        uvs = np.zeros((len(used), 2))
        given = used[:, 1] >= 0
        uvs[given] = lines.uvs[used[given, 1]]
        if surface.texture is not None and not given.any():
            self.left_out.append(f"piece {piece!r} has a texture and no texture coordinates")
        if looks is not None:
            uvs = uvs * looks.scale + looks.offset
        colors = None if lines.colors is None else linear_of(lines.colors[used[:, 0]])
        if colors is not None and np.ptp(colors, axis=0).max() < 1 / 512 and colors.min() > 1 - 1 / 512:
            colors = None
        if colors is not None and looks is None:
            surface = Surface("vertex_colors", (1.0, 1.0, 1.0))
        return ObjPart(
            piece,
            surface,
            lines.points[used[:, 0]],
            faces.reshape(-1, 3),
            normals[own_normal.reshape(-1)[first]],
            np.nan_to_num(uvs * [1, -1] + [0, 1]),
            colors,
        )


def _normals(lines: ObjLines, corners: Ints, face: Ints) -> tuple[Floats, Ints]:
    """Normals, and (t, 3) which of them each corner has.

    Written ones, then one for each face without smoothing, then one for each point and smoothing group; the last two
    for corners without a written one, weighted by area.
    """
    written = np.nan_to_num(lines.normals)
    chosen = corners[:, :, 2].copy()
    missing = chosen < 0
    if len(written):
        missing |= (np.abs(written).max(axis=1) < 1e-12)[chosen]
    if not missing.any():
        return written, chosen
    key = np.where(
        (lines.smooth[face] > 0)[:, None],
        len(lines.sizes) + lines.smooth[face][:, None] * len(lines.points) + corners[:, :, 0],
        face[:, None],
    )
    known, index = np.unique(key, return_inverse=True)
    index = index.reshape(key.shape)
    across = _face_normals(lines.points[corners[:, :, 0]], face, len(lines.sizes))
    owner = np.repeat(np.arange(len(lines.sizes)), lines.sizes)
    group = lines.smooth[owner]
    of_corner = np.where(group > 0, len(lines.sizes) + group * len(lines.points) + lines.corners[:, 0], owner)
    place = np.minimum(np.searchsorted(known, of_corner), len(known) - 1)
    meant = known[place] == of_corner
    made = np.stack([np.bincount(place[meant], across[owner[meant], axis], len(known)) for axis in range(3)], axis=1)
    length = np.linalg.norm(made, axis=1, keepdims=True)
    made = np.divide(made, length, out=np.tile([0.0, 1.0, 0.0], (len(made), 1)), where=length > 0)
    return np.concatenate([written, made]), np.where(missing, len(written) + index, chosen)


def _face_normals(places: Floats, face: Ints, count: int) -> Floats:
    """(count, 3) sums of the normals of each face's (t, 3, 3) triangles, as long as twice the area."""
    with np.errstate(over="ignore", invalid="ignore"):
        across = np.cross(places[:, 1] - places[:, 0], places[:, 2] - places[:, 0])
        summed: Floats = np.stack([np.bincount(face, across[:, axis], count) for axis in range(3)], axis=1)
    return summed
