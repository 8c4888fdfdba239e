"""``c4s catalog build``: a folder of mesh files becomes a pack."""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from c4s.errors import BadInput
from c4s.files import digest, read_json, write_json
from c4s.names import check_written, checked_id, place_in
from c4s.packs.check import pack_changes
from c4s.records.pack import MANIFEST, STAMP
from c4s.trees import refuse
from catalog.build import sources_digest
from catalog.ingest.collision import How, HullChoice, collision_of
from catalog.ingest.colours import colours_of
from catalog.ingest.excess import excess_row, worst
from catalog.ingest.licence import UNKNOWN, licence
from catalog.ingest.listing import ListingRow, inputs_digest, listing, table
from catalog.ingest.source import Up, read_source
from catalog.ingest.surface import SourcePart
from catalog.ingest.units import check_units, words
from catalog.ingest.vocabulary import is_compound, kind_of, readable, search_words, spoken
from catalog.ingest.writer import PackWriter, identifier
from catalog.settle import REMEDY
from catalog.starter import STARTER

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


def categories(files: list[Path], folder: Path) -> dict[Path, str]:
    """Category of each file: the nearest telling folder, else the first word of the name if two files share it,
    else the kind of thing that the name tells.
    """
    first = {path: _first(path.stem) for path in files}
    count = Counter(first.values())
    found = {}
    for path in files:
        telling = [part for part in path.relative_to(folder).parts[:-1] if _telling(part)]
        shared = first[path] if count[first[path]] > 1 else kind_of(path.stem) or "props"
        found[path] = " ".join(words(telling[-1])) or shared if telling else shared
    return found


def _first(stem: str) -> str:
    """The first word of a name as it is spoken: ``kitchen counter`` of ``kitchencounter_sink``."""
    written, said = words(stem), spoken(stem)
    if not written:
        return "props"
    if is_compound(said[:2]):
        return " ".join(said[:2]).lower()
    return " ".join(spoken(written[0])).lower()


def _telling(part: str) -> bool:
    return bool(set(words(part)) - PLAIN_FOLDERS)


def ingest(
    folder: Path,
    pack_id: str,
    root: Path,
    *,
    scale: float = 1.0,
    title: str | None = None,
    up: Up | None = None,
    hulls: How = "auto",
    hulls_of: Sequence[str] = (),
    replace: bool = False,
    progress: Callable[[int, int, str], None] | None = None,
) -> dict[str, Any]:
    """Build the pack ``root/<pack_id>`` of all mesh files under ``folder`` and return the report.

    Args:
        folder: source folder; nothing outside it is read.
        pack_id: id of the pack; one that exists is left when nothing has changed.
        root: where packs lie.
        scale: factor from the files' units to metres.
        title: title of the pack; the folder's name when left out.
        up: axis that points up in OBJ files (and others, against what they say).
        hulls: how collision is made where a file brings none.
        hulls_of: other choices for some files, as ``bench*=decompose``; the last that fits wins.
        replace: put the new pack in the place of another one of this id, when all is done.
        progress: told (files done, files, name).

    The report names every file that was skipped and why, every note on the others, and what the sizes say.

    Raises:
        BadInput: no such folder, a bad id or scale, or no file that can be used; without ``replace`` also where
            another pack of this id lies there, or one that was changed.
    """
    place = place_in(root, checked_id(pack_id, "pack"), "pack")
    if not np.isfinite(scale) or not 1e-6 <= scale <= 1e6:
        raise BadInput("the scale must be a positive number", where=f"--scale {scale}")
    check_written(Path(os.path.realpath(folder)))
    if pack_id in STARTER:
        raise BadInput("a shipped pack has this id", where=pack_id, todo="choose another --id")
    choice, found = HullChoice.parse(hulls, hulls_of), listing(folder)
    wanted = digest([sources_digest(), inputs_digest(folder), scale, title, up, choice.plain(), folder.name])
    stamp = place / STAMP
    known = read_json(stamp) if stamp.is_file() else {}
    if known.get("inputs") == wanted and (place / MANIFEST).is_file():
        changed = pack_changes(place, known["report"]["sha256"])
        if not changed:
            return {**known["report"], "folder": str(place), "cached": True}
        if not replace:
            refuse(changed, todo=f"restore the file, or {REMEDY}")
    report = _built(
        found.files,
        found.skipped,
        folder,
        PackWriter(pack_id, root, replace=replace),
        scale,
        title,
        up,
        choice,
        progress,
    )
    write_json(stamp, {"inputs": wanted, "report": report})
    return {**report, "folder": str(place), "cached": False}


