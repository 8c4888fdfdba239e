"""``c4s catalog build``: a folder of mesh files becomes a pack."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from c4s.errors import BadInput
from catalog.ingest.hulls import HullPer, bodies
from catalog.ingest.licence import UNKNOWN, licence
from catalog.ingest.source import SUFFIXES, Up, read_source
from catalog.ingest.surface import Source
from catalog.ingest.units import check_units, words
from catalog.ingest.writer import PackWriter, identifier

PLAIN_FOLDERS = {"assets", "gltf", "glb", "obj", "dae", "models", "meshes", "mesh", "source", "visual"}
"""Folder names that say nothing about what is inside."""


def mesh_files(folder: Path) -> list[Path]:
    """The mesh files under a folder in the order of their names."""
    root = folder.resolve()
    return sorted(path for path in folder.rglob("*") if path.suffix.lower() in SUFFIXES and path.is_file()
                  and path.resolve().is_relative_to(root))


def categories(files: list[Path], folder: Path) -> dict[Path, str]:
    """Category of each file: the nearest telling folder, else the first word of the name if two files share it."""
    first = {path: (words(path.stem) or ["prop"])[0] for path in files}
    count = Counter(first.values())
    found = {}
    for path in files:
        telling = [part for part in path.relative_to(folder).parts[:-1] if part.lower() not in PLAIN_FOLDERS]
        shared = first[path] if count[first[path]] > 1 else "props"
        found[path] = " ".join(words(telling[-1])) or shared if telling else shared
    return found


def ingest(folder: Path, pack_id: str, root: Path, *, scale: float = 1.0, title: str | None = None,
           up: Up | None = None, hulls: HullPer = "asset",
           progress: Callable[[int, int, str], None] | None = None) -> dict[str, Any]:
    """Build the pack ``root/<pack_id>`` of all mesh files under ``folder`` and return the report.

    Args:
        folder: source folder; nothing outside it is read.
        pack_id: id of the pack; one that exists is replaced when all is done.
        root: where packs lie.
        scale: factor from the files' units to metres.
        title: title of the pack; the folder's name when left out.
        up: axis that points up in OBJ files (and others, against what they say).
        hulls: how many convex hulls stand for an asset.
        progress: told (files done, files, name).

    The report names every file that was skipped and why, every note on the others, and what the sizes say.

    Raises:
        BadInput: no such folder, a bad id or scale, or no file that can be used.
    """
    if not folder.is_dir():
        raise BadInput("no such folder", where=str(folder))
    if not np.isfinite(scale) or not 1e-6 <= scale <= 1e6:
        raise BadInput("the scale must be a positive number", where=f"--scale {scale}")
    files = mesh_files(folder)
    if not files:
        raise BadInput(f"no mesh files here ({', '.join(SUFFIXES)})", where=str(folder))
    kinds, skipped, notes, sizes = categories(files, folder), [], [], []
    name, text = licence(folder)
    if name == UNKNOWN:
        notes.append({"file": "", "note": "no file here tells the licence"})
    with PackWriter(pack_id, root) as writer:
        for number, path in enumerate(files):
            relative = path.relative_to(folder).as_posix()
            if progress:
                progress(number, len(files), relative)
            try:
                source = read_source(path, folder, scale=scale, up=up if path.suffix.lower() == ".obj" else None)
            except BadInput as error:
                skipped.append({"file": relative, "reason": error.what})
                continue
            notes += [{"file": relative, "note": note} for note in source.notes]
            asset = writer.add(path.stem, source.parts, list(bodies(
                [(part.node, part.vertices, part.faces) for part in source.parts], hulls)),
                category=kinds[path], tags=_tags(path, folder), description=_description(path, source))
            sizes.append((path.stem, max(asset.size_m)))
        if not writer.assets:
            first = skipped[0]
            raise BadInput(f"none of {len(files)} mesh files can be used; {first['file']}: {first['reason']}",
                           where=str(folder))
        pack = writer.finish(title=title or " ".join(word.capitalize() for word in words(folder.name)) or pack_id,
                             license_id=name, license_text=text, description=f"{len(writer.assets)} assets")
    check = check_units(sizes)
    return {"pack": pack.pack_id, "title": pack.title, "license": pack.license, "folder": str(root / pack_id),
            "sha256": pack.sha256(), "files": len(files), "assets": len(pack.assets), "materials": len(pack.materials),
            "scale": scale, "skipped": skipped, "notes": notes,
            "units": {"known": check.known, "implausible": check.implausible, "reason": check.reason,
                      "proposed_scale": float(f"{check.proposed * scale:.2g}") if check.proposed else None}}


def _tags(path: Path, folder: Path) -> list[str]:
    named = [word for part in (*path.relative_to(folder).parts[:-1], path.stem) for word in words(part)]
    return list(dict.fromkeys(word for word in named if len(word) > 1 and word not in PLAIN_FOLDERS))


def _description(path: Path, source: Source) -> str:
    size = np.ptp(np.concatenate([part.vertices for part in source.parts]), axis=0) / 100
    looks = sorted({identifier(part.surface.name).replace("_", " ") for part in source.parts})
    return (f"{' '.join(words(path.stem)).capitalize() or path.stem}, {size[0]:.2f} x {size[1]:.2f} x {size[2]:.2f} m; "
            f"{', '.join(looks[:6])}")
