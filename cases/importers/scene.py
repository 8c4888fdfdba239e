"""What every scene importer hands over, and how it becomes a pack and a level document."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from fnmatch import fnmatch
from pathlib import Path
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from c4s.errors import BadInput
from c4s.files import json_text, read_json, write_json
from c4s.geometry.transform import rotator_from_quat
from c4s.names import place_in
from c4s.packs.check import check_pack
from c4s.records.level import Level, LevelActor, LevelComponent, Transform
from c4s.records.pack import CollisionBody
from c4s.records.suite import IMPORTED_SCENE
from c4s.render.textures import srgb_bytes
from cases.corruption import STATIC_MESH_ACTOR, STATIC_MESH_COMPONENT, guid_of, with_identities
from cases.importers.collision import scene_collision
from cases.importers.wild import wild
from catalog.ingest.collision import AssetCollision, HullChoice
from catalog.ingest.colours import colours_of
from catalog.ingest.excess import excess_row, worst
from catalog.ingest.hulls import hull
from catalog.ingest.licence import licence
from catalog.ingest.surface import SourcePart, Surface
from catalog.ingest.units import check_units, odd_sizes, words
from catalog.ingest.vocabulary import kind_of, readable, search_words
from catalog.ingest.writer import PackWriter, identifier

Matrix = NDArray[np.float64]
REPORT = "import.json"
PLACE_DIGITS = 7
"""Of angles (degrees) and scale factors: a corner 100 m from its pivot stays within a thousandth of a millimetre."""
GROUND, GROUND_BEYOND_CM, GROUND_CM, GROUND_COLOR = "c4s|ground", 400.0, 4.0, (0.23, 0.24, 0.2)
GROUND_GAP_CM = 0.2
"""What stands on a ground that was laid stands so far above it: what sinks by a rounding error counts as floating."""
AUTOMATIC = HullChoice()


@dataclass
class SceneAsset:
    """A mesh that actors share: parts in cm and Unreal's axes about its pivot.

    ``ground``: its bodies are slabs under its surface, which nothing is to be seen of.
    """

    name: str
    parts: list[SourcePart]
    collision: list[CollisionBody] = field(default_factory=list)
    ground: bool = False


@dataclass
class SceneActor:
    """A placed mesh: its path in the source (``Cafe/chair_1``), its asset's key, its matrix (cm, Unreal's axes).

    ``movable``: the source says that it is not fixed to its place.
    """

    path: str
    asset: str
    matrix: Matrix
    movable: bool = False


@dataclass
class SceneLight:
    """A light: world matrix (it shines along X), linear colour and strength as in the engine.

    ``units`` of a point or spot light, the engine's own measure when left out; ``cone_deg`` are the inner and outer
    half angles of a spot light.
    """

    path: str
    kind: Literal["point", "spot", "directional"]
    matrix: Matrix
    color: tuple[float, float, float] = (1.0, 1.0, 1.0)
    intensity: float = 1.0
    radius_cm: float = 1000.0
    units: Literal["CANDELAS"] | None = None
    cone_deg: tuple[float, float] | None = None


@dataclass
class SceneCamera:
    """A camera: world matrix (it looks along X), horizontal field of view in degrees, width over height."""

    path: str
    matrix: Matrix
    fov_deg: float
    aspect: float


@dataclass
class ImportedScene:
    """A scene as an importer read it. ``skipped`` names what is not in it and why."""

    metric: bool = False
    """The format itself says that its unit is the metre."""
    assets: dict[str, SceneAsset] = field(default_factory=dict)
    actors: list[SceneActor] = field(default_factory=list)
    lights: list[SceneLight] = field(default_factory=list)
    cameras: list[SceneCamera] = field(default_factory=list)
    skipped: list[dict[str, str]] = field(default_factory=list)
    notes: list[dict[str, str]] = field(default_factory=list)

    def skip(self, name: str, reason: str, kind: str = "") -> None:
        """Record that something of the source is left out; what has one ``kind`` is told together.

        Without one it is the reason, its quoted names left out.
        """
        self.skipped.append({"name": name, "reason": reason, "kind": _kind(kind or reason)})

    def note(self, name: str, text: str) -> None:
        """Record something about what was read, once."""
        row = {"name": name, "note": text}
        if row not in self.notes:
            self.notes.append(row)


def _kind(reason: str) -> str:
    """A reason without what it says of one thing alone: quoted names, what stands in brackets or behind a colon."""
    return " ".join(re.sub(r"'[^']*'|\([^)]*\)|: .*", " ", reason).split()) or reason


def place(matrix: Matrix) -> tuple[Transform, bool]:
    """Location, rotation and scale of a matrix, and whether it has a shear that these cannot hold."""
    scale = np.linalg.norm(matrix[:3, :3], axis=0)
    if not np.isfinite(matrix).all() or scale.min() < 1e-9:
        raise BadInput("an actor's transform has a number that is not finite, or a scale of nothing")
    axes = matrix[:3, :3] / scale
    if np.linalg.det(axes) < 0:
        scale[0], axes[:, 0] = -scale[0], -axes[:, 0]
    sheared = bool(np.abs(axes.T @ axes - np.eye(3)).max() > 1e-3)
    u, _, v = np.linalg.svd(axes)
    rotation = rotator_from_quat(Rotation.from_matrix(u @ v).as_quat().tolist())
    place = [
        tuple(round(float(value), digits) + 0.0 for value in values)
        for values, digits in ((matrix[:3, 3], 4), (rotation, PLACE_DIGITS), (scale, PLACE_DIGITS))
    ]
    return Transform(location_cm=place[0], rotation_deg=place[1], scale=place[2]), sheared


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
    license_folder: Path,
    suites: Path,
    packs: Path,
    without: Sequence[str] = (),
    scale: float = 1.0,
    ground: bool = False,
    hulls: HullChoice = AUTOMATIC,
    replace: bool = False,
) -> dict[str, Any]:
    """Write the pack ``packs/<suite_id>`` and ``suites/<suite_id>/scene.level.json``; returns the report.

    ``without`` are patterns of actors' paths that are left out (a roof, say); ``scale`` is the factor that was applied,
    in units of which another is proposed; ``ground`` lays a plate under all of it. The report is written beside the
    level as ``import.json``. Raises ``BadInput`` when no actor is left; without ``replace`` also where another scene or
    pack of this name is there.
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
    told = licence(license_folder)
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
                actors=[*_actors(scene, kept, paths, suite_id), *_cameras(scene, suite_id), *_lights(scene, suite_id)],
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