def _built(
    files: list[Path],
    skipped: list[dict[str, str]],
    folder: Path,
    place: PackWriter,
    scale: float,
    title: str | None,
    up: Up | None,
    hulls: HullChoice,
    progress: Callable[[int, int, str], None] | None,
) -> dict[str, Any]:
    (rows, notes), kinds, sizes, described = table(folder), categories(files, folder), [], 0
    held: list[dict[str, Any]] = []
    name, text = licence(folder)
    if name == UNKNOWN:
        notes.append({"file": "", "note": "no file here tells the licence"})
    with place as writer:
        for number, path in enumerate(files):
            relative = path.relative_to(folder).as_posix()
            if progress:
                progress(number, len(files), relative)
            try:
                source = read_source(path, folder, scale=scale, up=up if path.suffix.lower() == ".obj" else None)
                collision = collision_of(path, folder, source.parts, hulls.how(relative), scale=scale)
            except BadInput as error:
                skipped.append({"file": relative, "reason": error.what})
                continue
            except OSError as error:
                skipped.append({"file": relative, "reason": f"it cannot be opened: {error.strerror or error}"})
                continue
            notes += [{"file": relative, "note": note} for note in [*source.notes, *collision.notes]]
            row = rows.get(relative) or rows.get(path.name) or rows.get(path.stem) or ListingRow()
            described += row != ListingRow()
            asset = writer.add(
                path.stem,
                collision.shown,
                collision.bodies,
                source=collision.source,
                readable=row.name or readable(path.stem),
                category=row.category or kinds[path],
                tags=list(dict.fromkeys([*row.tags, *_tags(path, folder)])),
                description=row.description or _description(path, kinds[path], collision.shown),
            )
            sizes.append((path.stem, max(asset.size_m)))
            held.append(excess_row(relative, collision.shown, collision.bodies))
        if not writer.assets:
            first = skipped[0]
            raise BadInput(
                f"none of {len(files)} mesh files can be used; {first['file']}: {first['reason']}", where=str(folder)
            )
        pack = writer.finish(
            title=title or readable(Path(os.path.realpath(folder)).name),
            license_id=name,
            license_text=text,
            description=f"{len(writer.assets)} assets",
        )
    if any(row != ListingRow() for row in rows.values()):
        notes.append({"file": "", "note": f"{described} assets are described by a table of the folder"})
    check = check_units(sizes)
    return {
        "pack": pack.pack_id,
        "title": pack.title,
        "license": pack.license,
        "sha256": pack.sha256(),
        "files": len(files),
        "assets": len(pack.assets),
        "materials": len(pack.materials),
        "scale": scale,
        "skipped": sorted(skipped, key=lambda row: row["file"]),
        "notes": notes,
        "collision_excess": worst(held),
        "units": {
            "known": check.known,
            "implausible": check.implausible,
            "reason": check.reason,
            "proposed_scale": float(f"{check.proposed * scale:.2g}") if check.proposed else None,
        },
    }


def _tags(path: Path, folder: Path) -> list[str]:
    above = [word for part in path.relative_to(folder).parts[:-1] for word in words(part) if word not in PLAIN_FOLDERS]
    return list(dict.fromkeys([*search_words(path.stem), *(word for word in above if len(word) > 1)]))


def _description(path: Path, category: str, parts: list[SourcePart]) -> str:
    """What a thing is, its colours, its size, and the materials whose names say something."""
    low = np.min([part.vertices.min(axis=0) for part in parts], axis=0)
    size = (np.max([part.vertices.max(axis=0) for part in parts], axis=0) - low) / 100
    kind = kind_of(path.stem) or category
    name = readable(path.stem)
    what = name if kind in name.lower() else f"{name} ({kind})"
    looks = sorted({identifier(part.surface.name).replace("_", " ") for part in parts if part.surface.texture is None})
    telling = [
        look
        for look in looks
        if kind_of(look) is None
        and len(look) > 2
        and not look.lower().startswith(("material", "default", "plain", "mat ", "lambert", "phong", "color", "vertex"))
    ]
    made = f"; materials {', '.join(telling[:5])}" if telling else ""
    return f"{what}; {', '.join(colours_of(parts))}; {size[0]:.2f} x {size[1]:.2f} x {size[2]:.2f} m{made}"
