"""The statements of a Wavefront OBJ file as arrays: numbers, corners of faces, and what holds for each face."""

from __future__ import annotations

import re
import warnings
from collections import Counter
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from c4s.errors import BadInput

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]
IGNORED = {
    b"p": "points",
    b"l": "lines",
    b"curv": "curves",
    b"curv2": "curves",
    b"surf": "curved surfaces",
    b"call": "other files that it calls",
}
"""Statements that show something and are left out, and the word for it."""


@dataclass
class ObjLines:
    """A parsed file. Indices count from 0; -1 stands where a corner names nothing."""

    points: Floats
    """(n, 3) as written."""
    colors: Floats | None
    """(n, 3) display colours in [0, 1] behind the points (``v x y z r g b``)."""
    uvs: Floats
    """(m, 2), v up."""
    normals: Floats
    """(k, 3) as written."""
    corners: Ints
    """(c, 3) point, texture coordinate and normal of each corner, face after face."""
    sizes: Ints
    """(f,) corners of each face."""
    piece: Ints
    """(f,) row of ``pieces``."""
    material: Ints
    """(f,) row of ``materials``; -1 where none is chosen."""
    smooth: Ints
    """(f,) smoothing group; 0 for none."""
    pieces: list[str]
    materials: list[str]
    libraries: list[str]
    """What stands behind each ``mtllib``, as written."""
    left_out: Counter[str] = field(default_factory=Counter)
    """How often something is left out, by its word."""


class _Reader:
    """Goes through the lines once and collects them by their kind."""

    def __init__(self, data: bytes, where: str) -> None:
        self.where = where
        self.points: list[bytes] = []
        self.uvs: list[bytes] = []
        self.normals: list[bytes] = []
        self.faces: list[bytes] = []
        self.relative: list[tuple[int, int, int, int]] = []
        self.objects, self.groups = _Named("object"), _Named("default")
        self.materials = _Named(None)
        self.smooth = [(0, 0)]
        self.libraries: list[str] = []
        self.left_out: Counter[str] = Counter()
        rows = {b"v": self.points, b"vt": self.uvs, b"vn": self.normals}
        for line in data.splitlines():
            split = line.split(None, 1)
            if len(split) < 2:
                continue
            word, rest = split
            if word in rows:
                rows[word].append(rest)
            elif word in (b"f", b"fo"):
                if b"-" in rest:
                    self.relative.append((len(self.faces), len(self.points), len(self.uvs), len(self.normals)))
                self.faces.append(rest)
            elif not word.startswith(b"#"):
                self._state(word, rest)

    def _state(self, word: bytes, rest: bytes) -> None:
        face = len(self.faces)
        if word == b"usemtl":
            self.materials.change(face, _text(rest))
        elif word == b"o":
            self.objects.change(face, _text(rest))
        elif word == b"g":
            self.groups.change(face, _text(rest))
        elif word == b"s":
            group = rest.split()[0]
            self.smooth.append((face, int(group) if group.isdigit() else int(group.lower() == b"on")))
        elif word == b"mtllib":
            self.libraries.append(_text(rest))
        elif word in IGNORED:
            self.left_out[IGNORED[word]] += 1

    def lines(self) -> ObjLines:
        points, colors = self._points()
        uvs, given = self._table(self.uvs, 2)
        uvs[given < 2] = uvs[given < 2] * [1, 0]
        normals, _ = self._table(self.normals, 3)
        sizes = np.fromiter((len(row.split()) for row in self.faces), np.int64, len(self.faces))
        pieces = self.objects if self.objects.names[1:] else self.groups
        return ObjLines(
            points,
            colors,
            uvs,
            normals,
            *self._corners(sizes, len(points), len(uvs), len(normals)),
            pieces.of(len(self.faces)),
            self.materials.of(len(self.faces)) - 1,
            _runs(self.smooth, len(self.faces)),
            [str(name) for name in pieces.names],
            [str(name) for name in self.materials.names[1:]],
            self.libraries,
            self.left_out,
        )

    def _points(self) -> tuple[Floats, Floats | None]:
        table, given = self._table(self.points, 6)
        if (given < 3).any():
            raise BadInput("a vertex of the file has less than three coordinates", where=self.where)
        with_color = given >= 6
        if not with_color.any():
            return table[:, :3], None
        colors = np.where(with_color[:, None], table[:, 3:6], 1.0)
        if not np.isfinite(colors).all():
            return table[:, :3], None
        most = float(colors[with_color].max())
        return table[:, :3], np.clip(np.where(with_color[:, None], colors / (255 if most > 1 else 1), 1.0), 0, 1)

    def _table(self, rows: list[bytes], width: int) -> tuple[Floats, Ints]:
        """The first ``width`` numbers of each row, zero where there are less, and how many each row has."""
        given = np.fromiter((len(row.split()) for row in rows), np.int64, len(rows))
        flat = _parsed(b" ".join(rows), int(given.sum()), np.float64)
        if flat is None:
            rows = [row.split(b"#", 1)[0] for row in rows]
            given = np.fromiter((len(row.split()) for row in rows), np.int64, len(rows))
            try:
                flat = np.array([float(word) for row in rows for word in row.split()], np.float64)
            except ValueError as error:
                raise BadInput(f"the file is malformed: {error!s:.100}", where=self.where) from None
        table = np.zeros((len(rows), width))
        if len(rows) and (given == given[0]).all():
            taken = flat.reshape(len(rows), -1)[:, :width]
            table[:, : taken.shape[1]] = taken
            return table, given
        row = np.repeat(np.arange(len(rows)), given)
        column = np.arange(len(flat)) - np.repeat(np.cumsum(given) - given, given)
        kept = column < width
        table[row[kept], column[kept]] = flat[kept]
        return table, given

    def _corners(self, sizes: Ints, *counts: int) -> tuple[Ints, Ints]:
        faces = self.faces
        slashes = np.fromiter((row.count(b"/") for row in faces), np.int64, len(faces))
        uneven = (sizes == 0) | (slashes % np.maximum(sizes, 1) != 0) | (slashes > 2 * sizes)
        fields = slashes // np.maximum(sizes, 1) + 1
        corners = np.zeros((int(sizes.sum()), 3), np.int64)
        for width in (1, 2, 3):
            which = np.flatnonzero(fields == width)
            text = b" ".join([faces[index] for index in which.tolist()])
            flat = _parsed(text.replace(b"//", b"/0/").replace(b"/", b" "), width * int(sizes[which].sum()), np.int64)
            if flat is None or uneven.any():
                return self._slow_corners(counts)
            corners[np.repeat(fields == width, sizes), :width] = flat.reshape(-1, width)
        return self._absolute(corners, sizes, counts), sizes

    def _slow_corners(self, counts: tuple[int, ...]) -> tuple[Ints, Ints]:
        rows: list[list[int]] = []
        sizes = np.zeros(len(self.faces), np.int64)
        try:
            for index, face in enumerate(self.faces):
                words = face.split(b"#", 1)[0].split()
                sizes[index] = len(words)
                for word in words:
                    numbers = [int(one) if one else 0 for one in word.split(b"/")[:3]]
                    rows.append(numbers + [0] * (3 - len(numbers)))
        except ValueError as error:
            raise BadInput(
                f"the file is malformed: a corner of a face is no number: {error!s:.80}", where=self.where
            ) from None
        return self._absolute(np.array(rows, np.int64).reshape(-1, 3), sizes, counts), sizes

    def _absolute(self, corners: Ints, sizes: Ints, counts: tuple[int, ...]) -> Ints:
        """Indices from 0: negative ones count back from what stood in the file before their face."""
        found = corners - 1
        if self.relative:
            starts = np.cumsum(sizes) - sizes
            for face, *before in self.relative:
                rows = slice(int(starts[face]), int(starts[face] + sizes[face]))
                own = corners[rows]
                found[rows] = np.where(own < 0, own + np.asarray(before), found[rows])
        if len(found) and not 0 <= found[:, 0].min() <= found[:, 0].max() < counts[0]:
            raise BadInput("a triangle names a vertex that does not exist", where=self.where)
        for column, word in ((1, "texture coordinates"), (2, "normals")):
            wrong = (found[:, column] >= counts[column]) | (found[:, column] < -1)
            if wrong.any():
                self.left_out[f"{word} that do not exist"] += int(wrong.sum())
                found[wrong, column] = -1
        return found


