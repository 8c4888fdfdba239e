"""What the rivals of ``bench.rival_pictures`` run: a scene is read once, then a picture is taken for each line.

A line names samples and a file; the file receives linear light, and the answer is ``TAKEN`` with processor seconds.
"""

from __future__ import annotations

MITSUBA = r"""
import json, os, sys, time
import numpy as np
import mitsuba as mi
folder, variant = sys.argv[sys.argv.index("--") + 1:]
mi.set_variant(variant)
told = json.load(open(os.path.join(folder, "scene.json")))
scene = {"type": "scene", "integrator": {"type": "direct", "emitter_samples": 2, "bsdf_samples": 0}}
scene["sky"] = {"type": "constant", "radiance": {"type": "rgb", "value": told["sky"]}}
if told["sun"]:
    scene["sun"] = {"type": "directional", "direction": told["sun_way"],
                    "irradiance": {"type": "rgb", "value": told["sun"]}}
for number, one in enumerate(told["materials"]):
    arrays = np.load(one["arrays"])
    rows = np.concatenate([arrays["points"], arrays["normals"], arrays["uvs"]], axis=1).astype("<f4")
    faces = np.empty(len(rows) // 3, dtype=[("n", "u1"), ("i", "<i4", 3)])
    faces["n"], faces["i"] = 3, np.arange(len(rows)).reshape(-1, 3)
    names = "".join(f"property float {name}\n" for name in "x y z nx ny nz u v".split())
    head = (f"ply\nformat binary_little_endian 1.0\nelement vertex {len(rows)}\n{names}"
            f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n")
    file = os.path.join(folder, f"{number}.ply")
    with open(file, "wb") as out:
        out.write(head.encode() + rows.tobytes() + faces.tobytes())
    color = {"type": "bitmap", "filename": one["texture"]} if one["texture"] else {"type": "rgb", "value": one["color"]}
    surface = {"type": "principled", "base_color": color, "roughness": one["roughness"], "metallic": one["metallic"]}
    shape = {"type": "ply", "filename": file, "bsdf": {"type": "twosided", "inner": surface}}
    scene[f"shape{number}"] = shape
eye, ahead = told["eye"], told["ahead"]
scene["sensor"] = {
    "type": "perspective", "fov": told["fov_deg"], "fov_axis": "x", "near_clip": 0.001, "far_clip": 10000.0,
    "to_world": mi.ScalarTransform4f().look_at(origin=eye, target=[a + b for a, b in zip(eye, ahead)], up=[0, 0, 1]),
    "film": {"type": "hdrfilm", "width": told["size"][0], "height": told["size"][1], "rfilter": {"type": "box"},
             "pixel_format": "rgb", "component_format": "float32"},
    "sampler": {"type": "independent"},
}
scene = mi.load_dict(scene)
seed = 0
def picture(samples):
    global seed
    total, left = 0.0, samples
    while left > 0:
        part = min(left, 16)
        seed += 1
        total = total + np.array(mi.render(scene, spp=part, seed=seed)) * part
        left -= part
    return total / samples
for line in sys.stdin:
    samples, file = line.split(maxsplit=1)
    if variant != "scalar_rgb":
        picture(min(int(samples), 16))
    before = time.process_time()
    found = picture(int(samples))
    spent = time.process_time() - before
    np.save(file.strip(), found.astype(np.float32))
    print("TAKEN", spent, flush=True)
"""

CYCLES = r"""
import json, math, os, sys, time
import bpy
import numpy as np
from mathutils import Vector
folder, variant = sys.argv[sys.argv.index("--") + 1:]
told = json.load(open(os.path.join(folder, "scene.json")))
bpy.ops.wm.read_factory_settings(use_empty=True)
scene = bpy.context.scene
for number, one in enumerate(told["materials"]):
    arrays = np.load(one["arrays"])
    points = arrays["points"]
    mesh = bpy.data.meshes.new(str(number))
    mesh.from_pydata(points.tolist(), [], np.arange(len(points)).reshape(-1, 3).tolist())
    uvs = arrays["uvs"].copy()
    uvs[:, 1] = 1.0 - uvs[:, 1]
    mesh.uv_layers.new().data.foreach_set("uv", uvs.ravel())
    mesh.normals_split_custom_set_from_vertices(arrays["normals"].tolist())
    if hasattr(mesh, "use_auto_smooth"):
        mesh.use_auto_smooth = True
    material = bpy.data.materials.new(str(number))
    material.use_nodes = True
    nodes = material.node_tree.nodes
    surface = nodes.get("Principled BSDF")
    surface.inputs["Base Color"].default_value = (*one["color"], 1.0)
    surface.inputs["Roughness"].default_value = one["roughness"]
    surface.inputs["Metallic"].default_value = one["metallic"]
    if one["texture"]:
        image = nodes.new("ShaderNodeTexImage")
        image.image = bpy.data.images.load(one["texture"])
        material.node_tree.links.new(image.outputs["Color"], surface.inputs["Base Color"])
    mesh.materials.append(material)
    scene.collection.objects.link(bpy.data.objects.new(str(number), mesh))
if told["sun"]:
    lamp = bpy.data.lights.new("sun", "SUN")
    lamp.energy, lamp.color, lamp.angle = 1.0, told["sun"], math.radians(told["sun_deg"])
    sun = bpy.data.objects.new("sun", lamp)
    sun.rotation_euler = Vector(told["sun_way"]).to_track_quat("-Z", "Y").to_euler()
    scene.collection.objects.link(sun)
sky = bpy.data.worlds.new("sky")
scene.world, sky.use_nodes = sky, True
sky.node_tree.nodes["Background"].inputs[0].default_value = (*told["sky"], 1.0)
lens = bpy.data.cameras.new("eye")
lens.angle, lens.clip_start, lens.clip_end = math.radians(told["fov_deg"]), 0.001, 10000.0
camera = bpy.data.objects.new("eye", lens)
camera.location = told["eye"]
camera.rotation_euler = Vector(told["ahead"]).to_track_quat("-Z", "Y").to_euler()
scene.collection.objects.link(camera)
scene.camera = camera
scene.render.engine = "CYCLES"
cycles = scene.cycles
cycles.device, cycles.use_adaptive_sampling, cycles.max_bounces = "CPU", False, 0
cycles.use_denoising = variant == "denoised"
if cycles.use_denoising:
    cycles.denoiser = "OPENIMAGEDENOISE"
cycles.pixel_filter_type = "BOX"
scene.render.use_persistent_data = True
scene.render.resolution_x, scene.render.resolution_y = told["size"]
scene.render.image_settings.file_format = "OPEN_EXR"
scene.render.image_settings.color_depth = "32"
for line in sys.stdin:
    samples, file = line.split(maxsplit=1)
    file = file.strip()
    scene.render.filepath = file + ".exr"
    cycles.samples = 1
    bpy.ops.render.render()
    cycles.samples, cycles.seed = int(samples), cycles.seed + 1
    before = time.process_time()
    bpy.ops.render.render()
    spent = time.process_time() - before
    bpy.data.images["Render Result"].save_render(file + ".exr")
    image = bpy.data.images.load(file + ".exr")
    image.colorspace_settings.name = "Non-Color"
    values = np.empty(image.size[0] * image.size[1] * 4, dtype=np.float32)
    image.pixels.foreach_get(values)
    np.save(file, values.reshape(image.size[1], image.size[0], 4)[::-1, :, :3])
    bpy.data.images.remove(image)
    print("TAKEN", spent, flush=True)
"""
