"""The surfaces of a scene that a line of sight stops at, and what many lines meet first.

A component with collision is its mesh's triangles where they are known (what a trace against complex collision meets),
else its collision bodies. Lengths in cm.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, NamedTuple, Protocol, TypeAlias

import numpy as np
import shapely
from numpy.typing import NDArray

from c4s.bounds import BOUNDS
from c4s.collision import SceneBodies, scene_bodies
from c4s.collision.lines import Meetings, TriangleSet, meet_shape
from c4s.collision.mesh_body import Array, triple
from c4s.collision.scene import quaternion_of, rotation_matrices
from c4s.collision.shapes import Shape

LINES, PAIRS = 20_000, 4_000_000
"""Lines, and at most pairs of a line and a body, that are followed at a time: bounds the memory."""
_BOX_CM = 1e-6
_FLAT = 1e-8
"""A scale under this leaves no volume: such a mesh is met where its corners come to lie."""
Rows: TypeAlias = NDArray[np.int64]


class SurfaceTriangles(Protocol):
    """A triangle mesh in its local frame (cm): ``vertices`` (n, 3) and ``faces`` (m, 3) of vertex indices."""

    @property
    def vertices(self) -> NDArray[Any]: ...

    @property
    def faces(self) -> NDArray[Any]: ...


MeshSource: TypeAlias = Callable[[str, Mapping[str, Any]], SurfaceTriangles | None]
"""Gives the mesh of a path, checked against what the snapshot says of it; None where it is not at hand."""


class Component(NamedTuple):
    """A mesh component of an actor."""

    mesh: str
    static: bool
    collides: bool
    pose: Array
    """4 x 4, local to world."""
    places: list[Array]
    """Where it shows its mesh: the component's own pose, or one of each instance."""


class FirstHits(NamedTuple):
    """What n lines meet first."""

    actor: Rows
    """Position in the scene; -1: nothing is met."""
    point: Array
    normal: Array
    """Unit, against the line."""
    inside: NDArray[np.bool_]
    """The line starts inside a body of the actor."""

    def part(self, first: int, end: int) -> FirstHits:
        """Those of some lines."""
        some = slice(first, end)
        return FirstHits(self.actor[some], self.point[some], self.normal[some], self.inside[some])


class _Piece(NamedTuple):
    actor: int
    solid: TriangleSet | Shape
    linear: Array
    offset: Array
    low: Array
    """World box."""
    high: Array


