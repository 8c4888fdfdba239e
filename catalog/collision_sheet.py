"""A sheet of the collision bodies of a pack's assets, each in its own colour, beside what is to be seen of them."""

from __future__ import annotations

import colorsys
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw
from scipy.spatial import ConvexHull

from c4s.errors import BadInput
from c4s.packs.meshes import Mesh
from c4s.packs.store import PackStore
from c4s.records.pack import Asset, CollisionBody
from c4s.render import SurfaceMaterial
from catalog.ingest.excess import corners_of
from catalog.preview import SIZE, Part, PreviewSurfaces, drawn, preview

COLUMNS = 4
MOST_ASSETS = 120
CAPTION = 20
_GOLDEN = 0.618034


def body_part(body: CollisionBody, number: int) -> Part:
    """A body as a part of a picture, in a colour of its number."""
    corners = corners_of(body)
    faces = ConvexHull(corners, qhull_options="QJ Pp").simplices
    triangles = corners[faces]
    normals = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    outward = np.einsum("ij,ij->i", normals, triangles[:, 0] - corners.mean(axis=0)) >= 0
    normals *= np.where(outward, 1.0, -1.0)[:, None]
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-12)
    count = len(faces)
    mesh = Mesh(
        triangles.reshape(-1, 3).astype(np.float32),
        np.arange(3 * count).reshape(-1, 3).astype(np.int32),
        np.repeat(normals, 3, axis=0).astype(np.float32),
        np.zeros((3 * count, 2), np.float32),
        np.zeros(count, np.int32),
    )
    return mesh, np.eye(4), (SurfaceMaterial(colorsys.hsv_to_rgb(number * _GOLDEN % 1, 0.65, 0.8), roughness=0.9),)


def bodies_picture(store: PackStore, asset: Asset) -> NDArray[np.uint8]:
    """(SIZE, SIZE, 3) picture of an asset's bodies, as its preview is framed."""
    low, high = np.array(asset.bounds_min_cm), np.array(asset.bounds_max_cm)
    return drawn(store, [body_part(body, number) for number, body in enumerate(asset.collision)], low, high)


def collision_sheet(folder: Path, out: Path, names: Sequence[str] = ()) -> int:
    """Draw the sheet of a pack's assets with bodies (those whose id holds one of the names); returns their number.

    Raises:
        BadInput: none is chosen, or more than ``MOST_ASSETS`` are.
    """
    store = PackStore([folder])
    chosen = [
        asset
        for asset in store.packs[folder].assets
        if asset.collision and (not names or any(name.lower() in asset.id for name in names))
    ]
    if not chosen:
        raise BadInput(
            "no asset with collision bodies has such an id", where=str(folder), todo="see `c4s catalog show`"
        )
    if len(chosen) > MOST_ASSETS:
        raise BadInput(f"{len(chosen)} assets are too many for a sheet of {MOST_ASSETS}", todo="name some of them")
    surfaces = PreviewSurfaces(store)
    rows = -(-len(chosen) // COLUMNS)
    sheet = Image.new("RGB", (min(COLUMNS, len(chosen)) * (2 * SIZE + 8), rows * (SIZE + CAPTION)), "white")
    pen = ImageDraw.Draw(sheet)
    for number, asset in enumerate(chosen):
        x, y = number % COLUMNS * (2 * SIZE + 8), number // COLUMNS * (SIZE + CAPTION)
        sheet.paste(Image.fromarray(preview(surfaces, asset)), (x, y))
        sheet.paste(Image.fromarray(bodies_picture(store, asset)), (x + SIZE, y))
        size = " x ".join(f"{side:.2f}" for side in asset.size_m)
        pen.text((x + 4, y + SIZE + 4), f"{asset.id}: {size} m, {len(asset.collision)} bodies", fill="black")
    out.parent.mkdir(parents=True, exist_ok=True)
    sheet.save(out)
    return len(chosen)
