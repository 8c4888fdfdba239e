"""The node tree of a glTF, GLB or DAE file as a scene: a node with a mesh is an actor; a mesh is an asset.

Instances of EXT_mesh_gpu_instancing are actors of their own. Cameras and the lights of KHR_lights_punctual come along.
"""

from __future__ import annotations

import math
import re
from collections import defaultdict
from pathlib import Path
from typing import Any, Literal

import numpy as np

from c4s.errors import BadInput
from cases.importers.imported import ImportedScene, Matrix, SceneActor, SceneAsset, SceneCamera, SceneLight
from catalog.ingest.gltf_file import GltfFile
from catalog.ingest.gltf_tree import GltfTree, Placed, PlacedRecord
from catalog.ingest.source import GLTF, TO_UNREAL, gltf_parts, part_of
from catalog.ingest.surface import SourcePart, color_of
from catalog.ingest.trimesh_file import TrimeshFile

SUN_LIMIT = 10.0
"""Brightest sun (lux): writers of glTF give anything from 1 to 100,000 for daylight."""
ENDLESS_CM = 100_000.0
"""Reach of a light without a range."""


def read_tree(path: Path, *, scale: float = 1.0) -> ImportedScene:
    """Read a node tree.

    Args:
        path: the file.
        scale: metres per unit of the file.

    Raises:
        BadInput: the file cannot be read. Nodes whose mesh cannot be used are named in ``skipped``.
    """
    return _Gltf(path, scale).read() if path.suffix.lower() in GLTF else _read_collada(path, scale)


class _Gltf:
    def __init__(self, path: Path, scale: float) -> None:
        self.path, self.scale = path, scale
        self.axes = np.asarray(TO_UNREAL["y"], dtype=float)
        self.tree = GltfTree(GltfFile(path, path.parent))
        self.scene = ImportedScene()
        self.light_factor = _light_factor(self.tree.file.tree)

    def read(self) -> ImportedScene:
        for placed in self.tree.placed():
            name = "/".join(placed.path)
            try:
                key = f"{placed.mesh}|{placed.weights}|{placed.node if placed.skin is not None else ''}"
                if key not in self.scene.assets:
                    self.scene.assets[key] = self._asset(placed)
                matrix = np.eye(4) if placed.skin is not None else placed.matrix
                self.scene.actors.append(SceneActor(name, key, in_unreal(matrix, self.axes, self.scale)))
            except BadInput as error:
                self.scene.skip(name, error.what)
        for light in self.tree.lights():
            self._light(light)
        for camera in self.tree.cameras():
            self._camera(camera)
        for text in self.tree.file.notes:
            self.scene.note(self.path.name, text)
        return self.scene

    def _asset(self, placed: Placed) -> SceneAsset:
        """The mesh about its node's pivot; a skinned one, which has no place of its own, about the scene's origin."""
        record = self.tree.file.item("meshes", placed.mesh)
        still = Placed(placed.node, placed.path, placed.mesh, np.eye(4), placed.weights, placed.skin)
        parts = list(gltf_parts(self.tree, still, self.axes, self.scale, self.path))
        return checked(SceneAsset(str(record.get("name") or placed.path[-1]), parts))

    def _light(self, placed: PlacedRecord) -> None:
        name, record = "/".join(placed.path), placed.record
        kinds: dict[str, Literal["point", "spot", "directional"]] = {
            "point": "point",
            "spot": "spot",
            "directional": "directional",
        }
        kind = kinds.get(str(record.get("type")))
        try:
            color = color_of(record.get("color", (1, 1, 1)))
            intensity = float(record.get("intensity", 1)) / self.light_factor
            reach = float(record.get("range", 0)) * 100 * self.scale or ENDLESS_CM
            cone = record.get("spot", {})
            angles = (
                math.degrees(float(cone.get("innerConeAngle", 0))),
                math.degrees(float(cone.get("outerConeAngle", math.pi / 4))),
            )
            if kind is None or not math.isfinite(intensity) or not 0 < reach < math.inf:
                raise ValueError
        except (TypeError, ValueError, AttributeError):
            self.scene.skip(name, f"a light of type {record.get('type')!r} that cannot be used")
            return
        if kind == "directional" and intensity > SUN_LIMIT:
            self.scene.note(name, f"a sun of {intensity:g} lux is shown with {SUN_LIMIT:g}")
            intensity = SUN_LIMIT
        self.scene.lights.append(
            SceneLight(
                name,
                kind,
                self._looking(placed.matrix),
                color,
                intensity,
                min(reach, ENDLESS_CM),
                units=None if kind == "directional" else "CANDELAS",
                cone_deg=angles if kind == "spot" else None,
            )
        )

    def _camera(self, placed: PlacedRecord) -> None:
        name, lens = "/".join(placed.path), placed.record.get("perspective") or {}
        try:
            vertical = float(lens["yfov"])
            aspect = float(lens.get("aspectRatio", 16 / 9))
            fov = math.degrees(2 * math.atan(math.tan(vertical / 2) * aspect))
        except (TypeError, ValueError, KeyError):
            self.scene.skip(name, "a camera that is not a perspective one")
            return
        self.scene.cameras.append(SceneCamera(name, self._looking(placed.matrix), round(fov, 4), round(aspect, 4)))

    def _looking(self, matrix: Matrix) -> Matrix:
        """The pose of a light or camera, which looks along its X here and along -Z in glTF; its scale is left out."""
        turned = in_unreal(matrix, self.axes, self.scale)
        axes = turned[:3, :3] / np.maximum(np.linalg.norm(turned[:3, :3], axis=0), 1e-12)
        forward, up = -axes[:, 1], axes[:, 2]
        turned[:3, :3] = np.column_stack([forward, np.cross(up, forward), up])
        return turned


