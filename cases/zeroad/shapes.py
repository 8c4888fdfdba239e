"""What an actor of 0 A.D. looks like: its mesh and its props as parts (cm, Unreal's axes), cut at the ground."""

from __future__ import annotations

import random
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from functools import lru_cache

import numpy as np
from PIL import Image

from c4s.errors import BadInput
from cases.importers.imported import Matrix
from cases.zeroad.actors import ActorLook, look_of
from cases.zeroad.archive import Archive
from cases.zeroad.pmd import PmdMesh, read_pmd
from catalog.ingest.surface import SourcePart, Surface, has_alpha, texture_png

MOST_PIXELS, DEEPEST = 512, 6
"""Pixels a side of a texture; how many props may hang on props."""
TURN = np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
"""Of the axes east, up and north into Unreal's: X is north, Y east, Z up."""
PAINT = (150, 52, 40)
"""Colour of what is in the colour of a player."""
SEE_THROUGH = ("trans_wind.xml", "waterfall.xml")


@dataclass
class ActorShape:
    """A mesh of an actor or of one of its props: what it is called, and its part."""

    name: str
    part: SourcePart


def turned(matrix: Matrix) -> Matrix:
    """A matrix (metres, Y up) in cm and Unreal's axes."""
    turn = np.eye(4)
    turn[:3, :3] = TURN
    found: Matrix = turn @ matrix @ turn.T
    found[:3, 3] *= 100
    return found


@dataclass(eq=False)
class Shapes:
    """The shapes of the actors of an archive."""

    archive: Archive
    missing: dict[str, str] = field(default_factory=dict)
    """Props and textures that could not be read, and why."""

    def of(self, actor: str, chance: random.Random) -> list[ActorShape]:
        """All shapes of an actor about its place; ``BadInput`` where it has none."""
        found = list(self._shapes(actor, chance, np.eye(4), 0))
        if not found:
            raise BadInput("an actor without a mesh", where=actor)
        return found

    def _shapes(self, actor: str, chance: random.Random, matrix: Matrix, depth: int) -> Iterator[ActorShape]:
        look = look_of(self.archive, actor, chance)
        points: dict[str, Matrix] = {}
        if look.mesh:
            mesh = self._mesh(look.mesh)
            points = mesh.points
            if mesh.faces.size:
                yield ActorShape(actor.rpartition("/")[2].removesuffix(".xml"), self._part(look, mesh, matrix))
        for point, props in look.props.items():
            for prop in props if depth < DEEPEST else ():
                place = points.get(point)
                if place is None and point != "root":
                    continue
                below = matrix if place is None else matrix @ place
                try:
                    yield from self._shapes(prop, chance, below, depth + 1)
                except BadInput as error:
                    self.missing[prop] = error.what

    @lru_cache(maxsize=512)  # noqa: B019
    def _mesh(self, name: str) -> PmdMesh:
        return read_pmd(self.archive.mesh(name), name)

    def _part(self, look: ActorLook, mesh: PmdMesh, matrix: Matrix) -> SourcePart:
        points = (mesh.vertices @ matrix[:3, :3].T + matrix[:3, 3]) @ TURN.T * 100
        normals = mesh.normals @ matrix[:3, :3].T @ TURN.T
        normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-9)
        corners = points[mesh.faces]
        flat = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        away = np.einsum("ij,ij->i", flat, normals[mesh.faces].sum(axis=1)) < 0
        faces = mesh.faces[:, ::-1] if float(away.mean()) > 0.5 else mesh.faces
        keep = np.linalg.norm(flat, axis=1) > 1e-6
        uvs = np.column_stack([mesh.uvs[:, 0], mesh.uvs[:, 1]])
        return SourcePart("body", self._surface(look), points, faces[keep], normals, uvs)

    def _surface(self, look: ActorLook) -> Surface:
        if look.texture is None:
            return Surface("plain")
        try:
            return self._textured(look.texture, look.material, look.color)
        except BadInput as error:
            self.missing[look.texture] = error.what
            return Surface("plain")

    @lru_cache(maxsize=512)  # noqa: B019
    def _textured(self, name: str, material: str, color: tuple[float, float, float] | None) -> Surface:
        picture = self.archive.picture(f"skins/{name}")
        if max(picture.size) > MOST_PIXELS:
            factor = MOST_PIXELS / max(picture.size)
            size = (max(1, round(picture.width * factor)), max(1, round(picture.height * factor)))
            picture = picture.resize(size, Image.Resampling.BOX)
        stem = name.rpartition("/")[2].partition(".")[0]
        if material.startswith(("player", "objectcolor")):
            rest = PAINT if material.startswith("player") or color is None else tuple(round(255 * one) for one in color)
            picture = Image.composite(picture, Image.new("RGBA", picture.size, (*rest, 255)), picture.getchannel("A"))
        clear = material.startswith("basic_trans") or material in SEE_THROUGH
        if clear and has_alpha(picture):
            png = texture_png(picture, alpha=True)
            return Surface(stem, (1.0, 1.0, 1.0), texture=png, alpha="mask", alpha_cutoff=0.4)
        return Surface(stem, (1.0, 1.0, 1.0), texture=texture_png(picture))


def cut_at_ground(part: SourcePart) -> SourcePart | None:
    """What of a part is above a height of nothing; None where nothing is."""
    below = part.vertices[:, 2] < 0
    if not below.any():
        return part
    under = below[part.faces].sum(axis=1)
    faces = [part.faces[under == 0]]
    vertices, normals, uvs = [part.vertices], [part.normals], [part.uvs]
    count = len(part.vertices)
    for face in part.faces[(under == 1) | (under == 2)]:
        lone = next(k for k in range(3) if below[face[k]] == (below[face].sum() == 1))
        a, b, c = face[lone], face[(lone + 1) % 3], face[(lone + 2) % 3]
        for other in (b, c):
            high, low = part.vertices[a][2], part.vertices[other][2]
            share = high / (high - low)
            for rows, own in ((vertices, part.vertices), (normals, part.normals), (uvs, part.uvs)):
                rows.append((own[a] + share * (own[other] - own[a]))[None])
        ab, ac, count = count, count + 1, count + 2
        kept = [[ab, b, c], [ab, c, ac]] if below[a] else [[a, ab, ac]]
        faces.append(np.array(kept))
    left = np.concatenate(faces)
    if not left.size:
        return None
    used, number = np.unique(left, return_inverse=True)
    points, ups, places = (np.concatenate(rows)[used] for rows in (vertices, normals, uvs))
    points[:, 2] = np.maximum(points[:, 2], 0.0)
    return replace(part, vertices=points, normals=ups, uvs=places, faces=number.reshape(-1, 3))