def _actors(scene: ImportedScene, kept: list[SceneActor], paths: dict[str, str], suite_id: str) -> list[LevelActor]:
    names: Counter[str] = Counter()
    actors = []
    for actor in kept:
        try:
            transform, sheared = place(actor.matrix)
        except BadInput as error:
            scene.skip(actor.path, error.what)
            continue
        if sheared:
            scene.note(actor.path, "its shear is left out")
        name = _unique(identifier(re.sub(r"(?<![A-Za-z0-9])-(?=[0-9])", "minus", actor.path)), names)
        properties = {"mobility": "MOVABLE"} if actor.movable else {}
        actors.append(
            LevelActor(
                name=name,
                label=name,
                class_path=STATIC_MESH_ACTOR,
                guid=guid_of(f"{suite_id}|{name}"),
                transform=transform,
                folder=actor.path.rpartition("/")[0],
                components=[
                    LevelComponent(
                        name="StaticMeshComponent0",
                        class_path=STATIC_MESH_COMPONENT,
                        static_mesh=paths[actor.asset],
                        properties=properties,
                    )
                ],
            )
        )
    return actors


def _cameras(scene: ImportedScene, suite_id: str) -> list[LevelActor]:
    names: Counter[str] = Counter()
    actors = []
    for camera in scene.cameras:
        name = _unique(identifier(f"Camera_{camera.path.rpartition('/')[2]}"), names)
        actors.append(
            LevelActor(
                name=name,
                label=name,
                class_path="/Script/Engine.CameraActor",
                guid=guid_of(f"{suite_id}|{name}"),
                transform=place(camera.matrix)[0],
                components=[
                    LevelComponent(name="SceneComponent", class_path="/Script/Engine.SceneComponent"),
                    LevelComponent(
                        name="CameraComponent",
                        class_path="/Script/Engine.CameraComponent",
                        properties={"field_of_view": camera.fov_deg, "aspect_ratio": camera.aspect},
                    ),
                ],
            )
        )
    return actors


def _lights(scene: ImportedScene, suite_id: str) -> list[LevelActor]:
    """The scene's lights; where it has no sun, a sun and a sky that make an indoor scene readable."""
    lights = list(scene.lights)
    if not any(light.kind == "directional" for light in lights):
        down = np.eye(4)
        down[:3, :3] = Rotation.from_euler("ZY", [35, 60], degrees=True).as_matrix()
        lights.append(SceneLight("LightSun", "directional", down, intensity=4.0))
    names: Counter[str] = Counter()
    actors = []
    for light in lights:
        kind = {"point": "PointLight", "spot": "SpotLight", "directional": "DirectionalLight"}[light.kind]
        properties: dict[str, Any] = {"intensity": light.intensity, "light_color": [*_srgb_bytes(light.color), 255]}
        if light.kind != "directional":
            properties["attenuation_radius"] = light.radius_cm
        if light.units is not None:
            properties["intensity_units"] = light.units
        if light.cone_deg is not None:
            properties |= {"inner_cone_angle": light.cone_deg[0], "outer_cone_angle": light.cone_deg[1]}
        name = _unique(identifier(f"Light_{light.path.removeprefix('Light')}"), names)
        actors.append(_light(name, kind, place(light.matrix)[0], properties, suite_id))
    return [*actors, _light("Light_Sky", "SkyLight", Transform(), {"intensity": 1.0}, suite_id)]


def _srgb_bytes(color: tuple[float, float, float]) -> list[int]:
    """Linear colour as the engine keeps that of a light."""
    return [int(value) for value in srgb_bytes(np.asarray(color, dtype=np.float32))]


def _light(name: str, kind: str, transform: Transform, properties: dict[str, Any], suite_id: str) -> LevelActor:
    component = "SkyLightComponent0" if kind == "SkyLight" else "LightComponent0"
    return LevelActor(
        name=name,
        label=name,
        class_path=f"/Script/Engine.{kind}",
        guid=guid_of(f"{suite_id}|{name}"),
        transform=transform,
        components=[
            LevelComponent(name=component, class_path=f"/Script/Engine.{kind}Component", properties=properties)
        ],
    )


def _unique(name: str, names: Counter[str]) -> str:
    names[name.lower()] += 1
    number = names[name.lower()]
    return name if number == 1 else _unique(f"{re.sub(r'_x[0-9]+$', '', name)}_x{number}", names)
