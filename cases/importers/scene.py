"""What every scene importer hands over, and how it becomes a pack and a level document."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from fnmatch import fnmatch
from pathlib import Path
from typing import Any

import numpy as np

from c4s.errors import BadInput
from c4s.files import json_text, read_json, write_json
from c4s.names import place_in
from c4s.packs.check import check_pack
from c4s.records.level import Level
from c4s.records.suite import IMPORTED_SCENE
from cases.corruption import with_identities
from cases.importers.collision import scene_collision
from cases.importers.imported import ImportedScene, SceneActor, SceneAsset
from cases.importers.level_actors import actors_of, cameras_of, lights_of
from cases.importers.wild import wild
from catalog.ingest.collision import AssetCollision, HullChoice
from catalog.ingest.colours import colours_of
from catalog.ingest.excess import excess_row, worst
from catalog.ingest.hulls import hull
from catalog.ingest.licence import Licence
from catalog.ingest.surface import SourcePart, Surface
from catalog.ingest.units import check_units, odd_sizes, words
from catalog.ingest.vocabulary import kind_of, readable, search_words
from catalog.ingest.writer import PackWriter, identifier

REPORT = "import.json"
GROUND, GROUND_BEYOND_CM, GROUND_CM, GROUND_COLOR = "c4s|ground", 400.0, 4.0, (0.23, 0.24, 0.2)
GROUND_GAP_CM = 0.2
"""What stands on a ground that was laid stands so far above it: what sinks by a rounding error counts as floating."""
AUTOMATIC = HullChoice()


def under(scene: ImportedScene, kept: Sequence[SceneActor]) -> tuple[SceneAsset, SceneActor]:
    """A flat ground under all actors and a little beyond, its pivot in its upper face."""
    low, high = np.full(3, np.inf), np.full(3, -np.inf)
    for actor in kept:
        for part in scene.assets[actor.asset].parts:
            points = part.vertices @ actor.matrix[:3, :3].T + actor.matrix[:3, 3]
            low, high = np.minimum(low, points.min(axis=0)), np.maximum(high, points.max(axis=0))
    middle, half = (low + high) / 2, (high - low) / 2 + GROUND_BEYOND_CM
    corners = np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]]) * half
    up, faces = np.tile([0.0, 0.0, 1.0], (4, 1)), np.array([[0, 1, 2], [0, 2, 3]])
    part = SourcePart("ground", Surface("ground", GROUND_COLOR, roughness=1.0), corners, faces, up, np.zeros((4, 2)))
    place = np.eye(4)
    place[:3, 3] = (*middle[:2], low[2] - GROUND_GAP_CM)
    body = hull(np.concatenate([corners, corners - [0, 0, GROUND_CM]]))
    return SceneAsset("ground", [part], [body], ground=True), SceneActor("Ground", GROUND, place)


def short_names(names: Iterable[str]) -> dict[str, str]:
    """Names without the words that all begin with and without the numbers that all end with."""
    every = sorted(set(names))
    split = [name.split("_") for name in every]
    shared = 0
    while len(every) > 2 and all(len(parts) > shared + 1 and parts[shared] == split[0][shared] for parts in split):
        shared += 1
    numbered = all(len(parts) > shared + 1 and parts[-1].isdigit() for parts in split)
    return {
        name: "_".join(parts[shared:-1] if numbered else parts[shared:])
        for name, parts in zip(every, split, strict=True)
    }


def write_scene(
    scene: ImportedScene,
    suite_id: str,
    *,
    source: Path,
    told: Licence,
    suites: Path,
    packs: Path,
    without: Sequence[str] = (),
    scale: float = 1.0,
    ground: bool = False,
    hulls: HullChoice = AUTOMATIC,
    replace: bool = False,
) -> dict[str, Any]:
    """Write the pack ``packs/<suite_id>`` and ``suites/<suite_id>/scene.level.json``; returns the report.

    ``told`` is the licence; ``without`` are patterns of actors' paths that are left out (a roof, say); ``scale`` is the
    factor that was applied, in units of which another is proposed; ``ground`` lays a plate under all of it. The report
    is written beside the level as ``import.json``. Raises ``BadInput`` when no actor is left; without ``replace`` also
    where another scene or pack of this name is there.
    """
    kept = [actor for actor in scene.actors if not any(fnmatch(actor.path, pattern) for pattern in without)]
    if not kept:
        reason = f"; {scene.skipped[0]['name']}: {scene.skipped[0]['reason']}" if scene.skipped else ""
        raise BadInput(f"no actor of this scene can be placed{reason}", where=str(source))
    if ground:
        scene.assets[GROUND], actor = under(scene, kept)
        kept.append(actor)
    for path, text in wild([(actor.path, actor.matrix) for actor in kept]).items():
        scene.note(path, text)
    count = Counter(actor.asset for actor in kept)
    for text in told.notes:
        scene.note("", text)
    with PackWriter(suite_id, packs, replace=replace) as writer:
        held: list[dict[str, Any]] = []
        paths, shown = {}, short_names(scene.assets[key].name for key in count)
        for key in sorted(count, key=lambda key: (scene.assets[key].name, key)):
            asset = scene.assets[key]
            own = (
                AssetCollision(asset.parts, asset.collision, "authored")
                if asset.ground and asset.collision
                else scene_collision(asset.parts, asset.collision, hulls.how(asset.name))
            )
            for text in own.notes:
                scene.note(asset.name, text)
            name = shown[asset.name]
            record = writer.add(
                name,
                asset.parts,
                own.bodies,
                category=kind_of(name) or (words(name) or ["props"])[-1],
                readable=readable(name),
                tags=search_words(name),
                source=own.source,
                description=f"{readable(name)}; {', '.join(colours_of(asset.parts))}; {count[key]} in the scene",
            )
            paths[key] = record.path
            held.append(excess_row(asset.name, own.shown, own.bodies))
        sizes = [(asset.name, max(asset.size_m)) for asset in writer.assets]
        level = with_identities(
            Level(
                package=f"/Game/{writer.folder_name}/Maps/{identifier(suite_id)}",
                actors=[
                    *actors_of(scene, kept, paths, suite_id),
                    *cameras_of(scene, suite_id),
                    *lights_of(scene, suite_id),
                ],
            ),
            suite_id,
        )
        folder = suites / suite_id
        if not replace:
            _refuse_other(folder / IMPORTED_SCENE, level)
        pack = writer.finish(
            title=f"Meshes of {source.stem}",
            license_id=told.id,
            license_text=told.text,
            ai_use=told.ai_use,
            description=f"Imported from {source.name}",
        )
    level.write(folder / IMPORTED_SCENE)
    units = check_units(sizes).proposed
    for index, odd in odd_sizes([(name, side * (units or 1.0)) for name, side in sizes]).items():
        scene.note(sizes[index][0], f"its size is unlike the others': {odd.reason}")
    proposed = None if scene.metric or units is None else float(f"{units * scale:.2g}")
    report = {
        "suite": suite_id,
        "level": str(folder / IMPORTED_SCENE),
        "package": level.package,
        "pack": pack.pack_id,
        "license": pack.license,
        "ai_use": pack.ai_use,
        "ai_use_reason": told.ai_reason,
        "actors": len(kept),
        "lights": len(scene.lights),
        "cameras": len(scene.cameras),
        "assets": len(pack.assets),
        "left_out": len(scene.actors) - len(kept),
        "skipped": scene.skipped,
        "skipped_kinds": dict(Counter(row["kind"] for row in scene.skipped).most_common()),
        "notes": scene.notes,
        "proposed_scale": proposed,
        "collision_excess": worst(held),
        "sha256": level.sha256(),
        "pack_sha256": pack.sha256(),
    }
    write_json(folder / REPORT, report)
    return report


def _refuse_other(path: Path, level: Level) -> None:
    """``BadInput`` where another level lies at ``path``."""
    if path.is_file() and path.read_bytes() != json_text(level.plain()).encode():
        raise BadInput(
            "another scene of this name lies here", where=str(path), todo="give --replace, or choose another --id"
        )


def imported_scene(suites: Path, packs: Path, name: str) -> Level:
    """The level of an imported scene; ``BadInput`` where there is none, or it or its pack was changed since."""
    path = place_in(suites, name, "scene") / IMPORTED_SCENE
    if not path.is_file():
        raise BadInput(f"no imported scene {name!r}", where=str(suites), todo="see `c4s suite import-scene`")
    level, report = Level.read(path), read_json(path.with_name(REPORT), what="import report")
    if level.sha256() != report.get("sha256"):
        todo = "restore the file, or import the scene again with --replace"
        raise BadInput("the file has changed since the scene was imported", where=str(path), todo=todo)
    check_pack(packs / name, report.get("pack_sha256"))
    return level
