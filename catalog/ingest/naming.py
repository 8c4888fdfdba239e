"""What mesh files are called: by their own name where that tells something, else by the folders that they lie in."""

from __future__ import annotations

import re
from collections import Counter, defaultdict
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from catalog.ingest.units import words
from catalog.ingest.vocabulary import is_compound, kind_of, spoken

PLAIN_FOLDERS = {
    "assets",
    "gltf",
    "glb",
    "obj",
    "dae",
    "models",
    "model",
    "meshes",
    "mesh",
    "source",
    "visual",
    "format",
    "export",
    "exports",
    "fbx",
    "files",
    "textured",
    "untextured",
    "lowpoly",
}
"""Folder names that say nothing about what is inside."""
PLAIN_NAMES = PLAIN_FOLDERS | {
    "asset",
    "base",
    "collada",
    "copy",
    "data",
    "default",
    "draco",
    "file",
    "final",
    "geometry",
    "high",
    "lod",
    "low",
    "main",
    "material",
    "new",
    "normalized",
    "object",
    "out",
    "output",
    "poly",
    "raw",
    "result",
    "scan",
    "scene",
    "simple",
    "simplified",
    "test",
    "texture",
    "thing",
    "tmp",
    "unnamed",
    "untitled",
    "version",
}
"""Words of file names that say nothing about the thing."""
HASH = re.compile(r"[0-9a-f]{8,}|[0-9a-f]{8}(-[0-9a-f]{4}){3}-[0-9a-f]{12}", re.IGNORECASE)
SHARED_NAMES = 3
"""A name that so many files in different folders have tells none of them apart."""


@dataclass(frozen=True)
class FileName:
    """What a file is called (words as in a file name), and the folders that tell its category."""

    name: str
    above: tuple[str, ...]


def named(files: Sequence[Path], folder: Path) -> dict[Path, FileName]:
    """The name of each file.

    A name of words that say nothing (``model``, ``scene_final_2``, a number, a digest) gives way to the nearest folder
    that says something, and so does one that ``SHARED_NAMES`` files in folders of different names have. Files that
    would be called the same in one folder keep their own name behind the folder's.
    """
    shared = Counter(stem for stem, _ in {(path.stem.lower(), path.parent) for path in files})
    found, takers = {}, defaultdict(list)
    for path in files:
        above = [part for part in path.relative_to(folder).parts[:-1] if says(part)]
        plain = not says(path.stem, PLAIN_NAMES)
        if above and (plain or shared[path.stem.lower()] >= SHARED_NAMES):
            found[path] = FileName(above[-1], tuple(above[:-1]))
            takers[above[-1], path.parent].append(path)
        else:
            found[path] = FileName(path.stem, tuple(above))
    for group in takers.values():
        if len(group) > 1:
            for path in group:
                found[path] = FileName(f"{found[path].name}_{path.stem}", found[path].above)
    return found


def says(name: str, plain: set[str] = PLAIN_FOLDERS) -> bool:
    """Whether a name has a word that says something: no digest, no number, no plain word."""
    if HASH.fullmatch(name) and any(letter.isdigit() for letter in name):
        return False
    found = [word for word in spoken(name) if not word.isdigit() and len(word) > 1]
    return bool({word.lower() for word in found} - plain) and bool(set(words(name)) - plain or not name.isascii())


def categories(names: dict[Path, FileName]) -> dict[Path, str]:
    """Category of each file: the nearest telling folder, else the first word of the name if two files share it,
    else the kind of thing that the name tells.
    """
    first = {path: _first(one.name) for path, one in names.items()}
    count = Counter(first.values())
    found = {}
    for path, one in names.items():
        shared = first[path] if count[first[path]] > 1 else kind_of(one.name) or "props"
        found[path] = " ".join(words(one.above[-1])) or shared if one.above else shared
    return found


def _first(name: str) -> str:
    """The first word of a name as it is spoken: ``kitchen counter`` of ``kitchencounter_sink``."""
    written, said = words(name), spoken(name)
    if not written:
        return "props"
    if is_compound(said[:2]):
        return " ".join(said[:2]).lower()
    return " ".join(spoken(written[0])).lower()
