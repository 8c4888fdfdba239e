"""The stand-in's own content: a package file an asset or material, with what the pack's manifest says of it.

The files lie where Unreal's would, under the names that Unreal's would have, so that packs, projects and links are the
same with both. No real editor can read them, and the stand-in reads no others.
"""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterator, Mapping
from pathlib import Path, PurePosixPath
from typing import Any

from c4s.errors import BadInput
from c4s.files import digest_file, read_json, write_json
from c4s.packs.store import package_path
from c4s.records.pack import MANIFEST, Asset, Material, Pack
from c4s.records.unreal_content import CONTENT_FILE, CONTENT_FOLDER, UnrealContent

FORMAT = "c4s.standin.package.v1"
API = "5.6-standin"
"""The engine that saves such content."""


def add_content(pack: Path) -> None:
    """Give a built pack content for the stand-in, in its own folder: the pack gets another digest."""
    manifest = Pack.read(pack / MANIFEST)
    content = pack / CONTENT_FOLDER
    records: dict[str, Asset | Material] = {asset.path: asset for asset in manifest.assets}
    records |= {material.path: material for material in manifest.materials}
    for record in records.values():
        _write_package(content, pack, manifest, record)
    needs = {path: sorted({*_needs(path, records, manifest.pack_id)}) for path in records}
    UnrealContent(engine=API, needs=needs).write(pack / CONTENT_FILE)
    written = [pack / CONTENT_FILE, *(file for file in content.rglob("*") if file.is_file())]
    files = {file.relative_to(pack).as_posix(): digest_file(file) for file in sorted(written)}
    manifest.model_copy(update={"files": {**manifest.files, **files}}).write(pack / MANIFEST)


def _needs(path: str, records: Mapping[str, Asset | Material], pack_id: str) -> Iterator[str]:
    """The files of an asset or material, and of all that it is made of."""
    record = records[path]
    yield f"{_place(path)}.uasset"
    yield from (_bulk(pack_id, name).as_posix() for name in _bulk_names(record))
    if isinstance(record, Asset):
        for other in (*(part.asset for part in record.parts), *(slot.material for slot in record.slots)):
            if other in records:
                yield from _needs(other, records, pack_id)


def _place(path: str) -> PurePosixPath:
    """Where the package of a path lies below ``Content``."""
    return PurePosixPath(package_path(path).removeprefix("/Game/"))


def _bulk(pack_id: str, name: str) -> PurePosixPath:
    """Where the bytes of a file of a pack lie below ``Content``."""
    return PurePosixPath("Bulk", pack_id, f"{name}.ubulk")


def _bulk_names(record: Asset | Material) -> list[str]:
    """The files of the pack that an asset or material shows: its mesh, its textures."""
    if isinstance(record, Asset):
        return [record.mesh] if record.mesh is not None else []
    names = (record.texture, record.normal_texture, record.roughness_metal_texture, record.emissive_texture)
    return [name for name in names if name is not None]


def _write_package(content: Path, pack: Path, manifest: Pack, record: Asset | Material) -> None:
    meta = manifest.model_copy(update={"assets": [], "materials": [], "files": {}})
    plain, names = record.plain() | ({"preview": None} if isinstance(record, Asset) else {}), _bulk_names(record)
    for name in names:
        target = content / _bulk(manifest.pack_id, name)
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(pack / name, target)
    package = {
        "schema_version": FORMAT,
        "pack": meta.plain(),
        "kind": "asset" if isinstance(record, Asset) else "material",
        "record": plain,
        "files": {name: manifest.files[name] for name in names},
    }
    write_json(content / f"{_place(record.path)}.uasset", package)


def read_content(content: Path, folder: Path) -> list[Path]:
    """The packs that a project's content holds, as folders below ``folder`` that a pack store reads.

    ``BadInput`` for packages that the stand-in did not make.
    """
    packs: dict[str, dict[str, Any]] = {}
    for file in _linked_packages(content):
        package = read_json(file, what="package")
        if not isinstance(package, dict) or package.get("schema_version") != FORMAT:
            raise BadInput("the stand-in reads its own packages only", where=str(file))
        own = packs.setdefault(package["pack"]["pack_id"], dict(package["pack"]))
        own["assets" if package["kind"] == "asset" else "materials"].append(package["record"])
        own["files"] |= package["files"]
    for pack_id, manifest in packs.items():
        Pack.parse(manifest, where=pack_id).write(folder / pack_id / MANIFEST)
        for name in manifest["files"]:
            target = folder / pack_id / name
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(content / _bulk(pack_id, name), target)
    return [folder / pack_id for pack_id in sorted(packs)]


def _linked_packages(content: Path) -> Iterator[Path]:
    """The packages that a project was given, which are links."""
    for above, folders, names in os.walk(content):
        folders.sort()
        for name in sorted(names):
            if name.endswith(".uasset") and (Path(above) / name).is_symlink():
                yield Path(above) / name
