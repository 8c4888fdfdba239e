"""What of a shape is a thing of its own: props that stand on the ground and touch nothing of the rest."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from cases.importers.imported import Matrix
from cases.zeroad.shapes import ActorShape
from catalog.ingest.surface import SourcePart

Triangles = np.ndarray[tuple[int, int], np.dtype[np.int64]]
APART_CM, SAMPLE_CM, MOST_SAMPLES = 15.0, 15.0, 60_000
LEAST_CM, LARGEST_CM = 15.0, 880.0
STANDS_CM = (-80.0, 15.0)
"""A thing's lowest point is so far from the ground at its pivot."""


@dataclass
class ActorPiece:
    """Parts that hang together, and what they are called."""

    name: str
    parts: list[SourcePart]

    @property
    def box(self) -> tuple[Matrix, Matrix]:
        """Its lowest and highest corner."""
        points = np.concatenate([part.vertices[np.unique(part.faces)] for part in self.parts])
        return points.min(axis=0), points.max(axis=0)


def split(name: str, shapes: list[ActorShape]) -> list[ActorPiece]:
    """The pieces of an actor, the one that is no thing of its own first (where there is one)."""
    rows = [(number, faces) for number, shape in enumerate(shapes) for faces in _connected(shape.part)]
    label = _joined([shapes[number].part.vertices[faces] for number, faces in rows])
    rest, found = ActorPiece(name, []), []
    groups: list[dict[int, list[Triangles]]] = [{} for _ in range(int(label.max()) + 1)]
    for (number, faces), group in zip(rows, label.tolist(), strict=True):
        groups[group].setdefault(number, []).append(faces)
    for own in groups:
        parts = [replace(shapes[number].part, faces=np.concatenate(faces)) for number, faces in own.items()]
        piece = ActorPiece(shapes[min(own)].name, parts)
        low, high = piece.box
        stands = STANDS_CM[0] <= low[2] <= STANDS_CM[1] and high[2] > LEAST_CM
        if stands and LEAST_CM <= float((high - low).max()) <= LARGEST_CM:
            found.append(piece)
        else:
            rest.parts += parts
    return [rest, *found] if rest.parts else found


def about_its_foot(piece: ActorPiece, low_cm: float) -> tuple[ActorPiece, Matrix]:
    """A piece about the middle of its lower side, and where that was."""
    low, high = piece.box
    foot = np.array([*(low + high)[:2] / 2, low_cm])
    parts = []
    for part in piece.parts:
        used, number = np.unique(part.faces, return_inverse=True)
        parts.append(
            replace(
                part,
                vertices=part.vertices[used] - foot,
                normals=part.normals[used],
                uvs=part.uvs[used],
                faces=number.reshape(-1, 3),
            )
        )
    return ActorPiece(piece.name, parts), foot


def _connected(part: SourcePart) -> list[Triangles]:
    """The faces of a part by what hangs together at its corners."""
    _, welded = np.unique(np.round(part.vertices, 1), axis=0, return_inverse=True)
    faces = welded.reshape(-1)[part.faces]
    count = int(faces.max()) + 1
    ends = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]]])
    _, label = connected_components(coo_matrix((np.ones(len(ends)), (ends[:, 0], ends[:, 1])), shape=(count, count)))
    own = label[faces[:, 0]]
    return [part.faces[own == one] for one in np.unique(own)]


def _joined(pieces: list[Matrix]) -> np.ndarray[tuple[int], np.dtype[np.int64]]:
    """Which pieces (corners of triangles) come nearer to each other than ``APART_CM``: a number of each's group."""
    area = sum(float(np.linalg.norm(np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]), axis=1).sum()) / 2 for p in pieces)
    step = max(SAMPLE_CM, float(np.sqrt(area / MOST_SAMPLES)))
    points = [_thinned(_samples(corners, step), step / 4) for corners in pieces]
    owners = np.repeat(np.arange(len(pieces)), [len(own) for own in points])
    pairs = cKDTree(np.concatenate(points)).query_pairs(max(APART_CM, step), output_type="ndarray")
    ends = owners[pairs].reshape(-1, 2)
    ends = ends[ends[:, 0] != ends[:, 1]]
    matrix = coo_matrix((np.ones(len(ends)), (ends[:, 0], ends[:, 1])), shape=(len(pieces), len(pieces)))
    label: np.ndarray[tuple[int], np.dtype[np.int64]] = connected_components(matrix)[1].astype(np.int64)
    return label


def _thinned(points: Matrix, cell_cm: float) -> Matrix:
    """One point of each cell that has any: a carved thing has thousands of corners within a hand's breadth."""
    _, first = np.unique(np.floor(points / cell_cm).astype(np.int64), axis=0, return_index=True)
    return points[np.sort(first)]


def _samples(corners: Matrix, step: float) -> Matrix:
    """Points on triangles, about a step from each other, their corners among them."""
    found = [corners.reshape(-1, 3)]
    side = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).max(axis=1)
    often = np.ceil(side / step).astype(int)
    for count in np.unique(often[often > 1]):
        i, j = np.meshgrid(np.arange(count + 1), np.arange(count + 1))
        inside = i + j <= count
        u, v = (i[inside] / count)[:, None, None], (j[inside] / count)[:, None, None]
        own = corners[often == count]
        spread = own[None, :, 0] * (1 - u - v) + own[None, :, 1] * u + own[None, :, 2] * v
        found.append(spread.reshape(-1, 3))
    return np.concatenate(found)
