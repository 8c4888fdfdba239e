"""Scenes made elsewhere come in actor by actor: SDF worlds, node trees and placement tables."""

from __future__ import annotations

import csv
import json
import math
from pathlib import Path

import numpy as np
import pytest
import trimesh

from c4s.cli.boundary import run as boundary
from c4s.cli.main import app
from c4s.errors import BadInput
from c4s.evidence import export_level
from c4s.geometry.transform import affine
from c4s.packs.store import PackStore
from c4s.records.level import Level
from cases.corruption import id_of
from cases.importers.imported import place
from cases.importers.importing import import_scene
from tests.shared import SHARED

SCENES = SHARED / "assets/scenes"
here = pytest.mark.skipif(not SCENES.is_dir(), reason="the shared sample scenes are not here")

WORLD = """
<?xml version="1.0"?>
<sdf version="1.6"><world name="default">
  <light name="lamp" type="point"><pose>0 0 3 0 0 0</pose><diffuse>1 0.5 0.5 1</diffuse></light>
  <model name="crate_1"><pose>1 2 0 0 0 1.5707963</pose><link name="l"><pose>0 0 0.5 0 0 0</pose>
    <visual name="v"><geometry><box><size>2 1 1</size></box></geometry>
      <material><diffuse>1 0 0 1</diffuse></material></visual>
    <collision name="c"><geometry><box><size>2 1 1</size></box></geometry></collision></link></model>
  <model name="crate_2"><pose>3 0 0 0 0 0</pose><link name="l"><pose>0 0 0.5 0 0 0</pose>
    <visual name="v"><geometry><box><size>2 1 1</size></box></geometry>
      <material><diffuse>1 0 0 1</diffuse></material></visual>
    <collision name="c"><geometry><box><size>2 1 1</size></box></geometry></collision></link></model>
  <model name="room"><pose>10 0 0 0 0 3.1415926</pose>
    <include><name>chair_-1</name><uri>model://chair</uri><pose>1 1 0 0 0 0</pose></include>
    <include><name>chair_1</name><uri>model://chair</uri><pose>-1 1 0 0 0 0</pose></include>
    <include><name>ghost</name><uri>model://ghost</uri></include>
    <link name="wall"><visual name="v"><geometry><plane><size>4 4</size></plane></geometry></visual></link>
    <link name="torn"><visual name="v"><geometry><mesh><uri>model://chair/torn.obj</uri></mesh></geometry></visual></link>
  </model>
  <model name="bad_pose"><pose>1 2 x 0 0 0</pose><link name="l"/></model>
</world></sdf>
"""
CHAIR = """<sdf version="1.6"><model name="chair"><link name="l"><visual name="v"><geometry><mesh>
<uri>model://chair/chair.obj</uri><scale>0.01 0.01 0.01</scale></mesh></geometry></visual></link></model></sdf>"""


@pytest.fixture
def world(tmp_path: Path) -> Path:
    chair = tmp_path / "scene" / "models" / "chair"
    chair.mkdir(parents=True)
    (chair / "model.sdf").write_text(CHAIR)
    box = trimesh.creation.box(extents=(50, 40, 90))
    (chair / "chair.obj").write_text(trimesh.exchange.obj.export_obj(box))
    (chair / "torn.obj").write_text("v 0 0 0\n")
    path = tmp_path / "scene" / "worlds" / "test.world"
    path.parent.mkdir()
    path.write_text(WORLD)
    return path


def test_an_sdf_world_comes_in_actor_by_actor(world: Path, tmp_path: Path) -> None:
    report = import_scene(world, "tiny", suites=tmp_path / "suites", packs=tmp_path / "packs")
    level = Level.read(Path(report["level"]))
    actors = {actor.name: actor for actor in level.actors}
    assert set(actors) == {
        "crate_1",
        "crate_2",
        "room_chair_minus1",
        "room_chair_1",
        "room_wall",
        "Light_lamp",
        "Light_Sun",
        "Light_Sky",
    }
    assert actors["crate_1"].transform.location_cm == pytest.approx((100, -200, 0), abs=0.01)
    assert actors["crate_1"].transform.rotation_deg == pytest.approx((0, -90, 0), abs=0.01)
    assert actors["room_chair_minus1"].transform.location_cm == pytest.approx((900, 100, 0), abs=0.01)
    assert actors["room_chair_1"].folder == "room"
    ids = [id_of(actor) for actor in level.actors]
    assert None not in ids and len(set(ids)) == len(ids)
    store = PackStore([tmp_path / "packs" / "tiny"])
    crate = store.asset(str(actors["crate_1"].components[0].static_mesh))
    assert crate is not None and crate.size_m == pytest.approx((2, 1, 1)) and crate.bounds_min_cm[2] == 0
    assert crate.collision_source == "authored" and len(crate.collision) == 1
    assert actors["crate_2"].components[0].static_mesh == crate.path
    chair = store.asset(str(actors["room_chair_1"].components[0].static_mesh))
    assert chair is not None and chair.size_m == pytest.approx((0.5, 0.4, 0.9)) and chair.collision_source == "hull"
    reasons = {row["name"]: row["reason"] for row in report["skipped"]}
    assert "missing" in reasons["room/ghost"] and "not 6 numbers" in reasons["bad_pose"]
    assert any(name.startswith("room/torn") for name in reasons)


