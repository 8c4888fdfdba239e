"""``c4s suite import-scene``: chooses the importer by the file's ending."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from c4s.errors import BadInput
from c4s.names import check_written, checked_id, place_in
from cases.importers.blend import read_blend
from cases.importers.gltf import read_tree
from cases.importers.imported import ImportedScene
from cases.importers.scene import write_scene
from cases.importers.sdf import read_sdf, scene_root
from cases.importers.table import read_table
from catalog.ingest.collision import How, HullChoice
from catalog.ingest.licence import licence

SDF, TREE, TABLE, BLEND = (".world", ".sdf"), (".gltf", ".glb", ".dae"), (".csv",), (".blend",)


def import_scene(
    source: Path | Sequence[Path],
    suite_id: str,
    *,
    suites: Path,
    packs: Path,
    scale: float = 1.0,
    without: Sequence[str] = (),
    meshes: Sequence[str] = (),
    resources: Sequence[Path] = (),
    ground: bool = False,
    hulls: How = "auto",
    hulls_of: Sequence[str] = (),
    license_file: Path | None = None,
    replace: bool = False,
    progress: Callable[[str], None] | None = None,
) -> dict[str, Any]:
    """Bring a scene file in as pack ``suite_id`` and ``suites/<suite_id>/scene.level.json``; returns the report.

    Args:
        source: SDF world, glTF/GLB/DAE node tree, Blender file, or placement table; several SDF worlds join.
        suite_id: id of the pack and name of the folder; a suite with cases of this name is not touched.
        suites: where suites lie.
        packs: where packs lie.
        scale: metres per unit; SDF is metres by definition.
        without: patterns of actors that are left out.
        meshes: ``NAME=FILE`` or ``NAME=FILE#PART,PART``: meshes of an SDF world that are read from another file.
        resources: further folders in which an SDF world's models are looked for.
        ground: lay a flat ground under all of it: tiles and islands stand on nothing else.
        hulls: how collision is made where the scene states none; ``auto`` also where that is far from the mesh.
        hulls_of: other choices for some things by the name of their mesh, as ``bench*=decompose``; the last that fits.
        license_file: the file that tells the licence; found in and around the scene's folder when left out.
        replace: put the scene and its pack in the place of others of this name.
        progress: told what is being read.

    Raises:
        BadInput: an unknown kind of file, a bad id, a file that is wrong as a whole, or nothing that can be placed.
    """
    place_in(suites, checked_id(suite_id, "pack"), "scene")
    sources = [source] if isinstance(source, Path) else list(source)
    for path in sources:
        check_written(path)
        if not path.is_file():
            raise BadInput("no such file", where=str(path))
    source, kind = sources[0], sources[0].suffix.lower()
    if len(sources) > 1 and not all(path.suffix.lower() in SDF for path in sources):
        raise BadInput("only SDF worlds join into one scene", where=str(sources[1]))
    for folder in resources:
        if not folder.is_dir():
            raise BadInput("no such folder", where=f"--resources {folder}")
    if resources and kind not in SDF:
        raise BadInput("only an SDF world has models in other folders", where=f"--resources {resources[0]}")
    if not np.isfinite(scale) or not 1e-6 <= scale <= 1e6:
        raise BadInput("the scale must be a positive number", where=f"--scale {scale}")
    if (suites / suite_id / "suite.json").exists():
        raise BadInput("a suite of this name exists", where=suite_id, todo="choose another --id")
    if meshes and kind not in SDF:
        raise BadInput("only meshes of an SDF world can be read from another file", where=f"--mesh {meshes[0]}")
    choice = HullChoice.parse(hulls, hulls_of)
    folder, scene = source.parent, ImportedScene()
    if kind in SDF:
        if scale != 1.0:
            raise BadInput("SDF is in metres", where=f"--scale {scale}", todo="leave --scale out")
        scene, folder = read_sdf(sources, progress, _replacements(meshes), resources), scene_root(source)
    elif kind in TREE:
        scene = read_tree(source, scale=scale)
    elif kind in BLEND:
        scene = read_blend(source, scale=scale)
    elif kind in TABLE:
        scene = read_table(source, scale=scale)
    else:
        raise BadInput(
            f"no importer for {kind or 'this file'}",
            where=str(source),
            todo=f"it reads {', '.join(SDF + TREE + TABLE + BLEND)}",
        )
    return write_scene(
        scene,
        suite_id,
        source=source,
        told=licence(folder, [source], given=license_file),
        suites=suites,
        packs=packs,
        without=without,
        scale=scale,
        ground=ground,
        hulls=choice,
        replace=replace,
    )


def _replacements(rows: Sequence[str]) -> dict[str, str]:
    found = {}
    for row in rows:
        name, equals, file = row.partition("=")
        if not (name and equals and file):
            raise BadInput("a mesh is named as NAME=FILE or NAME=FILE#PART", where=f"--mesh {row}")
        found[name.strip()] = file.strip()
    return found
