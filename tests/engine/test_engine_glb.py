"""Levels as GLB: instances as nodes below their actor, lights and cameras, and levels with nothing to show."""

from __future__ import annotations

import json
import math
import struct
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest
import trimesh
from scipy.spatial.transform import Rotation

from c4s.engine.headless.glb.level import write_glb
from c4s.engine.headless.glb.walkable import ASTRAY, LARGEST, REACHED, walkable_layers
from c4s.engine.headless.pictures.lights import candela_of, kelvin_rgb, lights_of
from c4s.engine.headless.process.boot import boot
from c4s.engine.headless.world.state import world
from c4s.errors import BadInput
from tests.khronos import complaints


def spawn_row(unreal: ModuleType) -> None:
    """An actor with a cube and a mirrored long one, as instances."""
    row = unreal.EditorLevelLibrary.spawn_actor_from_class(unreal.Actor, unreal.Vector())
    subsystem = unreal.get_engine_subsystem(unreal.SubobjectDataSubsystem)
    parent = subsystem.k2_gather_subobject_data_for_instance(row)[0]
    kind = unreal.InstancedStaticMeshComponent.static_class()
    subsystem.add_new_subobject(unreal.AddNewSubobjectParams(parent, kind))
    component = row.get_component_by_class(unreal.InstancedStaticMeshComponent)
    component.set_static_mesh(unreal.load_asset("/Engine/BasicShapes/Cube"))
    for x, scale in ((0, 1), (500, -2)):
        component.add_instance(unreal.Transform(unreal.Vector(x, 0, 0), unreal.Rotator(), unreal.Vector(scale, 1, 1)))


def test_instances_share_one_mesh_below_their_actor(tmp_path: Path):
    unreal = boot([], tmp_path / "content")
    spawn_row(unreal)
    report = write_glb(world(), tmp_path / "row.glb")
    assert (report["actors"], report["meshes"], report["nodes"]) == (1, 1, 3)
    loaded = trimesh.load_scene(tmp_path / "row.glb")
    assert np.allclose(loaded.bounds * 100, [[-50, -50, -50], [600, 50, 50]], atol=0.01)
    assert all(mesh.volume > 0 for mesh in loaded.dump())


def test_an_empty_level_is_refused(tmp_path: Path):
    boot([], tmp_path / "content")
    with pytest.raises(BadInput, match="shows no mesh"):
        write_glb(world(), tmp_path / "none.glb")
    assert not (tmp_path / "none.glb").exists()


def lit_level(folder: Path) -> tuple[dict, dict]:
    """The GLB's JSON of a level with cubes, every kind of light and a camera, and what the writer told."""
    unreal = boot([], folder / "content")
    library = unreal.EditorLevelLibrary
    spawn_row(unreal)
    library.spawn_actor_from_object(unreal.load_asset("/Engine/BasicShapes/Cube"), unreal.Vector())

    def spawn(kind: str, place=(0, 0, 0), **turn: float):
        actor = library.spawn_actor_from_class(getattr(unreal, kind), unreal.Vector(*place), unreal.Rotator(**turn))
        actor.set_actor_label(kind)
        return actor

    sun = spawn("DirectionalLight", pitch=-30, yaw=40).get_component_by_class(unreal.DirectionalLightComponent)
    sun.set_editor_properties({"intensity": 8.0, "use_temperature": True, "temperature": 3000.0})
    lamp = spawn("PointLight", (100, 200, 300)).point_light_component
    lamp.set_editor_properties(
        {
            "intensity": 800.0,
            "intensity_units": unreal.LightUnits.LUMENS,
            "light_color": unreal.Color(r=255, g=188, b=0),
            "attenuation_radius": 450.0,
        }
    )
    spot = spawn("SpotLight", pitch=90).spot_light_component
    spot.set_editor_properties(
        {
            "intensity": 50.0,
            "intensity_units": unreal.LightUnits.CANDELAS,
            "inner_cone_angle": 60.0,
            "outer_cone_angle": 44.0,
        }
    )
    spawn("RectLight", yaw=90).rect_light_component.set_editor_property("intensity", 625.0)
    spawn("SkyLight")
    spawn("PointLight").set_is_temporarily_hidden_in_editor(True)
    spawn("CameraActor", (-500, 0, 0), yaw=180, roll=20).camera_component.set_editor_property("field_of_view", 90.0)
    told = write_glb(world(), folder / "lit.glb")
    return tree_of(folder / "lit.glb"), told