def test_an_imported_level_opens_in_the_engine(world: Path, tmp_path: Path) -> None:
    report = import_scene(world, "tiny", suites=tmp_path / "suites", packs=tmp_path / "packs", without=["room/*"])
    assert report["left_out"] == 3
    export_level(
        engine="headless",
        packs=[tmp_path / "packs" / "tiny"],
        level=Path(report["level"]),
        out=tmp_path / "snapshot.json",
    )
    snapshot = json.loads((tmp_path / "snapshot.json").read_text())
    assert len(snapshot["actors"]) == 5


def test_importing_twice_gives_the_same_level(world: Path, tmp_path: Path) -> None:
    one, two = (import_scene(world, "tiny", suites=tmp_path / n, packs=tmp_path / n / "p") for n in ("a", "b"))
    assert one["sha256"] == two["sha256"]
    assert Path(one["level"]).read_bytes() == Path(two["level"]).read_bytes()


@pytest.mark.parametrize(
    ("name", "text", "said"),
    [
        ("a.world", "<sdf><world>", "not valid XML"),
        ("a.world", "<robot/>", "no SDF world"),
        ("a.world", "<!DOCTYPE a [<!ENTITY b 'c'>]><sdf/>", "no entities"),
        ("a.max", "", "no importer"),
        ("a.csv", "actor,asset\na,b\n", "no column 'grid_x'"),
        ("a.glb", "glTF", "cannot read"),
        ("a.world", "<sdf><world name='w'/></sdf>", "no actor"),
    ],
)
def test_bad_scene_files_are_bad_input(tmp_path: Path, name: str, text: str, said: str) -> None:
    (tmp_path / name).write_text(text)
    with pytest.raises(BadInput, match=said):
        import_scene(tmp_path / name, "bad", suites=tmp_path / "suites", packs=tmp_path / "packs")
    assert not (tmp_path / "suites").exists()


def test_a_node_tree_keeps_every_world_transform(tmp_path: Path) -> None:
    scene, box = trimesh.Scene(), trimesh.creation.box(extents=(1, 2, 3))
    turned = trimesh.transformations.compose_matrix(angles=[0.3, 0.2, 0.1], translate=[1, 2, 3], scale=[2, 1, -1])
    scene.add_geometry(box, node_name="plain", geom_name="box")
    scene.graph.update(frame_to="turned", frame_from="plain", matrix=turned, geometry="box")
    (tmp_path / "tree.glb").write_bytes(scene.export(file_type="glb"))
    report = import_scene(tmp_path / "tree.glb", "tree", suites=tmp_path / "suites", packs=tmp_path / "packs")
    assert report["assets"] == 1 and report["actors"] == 2
    actor = next(one for one in Level.read(Path(report["level"])).actors if one.name.endswith("turned"))
    swap = np.eye(4)[[0, 2, 1, 3]]
    wanted = swap @ turned @ swap
    wanted[:3, 3] *= 100
    got = affine(actor.transform.location_cm, actor.transform.rotation_deg, actor.transform.scale)
    assert got == pytest.approx(wanted, abs=0.01)
    assert np.prod(actor.transform.scale) < 0


def test_place_tells_a_shear() -> None:
    matrix = np.eye(4)
    assert place(matrix)[1] is False
    matrix[0, 1] = 0.5
    assert place(matrix)[1] is True
    with pytest.raises(BadInput):
        place(np.zeros((4, 4)))


