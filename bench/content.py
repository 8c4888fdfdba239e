"""``python -m bench.content FOLDER|ARCHIVE ... [--scale F] [--build FOLDER] [--json]``: what comes in of mesh files.

Every file is read as ``c4s catalog build`` reads it; nothing is written. With ``--build`` that command runs too, with a
``C4S_HOME`` of its own and no cache for each source in that new folder, where the packs stay: assets, processor time
with that of its children, peak memory of its largest process. One row a source: mesh files, assets, skipped files with
their reasons, materials, and notes. An archive (``.zip``, ``.sh3f``, ``.jar``, ``.whl``) is unpacked into a
temporary folder. Where a folder has a furniture catalogue of Sweet Home 3D, sizes are compared with it: an asset counts
unless the catalogue turns the model or gives it a size that its file has not.
"""

from __future__ import annotations

import argparse
import json
import os
import re
import sys
import tempfile
import zipfile
from collections import Counter, defaultdict
from collections.abc import Sequence
from dataclasses import asdict, dataclass, field
from pathlib import Path
from subprocess import PIPE, Popen

import numpy as np

from c4s.errors import BadInput
from catalog.ingest.collision import collision_of
from catalog.ingest.licence import licence
from catalog.ingest.listing import listing
from catalog.ingest.source import read_source
from catalog.ingest.surface import SourcePart

ARCHIVES = (".zip", ".sh3f", ".jar", ".whl")
CATALOGUE = "PluginFurnitureCatalog.properties"
NEAR = 0.02
"""Sizes are equal within this share."""


@dataclass
class FolderContent:
    """What one source holds."""

    source: str
    licence: str = ""
    ai_use: str = ""
    files: int = 0
    assets: int = 0
    materials: int = 0
    several_materials: int = 0
    """Assets with more than one material."""
    skipped: dict[str, int] = field(default_factory=dict)
    notes: dict[str, int] = field(default_factory=dict)
    sized: int = 0
    """Assets whose size the catalogue states as their file has it."""
    near: int = 0
    """Of those, the assets that are as large."""
    built: int = 0
    """Assets of the pack that was built."""
    processor_s: float = 0.0
    peak_mb: float = 0.0


def content(folder: Path, *, scale: float = 1.0) -> FolderContent:
    """Read every mesh file of a folder."""
    found, row = listing(folder), FolderContent(folder.name)
    told = licence(folder, found.files)
    row.licence, row.ai_use, row.files = told.id, told.ai_use, len(found.files) + len(found.skipped)
    skipped = Counter(_kind(one["reason"]) for one in found.skipped)
    notes: Counter[str] = Counter()
    looks = set()
    sizes: dict[str, tuple[float, ...]] = {}
    for path in found.files:
        try:
            source = read_source(path, folder, scale=scale)
            parts = collision_of(path, folder, source.parts, "none", scale=scale).shown
        except BadInput as error:
            skipped[_kind(error.what)] += 1
            continue
        row.assets += 1
        own = {part.surface for part in parts}
        looks |= own
        row.several_materials += len(own) > 1
        notes.update({_kind(text) for text in source.notes})
        sizes[path.relative_to(folder).as_posix()] = _size_m(parts)
    row.materials, row.skipped, row.notes = len(looks), dict(skipped.most_common()), dict(notes.most_common(8))
    for file, wanted in furniture_sizes(folder).items():
        if file in sizes:
            row.sized += 1
            row.near += _alike(sizes[file], wanted)
    return row


def build(folder: Path, home: Path, row: FolderContent, *, scale: float = 1.0) -> None:
    """Build a pack of a folder in a home of its own, and note what that took."""
    call = [
        sys.executable,
        "-m",
        "c4s.cli",
        "catalog",
        "build",
        str(folder),
        "--id",
        "pack",
        "--scale",
        str(scale),
        "--json",
    ]
    with Popen(call, env={**os.environ, "C4S_HOME": str(home)}, stdout=PIPE, text=True) as running:
        assert running.stdout is not None
        told = running.stdout.read()
        _, status, used = os.wait4(running.pid, 0)
        running.returncode = os.waitstatus_to_exitcode(status)
    if running.returncode:
        raise BadInput(f"c4s catalog build ended with {running.returncode}", where=str(folder))
    row.built = json.loads(told)["assets"]
    row.processor_s, row.peak_mb = round(used.ru_utime + used.ru_stime, 1), round(used.ru_maxrss / 1024)


