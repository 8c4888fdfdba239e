"""From the open level to pictures: meshes, materials and the level's own lights for the renderer.

A level without lights gets a clear day, so that it can be read; one with lights is lit by them alone, with a dim
ambient. Colours are linear RGB, intensities as in Unreal: lux for the sun, candelas for local lights.
"""

from __future__ import annotations

import functools
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from c4s.engine.headless.render import (
    Camera,
    Instance,
    Lights,
    LocalLight,
    Picture,
    Renderer,
    Sky,
    Sun,
    SurfaceMaterial,
)
from c4s.packs.manifest import Material
from c4s.packs.meshes import Mesh
from c4s.packs.store import PackStore

_UNITLESS_PER_CANDELA = 625.0
_LUMEN_PER_CANDELA = 4 * np.pi
_DIM_SKY = Sky(light=0.25)
_EV_OF_ONE_CANDELA = 3.0
_RECTANGLE_CONE_DEG = (45.0, 88.0)
_MIN_SUN_DEG = 0.3
_MIN_SKY = 0.05
_MIN_VOLUME = 1e-9


@dataclass(frozen=True)
class Scene:
    """A level ready for pictures; masks hold indices into ``names`` and ``labels``."""

    renderer: Renderer
    names: tuple[str, ...]
    labels: tuple[str, ...]


def attach() -> None:
    """Make ``c4s.editor.capture`` take its pictures here."""
    from c4s.editor import capture

    capture.source = take


def take(cameras: Sequence[Mapping[str, Any]], files: Sequence[str], mode: str, masks: bool) -> list[dict[str, Any]]:
    """Render the open level from ``cameras`` into PNG files, with ``masks`` into ``<stem>.actors.npz`` too."""
    scene = open_level()
    records = []
    for view, name in zip(cameras, files, strict=True):
        picture = scene.renderer.render(camera_of(view), mode="base_color" if mode == "base_color" else "lit",
                                        exposure_bias_ev=float(view.get("exposure_bias_ev") or 0.0))
        path = Path(name)
        Image.fromarray(picture.rgb).save(path, format="PNG")
        if masks:
            write_mask(path.with_suffix(".actors.npz"), picture, scene)
        records.append({"visible": visible(picture, scene)})
    scene.renderer.close()
    return records


def camera_of(view: Mapping[str, Any]) -> Camera:
    """A camera from ``location_cm``, ``rotation_deg`` ([pitch, yaw, roll]), ``fov_deg`` (horizontal), and its size."""
    x, y, z = (float(value) for value in view["location_cm"])
    pitch, yaw, roll = (float(value) for value in view["rotation_deg"])
    return Camera((x, y, z), (pitch, yaw, roll), float(view["fov_deg"]), int(view["width"]), int(view["height"]))


def write_mask(path: Path, picture: Picture, scene: Scene) -> None:
    """Write the actor mask and depth of a picture with the table of its actors."""
    with path.open("wb") as file:
        np.savez_compressed(file, actor=picture.actor, depth_cm=picture.depth_cm.astype(np.float32),
                            names=np.array(scene.names, dtype=np.str_), labels=np.array(scene.labels, dtype=np.str_))


def visible(picture: Picture, scene: Scene) -> dict[str, int]:
    """Pixels of each actor that the picture shows, by object name."""
    indices, counts = np.unique(picture.actor[picture.actor >= 0], return_counts=True)
    return {scene.names[index]: int(count) for index, count in zip(indices, counts, strict=True)}


def open_level() -> Scene:
    """The current level of this process."""
    import unreal

    from c4s.engine.headless.state import world

    actors = list(unreal.get_editor_subsystem(unreal.EditorActorSubsystem).get_all_level_actors())
    meshes: dict[str, int] = {}
    loaded: list[Mesh] = []
    instances: list[Instance] = []
    surfaces = _Surfaces(world().store)
    for number, actor in enumerate(actors):
        if actor.get_editor_property("hidden") or actor.is_temporarily_hidden_in_editor():
            continue
        for component in actor.get_components_by_class(unreal.StaticMeshComponent):
            mesh = component.get_editor_property("static_mesh")
            if mesh is None or not component.is_visible() or component.get_editor_property("hidden_in_game"):
                continue
            path = mesh.get_path_name()
            if path not in meshes:
                meshes[path] = len(loaded)
                loaded.append(world().store.mesh(path))
            slots = tuple(surfaces.of(component.get_material(slot)) for slot in range(component.get_num_materials()))
            instances += [Instance(meshes[path], matrix, slots, number) for matrix in _matrices(component)]
    return Scene(Renderer(loaded, instances, lights_of(actors)), tuple(actor.get_name() for actor in actors),
                 tuple(actor.get_actor_label() for actor in actors))


