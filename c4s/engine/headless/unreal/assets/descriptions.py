"""The geometry of a mesh as Unreal describes it: vertices, their instances at the corners of triangles, triangles.

A polygon is one triangle here, a polygon group is a slot; descriptions can be read and not edited.
"""

# ruff: noqa: RUF012  (each class declares its table of properties; no table is ever changed)

from __future__ import annotations

from typing import Any

import numpy as np

from c4s.engine.headless.unreal.containers import Array, Name
from c4s.engine.headless.unreal.core import Object, Prop, api, public
from c4s.engine.headless.unreal.structs import Rotator, StructBase, Vector, Vector2D
from c4s.packs.meshes import Mesh


@public
class ElementID(StructBase):
    """The index of a part of a mesh."""

    _fields = {"id_value": Prop("int", 0)}
    id_value: int


@public
class VertexID(ElementID):
    """The index of a vertex."""


@public
class VertexInstanceID(ElementID):
    """The index of a vertex as a corner of one triangle."""


@public
class TriangleID(ElementID):
    """The index of a triangle."""


@public
class PolygonID(ElementID):
    """The index of a polygon."""


@public
class PolygonGroupID(ElementID):
    """The index of a group of polygons: a slot."""


def _ids(kind: type[ElementID], numbers: Any) -> Array:
    return Array._of(kind.__name__, [kind(int(number)) for number in numbers])


