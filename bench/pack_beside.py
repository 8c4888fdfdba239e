"""``python -m bench.pack_beside FOLDER --out SHEET.png [--only WORD ...] [--count N] [--scale F]``.

Builds a pack of each of some mesh files of a folder, and lays its preview beside Blender's picture (Cycles) of the same
file, read by Blender's own importer, from the same direction: what comes in, beside an independent reader and renderer.
Files are taken at even steps of their names, or those whose path holds a word. Each frames its model itself. Without
``blender`` on the search path the script says so and ends with 0.

The sheet has pairs: ours on the left, Blender's on the right. Printed is a line a file: the size (m) in our pack, and
by how much Blender's differs at most. Exit 1 where that is more than a hundredth of the largest side.
"""

from __future__ import annotations

import argparse
import json
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path

from PIL import Image, ImageDraw

from c4s.records.pack import MANIFEST, Asset, Pack
from catalog.ingest.folder import ingest
from catalog.ingest.listing import listing
from catalog.preview import SIZE

COLUMNS = 3
NEAR = 0.01
INSIDE = r"""
import bpy, json, math, sys
from mathutils import Vector
(file, picture, scale), size = json.loads(sys.argv[-2]), int(sys.argv[-1])
bpy.ops.wm.read_factory_settings(use_empty=True)
if file.lower().endswith(".obj"):
    bpy.ops.wm.obj_import(filepath=file)
elif file.lower().endswith((".glb", ".gltf")):
    bpy.ops.import_scene.gltf(filepath=file)
else:
    bpy.ops.wm.collada_import(filepath=file)
bpy.context.view_layer.update()
shown = [one for one in bpy.data.objects if one.type == "MESH"]
points = [one.matrix_world @ Vector(corner) for one in shown for corner in one.bound_box]
low = Vector([min(p[i] for p in points) for i in range(3)])
high = Vector([max(p[i] for p in points) for i in range(3)])
told = [(high[i] - low[i]) * scale for i in range(3)]
reach, middle = (high - low).length, (low + high) / 2
bpy.ops.mesh.primitive_plane_add(size=40 * reach, location=(middle.x, middle.y, low.z - 0.001 * reach))
ground = bpy.context.object
grey = bpy.data.materials.new("ground")
grey.use_nodes = True
grey.node_tree.nodes["Principled BSDF"].inputs["Base Color"].default_value = (0.36, 0.37, 0.39, 1)
ground.data.materials.append(grey)
world = bpy.data.worlds.new("sky")
bpy.context.scene.world = world
world.use_nodes = True
world.node_tree.nodes["Background"].inputs[0].default_value = (0.26, 0.26, 0.27, 1)
sun = bpy.data.lights.new("sun", "SUN")
sun.energy, sun.angle = 2.0, math.radians(6)
lamp = bpy.data.objects.new("sun", sun)
lamp.rotation_euler = Vector((0.25, 0.75, -0.8)).to_track_quat("-Z", "Y").to_euler()
bpy.context.collection.objects.link(lamp)
lens = bpy.data.cameras.new("view")
lens.angle, lens.clip_start, lens.clip_end = math.radians(30), 0.001 * reach, 100 * reach
camera = bpy.data.objects.new("view", lens)
towards = Vector((0.62, -0.78, 0.52)).normalized()
camera.location = middle + towards * reach * 2.2
camera.rotation_euler = (-towards).to_track_quat("-Z", "Y").to_euler()
bpy.context.collection.objects.link(camera)
scene = bpy.context.scene
scene.camera = camera
for one in bpy.data.objects:
    one.select_set(one in shown)
bpy.context.view_layer.update()
bpy.ops.view3d.camera_to_view_selected()
scene.render.engine, scene.cycles.device, scene.cycles.samples = "CYCLES", "CPU", 24
scene.cycles.use_denoising = False
scene.render.threads_mode, scene.render.threads = "FIXED", 2
scene.render.resolution_x = scene.render.resolution_y = size
scene.view_settings.view_transform = "Standard"
scene.render.filepath = picture
bpy.ops.render.render(write_still=True)
print("TOLD " + json.dumps(told))
"""


