"""Poses of SDF elements in the frames that they name: ``relative_to``, ``attached_to``, ``placement_frame``."""

from __future__ import annotations

from xml.etree.ElementTree import Element

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from c4s.errors import BadInput
from cases.importers.sdf_library import SdfLibrary

Matrix = NDArray[np.float64]
ROOTS = ("", "__model__", "world", "__root__")
NAMED = ("frame", "link", "model", "include", "joint", "light")


def numbers(text: str | None, count: int, default: float = 0.0) -> list[float]:
    """``count`` numbers of an element's text; ``BadInput`` when one is not finite or there are too few."""
    words = (text or "").split()
    if not words:
        return [default] * count
    try:
        values = [float(word) for word in words[:count]]
    except ValueError:
        values = []
    if len(values) != count or not np.isfinite(values).all():
        raise BadInput(f"{' '.join(words[:6])!r} is not {count} numbers")
    return values


def rigid(place: list[float], angles: list[float]) -> Matrix:
    """A 4x4 matrix of a place and turns about the fixed axes x, y, z in that order (radians)."""
    matrix = np.eye(4)
    matrix[:3, :3] = Rotation.from_euler("xyz", angles).as_matrix()
    matrix[:3, 3] = place
    return matrix


def pose(element: Element) -> Matrix:
    """The pose that an element writes, in whatever frame it names: x y z and roll pitch yaw, or a quaternion."""
    found = element.find("pose")
    if found is None:
        return np.eye(4)
    if found.get("rotation_format") == "quat_xyzw":
        x, y, z, *quaternion = numbers(found.text, 7) if (found.text or "").split() else [0, 0, 0, 0, 0, 0, 1]
        if np.linalg.norm(quaternion) < 1e-9:
            raise BadInput("a pose has no rotation: its quaternion is nothing")
        matrix = np.eye(4)
        matrix[:3, :3] = Rotation.from_quat(quaternion).as_matrix()
        matrix[:3, 3] = x, y, z
        return matrix
    x, y, z, *angles = numbers(found.text, 6)
    degrees = found.get("degrees", "false").strip().lower() in ("true", "1")
    return rigid([x, y, z], [float(np.radians(angle)) for angle in angles] if degrees else angles)


def merged(element: Element) -> bool:
    """Whether an include puts what it stands for into its parent (``merge="true"``) and is no model of its own."""
    return element.tag == "include" and element.get("merge", "false").strip().lower() in ("true", "1")


class Frames:
    """The frames of one world or model.

    Args:
        scope: the ``world`` or ``model`` element.
        library: what an ``include`` stands for.
    """

    def __init__(self, scope: Element, library: SdfLibrary) -> None:
        self.scope, self.library = scope, library
        self._named: dict[str, Element] = {}
        self._merged: list[Element] = []
        for child in scope:
            if merged(child):
                self._merged.append(child)
            elif child.tag in NAMED:
                name = library.name(child) if child.tag == "include" else child.get("name") or ""
                self._named.setdefault(name, child)
        self._resolving: list[str] = []

    def of(self, element: Element) -> Matrix:
        """The matrix of a child of the scope (or of a visual's or light's parent link) in the scope's frame."""
        written, model = self._written(element)
        base, placed = self.resolve(self._frame_of(written)), pose(written)
        anchor = element.findtext("placement_frame") or element.get("placement_frame") or model.get("placement_frame")
        if element.tag in ("model", "include") and anchor:
            placed = placed @ np.linalg.inv(Frames(model, self.library).resolve(anchor.strip()))
        out: Matrix = base @ placed
        return out

    def resolve(self, name: str) -> Matrix:
        """The matrix of a frame by its name, ``model::link`` for one of a nested model."""
        if name in ROOTS:
            return np.eye(4)
        first, _, rest = name.partition("::")
        element = self._named.get(first)
        if first in self._resolving:
            raise BadInput(f"frame {first!r} hangs on itself")
        self._resolving.append(first)
        try:
            matrix = self._of_merged(first) if element is None else self.of(element)
        finally:
            self._resolving.pop()
        if rest and element is not None:
            matrix = matrix @ Frames(self._written(element)[1], self.library).resolve(rest)
        return matrix

    def has(self, name: str) -> bool:
        """Whether a frame of this name is the scope's own."""
        return name in self._named

    def _of_merged(self, name: str) -> Matrix:
        """A frame that comes with a merged include."""
        for include in self._merged:
            inner = Frames(self.library(include), self.library)
            if inner.has(name):
                matrix: Matrix = self.of(include) @ inner.resolve(name)
                return matrix
        raise BadInput(f"frame {name!r} does not exist")

    def _written(self, element: Element) -> tuple[Element, Element]:
        """The element whose pose counts, and the model that it stands for."""
        if element.tag != "include":
            return element, element
        model = self.library(element)
        return (element if element.find("pose") is not None else model), model

    def _frame_of(self, element: Element) -> str:
        """The frame in which an element writes its pose."""
        found = element.find("pose")
        named = (found.get("relative_to") or found.get("frame") or "").strip() if found is not None else ""
        if named or element.tag not in ("frame", "joint"):
            return named
        return (
            (element.get("attached_to") or "").strip()
            if element.tag == "frame"
            else (element.findtext("child") or "").strip()
        )
