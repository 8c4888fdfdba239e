"""Writes packs: one GLB an asset, textures, previews, and the manifest. Same specification, same bytes.

``python -m catalog.build [pack ...] [--out FOLDER]`` builds the starter packs.
"""

from __future__ import annotations

import argparse
from importlib import import_module
from pathlib import Path
from threading import Lock

import numpy as np

from c4s.errors import BadInput
from c4s.files import digest, digest_bytes, digest_file, read_json, write_bytes, write_json
from c4s.folders import beside
from c4s.geometry.transform import affine, transformed_box
from c4s.home import packs_root
from c4s.packs.check import pack_changes
from c4s.packs.meshes import Mesh
from c4s.records.level import Transform
from c4s.records.pack import MANIFEST, STAMP, Asset, BlueprintPart, Material, MaterialSlot, Pack
from catalog.preview import write_previews
from catalog.settle import check_kept, settle
from catalog.shapes import AssetSpec, BlueprintSpec, Builder, BuiltShape, MaterialSpec, PackSpec
from catalog.shapes.spec import asset_id, readable
from catalog.shapes.textures import png
from catalog.starter import STARTER

_LOADING = Lock()


def glb(mesh: Mesh, slots: list[str], colors: dict[str, tuple[float, float, float]]) -> bytes:
    """GLB bytes of a mesh: a primitive a slot, the material named like the slot (metres, Y up, right-handed)."""
    import trimesh
    from trimesh.exchange.gltf import export_glb
    from trimesh.visual import TextureVisuals
    from trimesh.visual.material import PBRMaterial

    scene = trimesh.Scene()
    for index, slot in enumerate(slots):
        faces = mesh.faces[mesh.face_slots == index]
        used, corners = np.unique(faces, return_inverse=True)
        swap = [0, 2, 1]
        color = [*(round(255 * c) for c in colors[slot]), 255]
        uv = mesh.uvs[used] * [1, -1] + [0, 1]
        material = PBRMaterial(name=slot, baseColorFactor=color)  # type: ignore[no-untyped-call]
        visual = TextureVisuals(uv=uv, material=material)  # type: ignore[no-untyped-call]
        if mesh.colors is not None:
            rgb = np.concatenate([mesh.colors[used], np.ones((len(used), 1))], axis=1)
            visual.vertex_attributes["color"] = np.round(rgb * 255).astype(np.uint8)
        part = trimesh.Trimesh(
            mesh.vertices[used][:, swap].astype(np.float64) / 100,
            corners.reshape(-1, 3)[:, ::-1],
            vertex_normals=mesh.normals[used][:, swap],
            visual=visual,
            process=False,
        )
        scene.add_geometry(part, node_name=f"part_{index:02d}", geom_name=f"part_{index:02d}")
    return bytes(export_glb(scene, include_normals=True))  # type: ignore[no-untyped-call]


def _tiled(shape: BuiltShape, materials: dict[str, MaterialSpec]) -> Mesh:
    """The mesh with texture coordinates in repeats of each material's texture in place of metres."""
    mesh = shape.mesh
    factor = np.ones(len(mesh.vertices), np.float32)
    for index, name in enumerate(shape.materials):
        factor[mesh.faces[mesh.face_slots == index].ravel()] = 1 / materials[name].tile_m
    factor[shape.fitted] = 1
    return Mesh(mesh.vertices, mesh.faces, mesh.normals, mesh.uvs * factor[:, None], mesh.face_slots)


class _Writer:
    def __init__(self, spec: PackSpec, folder: Path) -> None:
        self.spec, self.folder = spec, folder
        self.materials = {material.name: material for material in spec.materials}
        self.built: dict[str, Asset] = {}

    def path(self, subfolder: str, name: str) -> str:
        return f"/Game/{self.spec.content_folder}/{subfolder}/{name}.{name}"

    def material(self, spec: MaterialSpec) -> Material:
        texture = None
        if spec.texture is not None:
            data = png(spec.texture())
            texture = f"textures/T_{spec.name}_{digest_bytes(data)[:12]}.png"
            write_bytes(self.folder / texture, data)
        return Material(
            path=self.path("Materials", f"M_{spec.name}"),
            base_color=spec.color,
            roughness=spec.roughness,
            metallic=spec.metallic,
            emissive=spec.emissive,
            opacity=spec.opacity,
            texture=texture,
        )

    def asset(self, spec: AssetSpec) -> Asset:
        builder = Builder()
        spec.build(builder)
        shape = builder.shape()
        unknown = [name for name in shape.materials if name not in self.materials]
        if unknown:
            raise BadInput(f"the pack has no material {unknown[0]!r}", where=spec.name)
        data = glb(
            _tiled(shape, self.materials),
            shape.materials,
            {name: self.materials[name].color for name in shape.materials},
        )
        identity = asset_id(spec.name)
        write_bytes(self.folder / f"meshes/{identity}.glb", data)
        low, high = shape.mesh.bounds_cm
        slots = [MaterialSlot(name=name, material=self.path("Materials", f"M_{name}")) for name in shape.materials]
        asset = Asset(
            id=identity,
            name=readable(spec.name),
            path=self.path(spec.category.title(), f"SM_{spec.name}"),
            category=spec.category,
            description=spec.description,
            tags=list(spec.tags),
            bounds_min_cm=low,
            bounds_max_cm=high,
            mesh=f"meshes/{identity}.glb",
            mesh_sha256=digest_bytes(data),
            slots=slots,
            collision=shape.collision,
            collision_source="authored" if shape.collision else "none",
        )
        self.built[spec.name] = asset
        return asset

    def blueprint(self, spec: BlueprintSpec) -> Asset:
        parts, lows, highs = [], [], []
        for number, part in enumerate(spec.parts):
            if part.asset not in self.built:
                raise BadInput(f"the pack has no asset {part.asset!r}", where=spec.name)
            asset = self.built[part.asset]
            place = Transform(location_cm=part.location_cm, rotation_deg=(0.0, part.yaw_deg, 0.0), scale=part.scale)
            parts.append(BlueprintPart(name=f"{part.asset}{number}", asset=asset.path, relative=place))
            origin, extent = transformed_box(
                affine(place.location_cm, place.rotation_deg, place.scale), asset.bounds_min_cm, asset.bounds_max_cm
            )
            lows.append(origin - extent)
            highs.append(origin + extent)
        low, high = np.min(lows, axis=0).round(3).tolist(), np.max(highs, axis=0).round(3).tolist()
        return Asset(
            id=f"{asset_id(spec.name)}_bp",
            name=f"{readable(spec.name)} BP",
            kind="blueprint",
            path=self.path("Blueprints", f"BP_{spec.name}"),
            category=spec.category,
            tags=list(spec.tags),
            description=spec.description,
            bounds_min_cm=tuple(low),
            bounds_max_cm=tuple(high),
            parts=parts,
        )


