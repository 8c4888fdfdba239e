"""From the open level to pictures: meshes and materials for the renderer; ``render_lights`` reads its lights."""

from __future__ import annotations

import functools
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from c4s.engine.headless.pictures.lights import grade_at, lights_of
from c4s.packs.meshes import Mesh
from c4s.packs.pictures import open_picture
from c4s.packs.store import PackStore
from c4s.render import Camera, Instance, Lights, LocalLight, Renderer, SurfaceMaterial
from c4s.render.masks import LEAST_VOLUME, camera_of, glimpse, mask_name, visible, write_mask
from c4s.render.png import write_png

if TYPE_CHECKING:
    from c4s.engine.headless.unreal.assets import MaterialInterface
    from c4s.engine.headless.unreal.components import StaticMeshComponent
    from c4s.engine.headless.world.world import Drawable, LightSource, World


@dataclass(frozen=True)
class DrawnScene:
    """A level ready for pictures; masks hold indices into ``names`` and ``labels``."""

    renderer: Renderer
    names: tuple[str, ...]
    labels: tuple[str, ...]
    sources: tuple[LightSource, ...]
    """Lights, fog and post-process volumes."""


def take(cameras: Sequence[Mapping[str, Any]], files: Sequence[str], mode: str, masks: bool) -> list[dict[str, Any]]:
    """Render the open level from ``cameras`` into PNG files, with ``masks`` into ``<stem>.actors.npz`` too."""
    scene = open_level()
    records = []
    for view, name in zip(cameras, files, strict=True):
        camera = camera_of(view)
        picture = scene.renderer.render(
            camera,
            mode="base_color" if mode == "base_color" else "lit",
            exposure_bias_ev=float(view.get("exposure_bias_ev") or 0.0),
            grade=grade_at(scene.sources, camera.location_cm),
        )
        path = Path(name)
        write_png(path, picture.rgb)
        if masks:
            write_mask(path.with_name(mask_name(path.stem)), picture, scene.names, scene.labels)
        records.append({"visible": visible(picture, scene.names)})
    scene.renderer.close()
    return records


def probe(cameras: Sequence[Mapping[str, Any]]) -> list[dict[str, Any]]:
    """What each camera would see of the open level (``glimpse``), by one ray a pixel, without light."""
    scene = open_level()
    seen = [
        glimpse(scene.renderer.render(camera_of(view), mode="base_color", samples=1), scene.names) for view in cameras
    ]
    scene.renderer.close()
    return seen


def open_level() -> DrawnScene:
    """The current level of this process."""
    from c4s.engine.headless.world.state import world

    level = world()
    actors = level.actor_list()
    sources = tuple(level.light_sources())
    return DrawnScene(
        Renderer(*placed(level), lights_of(sources)),
        tuple(actor.get_name() for actor in actors),
        tuple(actor.get_actor_label() for actor in actors),
        sources,
    )


def placed(level: World) -> tuple[list[Mesh], list[Instance]]:
    """What a level shows: its meshes, and where they stand with which surfaces."""
    meshes: dict[str, int] = {}
    loaded: list[Mesh] = []
    instances: list[Instance] = []
    surfaces = _Surfaces(level.store)
    for shown in drawn(level):
        if shown.mesh not in meshes:
            meshes[shown.mesh] = len(loaded)
            loaded.append(level.store.mesh(shown.mesh))
        instances.append(Instance(meshes[shown.mesh], shown.matrix, surfaces.of(shown.component), shown.actor_index))
    return loaded, instances


def drawn(level: World) -> Iterator[Drawable]:
    """The level's meshes that have a volume."""
    return (shown for shown in level.drawables() if abs(_volume(shown.matrix)) >= LEAST_VOLUME)


def look_of(store: PackStore, material: MaterialInterface | None) -> tuple[Any, ...] | None:
    """All that decides how a material looks: numbers, alpha mode and cutoff, and the files of its four textures."""
    if material is None:
        return None
    look, base = material._surface(), material.get_base_material()
    packed = store.material(base.get_path_name()) if base is not None else None
    numbers = (look.base_color, look.roughness, look.metallic, look.emissive, look.opacity)
    if packed is None:
        return (*numbers, "opaque", 0.5, None, None, None, None)
    return (
        *numbers,
        packed.alpha,
        packed.alpha_cutoff,
        *(
            store.pack_file(packed, name)
            for name in (packed.texture, packed.normal_texture, packed.roughness_metal_texture, packed.emissive_texture)
        ),
    )


def _volume(matrix: NDArray[np.float64]) -> float:
    """Determinant of a matrix's linear part; numpy's costs more for one matrix."""
    (a, b, c, _), (d, e, f, _), (g, h, i, _), _ = matrix.tolist()
    return float(a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g))


class _Surfaces:
    """Materials as the renderer wants them, one object a material."""

    def __init__(self, store: PackStore) -> None:
        self._store = store
        self._known: dict[tuple[Any, ...], SurfaceMaterial] = {}
        self._of_slots: dict[
            tuple[int, ...], tuple[tuple[MaterialInterface | None, ...], tuple[SurfaceMaterial, ...]]
        ] = {}
        """By the identities of the slots' materials, which are kept so that no other takes their place."""
        self._missing = SurfaceMaterial()

    def of(self, component: StaticMeshComponent) -> tuple[SurfaceMaterial, ...]:
        """The surfaces of a component's slots; neutral grey where a slot has none."""
        found = tuple(component._material(slot) for slot in range(component._slot_count()))
        key = tuple(id(material) for material in found)
        if key not in self._of_slots:
            self._of_slots[key] = (found, tuple(self._surface(material) for material in found))
        return self._of_slots[key][1]

    def _surface(self, material: MaterialInterface | None) -> SurfaceMaterial:
        look = look_of(self._store, material)
        if look is None:
            return self._missing
        if look not in self._known:
            base_color, roughness, metallic, emissive, opacity, alpha, cutoff, *files = look
            color, normal, roughness_metal, emissive_texture = (
                None if file is None else _texture(file, number == 0 and alpha != "opaque")
                for number, file in enumerate(files)
            )
            self._known[look] = SurfaceMaterial(
                base_color,
                roughness,
                metallic,
                emissive,
                opacity,
                color,
                alpha,
                cutoff,
                normal,
                roughness_metal,
                emissive_texture,
            )
        return self._known[look]


@functools.lru_cache(maxsize=256)
def _texture(file: Path, alpha: bool) -> NDArray[np.uint8]:
    with open_picture(file, where=str(file)) as picture:
        return np.asarray(picture.convert("RGBA" if alpha else "RGB"), dtype=np.uint8)


def warm() -> None:
    """Compile every kernel by taking one small picture of each kind."""
    triangle = Mesh(
        np.array([[0, -50, 0], [0, 50, 0], [0, 0, 80]], np.float32),
        np.array([[0, 1, 2]], np.int32),
        np.tile(np.array([-1, 0, 0], np.float32), (3, 1)),
        np.zeros((3, 2), np.float32),
        np.zeros(1, np.int32),
    )
    surface = SurfaceMaterial(texture=np.full((2, 2, 4), 255, np.uint8), alpha="mask")
    lights = Lights(local=(LocalLight((-100.0, 0.0, 50.0)),))
    renderer = Renderer([triangle], [Instance(0, np.eye(4), (surface,), 0)], lights)
    camera = Camera((-200.0, 0.0, 30.0), width=32, height=32)
    renderer.render(camera, mode="lit")
    renderer.render(camera, mode="base_color")