def tree_of(file: Path) -> dict:
    """The JSON of a GLB."""
    data = file.read_bytes()
    return json.loads(data[20 : 20 + struct.unpack_from("<I", data, 12)[0]])


def forward(node: dict, local=(0.0, 0.0, -1.0)) -> list[float]:
    """Where a node's -Z (or another local direction) points, in Unreal's axes."""
    x, y, z, w = node["rotation"]
    turned = Rotation.from_quat([x, y, z, w]).apply(local)
    return [turned[0], turned[2], turned[1]]


def test_lights_and_cameras_come_along_with_their_units_and_directions(tmp_path: Path):
    tree, told = lit_level(tmp_path)
    assert (told["lights"], told["cameras"], told["left_out"]) == (4, 1, ["SkyLight"])
    lights = {each["name"]: each for each in tree["extensions"]["KHR_lights_punctual"]["lights"]}
    nodes = {node["name"]: node for node in tree["nodes"]}
    below = set(tree["scenes"][0]["nodes"])
    assert all(tree["nodes"].index(nodes[name]) in below for name in (*lights, "CameraActor"))

    sun = lights["DirectionalLight"]
    assert sun["type"] == "directional" and "range" not in sun and max(sun["color"]) == 1 and sun["color"][2] < 0.3
    assert forward(nodes["DirectionalLight"]) == pytest.approx(
        [
            math.cos(math.radians(30)) * math.cos(math.radians(40)),
            math.cos(math.radians(30)) * math.sin(math.radians(40)),
            -0.5,
        ]
    )
    lamp = lights["PointLight"]
    assert told["light_factor"] == tree["asset"]["extras"]["light_factor"] == 683
    assert sun["intensity"] == pytest.approx(683 * 8.0 * max(kelvin_rgb(3000.0)))
    assert lamp["intensity"] == pytest.approx(683 * 800 / (4 * math.pi)) and lamp["range"] == 4.5
    assert lamp["color"] == pytest.approx([1.0, 0.5029, 0.0], abs=1e-3)
    assert nodes["PointLight"]["translation"] == [1.0, 3.0, 2.0]
    spot = lights["SpotLight"]
    assert spot["intensity"] == 683 * 50 and spot["spot"]["outerConeAngle"] == pytest.approx(math.radians(44))
    assert spot["spot"]["innerConeAngle"] < spot["spot"]["outerConeAngle"], "glTF wants it so"
    assert forward(nodes["SpotLight"]) == pytest.approx([0, 0, 1], abs=1e-9)
    assert lights["RectLight"]["intensity"] == 683 and lights["RectLight"]["spot"]["outerConeAngle"] == math.pi / 2
    assert forward(nodes["RectLight"]) == pytest.approx([0, 1, 0], abs=1e-9)

    camera = tree["cameras"][nodes["CameraActor"]["camera"]]["perspective"]
    assert camera["yfov"] == pytest.approx(2 * math.atan(9 / 16)) and camera["aspectRatio"] == pytest.approx(16 / 9)
    assert forward(nodes["CameraActor"]) == pytest.approx([-1, 0, 0], abs=1e-9)
    up = (-math.sin(math.radians(20)), math.cos(math.radians(20)))
    assert forward(nodes["CameraActor"], (0, 1, 0)) == pytest.approx([0, up[0], up[1]], abs=1e-9)


