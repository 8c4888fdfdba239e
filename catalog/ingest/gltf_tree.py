"""The node tree of a glTF scene: world matrices, placed meshes (instances too), lights and cameras."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from catalog.ingest.gltf_file import GltfFile
from catalog.ingest.gltf_mesh import GltfMeshes, Primitive

INSTANCING = "EXT_mesh_gpu_instancing"
LIGHTS = "KHR_lights_punctual"
Matrix = NDArray[np.float64]


@dataclass(frozen=True)
class Placed:
    """A mesh on a node: the names from the root to it, and its matrix in the file's axes and units."""

    node: int
    path: tuple[str, ...]
    mesh: int
    matrix: Matrix
    weights: tuple[float, ...] = ()
    skin: int | None = None


@dataclass(frozen=True)
class PlacedRecord:
    """A light or camera on a node: the record of the file, and where it is; it looks along the matrix's -Z."""

    path: tuple[str, ...]
    record: dict[str, Any]
    matrix: Matrix


class GltfTree:
    """The default scene of a file (its first where it names none)."""

    def __init__(self, file: GltfFile) -> None:
        self.file, self.meshes = file, GltfMeshes(file)
        self.worlds: dict[int, Matrix] = {}
        self.paths: dict[int, tuple[str, ...]] = {}
        nodes = file.items("nodes")
        try:
            self._names = _names(nodes)
            roots = self._roots(nodes)
            self._walk(roots, nodes)
            self._all_worlds(nodes)
        except (TypeError, ValueError, AttributeError) as error:
            raise file.bad(f"its nodes are malformed: {error}") from None
        if file.items("animations"):
            file.notes.append("animations are left out: it is shown as it stands in the file")

    def _roots(self, nodes: list[dict[str, Any]]) -> list[int]:
        scenes = self.file.items("scenes")
        if not scenes:
            below = {child for node in nodes for child in node.get("children", [])}
            return [index for index in range(len(nodes)) if index not in below]
        chosen = self.file.tree.get("scene", 0)
        record = self.file.item("scenes", chosen)
        others = [str(scene.get("name") or index) for index, scene in enumerate(scenes) if index != chosen]
        if others:
            self.file.notes.append(f"only the default one of its {len(scenes)} scenes is read, not {', '.join(others)}")
        return list(record.get("nodes", []))

    def _walk(self, roots: list[int], nodes: list[dict[str, Any]]) -> None:
        waiting: list[tuple[int, tuple[str, ...], Matrix]] = [(index, (), np.eye(4)) for index in reversed(roots)]
        while waiting:
            index, above, frame = waiting.pop()
            node = self.file.item("nodes", index)
            if index in self.worlds:
                raise self.file.bad(f"node {self._names[index]!r} hangs below itself or in two places")
            if node.get("extensions", {}).get("KHR_node_visibility", {}).get("visible", True) is False:
                self.file.notes.append(f"node {self._names[index]!r} is hidden and left out")
                continue
            self.worlds[index] = frame @ _local(node)
            self.paths[index] = (*above, self._names[index])
            waiting += [(child, self.paths[index], self.worlds[index]) for child in reversed(node.get("children", []))]

    def _all_worlds(self, nodes: list[dict[str, Any]]) -> None:
        """World matrices of nodes outside the scene too: joints of a skin may lie there."""
        self._joint_worlds = dict(self.worlds)
        parents = {child: index for index, node in enumerate(nodes) for child in node.get("children", [])}

        for index in {joint for skin in self.file.items("skins") for joint in skin.get("joints", [])}:
            chain, at = [index], index
            while at in parents and parents[at] not in self._joint_worlds and len(chain) <= len(nodes):
                at = parents[at]
                chain.append(at)
            frame = self._joint_worlds.get(parents.get(at, -1), np.eye(4))
            for one in reversed(chain):
                if one not in self._joint_worlds:
                    self._joint_worlds[one] = frame @ _local(self.file.item("nodes", one))
                frame = self._joint_worlds[one]

    def placed(self) -> Iterator[Placed]:
        """Every mesh of the scene in the order of the tree; each instance of EXT_mesh_gpu_instancing apart."""
        for index, path in self.paths.items():
            node = self.file.item("nodes", index)
            if "mesh" not in node:
                continue
            weights = tuple(float(value) for value in node.get("weights", ()))
            instancing = node.get("extensions", {}).get(INSTANCING)
            if instancing is None:
                skin = node.get("skin")
                yield Placed(index, path, node["mesh"], self.worlds[index], weights, skin)
                continue
            for number, local in enumerate(self._instances(instancing)):
                yield Placed(
                    index, (*path[:-1], f"{path[-1]}_{number}"), node["mesh"], self.worlds[index] @ local, weights
                )

    def _instances(self, record: dict[str, Any]) -> Iterator[Matrix]:
        attributes = {key: self.file.array(index) for key, index in record.get("attributes", {}).items()}
        count = {len(values) for key, values in attributes.items() if key in ("TRANSLATION", "ROTATION", "SCALE")}
        if len(count) != 1:
            raise self.file.bad(f"{INSTANCING} needs places of one count")
        for number in range(count.pop()):
            yield _local(
                {
                    name.lower(): attributes[name][number]
                    for name in ("TRANSLATION", "ROTATION", "SCALE")
                    if name in attributes
                }
            )

    def triangles(self, placed: Placed) -> list[tuple[Primitive, Matrix]]:
        """The primitives of a placed mesh, each with the matrix that is still to be applied.

        A skin is applied as the joints stand in the file, and leaves no matrix: glTF ignores the node's own then.
        """
        primitives = self.meshes.primitives(placed.mesh, placed.weights)
        if placed.skin is None:
            return [(primitive, placed.matrix) for primitive in primitives]
        skin = self.file.item("skins", placed.skin)
        joints = np.stack([self._joint_worlds[index] for index in skin.get("joints", [])])
        if "inverseBindMatrices" in skin:
            inverse = self.file.array(skin["inverseBindMatrices"]).reshape(-1, 4, 4).transpose(0, 2, 1)
            joints = joints @ inverse[: len(joints)]
        return [
            _skinned(self.file, primitive, joints) if primitive.joints is not None else (primitive, placed.matrix)
            for primitive in primitives
        ]

    def lights(self) -> Iterator[PlacedRecord]:
        """The lights of KHR_lights_punctual."""
        known = self.file.tree.get("extensions", {}).get(LIGHTS, {}).get("lights", [])
        for index, path in self.paths.items():
            number = self.file.item("nodes", index).get("extensions", {}).get(LIGHTS, {}).get("light")
            if isinstance(number, int) and 0 <= number < len(known):
                yield PlacedRecord(path, known[number], self.worlds[index])

    def cameras(self) -> Iterator[PlacedRecord]:
        """The cameras."""
        for index, path in self.paths.items():
            number = self.file.item("nodes", index).get("camera")
            if number is not None:
                yield PlacedRecord(path, self.file.item("cameras", number), self.worlds[index])