@public
class MeshDescriptionBase(Object):
    """What is read of a mesh."""

    _class_module = "MeshDescription"

    def _bind(self, mesh: Mesh, slots: int) -> Any:
        _, first, place = np.unique(mesh.vertices, axis=0, return_index=True, return_inverse=True)
        order = np.argsort(first)
        rank = np.empty(len(order), np.int64)
        rank[order] = np.arange(len(order))
        self._positions = mesh.vertices[first[order]]
        self._corners = rank[place.reshape(-1)][mesh.faces]
        self._uvs = mesh.uvs[mesh.faces].reshape(-1, 2)
        self._groups, self._group_count = mesh.face_slots, slots
        return self

    @staticmethod
    def _within(element: ElementID, count: int) -> bool:
        return 0 <= element.id_value < count

    def _triangle(self, element: ElementID) -> Any:
        """Vertices of a triangle; none for an index that is none."""
        return self._corners[element.id_value] if self._within(element, len(self._corners)) else []

    @api
    def is_empty(self) -> bool:
        """Whether there is no vertex."""
        return not len(self._positions)

    @api
    def get_vertex_count(self) -> int:
        """Number of vertices, those at one place being one."""
        return len(self._positions)

    @api
    def get_vertex_instance_count(self) -> int:
        """Number of corners of all triangles."""
        return 3 * len(self._corners)

    @api
    def get_triangle_count(self) -> int:
        """Number of triangles."""
        return len(self._corners)

    @api
    def get_polygon_count(self) -> int:
        """Number of polygons, each of them a triangle."""
        return len(self._corners)

    @api
    def get_polygon_group_count(self) -> int:
        """Number of slots."""
        return int(self._group_count)

    @api
    def is_vertex_valid(self, vertex_id: VertexID) -> bool:
        """Whether there is such a vertex."""
        return self._within(vertex_id, len(self._positions))

    @api
    def is_vertex_instance_valid(self, vertex_instance_id: VertexInstanceID) -> bool:
        """Whether there is such a corner."""
        return self._within(vertex_instance_id, 3 * len(self._corners))

    @api
    def is_triangle_valid(self, triangle_id: TriangleID) -> bool:
        """Whether there is such a triangle."""
        return self._within(triangle_id, len(self._corners))

    @api
    def is_polygon_valid(self, polygon_id: PolygonID) -> bool:
        """Whether there is such a polygon."""
        return self._within(polygon_id, len(self._corners))

    @api
    def is_polygon_group_valid(self, polygon_group_id: PolygonGroupID) -> bool:
        """Whether there is such a slot."""
        return self._within(polygon_group_id, self._group_count)

    @api
    def get_vertex_position(self, vertex_id: VertexID) -> Vector:
        """Place of a vertex in the mesh (cm); the origin for an index that is none."""
        if not self._within(vertex_id, len(self._positions)):
            return Vector()
        return Vector(*(float(number) for number in self._positions[vertex_id.id_value]))

    @api
    def get_triangle_vertices(self, triangle_id: TriangleID) -> Array:
        """The three vertices of a triangle."""
        return _ids(VertexID, self._triangle(triangle_id))

    @api
    def get_triangle_vertex_instances(self, triangle_id: TriangleID) -> Array:
        """The three corners of a triangle."""
        found = self._within(triangle_id, len(self._corners))
        return _ids(VertexInstanceID, [3 * triangle_id.id_value + n for n in range(3)] if found else [])

    @api
    def get_triangle_vertex_instance(self, triangle_id: TriangleID, index: int) -> VertexInstanceID:
        """A corner of a triangle, the first to the third."""
        found = self._within(triangle_id, len(self._corners)) and 0 <= index < 3
        return VertexInstanceID(3 * triangle_id.id_value + index if found else -1)

    @api
    def get_triangle_polygon(self, triangle_id: TriangleID) -> PolygonID:
        """The polygon that a triangle is."""
        return PolygonID(triangle_id.id_value)

    @api
    def get_triangle_polygon_group(self, triangle_id: TriangleID) -> PolygonGroupID:
        """The slot of a triangle."""
        found = self._within(triangle_id, len(self._corners))
        return PolygonGroupID(int(self._groups[triangle_id.id_value]) if found else -1)

    @api
    def get_vertex_instance_vertex(self, vertex_instance_id: VertexInstanceID) -> VertexID:
        """The vertex at a corner."""
        number = vertex_instance_id.id_value
        found = self._within(vertex_instance_id, 3 * len(self._corners))
        return VertexID(int(self._corners[number // 3][number % 3]) if found else -1)

    @api
    def get_polygon_vertices(self, polygon_id: PolygonID) -> Array:
        """The three vertices of a polygon."""
        return _ids(VertexID, self._triangle(polygon_id))

    @api
    def get_polygon_triangles(self, polygon_id: PolygonID) -> Array:
        """The triangle that a polygon is."""
        return _ids(TriangleID, [polygon_id.id_value] if len(self._triangle(polygon_id)) else [])

    @api
    def get_polygon_polygon_group(self, polygon_id: PolygonID) -> PolygonGroupID:
        """The slot of a polygon."""
        return self.get_triangle_polygon_group(TriangleID(polygon_id.id_value))

    @api
    def get_num_polygon_vertices(self, polygon_id: PolygonID) -> int:
        """Three."""
        return len(self._triangle(polygon_id))

    @api
    def get_num_polygon_triangles(self, polygon_id: PolygonID) -> int:
        """One."""
        return min(1, len(self._triangle(polygon_id)))


@public
class StaticMeshDescription(MeshDescriptionBase):
    """What is read of a static mesh."""

    _class_module = "StaticMeshDescription"

    @api
    def get_vertex_instance_uv(self, vertex_instance_id: VertexInstanceID, uv_index: int = 0) -> Vector2D:
        """Texture coordinates at a corner; there is one set of them."""
        found = self._within(vertex_instance_id, len(self._uvs)) and uv_index == 0
        return Vector2D(*(float(number) for number in self._uvs[vertex_instance_id.id_value])) if found else Vector2D()


@public
class StaticMeshSocket(Object):
    """A named place on a mesh; meshes here have none."""

    _declares = {
        "socket_name": Prop("Name", lambda: Name("None"), writable=False),
        "relative_location": Prop("Vector", Vector),
        "relative_rotation": Prop("Rotator", Rotator),
        "relative_scale": Prop("Vector", lambda: Vector(1, 1, 1)),
        "tag": Prop("str", ""),
    }
