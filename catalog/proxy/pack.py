"""Writing a pack of proxies: every palette entry under its own ``/Game`` path, in exactly its own size.

The palette gives no pivot, so a proxy's pivot is the centre of its bottom.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from c4s.files import digest_bytes, write_bytes
from c4s.packs.meshes import Mesh
from c4s.records.level import Vector
from c4s.records.pack import Asset, BlueprintPart, BoxBody, CollisionBody, HullBody, Material, MaterialSlot, Pack
from catalog.build import glb
from catalog.preview import write_previews
from catalog.proxy.colours import Colour, accent, base_colour
from catalog.proxy.shapes import shaper
from catalog.shapes import Builder, BuiltShape

FIXED: dict[str, Colour] = {
    "Leaf": (0.09, 0.24, 0.06),
    "Trunk": (0.16, 0.09, 0.05),
    "Pane": (0.10, 0.16, 0.22),
    "Roof": (0.30, 0.10, 0.06),
    "Glow": (1.0, 0.82, 0.5),
}


@dataclass(frozen=True)
class PaletteEntry:
    """A palette line: sizes in metres along X, Y, Z; ``path`` as it is spawned (a Blueprint class ends in ``_C``)."""

    id: str
    name: str
    category: str
    size_m: Vector
    path: str


def build_proxy_pack(
    pack_id: str, title: str, entries: Sequence[PaletteEntry], root: Path, progress: Callable[[str], None]
) -> Pack:
    """Write ``root/<pack_id>`` with a proxy and a preview for every entry; the same entries give the same bytes.

    ``root`` is a folder to build in: nothing of that name may lie there.
    """
    folder = root / pack_id
    materials: dict[str, Material] = {}
    assets: list[Asset] = []
    for index, entry in enumerate(entries):
        if index % 25 == 0:
            progress(f"{pack_id}: {index} of {len(entries)} proxies")
        assets += _assets(entry, folder, pack_id, materials)
    pack = Pack(
        pack_id=pack_id,
        content_folder=pack_id,
        title=title,
        license="CC0-1.0 (generated stand-ins)",
        description="Stand-ins for content that is not here: right sizes, right paths, plain shapes.",
        assets=assets,
        materials=list(materials.values()),
        category_descriptions={asset.category: f"{asset.category} assets" for asset in assets},
    )
    pack.write(folder / "pack.json")
    progress(f"{pack_id}: previews")
    return write_previews(folder)


def _words(entry: PaletteEntry) -> list[str]:
    """Words of the name from last to first (the head of a name comes last), then those of the category."""
    name = [word for word in re.findall(r"[a-z]+", entry.name.lower()) if len(word) > 1]
    return [*reversed(name), *re.findall(r"[a-z]+", entry.category.lower())]


def _assets(entry: PaletteEntry, folder: Path, pack_id: str, materials: dict[str, Material]) -> list[Asset]:
    width, depth, height = (100 * side for side in entry.size_m)
    builder, words = Builder(), _words(entry)
    shaper(words, width, depth, height)(builder, max(width, 1e-3), max(depth, 1e-3), height)
    shape = builder.shape()
    mesh, bodies = _fit(shape, (width, depth, height))
    main = base_colour(words, entry.category, entry.id)
    colours = {"Main": main, "Accent": accent(main), **FIXED}
    data = glb(mesh, shape.materials, {name: colours[name] for name in shape.materials})
    file = f"meshes/{entry.id}.glb"
    write_bytes(folder / file, data)
    slots = []
    for name in shape.materials:
        owner = entry.id if name not in FIXED else "shared"
        path = f"/Game/C4SProxy/{pack_id}/M_{owner}_{name}.M_{owner}_{name}"
        materials.setdefault(
            path,
            Material(
                path=path, base_color=colours[name], emissive=(2.0, 1.6, 1.0) if name == "Glow" else (0.0, 0.0, 0.0)
            ),
        )
        slots.append(MaterialSlot(name=name, material=path))
    low, high = mesh.bounds_cm
    blueprint = entry.path.endswith("_C")
    path = entry.path[:-2] if blueprint else entry.path
    asset = Asset(
        id=entry.id,
        name=entry.name,
        path=path,
        category=entry.category,
        description=f"Stand-in for {entry.name}",
        tags=sorted(set(words)),
        bounds_min_cm=low,
        bounds_max_cm=high,
        mesh=file,
        mesh_sha256=digest_bytes(data),
        slots=slots,
        collision=bodies,
        collision_source="authored" if bodies else "none",
    )
    if not blueprint:
        return [asset]
    leaf = path.rsplit("/", 1)[-1].split(".")[0]
    body_path = f"{path.rsplit('/', 1)[0]}/{leaf}_Body.{leaf}_Body"
    body = asset.model_copy(update={"id": f"{entry.id}_body", "path": body_path, "category": "blueprint parts"})
    return [
        body,
        asset.model_copy(
            update={
                "kind": "blueprint",
                "mesh": None,
                "mesh_sha256": None,
                "slots": [],
                "collision": [],
                "collision_source": "none",
                "parts": [BlueprintPart(name="Body", asset=body_path)],
            }
        ),
    ]


def _fit(shape: BuiltShape, size: Vector) -> tuple[Mesh, list[CollisionBody]]:
    """Stretch a shape to exactly ``size`` (cm), its bottom centre at the origin; a zero side has no bodies."""
    vertices = shape.mesh.vertices.astype(np.float64)
    low, high = vertices.min(axis=0), vertices.max(axis=0)
    span = high - low
    factor = np.where(span > 1e-6, np.asarray(size) / np.maximum(span, 1e-6), 0.0)
    middle = np.array([(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, low[2]])

    def move(points: np.ndarray) -> np.ndarray:
        return np.asarray(np.round((points - middle) * factor, 3))

    mesh = Mesh(
        move(vertices).astype(np.float32), shape.mesh.faces, shape.mesh.normals, shape.mesh.uvs, shape.mesh.face_slots
    )
    bodies: list[CollisionBody] = []
    if min(size) > 0:
        for body in shape.collision:
            if isinstance(body, BoxBody):
                turned = round(body.rotation_deg[1]) % 180 == 90
                half = np.asarray(body.half_extent)[[1, 0, 2]] if turned else np.asarray(body.half_extent)
                bodies.append(
                    BoxBody(center=_vector(move(np.asarray(body.center))), half_extent=_vector(half * factor))
                )
            elif isinstance(body, HullBody):
                bodies.append(HullBody(vertices=[_vector(move(np.asarray(v))) for v in body.vertices]))
    return mesh, bodies


def _vector(values: np.ndarray) -> Vector:
    return float(values[0]), float(values[1]), float(values[2])
