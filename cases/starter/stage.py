"""What placing indoors and outdoors have in common: actors of one level with reproducible ids, meshes and lights."""

from __future__ import annotations

from typing import Any

from c4s.errors import BadInput
from c4s.records.level import LevelActor, LevelComponent, Transform
from cases.corruption import STATIC_MESH_ACTOR, STATIC_MESH_COMPONENT, guid_of

COMPONENTS = {
    "SkyLight": "SkyLightComponent0",
    "SkyAtmosphere": "SkyAtmosphereComponent",
    "ExponentialHeightFog": "HeightFogComponent0",
}
"""Names of root components that are not ``LightComponent0``."""


class Stage:
    """The actors of a level under construction.

    Args:
        scene_id: names the level; GUIDs follow from it and the actors' names.
        paths: asset path by name without ``SM_`` and ``BP_``.
    """

    def __init__(self, scene_id: str, paths: dict[str, str]) -> None:
        self.scene_id, self.paths = scene_id, paths
        self.actors: list[LevelActor] = []
        self.outliner_folder = ""

    def path(self, asset: str) -> str:
        """Path of an asset by its name; ``BadInput`` when no pack of the level has it."""
        if asset not in self.paths:
            raise BadInput("no pack of this level has this asset", where=f"{self.scene_id}: {asset}")
        return self.paths[asset]

    def add_actor(self, name: str, class_path: str, place: Transform, components: list[LevelComponent]) -> str:
        """Add an actor under an object name that is also its label; returns the name."""
        self.actors.append(
            LevelActor(
                name=name,
                label=name,
                class_path=class_path,
                transform=place,
                guid=guid_of(f"{self.scene_id}|{name}"),
                components=components,
                folder=self.outliner_folder,
            )
        )
        return name

    def add_mesh(self, name: str, asset: str, place: Transform) -> str:
        """Add a static mesh actor that shows an asset."""
        return self.add_actor(
            name,
            STATIC_MESH_ACTOR,
            place,
            [
                LevelComponent(
                    name="StaticMeshComponent0", class_path=STATIC_MESH_COMPONENT, static_mesh=self.path(asset)
                )
            ],
        )

    def add_light(self, name: str, kind: str, place: Transform, **properties: Any) -> str:
        """Add a light, fog or atmosphere: ``kind`` is its class, ``properties`` are those of its component."""
        component = LevelComponent(
            name=COMPONENTS.get(kind, "LightComponent0"),
            class_path=f"/Script/Engine.{kind}Component",
            properties=properties,
        )
        return self.add_actor(name, f"/Script/Engine.{kind}", place, [component])

    def add_air(self) -> None:
        """Atmosphere and thin fog, as a level has them that was set up for pictures."""
        self.add_light("SkyAtmosphere_0", "SkyAtmosphere", Transform())
        self.add_light("Fog_0", "ExponentialHeightFog", Transform(), fog_density=0.002, fog_max_opacity=0.6)


def asset_path(content_folder: str, category: str, name: str) -> str:
    """Path of a static mesh, as the pack builder makes it."""
    return f"/Game/{content_folder}/{category.title()}/SM_{name}.SM_{name}"