def drawn(file: Path, picture: Path, scale: float) -> list[float] | None:
    """Let Blender draw a file; its size (m) as Blender reads it, None where Blender ends without a picture."""
    script = picture.with_suffix(".py")
    script.write_text(INSIDE)
    call = ["blender", "--background", "--factory-startup", "--python", str(script), "--"]
    done = subprocess.run(
        [*call, json.dumps([str(file), str(picture), scale]), str(SIZE)], capture_output=True, text=True, check=False
    )
    line = next((line for line in done.stdout.splitlines() if line.startswith("TOLD ")), None)
    if line is None:
        Image.new("RGB", (SIZE, SIZE), "white").save(picture)
        return None
    told: list[float] = json.loads(line.removeprefix("TOLD "))
    return told


def chosen(files: Sequence[Path], only: Sequence[str], count: int) -> list[Path]:
    """Files whose path holds one of the words, else all; of those ``count`` at even steps."""
    fitting = [one for one in files if not only or any(word in one.as_posix() for word in only)]
    return [fitting[number * len(fitting) // count] for number in range(count)] if len(fitting) > count else fitting


def built(file: Path, files: Sequence[Path], folder: Path, scratch: Path, scale: float) -> tuple[Asset, Path]:
    """The asset that a file alone becomes, and its preview; textures and libraries beside it come along."""
    others = {one.name for one in files if one != file and one.parent == file.parent}
    source = scratch / "source" / file.parent.relative_to(folder)
    shutil.copytree(file.parent, source, ignore=lambda _, names: others & set(names), dirs_exist_ok=True)
    (scratch / "licence.txt").write_text("CC0-1.0")
    ingest(scratch / "source", "pack", scratch, scale=scale, hulls="none", license_file=scratch / "licence.txt")
    (asset,) = Pack.read(scratch / "pack" / MANIFEST).assets
    assert asset.preview is not None
    return asset, scratch / "pack" / asset.preview


def sheet(rows: Sequence[tuple[str, Path, Path]], out: Path) -> None:
    """Lay pairs of pictures out with their captions."""
    high, wide = -(-len(rows) // COLUMNS), 2 * SIZE + 12
    laid = Image.new("RGB", (COLUMNS * wide, high * (SIZE + 20)), "white")
    pen = ImageDraw.Draw(laid)
    for number, (caption, ours, theirs) in enumerate(rows):
        x, y = number % COLUMNS * wide, number // COLUMNS * (SIZE + 20)
        laid.paste(Image.open(ours).convert("RGB"), (x, y))
        laid.paste(Image.open(theirs).convert("RGB"), (x + SIZE, y))
        pen.text((x + 4, y + SIZE + 3), caption, fill="black")
    laid.save(out)


def main() -> int:
    """Build, draw, lay out."""
    parser = argparse.ArgumentParser(prog="python -m bench.pack_beside", description=__doc__)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--out", type=Path, required=True)
    parser.add_argument("--only", nargs="*", default=[])
    parser.add_argument("--count", type=int, default=12)
    parser.add_argument("--scale", type=float, default=1.0, help="metres per unit of the files")
    given = parser.parse_args()
    if shutil.which("blender") is None:
        print("blender is not on the search path: nothing to lay beside")
        return 0
    found = listing(given.folder).files
    files = chosen(found, given.only, given.count)
    off = 0
    with tempfile.TemporaryDirectory() as place:
        rows = []
        for number, file in enumerate(files):
            asset, preview = built(file, found, given.folder, Path(place, f"own-{number}"), given.scale)
            picture = Path(place, f"{number}.png")
            theirs = drawn(file, picture, given.scale)
            apart = max(abs(a - b) for a, b in zip(asset.size_m, theirs or asset.size_m, strict=True))
            wrong = apart > NEAR * max(asset.size_m)
            told = "Blender ends without a picture" if theirs is None else f"{1000 * apart:.1f} mm"
            off += wrong
            size = " x ".join(f"{side:.3f}" for side in asset.size_m)
            print(f"{file.relative_to(given.folder)}: {size} m, {told}{' DIFFERS' if wrong else ''}", flush=True)
            rows.append((f"{asset.id} {size} m", preview, picture))
        sheet(rows, given.out)
    return int(off > 0)


if __name__ == "__main__":
    sys.exit(main())
