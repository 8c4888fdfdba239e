"""Collects meshes and surfaces into a pack and writes it: deterministic bytes, a material once, a texture once."""

from __future__ import annotations

import re
import unicodedata
from pathlib import Path
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from c4s.files import digest, digest_bytes, write_bytes
from c4s.folders import beside
from c4s.names import checked_id
from c4s.packs.meshes import Mesh
from c4s.records.pack import MANIFEST, Asset, CollisionBody, Material, MaterialSlot, Pack
from catalog.build import glb
from catalog.ingest.licence_words import AiUse
from catalog.ingest.surface import SourcePart, Surface
from catalog.preview import write_previews
from catalog.settle import settle

MAX_NAME = 100
NAMES_TOLD = 8


def content_folder(pack_id: str) -> str:
    """The folder under ``/Game`` of a pack: ``kaykit-furniture`` as ``KaykitFurniture``; ``BadInput`` for a bad id."""
    words = re.split(r"[^a-z0-9]+", checked_id(pack_id, "pack"))
    return "".join(word[:1].upper() + word[1:] for word in words if word)


def identifier(text: str) -> str:
    """Text as an Unreal name: letters, digits and ``_``, at most ``MAX_NAME`` of them.

    Accents fall away; a name in another script becomes a part of its digest, so that it stays the same name.
    """
    plain = unicodedata.normalize("NFKD", text).encode("ascii", "ignore").decode()
    name = re.sub(r"_+", "_", re.sub(r"[^A-Za-z0-9]+", "_", plain)).strip("_")
    if not name or (len(name) < 3 and not text.isascii()):
        name = f"{name}_{digest(text)[:8]}".strip("_") if text.strip() else "Unnamed"
    return name if len(name) <= MAX_NAME else f"{name[: MAX_NAME - 9]}_{digest(text)[:8]}"


def _prefixed(prefix: str, name: str) -> str:
    """An Unreal name with the prefix of its kind, once."""
    return f"{prefix}{identifier(name.removeprefix(prefix) or name)}"


def _colors(parts: list[SourcePart]) -> NDArray[np.float32] | None:
    """Colours of the vertices of all parts, white where a part has none; ``None`` when none has."""
    if all(part.colors is None for part in parts):
        return None
    return np.concatenate(
        [np.ones((len(part.vertices), 3)) if part.colors is None else part.colors for part in parts]
    ).astype(np.float32)


