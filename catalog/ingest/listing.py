"""What lies in a source folder: mesh files, what cannot be read and why, and a table that describes them."""

from __future__ import annotations

import csv
import os
import re
from collections.abc import Iterable
from dataclasses import dataclass, field
from pathlib import Path

from c4s.errors import BadInput
from c4s.files import digest, digest_file, read_plain_text
from c4s.names import file_in, shown
from catalog.ingest.source import SUFFIXES

NOT_READ = {
    ".fbx": "FBX",
    ".blend": "Blender",
    ".usd": "USD",
    ".usda": "USD",
    ".usdc": "USD",
    ".usdz": "USD",
    ".max": "3ds Max",
    ".3ds": "3D Studio",
    ".ma": "Maya",
    ".mb": "Maya",
    ".c4d": "Cinema 4D",
    ".stl": "STL",
    ".ply": "PLY",
    ".abc": "Alembic",
    ".uasset": "Unreal asset",
    ".umap": "Unreal map",
    ".vrm": "VRM",
    ".x3d": "X3D",
    ".wrl": "VRML",
    ".skp": "SketchUp",
    ".lwo": "LightWave",
    ".step": "STEP",
    ".stp": "STEP",
    ".iges": "IGES",
    ".vox": "MagicaVoxel",
    ".off": "OFF",
    ".3mf": "3MF",
    ".ase": "ASE",
    ".ms3d": "MilkShape",
    ".md2": "MD2",
    ".b3d": "Blitz3D",
    ".x": "DirectX",
}
ARCHIVES = (".zip", ".rar", ".7z", ".tar", ".gz", ".tgz", ".bz2", ".xz", ".unitypackage")
BETTER = (".glb", ".gltf", ".dae", ".obj")
"""Of one thing in several formats the first of these is read: materials suffer least."""
FORMAT_WORD = re.compile(r"(?i)\b(glb|gltf2?|obj|dae|collada|fbx|usd|usdz|blend|stl|format|models?|meshes)\b|[\W_]+")


TOLD = ("name", "category", "description", "tags", "license")
SAME_THING = "the same thing in another format is read"


@dataclass
class Listing:
    """Mesh files in the order of their names, and the names of others with the reason why they are not read."""

    files: list[Path]
    skipped: list[dict[str, str]] = field(default_factory=list)


def listing(folder: Path) -> Listing:
    """Look through a folder. Links that lead out of it are not followed and are named.

    Raises:
        BadInput: this is no folder, or it holds no mesh file that can be read (an archive: unpack it first).
    """
    if folder.is_file():
        kind = folder.suffix.lower()
        if kind in ARCHIVES:
            raise BadInput(
                "this is an archive, not a folder",
                where=str(folder),
                todo=f"unpack it and give the folder: unzip {folder.name} -d {folder.stem}",
            )
        raise BadInput("this is a file, not a folder", where=str(folder), todo=f"give its folder: {folder.parent}")
    if not folder.is_dir():
        raise BadInput("no such folder", where=str(folder))
    root, meshes, found = Path(os.path.realpath(folder)), [], Listing([])
    others: list[tuple[Path, str]] = []
    for place, below, names in os.walk(folder):
        below.sort()
        for name in sorted([*names, *(one for one in below if Path(place, one).is_symlink())]):
            path = Path(place, name)
            kind = path.suffix.lower()
            if not is_text(folder, path):
                others.append((path, "its name is no text"))
            elif path.is_symlink() and not (path.exists() and Path(os.path.realpath(path)).is_relative_to(root)):
                reason = "it is a link out of the folder" if path.exists() else "it is a link to nothing"
                if kind in SUFFIXES or path.is_dir() or kind in NOT_READ:
                    others.append((path, reason))
            elif path.is_symlink() and path.is_dir():
                others.append((path, "it is a link to a folder"))
            elif kind in SUFFIXES and path.is_file():
                meshes.append(path)
            elif kind in NOT_READ:
                others.append((path, f"{NOT_READ[kind]} files are not read; export it as glTF (.glb)"))
            elif kind in SUFFIXES:
                others.append((path, "it is no plain file"))
            elif kind in ARCHIVES:
                others.append((path, "it is an archive; unpack it"))
    kept = _one_format(folder, sorted(meshes))
    found.files = [path for path in sorted(meshes) if path in kept.values()]
    things = {_thing(folder, path) for path in found.files}
    others = [
        (path, SAME_THING if path.suffix.lower() in NOT_READ and _thing(folder, path) in things else reason)
        for path, reason in others
    ] + [(path, SAME_THING) for path in meshes if path not in kept.values()]
    found.skipped = [
        {"file": shown(path.relative_to(folder).as_posix()), "reason": reason} for path, reason in sorted(others)
    ]
    if not found.files:
        first = f"; {found.skipped[0]['file']}: {found.skipped[0]['reason']}" if found.skipped else ""
        raise BadInput(f"no mesh files here ({', '.join(SUFFIXES)}){first}", where=str(folder))
    return found