@here
@pytest.mark.parametrize(
    ("file", "table", "expected_missing"),
    [
        ("aws-small-warehouse/worlds/no_roof_small_warehouse.world", "instances_no_roof_small_warehouse.csv", 0),
        ("osrf-servicesim-office/worlds/example.world", "instances.csv", 14),
    ],
)
def test_real_worlds_stand_where_their_tables_say(file: str, table: str, expected_missing: int, tmp_path: Path) -> None:
    """The tables list door leaves and frames whose mesh files were never published: they alone are missing."""
    report = import_scene(SCENES / file, "real", suites=tmp_path / "suites", packs=tmp_path / "packs")
    placed = {actor.name: actor.transform for actor in Level.read(Path(report["level"])).actors}
    with (SCENES / file.split("/")[0] / table).open() as rows:
        listed = [row for row in csv.DictReader(rows) if row["how"] not in ("group", "actor")]
    missing = []
    for row in listed:
        name = row["actor"].replace("/", "_").replace(".", "_").replace("_-", "_minus")
        if name not in placed:
            missing.append(row["actor"])
            continue
        wanted = (100 * float(row["x"]), -100 * float(row["y"]), 100 * float(row["z"]))
        assert placed[name].location_cm == pytest.approx(wanted, abs=0.1), name
        if abs(float(row["roll"])) < 0.01:
            turn = math.radians(placed[name].rotation_deg[1]) + float(row["yaw"])
            assert abs(math.remainder(turn, 2 * math.pi)) < 0.001, name
    assert len(missing) == expected_missing and all(name.split("/")[-1].startswith("door") for name in missing)


@here
def test_lost_meshes_of_the_office_can_be_replaced_by_parts_that_are_there(tmp_path: Path) -> None:
    parts = {
        "door/meshes/door_frame.obj": "door/meshes/door.obj#Door_Frame",
        "door/meshes/door_door.obj": "door/meshes/door.obj#Door,Door_Handle",
        "cubicle_wall/meshes/cubicle_closed.obj": "cubicle_wall/meshes/cubicle_wall.obj#closed",
    }
    report = import_scene(
        SCENES / "osrf-servicesim-office/worlds/example.world",
        "whole",
        suites=tmp_path / "suites",
        packs=tmp_path / "packs",
        without=["*Cubicle*", "ceiling"],
        meshes=[f"model://{lost}=model://{there}" for lost, there in parts.items()],
    )
    assert report["skipped_kinds"] == {"animated person": 5, "plugin": 4}
    assert report["actors"] + report["left_out"] == 314
    names = {actor.name for actor in Level.read(Path(report["level"])).actors}
    assert {"PrivateOfficeD_door", "PrivateOfficeD_door_frame"} <= names


@here
def test_the_city_builder_sample_comes_in_by_the_command(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("C4S_HOME", str(tmp_path))
    table = SCENES / "kenney-city-builder-sample" / "instances.csv"
    with pytest.raises(SystemExit) as stop:
        boundary(
            lambda: app(
                ["suite", "import-scene", str(table), "--id", "city", "--scale", "8", "--json"], standalone_mode=False
            )
        )
    assert stop.value.code in (0, None)
    report = json.loads(capsys.readouterr().out)
    assert report["actors"] == 122 and report["assets"] == 15 and report["skipped"] == []
    tiles = [actor for actor in Level.read(Path(report["level"])).actors if actor.name.startswith("tile")]
    assert tiles[0].transform.location_cm == pytest.approx((-1600, 4000, 0))


def test_wild_placements_and_sizes_are_noted_and_can_be_left_out(tmp_path: Path) -> None:
    for name, size in (("chair", 1.0), ("table", 1.0), ("stool_cm", 60.0)):
        trimesh.creation.box(extents=(size, size, size)).export(tmp_path / f"{name}.glb")
    rows = [f"{kind}_{i},{kind}.glb,{3 * i},{4 * i},0,0,0,0" for i in range(6) for kind in ("chair", "table")]
    rows += ["stool,stool_cm.glb,1,1,0,0,0,0", "fallen,chair.glb,2,2,-343000,0,0,0", "yard,table.glb,400,0,0,0,0,0"]
    table = tmp_path / "scene.csv"
    table.write_text("\n".join(["actor,asset,x,y,z,roll,pitch,yaw", *rows]))
    report = import_scene(table, "one", suites=tmp_path / "suites", packs=tmp_path / "packs")
    notes = {row["name"]: row["note"] for row in report["notes"] if row["name"]}
    assert notes["fallen"].startswith("it lies 343 km from the middle of the others, at ")
    assert "z = -3.43e+05 m; --without 'fallen' leaves it out" in notes["fallen"]
    assert "it is 60 m long" in notes["Stool cm"]
    assert set(notes) == {"fallen", "Stool cm"}
    report = import_scene(
        table, "two", suites=tmp_path / "suites", packs=tmp_path / "packs", without=["fallen", "stool"]
    )
    assert (report["actors"], report["left_out"]) == (13, 2)
    assert not [row for row in report["notes"] if row["name"]]
