"""Preview pictures of a pack's assets, and a contact sheet for the eye.

``python -m catalog.preview PACK_FOLDER SHEET.png [name ...]`` draws the sheet (of the assets whose ids hold a name).
"""

from __future__ import annotations

import functools
import math
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw

from c4s import render
from c4s.files import digest, digest_file, write_bytes
from c4s.geometry.transform import affine, look_at, rotation_matrix
from c4s.home import cache_root
from c4s.packs.meshes import Mesh
from c4s.packs.pictures import open_picture, png_bytes
from c4s.packs.store import PackStore
from c4s.records.pack import MANIFEST, STAMP, Asset, Material, Pack
from c4s.render import Camera, Instance, Lights, Renderer, Sky, Sun, SurfaceMaterial
from c4s.trees import read_listing

Part: TypeAlias = tuple[Mesh, NDArray[np.float64], tuple[SurfaceMaterial, ...]]
"""A mesh, where it stands (4 x 4), and its materials."""
SIZE = 320
"""Pixels a side of a preview."""
_SAMPLES = 2
_FOV_DEG = 30.0
_FILLS = 0.92
"""Share of the picture's side that an asset takes."""
_FROM = np.array([0.62, 0.78, 0.52])
"""Where the camera stands, seen from the asset: its front, its right and above."""
_SUN = Sun((0.25, -0.75, -0.8), angle_deg=6.0)
_SKY = Sky((0.6, 0.6, 0.62), (0.7, 0.7, 0.7), (0.3, 0.3, 0.3))
_GROUND = SurfaceMaterial((0.36, 0.37, 0.39), roughness=1.0)


class PreviewSurfaces:
    """Materials of packs as the renderer wants them, one object a material."""

    def __init__(self, store: PackStore) -> None:
        self.store = store
        self._known: dict[str, SurfaceMaterial] = {}

    def of(self, path: str) -> SurfaceMaterial:
        """The surface of a material asset; neutral grey when no pack has it."""
        if path not in self._known:
            material = self.store.material(path)
            self._known[path] = SurfaceMaterial() if material is None else self._surface(material)
        return self._known[path]

    def _surface(self, material: Material) -> SurfaceMaterial:
        def picture(name: str | None, mode: str = "RGB") -> NDArray[np.uint8] | None:
            file = self.store.pack_file(material, name)
            return (
                None if file is None else np.asarray(open_picture(file, where=str(file)).convert(mode), dtype=np.uint8)
            )

        return SurfaceMaterial(
            material.base_color,
            material.roughness,
            material.metallic,
            material.emissive,
            material.opacity,
            picture(material.texture, "RGB" if material.alpha == "opaque" else "RGBA"),
            material.alpha,
            material.alpha_cutoff,
            picture(material.normal_texture),
            picture(material.roughness_metal_texture),
            picture(material.emissive_texture),
        )


def _pieces(store: PackStore, asset: Asset) -> list[tuple[Asset, NDArray[np.float64]]]:
    if asset.kind == "static_mesh":
        return [(asset, np.eye(4))]
    found = []
    for part in asset.parts:
        piece, place = store.asset(part.asset), part.relative
        assert piece is not None
        found.append((piece, affine(place.location_cm, place.rotation_deg, place.scale)))
    return found


def _framed(points: NDArray[np.float64]) -> Camera:
    """The camera that looks from ``_FROM`` and has all points (cm) in its picture, as large as they fit."""
    towards = _FROM / np.linalg.norm(_FROM)
    rotation = look_at((0.0, 0.0, 0.0), (-towards).tolist())
    seen = (points @ rotation_matrix(rotation)).T
    half = math.tan(math.radians(_FOV_DEG) / 2) * _FILLS
    eye = np.zeros(3)
    for axis in (1, 2):
        near_low, near_high = (seen[axis] + half * seen[0]).min(), (seen[axis] - half * seen[0]).max()
        eye[axis] = (near_low + near_high) / 2
    back = [seen[0] - np.abs(seen[axis] - eye[axis]) / half for axis in (1, 2)]
    eye[0] = min(float(np.minimum(*back).min()), float(seen[0].min()) - 0.5)
    x, y, z = (rotation_matrix(rotation) @ eye).round(3).tolist()
    return Camera((x, y, z), rotation, _FOV_DEG, SIZE, SIZE)


def preview(surfaces: PreviewSurfaces, asset: Asset) -> NDArray[np.uint8]:
    """(SIZE, SIZE, 3) picture of one asset from the front, right and above, on a grey ground."""
    parts = [
        (surfaces.store.mesh(piece.path), matrix, tuple(surfaces.of(slot.material) for slot in piece.slots))
        for piece, matrix in _pieces(surfaces.store, asset)
    ]
    return drawn(surfaces.store, parts, np.array(asset.bounds_min_cm), np.array(asset.bounds_max_cm))


