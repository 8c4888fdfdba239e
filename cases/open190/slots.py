"""The slots: source scenes that people made, each in the place of a parametric one where its package is installed.

``slots.yaml`` names for each the package and the manager that installs it, the file with its digest, and how it is
imported. A file that is not there, or is another one than was looked at, leaves the parametric scene where it is.
"""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from fnmatch import fnmatch
from functools import cache
from pathlib import Path
from typing import Any, Final, Literal

from pydantic import Field

from c4s.errors import BadInput
from c4s.files import digest, digest_file, read_json, read_plain, read_yaml, write_json
from c4s.folders import beside, put_folder
from c4s.home import cache_root
from c4s.records.base import Record
from c4s.records.level import Level
from c4s.records.pack import MANIFEST, Pack
from c4s.records.pack import STAMP as PACK_STAMP
from c4s.records.suite import IMPORTED_SCENE
from cases.importers.importing import import_scene
from cases.importers.scene import REPORT, write_scene
from cases.open190.brought import BroughtPlace
from cases.open190.library import SCENES
from cases.open190.scenes import SceneSpec
from cases.zeroad import SOFT, Square, read_map
from catalog.build import sources_digest
from catalog.ingest.collision import HullChoice
from catalog.ingest.licence import licence

VARIABLE: Final = "C4S_SLOTS"
TABLE: Final = Path(__file__).with_name("slots.yaml")
ROOT: Final = Path("/")
SOFT_MESHES: Final = tuple(f"{name}*" for name in SOFT)
"""Water and grass have no bodies: nothing stands on them or meets them."""


class MapPart(Record):
    """A square of a map: the map's name in its archive, its first tile to the east and north, and tiles a side."""

    name: str
    column: int
    row: int
    side: int


class SceneSlot(Record):
    """A source scene that people made, and the package that it comes from."""

    scene_id: str
    in_place_of: str
    """The parametric scene that is used where the package is not installed."""
    environment: Literal["indoor", "outdoor"]
    title: str
    manager: str
    package: str
    version: str
    install: str
    """What a user types to install it."""
    file: str
    """Below the root of the system, or of the folder that ``C4S_SLOTS`` names."""
    file_sha256: str
    licence_file: str
    licence: str
    needs: list[str] = Field(default_factory=list)
    """Programs that read the file."""
    without: list[str] = Field(default_factory=list)
    """Patterns of actors that are left out."""
    soft: list[str] = Field(default_factory=list)
    """Patterns of things of a map that have no bodies and are never changed, such as the meadow around a town."""
    room_cm: tuple[float, float, float, float, float] | None = None
    """Plan (x0, y0, x1, y1) of a room, and the height of its lamps."""
    map: MapPart | None = None
    """The part of a map of 0 A.D. that is the scene; ``file`` is the archive that holds it."""


@cache
def slots() -> tuple[SceneSlot, ...]:
    """The slots in the order of the table."""
    rows = read_yaml(TABLE, what="table of slots")
    return tuple(SceneSlot.parse(row, where=str(TABLE)) for row in rows)


def slots_root() -> Path:
    """Where packages' files lie: the system's root, or the folder that ``C4S_SLOTS`` names."""
    told = os.environ.get(VARIABLE)
    if told is None:
        return ROOT
    if not told.strip() or not Path(told).is_dir():
        raise BadInput(f"{told!r} is no folder", where=VARIABLE, todo="unpack packages into one, or unset it")
    return Path(told).absolute()


@cache
def _digest(file: Path, size: int, changed_ns: int) -> str:
    """Of a file as it was then: one archive of a gigabyte may hold several scenes."""
    return digest_file(file)


def absence(slot: SceneSlot) -> str | None:
    """Why a slot's scene cannot be used here; None where it can."""
    file = slots_root() / slot.file
    if not file.is_file():
        return f"{slot.package} is not installed"
    if _digest(file, file.stat().st_size, file.stat().st_mtime_ns) != slot.file_sha256:
        return f"its file is not the one of {slot.package} {slot.version}"
    missing = [name for name in slot.needs if shutil.which(name) is None]
    return f"{', '.join(missing)} is not installed" if missing else None


