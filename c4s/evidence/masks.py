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
from c4s.render import Instance, Lights, Renderer, SurfaceMaterial
from c4s.render.masks import LEAST_VOLUME, camera_of, mask_name, visible, write_mask

Record = dict[str, Any]
_GREY = (SurfaceMaterial(),)


def with_masks(
    records: Sequence[Record], folder: Path, snapshot: Mapping[str, Any], packs: Sequence[Path]
) -> list[Record]:
    """The records of pictures in ``folder`` with the masks that they lack, which are written beside them."""
    if all("actors" in record for record in records):
        return list(records)
    names = [str(actor["name"]) for actor in snapshot["actors"]]
    labels = [str(actor["label"]) for actor in snapshot["actors"]]
    meshes, instances = _placed(snapshot, PackStore(packs))
    renderer = Renderer(meshes, instances, Lights())
    completed = []
    for record in records:
        picture = renderer.render(camera_of(record["camera"]), mode="base_color")
        write_mask(folder / mask_name(record["name"]), picture, names, labels)
        completed.append({**record, "actors": mask_name(record["name"]), "visible": visible(picture, names)})
    renderer.close()
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