def is_text(folder: Path, path: Path) -> bool:
    """Whether a path below a folder can be written down: it has no control characters, and its bytes are UTF-8."""
    return str(path.relative_to(folder)).isprintable()


def _thing(folder: Path, path: Path) -> tuple[str, ...]:
    """The place of a file without its format: ``GLB format/a.glb`` and ``OBJ format/a.obj`` are one thing."""
    parts = [FORMAT_WORD.sub("", part).lower() for part in path.relative_to(folder).parts[:-1]]
    return (*(part for part in parts if part), path.stem)


def _one_format(folder: Path, files: Iterable[Path]) -> dict[tuple[str, ...], Path]:
    kept: dict[tuple[str, ...], Path] = {}
    for path in sorted(files, key=lambda path: (BETTER.index(path.suffix.lower()), path)):
        thing = _thing(folder, path)
        if thing in kept and kept[thing].suffix.lower() == path.suffix.lower():
            thing = (*thing, path.relative_to(folder).as_posix())
        kept.setdefault(thing, path)
    return kept


@dataclass(frozen=True)
class ListingRow:
    """What a table says about a file; empty where it says nothing."""

    name: str = ""
    category: str = ""
    description: str = ""
    tags: tuple[str, ...] = ()
    licence: str = ""

    def over(self, other: ListingRow) -> ListingRow:
        """What this says, and where it says nothing what the other one says; the tags of both."""
        return ListingRow(
            self.name or other.name,
            self.category or other.category,
            self.description or other.description,
            tuple(dict.fromkeys([*self.tags, *other.tags])),
            self.licence or other.licence,
        )


def table(folder: Path) -> tuple[dict[str, ListingRow], list[dict[str, str]]]:
    """Rows of CSV tables in the folder that have a column ``file``, by the file's path or name; and notes.

    Columns that are read: ``name``, ``category``, ``description``, ``tags`` (split at ``;``, ``,`` or ``|``) and
    ``license``.
    """
    rows: dict[str, ListingRow] = {}
    notes = []
    for path in sorted(folder.glob("*.csv")):
        try:
            for row in csv.DictReader(read_plain_text(file_in(folder, path.name)).splitlines(keepends=True)):
                if row.get("file"):
                    said = {key: (row.get(key) or "").strip() for key in TOLD}
                    rows[str(row["file"]).strip()] = ListingRow(
                        said["name"],
                        said["category"],
                        said["description"],
                        tuple(tag.strip() for tag in re.split(r"[;,|]", said["tags"]) if tag.strip()),
                        said["license"],
                    )
        except (BadInput, csv.Error) as error:
            why = error.what if isinstance(error, BadInput) else error
            notes.append({"file": shown(path.name), "note": f"this table cannot be read and is left out: {why}"})
    return rows, notes


def inputs_digest(folder: Path) -> str:
    """SHA-256 of every file under a folder, links left out."""
    files = sorted(
        path for path in folder.rglob("*") if path.is_file() and not path.is_symlink() and is_text(folder, path)
    )
    return digest([[path.relative_to(folder).as_posix(), digest_file(path)] for path in files])