def _kind(text: str) -> str:
    """A reason or note without names and numbers, so that equal ones are counted together."""
    return re.sub(r"\b\d[\d.,]*\b", "N", re.sub(r"'[^']*'", "'...'", text.split(" (")[0]))[:90]


def _size_m(parts: Sequence[SourcePart]) -> tuple[float, ...]:
    points = np.concatenate([part.vertices for part in parts])
    return tuple((np.ptp(points, axis=0) / 100).tolist())


def _alike(one: Sequence[float], two: Sequence[float]) -> bool:
    return all(abs(a - b) <= NEAR * max(abs(b), 1e-9) for a, b in zip(one, two, strict=True))


def furniture_sizes(folder: Path) -> dict[str, tuple[float, ...]]:
    """Width, depth and height (m) of the models that a Sweet Home 3D catalogue in a folder shows as they are.

    Left out are those that it turns, and those for which it states another size than the points of their file span in
    centimetres (it scales them then).
    """
    path = folder / CATALOGUE
    if not path.is_file():
        return {}
    rows: dict[str, dict[str, str]] = defaultdict(dict)
    for key, number, value in re.findall(r"(?m)^\s*(\w+)#(\d+)\s*=\s*(.*?)\s*$", path.read_text(encoding="latin-1")):
        rows[number][key] = value
    found = {}
    for row in rows.values():
        model = row.get("model", "").lstrip("/")
        if not (folder / model).is_file() or "modelRotation" in row or not model.endswith(".obj"):
            continue
        wanted = tuple(float(row[key]) / 100 for key in ("width", "depth", "height"))
        if _alike(_spanned(folder / model), wanted):
            found[model] = wanted
    return found


def _spanned(path: Path) -> tuple[float, ...]:
    """What the ``v`` lines of an OBJ file span, in metres where its unit is the centimetre: width, depth, height."""
    lines = re.findall(r"(?m)^v\s+(\S+)\s+(\S+)\s+(\S+)", path.read_text(encoding="latin-1"))
    x, y, z = np.ptp(np.array(lines, dtype=float), axis=0) / 100
    return float(x), float(z), float(y)


def main(arguments: Sequence[str] | None = None) -> None:
    """Read and print."""
    parser = argparse.ArgumentParser(prog="python -m bench.content", description=__doc__)
    parser.add_argument("sources", nargs="+", type=Path)
    parser.add_argument("--scale", type=float, default=1.0, help="metres per unit of the files")
    parser.add_argument("--json", action="store_true", help="one JSON object a line")
    parser.add_argument(
        "--build", type=Path, metavar="FOLDER", help="build a pack of each, in homes in this new folder"
    )
    given = parser.parse_args(arguments)
    if given.build is not None:
        given.build.mkdir(parents=True)
    for source in given.sources:
        with tempfile.TemporaryDirectory() as scratch:
            folder = source
            if source.suffix in ARCHIVES:
                folder = Path(scratch, source.stem)
                with zipfile.ZipFile(source) as packed:
                    packed.extractall(folder)
            row = content(folder, scale=given.scale)
            if given.build is not None:
                build(folder, given.build / folder.name, row, scale=given.scale)
        if given.json:
            print(json.dumps(asdict(row)), flush=True)
            continue
        print(
            f"{row.source}: {row.files} files, {row.assets} assets ({row.several_materials} of several materials), "
            f"{row.materials} materials, licence {row.licence}, AI use {row.ai_use}"
            + (f", {row.near} of {row.sized} as large as catalogued" if row.sized else "")
            + (f", built {row.built} in {row.processor_s:.0f} s, {row.peak_mb:.0f} MB" if row.built else ""),
            flush=True,
        )
        for word, counts in (("skipped", row.skipped), ("note", row.notes)):
            for text, count in counts.items():
                print(f"    {word} {count}: {text}")


if __name__ == "__main__":
    main()
