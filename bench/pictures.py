"""Captures of a level of 6,700 actors by the headless engine, beside panda3d's software renderer where it is installed.

``python -m bench.pictures [--actors N] [--out FOLDER]`` prints one JSON object. A capture is all that an agent waits
for: the level's geometry and lights gathered anew, the ray structure built, the picture taken and its PNG written. The
rival (``pip install panda3d``) rasterises the same meshes in place without shadows, textures, mask or depth; its scene
is built before its clock starts, and its frame is copied out as bytes.
"""

from __future__ import annotations

import argparse
import importlib
import json
import statistics
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

import numpy as np

from bench.row import Row
from bench.town import PACKAGE, write_town
from c4s.errors import MachineryFault
from c4s.home import packs_root
from catalog.build import ensure_pack

WIDTH, HEIGHT, FOV_DEG = 1280, 720, 80.0
VIEWS = (
    ((-9200.0, -9200.0, 900.0), (-12.0, 45.0, 0.0)),
    ((0.0, 0.0, 160.0), (-5.0, 10.0, 0.0)),
    ((-3000.0, -2000.0, 1500.0), (-35.0, 30.0, 0.0)),
    ((0.0, 0.0, 9000.0), (-89.0, 0.0, 0.0)),
    ((2000.0, 1000.0, 300.0), (-10.0, 200.0, 0.0)),
)
"""Location (cm) and [pitch, yaw, roll]."""
_PACK = "c4s-home"
_GOAL_S = 2.0


def run(actors: int = 6700, out: Path | None = None) -> dict[str, Any]:
    """Seconds of each view, ours after one capture that loads meshes, and the rival's; pictures go to ``out``."""
    from c4s.engine.headless.pictures import take
    from c4s.engine.headless.process.boot import boot

    pack = ensure_pack(_PACK, packs_root())
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch)
        level = write_town(folder, pack, actors)
        boot([packs_root() / _PACK], folder / "content", levels=[level], start_map=PACKAGE)
        pictures = out or folder
        pictures.mkdir(parents=True, exist_ok=True)
        seconds: list[float] = []
        processor: list[float] = []
        for number in (0, *range(len(VIEWS))):
            location, rotation = VIEWS[number]
            view = {
                "location_cm": location,
                "rotation_deg": rotation,
                "fov_deg": FOV_DEG,
                "width": WIDTH,
                "height": HEIGHT,
            }
            wall, cpu = time.perf_counter(), time.process_time()
            take.take([view], [str(pictures / f"view-{number}.png")], "lit", False)
            seconds.append(time.perf_counter() - wall)
            processor.append(time.process_time() - cpu)
        rival = _panda_seconds(pictures)
    return {
        "work": f"captures {WIDTH}x{HEIGHT}",
        "actors": actors,
        "views": len(VIEWS),
        "seconds": round(statistics.median(seconds[1:]), 3),
        "worst_s": round(max(seconds[1:]), 3),
        "cpu_seconds": round(statistics.median(processor[1:]), 3),
        "first_s": round(seconds[0], 3),
        "rival": "panda3d software" if rival else None,
        "rival_seconds": round(statistics.median(rival), 3) if rival else None,
    }


def _panda_seconds(pictures: Path) -> list[float]:
    """Seconds of each view by panda3d's software rasteriser; none, and a line, where it is not installed."""
    try:
        core: Any = importlib.import_module("panda3d.core")
        show_base: Any = importlib.import_module("direct.showbase.ShowBase")
    except ImportError:
        print("panda3d is not installed: no rival for pictures (pip install panda3d)", file=sys.stderr)
        return []
    from c4s.engine.headless.world.state import world

    for setting in (
        "load-display p3tinydisplay",
        "window-type offscreen",
        f"win-size {WIDTH} {HEIGHT}",
        "audio-library-name null",
        "notify-level-display fatal",
    ):
        core.loadPrcFileData("", setting)
    base = show_base.ShowBase(windowType="offscreen")
    kinds: dict[str, Any] = {}
    for shown in world().drawables():
        if shown.mesh not in kinds:
            kinds[shown.mesh] = _panda_mesh(core, world().store.mesh(shown.mesh))
        place = base.render.attachNewNode("actor")
        place.attachNewNode(kinds[shown.mesh])
        place.setMat(core.LMatrix4f(*shown.matrix.T.astype(float).ravel().tolist()))
        place.setTwoSided(True)
    sun = base.render.attachNewNode(core.DirectionalLight("sun"))
    sun.setHpr(20, -45, 0)
    base.render.setLight(sun)
    base.camLens.setFov(FOV_DEG)
    base.camLens.setNearFar(10, 100000)
    seconds = []
    for location, (pitch, yaw, _) in (VIEWS[0], *VIEWS):
        base.camera.setPosHpr(*location, yaw - 90, pitch, 0)
        start = time.perf_counter()
        base.graphicsEngine.renderFrame()
        picture = core.PNMImage()
        drawn = base.win.getScreenshot(picture)
        seconds.append(time.perf_counter() - start)
        if not drawn or picture.getAverageGray() <= 0:
            raise MachineryFault("panda3d drew nothing", where="bench.pictures")
        picture.write(core.Filename(str(pictures / f"panda3d-{len(seconds) - 1}.png")))
    base.destroy()
    return seconds[1:]


def _panda_mesh(core: Any, mesh: Any) -> Any:
    form = core.GeomVertexFormat.getV3n3()
    data = core.GeomVertexData("mesh", form, core.Geom.UHStatic)
    data.uncleanSetNumRows(len(mesh.vertices))
    rows = np.ascontiguousarray(np.concatenate([mesh.vertices, mesh.normals], axis=1), dtype=np.float32)
    data.modifyArrayHandle(0).copyDataFrom(rows.tobytes())
    triangles = core.GeomTriangles(core.Geom.UHStatic)
    triangles.setIndexType(core.Geom.NTUint32)
    triangles.modifyVertices().uncleanSetNumRows(mesh.faces.size)
    triangles.modifyVertices().modifyHandle().copyDataFrom(mesh.faces.astype(np.uint32).tobytes())
    geometry = core.Geom(data)
    geometry.addPrimitive(triangles)
    node = core.GeomNode("mesh")
    node.addGeom(geometry)
    return node


def rows() -> list[Row]:
    """The median capture, against 2 s on 2 cores."""
    found = run()
    rival = found["rival_seconds"]
    return [
        Row(
            f"capture {WIDTH}x{HEIGHT}, {found['actors']} actors (worst {found['worst_s']} s; the rival has no "
            "shadows, textures or mask)",
            found["seconds"],
            f"under {_GOAL_S:.0f} s",
            found["seconds"] < _GOAL_S,
            rival=found["rival"] or "",
            theirs=rival,
            ratio=round(rival / found["seconds"], 2) if rival else None,
        )
    ]


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--actors", type=int, default=6700)
    parser.add_argument("--out", type=Path, default=None)
    options = parser.parse_args()
    print(json.dumps(run(options.actors, options.out), indent=1))
