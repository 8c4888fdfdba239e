"""Pictures of a pack's assets: single previews, and a contact sheet for the eye.

``python -m catalog.preview PACK_FOLDER SHEET.png [name ...]`` draws the sheet (of the assets whose ids hold a name).
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw

from c4s.engine.headless.render import Camera, Instance, Lights, Renderer, SurfaceMaterial
from c4s.packs.manifest import Asset
from c4s.packs.meshes import Mesh
from c4s.packs.store import PackStore
from c4s.scene.transform import affine, look_at


def surface(store: PackStore, path: str) -> SurfaceMaterial:
    """The surface of a material asset."""
    material = store.material(path)
    if material is None:
        return SurfaceMaterial()
    file = store.texture_file(material)
    texture = None if file is None else np.asarray(Image.open(file).convert("RGB"))
    return SurfaceMaterial(material.base_color, material.roughness, material.metallic, material.emissive,
                           material.opacity, texture)


def _pieces(store: PackStore, asset: Asset) -> list[tuple[Asset, NDArray[np.float64]]]:
    if asset.kind == "static_mesh":
        return [(asset, np.eye(4))]
    found = []
    for part in asset.parts:
        piece, place = store.asset(part.asset), part.relative
        assert piece is not None
        found.append((piece, affine(place.location_cm, place.rotation_deg, place.scale)))
    return found


def preview(store: PackStore, asset: Asset, width: int = 320, height: int = 240) -> NDArray[np.uint8]:
    """Picture of one asset from the front, right and above, on a grey floor."""
    meshes: list[Mesh] = [store.mesh("/Engine/BasicShapes/Plane.Plane")]
    low, high = np.array(asset.bounds_min_cm), np.array(asset.bounds_max_cm)
    floor = SurfaceMaterial((0.35, 0.36, 0.38))
    instances = [Instance(0, affine((0, 0, low[2] - 0.1), (0, 0, 0), (400, 400, 1)), (floor,), 0)]
    for piece, matrix in _pieces(store, asset):
        instances.append(Instance(len(meshes), matrix, tuple(surface(store, s.material) for s in piece.slots), 1))
        meshes.append(store.mesh(piece.path))
    centre, reach = (low + high) / 2, float(np.linalg.norm(high - low))
    direction = np.array([0.55, 0.75, 0.42])
    eye = centre + direction / np.linalg.norm(direction) * max(reach * 1.55, 8)
    place = (float(eye[0]), float(eye[1]), float(eye[2]))
    renderer = Renderer(meshes, instances, Lights(ambient_occlusion_cm=max(10.0, reach / 2)))
    picture = renderer.render(Camera(place, look_at(place, centre.tolist()), 42, width, height), samples=4)
    renderer.close()
    return picture.rgb


def contact_sheet(folder: Path, out: Path, names: list[str], columns: int = 6) -> int:
    """Draw a sheet of the pack's assets; returns how many there are."""
    store = PackStore([folder])
    assets = [a for a in store.packs[folder].assets if not names or any(name in a.id for name in names)]
    rows = -(-len(assets) // columns)
    sheet = Image.new("RGB", (columns * 320, rows * 260), "white")
    pen = ImageDraw.Draw(sheet)
    for i, asset in enumerate(assets):
        x, y = i % columns * 320, i // columns * 260
        sheet.paste(Image.fromarray(preview(store, asset)), (x, y))
        size = "x".join(f"{s:.2f}" for s in asset.size_m)
        pen.text((x + 4, y + 243), f"{asset.id} {size} m, {len(asset.collision)} bodies", fill="black")
    sheet.save(out)
    return len(assets)


if __name__ == "__main__":
    print(contact_sheet(Path(sys.argv[1]), Path(sys.argv[2]), sys.argv[3:]))
