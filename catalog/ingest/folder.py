"""``c4s catalog build``: a folder of mesh files becomes a pack."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from c4s.errors import BadInput
from c4s.files import digest, read_json, write_json
from c4s.names import check_written, checked_id, place_in
from c4s.packs.check import pack_changes
from c4s.records.pack import MANIFEST, STAMP, Pack
from c4s.trees import refuse
from catalog.build import sources_digest
from catalog.ingest.collision import How, HullChoice, collision_of
from catalog.ingest.colours import colours_of
from catalog.ingest.excess import excess_row, worst
from catalog.ingest.licence import licence
from catalog.ingest.listing import Listing, ListingRow, inputs_digest, listing, table
from catalog.ingest.naming import PLAIN_FOLDERS, categories, named, says
from catalog.ingest.pivots import bottom, moved, moved_bodies, outside
from catalog.ingest.scales import ScaleChoice
from catalog.ingest.sidecar import sidecar
from catalog.ingest.source import Up, read_source
from catalog.ingest.surface import SourcePart
from catalog.ingest.units import OddSize, check_units, odd_sizes, words
from catalog.ingest.vocabulary import kind_of, readable, search_words
from catalog.ingest.writer import PackWriter, identifier
from catalog.settle import REMEDY
from catalog.starter import STARTER


@dataclass(frozen=True)
class Wishes:
    """How a pack is made of a folder; see ``ingest``."""

    scale: ScaleChoice
    title: str | None
    up: Up | None
    hulls: HullChoice
    recentre: bool
    licence: Path | None

    def plain(self) -> list[object]:
        """As plain data."""
        return [self.scale.plain(), self.title, self.up, self.hulls.plain(), self.recentre]


def ingest(
    folder: Path,
    pack_id: str,
    root: Path,
    *,
    scale: float = 1.0,
    scale_of: Sequence[str] = (),
    title: str | None = None,
    up: Up | None = None,
    hulls: How = "auto",
    hulls_of: Sequence[str] = (),
    recentre: bool = False,
    license_file: Path | None = None,
    replace: bool = False,
    progress: Callable[[int, int, str], None] | None = None,
) -> dict[str, Any]:
    """Build the pack ``root/<pack_id>`` of all mesh files under ``folder`` and return the report.

    Args:
        folder: source folder; nothing outside it is read, but for licence files of the folders above.
        pack_id: id of the pack; one that exists is left when nothing has changed.
        root: where packs lie.
        scale: factor from the files' units to metres.
        scale_of: other factors for some files, as ``chair*=0.01``; the last that fits wins.
        title: title of the pack; the folder's name when left out.
        up: axis that points up in OBJ files (and others, against what they say).
        hulls: how collision is made where a file brings none.
        hulls_of: other choices for some files, as ``bench*=decompose``; the last that fits wins.
        recentre: move pivots that lie outside their mesh to the middle of its bottom.
        license_file: the file that tells the licence; found in and around the folder when left out.
        replace: put the new pack in the place of another one of this id, when all is done.
        progress: told (files done, files, name).

    The report names every file that was skipped and why, every note on the others, and what the sizes say.

    Raises:
        BadInput: no such folder, a bad id or scale, or no file that can be used; without ``replace`` also where
            another pack of this id lies there, or one that was changed.
    """
    place = place_in(root, checked_id(pack_id, "pack"), "pack")
    wishes = Wishes(
        ScaleChoice.parse(scale, scale_of), title, up, HullChoice.parse(hulls, hulls_of), recentre, license_file
    )
    check_written(Path(os.path.realpath(folder)))
    if pack_id in STARTER:
        raise BadInput("a shipped pack has this id", where=pack_id, todo="choose another --id")
    found = listing(folder)
    told = licence(folder, found.files, [row.licence for row in table(folder)[0].values()], license_file)
    wanted = digest([sources_digest(), inputs_digest(folder), wishes.plain(), told.id, told.text, folder.name])
    stamp = place / STAMP
    known = read_json(stamp) if stamp.is_file() else {}
    if known.get("inputs") == wanted and (place / MANIFEST).is_file():
        changed = pack_changes(place, known["report"]["sha256"])
        if not changed:
            return {**known["report"], "folder": str(place), "cached": True}
        if not replace:
            refuse(changed, todo=f"restore the file, or {REMEDY}")
    report = _Build(folder, found, wishes, progress).write(PackWriter(pack_id, root, replace=replace))
    write_json(stamp, {"inputs": wanted, "report": report})
    return {**report, "folder": str(place), "cached": False}


class _Build:
    """One pack in the making: what was skipped and noted, and how large each thing is."""

    def __init__(
        self, folder: Path, found: Listing, wishes: Wishes, progress: Callable[[int, int, str], None] | None
    ) -> None:
        self.folder, self.files, self.wishes, self.progress = folder, found.files, wishes, progress
        self.skipped = list(found.skipped)
        self.rows, self.notes = table(folder)
        self.names = named(self.files, folder)
        self.kinds = categories(self.names)
        self.sizes: list[tuple[str, str, float]] = []
        self.stated: list[str] = []
        self.held: list[dict[str, Any]] = []
        self.described = self.beside = 0

    def write(self, place: PackWriter) -> dict[str, Any]:
        """Add every file that can be read and put the pack in its place; returns the report."""
        with place as writer:
            for number, path in enumerate(self.files):
                relative = path.relative_to(self.folder).as_posix()
                if self.progress:
                    self.progress(number, len(self.files), relative)
                try:
                    self._add(path, relative, writer)
                except BadInput as error:
                    self.skipped.append({"file": relative, "reason": error.what})
                except OSError as error:
                    self.skipped.append({"file": relative, "reason": f"it cannot be opened: {error.strerror or error}"})
            if not writer.assets:
                first = self.skipped[0]
                raise BadInput(
                    f"none of {len(self.files)} mesh files can be used; {first['file']}: {first['reason']}",
                    where=str(self.folder),
                )
            told = licence(self.folder, self.files, self.stated, self.wishes.licence)
            pack = writer.finish(
                title=self.wishes.title or readable(Path(os.path.realpath(self.folder)).name),
                license_id=told.id,
                license_text=told.text,
                ai_use=told.ai_use,
                description=f"{len(writer.assets)} assets",
            )
        for text in told.notes:
            self._note("", text)
        if self.described:
            self._note("", f"{self.described} assets are described by a table of the folder")
        if self.beside:
            self._note("", f"{self.beside} assets are described by files beside them")
        return self._report(pack, told.ai_reason)

    def _add(self, path: Path, relative: str, writer: PackWriter) -> None:
        wishes, name, kind = self.wishes, self.names[path].name, self.kinds[path]
        scale = wishes.scale.of_file(relative)
        source = read_source(path, self.folder, scale=scale, up=wishes.up if path.suffix.lower() == ".obj" else None)
        collision = collision_of(path, self.folder, source.parts, wishes.hulls.how(relative), scale=scale)
        parts, bodies = collision.shown, collision.bodies
        for text in [*source.notes, *collision.notes]:
            self._note(relative, text)
        away = outside(parts)
        if away and wishes.recentre:
            by = -bottom(parts)
            parts, bodies = moved(parts, by), moved_bodies(bodies, by)
            self._note(relative, "its pivot lay outside the mesh and is moved to the middle of its bottom")
        elif away:
            self._note(relative, f"its pivot lies {away / 100:.3g} m outside the mesh; --recentre moves it")
        row = self._row(path, relative)
        asset = writer.add(
            name,
            parts,
            bodies,
            source=collision.source,
            readable=row.name or readable(name),
            category=row.category or kind,
            tags=list(dict.fromkeys([*row.tags, *self._tags(path, row.name)])),
            description=row.description or _description(name, kind, parts),
        )
        self.held.append(excess_row(relative, parts, bodies))
        self.sizes.append((relative, row.name if check_units([(row.name, 1.0)]).known else name, max(asset.size_m)))

    def _row(self, path: Path, relative: str) -> ListingRow:
        """What tables and files beside it say of a file."""
        listed = self.rows.get(relative) or self.rows.get(path.name) or self.rows.get(path.stem) or ListingRow()
        beside, notes = sidecar(path, self.folder, self.files)
        for text in notes:
            self._note(relative, text)
        self.described += listed != ListingRow()
        self.beside += beside != ListingRow()
        row = listed.over(beside)
        if row.licence:
            self.stated.append(row.licence)
        return row

    def _tags(self, path: Path, title: str) -> list[str]:
        above = [
            word
            for part in path.relative_to(self.folder).parts[:-1]
            if says(part)
            for word in words(part)
            if word not in PLAIN_FOLDERS and len(word) > 1
        ]
        return list(
            dict.fromkeys([*search_words(self.names[path].name), *(search_words(title) if title else []), *above])
        )

    def _note(self, file: str, text: str) -> None:
        self.notes.append({"file": file, "note": text})

    def _report(self, pack: Pack, ai_reason: str) -> dict[str, Any]:
        check = check_units([(name, side) for _, name, side in self.sizes])
        whole = check.proposed or 1.0
        for index, odd in odd_sizes([(name, side * whole) for _, name, side in self.sizes]).items():
            file, _, side = self.sizes[index]
            self._note(file, self._odd(file, side, odd, whole))
        return {
            "pack": pack.pack_id,
            "title": pack.title,
            "license": pack.license,
            "ai_use": pack.ai_use,
            "ai_use_reason": ai_reason,
            "sha256": pack.sha256(),
            "files": len(self.files),
            "assets": len(pack.assets),
            "materials": len(pack.materials),
            "scale": self.wishes.scale.default,
            "skipped": sorted(self.skipped, key=lambda row: row["file"]),
            "notes": self.notes,
            "collision_excess": worst(self.held),
            "units": {
                "known": check.known,
                "implausible": check.implausible,
                "reason": check.reason,
                "proposed_scale": float(f"{whole * self.wishes.scale.default:.2g}") if check.proposed else None,
            },
        }

    def _odd(self, file: str, side: float, odd: OddSize, whole: float) -> str:
        said = f"its size is unlike the others': {odd.reason}{f' (at {whole:.2g} times)' if whole != 1 else ''}"
        if odd.factor == 1.0:
            return said
        return f"{said}; --scale-of '{file}={odd.factor * whole * self.wishes.scale.of_file(file):.3g}' fits"


def _description(stem: str, category: str, parts: list[SourcePart]) -> str:
    """What a thing is, its colours, its size, and the materials whose names say something."""
    low = np.min([part.vertices.min(axis=0) for part in parts], axis=0)
    size = (np.max([part.vertices.max(axis=0) for part in parts], axis=0) - low) / 100
    kind = kind_of(stem) or category
    name = readable(stem)
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
