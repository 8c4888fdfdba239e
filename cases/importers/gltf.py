"""The node tree of a glTF, GLB or DAE file as a scene: a node with a mesh is an actor; a mesh is an asset."""

from __future__ import annotations

import re
from collections import defaultdict
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from c4s.errors import BadInput
from cases.importers.scene import ImportedScene, SceneActor, SceneAsset
from catalog.ingest.source import OpenFile


def read_tree(path: Path, *, scale: float = 1.0) -> ImportedScene:
    """Read a node tree.

    Args:
        path: the file.
        scale: metres per unit of the file.

    Raises:
        BadInput: the file cannot be read. Nodes whose mesh cannot be used are named in ``skipped``.
    """
    opened = OpenFile(path, path.parent, scale=scale)
    graph, scene = opened.scene.graph, ImportedScene()
    parents = graph.transforms.parents
    for text in opened.notes:
        scene.note(path.name, text)
    owners: dict[str, list[str]] = defaultdict(list)
    for node in graph.nodes_geometry:
        name = graph[node][1]
        split = opened.scene.geometry[name].metadata.get("from_gltf_primitive") and node in parents
        owners[str(parents[node] if split else node)].append(str(name))
    axes = np.eye(4)
    axes[:3, :3] = opened.axes
    for owner, names in owners.items():
        key = "|".join(sorted(names))
        try:
            if key not in scene.assets:
                scene.assets[key] = _asset(opened, sorted(names), scene)
            matrix = axes @ np.asarray(graph[owner][0], float) @ axes.T
            matrix[:3, 3] *= 100 * opened.scale
            scene.actors.append(SceneActor(_path(owner, parents), key, matrix))
        except BadInput as error:
            scene.skip(owner, error.what)
    return scene


def _asset(opened: OpenFile, names: list[str], scene: ImportedScene) -> SceneAsset:
    parts, notes = [], list[str]()
    for name in names:
        geometry: Any = opened.scene.geometry[name]
        if len(getattr(geometry, "faces", ())):
            parts.append(opened.part(name, geometry, _identity(), opened.surfaces.read(geometry.visual, notes)))
    if not parts:
        raise BadInput("its mesh has no triangles")
    if np.count_nonzero(np.ptp(np.concatenate([part.vertices for part in parts]), axis=0) > 1e-4) < 2:
        raise BadInput("its mesh has no extent")
    for text in notes:
        scene.note(names[0], text)
    return SceneAsset(re.sub(r"_[0-9a-f]{6}$", "", names[0]), parts)


def _identity() -> NDArray[np.float64]:
    return np.eye(4)


def _path(node: str, parents: dict[str, str]) -> str:
    """The names from below the root to the node."""
    names = [node]
    while names[-1] in parents:
        names.append(parents[names[-1]])
    return "/".join(reversed(names[:-1])) if len(names) > 1 else node
