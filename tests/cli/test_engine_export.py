"""``c4s engine export``: a level as a GLB that another program reads back to the same places and colours."""

from __future__ import annotations

import importlib
import json
import os
import struct
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
import trimesh
from PIL import Image

from c4s.engine.headless.process.boot import boot
from c4s.records.pack import Asset, Material, MaterialSlot, Pack
from tests.khronos import complaints

POST = "/Game/T/SM_Post"


@pytest.fixture
def home(tmp_path: Path) -> Path:
    """A home with one pack: a post off its pivot, of a textured shaft and a glowing cap."""
    folder = tmp_path / "packs" / "t"
    (folder / "meshes").mkdir(parents=True)
    (folder / "textures").mkdir()
    Image.new("RGB", (4, 4), (200, 100, 50)).save(folder / "textures" / "wood.png")
    parts = trimesh.Scene()
    for name, low, high in (("Shaft", (0, 0, 0), (0.4, 0.8, 0.2)), ("Cap", (0, 0.8, 0), (0.1, 1.0, 0.1))):
        box = trimesh.creation.box(bounds=(low, high))
        box.visual = trimesh.visual.TextureVisuals(
            uv=np.zeros((len(box.vertices), 2)), material=trimesh.visual.material.PBRMaterial(name=name)
        )
        parts.add_geometry(box, node_name=name)
    parts.export(folder / "meshes" / "post.glb")
    slots = [MaterialSlot(name=name, material=f"/Game/T/M_{name}.M_{name}") for name in ("Shaft", "Cap")]
    post = Asset(
        id="sm_post",
        name="Post",
        path=f"{POST}.SM_Post",
        category="props",
        mesh="meshes/post.glb",
        mesh_sha256="0" * 64,
        slots=slots,
        bounds_min_cm=(0, 0, 0),
        bounds_max_cm=(40, 20, 100),
    )
    Pack(
        pack_id="t",
        content_folder="T",
        title="T",
        license="CC0-1.0",
        assets=[post],
        materials=[
            Material(path=slots[0].material, base_color=(0.4, 0.2, 0.1), texture="textures/wood.png"),
            Material(path=slots[1].material, emissive=(4.0, 2.0, 1.0), opacity=0.5),
        ],
    ).write(folder / "pack.json")
    return tmp_path


@pytest.fixture
def scene(home: Path) -> tuple[Path, dict]:
    """A saved level with its snapshot: turned, mirrored, instanced, hidden, recoloured, and two of one label."""
    content = home / "submission"
    unreal = boot([home / "packs" / "t"], content)
    spawn = unreal.EditorLevelLibrary.spawn_actor_from_object
    post = unreal.load_asset(POST)
    for place, turn, scale in (((100, 200, 300), (10, 20, 30), (1, 1, 1)), ((-400, 0, 0), (0, -70, 5), (-1, 2, 0.5))):
        actor = spawn(post, unreal.Vector(*place), unreal.Rotator(*turn))
        actor.set_actor_scale3d(unreal.Vector(*scale))
        actor.set_actor_label("Post")
    cube = spawn(unreal.load_asset("/Engine/BasicShapes/Cube"), unreal.Vector(0, 0, 50))
    cube.set_actor_label("Red cube")
    tools, factory = unreal.AssetToolsHelpers.get_asset_tools(), unreal.MaterialFactoryNew()
    red = tools.create_asset("M_Red", "/Game/Made", unreal.Material, factory)
    colour = unreal.MaterialEditingLibrary.create_material_expression(red, unreal.MaterialExpressionConstant3Vector)
    colour.set_editor_property("constant", unreal.LinearColor(0.0123, 0.0, 0.0, 1.0))
    unreal.MaterialEditingLibrary.connect_material_property(colour, "", unreal.MaterialProperty.MP_BASE_COLOR)
    cube.static_mesh_component.set_material(0, red)
    unreal.EditorAssetLibrary.save_asset("/Game/Made/M_Red")
    copy = unreal.EditorAssetLibrary.duplicate_asset(POST, "/Game/Made/SM_Copy")
    unreal.EditorAssetLibrary.save_asset("/Game/Made/SM_Copy")
    spawn(copy, unreal.Vector(0, 900, 0)).set_actor_label("Copy")
    spawn(post, unreal.Vector(0, -900, 0)).set_actor_hidden_in_game(True)
    level = unreal.EditorLevelLibrary.get_editor_world()
    assert unreal.EditorLoadingAndSavingUtils.save_map(level, "/Game/SavedScenes/Yard")
    snapshot = importlib.import_module("c4s.editor.snapshot").export_snapshot()
    return content / "Game" / "SavedScenes" / "Yard.level.json", snapshot