class _Named:
    """A name that holds from a face on."""

    def __init__(self, first: str | None) -> None:
        self.names: list[str | None] = [first]
        self.changes = [(0, 0)]
        self._known: dict[str | None, int] = {first: 0}

    def change(self, face: int, name: str) -> None:
        number = self._known.setdefault(name, len(self.names))
        if number == len(self.names):
            self.names.append(name)
        self.changes.append((face, number))

    def of(self, faces: int) -> Ints:
        """(faces,) number of the name of each face."""
        return _runs(self.changes, faces)


def _runs(changes: list[tuple[int, int]], count: int) -> Ints:
    at, values = np.asarray(changes, np.int64).T
    return np.repeat(values, np.diff(np.append(at, count)))


def _text(data: bytes) -> str:
    """A name in UTF-8, or in Latin-1 where it is none."""
    try:
        return data.decode("utf-8").strip()
    except UnicodeDecodeError:
        return data.decode("latin-1").strip()


def _parsed(text: bytes, count: int, kind: type) -> NDArray[Any] | None:
    """All numbers of a text; None where they are not exactly so many."""
    if not count:
        return np.zeros(0, kind)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", DeprecationWarning)
        try:
            found: NDArray[Any] = np.fromstring(text, dtype=kind, sep=" ")
        except ValueError:
            return None
    return found if len(found) == count else None


def read_lines(data: bytes, where: str) -> ObjLines:
    """Parse the bytes of an OBJ file.

    Raises ``BadInput`` for numbers that are none, and for a face that names a point that is not there.
    """
    if data[:2] in (b"\xff\xfe", b"\xfe\xff"):
        data = data.decode("utf-16", errors="replace").encode()
    data = data.removeprefix(b"\xef\xbb\xbf")
    if b"\\" in data:
        data = re.sub(rb"\\[ \t]*(\r\n|\n|\r)", b" ", data)
    return _Reader(data, where).lines()
