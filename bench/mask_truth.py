"""``python -m bench.mask_truth LEVEL BLEND``: the actor masks of an imported scene against Blender's own rays.

LEVEL is ``scene.level.json`` of a scene that ``c4s suite import-scene`` made of the Blender file BLEND. Of one camera
above a corner of it, every pixel's actor is asked of our renderer and of Blender, which casts its rays into its own
file. Printed are the actors that either sees in 50 pixels or more, with the intersection over union of their masks:
median and the five worst. An actor below others is called by their names too, so a name that ends in Blender's is it.
Without ``blender`` on the search path the script says so and ends with 0. Exit 1 where the median is below 0.99.
"""

from __future__ import annotations

import argparse
import json
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from c4s.cli.levels import packs_of
from c4s.engine import backend
from c4s.engine.headless.process.boot import boot
from c4s.records.level import Level

WIDTH, HEIGHT, FOV_DEG = 320, 180, 60.0
LEAST_PIXELS = 50
LEAST_MEDIAN = 0.99
INSIDE = r"""
import bpy, json, math, sys
from mathutils import Vector
x, y, z, pitch, yaw, fov, width, height = json.loads(sys.argv[-1])
p, w = math.radians(pitch), math.radians(yaw)
ahead = Vector((math.cos(p) * math.cos(w), -math.cos(p) * math.sin(w), math.sin(p)))
turn, eye = ahead.to_track_quat("-Z", "Y"), Vector((x / 100, -y / 100, z / 100))
scene, graph, half = bpy.context.scene, bpy.context.evaluated_depsgraph_get(), math.tan(math.radians(fov) / 2)
seen = []
for row in range(height):
    for column in range(width):
        across, up = (2 * (column + 0.5) / width - 1) * half, (1 - 2 * (row + 0.5) / height) * half * height / width
        ray = turn @ Vector((across, up, -1))
        ray.normalize()
        hit, _, _, _, thing, _ = scene.ray_cast(graph, eye, ray)
        seen.append(thing.name if hit else "")
print("SEEN " + json.dumps(seen))
"""


def ours(level: Path) -> tuple[list[float], NDArray[np.str_]]:
    """The camera (place in cm, pitch, yaw and field of view in degrees, width, height), and the actor of each pixel."""
    from c4s.engine.headless.pictures.take import take
    from c4s.engine.headless.world.state import world

    with tempfile.TemporaryDirectory() as place:
        packs = packs_of(backend("headless").asset_paths(level))
        boot(packs, Path(place), levels=[level], start_map=Level.read(level).package)
        spans = []
        for one in world().drawables():
            points = world().store.mesh(one.mesh).vertices
            spans.append(np.c_[points, np.ones(len(points))] @ one.matrix.T)
        low, high = (np.percentile(np.concatenate(spans)[:, :3], share, axis=0) for share in (2, 98))
        reach = float((high - low).max())
        towards = -np.array([0.55, 0.65, 0.75])
        at = (low + high) / 2 - towards * reach
        yaw = float(np.degrees(np.arctan2(towards[1], towards[0])))
        pitch = float(np.degrees(np.arctan2(towards[2], np.hypot(towards[0], towards[1]))))
        camera = {"name": "view", "location_cm": at.tolist(), "rotation_deg": [pitch, yaw, 0.0], "fov_deg": FOV_DEG}
        picture = Path(place, "view.png")
        take([{**camera, "width": WIDTH, "height": HEIGHT}], [str(picture)], "lit", masks=True)
        with np.load(picture.with_suffix(".actors.npz"), allow_pickle=False) as masks:
            labels = np.concatenate([masks["labels"], [""]])
            return [*at.tolist(), pitch, yaw, FOV_DEG, WIDTH, HEIGHT], plain(labels)[masks["actor"]]


def plain(names: NDArray[np.str_]) -> NDArray[np.str_]:
    """Names as actors have them: no character but letters, digits and ``_``."""
    return np.array([re.sub(r"\W", "_", str(name)).lower() for name in names])


def blenders(file: Path, view: list[float]) -> NDArray[np.str_]:
    """The object of each pixel that Blender's rays meet in its own file."""
    with tempfile.TemporaryDirectory() as place:
        script = Path(place, "inside.py")
        script.write_text(INSIDE)
        call = ["blender", "--background", str(file), "--python", str(script), "--", json.dumps(view)]
        done = subprocess.run(call, capture_output=True, text=True, check=False)
    line = next((line for line in done.stdout.splitlines() if line.startswith("SEEN ")), None)
    if line is None:
        sys.exit(f"Blender saw nothing: {(done.stdout + done.stderr)[-2000:]}")
    return plain(np.array(json.loads(line.removeprefix("SEEN ")))).reshape(HEIGHT, WIDTH)


def called(theirs: NDArray[np.str_], labels: set[str]) -> NDArray[np.str_]:
    """Blender's objects by the labels of actors, where just one label ends in an object's name."""
    names, which = np.unique(theirs, return_inverse=True)
    told = []
    for name in map(str, names):
        longer = [label for label in labels if name and label.endswith(f"_{name}")]
        told.append(longer[0] if name not in labels and len(longer) == 1 else name)
    return np.array(told)[which].reshape(theirs.shape)


def main() -> int:
    """Compare and print."""
    parser = argparse.ArgumentParser(prog="python -m bench.mask_truth", description=__doc__)
    parser.add_argument("level", type=Path)
    parser.add_argument("blend", type=Path)
    given = parser.parse_args()
    if shutil.which("blender") is None:
        print("blender is not on the search path: nothing to compare with")
        return 0
    view, mine = ours(given.level)
    theirs = called(blenders(given.blend, view), set(np.unique(mine)))
    rows = []
    for name in set(np.unique(mine)) | set(np.unique(theirs)) - {""}:
        a, b = mine == name, theirs == name
        if name and max(a.sum(), b.sum()) >= LEAST_PIXELS:
            rows.append((float((a & b).sum() / (a | b).sum()), str(name), int(a.sum()), int(b.sum())))
    if not rows:
        sys.exit("no actor is seen in enough pixels")
    rows.sort()
    median = float(np.median([row[0] for row in rows]))
    print(f"{len(rows)} actors, median IoU {median:.4f}, pixels alike {float((mine == theirs).mean()):.4f}")
    for share, name, own, other in rows[:5]:
        print(f"    {share:.4f} {name}: {own} pixels ours, {other} Blender's")
    return int(median < LEAST_MEDIAN)


if __name__ == "__main__":
    sys.exit(main())
