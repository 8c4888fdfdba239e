"""The actors of an imported scene's level: placed meshes, cameras and lights."""

from __future__ import annotations

import re
from collections import Counter
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

from c4s.errors import BadInput
from c4s.records.level import LevelActor, LevelComponent, Transform
from c4s.render.textures import srgb_bytes
from cases.corruption import STATIC_MESH_ACTOR, STATIC_MESH_COMPONENT, guid_of
from cases.importers.imported import ImportedScene, SceneActor, SceneLight, place
from catalog.ingest.writer import identifier


def actors_of(scene: ImportedScene, kept: list[SceneActor], paths: dict[str, str], suite_id: str) -> list[LevelActor]:
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


def cameras_of(scene: ImportedScene, suite_id: str) -> list[LevelActor]:
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


def lights_of(scene: ImportedScene, suite_id: str) -> list[LevelActor]:
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