def drawn(store: PackStore, parts: Sequence[Part], low: NDArray[Any], high: NDArray[Any]) -> NDArray[np.uint8]:
    """(SIZE, SIZE, 3) picture of parts between two corners (cm), framed and lit as every preview."""
    meshes: list[Mesh] = [store.mesh("/Engine/BasicShapes/Plane.Plane")]
    reach = float(np.linalg.norm(high - low))
    middle = (low + high) / 2
    ground = affine((middle[0], middle[1], low[2] - 0.001 * reach), (0, 0, 0), (reach, reach, 1))
    instances, points = [Instance(0, ground, (_GROUND,), 0)], []
    for mesh, matrix, materials in parts:
        instances.append(Instance(len(meshes), matrix, materials, 1))
        meshes.append(mesh)
        points.append(mesh.vertices.astype(np.float64) @ matrix[:3, :3].T + matrix[:3, 3])
    lights = Lights(_SUN, sky=_SKY, ambient_occlusion_cm=max(1.0, reach / 3))
    renderer = Renderer(meshes, instances, lights)
    picture = renderer.render(_framed(np.concatenate(points)), samples=_SAMPLES)
    renderer.close()
    return picture.rgb


@functools.cache
def _painter() -> str:
    """Digest of all sources that decide what a preview shows."""
    files = [Path(__file__), *sorted(Path(render.__file__).parent.glob("*.py"))]
    return digest([digest_file(path) for path in files])


def _key(store: PackStore, asset: Asset) -> str:
    """Digest of what an asset's preview is made of; textures carry their digest in their name."""
    pieces = [
        (
            piece.mesh_sha256,
            piece.mesh_scale,
            matrix.round(6).tolist(),
            [
                None if material is None else material.plain()
                for material in (store.material(slot.material) for slot in piece.slots)
            ],
        )
        for piece, matrix in _pieces(store, asset)
    ]
    return digest([_painter(), asset.bounds_min_cm, asset.bounds_max_cm, pieces])


def write_previews(folder: Path, *, drawn: bool = True) -> Pack:
    """Draw ``previews/<id>.png`` of every asset of the pack in ``folder``; name them in its manifest, and freeze it.

    The manifest then holds the digest of every file of the folder: this is the last step of a build. Unless they are
    ``drawn`` there are no pictures.

    Pictures are kept in the cache under ``C4S_HOME`` by the digest of meshes, materials and the renderer's sources.
    """
    store = PackStore([folder])
    pack, surfaces = store.packs[folder], PreviewSurfaces(store)
    named = []
    for asset in pack.assets:
        if not drawn:
            named.append(asset)
            continue
        kept = cache_root() / "previews" / f"{_key(store, asset)}.png"
        if not kept.is_file():
            write_bytes(kept, png_bytes(Image.fromarray(preview(surfaces, asset))))
        name = f"previews/{asset.id}.png"
        write_bytes(folder / name, kept.read_bytes())
        named.append(asset.model_copy(update={"preview": name}))
    files = {name: value for name, value in read_listing(folder).items() if name not in (MANIFEST, STAMP)}
    pack = pack.model_copy(update={"assets": named, "files": dict(sorted(files.items()))})
    pack.write(folder / MANIFEST)
    return pack


def contact_sheet(folder: Path, out: Path, names: list[str], columns: int = 8) -> int:
    """Draw a sheet of the previews of a pack's assets; returns how many there are."""
    assets = [a for a in PackStore([folder]).packs[folder].assets if not names or any(name in a.id for name in names)]
    rows = -(-len(assets) // columns)
    sheet = Image.new("RGB", (columns * SIZE, rows * (SIZE + 20)), "white")
    pen = ImageDraw.Draw(sheet)
    for i, asset in enumerate(assets):
        x, y = i % columns * SIZE, i // columns * (SIZE + 20)
        if asset.preview is not None:
            sheet.paste(Image.open(folder / asset.preview), (x, y))
        size = "x".join(f"{s:.2f}" for s in asset.size_m)
        pen.text((x + 4, y + SIZE + 3), f"{asset.id} {size} m, {len(asset.collision)} bodies", fill="black")
    sheet.save(out)
    return len(assets)


if __name__ == "__main__":
    print(contact_sheet(Path(sys.argv[1]), Path(sys.argv[2]), sys.argv[3:]))
