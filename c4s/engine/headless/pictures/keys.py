"""What a picture of the open level depends on, as a digest: pictures of equal digests are the same bytes.

Nothing is rendered or parsed for it: meshes and textures count by the bytes of their files, everything else by its
value. The sources that turn a level into a picture are part of it, and so is the table of actors that a mask holds.
"""

from __future__ import annotations

import functools
import hashlib
import importlib.metadata
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import c4s
from c4s.engine.headless.pictures.lights import grade_at, lights_of
from c4s.engine.headless.pictures.take import drawn, look_of
from c4s.files import digest, digest_file
from c4s.render.masks import camera_of

if TYPE_CHECKING:
    from c4s.engine.headless.world.world import World

_SOURCES = ("editor", "engine/headless", "geometry", "packs", "records", "render")
_LIBRARIES = ("embreex", "numba", "numpy", "pillow", "trimesh")


def picture_keys(cameras: Sequence[Mapping[str, Any]], mode: str) -> list[str]:
    """A digest (64 hex) for the picture, mask and depth that each camera would take now."""
    from c4s.engine.headless.world.state import world

    level = world()
    sources = tuple(level.light_sources())
    scene = _scene(level, repr(lights_of(sources)))
    return [
        digest(
            [
                scene,
                mode,
                float(view.get("exposure_bias_ev") or 0.0),
                repr(camera),
                repr(grade_at(sources, camera.location_cm)),
            ]
        )
        for view in cameras
        for camera in [camera_of(view)]
    ]


def _scene(level: World, lights: str) -> str:
    found = hashlib.sha256(_painter().encode())
    meshes: dict[str, int] = {}
    looks: dict[Any, int] = {}
    for shown in drawn(level):
        mesh = meshes.setdefault(shown.mesh, len(meshes))
        look = tuple(
            looks.setdefault(look_of(level.store, shown.component._material(slot)), len(looks))
            for slot in range(shown.component._slot_count())
        )
        found.update(repr((mesh, look, shown.actor_index)).encode())
        found.update(shown.matrix.tobytes())
    names = [(actor.get_name(), actor.get_actor_label()) for actor in level.actor_list()]
    files = [[_content(file) if isinstance(file, Path) else repr(file) for file in look or ()] for look in looks]
    found.update(repr((names, lights, [_mesh(level, path) for path in meshes], files)).encode())
    return found.hexdigest()


def _mesh(level: World, path: str) -> tuple[Any, ...]:
    """A mesh by the bytes of its file; the engine's own shapes by their path."""
    asset, file = level.store.asset(path), level.store.mesh_file(path)
    if asset is None or file is None:
        return (path,)
    return _content(file), asset.mesh_scale, [slot.name for slot in asset.slots]


@functools.cache
def _content(file: Path) -> str:
    return digest_file(file)


@functools.cache
def _painter() -> str:
    """Digest of the sources and the libraries' versions."""
    root = Path(c4s.__file__).parent
    files = [file for folder in _SOURCES for file in sorted((root / folder).rglob("*.py"))]
    return digest(
        [
            [[file.relative_to(root).as_posix(), digest_file(file)] for file in files],
            [importlib.metadata.version(name) for name in _LIBRARIES],
        ]
    )
