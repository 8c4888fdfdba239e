"""Pictures of this checkout beside those of another: equal look, equal masks, and the processor time of both.

``python -m bench.looks CHECKOUT`` takes the views of the starter suite's true scenes by both checkouts, each scene in
a process of its own, and prints one JSON object. Seconds are processor time of gathering the level, rendering, and
writing picture and mask, after one small picture that loads the compiled code. It returns 1 where a view is less
similar than the bound, or a mask differs.
"""

from __future__ import annotations

import argparse
import json
import math
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

LEAST_SIMILARITY = 0.98
_SIZE = {"width": 960, "height": 540}


def _posed(view: Mapping[str, Any]) -> dict[str, Any]:
    """A camera with its rotation, as the engine is told of it."""
    rotation = view.get("rotation_deg")
    if rotation is None:
        x, y, z = (t - e for e, t in zip(view["location_cm"], view["target_cm"], strict=True))
        rotation = [math.degrees(math.atan2(z, math.hypot(x, y))), math.degrees(math.atan2(y, x)), 0.0]
    return {**view, "rotation_deg": rotation, "fov_deg": view.get("fov_deg") or 90.0, **_SIZE}


def _scenes() -> Iterator[dict[str, Any]]:
    """Level, packs and cameras of each case; overview views where it has no cameras of its own."""
    from c4s.evidence import open_level
    from c4s.files import read_json
    from c4s.home import packs_root, suites_root
    from c4s.records.suite import SuiteFolder, WithheldFolder
    from c4s.semantics.sight import overview_plan
    from cases.starter.suite import SUITE_ID, build_starter

    root = suites_root() / SUITE_ID
    build_starter(root, packs_root(), lambda line: print(line, file=sys.stderr))
    suite = SuiteFolder(root)
    for folder in sorted((root / "withheld").iterdir()):
        given = WithheldFolder(folder)
        alias = suite.withheld_case(folder.name).alias
        packs = [packs_root() / pack.pack_id for pack in suite.agent_case(alias).packs]
        files = [file for file in (given.cameras, given.target_cameras) if file.is_file()]
        views: list[Mapping[str, Any]] = [view for file in files for view in read_json(file)["views"]]
        if not views:
            with open_level(engine="headless", packs=packs, level=given.truth_level) as clean:
                views = list(overview_plan(clean.snapshot(), clean.probe).cameras)
        yield {
            "case": folder.name,
            "level": str(given.truth_level),
            "packs": [str(pack) for pack in packs],
            "views": [_posed(view) for view in views],
        }


def shoot(scene: Mapping[str, Any], out: Path) -> float:
    """Take a scene's pictures with masks by the ``c4s`` on this process's path; processor seconds."""
    from c4s.engine.headless.pictures import take
    from c4s.engine.headless.process.boot import boot
    from c4s.records.level import Level

    level = Path(scene["level"])
    with tempfile.TemporaryDirectory() as scratch:
        packs = [Path(pack) for pack in scene["packs"]]
        boot(packs, Path(scratch), levels=[level], start_map=Level.read(level).package)
        take.warm()
        before = time.process_time()
        take.take(
            scene["views"], [str(out / f"{scene['case']}-{view['name']}.png") for view in scene["views"]], "lit", True
        )
        return time.process_time() - before


def _by(checkout: Path, scene: Mapping[str, Any], out: Path) -> float:
    spec = out.parent / "scene.json"
    spec.write_text(json.dumps(scene))
    command = [sys.executable, "-P", str(Path(__file__).resolve()), "--shoot", str(spec), str(out)]
    told = subprocess.run(
        command,
        env={**os.environ, "PYTHONPATH": str(checkout)},
        cwd=checkout,
        check=True,
        capture_output=True,
        text=True,
    )
    return float(told.stdout)


def compare(other: Path) -> dict[str, Any]:
    """Seconds a view of both checkouts, the similarity (SSIM) of their pictures, and pixels whose masks differ."""
    import numpy as np
    from PIL import Image

    from c4s.judge.paired.measures import pixel_measures

    own = Path(__file__).resolve().parents[1]
    similar: dict[str, float] = {}
    seconds, changed = [0.0, 0.0], 0
    with tempfile.TemporaryDirectory() as name:
        folders = [Path(name) / "other", Path(name) / "own"]
        for folder in folders:
            folder.mkdir()
        for scene in _scenes():
            for number, (checkout, folder) in enumerate(zip((other, own), folders, strict=True)):
                seconds[number] += _by(checkout, scene, folder)
        for file in sorted(folders[1].glob("*.png")):
            pictures = [np.asarray(Image.open(folder / file.name)) / 255.0 for folder in folders]
            similar[file.stem] = sum(pixel_measures(pictures[1], pictures[0]).values())
            masks = [np.load(folder / f"{file.stem}.actors.npz")["actor"] for folder in folders]
            changed += int((masks[0] != masks[1]).sum())
    worst = min(similar, key=lambda name: similar[name])
    return {
        "views": len(similar),
        "least_similarity": round(similar[worst], 4),
        "at": worst,
        "mean_similarity": round(sum(similar.values()) / len(similar), 4),
        "mask_pixels_that_differ": changed,
        "cpu_seconds_a_view": round(seconds[1] / len(similar), 3),
        "theirs": round(seconds[0] / len(similar), 3),
    }


def main(arguments: Sequence[str] | None = None) -> int:
    """Compare and print, or take one scene's pictures for a comparison."""
    parser = argparse.ArgumentParser(prog="python -m bench.looks", description=__doc__)
    parser.add_argument("checkout", nargs="?", type=Path, help="the other checkout")
    parser.add_argument("--shoot", nargs=2, type=Path, help=argparse.SUPPRESS)
    given = parser.parse_args(arguments)
    if given.shoot:
        print(shoot(json.loads(given.shoot[0].read_text()), given.shoot[1]))
        return 0
    if given.checkout is None:
        parser.error("the other checkout is missing")
    found = compare(given.checkout.resolve())
    print(json.dumps(found, indent=1))
    return int(found["least_similarity"] < LEAST_SIMILARITY or found["mask_pixels_that_differ"] > 0)


if __name__ == "__main__":
    raise SystemExit(main())