class Surfaces:
    """The surfaces of one snapshot.

    Args:
        snapshot: the scene.
        bodies: its collision bodies.
        meshes: gives the triangles of meshes; without it all surfaces are collision bodies.
    """

    def __init__(self, snapshot: Mapping[str, Any], bodies: SceneBodies, meshes: MeshSource | None = None) -> None:
        extra = snapshot.get("c4s")
        facts = extra.get("meshes") if isinstance(extra, Mapping) else None
        self.facts: Mapping[str, Any] = facts if isinstance(facts, Mapping) else {}
        self._source, self._sets, self._known = meshes, dict[str, TriangleSet](), dict[str, SurfaceTriangles | None]()
        self._actors: list[Mapping[str, Any]] = snapshot["actors"]
        self.unknown: dict[int, str] = dict(bodies.unresolved)
        """Actor to the reason why its surfaces are not (all) known."""
        self._pieces = self._shown(snapshot, bodies)
        self._low = np.array([piece.low for piece in self._pieces]).reshape(-1, 3) - _BOX_CM
        self._high = np.array([piece.high for piece in self._pieces]).reshape(-1, 3) + _BOX_CM
        self._owners = np.array([piece.actor for piece in self._pieces], dtype=np.int64)
        self._inverse = np.linalg.inv(np.array([piece.linear for piece in self._pieces]).reshape(-1, 3, 3))
        self._offset = np.array([piece.offset for piece in self._pieces]).reshape(-1, 3)
        self._solids = np.array([id(piece.solid) for piece in self._pieces], dtype=np.int64)
        self._met = 0
        self._tree = shapely.STRtree(shapely.box(*self._low[:, :2].T, *self._high[:, :2].T))

    def mesh(self, path: str) -> SurfaceTriangles | None:
        """The triangles of a mesh, where they are known."""
        if path not in self._known:
            found = self._source(path, self.facts.get(path) or {}) if self._source is not None else None
            self._known[path] = found if found is not None and len(found.faces) else None
        return self._known[path]

    def _shown(self, snapshot: Mapping[str, Any], bodies: SceneBodies) -> list[_Piece]:
        pieces: list[_Piece] = []
        if self._source is not None:
            rest = []
            for index, actor in enumerate(self._actors):
                own = actor.get("c4s")
                listed = own.get("components") if isinstance(own, Mapping) else None
                if not isinstance(listed, list):
                    rest.append(actor)
                    continue
                without = [part for part in listed if not self._add(index, part, pieces)]
                rest.append({**actor, "c4s": {"components": without}})
            bodies = scene_bodies({**snapshot, "actors": rest})
            self.unknown = dict(bodies.unresolved)
        return pieces + [
            _Piece(owner, body.form, body.rotation, body.translation, body.low, body.high)
            for body, owner in zip(bodies.bodies, bodies.owners, strict=True)
        ]

    def _add(self, index: int, part: Any, pieces: list[_Piece]) -> bool:
        """Add the triangles of a component; False where they are not known."""
        try:
            component = read_component(part)
        except ValueError:
            return False
        found = self.mesh(component.mesh) if component is not None else None
        if component is None or found is None:
            return False
        if component.collides:
            pieces += [_piece(index, self._triangles(component.mesh, found), place) for place in component.places]
        return True

    def _triangles(self, path: str, mesh: SurfaceTriangles) -> TriangleSet:
        if path not in self._sets:
            self._sets[path] = TriangleSet(np.asarray(mesh.vertices, dtype=np.float64)[mesh.faces])
        return self._sets[path]

    def first(self, start: Array, step: Array, own: Rows) -> FirstHits:
        """What each of n lines meets first, its own actor left out. Of two at one place the earlier actor counts.

        Raises ``BadInput`` for a scene so crowded that it is beyond ``line_pairs``.
        """
        lines = max(1, min(LINES, PAIRS // max(len(self._pieces), 1)))
        portions = [slice(k, k + lines) for k in range(0, max(len(start), 1), lines)]
        for part in portions:
            self._met += len(self._beside(start[part], step[part])[0])
            BOUNDS["line_pairs"].hold(self._met, where="support")
        parts = [self._first(start[part], step[part], own[part]) for part in portions]
        return FirstHits(*(np.concatenate(column) for column in zip(*parts, strict=True)))

    def _beside(self, start: Array, step: Array) -> tuple[Rows, Rows]:
        """Pairs of a line and a piece that meet in plan."""
        low, high = np.minimum(start, start + step), np.maximum(start, start + step)
        line, piece = self._tree.query(shapely.box(*low[:, :2].T, *high[:, :2].T))
        return line, piece

    def _first(self, start: Array, step: Array, own: Rows) -> FirstHits:
        low, high = np.minimum(start, start + step), np.maximum(start, start + step)
        line, piece = self._beside(start, step)
        near = (self._owners[piece] != own[line]) & (self._low[piece, 2] <= high[line, 2])
        near &= self._high[piece, 2] >= low[line, 2]
        line, piece = line[near], piece[near]
        met = Meetings.none(len(line))
        for some, solid in self._groups(piece):
            inverse = self._inverse[piece[some]]
            begin = np.einsum("nij,nj->ni", inverse, start[line[some]] - self._offset[piece[some]])
            way = np.einsum("nij,nj->ni", inverse, step[line[some]])
            found = solid.meet(begin, way) if isinstance(solid, TriangleSet) else meet_shape(solid, begin, way)
            met.fraction[some], met.inside[some] = found.fraction, found.inside
            met.normal[some] = np.einsum("nji,nj->ni", inverse, found.normal)
        order = np.lexsort((self._owners[piece], met.fraction, line))
        order = order[np.isfinite(met.fraction[order])]
        chosen = order[np.concatenate([[True], line[order][1:] != line[order][:-1]])] if len(order) else order
        hits = FirstHits(
            np.full(len(start), -1), start + step, np.zeros((len(start), 3)), np.zeros(len(start), dtype=bool)
        )
        at = line[chosen]
        hits.actor[at], hits.inside[at] = self._owners[piece[chosen]], met.inside[chosen]
        hits.point[at] = start[at] + met.fraction[chosen, None] * step[at]
        normal = np.where(met.inside[chosen, None], -step[at], met.normal[chosen])
        normal = normal / np.linalg.norm(normal, axis=1)[:, None]
        hits.normal[at] = np.where(np.einsum("ij,ij->i", normal, step[at])[:, None] > 0, -normal, normal)
        return hits

    def _groups(self, piece: Rows) -> list[tuple[Rows, TriangleSet | Shape]]:
        """Positions of the pairs of one solid, solid by solid."""
        if not len(piece):
            return []
        solids = self._solids[piece]
        order = np.argsort(solids, kind="stable")
        groups = np.split(order, np.flatnonzero(np.diff(solids[order])) + 1)
        return [(some, self._pieces[int(piece[some[0]])].solid) for some in groups]


def read_component(part: Any) -> Component | None:
    """A component of a snapshot; None when it shows no mesh. ``ValueError`` for unusable numbers."""
    if not isinstance(part, Mapping) or not part.get("mesh"):
        return None
    pose, instances = _matrix(part.get("transform")), part.get("instances")
    return Component(
        str(part["mesh"]),
        str(part.get("class")).endswith(("StaticMeshComponent", "SplineMeshComponent")),
        bool(part.get("collision_enabled")),
        pose,
        [_matrix(each) for each in instances] if isinstance(instances, list) else [pose],
    )


def _matrix(transform: Any) -> Array:
    if not isinstance(transform, Mapping):
        raise ValueError("no transform")
    rotation = rotation_matrices(np.array([quaternion_of(transform)]))[0]
    made = np.eye(4)
    made[:3, :3] = rotation * np.array(triple(transform.get("scale")))
    made[:3, 3] = triple(transform.get("location_cm"))
    return made


def _piece(actor: int, triangles: TriangleSet, pose: Array) -> _Piece:
    linear, offset = pose[:3, :3], pose[:3, 3]
    if float(np.linalg.norm(linear, axis=0).min()) < _FLAT:
        triangles = TriangleSet(triangles.corners @ linear.T + offset)
        linear, offset = np.eye(3), np.zeros(3)
    low, high = triangles.box
    middle, half = linear @ ((low + high) / 2) + offset, np.abs(linear) @ ((high - low) / 2)
    return _Piece(actor, triangles, linear, offset, middle - half, middle + half)