def test_nits_count_by_the_area_that_shines(tmp_path: Path):
    unreal = boot([], tmp_path / "content")
    light = unreal.EditorLevelLibrary.spawn_actor_from_class(unreal.RectLight, unreal.Vector()).rect_light_component
    light.set_editor_properties(
        {"intensity": 200.0, "intensity_units": unreal.LightUnits.NITS, "source_width": 100.0, "source_height": 50.0}
    )
    (source,) = world().light_sources()
    assert candela_of(source) == pytest.approx(100.0)
    assert lights_of([source]).local[0].intensity_cd == pytest.approx(100.0)


def test_the_khronos_validator_accepts_lights_cameras_and_instances(tmp_path: Path):
    lit_level(tmp_path)
    assert complaints(tmp_path / "lit.glb") == []


def test_a_sun_in_real_lux_is_written_as_it_is(tmp_path: Path):
    unreal = boot([], tmp_path / "content")
    spawn_row(unreal)
    sun = unreal.EditorLevelLibrary.spawn_actor_from_class(unreal.DirectionalLight, unreal.Vector())
    sun.get_component_by_class(unreal.DirectionalLightComponent).set_editor_property("intensity", 75_000.0)
    assert write_glb(world(), tmp_path / "noon.glb")["light_factor"] == 1
    (light,) = tree_of(tmp_path / "noon.glb")["extensions"]["KHR_lights_punctual"]["lights"]
    assert light["intensity"] == 75_000.0


def test_how_a_body_can_walk_is_layers_of_their_own(tmp_path: Path):
    unreal = boot([], tmp_path / "content")
    cube = unreal.load_asset("/Engine/BasicShapes/Cube")
    spawn = unreal.EditorLevelLibrary.spawn_actor_from_object
    plate = spawn(cube, unreal.Vector(0, 0, -50))
    plate.set_actor_scale3d(unreal.Vector(30, 30, 1))
    plate.set_actor_label("Floor")
    for number in range(18):
        crate = spawn(cube, unreal.Vector(-1200 + 480 * (number % 6), -900 + 800 * (number // 6), 30))
        crate.set_actor_scale3d(unreal.Vector(0.6, 0.6, 0.6))
        crate.set_actor_label(f"Crate {number}")
    shut_in = spawn(cube, unreal.Vector(1300, 1300, 30))
    shut_in.set_actor_scale3d(unreal.Vector(0.4, 0.4, 0.6))
    for x, y, wide, deep in (
        (1300, 1180, 2.6, 0.2),
        (1300, 1420, 2.6, 0.2),
        (1180, 1300, 0.2, 2.6),
        (1420, 1300, 0.2, 2.6),
    ):
        wall = spawn(cube, unreal.Vector(x, y, 150))
        wall.set_actor_label("Wall")
        wall.set_actor_scale3d(unreal.Vector(wide, deep, 3))
    layers = {layer.name: layer for layer in walkable_layers()}
    report = write_glb(world(), tmp_path / "walk.glb", list(layers.values()))
    assert report["actors"] == 24, "layers are not counted"
    routes = [name for name in layers if name.startswith("Route ")]
    assert [*layers] == [LARGEST, REACHED, ASTRAY, *routes] and len(routes) == 3
    assert all(name.endswith(": arrived") for name in routes) and sum(" to Crate " in name for name in routes) >= 2
    assert len(layers[ASTRAY].faces) == 8, "a frame of four strips: what is shut in, and no wall"
    nodes = {node["name"] for node in tree_of(tmp_path / "walk.glb")["nodes"]}
    assert layers.keys() <= nodes
    area = layers[LARGEST].points
    assert 0 < area[:, 1].min() == area[:, 1].max() < 0.05, "on the plate's top"
    assert np.all(np.abs(area[:, [0, 2]]) < 15)
    for layer in layers.values():
        corners = layer.points[layer.faces]
        assert np.all(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])[:, 1] > 0), "looks up"
    ribbon = layers[routes[0]].points
    assert np.linalg.norm(ribbon[0] - ribbon[3]) == pytest.approx(0.12, abs=1e-6)