def _light_factor(tree: dict[str, Any]) -> float:
    """What a file of ``c4s engine export`` says that its lights were multiplied by; 1 for any other file."""
    asset = tree.get("asset")
    extras = asset.get("extras") if isinstance(asset, dict) else None
    factor = extras.get("light_factor") if isinstance(extras, dict) else None
    return float(factor) if isinstance(factor, int | float) and math.isfinite(factor) and factor > 0 else 1.0


def _read_collada(path: Path, scale: float) -> ImportedScene:
    file, scene = TrimeshFile(path, path.parent), ImportedScene()
    axes, unit = np.asarray(TO_UNREAL[file.up], dtype=float), scale * file.unit_m
    parents = file.scene.graph.transforms.parents
    owners: dict[str, list[str]] = defaultdict(list)
    matrices = {}
    for node, name, matrix in file.geometries():
        owners[node].append(name)
        matrices[node] = matrix
    for node, names in owners.items():
        key = "|".join(sorted(names))
        try:
            if key not in scene.assets:
                scene.assets[key] = _collada_asset(file, sorted(names), axes, unit)
            scene.actors.append(SceneActor(_path(node, parents), key, in_unreal(matrices[node], axes, unit)))
        except BadInput as error:
            scene.skip(node, error.what)
    for text in file.notes:
        scene.note(path.name, text)
    return scene


def _collada_asset(file: TrimeshFile, names: list[str], axes: Matrix, unit: float) -> SceneAsset:
    parts: list[SourcePart] = []
    for name in names:
        arrays = file.arrays(name)
        if arrays is not None:
            parts.append(part_of(name, *arrays, np.eye(4), axes, unit, file.path))
    return checked(SceneAsset(re.sub(r"_[0-9a-f]{6}$", "", names[0]), parts))


def checked(asset: SceneAsset) -> SceneAsset:
    """The asset; ``BadInput`` when there is nothing of it to see."""
    if not asset.parts:
        raise BadInput("its mesh has no triangles")
    if np.count_nonzero(np.ptp(np.concatenate([part.vertices for part in asset.parts]), axis=0) > 1e-4) < 2:
        raise BadInput("its mesh has no extent")
    return asset


def in_unreal(matrix: Matrix, axes: Matrix, scale: float) -> Matrix:
    """A matrix of the file's axes and units in Unreal's axes and cm."""
    turn = np.eye(4)
    turn[:3, :3] = axes
    turned: Matrix = turn @ np.asarray(matrix, float) @ turn.T
    turned[:3, 3] *= 100 * scale
    return turned


def _path(node: str, parents: dict[Any, Any]) -> str:
    """The names from below the root to the node."""
    names = [node]
    while names[-1] in parents:
        names.append(str(parents[names[-1]]))
    return "/".join(reversed(names[:-1])) if len(names) > 1 else node
