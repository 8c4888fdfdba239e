"""The collision bodies of a mesh as a snapshot stores them (local cm), read and checked.

A ``MeshBody`` is a value: equal bodies of different meshes or snapshots are equal, so it can be the key of a cache.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Literal, TypeAlias

import numpy as np
from numpy.typing import NDArray

Array: TypeAlias = NDArray[np.float64]
Triple: TypeAlias = tuple[float, float, float]
Kind = Literal["box", "sphere", "capsule", "hull"]


@dataclass(frozen=True, slots=True)
class MeshBody:
    """One body. ``size``: half extents of a box; (radius, length of the cylinder part, 0) of round bodies."""

    kind: Kind
    centre: Triple = (0.0, 0.0, 0.0)
    rotation_deg: Triple = (0.0, 0.0, 0.0)
    """[pitch, yaw, roll]."""
    size: Triple = (0.0, 0.0, 0.0)
    vertices: bytes = b""
    """Vertices of a hull: float64, row by row."""

    @property
    def points(self) -> Array:
        """Vertices (n, 3) of a hull."""
        return np.frombuffer(self.vertices, dtype=np.float64).reshape(-1, 3)


LARGEST = 1e12
"""Lengths (cm) and factors beyond this are no measurement; it keeps products of them far from overflow."""


def number(value: Any) -> float:
    """A number within ``LARGEST``; ``ValueError`` for anything else, numeric strings, booleans and NaN included."""
    if isinstance(value, bool) or not isinstance(value, int | float) or not abs(value) <= LARGEST:
        raise ValueError(f"{str(value)[:40]!r} is no number from -1e12 to 1e12")
    return float(value)


def triple(values: Any) -> Triple:
    """Three such numbers; ``ValueError`` otherwise."""
    if not isinstance(values, list | tuple) or len(values) != 3:
        raise ValueError("not three numbers")
    x, y, z = values
    if (
        type(x) is type(y) is type(z) is float
        and -LARGEST <= x <= LARGEST
        and -LARGEST <= y <= LARGEST
        and -LARGEST <= z <= LARGEST
    ):
        return x, y, z
    return number(x), number(y), number(z)


def read_body(record: Any) -> MeshBody:
    """A stored body; ``ValueError`` says what is wrong with it. Negative sizes count as their absolute value."""
    if not isinstance(record, Mapping):
        raise ValueError("a collision body is not an object")
    kind = record.get("kind")
    if kind == "hull":
        return MeshBody("hull", vertices=_vertices(record.get("vertices")).tobytes())
    centre = triple(record.get("center"))
    if kind == "sphere":
        return MeshBody("sphere", centre, size=(abs(number(record.get("radius"))), 0.0, 0.0))
    rotation = record.get("rotation_deg")
    turned = (0.0, 0.0, 0.0) if rotation is None else triple(rotation)
    if kind == "capsule":
        return MeshBody(
            "capsule", centre, turned, (abs(number(record.get("radius"))), abs(number(record.get("length"))), 0.0)
        )
    if kind == "box":
        x, y, z = triple(record.get("half_extent"))
        return MeshBody("box", centre, turned, (abs(x), abs(y), abs(z)))
    raise ValueError(f"unknown collision body kind {str(kind)[:40]!r}")


def _vertices(values: Any) -> Array:
    if not isinstance(values, list | tuple):
        raise ValueError("a hull without a list of vertices")
    return np.array([triple(value) for value in values], dtype=np.float64).reshape(-1, 3)