@dataclass(frozen=True)
class BroughtSpec:
    """The scene of a slot before it is built; like a ``SceneSpec``, but imported and not laid out."""

    slot: SceneSlot

    @property
    def scene_id(self) -> str:
        """Of the scene; its cases are named for it."""
        return self.slot.scene_id

    @property
    def kind(self) -> Literal["indoor", "outdoor"]:
        """Of its setting."""
        return self.slot.environment

    @property
    def title(self) -> str:
        """What it is called."""
        return self.slot.title

    @property
    def pack_id(self) -> str:
        """The pack of its meshes."""
        return f"open-{self.scene_id}"

    def sources(self) -> str:
        """Digest of all that decides what is imported."""
        import cases.importers
        import cases.zeroad

        packages = [cases.importers, *([] if self.slot.map is None else [cases.zeroad])]
        files = [file for one in packages for file in sorted(Path(str(one.__file__)).parent.glob("*.py"))]
        own = [[path.name, digest_file(path)] for path in (*files, Path(__file__))]
        return digest([sources_digest(), own, self.slot.model_dump(mode="json")])

    def bring(self, packs: Path, *, replace: bool = False) -> Pack:
        """Import the scene unless it is there as these sources import it; its pack.

        Raises:
            BadInput: the file cannot be imported, or another pack of this name is there and ``replace`` is not given.
        """
        stamp, level = packs / self.pack_id / PACK_STAMP, self._level()
        if level.is_file() and stamp.is_file() and read_json(stamp).get("sources") == self.sources():
            return Pack.read(packs / self.pack_id / MANIFEST)
        root = slots_root()
        with beside(level.parent) as scratch:
            report = self._import(root, scratch, packs, replace=replace)
            lasting = {name: value for name, value in report.items() if name != "level"}
            write_json(scratch / self.pack_id / REPORT, {**lasting, "source": self._source()})
            put_folder(scratch / self.pack_id, level.parent, marker=IMPORTED_SCENE)
        write_json(stamp, {"sources": self.sources()})
        return Pack.read(packs / self.pack_id / MANIFEST)

    def _import(self, root: Path, scratch: Path, packs: Path, *, replace: bool) -> dict[str, Any]:
        source, words, part = root / self.slot.file, _told_licence(self.slot, root, scratch), self.slot.map
        if part is None:
            return import_scene(
                source,
                self.pack_id,
                suites=scratch,
                packs=packs,
                without=self.slot.without,
                license_file=words,
                replace=replace,
            )
        scene = read_map(source, part.name, Square(part.column, part.row, part.side))
        for asset in scene.assets.values():
            if any(fnmatch(asset.name, pattern) for pattern in self.slot.soft):
                asset.collision = []
        return write_scene(
            scene,
            self.pack_id,
            source=source,
            told=licence(source.parent, given=words),
            suites=scratch,
            packs=packs,
            without=self.slot.without,
            hulls=HullChoice("auto", tuple((pattern, "none") for pattern in (*SOFT_MESHES, *self.slot.soft))),
            replace=replace,
        )

    def _source(self) -> dict[str, Any]:
        """What the report of the import says of where the scene is from: it was made in a folder of a moment."""
        slot = self.slot
        part = {} if slot.map is None else {"map": slot.map.model_dump(mode="json")}
        return {"manager": slot.manager, "package": slot.package, "version": slot.version, "file": slot.file, **part}

    def place(self, packs: Path) -> BroughtPlace:
        """The scene as the repairs take it; it was brought before."""
        pack = Pack.read(packs / self.pack_id / MANIFEST)
        return BroughtPlace(
            self.scene_id, self.pack_id, Level.read(self._level()), pack.assets, self.slot.room_cm, self.slot.soft
        )

    def _level(self) -> Path:
        return cache_root() / "open-190-slots" / self.pack_id / IMPORTED_SCENE


def _told_licence(slot: SceneSlot, root: Path, scratch: Path) -> Path:
    """The words of the package, under the id that the table gives them."""
    words = read_plain(root / slot.licence_file).decode("utf-8", errors="replace")
    file = scratch / "licence.txt"
    file.write_text(f"SPDX-License-Identifier: {slot.licence}\n\n{words}", encoding="utf-8")
    return file


AnySpec = SceneSpec | BroughtSpec


def chosen(table: Sequence[SceneSlot] | None = None) -> dict[str, AnySpec]:
    """The scenes of the suite by id, in the order of the plan: those of slots where their packages are here."""
    rows = slots() if table is None else table
    here = {slot.in_place_of: BroughtSpec(slot) for slot in rows if absence(slot) is None}
    specs = [here.get(name, spec) for name, spec in SCENES.items()]
    return {spec.scene_id: spec for spec in specs}


def told() -> Mapping[str, str]:
    """What each slot holds here and why, a line a slot by the id of its scene."""
    return {slot.scene_id: _line(slot, absence(slot)) for slot in slots()}


def _line(slot: SceneSlot, reason: str | None) -> str:
    if reason is None:
        return f"from {slot.package} {slot.version} ({slot.manager}), {slot.licence}"
    return f"{slot.in_place_of} in its place: {reason} ({slot.install})"


def held(specs: Iterable[AnySpec]) -> dict[str, str]:
    """What the slots of a suite of some scenes hold: the package, or the parametric scene that is in its place."""
    names = {spec.scene_id for spec in specs}
    return {
        slot.scene_id: f"{slot.package} {slot.version} ({slot.manager})" if slot.scene_id in names else slot.in_place_of
        for slot in slots()
        if {slot.scene_id, slot.in_place_of} & names
    }
