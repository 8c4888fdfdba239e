"""How Blender opens what ``c4s engine export`` writes: names, places, materials, light, and a picture beside ours.

``python -m bench.blender_view LEVEL --out FOLDER [--blender PROGRAM] [--view X,Y,Z,PITCH,YAW,FOV]``

PROGRAM is Blender itself, or a Python with the package ``bpy``. Without it and without ``blender`` on the search path
the script says so and ends with 0. It writes ``blender.png`` (Cycles) and ``ours.png`` of the same camera, and prints
what differs: world boxes of all meshes, names, the sun's strength in W/m2. Exit 1 where a box is off by more than
0.1 mm, a name is missing, or the sun is not of the level's strength.
"""

from __future__ import annotations

import argparse
import json
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

import numpy as np

from c4s.cli.levels import packs_of
from c4s.engine import backend
from c4s.engine.headless.process.boot import boot
from c4s.engine.headless.world.state import world
from c4s.records.level import Level

MOST_MM = 0.1
SUN_RATIO = 0.01

INSIDE = r"""
import bpy, json, math, sys
from mathutils import Matrix, Vector
glb, out, view = sys.argv[sys.argv.index("--") + 1:]
view = json.loads(view)
bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.ops.import_scene.gltf(filepath=glb)
bpy.context.view_layer.update()
boxes = {}
for one in bpy.data.objects:
    if one.type == "MESH":
        points = [one.matrix_world @ vertex.co for vertex in one.data.vertices]
        boxes.setdefault(one.name.rsplit(".", 1)[0] if one.name[-4:-3] == "." else one.name, []).append(
            [[min(p[i] for p in points) for i in range(3)], [max(p[i] for p in points) for i in range(3)]])
shining = [one for one in bpy.data.objects if one.type == "LIGHT"]
lights = [{"name": one.name, "type": one.data.type, "energy": one.data.energy} for one in shining]
parents = {one.name: one.parent.name for one in bpy.data.objects if one.parent}
materials = {}
for one in bpy.data.materials:
    node = one.node_tree and one.node_tree.nodes.get("Principled BSDF")
    if node:
        names = ("Base Color", "Alpha", "Roughness", "Metallic", "Emission Strength")
        values = {name: node.inputs[name].default_value for name in names if not node.inputs[name].is_linked}
        materials[one.name] = {name: list(v) if hasattr(v, "__len__") else v for name, v in values.items()}
        materials[one.name]["textured"] = node.inputs["Base Color"].is_linked
x, y, z, pitch, yaw, fov, width, height = view
lens = bpy.data.cameras.new("c4s view")
lens.angle = math.radians(fov)
camera = bpy.data.objects.new("c4s view", lens)
bpy.context.scene.collection.objects.link(camera)
p, w = math.radians(pitch), math.radians(yaw)
ahead = Vector((math.cos(p) * math.cos(w), -math.cos(p) * math.sin(w), math.sin(p)))
camera.location = Vector((x / 100, -y / 100, z / 100))
camera.rotation_euler = ahead.to_track_quat("-Z", "Y").to_euler()
scene = bpy.context.scene
scene.camera = camera
scene.render.engine = "CYCLES"
scene.cycles.device, scene.cycles.samples, scene.cycles.use_denoising = "CPU", 16, False
scene.render.resolution_x, scene.render.resolution_y = int(width), int(height)
sky = bpy.data.worlds.new("sky"); scene.world = sky; sky.use_nodes = True
sky.node_tree.nodes["Background"].inputs[0].default_value = (0.55, 0.7, 1.0, 1.0)
sky.node_tree.nodes["Background"].inputs[1].default_value = 0.35
scene.view_settings.view_transform = "Standard"
scene.render.filepath = out
bpy.ops.render.render(write_still=True)
found = {"boxes": boxes, "lights": lights, "parents": len(parents), "materials": materials}
print("FOUND" + json.dumps({**found, "objects": len(bpy.data.objects)}))
"""


def blender_words(program: str, script: Path) -> list[str]:
    """How a script is started: in Blender, or in a Python with ``bpy``."""
    return [program, str(script), "--"] if "python" in Path(program).name else [program, "-b", "-P", str(script), "--"]