def _matrices(component: Any) -> list[NDArray[np.float64]]:
    """World matrices of what a mesh component shows; what is flattened to nothing is left out."""
    world = component._world_pose().matrix()
    own = [world @ pose.matrix() for pose in component._instances] if hasattr(component, "_instances") else [world]
    return [matrix for matrix in own if abs(np.linalg.det(matrix[:3, :3])) > _MIN_VOLUME]


class _Surfaces:
    """Materials as the renderer wants them, one object a material."""

    def __init__(self, store: PackStore) -> None:
        self._store = store
        self._known: dict[tuple[Any, ...], SurfaceMaterial] = {}
        self._missing = SurfaceMaterial()

    def of(self, material: Any) -> SurfaceMaterial:
        """The surface of a material object; neutral grey for none."""
        if material is None:
            return self._missing
        look: Material = material._surface()
        base = material.get_base_material()
        packed = self._store.material(base.get_path_name()) if base is not None else None
        file = self._store.texture_file(packed) if packed is not None else None
        key = (look.base_color, look.roughness, look.metallic, look.emissive, look.opacity, file)
        if key not in self._known:
            self._known[key] = SurfaceMaterial(look.base_color, look.roughness, look.metallic, look.emissive,
                                               look.opacity, _texture(file) if file is not None else None)
        return self._known[key]


@functools.lru_cache(maxsize=256)
def _texture(file: Path) -> NDArray[np.uint8]:
    with Image.open(file) as picture:
        return np.asarray(picture.convert("RGB"), dtype=np.uint8)


def lights_of(actors: Sequence[Any]) -> Lights:
    """The lights of a level: the first directional light above the horizon is the sun; a clear day without any light."""
    import unreal

    suns: list[Sun] = []
    local: list[LocalLight] = []
    sky: float | None = None
    found = [component for actor in actors for component in actor.get_components_by_class(unreal.LightComponentBase)
             if component.is_visible() and component.get_editor_property("affects_world")]
    for component in found:
        intensity = float(component.get_editor_property("intensity"))
        if isinstance(component, unreal.SkyLightComponent):
            sky = intensity
        elif isinstance(component, unreal.DirectionalLightComponent):
            direction = _triple(component.get_forward_vector())
            if direction[2] < 0:
                suns.append(Sun(direction, _colour(component), intensity,
                                max(_MIN_SUN_DEG, component.get_editor_property("light_source_angle"))))
        elif isinstance(component, unreal.LocalLightComponent) and intensity > 0:
            local.append(_local(component, intensity))
    if not found:
        return Lights()
    return Lights(sun=suns[0] if suns else None, sky=_DIM_SKY if sky is None else Sky(intensity=max(sky, _MIN_SKY)),
                  local=tuple(local))


def _triple(vector: Any) -> tuple[float, float, float]:
    return float(vector.x), float(vector.y), float(vector.z)


def _colour(component: Any) -> tuple[float, float, float]:
    """Linear colour of a light."""
    colour = component.get_light_color()
    return float(colour.r), float(colour.g), float(colour.b)


def _local(component: Any, intensity: float) -> LocalLight:
    """A point, spot or rectangle light; a rectangle shines from its centre into the half space in front of it."""
    import unreal

    units = component.get_editor_property("intensity_units")
    if units == unreal.LightUnits.UNITLESS:
        intensity /= _UNITLESS_PER_CANDELA
    elif units == unreal.LightUnits.LUMENS:
        intensity /= _LUMEN_PER_CANDELA
    elif units == unreal.LightUnits.EV:
        intensity = 2.0 ** (intensity - _EV_OF_ONE_CANDELA)
    inner, outer = 180.0, 180.0
    if isinstance(component, unreal.SpotLightComponent):
        inner = float(component.get_editor_property("inner_cone_angle"))
        outer = float(component.get_editor_property("outer_cone_angle"))
    elif isinstance(component, unreal.RectLightComponent):
        inner, outer = _RECTANGLE_CONE_DEG
    return LocalLight(_triple(component.get_world_location()), _colour(component), intensity,
                      float(component.get_editor_property("attenuation_radius")),
                      _triple(component.get_forward_vector()), inner, outer)


def warm() -> None:
    """Compile every kernel by taking one small picture of each kind."""
    triangle = Mesh(np.array([[0, -50, 0], [0, 50, 0], [0, 0, 80]], np.float32), np.array([[0, 1, 2]], np.int32),
                    np.tile(np.array([-1, 0, 0], np.float32), (3, 1)), np.zeros((3, 2), np.float32),
                    np.zeros(1, np.int32))
    surface = SurfaceMaterial(texture=np.zeros((2, 2, 3), np.uint8))
    lights = Lights(local=(LocalLight((-100.0, 0.0, 50.0)),))
    renderer = Renderer([triangle], [Instance(0, np.eye(4), (surface,), 0)], lights)
    camera = Camera((-200.0, 0.0, 30.0), width=32, height=32)
    renderer.render(camera, mode="lit")
    renderer.render(camera, mode="base_color")
