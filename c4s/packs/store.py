"""Assets, materials and meshes of a set of pack folders, found by their ``/Game/...`` paths."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

from c4s.errors import BadInput
from c4s.names import file_in
from c4s.packs import basic_shapes, engine_content
from c4s.packs.meshes import Mesh, load_mesh
from c4s.protocol.content import Offered
from c4s.records.pack import Asset, Material, Pack

_EXPORT_TEXT = re.compile(r"""\s*[\w./]*'"?(/[^'"]+)"?'\s*""")


def bare_path(path: str) -> str:
    """A path as it stands in export text, ``StaticMesh'/Game/A/B.B'`` or ``/Script/Engine.StaticMesh'/Game/A/B.B'``,
    without the class around it; any other text as it is."""
    found = _EXPORT_TEXT.fullmatch(path) if "'" in path else None
    return found[1] if found else path


def package_path(path: str) -> str:
    """The package of an asset path in any of its forms."""
    return bare_path(path).split(".", 1)[0]


def object_path(path: str) -> str:
    """``/Game/A/B`` and ``/Game/A/B.B_C`` as ``/Game/A/B.B``: the path of the asset object of a package."""
    package = path.split(":", 1)[0].rsplit(".", 1)[0] if "." in path.rsplit("/", 1)[-1] else path
    return f"{package}.{package.rsplit('/', 1)[-1]}"


class PackStore:
    """Read access to packs. The engine's own content is always present."""

    def __init__(self, folders: Sequence[Path], offered: Iterable[str] | None = None) -> None:
        """Read the manifests; ``BadInput`` when one is missing or wrong, or two packs hold the same path.

        Args:
            folders: pack folders.
            offered: paths of the assets that are there (``c4s.protocol.content``); null for all of the packs.
        """
        self.folders = tuple(Path(folder) for folder in folders)
        self.packs: dict[Path, Pack] = {folder: Pack.read(folder / "pack.json") for folder in self.folders}
        self._assets: dict[str, Asset] = {**basic_shapes.assets(), **engine_content.assets()}
        self._materials: dict[str, Material] = {m.path: m for m in (basic_shapes.MATERIAL, *engine_content.MATERIALS)}
        self._home: dict[str, Path] = {}
        self._files: dict[tuple[Path, str], Path] = {}
        """Files of packs that were found to lie in their pack: packs are frozen, so each is looked at once."""
        self._meshes: dict[str, Mesh] = {**basic_shapes.meshes(), **engine_content.meshes()}
        there = None if offered is None else Offered(offered)
        if there is not None:
            assets = [asset for pack in self.packs.values() for asset in pack.assets]
            there.take_parts({asset.path: [part.asset for part in asset.parts] for asset in assets})
        for folder, pack in self.packs.items():
            for path in [asset.path for asset in pack.assets] + [material.path for material in pack.materials]:
                if path in self._home:
                    raise BadInput(f"{path} is in a pack twice, or in two packs", where=str(folder))
                self._home[path] = folder
            self._assets.update({asset.path: asset for asset in pack.assets if there is None or asset.path in there})
            self._materials.update({material.path: material for material in pack.materials})

    def asset(self, path: str) -> Asset | None:
        """The asset of a package, object or Blueprint class path; ``None`` when no pack has it."""
        if path.endswith("_C") and "." in path:
            asset = self._assets.get(object_path(path))
            return asset if asset is not None and asset.kind == "blueprint" and path == f"{asset.path}_C" else None
        return self._assets.get(path) or self._assets.get(object_path(path))

    def is_left_out(self, path: str) -> bool:
        """Whether a pack has this asset, and it is not offered."""
        full = object_path(path)
        return full in self._home and full not in self._assets and full not in self._materials

    def material(self, path: str) -> Material | None:
        """The material of a package or object path; ``None`` when no pack has it."""
        return self._materials.get(path) or self._materials.get(object_path(path))

    def texture_file(self, material: Material) -> Path | None:
        """File of the material's base-colour texture."""
        return self.pack_file(material, material.texture)

    def pack_file(self, material: Material, name: str | None) -> Path | None:
        """A file that a material of a pack names; ``None`` when it names none."""
        return self._file_in(self._home[material.path], name) if name else None

    def mesh(self, path: str) -> Mesh:
        """The mesh of a static mesh asset (cached); ``BadInput`` when there is no such asset or mesh."""
        asset = self.asset(path)
        if asset is None:
            raise BadInput("no pack has this asset", where=path)
        if asset.path not in self._meshes:
            if asset.mesh is None:
                raise BadInput("this asset has no mesh of its own", where=asset.path)
            self._meshes[asset.path] = load_mesh(self._home[asset.path], asset)
        return self._meshes[asset.path]

    def recorded_mesh(self, path: str, facts: Mapping[str, Any]) -> Mesh | None:
        """The mesh that a snapshot shows under a path, told by its recorded digest where the path is that of a copy.

        ``facts``: what the snapshot records of the mesh. None when no pack has a mesh of that digest.
        """
        digest, asset = facts.get("sha256"), self.asset(path)
        if asset is None or asset.kind != "static_mesh" or asset.mesh_sha256 != digest:
            asset = next((one for one in self._assets.values() if digest and one.mesh_sha256 == digest), None)
        return None if asset is None else self.mesh(asset.path)

    def mesh_file(self, path: str) -> Path | None:
        """File of a static mesh asset's mesh; ``None`` for a shape of the engine's own, or where there is none."""
        asset = self.asset(path)
        return self._file_in(self._home[asset.path], asset.mesh) if asset is not None and asset.mesh else None

    def _file_in(self, home: Path, name: str) -> Path:
        if (home, name) not in self._files:
            self._files[home, name] = file_in(home, name)
        return self._files[home, name]

    def file(self, path: str) -> Path | None:
        """The file that holds an asset or material of a pack, a mesh or the manifest; ``None`` where no pack has it."""
        home = self._home.get(object_path(path))
        return None if home is None else self.mesh_file(path) or home / "pack.json"

    def assets(self) -> list[Asset]:
        """All assets, those of the engine first, then in the order of the packs."""
        return list(self._assets.values())

    def materials(self) -> list[Material]:
        """All materials."""
        return list(self._materials.values())

    def packages(self) -> set[str]:
        """Names of all packages that resolve, ``/Game/A/B``."""
        return {path.rsplit(".", 1)[0] for path in (*self._assets, *self._materials)}
