"""Actor masks for pictures of an engine that has none: traced from the snapshot and the meshes of the packs.

A real editor draws a picture and cannot tell which actor a pixel shows. Where each mesh stands is in its snapshot, and
the packs hold the meshes, so the same camera sees the same actors here. Meshes that no pack holds are not in the mask.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from c4s.geometry.transform import affine
from c4s.packs.meshes import Mesh
from c4s.packs.store import PackStore
from c4s.render import Instance, Lights, Picture, Renderer, SurfaceMaterial
from c4s.render.masks import LEAST_VOLUME, camera_of, glimpse, mask_name, visible, write_mask

Record = dict[str, Any]
_GREY = (SurfaceMaterial(),)


class Tracer:
    """A scene as its snapshot and the packs tell it, ready to say which actor a pixel shows."""

    def __init__(self, snapshot: Mapping[str, Any], packs: Sequence[Path]) -> None:
        self.names = [str(actor["name"]) for actor in snapshot["actors"]]
        self.labels = [str(actor["label"]) for actor in snapshot["actors"]]
        meshes, instances = _placed(snapshot, PackStore(packs))
        self._renderer = Renderer(meshes, instances, Lights())

    def picture(self, camera: Mapping[str, Any], samples: int = 4) -> Picture:
        """A picture without light, of which mask and depth count."""
        return self._renderer.render(camera_of(camera), mode="base_color", samples=samples)

    def glimpses(self, cameras: Sequence[Mapping[str, Any]]) -> list[Record]:
        """What each camera would see."""
        return [glimpse(self.picture(camera, samples=1), self.names) for camera in cameras]


def with_masks(records: Sequence[Record], folder: Path, tracer: Tracer) -> list[Record]:
    """The records of pictures in ``folder`` with masks, which are written beside them."""
    completed = []
    for record in records:
        picture = tracer.picture(record["camera"])
        write_mask(folder / mask_name(record["name"]), picture, tracer.names, tracer.labels)
        completed.append({**record, "actors": mask_name(record["name"]), "visible": visible(picture, tracer.names)})
    return completed


def _placed(snapshot: Mapping[str, Any], store: PackStore) -> tuple[list[Mesh], list[Instance]]:
    """The meshes that a snapshot shows, and where."""
    numbers: dict[str, int | None] = {}
    meshes: list[Mesh] = []
    instances = []
    facts = snapshot["c4s"]["meshes"]
    for index, actor in enumerate(snapshot["actors"]):
        for path, place in _shown(actor):
            if path not in numbers:
                mesh = store.recorded_mesh(path, facts.get(path) or {})
                numbers[path] = None if mesh is None else len(meshes)
                meshes += [mesh] if mesh is not None else []
            number = numbers[path]
            matrix = affine(place["location_cm"], place["rotation_deg"], place["scale"])
            if number is not None and abs(np.linalg.det(matrix[:3, :3])) >= LEAST_VOLUME:
                instances.append(Instance(number, matrix, _GREY, index))
    return meshes, instances


def _shown(actor: Mapping[str, Any]) -> Iterator[tuple[str, Mapping[str, Any]]]:
    """Paths and places of the meshes of an actor that pictures show."""
    if actor["c4s"]["hidden"] or actor["export_diagnostics"]["hidden_in_editor"]:
        return
    for part in actor["c4s"]["components"]:
        if part["mesh"] and part["visible"]:
            for place in part.get("instances") or [part["transform"]]:
                yield part["mesh"], place