def c4s(home: Path, *arguments: object) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-m", "c4s.cli", "engine", "export", *map(str, arguments)],
        text=True,
        env={**os.environ, "C4S_HOME": str(home)},
        capture_output=True,
        timeout=120,
        check=False,
    )


def tree_of(path: Path) -> dict:
    data = path.read_bytes()
    return json.loads(data[20 : 20 + struct.unpack_from("<I", data, 12)[0]])


def boxes_cm(path: Path) -> dict[str, list[tuple[np.ndarray, np.ndarray]]]:
    """World boxes of the nodes below the world node as another reader has them, in Unreal's axes and cm, by name."""
    scene, found = trimesh.load_scene(path), {}
    for node in scene.graph.nodes_geometry:
        matrix, name = scene.graph[node]
        corners = trimesh.bounds.corners(scene.geometry[name].bounds)
        world = trimesh.transform_points(corners, matrix)[:, [0, 2, 1]] * 100
        top = node
        while scene.graph.transforms.parents.get(top) not in (None, scene.graph.base_frame):
            top = scene.graph.transforms.parents[top]
        found.setdefault(top, []).append((world.min(axis=0), world.max(axis=0)))
    return found


def test_a_level_reads_back_to_the_bounds_of_its_snapshot(home, scene, tmp_path):
    level, snapshot = scene
    out = tmp_path / "yard.glb"
    done = c4s(home, level, "--glb", out, "--json")
    assert done.returncode == 0, done.stderr
    report = json.loads(done.stdout)
    assert report["actors"] == 4 and report["packs"] == ["t"] and report["unresolved"] == []

    tree = tree_of(out)
    names = [node["name"] for node in tree["nodes"]]
    assert names.count("Post") == 2 and names.count("Red cube") == 1 and names.count("Copy") == 1
    assert len(tree["meshes"]) == report["meshes"] == 2, "post and cube: one mesh each, however often shown"
    assert sorted(len(mesh["primitives"]) for mesh in tree["meshes"]) == [1, 2]

    shown = [a for a in snapshot["actors"] if a["bounds"]["extent_cm"] != [0, 0, 0]]
    read = [bounds for name, bounds in boxes_cm(out).items()]
    assert len(read) == 4
    for actor in shown:
        if actor["label"] not in ("Red cube", "Copy"):
            continue
        origin, extent = (np.array(actor["bounds"][key]) for key in ("origin_cm", "extent_cm"))
        assert any(
            np.allclose(np.min([low for low, _ in boxes], axis=0), origin - extent, atol=0.01)
            and np.allclose(np.max([high for _, high in boxes], axis=0), origin + extent, atol=0.01)
            for boxes in read
        ), actor["label"]


def test_turned_and_mirrored_meshes_lie_where_unreal_has_them(home, scene, tmp_path):
    level, snapshot = scene
    out = tmp_path / "yard.glb"
    assert c4s(home, level, "--glb", out, "--pack", "t").returncode == 0
    loaded = trimesh.load_scene(out)
    points = trimesh.util.concatenate(loaded.dump()).vertices[:, [0, 2, 1]] * 100
    corners = np.array([(x, y, z) for x in (0, 40) for y in (0, 20) for z in (0, 80)])
    for actor in snapshot["actors"]:
        if actor["label"] != "Post" or actor["transform"]["location_cm"] == [0, -900, 0]:
            continue
        transform = actor["transform"]
        pitch, yaw, roll = np.radians(transform["rotation_deg"])
        cp, sp, cy, sy, cr, sr = np.cos(pitch), np.sin(pitch), np.cos(yaw), np.sin(yaw), np.cos(roll), np.sin(roll)
        axes = np.array(
            [
                [cp * cy, cp * sy, sp],
                [sr * sp * cy - cr * sy, sr * sp * sy + cr * cy, -sr * cp],
                [-(cr * sp * cy + sr * sy), cy * sr - cr * sp * sy, cr * cp],
            ]
        )
        for corner in corners * transform["scale"]:
            expected = corner @ axes + transform["location_cm"]
            assert np.linalg.norm(points - expected, axis=1).min() < 0.01
    assert all(mesh.volume > 0 for mesh in loaded.dump()), "triangles face outwards, mirrored or not"