def in_blender(program: str, glb: Path, picture: Path, view: list[float]) -> dict[str, Any]:
    """What Blender says of a GLB, and its picture."""
    with tempfile.TemporaryDirectory() as folder:
        script = Path(folder) / "inside.py"
        script.write_text(INSIDE)
        words = [*blender_words(program, script), str(glb), str(picture), json.dumps(view)]
        done = subprocess.run(words, capture_output=True, text=True, check=False)
    told = [line for line in done.stdout.splitlines() if line.startswith("FOUND")]
    if not told:
        raise SystemExit(f"blender failed:\n{done.stdout[-1500:]}{done.stderr[-3000:]}")
    found: dict[str, Any] = json.loads(told[-1].removeprefix("FOUND"))
    return found


def own_boxes(level: Path, packs: list[Path], picture: Path, view: list[float]) -> dict[str, Any]:
    """The world box of every mesh that the level shows, in Blender's axes and metres, its sun, and our picture."""
    from c4s.engine.headless.pictures.take import take

    with tempfile.TemporaryDirectory() as folder:
        boot(packs, Path(folder), levels=[level], start_map=Level.read(level).package)
        boxes = []
        for one in world().drawables():
            mesh = world().store.mesh(one.mesh)
            points = np.c_[mesh.vertices[np.unique(mesh.faces)].astype(float), np.ones(len(np.unique(mesh.faces)))]
            placed = (points @ one.matrix.T)[:, :3] * [0.01, -0.01, 0.01]
            boxes.append([placed.min(axis=0).tolist(), placed.max(axis=0).tolist()])
        sources = list(world().light_sources())
        suns = [float(s.properties["intensity"]) for s in sources if s.kind == "DirectionalLightComponent"]
        labels = {one.actor.get_actor_label() for one in world().drawables()}
        x, y, z, pitch, yaw, fov, width, height = view
        camera = {
            "name": "view",
            "location_cm": [x, y, z],
            "rotation_deg": [pitch, yaw, 0.0],
            "fov_deg": fov,
            "width": int(width),
            "height": int(height),
        }
        take([camera], [str(picture)], "lit", False)
    return {"boxes": boxes, "suns": suns, "labels": sorted(labels)}


def main() -> int:
    """Compare; 0 when all agrees or there is no Blender."""
    parser = argparse.ArgumentParser(prog="python -m bench.blender_view", description=__doc__)
    parser.add_argument("level", type=Path)
    parser.add_argument("--out", type=Path, required=True)
    parser.add_argument("--blender", default=shutil.which("blender"))
    parser.add_argument("--view", default="-1200,-1200,700,-20,45,60", help="X,Y,Z cm, PITCH, YAW, FOV degrees")
    given = parser.parse_args()
    if given.blender is None:
        print("skipped: no blender on the search path, and none given with --blender")
        return 0
    given.out.mkdir(parents=True, exist_ok=True)
    view = [*map(float, given.view.split(",")), 640.0, 360.0]
    engine = backend("headless")
    packs = packs_of(engine.asset_paths(given.level))
    glb = given.out / "level.glb"
    engine.export_glb(given.level, packs, glb)
    ours = own_boxes(given.level, packs, given.out / "ours.png", view)
    theirs = in_blender(given.blender, glb, given.out / "blender.png", view)
    return report(ours, theirs)


def report(ours: dict[str, Any], theirs: dict[str, Any]) -> int:
    """Print what differs; 1 where something is beyond its limit."""
    mine = np.array(ours["boxes"]).reshape(-1, 6)
    read = np.array([box for boxes in theirs["boxes"].values() for box in boxes]).reshape(-1, 6)
    away = np.abs(mine[:, None] - read[None]).max(axis=2).min(axis=1).max() * 1000
    names = set(theirs["boxes"])
    missing = [label for label in ours["labels"] if label not in names]
    suns = [light["energy"] for light in theirs["lights"] if light["type"] == "SUN"]
    told = max((abs(a / b - 1) for a, b in zip(sorted(suns), sorted(ours["suns"]), strict=True) if b), default=0.0)
    print(f"meshes: {len(mine)} ours, {len(read)} in Blender, farthest box {away:.4f} mm")
    print(f"objects {theirs['objects']}, with a parent {theirs['parents']}, labels not a mesh's name: {len(missing)}")
    print(f"suns: ours {ours['suns']} (lux as the level has them), Blender's {[round(s, 3) for s in suns]} W/m2")
    print(f"lights: {[(o['type'], round(o['energy'], 2)) for o in theirs['lights']][:6]}")
    textured = sum(material["textured"] for material in theirs["materials"].values())
    print(f"materials {len(theirs['materials'])}, with a texture {textured}")
    return int(away > MOST_MM or len(mine) != len(read) or told > SUN_RATIO)


if __name__ == "__main__":
    sys.exit(main())
