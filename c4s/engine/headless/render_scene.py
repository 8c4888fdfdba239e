"""From the open level to pictures: meshes, materials and the level's own lights for the renderer.

A level without lights gets a clear day, so that it can be read; one with lights is lit by them alone, with a dim
ambient. Colours are linear RGB, intensities as in Unreal: lux for the sun, candelas for local lights.
"""

from __future__ import annotations

import functools
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

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
from c4s.engine.headless.render.textures import decode_table
from c4s.packs.meshes import Mesh
from c4s.packs.store import PackStore

if TYPE_CHECKING:
    from c4s.engine.headless.unreal.assets import MaterialInterface
    from c4s.engine.headless.unreal.components import StaticMeshComponent
    from c4s.engine.headless.world import LightSource

_UNITLESS_PER_CANDELA = 625.0
_LUMEN_PER_CANDELA = 4 * np.pi
_DIM_SKY = Sky(light=0.25)
_EV_OF_ONE_CANDELA = 3.0
_MAX_EV = 30.0
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
    from c4s.engine.headless.state import world

    level = world()
    meshes: dict[str, int] = {}
    loaded: list[Mesh] = []
    instances: list[Instance] = []
    surfaces = _Surfaces(level.store)
    for shown in level.drawables():
        if abs(np.linalg.det(shown.matrix[:3, :3])) < _MIN_VOLUME:
            continue
        if shown.mesh not in meshes:
            meshes[shown.mesh] = len(loaded)
            loaded.append(level.store.mesh(shown.mesh))
        instances.append(Instance(meshes[shown.mesh], shown.matrix, surfaces.of(shown.component), shown.actor_index))
    actors = level.actor_list()
    return Scene(Renderer(loaded, instances, lights_of(list(level.light_sources()))),
                 tuple(actor.get_name() for actor in actors), tuple(actor.get_actor_label() for actor in actors))


class _Surfaces:
    """Materials as the renderer wants them, one object a material."""

    def __init__(self, store: PackStore) -> None:
        self._store = store
        self._known: dict[tuple[Any, ...], SurfaceMaterial] = {}
        self._of_component: dict[int, tuple[SurfaceMaterial, ...]] = {}
        self._missing = SurfaceMaterial()

    def of(self, component: StaticMeshComponent) -> tuple[SurfaceMaterial, ...]:
        """The surfaces of a component's slots; neutral grey where a slot has none."""
        if id(component) not in self._of_component:
            slots = range(component.get_num_materials())
            self._of_component[id(component)] = tuple(self._surface(component.get_material(slot)) for slot in slots)
        return self._of_component[id(component)]

    def _surface(self, material: MaterialInterface | None) -> SurfaceMaterial:
        if material is None:
            return self._missing
        look = material._surface()
        packed = self._store.material(material._origin_path())
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


def lights_of(sources: Sequence[LightSource]) -> Lights:
    """The lights of a level: the first directional light that shines down is the sun. No light at all: a clear day."""
    suns: list[Sun] = []
    local: list[LocalLight] = []
    sky: float | None = None
    shining = [source for source in sources if source.properties.get("affects_world")]
    for source in shining:
        intensity = float(source.properties["intensity"])
        forward = source.pose.axes()
        direction = (forward[0][0], forward[1][0], forward[2][0])
        if source.kind == "SkyLightComponent":
            sky = intensity
        elif source.kind == "DirectionalLightComponent":
            if direction[2] < 0:
                suns.append(Sun(direction, _colour(source), intensity,
                                max(_MIN_SUN_DEG, float(source.properties["light_source_angle"]))))
        elif intensity > 0:
            local.append(_local(source, direction))
    if not shining:
        return Lights()
    return Lights(sun=suns[0] if suns else None, sky=_DIM_SKY if sky is None else Sky(intensity=max(sky, _MIN_SKY)),
                  local=tuple(local))


def _colour(source: LightSource) -> tuple[float, float, float]:
    """Linear colour of a light, whose bytes are sRGB."""
    colour = source.properties["light_color"]
    red, green, blue = (float(decode_table()[int(byte)]) for byte in (colour.r, colour.g, colour.b))
    return red, green, blue


def _local(source: LightSource, direction: tuple[float, float, float]) -> LocalLight:
    """A point, spot or rectangle light; a rectangle shines from its centre into the half space in front of it."""
    inner, outer = 180.0, 180.0
    if source.kind == "SpotLightComponent":
        inner, outer = (float(source.properties[f"{part}_cone_angle"]) for part in ("inner", "outer"))
    elif source.kind == "RectLightComponent":
        inner, outer = _RECTANGLE_CONE_DEG
    intensity, units = float(source.properties["intensity"]), source.properties["intensity_units"].name
    candela = {"UNITLESS": intensity / _UNITLESS_PER_CANDELA, "LUMENS": intensity / _LUMEN_PER_CANDELA,
               "CANDELAS": intensity, "EV": 2.0 ** (min(intensity, _MAX_EV) - _EV_OF_ONE_CANDELA)}[units]
    return LocalLight(source.pose.location, _colour(source), candela, float(source.properties["attenuation_radius"]),
                      direction, inner, outer)


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