def build_pack(spec: PackSpec, root: Path, *, replace: bool = False, previews: bool = True) -> Pack:
    """Write a pack to ``root/<pack id>`` and return its manifest; without ``previews`` its assets have no pictures.

    Raises ``BadInput`` when the specification is wrong, or where another pack lies there and ``replace`` is not given.
    """
    with beside(root / spec.pack_id) as scratch:
        pack = _written(spec, scratch / spec.pack_id, previews=previews)
        settle(scratch / spec.pack_id, root / spec.pack_id, replace=replace)
    return pack


def _load_makers() -> None:
    """Load the mesh libraries in one thread: two that load parts of them at once may see a module half loaded."""
    with _LOADING:
        import_module("scipy.spatial")
        import_module("trimesh")


def _written(spec: PackSpec, folder: Path, *, previews: bool) -> Pack:
    _load_makers()
    writer = _Writer(spec, folder)
    materials = [writer.material(material) for material in spec.materials]
    assets = [writer.asset(asset) for asset in spec.assets]
    assets += [writer.blueprint(blueprint) for blueprint in spec.blueprints]
    categories = {asset.category for asset in assets}
    missing = sorted(categories - set(spec.category_descriptions))
    if missing:
        raise BadInput(f"category {missing[0]!r} has no description", where=spec.pack_id)
    pack = Pack(
        pack_id=spec.pack_id,
        content_folder=spec.content_folder,
        title=spec.title,
        license=spec.license,
        description=spec.description,
        assets=assets,
        materials=materials,
        category_descriptions=spec.category_descriptions,
    )
    pack.write(folder / MANIFEST)
    return write_previews(folder, drawn=previews)


def sources_digest() -> str:
    """SHA-256 of all that decides what a pack is built into: the sources of the builders and of the pack models."""
    import c4s.packs
    import c4s.records.pack

    folders = [Path(__file__).parent, Path(c4s.packs.__file__).parent]
    files = [path for folder in folders for path in sorted(folder.rglob("*.py"))]
    return digest([[path.name, digest_file(path)] for path in (*files, Path(c4s.records.pack.__file__))])


def ensure_pack(pack_id: str, root: Path, *, replace: bool = False) -> Pack:
    """The starter pack under ``root``: as it is there when these sources built it, else built now.

    Raises ``BadInput`` where the pack that is there was changed, or where these sources build another one, unless
    ``replace`` is given.
    """
    place, stamp = root / pack_id, root / pack_id / STAMP
    ours = (place / MANIFEST).is_file() and stamp.is_file() and read_json(stamp).get("sources") == sources_digest()
    if ours and not (replace and pack_changes(place)):
        check_kept(place)
        return Pack.read(place / MANIFEST)
    pack = build_pack(starter_pack(pack_id), root, replace=replace)
    write_json(stamp, {"sources": sources_digest()})
    return pack


def starter_pack(pack_id: str) -> PackSpec:
    """The specification of a starter pack; ``BadInput`` when there is none of this id."""
    if pack_id not in STARTER:
        raise BadInput("no such starter pack", where=pack_id, todo=f"there are {', '.join(STARTER)}")
    spec = import_module(STARTER[pack_id]).pack()
    assert isinstance(spec, PackSpec)
    return spec


def build_starter(root: Path | None = None, pack_ids: list[str] | None = None, *, replace: bool = False) -> list[Pack]:
    """Build the named starter packs, or all, under ``root`` (default: the packs folder of ``C4S_HOME``)."""
    named = pack_ids or list(STARTER)
    return [build_pack(starter_pack(pack_id), root or packs_root(), replace=replace) for pack_id in named]


def main() -> None:
    """Command line of the builder."""
    parser = argparse.ArgumentParser(description="Build starter packs.")
    parser.add_argument("packs", nargs="*", help=f"of {', '.join(STARTER)}; all when none is named")
    parser.add_argument("--out", type=Path, default=None)
    parser.add_argument("--replace", action="store_true", help="replace another pack of the same name")
    options = parser.parse_args()
    for pack in build_starter(options.out, options.packs, replace=options.replace):
        print(f"{pack.pack_id}: {len(pack.assets)} assets, {len(pack.materials)} materials, {pack.sha256()[:12]}")


if __name__ == "__main__":
    main()