def _skinned(file: GltfFile, primitive: Primitive, joints: Matrix) -> tuple[Primitive, Matrix]:
    assert primitive.joints is not None
    assert primitive.weights is not None
    if primitive.joints.max(initial=0) >= len(joints):
        raise file.bad("a vertex names a joint that its skin does not have")
    turn = np.einsum("vk,vkij->vij", primitive.weights, joints[primitive.joints])
    points = np.einsum("vij,vj->vi", turn[:, :3, :3], primitive.points) + turn[:, :3, 3]
    normals = np.einsum("vij,vj->vi", turn[:, :3, :3], primitive.normals)
    return Primitive(primitive.surface, points, primitive.faces, normals, primitive.uvs, primitive.colors), np.eye(4)


def _names(nodes: list[dict[str, Any]]) -> list[str]:
    """Names of the nodes; those that several share, or that are empty, carry the node's number."""
    named = [str(node.get("name") or "").strip() for node in nodes]
    count = Counter(named)
    return [name if name and count[name] == 1 else f"{name or 'node'}_{index}" for index, name in enumerate(named)]


def _local(node: dict[str, Any]) -> Matrix:
    """The matrix of a node in its parent."""
    if "matrix" in node:
        matrix = np.asarray(node["matrix"], dtype=float).reshape(4, 4).T
    else:
        matrix = np.eye(4)
        quaternion = np.asarray(node.get("rotation", (0, 0, 0, 1)), dtype=float)
        if not np.isfinite(quaternion).all() or np.linalg.norm(quaternion) < 1e-9:
            raise ValueError("a rotation is no quaternion")
        matrix[:3, :3] = Rotation.from_quat(quaternion).as_matrix() * np.asarray(node.get("scale", (1, 1, 1)), float)
        matrix[:3, 3] = np.asarray(node.get("translation", (0, 0, 0)), float)
    if not np.isfinite(matrix).all():
        raise ValueError("a transform has a number that is not finite")
    return matrix
