"""Rows of ``scenes`` and ``shapes``, of public cases alone: of private ones nothing is kept that a page could show."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any, Final

from c4s.files import digest_file
from c4s.records.captures import Captures
from c4s.records.folder import EvidenceFolder
from c4s.records.snapshot import read_snapshot
from c4s.records.suite import AgentCase, WithheldCase, WithheldFolder
from warehouse.parquet import is_whole, part_path, write_part
from warehouse.records import SceneRow, ShapeRow
from warehouse.scenes.content import Content, content_of
from warehouse.scenes.document import Json, document_of, packed
from warehouse.scenes.shapes import mesh_bytes, texture_bytes

SHAPE_PARTITION: Final = "_shapes"
"""Partition of the shapes, which belong to packs, not to a configuration."""


def case_scenes(
    agent: AgentCase, withheld: WithheldCase, folder: WithheldFolder, key: Mapping[str, Any], warehouse: Path
) -> Iterator[SceneRow]:
    """The start and the truth of a public case; the shapes that they show are kept too."""
    if withheld.visibility == "private":
        return
    for role, path in (("start", folder.input_snapshot), ("truth", folder.truth_snapshot)):
        if path.is_file():
            yield _row(path, agent, {**key, "role": role}, "[]", warehouse)


def trial_scene(
    agent: AgentCase, withheld: WithheldCase, folder: EvidenceFolder, key: Mapping[str, Any], warehouse: Path
) -> Iterator[SceneRow]:
    """What a trial of a public case left, with the cameras of its evidence; nothing where no scene was exported."""
    if withheld.visibility == "private" or not folder.snapshot.is_file():
        return
    views = []
    if folder.captures_index.is_file():
        for view in Captures.read(folder.captures_index).views:
            told = view.camera.plain()
            views.append({"name": view.name, "purpose": view.purpose, **told})
    yield _row(folder.snapshot, agent, {**key, "role": "submission"}, json.dumps(views), warehouse)


def _row(path: Path, agent: AgentCase, key: Mapping[str, Any], views: str, warehouse: Path) -> SceneRow:
    snapshot, content = read_snapshot(path), content_of(agent)
    document = document_of(snapshot, content)
    keep_shapes(document, (snapshot.get("c4s") or {}).get("meshes", {}), content, warehouse, key["suite"])
    return SceneRow(
        **key, actors=len(document["actors"]), views=views, document=packed(document), snapshot_sha256=digest_file(path)
    )


def keep_shapes(
    document: Json, facts: Mapping[str, Mapping[str, Any]], content: Content, warehouse: Path, suite: str
) -> None:
    """Write the meshes and textures of a document that the warehouse does not hold yet, a part each."""

    def is_kept(sha256: str) -> bool:
        return is_whole(part_path(warehouse, "shapes", suite, SHAPE_PARTITION, sha256))

    def keep(row: ShapeRow) -> None:
        write_part(warehouse, "shapes", [row], suite=suite, configuration=SHAPE_PARTITION, key=row.shape_sha256)

    place = {"suite": suite, "configuration": SHAPE_PARTITION}
    for path, sha256, _, _ in document["meshes"]:
        if sha256 and not is_kept(sha256) and (mesh := content.mesh(path, facts.get(path) or {})) is not None:
            data, triangles = mesh_bytes(mesh)
            keep(ShapeRow(**place, shape_sha256=sha256, kind="mesh", path=path, triangles=triangles, data=data))
    for look in document["materials"]:
        sha256 = look.get("texture", "")
        material = content.material(look["path"]) if sha256 and not is_kept(sha256) else None
        texture = content.texture(material) if material else None
        if texture:
            data = texture_bytes(texture[1], holes="cut" in look)
            keep(ShapeRow(**place, shape_sha256=sha256, kind="texture", path=look["path"], triangles=0, data=data))
