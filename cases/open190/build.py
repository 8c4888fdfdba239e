"""Builds packs, levels, pictures and the check of physics of scenes, one at a time; what is unchanged is kept.

``python -m cases.open190.build [scene ...] [--out FOLDER] [--quick]``. A scene's folder holds ``scene.level.json``,
``views/`` and ``report.json`` (counts, physics, seconds).
"""

from __future__ import annotations

import argparse
import json
import shutil
import tempfile
import time
from pathlib import Path
from typing import Any

from c4s.engine import DEFAULT_ENGINE
from c4s.evidence import open_level
from c4s.files import digest, digest_file, read_json, write_json
from c4s.folders import remove_tree
from c4s.home import packs_root, suites_root
from c4s.records.folder import EvidenceFolder
from c4s.records.pack import MANIFEST
from c4s.verify.physics.verdict import verify_physics
from cases.model import SourceScene
from cases.open190.eyes import views
from cases.open190.layout import StagedPlace
from cases.open190.library import SCENES
from cases.open190.scenes import SceneSpec
from cases.standing import unsound
from cases.views import camera
from catalog.build import build_pack, sources_digest

REPORT = "report.json"
LAID_OUT_BY = ("eyes.py", "layout/**/*.py", "parts/**/*.py", "places/**/*.py", "scenes.py", "space.py")
"""Which files of this package decide what a scene is."""


def source_scene(spec: SceneSpec, place: StagedPlace) -> SourceScene:
    """A laid out scene as the suite's builder takes it."""
    return SourceScene(
        spec.scene_id, "indoor" if spec.kind == "indoor" else "outdoor", spec.title, place.level(), (place.pack_id,)
    )


def laid_out_by() -> list[Path]:
    """The files of this package that decide what a scene is."""
    here = Path(__file__).parent
    return sorted(path for pattern in LAID_OUT_BY for path in here.glob(pattern))


def sources() -> str:
    """Digest of all sources that decide how a scene is laid out, and what its things are."""
    here = Path(__file__).parent
    own = [(path.relative_to(here).as_posix(), digest_file(path)) for path in laid_out_by()]
    return digest([sources_digest(), own])


def build_scene(spec: SceneSpec, packs: Path, out: Path, *, quick: bool = False) -> dict[str, Any]:
    """Build a scene's pack, level, pictures and report under ``out/<scene id>``, unless they are there unchanged.

    ``quick`` leaves out the previews of the pack's assets and takes the pictures at half size.
    """
    folder = out / spec.scene_id
    stamp = digest([sources(), spec.scene_id, quick])
    if (
        (folder / REPORT).is_file()
        and read_json(folder / REPORT).get("stamp") == stamp
        and (packs / f"open-{spec.scene_id}" / MANIFEST).is_file()
    ):
        report: dict[str, Any] = read_json(folder / REPORT)
        return report
    started = time.perf_counter()
    place = spec.place()
    level = place.level()
    laid = time.perf_counter()
    pack = build_pack(place.assortment.pack(place.pack_id, spec.title), packs, replace=True, previews=not quick)
    packed = time.perf_counter()
    if folder.exists():
        remove_tree(folder, inside=out)
    folder.mkdir(parents=True)
    level.write(folder / "scene.level.json")
    cameras = views(place)
    with tempfile.TemporaryDirectory(prefix="c4s-open-") as scratch:
        evidence = Path(scratch) / "seen"
        with open_level(
            engine=DEFAULT_ENGINE, packs=[packs / place.pack_id], level=folder / "scene.level.json"
        ) as clean:
            snapshot = clean.export(evidence)
            half = {"width": 640, "height": 360} if quick else {}
            clean.look(evidence, [{**camera(view), **half} for view in cameras])
        for view in cameras:
            (folder / "views").mkdir(exist_ok=True)
            shutil.copyfile(
                EvidenceFolder(evidence).captures / f"{view.name}.png", folder / "views" / f"{view.name}.png"
            )
    seen = time.perf_counter()
    verdict = verify_physics("text-to-scene", snapshot)
    leaves = {leaf["leaf_id"]: leaf for leaf in verdict.measurements["leaf_results"]}
    floats = leaves["floating"].get("floating_actors") or []
    inside = [row["actor"] for row in leaves["solid_penetration"].get("actors", []) if row["state"] != "clean"]
    bad = sorted(unsound(snapshot)) if spec.kind != "text" else []
    report = {
        "stamp": stamp,
        "scene": spec.scene_id,
        "kind": spec.kind,
        "title": spec.title,
        "style": spec.style.name,
        "actors": len(level.actors),
        "assets": len(pack.assets),
        "used": len({item.thing.name for item in place.items.values()}),
        "relations": len(place.relations),
        "physical_safety": verdict.score if spec.kind == "text" else round(1 - len(bad) / len(level.actors), 4),
        "floating": floats[:30],
        "penetrating": inside[:30],
        "unsound": bad[:30],
        "unsound_count": len(bad),
        "left_out": {name: count for name, count in place.left_out.most_common(20) if count},
        "level_sha256": digest(level.plain()),
        "pack_sha256": pack.sha256(),
        "seconds": {
            "layout": round(laid - started, 1),
            "pack": round(packed - laid, 1),
            "pictures": round(seen - packed, 1),
            "check": round(time.perf_counter() - seen, 1),
        },
    }
    write_json(folder / REPORT, report)
    return report


def main() -> None:
    """Command line of the build."""
    parser = argparse.ArgumentParser(description="Build the scenes of open-190.")
    parser.add_argument("scenes", nargs="*", help="all when none is named")
    parser.add_argument("--out", type=Path, default=None)
    parser.add_argument("--packs", type=Path, default=None)
    parser.add_argument("--quick", action="store_true", help="no previews, small pictures")
    options = parser.parse_args()
    for name in options.scenes or list(SCENES):
        report = build_scene(
            SCENES[name],
            options.packs or packs_root(),
            options.out or suites_root() / "open-190-scenes",
            quick=options.quick,
        )
        shown = (
            "scene",
            "kind",
            "style",
            "actors",
            "assets",
            "used",
            "physical_safety",
            "unsound_count",
            "floating",
            "penetrating",
            "left_out",
            "seconds",
        )
        print(json.dumps({key: report[key] for key in shown}), flush=True)


if __name__ == "__main__":
    main()