class PackWriter:
    """Writes one pack under ``root``, in a folder beside it that takes its place when all is done.

    ``replace``: put it in the place of another pack of this id.
    """

    def __init__(self, pack_id: str, root: Path, *, replace: bool = False) -> None:
        self.pack_id, self.root, self.folder_name = pack_id, root, content_folder(pack_id)
        self.replace = replace
        self._scratch = beside(root / pack_id)
        self.folder = root
        self.assets: list[Asset] = []
        self.materials: dict[str, Material] = {}
        self._by_surface: dict[str, str] = {}
        self._names: set[str] = set()

    def __enter__(self) -> PackWriter:
        self.folder = self._scratch.__enter__() / self.pack_id
        return self

    def __exit__(self, *_: object) -> None:
        self._scratch.__exit__(None, None, None)

    def material(self, surface: Surface) -> str:
        """Path of the material of a surface; surfaces that look alike share one."""
        record = Material(
            path="/Game/M",
            base_color=surface.color,
            roughness=surface.roughness,
            metallic=surface.metallic,
            emissive=surface.emissive,
            opacity=surface.opacity,
            texture=self._texture(surface.texture),
            alpha=surface.alpha,
            alpha_cutoff=surface.alpha_cutoff,
            normal_texture=self._texture(surface.normal_texture),
            roughness_metal_texture=self._texture(surface.roughness_metal_texture),
            emissive_texture=self._texture(surface.emissive_texture),
        )
        key = digest([surface.name, record.plain()])
        if key not in self._by_surface:
            name = self._free(_prefixed("M_", surface.name))
            path = f"/Game/{self.folder_name}/Materials/{name}.{name}"
            self.materials[path] = record.model_copy(update={"path": path})
            self._by_surface[key] = path
        return self._by_surface[key]

    def _texture(self, png: bytes | None) -> str | None:
        """Name of a texture in the pack; equal ones are written once."""
        if png is None:
            return None
        name = f"textures/T_{digest_bytes(png)[:16]}.png"
        if not (self.folder / name).is_file():
            write_bytes(self.folder / name, png)
        return name

    def add(
        self,
        name: str,
        parts: list[SourcePart],
        collision: list[CollisionBody],
        *,
        category: str,
        readable: str = "",
        description: str = "",
        tags: list[str] | None = None,
        source: Literal["authored", "hull", "decomposition", "none"] = "hull",
    ) -> Asset:
        """Add a static mesh of these parts; names that are taken get a number.

        ``readable`` is the name for people, made of ``name`` when left out; ``source`` says where the bodies come from.
        """
        slots: list[MaterialSlot] = []
        order: dict[str, int] = {}
        for part in parts:
            path = self.material(part.surface)
            if path not in order:
                order[path] = len(slots)
                slots.append(MaterialSlot(name=path.rsplit(".", 1)[-1][2:], material=path))
        offsets = np.cumsum([0] + [len(part.vertices) for part in parts[:-1]])
        mesh = Mesh(
            vertices=np.concatenate([part.vertices for part in parts]).round(3).astype(np.float32),
            faces=np.concatenate([part.faces + offset for part, offset in zip(parts, offsets, strict=True)]).astype(
                np.int32
            ),
            normals=np.concatenate([part.normals for part in parts]).round(5).astype(np.float32),
            uvs=np.concatenate([part.uvs for part in parts]).round(6).astype(np.float32),
            face_slots=np.concatenate(
                [np.full(len(part.faces), order[self.material(part.surface)], np.int32) for part in parts]
            ),
            colors=_colors(parts),
        )
        stem = self._free(_prefixed("SM_", name))
        identity = stem[3:].lower()
        colors = {slot.name: self.materials[slot.material].base_color for slot in slots}
        data = glb(mesh, [slot.name for slot in slots], colors)
        write_bytes(self.folder / f"meshes/{identity}.glb", data)
        low, high = mesh.bounds_cm
        section = identifier(category.title())
        asset = Asset(
            id=identity,
            name=readable or stem[3:].replace("_", " "),
            category=category,
            description=description,
            tags=tags or [],
            bounds_min_cm=low,
            path=f"/Game/{self.folder_name}/{section}/{stem}.{stem}",
            bounds_max_cm=high,
            mesh=f"meshes/{identity}.glb",
            mesh_sha256=digest_bytes(data),
            slots=slots,
            collision=collision,
            collision_source=source if collision else "none",
        )
        self.assets.append(asset)
        return asset

    def finish(
        self, *, title: str, license_id: str, description: str, license_text: str, ai_use: AiUse = "unknown"
    ) -> Pack:
        """Write the manifest and put the folder in its place.

        Raises ``BadInput`` where another pack lies there that is not to be replaced.
        """
        categories = sorted({asset.category for asset in self.assets})
        pack = Pack(
            pack_id=self.pack_id,
            content_folder=self.folder_name,
            title=title,
            license=license_id,
            ai_use=ai_use,
            description=description,
            assets=self.assets,
            materials=list(self.materials.values()),
            category_descriptions={name: self._told(name) for name in categories},
        )
        pack.write(self.folder / MANIFEST)
        if license_text:
            write_bytes(self.folder / "LICENSE.txt", license_text.encode())
        pack = write_previews(self.folder)
        settle(self.folder, self.root / self.pack_id, replace=self.replace)
        return pack

    def _told(self, category: str) -> str:
        """How many assets a category has, and the first names of them."""
        names = [asset.name for asset in self.assets if asset.category == category]
        rest = f" and {len(names) - NAMES_TOLD} more" if len(names) > NAMES_TOLD else ""
        return f"{len(names)} asset{'s' if len(names) != 1 else ''}: {', '.join(names[:NAMES_TOLD])}{rest}"

    def _free(self, name: str) -> str:
        name = f"{name}_Mesh" if name.endswith("_C") else name  # a path that ends in _C is a Blueprint's class
        number, free = 2, name
        while free.lower() in self._names:
            free, number = f"{name}_{number}", number + 1
        self._names.add(free.lower())
        return free