def test_colours_are_exact(home, scene, tmp_path):
    out = tmp_path / "yard.glb"
    assert c4s(home, scene[0], "--glb", out).returncode == 0
    materials = {m["name"]: m for m in tree_of(out)["materials"]}
    assert materials["M_Red"]["pbrMetallicRoughness"]["baseColorFactor"] == pytest.approx([0.0123, 0, 0, 1])
    assert "baseColorTexture" in materials["M_Shaft"]["pbrMetallicRoughness"]
    cap = materials["M_Cap"]
    assert cap["alphaMode"] == "BLEND" and cap["emissiveFactor"] == [1.0, 0.5, 0.25]
    assert cap["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"] == 4.0


def test_the_khronos_validator_finds_nothing(home, scene, tmp_path):
    out = tmp_path / "yard.glb"
    assert c4s(home, scene[0], "--glb", out).returncode == 0
    assert complaints(out) == []


def test_cut_outs_textures_and_colours_of_vertices_come_along(home, scene, tmp_path):
    folder = home / "packs" / "t"
    for name, mode in (("leaf", "RGBA"), ("bumps", "RGB"), ("shine", "RGB"), ("glow", "RGB")):
        Image.new(mode, (4, 4), (90, 200, 40, 0)[: len(mode)]).save(folder / "textures" / f"{name}.png")
    parts = trimesh.load_scene(folder / "meshes" / "post.glb")
    for part in parts.geometry.values():
        part.visual.vertex_attributes["color"] = np.tile(np.uint8([255, 128, 0, 255]), (len(part.vertices), 1))
    (folder / "meshes" / "post.glb").write_bytes(parts.export(file_type="glb"))
    pack = json.loads((folder / "pack.json").read_text())
    pack["materials"][0] |= {"alpha": "mask", "alpha_cutoff": 0.25, "emissive": [1, 1, 1]} | {
        f"{kind}": f"textures/{name}.png"
        for kind, name in (
            ("texture", "leaf"),
            ("normal_texture", "bumps"),
            ("roughness_metal_texture", "shine"),
            ("emissive_texture", "glow"),
        )
    }
    (folder / "pack.json").write_text(json.dumps(pack))
    out = tmp_path / "leaf.glb"
    assert c4s(home, scene[0], "--glb", out).returncode == 0
    tree = tree_of(out)
    leaf = next(m for m in tree["materials"] if m["name"] == "M_Shaft")
    assert leaf["alphaMode"] == "MASK" and leaf["alphaCutoff"] == 0.25
    assert {"normalTexture", "emissiveTexture"} <= set(leaf)
    assert {"baseColorTexture", "metallicRoughnessTexture"} <= set(leaf["pbrMetallicRoughness"])
    assert len(tree["images"]) == 4
    posts = [mesh for mesh in tree["meshes"] if mesh["name"] == "SM_Post"]
    assert posts and all("COLOR_0" in mesh["primitives"][0]["attributes"] for mesh in posts)


def test_bad_input_is_one_line(home, scene, tmp_path):
    broken = tmp_path / "broken.level.json"
    broken.write_text("{")
    for arguments, expected in (
        ((tmp_path / "none.json", "--glb", tmp_path / "a.glb"), "no such level document"),
        ((broken, "--glb", tmp_path / "a.glb"), "broken.level.json"),
        ((scene[0], "--glb", tmp_path / "a.glb", "--pack", "nope"), "unknown pack 'nope'"),
        ((scene[0], "--glb", tmp_path / "a.obj"), "must be a .glb file"),
    ):
        done = c4s(home, *arguments)
        assert done.returncode == 2 and expected in done.stderr and done.stderr.count("\n") == 1, done.stderr
    assert not (tmp_path / "a.glb").exists()
